"""Tasks in parallel processes: what one of them cannot do does no harm to the others.

The processes are forked, so a task may hold anything, such as a model with functions of Python. Where the
system cannot fork, the tasks are done here, one after the other, without limits of time.

Why no library: the pool of concurrent.futures, and loky on top of it, knows no limit of time for one task,
and gives up all of them when one process dies. Pebble can do both, but hands tasks over by pickling, and
forks from a thread of its own, beside which the locks of others may stay closed in the child for ever.
"""

from __future__ import annotations

import contextlib
import gc
import logging
import multiprocessing
import os
import signal
import sys
import time
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from typing import Any, TypeVar

from linkwork.blas_threads import one_blas_thread_from_here

__all__ = ["Lost", "can_fork", "in_processes", "processor_count"]

T = TypeVar("T")
R = TypeVar("R")

#: Between two beats of the one who waits [s].
BEAT_SECONDS = 0.2


@dataclass(frozen=True)
class Lost:
    """Why a task has no answer: its process died, or its time was over."""

    reason: str
    late: bool = False  #: its time was over


@dataclass
class _Worker:
    process: BaseProcess
    connection: Connection
    place: int | None = None  #: of the item it works on
    deadline: float = float("inf")


def processor_count() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def can_fork() -> bool:
    """Whether `in_processes` has processes, and so can end what takes too long: a daemon has none."""
    return (
        hasattr(os, "fork")
        and sys.platform.startswith("linux")
        and not multiprocessing.current_process().daemon
    )


def in_processes(
    task: Callable[[T], R],
    items: Sequence[T],
    processes: int | None = None,
    seconds: float | None = None,
    beat: Callable[[Sequence[int]], object] = lambda places: None,
) -> Iterator[tuple[int, R | Lost]]:
    """(place, task(items[place])) as they come, from that many processes (None: one a processor).

    seconds  that one item may take; then its process is ended
    beat     called now and then with the places that are being worked on

    An exception of `task` ends everything; closing the iterator ends all processes.
    """
    if not can_fork():
        for place, item in enumerate(items):
            beat([place])
            yield place, task(item)
        return
    todo = list(range(len(items)))[::-1]
    crew: list[_Worker] = []
    count = min(processes or processor_count(), len(items))
    try:
        while todo or any(worker.place is not None for worker in crew):
            while todo and len(crew) < count:
                crew.append(_started(task, items, crew))
            for worker in crew:
                if worker.place is None and todo:
                    worker.place = todo.pop()
                    worker.deadline = time.monotonic() + seconds if seconds else float("inf")
                    with contextlib.suppress(OSError):  # it died: seen below
                        worker.connection.send(worker.place)
            beat([worker.place for worker in crew if worker.place is not None])
            yield from _answers(crew, seconds)
    finally:
        for worker in crew:
            _end(worker)


def _answers(crew: list[_Worker], seconds: float | None) -> Iterator[tuple[int, Any]]:
    """What came within a beat; a worker that is lost leaves the crew."""
    busy = {worker.connection: worker for worker in crew if worker.place is not None}
    for ready in wait(list(busy), BEAT_SECONDS):
        assert isinstance(ready, Connection)
        worker = busy.pop(ready)
        place, worker.place = worker.place, None
        assert place is not None
        try:
            answer, error = worker.connection.recv()
        except (EOFError, OSError):
            crew.remove(worker)
            worker.process.join(1.0)
            cause = _cause_of_death(worker.process)
            _end(worker)
            yield place, Lost(cause)
            continue
        if error is not None:
            raise error
        yield place, answer
    for worker in busy.values():
        if worker.place is not None and time.monotonic() > worker.deadline:
            crew.remove(worker)
            _end(worker)
            yield worker.place, Lost(f"not done after {seconds:g} s", late=True)


def _started(task: Callable[[T], R], items: Sequence[T], crew: Sequence[_Worker]) -> _Worker:
    context: Any = multiprocessing.get_context("fork")
    ours, theirs = context.Pipe()
    others = [ours, *(worker.connection for worker in crew)]
    process = context.Process(target=_serve, args=(theirs, others, task, items), daemon=True)
    with warnings.catch_warnings():
        warnings.simplefilter(
            "ignore", DeprecationWarning
        )  # of fork beside threads, which the child leaves alone
        with _uninterrupted():
            process.start()
    theirs.close()
    return _Worker(process, ours)


@contextlib.contextmanager
def _uninterrupted() -> Iterator[None]:
    """Ctrl-C and SIGTERM come afterwards: what they raise while a process forks is ignored, and so lost."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _serve(connection: Connection, others: Sequence[Connection], task: Any, items: Sequence[Any]) -> None:
    """The other process: it ends when nobody is left to ask it."""
    gc.freeze()  # what was there before is no garbage here: not to be looked through, and so copied
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # who asks heeds it
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT, signal.SIGTERM})
    os.environ["OMP_NUM_THREADS"] = "1"  # of threads counted from here on: others need processors, too
    one_blas_thread_from_here()
    logging.getLogger("linkwork").setLevel(logging.WARNING)  # who asks tells of each item
    for other in others:  # inherited; while they are open, nobody would notice that the one who asks is gone
        other.close()
    while True:
        try:
            place = connection.recv()
        except (EOFError, OSError):  # whoever asked is gone
            return
        try:
            answer: tuple[Any, BaseException | None] = task(items[place]), None
        except Exception as error:
            answer = None, error
        try:
            connection.send(answer)
        except OSError:
            return


def _end(worker: _Worker) -> None:
    worker.connection.close()
    worker.process.kill()
    worker.process.join()


def _cause_of_death(process: BaseProcess) -> str:
    code = process.exitcode
    if code is not None and code < 0:
        return f"its process was ended by {signal.Signals(-code).name}"
    return f"its process ended with code {code}"
