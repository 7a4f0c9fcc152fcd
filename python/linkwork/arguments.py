"""Arguments as they are given: what is no number, name or path is an error of our own, whatever it is.

Comparisons of arrays, hashes of lists and conversions of huge integers raise errors of Python's or NumPy's;
here they are answered like other values that make no sense.
"""

from __future__ import annotations

import errno
import inspect
import math
import os
import stat
from collections.abc import Callable, Iterable, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any, TypeGuard

import numpy as np

from linkwork.arrays import Floats
from linkwork.errors import FileError, LinkworkError, ModelError, OptionError, about, nearest

__all__ = [
    "UNREADABLE", "array", "check_called", "check_new", "check_suffix", "check_takes", "folders",
    "is_iterable", "is_number", "is_one_of", "is_text", "number", "one_of", "optional_package", "path",
    "reals", "refuse_dash", "whole",
]  # fmt: skip

#: A shape (size,) of an array; None stands for any length.
ArrayShape = tuple[int | None, ...]

#: What is no file, by the type of its mode.
SPECIAL = {
    stat.S_IFCHR: "device", stat.S_IFBLK: "device", stat.S_IFIFO: "pipe", stat.S_IFSOCK: "socket",
}  # fmt: skip

#: Suffixes by what is in files, of those that are written and of others that a name could ask for. The last
#: two have suffixes that have a kind of their own, which is what errors call it.
SUFFIXES = {
    "result": (".h5", ".hdf5", ".hdf"), "table": (".csv",), "page": (".html", ".htm"),
    "movie": (".mp4", ".gif"), "data set": (".nc", ".nc4", ".cdf"),
    "picture": (".png", ".pdf", ".svg", ".eps", ".ps", ".jpg", ".jpeg", ".tif", ".tiff", ".webp"),
    "model": (".yaml", ".yml", ".json"), "robot": (".urdf", ".sdf", ".xml"),
    "spreadsheet": (".xlsx", ".xls", ".ods"), "column store": (".parquet", ".feather", ".arrow"),
    "Zarr store": (".zarr",), "NumPy file": (".npz", ".npy"), "MATLAB file": (".mat",),
    "text": (".txt", ".tsv", ".md", ".tex"), "pickle": (".pkl", ".pickle"),
    "video": (".avi", ".mov", ".mkv", ".webm"), "database": (".db", ".sqlite", ".sqlite3"),
    "compressed file": (".zip", ".gz", ".xz", ".bz2", ".zst", ".tar", ".tgz"),
    "table of cases": (".csv", ".nc", ".nc4", ".cdf"), "comparison": (".json",),
}  # fmt: skip

#: What NumPy and Python raise for what is not made of numbers.
UNREADABLE = (TypeError, ValueError, OverflowError)


def array(given: Any, what: str, error: type[LinkworkError] = OptionError, *, texts: bool = True) -> Floats:
    """As numbers, in any shape; NaN where they are masked. `error`: it is not made of real numbers, with
    `texts` of such that are numbers, too."""
    try:
        return reals(given, texts=texts)
    except UNREADABLE as cause:
        uneven = isinstance(cause, ValueError) and "inhomogeneous" in str(cause)
        why = "has rows of different lengths" if uneven else "is not made of numbers"
        raise error(f"{what} {given!r:.80} {why}", code="not_a_number") from cause


def reals(given: Any, texts: bool = False) -> Floats:
    """The same, texts that are numbers only where they count, and truth values only where these do not, as
    of what functions return. UNREADABLE: it is not made of real numbers."""
    masked = isinstance(given, np.ma.MaskedArray)
    found = given if masked else np.asarray(given)
    if given is None or found.dtype.kind not in ("iufOSU" if texts else "biufO"):
        raise TypeError("complex numbers would lose a part, and times of NumPy their unit")
    if texts and (isinstance(given, list | tuple) or found.dtype == object) and _has_truth(given):
        raise TypeError("a truth value is no number")
    numbers: Floats = found.astype(float, copy=False)
    return np.ma.filled(numbers, np.nan) if masked else numbers


