"""Cases in tasks of a few seconds, on local processes or on any executor of concurrent.futures.

What one case costs is learned from the first ones, which go alone, and of cases in lanes from the first
tasks. A task whose process dies is tried once more in halves, and these in halves, until what kills a process
is alone and takes no other case with it.
"""

from __future__ import annotations

import concurrent.futures as futures
import math
from collections.abc import Callable, Generator, Iterator, Sequence
from typing import Any

from linkwork.comparison.workers import Lost, in_processes
from linkwork.errors import LinkworkError
from linkwork.running.remarks import message_of
from linkwork.studies.agreement import Here, Refusal, Sent
from linkwork.studies.cases import Answer, Case, Runner
from linkwork.studies.executors import adapted, workers_of
from linkwork.studies.lanes import AT_ONCE, PACK

__all__ = ["chunked", "run_cases"]

#: A task takes about so long [s], which is at most lost with its process.
TASK_SECONDS = 3.0

#: Tasks for each process where there are few cases, so that all end together.
TASKS_EACH = 4

#: No more than so many files for a study, each with the cases of a task, in all of its shards together.
FILES = 50_000

#: Tasks that an executor holds for each of its workers.
AHEAD = 3

#: Beyond the time of one case a task of several has so long [s]; then each of them is tried alone.
PATIENCE = 10 * TASK_SECONDS

#: Beyond the time of the case that it has alone a process is waited for so long [s]: to start and to answer.
HANDING_OVER = 1.0

Chunk = Sequence[Case]
Found = tuple[Chunk, Answer | Lost]
Future = futures.Future[Answer | Refusal]
Pool = Callable[[Sequence[Chunk]], Iterator[Found]]


def run_cases(
    runner: Runner, cases: Sequence[Case], executor: Any, processes: int | None,
    beat: Callable[[], object] = lambda: None, case_seconds: float | None = None, total: int = 0,
    here: Here | None = None,
) -> Generator[Found, None, None]:  # fmt: skip
    """(cases, what became of them) as they come. What takes longer than `case_seconds`, alone, is lost.
    `total`: cases of the whole study, of which these may be a shard. `here`: what an executor's processes are
    to have as this one does.

    LinkworkError: the executor works no more, or would run something else. Closing the iterator gives up what
    is under way.
    """
    workers = workers_of(executor, processes)
    local = executor is None
    together = AT_ONCE if runner.lanes else 1
    pool = (
        _local(runner, processes, beat, case_seconds, together) if local
        else _on(adapted(executor), workers, beat, Sent(runner, here or Here()))
    )  # fmt: skip
    lost: list[Chunk] = []
    rest, mean = cases, 0.0
    for turn in range(3 if runner.lanes else 2):
        if turn == 0:
            chunks: list[Chunk] = [[case] for case in rest[:workers]]
        else:
            chunks = chunked(rest, mean, workers, PACK if runner.lanes else 1, total)
        if turn == 1 and runner.lanes:  # full packs take less for a case than one that is alone
            chunks = chunks[:workers]
        rest = rest[sum(map(len, chunks)) :]
        seconds: list[float] = []
        for chunk, answer in pool(chunks):
            if isinstance(answer, Lost) and not (answer.late and len(chunk) == 1):
                lost.extend(_parts(chunk, answer))
                continue
            if isinstance(answer, Answer):
                seconds.extend(run.seconds for run in answer.runs)
            yield chunk, answer
        mean = sum(seconds) / len(seconds) if seconds else TASK_SECONDS
    while lost:
        again, lost = lost, []
        for alone in (False, True):  # apart, as those that are alone have the time of one
            chosen = [chunk for chunk in again if (len(chunk) == 1) is alone]
            for chunk, answer in pool(chosen) if chosen else ():
                if isinstance(answer, Lost) and len(chunk) > 1:
                    lost.extend(_parts(chunk, answer))
                else:
                    yield chunk, answer


def _parts(chunk: Chunk, lost: Lost) -> list[Chunk]:
    """Halves, so that few of many cases are run again by themselves; of what took too long each case."""
    if lost.late or len(chunk) == 1:
        return [[case] for case in chunk]
    middle = (len(chunk) + 1) // 2
    if middle > PACK:
        middle = math.ceil(middle / PACK) * PACK
    return [chunk[:middle], chunk[middle:]]


