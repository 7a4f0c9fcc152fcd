"""A model compiled with a method: the right-hand side of its equations of motion."""

from __future__ import annotations

import copy
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork import _core
from linkwork.arguments import array, number
from linkwork.arrays import Floats, by_value
from linkwork.errors import NotFiniteError, OptionError
from linkwork.modeling.model import Model, check_model
from linkwork.options import LEVELS, TABLE, Options, compile_options

__all__ = ["Evaluation", "System"]


@by_value
@dataclass(frozen=True)
class Evaluation:
    """M v_dot - D^T lambda = g, D v_dot = gamma, Phi_dot = D v + Phi_t at one state; n bodies, m rows."""

    M: Floats  #: (n, 6, 6) diag(m I, J), J in body axes
    D: tuple[
        Floats, NDArray[np.int64], NDArray[np.int64]
    ]  #: (m, 6n) as (data, indices, indptr) of compressed rows
    inerters: tuple[
        Floats, NDArray[np.int64], NDArray[np.int64]
    ]  #: likewise rows d (k, 6n): with inerters the mass matrix is M + sum b d^T d
    inertance: Floats  #: (k,) b [kg] or [kg m2]
    Phi: Floats  #: (m,) [m] or [1]
    Phi_t: Floats  #: (m,)
    Phi_dot: Floats  #: (m,)
    gamma: Floats  #: (m,)
    g: Floats  #: (6n,) forces (inertial) and torques (body axes), gyroscopic ones included
    potential: float  #: of gravity and springs [J]
    force_power: float  #: of the forces without a potential [W]
    history: Floats  #: (h,) what the history variables become where this state is accepted


