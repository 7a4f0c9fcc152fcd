"""What is compared: an operation of a peer, checked against linkwork's physics, then timed."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from statistics import median

from mechanism import Mechanism

STEP = 1e-3  #: of all integrators [s]
LEAST_STEPS, MOST_STEPS = 5, 100  #: from one state: every batch is about the same stretch of the motion
FIRST_STEPS = 3  #: some codes look closely at how a motion begins
BATCHES = 10

#: Tolerance of first-order methods: twice the h / (2 SPAN) that velocities half a step late make.
FIRST_ORDER = 0.1

#: Runs so many calls, or steps, and returns the seconds that they took.
Batch = Callable[[int], float]


class OutOfReach(Exception):
    """An operation that would take too long."""


@dataclass(frozen=True)
class Operation:
    """One thing that a peer does with a mechanism."""

    seconds: Callable[[float], float]  # of one call, measured for so many seconds
    counterpart: str  # the operation of linkwork that it is compared to
    deviation: float | None  # of its accelerations from linkwork's, see mechanism.deviation
    tolerance: float  # of that, by the nature of the peer's formulation and integrator
    note: str = ""


#: Makes the operation; None where it has no meaning for the mechanism. MemoryError, OutOfReach.
Builder = Callable[[Mechanism], Operation | None]
Builders = Mapping[str, Builder]


def calls(call: Callable[[], object]) -> Batch:
    """In processor time of all threads: what else the machine does counts less."""

    def batch(count: int) -> float:
        begun = time.process_time()
        for _ in range(count):
            call()
        return time.process_time() - begun

    return batch


def typical(batch: Batch, seconds: float, least: int = 1, most: int = 1_000_000) -> float:
    """Seconds of one call: the median over batches of that many, made in about so many seconds altogether.

    Where the smallest batch takes longer than that, it is the only one.
    """
    taken = batch(least)
    if taken > seconds:
        return taken / least
    one = max(batch(least) / least, 1e-7)
    count = max(least, min(most, int(seconds / BATCHES / one)))
    repeats, end = [batch(count) / count], time.perf_counter() + seconds
    while time.perf_counter() < end or len(repeats) < 3:
        repeats.append(batch(count) / count)
    return median(repeats)


def beyond_first(run: Batch, seconds: float) -> float:
    """Seconds of one step of many, from `run`, which makes so many from the start."""

    def batch(count: int) -> float:  # both in turn: a start may take longer than the steps
        first = run(FIRST_STEPS)
        return run(FIRST_STEPS + count) - first

    return typical(batch, seconds, LEAST_STEPS, MOST_STEPS)


def without_call(call: Callable[[], object], empty: Callable[[], object], seconds: float) -> float:
    """Seconds of one call from Python, less those of one that has nothing to do."""
    return max(0.0, typical(calls(call), seconds) - typical(calls(empty), min(seconds, 0.05)))
