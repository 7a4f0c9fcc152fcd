"""How much memory this process has in use [bytes]; None where the system does not tell."""

from __future__ import annotations

import contextlib
import ctypes
import gc
from pathlib import Path

_STATUS, _FORGET = Path("/proc/self/status"), Path("/proc/self/clear_refs")


def resident() -> int | None:
    """Resident now, without what is free and only kept for what may come."""
    gc.collect()
    with contextlib.suppress(OSError, AttributeError):  # glibc only
        ctypes.CDLL(None).malloc_trim(0)
    return _status("VmRSS")


def peak() -> int | None:
    """The most that was resident since `forget_peak`, or since the process began.

    Not getrusage: that of a new process begins with the peak of its parent.
    """
    return _status("VmHWM")


def forget_peak() -> None:
    """From now on `peak` counts anew, where the system can."""
    with contextlib.suppress(OSError):
        _FORGET.write_text("5")


def limit_to_available() -> None:
    """From now on asking for more than is free is a MemoryError: the system need not kill a process."""
    try:
        import resource

        meminfo = dict(line.split(":", 1) for line in Path("/proc/meminfo").read_text().splitlines())
        size, available = _status("VmSize"), int(meminfo["MemAvailable"].split()[0]) * 1024
        if size is not None:
            hard = resource.getrlimit(resource.RLIMIT_AS)[1]
            resource.setrlimit(resource.RLIMIT_AS, (size + available, hard))
    except (ImportError, OSError, KeyError, ValueError):
        return


def _status(field: str) -> int | None:
    try:
        for line in _STATUS.read_text().splitlines():
            if line.startswith(field + ":"):
                return int(line.split()[1]) * 1024
    except OSError:
        pass
    return None
