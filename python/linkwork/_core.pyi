"""
The compiled core of linkwork: models, evaluation, formulations and the drivers of the integrators.
"""

from __future__ import annotations

import collections.abc
import typing

import numpy
import numpy.typing

__all__ = [
    "AdaptiveSimulation",
    "Assembler",
    "BreakPoints",
    "CoordinateInfo",
    "CoupledCoordinate",
    "DrivenLimits",
    "DrivenMotion",
    "Dynamics",
    "EmbeddedPair",
    "EquationInfo",
    "Event",
    "FormulationInfo",
    "HalfExplicit",
    "KindInfo",
    "LaneRun",
    "Model",
    "Multistep",
    "OnePath",
    "OptionInfo",
    "Options",
    "ParameterInfo",
    "RankReport",
    "Run",
    "SemiImplicitEuler",
    "Simulation",
    "SolverInfo",
    "StabilizationInfo",
    "Tableau",
    "TimeFunction",
    "advance_together",
    "force_kinds",
    "formulations",
    "instruction_set",
    "joint_kinds",
    "lane_count",
    "lane_refusal",
    "linear_solvers",
    "options",
    "run_ensemble",
    "special_joint_kinds",
    "stabilizations",
    "time_lanes",
    "time_sampling",
]

class AdaptiveSimulation(Run):
    """
    A run with steps as large as tolerances allow.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self,
        dynamics: Dynamics,
        pair: EmbeddedPair,
        t_end: typing.SupportsFloat | typing.SupportsIndex,
        rtol: typing.SupportsFloat | typing.SupportsIndex,
        atol: typing.SupportsFloat | typing.SupportsIndex,
        largest_step: typing.SupportsFloat | typing.SupportsIndex,
        record_every: typing.SupportsInt | typing.SupportsIndex,
        times: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        events: collections.abc.Sequence[Event] = [],
        t_start: typing.SupportsFloat | typing.SupportsIndex = 0.0,
        start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"] = ...,
        breaks: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex] = [],
        happened: collections.abc.Sequence[
            tuple[
                typing.SupportsInt | typing.SupportsIndex,
                typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
            ]
        ] = [],
        listed: collections.abc.Sequence[
            tuple[typing.SupportsInt | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex]
        ]
        | None = None,
    ) -> None: ...
    def energies_around_events(self) -> list:
        """
        (work, kinetic energy, potential energy) before each event that came, and after it; NaN: not known.
        """
    def statistics(self) -> dict: ...
    def take_occurrences(self) -> list:
        """
        (index of the event, t, y before, y after) of the events since the last call; y = (q, v).
        """
    def take_strikes(self) -> list:
        """
        (t, potential energy, y before, kinetic energy before, y after, kinetic energy after) of bodies struck by drivers since the last call; y = (q, v, work).
        """
    @property
    def listed_events(self) -> list[tuple[int, float]] | None:
        """
        (index, t) of all; None: not all are known.
        """

class Assembler:
    """
    Takes initial positions and velocities to the constraints at t = 0.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self,
        model: Model,
        weights: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        held: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex],
    ) -> None:
        """
        Weights of the bodies' masses, none for 1; indices of bodies that keep what they have.
        """
    def distance(
        self,
        given: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
    ) -> float:
        """
        Displacement of the mass, squared: integral |x - x_given|^2 w dm [kg m2].
        """
    def positions(
        self,
        given: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        start: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
    ) -> tuple:
        """
        (q, whether it is on the constraints): from `start`, near to `given`.
        """
    def residuals(
        self,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        v: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
    ) -> tuple:
        """
        (Phi, Phi_dot).
        """
    def row_lengths(
        self, q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        What residuals are relative to: Phi [m or 1] / row length is part of the size of the mechanism.
        """
    def velocities(
        self,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        given: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
    ) -> tuple:
        """
        (v, whether it is consistent at q).
        """
    @property
    def iterations(self) -> int: ...

class BreakPoints:
    """
    Times (b,) [s] at which something is not smooth; those that roundoff parts are one.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self, times: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex]
    ) -> None: ...
    def after(self, t: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        Where functions are evaluated for what begins at t [s].
        """
    def before(self, t: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        Where functions are evaluated for what ends at t [s].
        """
    def clock(
        self,
        t: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        t_end: typing.SupportsFloat | typing.SupportsIndex,
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Where functions are evaluated (k,) [s] for frames at t (k,): after a break, but before it where the run ends at it.
        """
    def meet_steps(
        self,
        origin: typing.SupportsFloat | typing.SupportsIndex,
        step: typing.SupportsFloat | typing.SupportsIndex,
        ends: typing.Annotated[
            collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex], "FixedSize(2)"
        ],
    ) -> None:
        """
        Of steps [s] that are counted from `origin` in a run that begins and ends at `ends`: where one ends at a break up to roundoff, the break is there, too.
        """
    @property
    def times(self) -> list[float]:
        """
        Ascending [s].
        """

class CoordinateInfo:
    """
    A free coordinate of a kind of joint.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    @property
    def name(self) -> str: ...
    @property
    def unit(self) -> str: ...

class CoupledCoordinate:
    """
    A free coordinate of a joint, as it enters a coupler.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self,
        joint: typing.SupportsInt | typing.SupportsIndex,
        name: str,
        factor: typing.SupportsFloat | typing.SupportsIndex,
    ) -> None: ...

class DrivenLimits:
    """
    When a step of a driven motion is trusted; parts of the mechanism.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(self) -> None: ...
    @property
    def closed(self) -> float: ...
    @property
    def converged(self) -> float: ...
    @property
    def iterations(self) -> int: ...
    @property
    def largest_correction(self) -> float: ...
    @property
    def longest_step(self) -> float: ...
    @property
    def rounding(self) -> float: ...
    @property
    def touch_part(self) -> float: ...

class DrivenMotion:
    """
    The motion that drivers prescribe, away from singular poses.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self,
        dynamics: Dynamics,
        length: typing.SupportsFloat | typing.SupportsIndex,
        row_lengths: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        rounding: typing.SupportsFloat | typing.SupportsIndex,
        unit: typing.SupportsFloat | typing.SupportsIndex,
        recorded: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
    ) -> None: ...
    def begin(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        v: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        v_dot: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        history: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
    ) -> bool:
        """
        From a state on the constraints; False: it is singular, or nearly so.
        """
    def follow(
        self,
        times: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        seconds: typing.SupportsFloat | typing.SupportsIndex,
    ) -> tuple:
        """
        (count, frames, paused, costs): as many frames as there are before something unusual, and until `seconds` are over; `paused` if they were on the way to the next one.
        """
    def pass_by(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        v: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
    ) -> None:
        """
        Somebody else has taken a step to this state.
        """
    def record(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        v: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
    ) -> None:
        """
        And has made a frame of it.
        """
    def start(
        self,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        history: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
    ) -> bool:
        """
        From the pose at t = 0 to which q leads; False: none is found, or it is singular, or nearly so.
        """
    @property
    def state(self) -> tuple:
        """
        (t, q, v, v_dot, history) where it has come.
        """
    @property
    def turned(self) -> list:
        """
        [joint, coordinate, before, t, angle] of how far joints turned from one of the times `recorded` to another [s], where frames there do not tell it; None: steps were too long to tell.
        """

class Dynamics:
    """
    A model with a formulation, a stabilization and a linear solver.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(self, model: Model, options: Options, like: Dynamics = None) -> None:
        """
        `like`: another one, whose rank is taken where it has the same joints and pose.
        """
    def accelerations(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        v: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        history: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"] | None = None,
    ) -> tuple:
        """
        (v_dot, multipliers) of the mechanism itself, without stabilization.
        """
    def advanced_history(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        v: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        history: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"] | None = None,
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        What the history becomes where this state is accepted.
        """
    def analysis_time(self) -> float:
        """
        Time of one symbolic analysis, by a solver like the one in use [s].
        """
    def beginning_history(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        v: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Of a motion that begins in this state.
        """
    def begins_contact(
        self,
        history_before: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        history_after: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
    ) -> bool:
        """
        Whether one is under way after a step that was not before it.
        """
    def constraint_rates(
        self,
        t: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        v: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        rows: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex],
    ) -> numpy.typing.NDArray[numpy.float64]:
        """
        Phi_t (k, rows) of some equations at k times and states.
        """
    def dependent_groups(
        self, most: typing.SupportsInt | typing.SupportsIndex
    ) -> list[tuple[int, list[int], str]]:
        """
        (row, rows that imply it, both in words) of the first redundant rows.
        """
    def derivative(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        y: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        history: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"] | None = None,
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        y_dot for y = (q, v).
        """
    def evaluate(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        v: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        history: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"] | None = None,
    ) -> dict:
        """
        M (n, 6, 6), D (compressed rows), inerters (rows), inertance, Phi, Phi_t, Phi_dot, gamma, g, potential, force_power, history.
        """
    def factorization_cost(self) -> dict:
        """
        matrix_nonzeros (lower triangle), factor_nonzeros, flops, bytes of the last factorization; None: unknown.
        """
    def force_element(
        self,
        element: typing.SupportsInt | typing.SupportsIndex,
        t: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        v: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        v_dot: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        history: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    ) -> tuple:
        """
        (force, torque (k, 3) on the second body, power that goes into the motion, potential, what its history variable becomes (k,)) of a force element at k times and states, each with its history variables.
        """
    def initial_state(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        y = (q, v), 13 per body.
        """
    def joint_frames(
        self, q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]
    ) -> numpy.typing.NDArray[numpy.float64]:
        """
        Inertial axes of the joint frames, fixed in the first body.
        """
    def kinetic_energies(
        self,
        q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        v: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (k,) [J] at k states.
        """
    def least_time_ahead(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        y: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        seconds: typing.SupportsFloat | typing.SupportsIndex,
    ) -> float:
        """
        Least time of a right-hand side at y = (q, v) [s], of those in so many seconds, two at least; a run that sets out from there goes on as it would have without.
        """
    def nearly_dependent_joints(self) -> list[str]:
        """
        Of the equations of which some depend on the others but for digits.
        """
    def rank(self) -> RankReport: ...
    def reactions(
        self,
        t: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        multipliers: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        history: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] | None = None,
    ) -> tuple:
        """
        Force and torque (joints, 3) that each joint exerts on its second body at the joint's point, inertial axes; (k, joints, 3) for k times, states and multipliers.
        """
    def redundancy_watch_time(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        y: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        repeats: typing.SupportsInt | typing.SupportsIndex,
    ) -> float:
        """
        Time of so many looks at the redundant rows at y = (q, v), one of which a run takes a step [s].
        """
    def repeat_right_hand_side(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        y: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        repeats: typing.SupportsInt | typing.SupportsIndex,
    ) -> None:
        """
        So many right-hand sides at y = (q, v), reactions included, for others to time.
        """
    def residuals(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        v: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
    ) -> tuple:
        """
        (Phi, Phi_dot, row lengths, row rates [1/s], roundoff), all of each row: Phi / length and Phi_dot / length / rate are parts of the size and speed of the connected part, known to the roundoff of its positions.
        """
    def right_hand_side_times(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        y: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        repeats: typing.SupportsInt | typing.SupportsIndex,
    ) -> dict:
        """
        Times of so many right-hand sides at y = (q, v), together [s]: evaluate, assemble, factorize, solve, reactions, and the whole, which may be less than their sum.
        """
    def scales(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        v: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
    ) -> tuple:
        """
        Of each body a length [m] and a rate [1/s], those of its connected part, and which part that is.
        """
    def statistics(self) -> dict: ...
    @property
    def body_count(self) -> int: ...
    @property
    def history(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Those of the last accepted state, which evaluations take where none are given.
        """
    @history.setter
    def history(self, arg1: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]) -> None: ...
    @property
    def history_owners(self) -> numpy.typing.NDArray[numpy.int32]:
        """
        Of each history variable (h, 2): 1 of a joint and its index, or 0 and that of a force element or, counted on from these, a law of a joint's force.
        """
    @property
    def initial_history(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        History variables of the initial state: full turns, speeds at which contacts began.
        """
    @property
    def joint_count(self) -> int: ...
    @property
    def linear_solver(self) -> str: ...
    @property
    def matrix_form(self) -> str: ...
    @property
    def options(self) -> Options: ...
    @property
    def part_sizes(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Of each body the size of its connected part, by which verdicts weigh errors [m].
        """
    @property
    def passed(self) -> tuple[int, int]:
        """
        How many singular poses were passed, and how often other rows became the redundant ones.
        """
    @property
    def residual_at_start(self) -> float:
        """
        The largest part of the size or of the speed of a connected part that a residual of the initial state is, above roundoff.
        """
    @property
    def row_count(self) -> int: ...

class EmbeddedPair:
    """
    An explicit Runge-Kutta method with error estimate and interpolant.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self,
        method: Tableau,
        error_order: typing.SupportsInt | typing.SupportsIndex,
        error: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        second_error: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        extra_A: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"],
        extra_c: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        interpolant: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"],
    ) -> None: ...

class EquationInfo:
    """
    A constraint equation of a kind of joint.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    @property
    def axis(self) -> int | None:
        """
        Of a translation or rotation that is held at zero: the axis of the joint along or about which, 0 to 2.
        """
    @property
    def name(self) -> str: ...
    @property
    def perpendicular(self) -> list[tuple[int, int]]:
        """
        Of such a rotation: axes of a and of b that are perpendicular; of two pairs the products are equal.
        """
    @property
    def quantity(self) -> str:
        """
        "translation", "rotation", "distance", "velocity" (non-holonomic) or "relation".
        """

class Event:
    """
    What happens when a function of (t, y) passes through zero; y = (q, v).
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self,
        name: str,
        function: collections.abc.Callable[
            [float, typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]],
            typing.SupportsFloat | typing.SupportsIndex,
        ],
        direction: typing.SupportsInt | typing.SupportsIndex,
        terminal: bool,
        change: collections.abc.Callable[
            [float, typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]],
            tuple[typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], bool],
        ]
        | None,
        tolerance: typing.SupportsFloat | typing.SupportsIndex | None,
    ) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def signature(self) -> tuple[int, bool, bool, float | None]:
        """
        What beside its functions decides on the steps: direction, terminal, whether it has a change, tolerance.
        """

class FormulationInfo:
    """
    A registered formulation.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    @property
    def compliant(self) -> bool: ...
    @property
    def documentation(self) -> str: ...
    @property
    def matrix_forms(self) -> list[str]: ...
    @property
    def name(self) -> str: ...
    @property
    def needs_full_rank(self) -> bool: ...
    @property
    def options(self) -> list[str]: ...

class HalfExplicit:
    """
    A half-explicit Runge-Kutta method.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self,
        name: str,
        order: typing.SupportsInt | typing.SupportsIndex,
        A: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"],
        A_bar: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"],
        explicit_first_stage: bool,
    ) -> None: ...

class KindInfo:
    """
    A registered kind of joint or force.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    @property
    def coordinates(self) -> dict[str, CoordinateInfo]:
        """
        Those that are free, by name.
        """
    @property
    def documentation(self) -> str: ...
    @property
    def driver(self) -> bool:
        """
        It prescribes a motion, its parameter.
        """
    @property
    def equations(self) -> dict[str, EquationInfo]:
        """
        By name, in the order of the rows.
        """
    @property
    def name(self) -> str: ...
    @property
    def parameters(self) -> dict[str, ParameterInfo]:
        """
        By name, in their order.
        """
    @property
    def placement(self) -> str: ...
    @property
    def rows(self) -> int: ...
    @property
    def symmetric(self) -> bool:
        """
        The same joint where a and b change places.
        """
    @property
    def velocity_rows(self) -> int:
        """
        How many of the last rows are of velocities.
        """

class LaneRun:
    """
    What the verdict of a member of an ensemble is made of, as that of a Run.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self,
        dynamics: Dynamics,
        t_end: typing.SupportsFloat | typing.SupportsIndex,
        step: typing.SupportsFloat | typing.SupportsIndex,
        balance_every: typing.SupportsInt | typing.SupportsIndex = 0,
        follow_errors: bool = True,
    ) -> None:
        """
        balance_every: steps between the energies that are kept; 0: none. follow_errors: whether the verdict knows how they grow.
        """
    def expect_breaks(
        self, times: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex]
    ) -> None: ...
    def judge(self, dynamics: Dynamics, method: typing.Any, other: bool = False, steps: bool = True) -> dict:
        """
        As of Run; without `steps` only how many were `taken` again.
        """
    def relative_violation(self) -> float: ...
    def take_balance(self) -> dict:
        """
        Energies by name as in frames, which are handed over.
        """
    @property
    def energies(self) -> tuple: ...
    @property
    def has_steps(self) -> bool: ...
    @property
    def passed_touches(self) -> list: ...
    @property
    def steps_done(self) -> int: ...
    @property
    def t(self) -> float: ...

class Model:
    """
    The constant description of a mechanism; see linkwork.Model.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self, gravity: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"] = ...
    ) -> None: ...
    def add_bodies(
        self,
        names: str | collections.abc.Sequence[str],
        mass: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        inertia: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        position: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        orientation: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        velocity: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        omega: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        inertia_as_is: collections.abc.Sequence[bool] = [],
    ) -> int:
        """
        Adds bodies under a prefix (str) or names (list); returns the first index. `inertia_as_is`: for each body whether its inertia may violate the triangle inequality; without, none may.
        """
    def add_breaks(
        self, times: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex]
    ) -> None:
        """
        Times at which users' forces are not smooth.
        """
    def add_compiled_force(
        self,
        name: str,
        address: typing.SupportsInt | typing.SupportsIndex,
        data: typing.SupportsInt | typing.SupportsIndex,
    ) -> None:
        """
        The address of a C function; see linkwork.Model.
        """
    def add_coupler(
        self,
        name: str,
        coordinates: collections.abc.Sequence[CoupledCoordinate],
        offset: typing.SupportsFloat | typing.SupportsIndex,
        signal: typing.SupportsInt | typing.SupportsIndex,
    ) -> int:
        """
        Adds a linear relation of coordinates (joint, name, factor); returns its index.
        """
    def add_forces(
        self,
        kind: str,
        names: str | collections.abc.Sequence[str],
        bodies: typing.Annotated[numpy.typing.ArrayLike, numpy.int32],
        origin: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        frame: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        parameters: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        signals: typing.Annotated[numpy.typing.ArrayLike, numpy.int32],
    ) -> int:
        """
        Adds force elements; returns the first index.
        """
    def add_joint_force(
        self, name: str, joint: typing.SupportsInt | typing.SupportsIndex, coordinate: str, law: typing.Any
    ) -> None:
        """
        A function of (t, x, x_dot), or of time alone, along a free coordinate of a joint.
        """
    def add_joints(
        self,
        kind: str,
        names: str | collections.abc.Sequence[str],
        bodies: typing.Annotated[numpy.typing.ArrayLike, numpy.int32],
        origin: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        frame: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        parameters: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        signals: typing.Annotated[numpy.typing.ArrayLike, numpy.int32],
    ) -> int:
        """
        Adds joints; returns the first index.
        """
    def add_point_on_curve(
        self,
        name: str,
        bodies: typing.Annotated[numpy.typing.ArrayLike, numpy.int32],
        origin: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        frame: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        knots: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        curve: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        direction: typing.Annotated[numpy.typing.ArrayLike, numpy.float64],
        closed: bool,
    ) -> int:
        """
        Adds a point of b on a spline of a, ascending coefficients (k, 4, 3); returns its index.
        """
    def add_signal(self, function: TimeFunction) -> int: ...
    def add_user_force(
        self, name: str, function: collections.abc.Callable, origin: typing.Any = None
    ) -> None:
        """
        A function of (t, q (n, 7), v (n, 6)) that returns forces (n, 6). `origin`: the user's function and its bodies; `function` is then one of (t (k,), q (k, n, 7), v (k, n, 6)) that returns (k, n, 6).
        """
    def body_name(self, body: typing.SupportsInt | typing.SupportsIndex) -> str: ...
    def describe_row(self, row: typing.SupportsInt | typing.SupportsIndex) -> str: ...
    def find_body(self, name: str) -> int:
        """
        Index of a name, -1 where there is none.
        """
    def find_force(self, name: str) -> int:
        """
        Index of a name, -1 where there is none.
        """
    def find_joint(self, name: str) -> int:
        """
        Index of a name, -1 where there is none.
        """
    def find_user_force(self, name: str) -> int:
        """
        Index of the name of one of the user's own forces, -1 where there is none.
        """
    def force_arrays(self) -> dict:
        """
        kind, bodies, origin, frame, first_parameter, parameters, signals: what add_forces took.
        """
    def force_name(self, force: typing.SupportsInt | typing.SupportsIndex) -> str: ...
    def joint_arrays(self) -> dict:
        """
        kind, bodies, origin, frame, first_parameter, parameters, signals: what add_joints took.
        """
    def joint_bodies(self, joint: typing.SupportsInt | typing.SupportsIndex) -> list[int]:
        """
        Indices of the bodies of a joint, two or, of a coupler, any number; -1 is the ground.
        """
    def joint_kind(self, joint: typing.SupportsInt | typing.SupportsIndex) -> str: ...
    def joint_name(self, joint: typing.SupportsInt | typing.SupportsIndex) -> str: ...
    def limited(self) -> list[tuple[str, int, float, int, float, str]]:
        """
        Functions of time that must not pass a bound: (what, its signal or -1, its number, signal and number of the bound, what that is).
        """
    def poses(
        self, bodies: typing.Annotated[numpy.typing.ArrayLike, numpy.int32]
    ) -> numpy.typing.NDArray[numpy.float64]:
        """
        (k, 7) at t = 0, of bodies by index; -1 is the ground.
        """
    def with_initial_state(
        self,
        q: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        v: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"],
        history: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex] = [],
    ) -> Model:
        """
        A copy whose bodies are elsewhere at t = 0; joints stay where they are on the bodies.
        """
    def with_weights(
        self,
        gravity: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
        bodies: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex],
        masses: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        inertias: collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 3]"]],
    ) -> Model:
        """
        A copy with another gravity, and other masses and inertias (3, 3) of some bodies.
        """
    @property
    def body_count(self) -> int: ...
    @property
    def breaks(self) -> list[float]: ...
    @property
    def force_count(self) -> int: ...
    @property
    def gravity(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]: ...
    @property
    def inertia(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def inertia_as_is(self) -> list[int]:
        """
        Indices of the bodies whose inertia may be that of no real body.
        """
    @property
    def initial_history(self) -> list[float]:
        """
        See with_initial_state.
        """
    @property
    def joint_count(self) -> int: ...
    @property
    def joint_force_bodies(self) -> list[tuple[int, int]]:
        """
        The two bodies of each law along a coordinate, -1 for the ground.
        """
    @property
    def joint_forces(self) -> list[tuple[str, str]]:
        """
        (name, coordinate) of the laws along coordinates.
        """
    @property
    def joint_rows(self) -> numpy.typing.NDArray[numpy.int32]: ...
    @property
    def longest_arm(self) -> float:
        """
        From a center of mass to a joint [m]; 0: none.
        """
    @property
    def mass(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def q0(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]: ...
    @property
    def row_count(self) -> int: ...
    @property
    def v0(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]: ...

class Multistep:
    """
    An Adams method; coefficients of the newest value first.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self,
        name: str,
        order: typing.SupportsInt | typing.SupportsIndex,
        predictor: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        corrector: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        starter: Tableau,
    ) -> None: ...

class OnePath:
    """
    While it is entered, this thread computes by the instructions that every processor has.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __enter__(self) -> None: ...
    def __exit__(self, *args) -> None: ...
    def __init__(self, wanted: bool) -> None: ...

class OptionInfo:
    """
    What an option of a run can be.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    @property
    def choices(self) -> list[str]:
        """
        Of a name.
        """
    @property
    def documentation(self) -> str: ...
    @property
    def methods(self) -> list[str]:
        """
        Formulations or stabilizations that have it; empty: it is of all.
        """
    @property
    def name(self) -> str: ...
    @property
    def positive(self) -> bool:
        """
        A number: not zero.
        """
    @property
    def type(self) -> str:
        """
        "name", "number", "whole" or "limits".
        """
    @property
    def unit(self) -> str: ...
    @property
    def usual(self) -> float | None:
        """
        A number of some methods only: where it is not given, or None.
        """

class Options:
    """
    The choices of a run.
    """

    deterministic: bool
    formulation: str
    linear_solver: str
    matrix_form: str
    on_singular: str
    on_violation: str
    stabilization: str
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(self) -> None: ...
    def resolved(self) -> Options:
        """
        As a run has them; OptionError: what cannot be honored.
        """
    @property
    def baumgarte_alpha(self) -> float | None: ...
    @baumgarte_alpha.setter
    def baumgarte_alpha(self, arg0: typing.SupportsFloat | typing.SupportsIndex | None) -> None: ...
    @property
    def baumgarte_beta(self) -> float | None: ...
    @baumgarte_beta.setter
    def baumgarte_beta(self, arg0: typing.SupportsFloat | typing.SupportsIndex | None) -> None: ...
    @property
    def damping_ratio(self) -> float | None: ...
    @damping_ratio.setter
    def damping_ratio(self, arg0: typing.SupportsFloat | typing.SupportsIndex | None) -> None: ...
    @property
    def frequency(self) -> float | None: ...
    @frequency.setter
    def frequency(self, arg0: typing.SupportsFloat | typing.SupportsIndex | None) -> None: ...
    @property
    def max_iterations(self) -> int | None: ...
    @max_iterations.setter
    def max_iterations(self, arg0: typing.SupportsInt | typing.SupportsIndex | None) -> None: ...
    @property
    def penalty(self) -> float | None: ...
    @penalty.setter
    def penalty(self, arg0: typing.SupportsFloat | typing.SupportsIndex | None) -> None: ...
    @property
    def penalty_scale(self) -> float | None: ...
    @penalty_scale.setter
    def penalty_scale(self, arg0: typing.SupportsFloat | typing.SupportsIndex | None) -> None: ...
    @property
    def threads(self) -> int | None: ...
    @threads.setter
    def threads(self, arg0: typing.SupportsInt | typing.SupportsIndex | None) -> None: ...
    @property
    def tolerance(self) -> float | None: ...
    @tolerance.setter
    def tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex | None) -> None: ...
    @property
    def violation_limit(self) -> typing.Annotated[list[float], "FixedSize(3)"]: ...
    @violation_limit.setter
    def violation_limit(
        self,
        arg0: typing.Annotated[
            collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex], "FixedSize(3)"
        ],
    ) -> None: ...

class ParameterInfo:
    """
    A parameter of a kind of joint or force.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    @property
    def above(self) -> bool:
        """
        Numbers are above the bound.
        """
    @property
    def constant(self) -> bool:
        """
        A number, no function.
        """
    @property
    def example(self) -> float:
        """
        Of the usual size.
        """
    @property
    def initial_distance(self) -> bool:
        """
        Where it is not given: that of the two points at the initial pose.
        """
    @property
    def least(self) -> float | None:
        """
        The least number, if there is one.
        """
    @property
    def meaning(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def not_above(self) -> str:
        """
        Another parameter, or "".
        """
    @property
    def takes(self) -> str:
        """
        "function" (of time), "differentiable", "number", "whole_number" or "characteristic".
        """
    @property
    def unit(self) -> str:
        """
        Such as "N s/m" or "N/m^exponent"; "" for a mere number.
        """
    @property
    def usual(self) -> float | None:
        """
        Where it is not given; None: it must be.
        """

class RankReport:
    """
    Rank of the constraint matrix D: what is redundant in every pose, and what only in the assembled one.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    @property
    def beside_drivers(self) -> bool:
        """
        These are those of the mechanism without its drivers.
        """
    @property
    def degrees_of_freedom(self) -> int: ...
    @property
    def least_part(self) -> float:
        """
        What is independent in the least of them; 1: none.
        """
    @property
    def nearly_dependent(self) -> int:
        """
        How many rows that are kept depend on the others but for digits of the geometry, in every pose.
        """
    @property
    def rank(self) -> int:
        """
        Away from singular poses.
        """
    @property
    def redundant_rows(self) -> list[int]:
        """
        Implied by the others in every pose.
        """
    @property
    def rows(self) -> int: ...
    @property
    def singular_rows(self) -> list[int]:
        """
        Of the others, those that depend on the rest in the assembled pose.
        """
    @property
    def unique(self) -> list[bool]:
        """
        Per joint: its multipliers follow from the motion.
        """

class Run:
    """
    A simulation on its way, advanced in pieces.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def advance(
        self,
        max_frames: typing.SupportsInt | typing.SupportsIndex,
        max_seconds: typing.SupportsFloat | typing.SupportsIndex,
    ) -> None:
        """
        Runs on until so many frames are there, or so much time has passed.
        """
    def expect_breaks(
        self, times: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex]
    ) -> None:
        """
        Times [s], ascending, at which something is not smooth and no step ends: of the steps that contain one some are taken again, too.
        """
    def judge(
        self,
        dynamics: Dynamics,
        method: typing.Any,
        other: bool = False,
        progress: collections.abc.Callable[[float], None] | None = None,
        recorded: typing.Any = None,
    ) -> dict:
        """
        Takes the kept steps of the run again by `dynamics`, which is used up, and says what they were off by, relative to the motion: steps (t, h, state, reactions or None), and what AccumulatedError has of the run. `method`: that of the run, or one that is much more accurate, and `other`. `progress` is called with the share that is done, as each step is begun. `recorded`, used up, too: by the equations of the run, where `dynamics` has exact ones.
        """
    def record_reactions(self) -> None:
        """
        Frames have reaction_force and reaction_torque (k, joints, 3), too: as Dynamics.reactions finds them, for less. Before the first frame.
        """
    def relative_violation(self) -> float:
        """
        Largest violation of a position constraint now, relative to the size of the mechanism.
        """
    def resume(self, state: bytes, work: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Before the first step: goes on from a checkpoint at or before the start, of a run of the same mechanism by the same method, as that one would have gone on; `work` [J] at the start.
        """
    def statistics(self) -> dict: ...
    def take_frames(self, at_the_end: bool = False) -> dict:
        """
        The frames recorded since the last call: t, q, v, vdot, lambda, kinetic, potential, work, violation, history. At the end also one that waits for a step which will not come. In a call of its own, as an interrupt may take away what `advance` would return.
        """
    @property
    def checkpoint(self) -> typing.Any:
        """
        (t, state), not after the last frame that was taken; None: there is none.
        """
    @property
    def energies(self) -> tuple:
        """
        Largest kinetic energy, least and largest potential, largest amount of work over the steps so far [J].
        """
    @property
    def finished(self) -> bool: ...
    @property
    def has_steps(self) -> bool:
        """
        Its own, or the one that it goes on inside of.
        """
    @property
    def history(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Of last_state; see Dynamics.history.
        """
    @property
    def last_checkpoint(self) -> typing.Any:
        """
        The same, not after last_state.
        """
    @property
    def last_state(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        y = (q, v) at t, from which the run went on.
        """
    @property
    def steps_done(self) -> int: ...
    @property
    def steps_total(self) -> int:
        """
        0 where nobody knows.
        """
    @property
    def t(self) -> float: ...
    @property
    def turned(self) -> list:
        """
        [joint, coordinate, before, t, angle] of how far joints turned from one frame to another [s], where these do not tell it; None: steps were too long to tell.
        """
    @property
    def work(self) -> float:
        """
        Of last_state [J].
        """

class SemiImplicitEuler:
    """
    v' = v + h v_dot, q' = q + h N(q) v'; its steps are judged by the method `other`.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(self, other: Tableau) -> None: ...

class Simulation(Run):
    """
    A run with a fixed step.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self,
        dynamics: Dynamics,
        integrator: typing.Any,
        t_end: typing.SupportsFloat | typing.SupportsIndex,
        step: typing.SupportsFloat | typing.SupportsIndex,
        record_every: typing.SupportsInt | typing.SupportsIndex = 1,
        t_start: typing.SupportsFloat | typing.SupportsIndex = 0.0,
        start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"] = ...,
        breaks: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex] = [],
    ) -> None: ...
    def accept(self, y: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]) -> None: ...
    def begin_step(
        self,
    ) -> tuple[float, typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], float]:
        """
        (t, y, h) of the step that begins; h = 0 at the end.
        """
    def statistics(self) -> dict: ...
    @property
    def origin(self) -> float:
        """
        From which steps are counted [s].
        """

class SolverInfo:
    """
    A registered linear solver.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    @property
    def available(self) -> bool: ...
    @property
    def documentation(self) -> str: ...
    @property
    def matrix_forms(self) -> list[str]: ...
    @property
    def name(self) -> str: ...

class StabilizationInfo:
    """
    A registered stabilization.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    @property
    def documentation(self) -> str: ...
    @property
    def name(self) -> str: ...

class Tableau:
    """
    An explicit Runge-Kutta method.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    def __init__(
        self,
        name: str,
        order: typing.SupportsInt | typing.SupportsIndex,
        A: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"],
        b: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        c: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
    ) -> None: ...

class TimeFunction:
    """
    A quantity as a function of time [s], with two derivatives.
    """
    @staticmethod
    def _pybind11_conduit_v1_(*args, **kwargs): ...
    @staticmethod
    def callback(
        value: typing.Any,
        rate: typing.Any = None,
        acceleration: typing.Any = None,
        what: str = "function of time",
    ) -> TimeFunction:
        """
        Python functions of t; `what` they are, in messages.
        """
    @staticmethod
    def characteristic(function: TimeFunction, of: str) -> TimeFunction:
        """
        The same function of a coordinate or velocity of a force element; `of`: which, for messages.
        """
    @staticmethod
    def constant(value: typing.SupportsFloat | typing.SupportsIndex) -> TimeFunction: ...
    @staticmethod
    def cycloidal(
        rise: typing.SupportsFloat | typing.SupportsIndex,
        start: typing.SupportsFloat | typing.SupportsIndex,
        duration: typing.SupportsFloat | typing.SupportsIndex,
    ) -> TimeFunction:
        """
        rise (s - sin(2 pi s) / 2 pi), s = (t - start) / duration between 0 and 1; constant beyond.
        """
    @staticmethod
    def harmonic(
        amplitude: typing.SupportsFloat | typing.SupportsIndex,
        frequency: typing.SupportsFloat | typing.SupportsIndex,
        phase: typing.SupportsFloat | typing.SupportsIndex = 0.0,
        offset: typing.SupportsFloat | typing.SupportsIndex = 0.0,
    ) -> TimeFunction:
        """
        offset + amplitude sin(frequency t + phase); frequency in rad/s.
        """
    @staticmethod
    def piecewise_polynomial(
        breaks: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        coefficients: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
    ) -> TimeFunction:
        """
        Rows of ascending coefficients in t - breaks[i], flattened.
        """
    @staticmethod
    def polynomial(
        coefficients: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
    ) -> TimeFunction:
        """
        sum c_k t^k, ascending powers.
        """
    @staticmethod
    def sum(terms: collections.abc.Sequence[TimeFunction]) -> TimeFunction: ...
    @staticmethod
    def with_breaks(
        function: TimeFunction, times: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex]
    ) -> TimeFunction:
        """
        The same function, not smooth at these times, either.
        """
    def evaluate(self, t: typing.SupportsFloat | typing.SupportsIndex) -> tuple[float, float, float]:
        """
        (value, rate, acceleration) at t.
        """
    @property
    def breaks(self) -> list[tuple[float, bool]]:
        """
        Times at which it is not smooth, and whether each ends a step whatever the tables say.
        """
    @property
    def has_derivatives(self) -> bool: ...
    @property
    def of_time(self) -> bool: ...

def advance_together(
    runs: collections.abc.Sequence[AdaptiveSimulation], threads: typing.SupportsInt | typing.SupportsIndex
) -> list[str]:
    """
    Advances runs of equal options by one method to their ends, in the lanes of the processor. Of each why it did not come there, and has to be simulated by itself; empty: it did.
    """

def force_kinds() -> list[KindInfo]: ...
def formulations() -> list[FormulationInfo]: ...
def instruction_set() -> str:
    """
    The instruction set that the hot loops use on this processor, such as x86-64-v3.
    """

def joint_kinds() -> list[KindInfo]: ...
def lane_count() -> int:
    """
    Mechanisms that fill a pack here.
    """

def lane_refusal(dynamics: Dynamics) -> str:
    """
    Why lanes cannot run this, in words that end a sentence; empty where they can.
    """

def linear_solvers() -> list[SolverInfo]: ...
def options() -> list[OptionInfo]:
    """
    The table of options, formulation/options.def.
    """

def run_ensemble(
    dynamics: collections.abc.Sequence[Dynamics],
    tableau: Tableau,
    t_end: typing.SupportsFloat | typing.SupportsIndex,
    step: typing.SupportsFloat | typing.SupportsIndex,
    record_every: typing.SupportsInt | typing.SupportsIndex,
    threads: typing.SupportsInt | typing.SupportsIndex,
    runs: collections.abc.Sequence[LaneRun] = [],
    breaks: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex] = [],
    counts_turns: bool = False,
) -> list:
    """
    Simulates all `dynamics`, of equal options, from their initial states by an explicit Runge-Kutta method, in the lanes of the processor. Of each {reason, left_at [s], frames}: frames as of Run.advance where the reason is empty, else why it has to be simulated by itself. `runs`: of each what its verdict is made of, or none of them. `breaks`: times [s] at which something is not smooth, beside those that they know. `counts_turns`: how far joints turned between frames, `turned`, where these do not tell it.
    """

def special_joint_kinds() -> list[KindInfo]:
    """
    Of joints that a point and axes on two bodies do not describe; their numbers follow those of joint_kinds.
    """

def stabilizations() -> list[StabilizationInfo]: ...
def time_lanes(
    dynamics: collections.abc.Sequence[Dynamics],
    repetitions: typing.SupportsInt | typing.SupportsIndex,
    threads: typing.SupportsInt | typing.SupportsIndex,
) -> tuple:
    """
    (wall time [s] of one right-hand side with reactions of all of them, in full packs, one a thread; their v_dot (6n,)).
    """

def time_sampling(dynamics: Dynamics, steps: typing.SupportsInt | typing.SupportsIndex) -> float:
    """
    Time that a run of so many steps spends on following them for its verdict [s].
    """
