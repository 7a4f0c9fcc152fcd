"""One thread for BLAS and LAPACK of NumPy and SciPy: their matrices are small here, and many.

Threads of OpenBLAS wait for each other by spinning. Where other processes want the processors, too, as in a
pool of workers, each of which has as many threads, an analysis takes ten times as long. And what is found
does not depend on how many there are.
"""

from __future__ import annotations

import contextlib
import functools
import os
from collections.abc import Iterator
from typing import Any

__all__ = ["one_blas_thread", "one_blas_thread_from_here"]


@functools.cache  # it looks through all libraries
def _controller() -> Any:
    import scipy.linalg  # noqa: F401 (it has a BLAS of its own)
    from threadpoolctl import ThreadpoolController

    return ThreadpoolController()


@contextlib.contextmanager
def one_blas_thread() -> Iterator[None]:
    """While it is open; in all threads of this process, where no other one has the say over BLAS."""
    with _controller().limit(limits=1, user_api="blas"):
        yield


def one_blas_thread_from_here() -> None:
    """For good, as in a worker beside others, also of a library that is loaded later."""
    from threadpoolctl import threadpool_limits

    os.environ["OPENBLAS_NUM_THREADS"] = os.environ["MKL_NUM_THREADS"] = "1"
    threadpool_limits(1, "blas")
