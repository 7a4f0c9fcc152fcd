"""Times at which something that acts on a mechanism is known not to be smooth, as a run meets them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from linkwork import _core
from linkwork.errors import ModelError, OptionError, warn
from linkwork.functions import TimeFunction, check_breaks
from linkwork.modeling.model import Model

#: Jumps of a driver that are none, relative to its size and to the way that it makes beside the break.
ROUNDOFF = 1e-9

#: The same, relative to the largest values up to the next breaks: near zero these are differences of numbers.
CANCELLED = 16 * float(np.finfo(float).eps)

#: By which times of one break may differ, relative to them.
ROUNDING = 64 * float(np.finfo(float).eps)

#: So many jumps are noted in a manifest.
NOTED = 100


def of_run(model: Model, given: ArrayLike, t_start: float, t_end: float) -> list[float]:
    """Those after the start and not after the end, up to roundoff [s], ascending.

    OptionError: times that are none.
    """
    try:
        times = set(model.compiled().breaks)
        if not (isinstance(given, tuple) and not given):
            times.update(check_breaks(given, "simulate"))
    except ModelError as error:
        raise OptionError(error.message, code=error.code) from error
    for _, signal in model.signals:
        times.update(signal.break_points)
    return sorted(t for t in times if t_start < t <= t_end + ROUNDING * abs(t_end))


def beside(model: Model, known: Sequence[float], t_start: float, t_end: float) -> list[float]:
    """Those beside which a run whose steps end at breaks, of which it knows the model's and these, evaluates
    functions of time, at its start and end, too [s]."""
    at_start = of_run(model, (), np.nextafter(t_start, -np.inf), t_end)
    return sorted({*at_start, *(t for t in known if t >= t_start)})


class Jump(NamedTuple):
    """Of the velocity that a driver demands, by `size`."""

    what: str
    time: float  # [s]
    size: float


def velocity_jumps(model: Model, t_start: float, t_end: float) -> list[Jump]:
    """That the drivers demand, after the start and before the end [s], in order of time.

    ModelError: the position that one demands jumps there, or at the end, which no force can bring about.
    """
    found: list[Jump] = []
    for what, signal in model.drivers:
        for t, sides, order, size in _jumps(signal, t_start, t_end):
            if order == 0:
                raise ModelError(
                    f"{what} jumps by {size:.4g} at t = {t:.6g} s: it drives a joint, and no force moves "
                    "bodies in no time; give it a ramp, such as functions.cycloidal",
                    code="position_jump",
                    time=t,
                )
            if order == 1 and sides[1] < t_end:
                found.append(Jump(what, t, size))
    return sorted(found, key=lambda it: it.time)


def check_drivers(model: Model, t_start: float, t_end: float, *, adaptive: bool) -> list[Jump]:
    """Of the velocities that drivers demand in the run, by which bodies are struck.

    ModelError: the position that a driver demands jumps in the run, which no force can bring about.
    LinkworkWarning: its velocity jumps, and the steps are fixed. With steps that follow tolerances the bodies
    are struck there.
    """
    struck = velocity_jumps(model, t_start, t_end)
    if struck and not adaptive:
        warn(
            f"{_told(struck)}: an impact, "
            "which fixed steps smear over some steps; with rtol the bodies are struck at that time"
        )
    return struck


def check_apart(model: Model, given: ArrayLike, step: float, t_start: float, t_end: float) -> None:
    """LinkworkWarning: two breaks of one function, or of those of laws and `given`, which are not one by
    rounding, are so as a fixed step ends at both: what acts between them is left out."""
    functions = [(what, signal.break_points) for what, signal in model.signals]
    functions.append(("breaks", [*model.compiled().breaks, *np.ravel(given).tolist()]))
    found = [(what, *pair) for what, times in functions for pair in _merged(times, step, t_start, t_end)]
    if not found:
        return
    what, first, last = found[0]
    more = f" (and {len(found) - 1} more such)" if len(found) > 1 else ""
    warn(
        f"{what}: the breaks at t = {first:.12g} s and {last - first:.3g} s later{more} are at one end of a "
        f"step of {step:.6g} s, and so one: what acts between them is left out; give a pulse a width that "
        "steps resolve, or use rtol, with which steps end at both"
    )


def _merged(times: Iterable[float], step: float, t_start: float, t_end: float) -> list[tuple[float, float]]:
    """Neighbors of which some time between is in the run [s]."""
    pairs = [it for it in pairwise(sorted(times)) if it[1] > t_start and it[0] < t_end]
    by_rounding, by_steps = (_core.BreakPoints(sorted({*chain(*pairs)})) for _ in range(2))
    by_steps.meet_steps(t_start, step, (t_start, t_end))
    return [(a, b) for a, b in pairs if by_rounding.after(a) < b < by_steps.after(a)]


def struck_between_frames(model: Model, first: float, last: float) -> list[Jump]:
    """Of a motion that drivers prescribe from t = 0 on, those from the first to the last frame [s].

    ModelError: a position jumps. LinkworkWarning: a velocity does, and no frame can have what that takes.
    """
    struck = [it for it in velocity_jumps(model, 0.0, last) if it.time >= first]
    if struck:
        warn(
            f"{_told(struck)}: an impact, by an impulse that forces, efforts and reactions of the frames are "
            "without; give the driver a ramp, such as functions.cycloidal, to know what it takes"
        )
    return struck


def stored_energy_jumps(model: Model, t_start: float, t_end: float) -> list[float]:
    """When stiffness, free length or free range of a force element jumps, after the start and not after the
    end [s], ascending: energy that it stores jumps then."""
    found: set[float] = set()
    for _, signal in model._storing:
        found.update(t for t, _, order, _ in _jumps(signal, t_start, t_end) if order == 0)
    return sorted(found)


def noted(struck: Sequence[Jump]) -> dict[str, Any]:
    """The first hundred for a manifest."""
    told = [{"t": it.time, "jump": it.size, "of": f"the rate of {it.what}"} for it in struck[:NOTED]]
    return {"impacts": told} if told else {}


def _told(struck: Sequence[Jump]) -> str:
    """ "the rate of driver 'd': velocity jumps by 2 at t = 0.5 s", of the first one, and how many more do."""
    first = struck[0]
    more = f", and {len(struck) - 1} more do" if len(struck) > 1 else ""
    return f"the rate of {first.what} jumps by {first.size:.4g} at t = {first.time:.6g} s{more}"


def on_either_side(breaks: Iterable[float]) -> dict[tuple[float, float], float]:
    """The last time before each break and the first after it [s], in spite of rounding, ascending, and the
    first of the breaks that are one there."""
    times = sorted(breaks)
    known, found = _core.BreakPoints(times), dict[tuple[float, float], float]()
    for t in times:
        found.setdefault((known.before(t), known.after(t)), t)
    return found


def _jumps(
    signal: TimeFunction, t_start: float, t_end: float
) -> Iterator[tuple[float, tuple[float, float], int, float]]:
    """Of its breaks after the start and not after the end [s]: when, the times beside it, and `_jump`."""
    inside = on_either_side(t for t in signal.break_points if t_start < t <= t_end)
    begins, ends = [t_start, *(after for _, after in inside)], [*(before for before, _ in inside), t_end]
    for (sides, t), last, following in zip(inside.items(), begins, ends[1:], strict=False):
        yield t, sides, *_jump(signal, last, sides, following)


def _jump(
    signal: TimeFunction, last: float, sides: tuple[float, float], following: float
) -> tuple[int, float]:
    """The lowest derivative that jumps between both sides of a break, of order 0 or 1, and by how much;
    (2, 0.0): neither.

    last, following: the breaks, or ends of the run, next to it [s].
    """
    before, after = (signal.evaluate(at) for at in sides)
    beside = 0.5 * (sides[1] - sides[0])
    for level in (0, 1):
        size = abs(after[level] - before[level])
        slope = max(abs(before[level + 1]), abs(after[level + 1]))
        noise = ROUNDOFF * max(abs(after[level]), abs(before[level])) + 8 * beside * slope
        if (
            math.isfinite(size)
            and size > noise
            and size > CANCELLED * _largest(signal, level, last, sides, following)
        ):
            return level, size
    return 2, 0.0


def _largest(
    signal: TimeFunction, level: int, last: float, sides: tuple[float, float], following: float
) -> float:
    """Of the derivative of that order, in between the breaks on either side."""
    parts = (0.25, 0.5, 0.75)
    times = [t + part * (end - t) for t, end in zip(sides, (last, following), strict=True) for part in parts]
    return max(abs(signal.evaluate(at)[level]) for at in times)
