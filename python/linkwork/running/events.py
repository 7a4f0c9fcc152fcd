"""Events of a run: what happens when a function of time and state passes through zero."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from typing import Any, NamedTuple, overload

import numpy as np
from numpy.typing import ArrayLike

from linkwork import _core
from linkwork.arguments import UNREADABLE, array, check_called, is_iterable, is_number, is_text
from linkwork.arrays import Floats
from linkwork.errors import ModelError, OptionError
from linkwork.fingerprints import law
from linkwork.functions.calls import Calls
from linkwork.modeling.handles import Body
from linkwork.modeling.model import Model

__all__ = ["Event", "State", "Watched", "calls_of", "compile_events", "events_of", "functions_of"]


#: Makes a context, of the time [s].
Changing = Callable[[float], AbstractContextManager[object]]


class _Part:
    """A part of an array of the state, which is assigned in place."""

    def __init__(self, array: str, part: slice, documentation: str) -> None:
        self._array, self._part, self.__doc__ = array, part, documentation

    @overload
    def __get__(self, state: None, kind: type) -> _Part: ...
    @overload
    def __get__(self, state: object, kind: type) -> Floats: ...
    def __get__(self, state: object, kind: type) -> _Part | Floats:
        return self if state is None else getattr(state, self._array)[self._part]

    def __set_name__(self, kind: type, name: str) -> None:
        self._name = name

    def __set__(self, state: object, value: ArrayLike) -> None:
        """OptionError: no numbers, or of another shape, which is not stretched to that of the state."""
        part, new = self.__get__(state, type(state)), array(value, f"state: {self._name}")
        assert not isinstance(part, _Part)
        if new.shape not in ((), part.shape):
            raise OptionError(f"state: {self._name} has shape {part.shape}, not {new.shape}", code="shape")
        part[...] = new


#: Euler parameters that a change leaves: their length counts for nothing, as long as there is one.
SHORTEST = 1e-6


class BodyState:
    """Of one body: what is assigned to it, whole or in part, changes the state that it is of."""

    __slots__ = ("_q", "_v")

    position = _Part("_q", np.s_[:3], "Center of mass (3,), inertial [m].")
    orientation = _Part("_q", np.s_[3:], "Euler parameters (4,), scalar first.")
    velocity = _Part("_v", np.s_[:3], "Of the center of mass (3,), inertial [m/s].")
    omega = _Part("_v", np.s_[3:], "Angular velocity (3,), body axes [rad/s].")

    def __init__(self, q: Floats, v: Floats) -> None:
        self._q, self._v = q, v


class State:
    """Positions and velocities of all bodies: q (n, 7) and v (n, 6) as in `Result`, or `body(name)`."""

    __slots__ = ("_model", "_q", "_v")

    q = _Part("_q", np.s_[:], "Poses (n, 7): position, then Euler parameters.")
    v = _Part("_v", np.s_[:], "Velocities (n, 6): inertial velocity, then body-fixed angular velocity.")

    def __init__(self, model: Model, y: Floats) -> None:
        """`y` (13n,) = (q, v); the state is a view of it."""
        split = 7 * model.body_count
        self._model = model
        self._q, self._v = y[:split].reshape(-1, 7), y[split:].reshape(-1, 6)

    def body(self, name: str | Body) -> BodyState:
        """The state of one body, by name or handle.

            lw.Event(lambda t, state: state.body("rod").velocity[2], name="turning point")

        ModelError: no such body.
        """
        name = name.name if isinstance(name, Body) else name
        place = self._model.compiled().find_body(name) if is_text(name) else -1
        if place < 0:
            self._model.find(name)  # says what is near
            raise ModelError("the ground has no state", code="unknown_name")
        return BodyState(self._q[place], self._v[place])


@dataclass(frozen=True)
class Event:
    """A function of (t [s], state) that passes through zero; adaptive runs only.

    direction  1: rising, -1: falling, 0: both
    terminal   the run ends there
    change     change(t, state) gives the state other values in place, an impact for example. The state then
               goes to the constraints with the least change in the metric of the masses: joints answer an
               impulse on one body with impulses of their own. The run goes on from there, or ends there where
               `change` returns True
    tolerance  of the time [s], beside roundoff; None: 1e-12 s, or 1e-9 of the longest step where that is less

    A step is looked at in four places: an event between two of which the function returns to its sign is
    not seen; `step` in `simulate` limits them. A value of zero at the start of a run is no event, at its very
    end it is one. Events whose times are the same, but for their tolerances, all come, those that change or
    end the run first, in the order in which they are given; each change sees what those before it have
    changed. Events that come after ever shorter times, like the bounces of a ball, end the run with a
    StepSizeError; so does what a change has stopped and a force pushes through zero again.
    """

    function: Callable[[float, State], float]
    name: str = ""
    direction: int = 0
    terminal: bool = False
    change: Callable[[float, State], bool | None] | None = None
    tolerance: float | None = None

    @property
    def label(self) -> str:
        """Its name, or that of its function."""
        return (
            self.name
            if isinstance(self.name, str) and self.name
            else str(getattr(self.function, "__name__", "event"))
        )

    def _check(self) -> None:
        who = f"event '{self.label}'"
        if not isinstance(self.name, str):
            raise OptionError(f"event: name {self.name!r:.80} is no text", code="event")
        if isinstance(self.direction, bool) or not isinstance(self.direction, int) or abs(self.direction) > 1:
            raise OptionError(f"{who}: direction {self.direction!r:.80} is not -1, 0 or 1", code="event")
        if not isinstance(self.terminal, bool | np.bool_):
            raise OptionError(f"{who}: terminal {self.terminal!r:.80} is not True or False", code="event")
        if self.tolerance is not None and (not is_number(self.tolerance) or self.tolerance < 0):
            raise OptionError(
                f"{who}: tolerance {self.tolerance!r:.80} must be zero or positive [s]", code="event"
            )

    def compiled(
        self, model: Model, changing: Changing = nullcontext, calls: Calls | None = None
    ) -> _core.Event:
        """The same event of a run of `model` in the compiled module.

            lw.Event(lambda t, state: state.body("rod").position[2], name="floor").compiled(model)

        changing  a context in which `change` is called
        calls     those of its function, as `_calls` gives them, where they are looked at later

        OptionError: what is no function, or no direction, tolerance, or answer to whether it is terminal.
        """
        self._check()
        for what, given in (("function", self.function), ("change", self.change)):
            if not callable(given) and not (given is None and what == "change"):
                raise OptionError(
                    f"event '{self.label}': {what} {given!r} is no function of (t, state)", code="event"
                )
            if given is not None:
                check_called(given, ("t", "state"), f"event '{self.label}': {what}", OptionError)

        asked = calls or self._calls(model)

        def function(t: float, y: Floats) -> float:
            return self._number(t, asked.ask(t, y))

        def change(t: float, y: Floats) -> tuple[ArrayLike, bool]:
            changed = np.array(y)
            assert self.change is not None
            with changing(t):
                ends = self.change(t, State(model, changed))
            if not isinstance(ends, bool | np.bool_ | None):
                raise OptionError(
                    f"event '{self.label}': change must alter the state in place and return nothing, or True "
                    "to end the run",
                    code="event",
                )
            self._check_changed(model, t, changed)
            return changed, bool(ends)

        return _core.Event(
            self.label,
            function,
            int(self.direction),
            bool(self.terminal),
            None if self.change is None else change,
            self.tolerance,
        )

    def _calls(self, model: Model) -> Calls:
        """Of its function, each with t [s] and y (13n,) in a run of `model`."""
        return Calls(self.function, lambda t, y: (t, State(model, y)))

    def _number(self, t: float, value: object) -> float:
        """What its function returned. OptionError: no number, or whether it has passed zero."""
        who = f"event '{self.label}': its function returned {value!r}"
        if isinstance(value, bool | np.bool_):
            raise OptionError(
                f"{who}; give what passes zero, such as a height, and not whether it has", code="event"
            )
        try:
            return float(value)  # type: ignore[arg-type]
        except UNREADABLE as error:
            raise OptionError(f"{who}, no number (t = {t:g} s)", code="event") from error

    def _check_changed(self, model: Model, t: float, y: Floats) -> None:
        """OptionError: a body is nowhere, or has no orientation."""
        split = 7 * model.body_count
        q, v = y[:split].reshape(-1, 7), y[split:].reshape(-1, 6)
        finite = np.logical_and(np.isfinite(q).all(axis=1), np.isfinite(v).all(axis=1))
        wrong = np.flatnonzero(~finite | ~(np.linalg.norm(q[:, 3:], axis=1) >= SHORTEST))
        if not len(wrong):
            return
        body = int(wrong[0])
        name = model.compiled().body_name(body)
        what = "a state that is not finite" if body in np.flatnonzero(~finite) else "no orientation"
        raise OptionError(
            f"event '{self.label}': its change leaves body '{name}' {what} (t = {t:g} s)", code="event"
        )


class Watched(NamedTuple):
    """An event of a run."""

    label: str
    compiled: _core.Event
    event: Event
    calls: Calls  #: of its function

    def laws(self) -> tuple[str, str]:
        """Of its function and its change, with what they read now: see linkwork.fingerprints.law."""
        return law(self.event.function), law(self.event.change)


def functions_of(events: object) -> dict[str, Callable[..., Any]]:
    """What events call, by the name of the event."""
    given = events if is_iterable(events) else [] if events is None else [events]
    found: dict[str, Callable[..., Any]] = {}
    for place, event in enumerate(it for it in given if isinstance(it, Event)):
        found[f"event {event.label}" if place == 0 else f"event {event.label}, {place + 1}"] = event.function
        if event.change is not None:
            found[f"change of event {event.label}, {place + 1}"] = event.change
    return found


def events_of(given: object) -> list[Event]:
    """One, several or none; what gives them but once is used up. OptionError: something that is no Event."""
    found = list(given) if is_iterable(given) else [] if given is None else [given]
    for event in found:
        if not isinstance(event, Event):
            raise OptionError(f"events: {event!r:.80} is no linkwork.Event", code="event")
    return found


def compile_events(events: object, model: Model, changing: Changing = nullcontext) -> list[Watched]:
    """`changing`: a context in which they change something. OptionError: something that is no Event."""
    found = []
    for event in events_of(events):
        calls = event._calls(model)
        found.append(Watched(event.label, event.compiled(model, changing, calls), event, calls))
    return found


def calls_of(watched: Iterable[Watched]) -> list[tuple[str, Calls]]:
    """Of the functions of events, each with what it is."""
    return [(f"event {it.label}", it.calls) for it in watched]