def _has_truth(given: Any) -> bool:
    return any(isinstance(it, bool | np.bool_) for it in np.asarray(given, dtype=object).flat)


def is_number(given: Any) -> bool:
    """Whether it is one finite real number; text is none, nor is a truth value."""
    if isinstance(given, str | bytes | bool | np.bool_):
        return False
    if not (isinstance(given, int) or hasattr(given, "__float__")):
        return False
    if not isinstance(given, int | float) and np.iscomplexobj(given):
        return False
    try:
        return math.isfinite(given)
    except UNREADABLE:
        return False


def number(
    given: Any, what: str, error: type[LinkworkError] = OptionError, code: str = "not_a_number"
) -> float:
    """`error`: it is no finite number."""
    if not is_number(given):
        raise error(f"{what} {given!r:.80} is not a finite number", code=code)
    return float(given)


def whole(given: Any, least: int, what: str, error: type[LinkworkError] = OptionError) -> int:
    """`error`: it is no whole number of at least `least`, or too large for any purpose."""
    good = isinstance(given, int | np.integer) and not isinstance(given, bool)
    if not good or not least <= given < 2**63:
        raise error(f"{what} {given!r:.80} is not a whole number of at least {least}", code="count")
    return int(given)


def check_takes(function: Callable[..., Any], names: Iterable[str], who: str) -> None:
    """OptionError: `function` does not take arguments of these names."""
    try:
        inspect.signature(function).bind(**dict.fromkeys(names))
    except (TypeError, ValueError) as error:  # ValueError: what has no signature
        raise OptionError(
            f"parameters {', '.join(names)}: the function {who} does not take them ({error})",
            code="parameters",
        ) from error


def check_called(
    function: Callable[..., Any], names: Sequence[str], who: str, error: type[LinkworkError] = ModelError
) -> None:
    """`error`: `function` cannot be called with these arguments, by their places."""
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):  # of what has none the call tells
        return
    try:
        signature.bind(*names)
    except TypeError as cause:
        raise error(
            f"{who}: its function does not take ({', '.join(names)}): {cause}", code="signature"
        ) from cause


def is_iterable(given: Any) -> TypeGuard[Iterable[Any]]:
    """Arrays of one number say that they are, and are not."""
    return isinstance(given, Iterable) and getattr(given, "ndim", 1) != 0


def is_text(given: Any) -> TypeGuard[str]:
    """Not with half of a pair of surrogates, which nothing that is compiled takes."""
    surrogates = range(0xD800, 0xE000)
    return isinstance(given, str) and (given.isascii() or not any(ord(it) in surrogates for it in given))


def is_one_of(given: Any, known: Iterable[str]) -> bool:
    return isinstance(given, str) and given in list(known)


def one_of(given: Any, known: Iterable[str], what: str, code: str = "unknown_option") -> str:
    """OptionError: it is none of the names that there are."""
    names = list(known)
    if not isinstance(given, str) or given not in names:
        text = given if isinstance(given, str) else f"{given!r:.80}"
        raise OptionError(f"{what} '{text}' does not exist{nearest(text, names)}", code=code)
    return given


def path(given: Any, what: str, *, folder: bool = False) -> Path:
    """Of a file to be read or written, or a `folder`. FileError: it is no path, or of a folder instead; or
    neither a file nor a folder is there: a device would be replaced, and a pipe waits for ever."""
    try:
        found = os.fspath(given)
        if isinstance(found, str) and found and "\0" not in found and _is_encodable(found):
            refuse_dash(found, what)
            _refuse_special(found, what)
            if not folder and found.endswith((os.sep, os.altsep or os.sep)):
                why = "ends as the name of a folder: give that of a file"
                raise FileError(f"{what} '{found}': {why}", code="path")
            return Path(found)
    except TypeError:
        pass
    raise FileError(f"{what} {given!r:.80} is no path of a file: give its name", code="path")


def refuse_dash(path: str | bytes, what: str) -> None:
    """FileError: the name by which other programs mean standard input and output."""
    if path in ("-", b"-"):
        raise FileError(
            f"{what} '-': neither standard input nor output is taken: give the name of a file, or ./- of one "
            "that is called so",
            code="path",
        )


