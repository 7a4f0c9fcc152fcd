"""Standard output and error: closed (`>&-`), full, of few letters, or with nobody who reads."""

from __future__ import annotations

import errno
import io
import os
import sys
from contextlib import suppress

__all__ = ["error_of_output", "escape_letters", "flush", "print_no_more", "replace_closed", "say"]

#: Why standard output takes no more; other errors of the system are not its.
TAKES_NO_MORE = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.EBADF)


def replace_closed() -> None:
    """Of streams that are closed Python has none, and the next files to be opened would get their numbers.

    Standard output becomes one that refuses what is written, standard error one that forgets it.
    """
    while (number := os.open(os.devnull, os.O_RDONLY)) <= 2:
        pass
    os.close(number)
    if sys.stdout is None:
        sys.stdout = os.fdopen(1, "w", encoding="utf-8", closefd=False)
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115: as long as the process


def escape_letters() -> None:
    """Letters that standard output has no bytes for are written as \\u0141."""
    if isinstance(sys.stdout, io.TextIOWrapper) and sys.stdout.errors == "strict":
        sys.stdout.reconfigure(errors="backslashreplace")


def error_of_output(error: Exception) -> bool:
    """Whether it is standard output that takes no more."""
    return isinstance(error, OSError) and error.filename is None and error.errno in TAKES_NO_MORE


def print_no_more() -> None:
    """To where nobody listens, or nothing can be written."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def flush() -> None:
    """Both, as far as they take it."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError):
            stream.flush()


def say(kind: str, text: str) -> None:
    """A line on standard error, if that takes it: `error: ...`."""
    with suppress(OSError, ValueError):
        print(f"{kind}:", " ".join(text.split()), file=sys.stderr)
