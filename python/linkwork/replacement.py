"""Files that are whole or not there: written beside, brought to the disk, and renamed."""

from __future__ import annotations

import errno
import os
import shutil
import uuid
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from linkwork.errors import unwritable

__all__ = ["replacing"]

#: Of the name of a file beside, which has some more: file systems take 255.
NAME_BYTES = 150


@contextmanager
def replacing(path: str | os.PathLike[str], what: str) -> Iterator[Path]:
    """A file beside to write to, with the same suffix, which takes the place of `path` at the end; where
    anything is raised before that, `path` stays what it was.

    FileError: it cannot be written.
    """
    target = Path(os.path.realpath(path))
    kept = os.fsencode(target.stem)[:NAME_BYTES].decode(errors="ignore")
    beside = target.with_name(f".{kept}.{uuid.uuid4().hex[:12]}{target.suffix}")
    try:
        _check_replaceable(target)
        yield beside
        with open(beside, "r+b") as file:
            os.fsync(file.fileno())
        if target.exists():
            shutil.copymode(target, beside)
        os.replace(beside, target)
    except OSError as error:
        raise unwritable(what, path, error) from error
    finally:
        with suppress(OSError):
            beside.unlink(missing_ok=True)


def _check_replaceable(target: Path) -> None:
    """OSError: a folder, a device, or a file that may not be written, though another could take its place."""
    if target.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
    if target.exists() and not target.is_file():
        raise OSError("is no regular file; choose another")
    if target.exists() and not os.access(target, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    if not target.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))
