"""One thread for BLAS and LAPACK of NumPy and SciPy: their matrices are small here, and many.

Threads of OpenBLAS wait for each other by spinning. Where other processes want the processors, too, as in a
pool of workers, each of which has as many threads, an analysis takes ten times as long. And what is found
does not depend on how many there are.
"""

from __future__ import annotations

import contextlib
import functools
import os
import threading
from collections.abc import Iterator
from typing import Any

__all__ = ["one_blas_thread", "one_blas_thread_from_here"]


class _Limit:
    """Of this process: as long as somebody wants it."""

    def __init__(self, wanted: int = 0) -> None:
        self.lock, self.wanted, self.limits = threading.Lock(), wanted, None

    def begin(self) -> None:
        with self.lock:
            self.wanted += 1
            if self.wanted == 1:
                self.limits = _controller().limit(limits=1, user_api="blas")

    def end(self) -> None:
        with self.lock:
            self.wanted -= 1
            if self.wanted == 0 and self.limits is not None:
                self.limits.restore_original_limits()


@functools.cache  # it looks through all libraries
def _controller() -> Any:
    import scipy.linalg  # noqa: F401 (it has a BLAS of its own)
    from threadpoolctl import ThreadpoolController

    return ThreadpoolController()


_LIMIT = _Limit()


def _begin_anew() -> None:
    """In a process that was forked: a thread of the other one may have held the lock."""
    global _LIMIT
    _LIMIT = _Limit(_LIMIT.wanted)


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_begin_anew)


@contextlib.contextmanager
def one_blas_thread() -> Iterator[None]:
    """While it is open, in all threads of this process."""
    limit = _LIMIT
    limit.begin()
    try:
        yield
    finally:
        limit.end()


def one_blas_thread_from_here() -> None:
    """For good, as in a worker beside others, also of a library that is loaded later."""
    from threadpoolctl import threadpool_limits

    os.environ["OPENBLAS_NUM_THREADS"] = os.environ["MKL_NUM_THREADS"] = "1"
    threadpool_limits(1, "blas")