def _is_encodable(text: str) -> bool:
    """False: it has half of a pair of surrogates, which no file system takes."""
    try:
        os.fsencode(text)
    except UnicodeEncodeError:
        return False
    return True


def folders(given: Any, what: str) -> list[Path]:
    """Of one path or several, absolute. OptionError: no paths. FileError: one that is no folder."""
    several = [given] if isinstance(given, str | bytes | os.PathLike) else given
    if not is_iterable(several):
        raise OptionError(f"{what} {given!r:.80} is no list of folders", code=what)
    found = []
    for folder in (path(it, what, folder=True) for it in several):
        try:
            found.append(folder.resolve())
            there = folder.is_dir()
        except OSError:  # as of a name that is too long
            there = False
        if not there:
            raise FileError(f"{what} '{folder}': there is no such folder; check the path", code="not_found")
    return found


def check_suffix(given: Any, what: str) -> Path:
    """A path whose suffix, where it is one of SUFFIXES, is of a `what`. FileError: it says something else."""
    found = path(given, what)
    suffix = found.suffix.lower()
    for kind, suffixes in SUFFIXES.items():
        if suffix in suffixes and suffix not in SUFFIXES[what]:
            raise FileError(
                f"{what} '{found}': {suffix} is the suffix of a {kind}: a {what} is written to "
                f"{' or '.join(SUFFIXES[what])}",
                code="format",
            )
    return found


def check_switch(name: str, given: Any) -> None:
    """OptionError: it is neither True nor False."""
    if not isinstance(given, bool):
        raise OptionError(f"{name} {given!r:.80} is not True or False", code=name)


def check_new(given: Any, what: str, overwrite: bool) -> Path:
    """As `check_suffix`. FileError: there is a file, which may not be replaced."""
    found = check_suffix(given, what)
    check_switch("overwrite", overwrite)
    if not overwrite and os.path.isfile(found):
        raise FileError(
            f"{what} '{found}': there is such a file already: choose another name, or replace it by "
            "overwrite=True, --force of a command",
            code="exists",
        )
    return found


def optional_package(
    package: str, extra: str, what: str, error: type[LinkworkError] = OptionError, instead: str = ""
) -> Any:
    """A package that linkwork works without. `error`: it is not there, but needed for `what`."""
    try:
        return import_module(package)
    except ImportError as cause:
        absent = isinstance(cause, ModuleNotFoundError) and cause.name == package
        why = "is not installed" if absent else f"cannot be imported ({cause})"
        raise error(
            f"{what} needs the package {package}, which {why}: pip install 'linkwork[{extra}]'"
            + (f"; {instead}" if instead else ""),
            code="missing_package",
        ) from cause


def _refuse_special(found: str, what: str) -> None:
    try:
        kind = stat.S_IFMT(os.stat(found).st_mode)
    except OSError as error:
        if error.errno == errno.ELOOP:
            raise FileError(f"{what} '{found}': is a link that leads back to itself", code="path") from error
        return  # whoever opens it says so
    if kind not in (stat.S_IFREG, stat.S_IFDIR):
        raise FileError(
            f"{what} '{found}': is no regular file but a {SPECIAL.get(kind, 'special file')}; choose another",
            code="special_file",
        )


def shaped(value: Any, shapes: Sequence[ArrayShape], who: str, what: str) -> Floats:
    """`value` as an array of one of the `shapes`. Whether the numbers make sense, the compiled model says."""
    with about(what, who):
        numbers = array(value, f"{who}: {what}", ModelError)
    for shape in shapes:
        if len(shape) == numbers.ndim and all(
            n in (None, m) for n, m in zip(shape, numbers.shape, strict=True)
        ):
            return numbers
    wanted = " or ".join(str(shape).replace("None", "k") for shape in shapes)
    raise ModelError(
        f"{who}: {what} has shape {numbers.shape}, not {wanted}", code="shape", subject=who, field=what
    )