class System:
    """A model with a formulation, a stabilization and a linear solver. Options as in `simulate`.

    y = (q, v): q (7n,) position and Euler parameters of each body, v (6n,) velocity (inertial) and angular
    velocity (body axes) of each body. `derivative` fits `scipy.integrate.solve_ivp`:

        system = lw.System(model)
        solve_ivp(system.derivative, (0, 1), system.initial_state(), rtol=1e-9)

    Full turns of rotational springs, stops and couplers, and speeds at which contacts began, are history
    variables: numbers beside q and v that belong to the state of a motion. They are held while a step is
    tried and go on when its end is accepted, so that everything here is a function of its arguments. Without
    `history` they are those of the initial state; an integrator that takes many steps hands them on:

        history = system.initial_history
        for ...:
            y = step(lambda t, y: system.derivative(t, y, history), t, y, h)
            history = system.advance_history(t + h, y, history)

    A step may turn an angle by less than half a turn.

    A System works for one caller at a time: a second thread, or a function of yours that calls the System
    which is just calling it, gets a BusyError at once. Different Systems, also of one model, are free of each
    other.

    ModelError, OptionError; SingularSystemError where a massless motion is held by nothing.
    """

    def __init__(self, model: Model, **options: Unpack[Options]) -> None:
        check_model(model)
        self.model = model
        self._given = compile_options(options)
        self._options: Mapping[str, Any] = copy.deepcopy(options)
        self._dynamics = _core.Dynamics(model.compiled(), self._given)

    def of(self, model: Model) -> System:
        """
        Another model with the same options; of one with the same joints and pose the rank is known.

            heavier = lw.System(model).of(model.replaced("rod", mass=2.0))

        ModelError, SingularSystemError as of a System.
        """
        check_model(model)
        made = object.__new__(System)
        made.model, made._given, made._options = model, self._given, self._options
        made._dynamics = _core.Dynamics(model.compiled(), self._given, self._dynamics)
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        """Compiled anew, in another process or of a copy of the model."""
        return partial(System, **self._options), (self.model,)

    def compiled(self) -> _core.Dynamics:
        """
        The same system in the compiled module.

            rows = lw.System(model).compiled()
        """
        return self._dynamics

    @property
    def options(self) -> dict[str, Any]:
        """The options as chosen: no "auto" left, gains that depend on the step None."""
        options = self._dynamics.options
        limits = zip(LEVELS, options.violation_limit, strict=True)
        return {name: getattr(options, name) for name in TABLE} | {
            "violation_limit": {level: x for level, x in limits if math.isfinite(x)} or None
        }

    def initial_state(self) -> Floats:
        """
        y (13n,) at t = 0, as described in the model.

            y = lw.System(model).initial_state()
        """
        state: Floats = self._dynamics.initial_state()
        return state

    @property
    def initial_history(self) -> Floats:
        """History variables (h,) of the initial state: those of couplers, then those of force elements."""
        history: Floats = self._dynamics.initial_history
        return history

    def advance_history(self, t: float, y: ArrayLike, history: ArrayLike | None = None) -> Floats:
        """What the history (h,) becomes where the state y (13n,) at t [s] is accepted as the end of a step.

            system = lw.System(model)
            history = system.advance_history(0.0, system.initial_state())

        OptionError: another number of variables, no finite time or history. NotFiniteError: no finite state.
        """
        n = self.model.body_count
        time, state = _time(t), _numbers(y, "y", 13, n)
        if not math.isfinite(time):
            raise OptionError(f"t = {time:g} is not finite", code="not_finite")
        q, v = state[: 7 * n], state[7 * n :]
        self._check_finite(q, v)
        advanced: Floats = self._dynamics.advanced_history(time, q, v, _given(history))
        if not np.isfinite(advanced).all():
            raise NotFiniteError("history: becomes infinite or undefined in this state", code="not_finite")
        return advanced

    def _check_finite(self, q: Floats, v: Floats) -> None:
        """NotFiniteError: names the first body whose state is not."""
        finite = np.isfinite(q).reshape(-1, 7).all(axis=1) & np.isfinite(v).reshape(-1, 6).all(axis=1)
        if not finite.all():
            body = self.model.compiled().body_name(int(np.argmin(finite)))
            raise NotFiniteError(
                f"body '{body}': its state in q and v is not finite", code="not_finite", bodies=[body]
            )

    def derivative(self, t: float, y: ArrayLike, history: ArrayLike | None = None) -> Floats:
        """y_dot (13n,) at t [s], continuous stabilization included; the Euler parameters need not be unit.

            system = lw.System(model)
            y = system.initial_state()
            for k in range(100):
                y = y + 1e-4 * system.derivative(1e-4 * k, y)  # explicit Euler

        history  (h,) at the last accepted state; None: of the initial state, or, in an integrator of your own
                 that `simulate` runs, at the beginning of the step

        SingularSystemError, NotConvergedError, NotFiniteError: where there is no acceleration.
        """
        rates: Floats = self._dynamics.derivative(
            _time(t), _numbers(y, "y", 13, self.model.body_count), _given(history)
        )
        return rates

    def accelerations(
        self, t: float, q: ArrayLike, v: ArrayLike, history: ArrayLike | None = None
    ) -> tuple[Floats, Floats]:
        """(v_dot (6n,), multipliers (m,)) of the mechanism itself, without stabilization.

            system = lw.System(model, formulation="augmented_lagrangian")
            v_dot, multipliers = system.accelerations(0.0, result.q[-1], result.v[-1])

        In a singular pose, where equations depend on each other for a moment, the accelerations are those of
        independent ones, and the multipliers one choice of many: not that of least norm, as of equations that
        are redundant everywhere.

        t [s], q (n, 7) or (7n,), v (n, 6) or (6n,). OptionError: another shape, no numbers, no finite time.
        """
        v_dot, multipliers = self._dynamics.accelerations(*self._moment(t, q, v), _given(history))
        return v_dot, multipliers

    def evaluate(self, t: float, q: ArrayLike, v: ArrayLike, history: ArrayLike | None = None) -> Evaluation:
        """
        The terms of the equations of motion at one state, which is given as in `accelerations`.

            found = lw.System(model).evaluate(0.0, result.q[-1], result.v[-1])
        """
        found = self._dynamics.evaluate(*self._moment(t, q, v), _given(history))
        D, inerters = ((it["data"], it["indices"], it["indptr"]) for it in map(found.pop, ("D", "inerters")))
        return Evaluation(D=D, inerters=inerters, **found)

    def _moment(self, t: float, q: ArrayLike, v: ArrayLike) -> tuple[float, Floats, Floats]:
        n = self.model.body_count
        return _time(t), _numbers(q, "q", 7, n), _numbers(v, "v", 6, n)

    def __repr__(self) -> str:
        chosen = self._dynamics.options
        return f"<System {chosen.formulation}, {chosen.linear_solver}: {self.model.describe()}>"


def _time(t: Any) -> float:
    """OptionError: no number. Whether it is finite, the compiled module says."""
    return t if type(t) is float else number(t, "t [s]")


def _numbers(given: ArrayLike, what: str, each: int, bodies: int) -> Floats:
    """(each * bodies,). OptionError: no numbers, or not so many."""
    numbers = array(given, what)
    if numbers.shape in ((each * bodies,), (bodies, each)):
        return numbers.ravel()
    raise OptionError(
        f"{what} has shape {numbers.shape}, not ({each * bodies},) or ({bodies}, {each}), of {bodies} bodies",
        code="shape",
    )


def _given(history: ArrayLike | None) -> Floats | None:
    """OptionError: no finite numbers."""
    if history is None:
        return None
    numbers = np.ravel(array(history, "history"))
    if not np.isfinite(numbers).all():
        raise OptionError(f"history {history!r:.80} is not finite", code="not_finite")
    return numbers
