"""Models from the files of other programs: URDF, SDF and MJCF.

    imported = lw.import_urdf("panda.urdf", coordinates={"panda_joint1": 0.3})
    imported.model       the mechanism
    imported.notes       what of the file is not in it, or differently: nothing is dropped silently

Bodies are named like links and have their axes; joint coordinates are zero where those of the file are.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from linkwork.arguments import path as path_of
from linkwork.errors import FileError, nearest
from linkwork.importers.description import Imported, Note
from linkwork.importers.mjcf import import_mjcf
from linkwork.importers.sdf import import_sdf
from linkwork.importers.urdf import import_urdf

__all__ = [
    "IMPORTERS", "Imported", "Note", "import_mjcf", "import_sdf", "import_urdf", "is_importable", "read",
]  # fmt: skip

#: By file name extension.
IMPORTERS: Mapping[str, Callable[..., Imported]] = {
    ".urdf": import_urdf,
    ".sdf": import_sdf,
    ".mjcf": import_mjcf,
    ".xml": import_mjcf,
}


def is_importable(path: str | os.PathLike[str]) -> bool:
    """Whether the extension is that of a file that is imported."""
    return Path(path).suffix.lower() in IMPORTERS


def read(path: str | os.PathLike[str], **options: Any) -> Imported:
    """Import by the extension: .urdf, .sdf, .mjcf or .xml (MJCF). Errors as of import_urdf and the others.

    An empty `search_path` is that of every format.
    """
    suffix = path_of(path, "file to import").suffix.lower()
    if suffix not in IMPORTERS:
        known = ", ".join(IMPORTERS)
        raise FileError(
            f"'{path}': extension '{suffix}' is none of {known}{nearest(suffix, IMPORTERS)}", code="suffix"
        )
    if not options.get("search_path"):
        options.pop("search_path", None)
    return IMPORTERS[suffix](path, **options)
