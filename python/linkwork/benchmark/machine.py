"""Where and when a measurement was made."""

from __future__ import annotations

import datetime
import os
from typing import Any

from linkwork import _core
from linkwork.running.manifest import platform_facts

#: What limits the threads of BLAS.
THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


def machine() -> dict[str, Any]:
    """Versions, platform, processor, date; the instruction set of the hot loops; the threads of BLAS."""
    now = datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds")
    threads = {name: os.environ.get(name) for name in THREADS}
    return {"date": now, **platform_facts(), "instruction_set": _core.instruction_set(), "threads": threads}
