"""A mechanism by its name or from a file, for everything that takes one."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

from linkwork.arguments import SUFFIXES
from linkwork.errors import FileError, nearest
from linkwork.mechanisms.mechanism import Mechanism

if TYPE_CHECKING:
    from linkwork.modeling.model import Model

__all__ = ["is_file", "is_model_file", "mechanism_of_file"]


def is_file(name: str) -> bool:
    """
    Whether a word means a file: it has an extension or a folder. Names of mechanisms have neither.

        assert lw.mechanisms.is_file("crank.yaml")
    """
    return bool(PurePath(name).suffix) or os.sep in name


def is_model_file(name: str) -> bool:
    """
    Whether the extension is that of a file with a model, such as .yaml or .urdf; results have another.

        assert lw.mechanisms.is_model_file("crank.yaml")
    """
    from linkwork import importers
    from linkwork.modeling import files

    return importers.is_importable(name) or PurePath(name).suffix.lower() in files.SUFFIXES


def mechanism_of_file(path: str) -> Mechanism:
    """The model in a file, or imported from one, with the arguments of `simulate` that it recommends.

    What an import leaves out is a LinkworkWarning. FileError, ModelFileError: what is wrong with the file.
    """
    model, simulation = _read(path)

    def build() -> Model:
        return model

    build.__name__ = PurePath(path).name
    build.__doc__ = model.describe()
    return Mechanism(build, **simulation)


def _no_model(path: str, known: Sequence[str]) -> str:
    suffix = PurePath(path).suffix.lower()
    text = f"'{path}': extension '{suffix}' is none of a model: {', '.join(known)}"
    if suffix in SUFFIXES["result"]:
        return f"{text}; it is that of a result, which `linkwork view {path}` shows"
    hint = nearest(suffix, known)
    return text + hint if "nearest" in hint else text


def _read(path: str) -> tuple[Model, Mapping[str, Any]]:
    from linkwork import importers
    from linkwork.modeling import files

    if not is_model_file(path):
        raise FileError(_no_model(path, [*files.SUFFIXES, *importers.IMPORTERS]), code="suffix")
    if importers.is_importable(path):
        imported = importers.read(path)
        imported.warn()
        return imported.model, {}
    from linkwork.modeling.model import Model

    file = files.read(path, Model)
    return file.model, file.simulation
