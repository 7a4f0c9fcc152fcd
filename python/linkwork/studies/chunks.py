"""Cases in tasks of a few seconds, on local processes or on any executor of concurrent.futures.

What one case costs is learned from the first ones, which go alone. A task whose process dies is given up;
its cases are tried once more, each alone, so that what kills a process takes no other with it.
"""

from __future__ import annotations

import concurrent.futures as futures
import math
import pickle
from collections.abc import Callable, Generator, Iterator, Sequence
from typing import Any

from linkwork.comparison.workers import Lost, in_processes, processor_count
from linkwork.errors import LinkworkError, OptionError
from linkwork.studies.cases import Answer, Case, Runner

__all__ = ["check_executor", "chunked", "run_cases", "workers_of"]

#: A task takes about so long [s], which is at most lost with its process.
TASK_SECONDS = 3.0

#: Tasks for each process where there are few cases, so that all end together.
TASKS_EACH = 4

#: No more than so many files for a study, each with the cases of a task.
FILES = 50_000

#: Tasks that an executor holds for each of its workers.
AHEAD = 3

#: Beyond the time of one case a task of several has so long [s]; then each of them is tried alone.
PATIENCE = 10 * TASK_SECONDS

Chunk = Sequence[Case]
Found = tuple[Chunk, Answer | Lost]
Pool = Callable[[Runner, Sequence[Chunk]], Iterator[Found]]


def check_executor(executor: Any, processes: int | None, runner: Runner) -> None:
    """OptionError: no executor, or a study that cannot go to other processes."""
    if executor is None:
        return
    if not callable(getattr(executor, "submit", None)):
        raise OptionError(
            f"executor {executor!r:.80} is no concurrent.futures.Executor: it has no submit", code="executor"
        )
    if processes is not None:
        raise OptionError("processes is of the local ones: with an executor leave it out", code="conflict")
    if isinstance(executor, futures.ThreadPoolExecutor):
        return
    try:
        pickle.dumps(runner)
    except Exception as error:
        raise OptionError(
            f"executor: the study cannot go to another process ({error}): functions must be of a module, no "
            "lambdas; or leave executor out for local processes",
            code="executor",
        ) from error


def workers_of(executor: Any, processes: int | None) -> int:
    if executor is None:
        return processes or processor_count()
    known = getattr(executor, "_max_workers", None)
    return known if isinstance(known, int) and known > 0 else processor_count()


def run_cases(
    runner: Runner, cases: Sequence[Case], executor: Any, processes: int | None,
    beat: Callable[[], object] = lambda: None, case_seconds: float | None = None,
) -> Generator[Found, None, None]:  # fmt: skip
    """(cases, what became of them) as they come. What takes longer than `case_seconds`, alone, is lost.

    LinkworkError: the executor works no more. Closing the iterator gives up what is under way.
    """
    workers = workers_of(executor, processes)
    pool = _local(processes, beat, case_seconds) if executor is None else _on(executor, workers, beat)
    lost: list[Case] = []
    seconds: list[float] = []
    for chunk, answer in pool(runner, [[case] for case in cases[:workers]]):
        if isinstance(answer, Lost) and answer.late:
            yield chunk, answer
        elif isinstance(answer, Lost):
            lost.extend(chunk)
        else:
            seconds.extend(run.seconds for run in answer.runs)
            yield chunk, answer
    mean = sum(seconds) / len(seconds) if seconds else TASK_SECONDS
    for chunk, answer in pool(runner, chunked(cases[workers:], mean, workers)):
        if isinstance(answer, Lost):
            lost.extend(chunk)
        else:
            yield chunk, answer
    yield from pool(runner, [[case] for case in lost])


def chunked(cases: Sequence[Case], seconds: float, workers: int) -> list[Chunk]:
    """Of so many that a task takes TASK_SECONDS, where a case takes `seconds`."""
    size = max(1, min(int(TASK_SECONDS / max(seconds, 1e-6)), math.ceil(len(cases) / (TASKS_EACH * workers))))
    size = max(size, math.ceil(len(cases) / FILES))
    return [cases[start : start + size] for start in range(0, len(cases), size)]


def _local(processes: int | None, beat: Callable[[], object], case_seconds: float | None) -> Pool:
    def run(runner: Runner, chunks: Sequence[Chunk]) -> Iterator[Found]:
        seconds = case_seconds
        if seconds is not None and any(len(chunk) > 1 for chunk in chunks):
            seconds += PATIENCE
        for place, answer in in_processes(runner, chunks, processes, seconds, lambda _: beat()):
            yield chunks[place], answer

    return run


def _on(executor: Any, workers: int, beat: Callable[[], object]) -> Pool:
    def run(runner: Runner, chunks: Sequence[Chunk]) -> Iterator[Found]:
        todo = list(chunks)[::-1]
        under_way: dict[futures.Future[Answer], Chunk] = {}
        try:
            while todo or under_way:
                while todo and len(under_way) < AHEAD * workers:
                    chunk = todo.pop()
                    under_way[_submitted(executor, runner, chunk)] = chunk
                done, _ = futures.wait(under_way, timeout=0.5, return_when=futures.FIRST_COMPLETED)
                beat()
                for future in done:
                    yield under_way.pop(future), _answer(future)
        finally:
            for future in under_way:
                future.cancel()

    return run


def _submitted(executor: Any, runner: Runner, chunk: Chunk) -> futures.Future[Answer]:
    try:
        future: futures.Future[Answer] = executor.submit(runner, chunk)
    except (futures.BrokenExecutor, RuntimeError) as error:
        raise _broken(error) from error
    return future


def _answer(future: futures.Future[Answer]) -> Answer | Lost:
    """LinkworkError: nobody is there any more."""
    error = future.exception()
    if isinstance(error, futures.BrokenExecutor):
        raise _broken(error) from error
    return future.result() if error is None else Lost(f"its task ended with {type(error).__name__}: {error}")


def _broken(error: Exception) -> LinkworkError:
    return LinkworkError(
        f"executor: works no more ({type(error).__name__}: {error}); what is done is kept where a directory "
        "was given: run the study again with a new one",
        code="executor",
    )
