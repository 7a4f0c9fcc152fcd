"""Trials in processes of their own, which may crash or hang."""

from __future__ import annotations

import os
import resource
import shutil
import signal
import sys
import time
import traceback
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

#: Files at which something failed are kept here.
BUILT = Path(__file__).resolve().parents[2] / "build" / "hostile"

#: What reading a file may take for each of its bytes, and beside [bytes].
MEMORY_EACH, MEMORY = 40, 50_000_000

#: What nothing comes near [bytes]: beyond, the process gets no more.
MOST_MEMORY = 8 * 2**30


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
        raise Failure(f"{how}: {said.decode(errors='replace')[-900:]}")


def guarded_files(
    count: int,
    folder: Path,
    make: Callable[[Path], Path],
    read: Callable[[Path], object],
    seconds: int = 30,
    memory: int = MEMORY,
) -> None:
    """Makes a file in the folder and reads it, so many times in one fork, each within so many seconds.

    Failure: reading raised, crashed, hung or took too much memory; the file is kept in BUILT.
    """
    folder.mkdir(exist_ok=True)

    def alone() -> None:
        taken = 4096 * int(Path("/proc/self/statm").read_text().split()[0])
        resource.setrlimit(resource.RLIMIT_AS, (taken + MOST_MEMORY,) * 2)
        for _ in range(count):
            signal.alarm(seconds)
            path = make(folder)
            size, before = path.stat().st_size, peak(reset=True)
            read(path)
            if peak() - before > MEMORY_EACH * size + memory:
                raise Failure(f"{size} bytes took {(peak() - before) / 1e6:.0f} MB")
            path.unlink()

    try:
        guarded(alone, seconds)
    except Failure as failure:
        raise Failure(f"{keep(folder)}: {failure}") from None


def peak(reset: bool = False) -> int:
    """The most memory that this process had [bytes], since it was reset."""
    if reset:
        Path("/proc/self/clear_refs").write_text("5")
    lines = Path("/proc/self/status").read_text().splitlines()
    return 1024 * next(int(line.split()[1]) for line in lines if line.startswith("VmHWM"))


def keep(folder: Path) -> str:
    """For whoever looks into it; where."""
    kept = BUILT / f"{os.getpid()}-{time.time_ns()}"
    shutil.copytree(folder, kept)
    return str(kept.relative_to(BUILT.parents[1]))
