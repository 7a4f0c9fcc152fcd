"""What goes wrong, as data: a class, a code, one line for people, and the numbers behind it.

The compiled module raises these same classes. Nothing here prints.
"""

from __future__ import annotations

import contextlib
import difflib
import errno
import os
import sys
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from linkwork.motion.records import Snapshot
    from linkwork.results.result import Result

__all__ = [
    "AccuracyError", "BusyError", "Fault", "Faults", "FileError", "LinkworkError", "LinkworkWarning",
    "ModelError", "ModelFileError", "NotConvergedError", "NotFiniteError", "OptionError",
    "SingularSystemError", "StepSizeError", "ViolationError", "carry", "cause", "nearest", "unwritable",
    "warn",
]  # fmt: skip


class LinkworkError(Exception):
    """Base of every error of linkwork. `str(error)` is one line that names the object and the value."""

    def __init__(
        self,
        message: str,
        *,
        code: str = "error",
        bodies: Sequence[str] = (),
        joints: Sequence[str] = (),
        time: float | None = None,
        step: float | None = None,
        residuals: Mapping[str, float] | None = None,
        forces: Sequence[str] = (),
        stage: int | None = None,
        subject: str = "",
        field: str = "",
    ) -> None:
        """`subject` is what the message begins with, "body 'crank'", `field` which part of it is wrong.

        `time` and `step` [s] where a run failed, and in which stage of the step, from 1 on.

        `residuals` by name, in the unit of what is measured. An error of a run has its `result` up to there,
        and `state`, the last from which it went on: simulate(..., start=error.state) goes on from it.
        """
        self.message = " ".join(message.split())
        super().__init__(self.message)
        self.code = code
        self.bodies = list(bodies)
        self.joints = list(joints)
        self.time = time
        self.step = step
        self.residuals = dict(residuals or {})
        self.forces = list(forces)
        self.stage = stage
        self.subject, self.field = subject, field
        self.result: Result | None = None
        self.state: Snapshot | None = None

    @property
    def reason(self) -> str:
        """The message without its subject."""
        return self.message.removeprefix(f"{self.subject}: ") if self.subject else self.message

    def facts(self) -> dict[str, Any]:
        """What it says, for programs: kind, code, message and the details that there are."""
        names = ("subject", "field", "bodies", "joints", "forces", "time", "step", "stage", "residuals")
        details = {name: value for name in names if (value := getattr(self, name)) not in ("", [], {}, None)}
        return {"type": type(self).__name__, "code": self.code, "message": str(self), **details}


class ModelError(LinkworkError):
    """The description of the mechanism is wrong."""


class OptionError(LinkworkError):
    """A choice that does not exist, or that cannot be honored."""


class SingularSystemError(LinkworkError):
    """Dependent constraint equations, or no unique acceleration."""


class NotConvergedError(LinkworkError):
    """An iteration ended at its cap."""


class NotFiniteError(LinkworkError):
    """A NaN or an infinity appeared during a run."""


class StepSizeError(LinkworkError):
    """No step is small enough for the tolerances of an adaptive run."""


class ViolationError(LinkworkError):
    """The constraints are violated beyond the limit of the run."""


class BusyError(LinkworkError):
    """A System is called while it works, from another thread or from a function that it calls itself."""


class AccuracyError(LinkworkError):
    """A run is less accurate than it may be."""


class FileError(LinkworkError):
    """A file cannot be read or written."""


@dataclass(frozen=True, order=True)
class Fault:
    """What is wrong in a file: in which line, from 1 on, of which field, such as joints[3].axis."""

    line: int
    field: str
    message: str

    def __str__(self) -> str:
        return " ".join(": ".join(filter(None, (self.field, self.message))).split())


class Faults:
    """The first faults of a file, and how many there are."""

    def __init__(self) -> None:
        self._first: list[Fault] = []
        self.count = 0

    @property
    def full(self) -> bool:
        """Further ones are not listed."""
        return self.count >= MOST_FAULTS

    def add(self, fault: Fault) -> None:
        self.count += 1
        if self.count <= MOST_FAULTS:
            self._first.append(fault)

    def all(self) -> list[Fault]:
        """With a last one that counts the others."""
        more, last = self.count - len(self._first), max((it.line for it in self._first), default=1)
        others = f"and {more} more faults" if more > 1 else "and one more fault"
        return [*self._first, *([Fault(last, "", others)] if more > 0 else [])]


