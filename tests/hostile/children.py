"""Trials in processes of their own, which may crash or hang."""

from __future__ import annotations

import os
import signal
import sys
import traceback
from collections.abc import Callable
from contextlib import suppress


class Failure(Exception):
    """A promise that does not hold."""


def child(work: Callable[[], object]) -> int:
    """A fork that does the work and ends, 0 where nothing was raised."""
    pid = os.fork()
    if pid:
        return pid
    code = 1
    try:
        work()
        code = 0
    except BaseException:
        sys.stderr.write(traceback.format_exc(limit=-3))
        sys.stderr.flush()
    finally:
        os._exit(code)


def ended(pid: int) -> int:
    """Its exit code; negative: the signal that ended it."""
    return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])


def guarded(work: Callable[[], object], seconds: int = 60) -> None:
    """Does the work in a fork. Failure: it raised, crashed, or took longer."""
    reader, writer = os.pipe()

    def alone() -> None:
        os.dup2(writer, 2)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        signal.alarm(seconds)
        work()

    pid = child(alone)
    os.close(writer)
    said = b""
    with suppress(OSError), os.fdopen(reader, "rb") as stream:
        said = stream.read()
    code = ended(pid)
    if code:
        how = "hangs" if code == -signal.SIGALRM else f"exit code {code}"
        raise Failure(f"{how}: {said.decode(errors='replace')[-400:]}")