def chunked(
    cases: Sequence[Case], seconds: float, workers: int, pack: int = 1, total: int = 0
) -> list[Chunk]:
    """Of so many that a task takes TASK_SECONDS where a case takes `seconds`; of whole packs if it can; and
    of so many that a study of `total` cases has no more than FILES of them."""
    size = max(1, min(int(TASK_SECONDS / max(seconds, 1e-6)), math.ceil(len(cases) / (TASKS_EACH * workers))))
    size = max(size, math.ceil(max(len(cases), total) / FILES))
    size = math.ceil(size / pack) * pack if size >= pack / 2 else size
    return [cases[start : start + size] for start in range(0, len(cases), size)]


def _local(
    runner: Runner, processes: int | None, beat: Callable[[], object], case_seconds: float | None,
    together: int,
) -> Pool:  # fmt: skip
    """Of which `together` cases are run side by side."""

    def run(chunks: Sequence[Chunk]) -> Iterator[Found]:
        seconds = case_seconds
        if seconds is not None:
            seconds += PATIENCE if any(len(chunk) > 1 for chunk in chunks) else HANDING_OVER
        for place, answer in in_processes(runner, chunks, processes, seconds, lambda _: beat()):
            yield from _judged(chunks[place], answer, case_seconds, together)

    return run


def _judged(
    chunk: Chunk, answer: Answer | Lost, case_seconds: float | None, together: int
) -> Iterator[Found]:
    """What took longer than a case may is late, by its own time or by that of all cases beside it.

    That of a case alone decides in the end: which are late does not depend on how they are shared out.
    """
    if case_seconds is None:
        yield chunk, answer
        return
    late = Lost(f"not done after {case_seconds:g} s", late=True)
    if isinstance(answer, Lost):
        yield chunk, late if answer.late else answer
        return
    groups = [slice(start, start + together) for start in range(0, len(chunk), together)]
    slow = [it for it in groups if sum(run.seconds for run in answer.runs[it]) > case_seconds]
    yield from ((chunk[it], late) for it in slow)
    good = [it for it in groups if it not in slow]
    if good:
        runs = [run for it in good for run in answer.runs[it]]
        yield [case for it in good for case in chunk[it]], Answer(answer.machine, runs)


def _on(executor: Any, workers: int, beat: Callable[[], object], sent: Sent) -> Pool:
    def run(chunks: Sequence[Chunk]) -> Iterator[Found]:
        todo = list(chunks)[::-1]
        under_way: dict[Future, Chunk] = {}
        try:
            while todo or under_way:
                while todo and len(under_way) < AHEAD * workers:
                    chunk = todo.pop()
                    under_way[_submitted(executor, sent, chunk)] = chunk
                done, _ = futures.wait(under_way, timeout=0.5, return_when=futures.FIRST_COMPLETED)
                beat()
                for future in done:
                    yield under_way.pop(future), _answer(future, sent)
        finally:
            for future in under_way:
                future.cancel()

    return run


def _submitted(executor: Any, sent: Sent, chunk: Chunk) -> Future:
    try:
        future: Future = executor.submit(sent, list(chunk))
    except Exception as error:  # every library has its own: it is shut down, its scheduler is gone
        raise _broken(error) from error
    return future


def _answer(future: Future, sent: Sent) -> Answer | Lost:
    """LinkworkError: nobody is there any more, or one who would run something else."""
    try:
        error = future.exception()
    except futures.CancelledError as cancelled:  # by the executor: nobody here does before the end
        raise _broken(cancelled) from cancelled
    if isinstance(error, futures.BrokenExecutor):
        raise _broken(error) from error
    if error is None:
        found = future.result()
        if isinstance(found, Refusal):
            raise sent.error(found)
        return found
    return Lost(f"its task ended with {type(error).__name__}: {message_of(error)}")


def _broken(error: Exception) -> LinkworkError:
    cause = message_of(error) or "its scheduler, or all of its workers, are gone"
    return LinkworkError(
        f"executor: works no more ({type(error).__name__}: {cause}); what is done is kept where a directory "
        "was given: run the study again with a new one",
        code="executor",
    )