class ModelFileError(FileError):
    """A file with a model is wrong. `faults` are all that were found; str(error) has a line for each."""

    def __init__(self, path: str | os.PathLike[str], faults: Iterable[Fault]) -> None:
        self.path = os.fspath(path)
        self.faults = sorted(set(faults))
        self.lines = [f"{self.path}:{fault.line}: {fault}" for fault in self.faults]
        super().__init__("; ".join(self.lines), code="model_file")

    def __str__(self) -> str:
        return "\n".join(self.lines)

    def __reduce__(self) -> tuple[type[ModelFileError], tuple[str, list[Fault]]]:
        return ModelFileError, (self.path, self.faults)


class LinkworkWarning(UserWarning):
    """Something that is probably not meant, but can be computed."""


#: How alike names are that one can have meant, see difflib.
NEAR = 0.55

#: So many names are told in a message; of so many the nearest is looked for, for one no longer than this.
LISTED, MOST_LOOKED_AT, LONG_NAME = 8, 1000, 100

#: So many faults of a file are listed, the others counted.
MOST_FAULTS = 20

#: What to do where the operating system refuses to read or write.
_REMEDIES = {
    errno.ENOENT: "check the path",
    errno.ENOTDIR: "check the path",
    errno.EISDIR: "name a file in it",
    errno.EEXIST: "choose another name",
    errno.EACCES: "change the permissions, or choose another place",
    errno.EPERM: "change the permissions, or choose another place",
    errno.EROFS: "choose another place",
    errno.ENOSPC: "make room, or choose another place",
    errno.EDQUOT: "make room, or choose another place",
    errno.EFBIG: "raise the limit of file sizes, or record fewer frames",
}


def cause(error: Exception, beside: str = "") -> str:
    """Why a file could not be read or written, `beside`, what to do: "is a directory; name a file in it"."""
    number = getattr(error, "errno", None)
    if not number:
        lines = str(error).splitlines()
        return (lines[0] if lines else type(error).__name__) + beside
    remedy = _REMEDIES.get(number)
    return os.strerror(number).lower() + beside + (f"; {remedy}" if remedy else "")


@contextmanager
def about(field: str, subject: str = "") -> Iterator[None]:
    """Errors from here on are about this field, of this subject where they do not know theirs."""
    try:
        yield
    except LinkworkError as error:
        error.field, error.subject = field, error.subject or subject
        raise


#: Of what an error carries: of a run that was carried out within another one, it is that one's in the end.
_CARRIED = "_linkwork_carried"


def carry(error: BaseException, **found: Any) -> bool:
    """What there is of a run, as attributes of the error that ended it; False: one of the user's own has
    other ones of these names, or takes none."""
    own = not isinstance(error, LinkworkError | KeyboardInterrupt) and not hasattr(error, _CARRIED)
    if own and any(hasattr(error, name) for name in found):
        return False
    try:
        for name, value in {**found, _CARRIED: True}.items():
            setattr(error, name, value)
    except Exception:  # whatever an error of the user's raises
        return False
    return True


def unwritable(what: str, path: str | os.PathLike[str], error: Exception) -> FileError:
    """Of what was being written: a FileError to raise."""
    return FileError(f"{what} '{path}': cannot be written: {cause(error)}", code="not_writable")


def nearest(word: str, known: Iterable[str]) -> str:
    """The end of a message about an unknown `word`: `; the nearest is 'rk4'`, or what there is."""
    names, word = list(islice(known, MOST_LOOKED_AT)), str(word)
    likely = [name for name in names if len(name) <= 3 * len(word)] if len(word) <= LONG_NAME else []
    by_letters = {name.casefold(): name for name in reversed(likely)}
    same = [by_letters[word.casefold()]] if word.casefold() in by_letters else []
    close = same or difflib.get_close_matches(word, likely, n=1, cutoff=NEAR)
    if close:
        return f"; the nearest is '{close[0]}'"
    listed = ", ".join(repr(name) for name in names[:LISTED])
    more = f" and {len(names) - LISTED} more" if LISTED < len(names) < MOST_LOOKED_AT else ""
    short = all(len(name) <= LONG_NAME for name in names[:LISTED])
    return f"; choose from {listed}{more}" if names and short and len(names) < MOST_LOOKED_AT else ""


def counted(number: int, one: str, form: str = "") -> str:
    """ "1 body", "2 bodies"; `form` of the number as in f"{number:,}"."""
    many = one[:-1] + "ies" if one.endswith("y") else one + "s"
    return f"{number:{form}} {one if number == 1 else many}"


def warn(message: str) -> None:
    """LinkworkWarning at the line of the user's, the nearest outside this package."""
    inside = (os.path.dirname(__file__) + os.sep, contextlib.__file__)
    frame, level = sys._getframe(1), 2
    while frame.f_code.co_filename.startswith(inside) and frame.f_back is not None:
        frame, level = frame.f_back, level + 1
    warnings.warn(message, LinkworkWarning, stacklevel=level)
