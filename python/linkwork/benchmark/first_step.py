"""One step of a mechanism by one linear solver: whether it can be done, and how much memory it takes."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from linkwork.arrays import Floats
from linkwork.benchmark import memory
from linkwork.benchmark.subject import Subject
from linkwork.running import simulation


@dataclass(frozen=True)
class FirstStep:
    """A state in motion, t [s] and y = (q, v) (13n,), and what the way there took."""

    t: float
    y: Floats
    seconds: float  #: to compile the model and to make the step
    peak_bytes: int | None  #: the most memory that the process had in use
    growth_bytes: int | None  #: that less what it had before, with the model in it


def make_first_step(subject: Subject, options: Mapping[str, Any]) -> FirstStep:
    """One RK4 step of the size that the mechanism recommends. LinkworkError, MemoryError: it cannot be."""
    model, step = subject.build(), subject.step
    model.compiled()
    memory.forget_peak()
    before, started = memory.peak(), time.perf_counter()
    result = simulation.simulate(model, step, step, "rk4", progress=False, **options)
    seconds, peak = time.perf_counter() - started, memory.peak()
    y = np.concatenate([result.q[-1].ravel(), result.v[-1].ravel()])
    growth = None if peak is None or before is None else peak - before
    return FirstStep(float(result.t[-1]), y, seconds, peak, growth)
