"""How much memory there is to take, asked before it is taken."""

from __future__ import annotations

import math
import os
from contextlib import suppress
from types import ModuleType

resource: ModuleType | None
try:
    import resource
except ImportError:  # not on Windows
    resource = None

__all__ = ["available", "in_use", "in_words"]


def available() -> float:
    """Of the machine, and of the limit of the process [bytes]; infinite where nobody knows."""
    return min(_of_machine(), _of_limit())


def in_use() -> float:
    """By this process, as it is resident [bytes]; 0 where nobody knows."""
    with suppress(OSError, ValueError, IndexError, AttributeError), open("/proc/self/statm") as file:
        return float(int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE"))
    return 0.0


def in_words(count: float) -> str:
    """Bytes in a unit that suits them."""
    for unit in ("bytes", "kB", "MB", "GB", "TB"):
        if count < 1000:
            return f"{count:.3g} {unit}"
        count /= 1000
    return f"{count:.3g} PB"


def _of_machine() -> float:
    with suppress(OSError, ValueError, IndexError), open("/proc/meminfo") as file:
        for line in file:
            if line.startswith("MemAvailable:"):
                return 1024.0 * int(line.split()[1])
    return math.inf


def _of_limit() -> float:
    """What is left of the address space that `ulimit -v` gives."""
    if resource is None:
        return math.inf
    most = resource.getrlimit(resource.RLIMIT_AS)[0]
    if most == resource.RLIM_INFINITY:
        return math.inf
    with suppress(OSError, ValueError, IndexError), open("/proc/self/statm") as file:
        return max(0.0, float(most - int(file.read().split()[0]) * os.sysconf("SC_PAGE_SIZE")))
    return float(most)
