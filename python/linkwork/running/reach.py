"""Runs that end because their drivers ask for more than the joints allow.

Toward such a pose velocities grow without limit, so that the run ends with whatever fails first: what it says
of that is no help. The motion is then followed by the constraints alone, from a state before.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress

import numpy as np

from linkwork.constraints.continuation import Continuation
from linkwork.constraints.equations import Equations
from linkwork.constraints.impasse import Impasse
from linkwork.errors import (
    LinkworkError,
    NotConvergedError,
    NotFiniteError,
    SingularSystemError,
    StepSizeError,
    ViolationError,
)
from linkwork.modeling.model import Model
from linkwork.motion.records import Snapshot

__all__ = ["telling_of_reach"]

#: With which such runs end.
ENDS = (NotConvergedError, NotFiniteError, SingularSystemError, StepSizeError, ViolationError)

#: How far beyond its end, as a part of the run so far, and in steps: it may end a little before that pose.
BEYOND, STEPS_BEYOND = 1e-3, 2

#: By how much a state may violate the joints [rad, sizes of the mechanism] to be one from which to follow.
NEAR = 0.05

#: How far it may come as it moves [rad, sizes of the mechanism]: one beyond that has diverged.
FARTHEST = 100.0

#: How many states are tried, and how long that may take [s]; models with more bodies are not looked at.
STATES, SECONDS, MOST_BODIES = 8, 5.0, 2000

#: The shortest step, as a part of the way there, which is a few steps of the run, or frames of it.
SHORTEST = 2.0**-24


@contextmanager
def telling_of_reach(model: Model) -> Iterator[None]:
    """What ends a run here says so where its drivers ask for more than the joints allow."""
    try:
        yield
    except ENDS as error:
        if model.drivers and model.body_count <= MOST_BODIES:
            with suppress(Exception), np.errstate(all="ignore"):  # the error of the run is the one to raise
                found = _impasse(model, error)
                if found is not None and found.dead and found.driven:
                    _tell(error, found)
        raise


def _tell(error: LinkworkError, found: Impasse) -> None:
    error.add_note(f"linkwork: the run ended with: {error.message}")
    error.message = (
        f"the mechanism cannot follow its drivers beyond t = {found.time:.9g} s: {found}; end before it, or "
        "drive another joint"
    )
    error.args = (error.message,)
    error.code, error.joints, error.subject, error.field = "dead_point", found.joints, "", ""
    error.residuals["smallest_singular_value"] = found.sigma


def _impasse(model: Model, error: LinkworkError) -> Impasse | None:
    """Near the time of the error, on the way from the last state that is near the constraints."""
    end = _end(error)
    continuation = Continuation(Equations(model), end, shortest=SHORTEST, most_seconds=SECONDS)
    continuation.measure()
    for state in _states(error):
        known = state.t < end and continuation.begin_near(state, NEAR)
        if known and continuation.way_to(end) < FARTHEST:
            try:
                continuation.go_to(end)
            except NotConvergedError:
                return continuation.impasse()
            return None
    return None


def _end(error: LinkworkError) -> float:
    """[s] until when to follow the motion."""
    assert error.state is not None
    end = error.state.t if error.time is None else error.time
    first = error.state.t if error.result is None else float(error.result.t[0])
    return end + max(BEYOND * (end - first), STEPS_BEYOND * (error.step or 0.0))


def _states(error: LinkworkError) -> Iterator[Snapshot]:
    """From the last on, farther and farther back: those beyond that pose are near no constraints."""
    assert error.state is not None
    yield error.state
    frames = 0 if error.result is None else len(error.result)
    for back in (2**k for k in range(STATES - 1)):
        if back <= frames:
            assert error.result is not None
            yield error.result.snapshot(-back)
