"""What is looked at before the first step of a run."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from linkwork import _core
from linkwork.arguments import array, number
from linkwork.arrays import Floats
from linkwork.equations import branches, stiffness
from linkwork.equations.assembly import Assembly, assemble
from linkwork.equations.system import System
from linkwork.errors import ModelError, OptionError, warn
from linkwork.functions import Callback
from linkwork.integrators import HalfExplicit, Integrator
from linkwork.integrators.growth import added_growth
from linkwork.modeling.model import Model
from linkwork.motion.records import Snapshot
from linkwork.options import check_setting
from linkwork.running.recording import PythonStep
from linkwork.running.sampled_frames import listed

#: Residuals of the initial state that are more than rounding, relative to the size of what is placed.
RESIDUAL_TOLERANCE = 1e-9

#: Joints whose axes are compared at the start: of more it would take longer than all else.
MOST_COMPARED = 100_000

#: Of a coordinate, relative.
ROUNDOFF = 1e-14

#: Kinds of force elements with history variables, and how they begin at a state without.
BEGINNING = {
    **dict.fromkeys(
        ("rotational_spring_damper", "nonlinear_rotational_spring_damper", "rotational_stop"),
        "full turns are not in the state: its angle begins within half a turn of zero",
    ),
    **dict.fromkeys(
        ("sphere_plane_contact", "sphere_sphere_contact"),
        "the speed at which a contact began is not in the state: one that is under way begins anew",
    ),
}

#: Accelerations that redundant equations ask for otherwise than the rest, relative to what they are made of.
CONTRADICTION = 1e-6

#: Residuals up to here, relative to the size of the mechanism and to its speed, are corrected.
SMALL_RESIDUAL = 1e-3

#: Rate of a residual of velocities, relative to the size of the part [1/s], below which nothing moves but by
#: roundoff: where a motion has come to rest no speed is left to which it could be relative.
AT_REST = 1e-12

#: Times at which functions of time are looked at before a run.
SAMPLES = 257

#: Of the length of Euler parameters at the start, as in a model.
UNIT_TOLERANCE = 1e-6

#: How many objects a message lists.
LISTED = 5

#: Gains times step above which continuous Baumgarte stabilization lowers the order of the integrator.
ACCURATE_GAIN = 0.1

#: What to do where gains are unstable, of the stabilizations that have gains.
INSTEAD = {
    "baumgarte": "use smaller gains, a smaller step, or stabilization 'sampled_baumgarte'",
    "sampled_baumgarte": "leave both out, and a violation is gone after two steps, or use a smaller step",
}

#: A violation may grow so much in a step, by rounding of what tells its growth.
STABLE = 1e-9

#: Imaginary parts, relative to |s|, that are none.
REAL = 1e-6


def check_choices(given: Mapping[str, Any]) -> None:
    """OptionError: a policy that does not exist, or a switch that is neither True nor False."""
    for name in ("on_inaccurate", "assemble", "verify"):
        if name in given:
            check_setting(name, given[name])


def check_tables(model: Model, t_end: float) -> None:
    """OptionError: a function of time is not known from 0 to t_end. ModelError: its derivatives are wrong."""
    for what, signal in model.signals:
        first, last = signal.span
        if first > 0.0 or last < t_end:
            raise OptionError(
                f"{what}: is given from {first:g} to {last:g} s, the run goes from 0 to {t_end:g} s; "
                "extend the table or shorten the run",
                code="time_function_range",
            )
        signal.check(t_end)
    _check_limits(model, t_end)


def _check_limits(model: Model, t_end: float) -> None:
    """OptionError: a function of time passes the bound of its parameter, such as a negative stiffness.

    Looked for at many times of the run; of the user's own functions, which may be dear or have a memory, at
    its start only. The run itself looks in every evaluation.
    """
    limited = model.compiled().limited()
    functions, times = model._functions, np.linspace(0.0, t_end, SAMPLES).tolist() if limited else []
    for what, signal, constant, least_signal, least, than in limited:
        given = {place: functions[place] for place in (signal, least_signal) if place >= 0}
        compiled = {place: it.compiled() for place, it in given.items()}  # once: a formula is read each time
        for t in times[:1] if any(isinstance(it, Callback) for it in given.values()) else times:
            value = compiled[signal].evaluate(t)[0] if signal >= 0 else constant
            bound = compiled[least_signal].evaluate(t)[0] if least_signal >= 0 else least
            if value < bound:
                named = f", which is {than}" if than else ""
                raise OptionError(
                    f"{what} is {value:g} at t = {t:g} s, and must not be below {bound:g}{named}; correct it",
                    code="out_of_bounds",
                )


def rank_numbers(dynamics: _core.Dynamics) -> dict[str, int]:
    """How many constraint equations: in all, independent, redundant, and dependent in the first pose only."""
    rank = dynamics.rank()
    return {
        "equations": rank.rows,
        "rank": rank.rank,
        "degrees_of_freedom": rank.degrees_of_freedom,
        "redundant": len(rank.redundant_rows),
        "singular_at_start": len(rank.singular_rows),
    }


@dataclass(frozen=True)
class Residuals:
    """Of one level, positions or velocities: the largest of each joint (joints,)."""

    level: str  #: "poses" or "velocities"
    value: Floats  #: [m] or [1], of velocities per second
    relative: Floats  #: to the size of the connected part, of velocities to its speed
    rounding: Floats  #: what roundoff can make of a relative one

    @property
    def unit(self) -> str:
        return "/s" if self.level == "velocities" else ""


def residuals(model: Model, dynamics: _core.Dynamics, at: Snapshot | None = None) -> list[Residuals]:
    """Of positions and of velocities; without `at` at t = 0."""
    core = model.compiled()
    t, q, v = (0.0, core.q0, core.v0) if at is None else (at.t, np.ravel(at.q), np.ravel(at.v))
    Phi, Phi_dot, lengths, rates, roundoff = dynamics.residuals(t, q, v)
    starts = core.joint_rows[:-1]

    def of(level: str, residual: Floats, scale: Floats, nothing: Floats | float) -> Residuals:
        values = np.abs(residual)
        if not len(starts):
            return Residuals(level, np.zeros(0), np.zeros(0), np.zeros(0))
        relative = np.divide(values, scale, out=np.zeros(len(values)), where=values > nothing)
        rounding = RESIDUAL_TOLERANCE + roundoff
        return Residuals(level, *(np.maximum.reduceat(x, starts) for x in (values, relative, rounding)))

    return [of("poses", Phi, lengths, 0.0), of("velocities", Phi_dot, lengths * rates, AT_REST * lengths)]


def joint_residuals(
    model: Model, dynamics: _core.Dynamics, at: Snapshot | None = None
) -> tuple[Floats, Floats]:
    """Largest of each joint (joints,), of Phi and of Phi_dot = D v + Phi_t; without `at` at t = 0."""
    position, velocity = residuals(model, dynamics, at)
    return position.value, velocity.value


def consistent(
    model: Model, dynamics: _core.Dynamics, correct: bool = True, *, quiet: bool = False
) -> Assembly | None:
    """Correct initial conditions that violate the joints by a little more than rounding; None: nothing to do.

    LinkworkWarning: what was corrected; with `correct` False any violation, which then stays. ModelError: the
    violation is too large to be an inaccuracy; its `joints` and `residuals` are those that violate it.
    NotConvergedError: joints contradict each other. `quiet`: without the warnings, which were given.
    """
    if dynamics.residual_at_start <= RESIDUAL_TOLERANCE:
        return None
    core = model.compiled()
    small = SMALL_RESIDUAL if correct else np.inf
    remarks = (_inaccuracy(core, level, level.rounding, small) for level in residuals(model, dynamics))
    found = "; ".join(filter(None, remarks))
    if found and not correct and not quiet:
        warn(found)
    if not found or not correct:
        return None
    assembly = assemble(model)
    moved, turned, faster = (
        float(x.max()) for x in (assembly.moved, assembly.turned, assembly.velocity_change)
    )
    changes = f"bodies by at most {moved:.2g} m and {turned:.2g} rad, velocities by {faster:.2g} m/s"
    if not quiet:
        warn(f"{found}: corrected {changes}")
    return assembly


def near_dependence(dynamics: _core.Dynamics) -> str:
    """What to say of equations that depend on each other but for digits of the geometry; "" where none do."""
    rank = dynamics.rank()
    count = rank.nearly_dependent
    if not count:
        return ""
    rows = "an equation is" if count == 1 else f"{count} equations are"
    freedoms = rank.degrees_of_freedom
    are = "is" if freedoms == 1 else "are"
    left = f"there {are} {_freedoms(freedoms)}" if freedoms else "nothing can move"
    if rank.beside_drivers:
        left += " beside what is driven"
    return (
        f"joints {listed(dynamics.nearly_dependent_joints())}: {rows} independent of the others by "
        f"{rank.least_part:.1g} only, as where points or axes are rounded, or meant to be as close as that: "
        f"as they are given {left}, and reactions are very large; exact ones would leave "
        f"{_freedoms(freedoms + count)}. Compute them to all digits, or take joints that do not repeat each "
        "other"
    ).replace("e-0", "e-")


def _freedoms(count: int) -> str:
    return "1 degree of freedom" if count == 1 else f"{count} degrees of freedom"


def warn_of_near_dependence(dynamics: _core.Dynamics) -> None:
    """LinkworkWarning: equations that nearly depend on each other."""
    if text := near_dependence(dynamics):
        warn(text)


def warn_of_opposed_axes(model: Model, q: Floats) -> None:
    """LinkworkWarning: axes of joints that point away from each other, where their equations hold as well."""
    core = model.compiled()
    if core.joint_count > MOST_COMPARED:
        return
    names = [core.joint_name(int(joint)) for joint in branches.opposed(core, np.ravel(q))[:3]]
    if names:
        warn(
            f"the axes of {', '.join(map(repr, names))} point in opposite directions, where the equations "
            "hold, too: they stay turned by 180 degrees; turn the bodies, if that is not meant"
        )


def start_time(start: Snapshot | None) -> float:
    """Where a run begins [s]. OptionError: what is no Snapshot."""
    if start is None:
        return 0.0
    if not isinstance(start, Snapshot):
        raise OptionError(f"start {start!r:.80} is no linkwork.Snapshot(t, q, v)", code="start")
    if not isinstance(start.error, int | float) or isinstance(start.error, bool):
        raise OptionError(f"start: error {start.error!r:.80} is no number", code="start")
    return number(start.t, "start: t", code="start")


def check_start(model: Model, dynamics: _core.Dynamics, start: Snapshot, *, known: bool = False) -> None:
    """OptionError: the state of another mechanism.

    LinkworkWarning: the joints do not hold in it, or by opposed axes, unless it is `known` to be that of the
    run which goes on; force elements had more to go on from than the state.
    """
    check_state(model, start)
    core = model.compiled()
    _take_history(core, dynamics, start)
    if known:
        return
    remarks = [
        _inaccuracy(core, level, SMALL_RESIDUAL, np.inf) for level in residuals(model, dynamics, start)
    ]
    if any(remarks):
        warn(f"start: {'; '.join(filter(None, remarks))}: the run goes on from there as it is")
    warn_of_opposed_axes(model, start.q)


def check_state(model: Model, start: Snapshot) -> None:
    """OptionError: no finite state of these bodies."""
    core, count = model.compiled(), model.body_count
    q, v = array(start.q, "start: q"), array(start.v, "start: v")
    if q.size != 7 * count or v.size != 6 * count or not (np.isfinite(q).all() and np.isfinite(v).all()):
        raise OptionError(
            f"start: q {q.shape} and v {v.shape} are no finite state of the {count} bodies of model "
            f"'{model.name}': ({count}, 7) and ({count}, 6) are",
            code="start",
        )
    length = np.linalg.norm(q.reshape(-1, 7)[:, 3:], axis=1)
    if not (np.abs(length - 1.0) <= UNIT_TOLERANCE).all():
        body = int(np.argmax(np.abs(length - 1.0)))
        raise OptionError(
            f"start: body '{core.body_name(body)}': its Euler parameters have norm {length[body]:g}, not 1: "
            "divide them by it",
            code="start",
            bodies=[core.body_name(body)],
        )


def check_history(dynamics: _core.Dynamics, start: Snapshot) -> None:
    """OptionError: that of another model."""
    given, known = array(start.history, "start: history"), len(dynamics.initial_history)
    if given.size and (given.shape != (known,) or not np.isfinite(given).all()):
        raise OptionError(
            f"start: its history has {given.size} variables, or one that is not finite, but the springs, "
            f"stops, contacts and couplers of the model have {known}: start from a run of the same model, or "
            "leave the history out (start._replace(history=()))",
            code="start",
        )


def _take_history(core: _core.Model, dynamics: _core.Dynamics, start: Snapshot) -> None:
    """OptionError: that of another model. LinkworkWarning: there is none."""
    check_history(dynamics, start)
    given = array(start.history, "start: history")
    if not given.size:
        given = dynamics.beginning_history(start.t, np.ravel(start.q), np.ravel(start.v))
        if start.t > 0:
            _warn_of_beginnings(core)
    dynamics.history = given


def _warn_of_beginnings(core: _core.Model) -> None:
    """LinkworkWarning: what starts otherwise than it went on before."""
    kinds = [kind.name for kind in _core.force_kinds()]
    of_force = [BEGINNING.get(kinds[kind]) for kind in core.force_arrays()["kind"]]
    for what in sorted(set(filter(None, of_force))):
        names = [core.force_name(place) for place, found in enumerate(of_force) if found == what]
        warn(f"start: {_listed(len(names), names.__getitem__)}: {what}")
    laws = [name for name, coordinate in core.joint_forces if coordinate != "displacement"]
    if laws:
        turns = BEGINNING["rotational_stop"]
        warn(f"start: {_listed(len(laws), laws.__getitem__)}: {turns}")


def contradictions_at_start(model: Model, dynamics: _core.Dynamics) -> dict[str, float]:
    """Of redundant equations that ask for other accelerations than the rest: what is left of them [1/s2].

    By the equation in words; such as drivers that agree in position and velocity, and are about to part.
    """
    rows = np.asarray(dynamics.rank().redundant_rows, dtype=int)
    core = model.compiled()
    if not len(rows):
        return {}
    v_dot, _ = dynamics.accelerations(0.0, core.q0, core.v0)
    found = dynamics.evaluate(0.0, core.q0, core.v0)
    from scipy.sparse import csr_array  # which takes long to import

    D = csr_array(
        tuple(found["D"][part] for part in ("data", "indices", "indptr")), (core.row_count, len(v_dot))
    )
    left = np.abs(D @ v_dot - found["gamma"])[rows]
    size = (abs(D) @ np.abs(v_dot) + np.abs(found["gamma"]))[rows]
    broken = left > CONTRADICTION * size.max(initial=0.0)
    return {core.describe_row(int(row)): float(x) for row, x in zip(rows[broken], left[broken], strict=True)}


def warn_of_contradiction(statistics: Mapping[str, Any]) -> None:
    """LinkworkWarning: redundant equations contradict the others, by so little that the run went on.

    Two drivers of one joint agree at the start and part later: only one of them was followed.
    """
    found = statistics.get("contradiction")
    if not found:
        return
    names = found["joints"]
    warn(
        f"redundant equations of {_listed(len(names), names.__getitem__)} are violated by up to "
        f"{found['largest']:.2g} (m or 1) from t = {found['t']:.6g} s on, where the others hold: joints or "
        "drivers contradict each other, and not all were followed"
    )


def check_gains(method: Integrator | PythonStep, dynamics: _core.Dynamics, step: float) -> None:
    """OptionError: Baumgarte gains that the integrator cannot follow; LinkworkWarning: order lost.

    What a function of Python makes of the term of `baumgarte` nobody knows.
    """
    options = dynamics.options
    alpha, beta, kind = options.baumgarte_alpha, options.baumgarte_beta, options.stabilization
    if alpha is None or beta is None or isinstance(method, HalfExplicit):  # which refuses them itself
        return
    if kind == "sampled_baumgarte":
        who = f"'{method.name}'" if isinstance(method, Integrator) else f"{method!r:.80}"
        _check_growth(getattr(method, "sampled_growth", added_growth), alpha, beta, step, who, kind)
    elif kind == "baumgarte" and isinstance(method, Integrator):
        _check_growth(method.growth, alpha, beta, step, f"'{method.name}'", kind)
        if max(alpha, beta) * step > ACCURATE_GAIN and method.order > 1:
            lost = f"integrator '{method.name}' loses its order {method.order}"
            warn(f"{_gains(alpha, beta)} are above {ACCURATE_GAIN:g} / step: {lost}")


def _check_growth(
    grown: Callable[[float, float], float], alpha: float, beta: float, step: float, who: str, kind: str
) -> None:
    growth = grown(min(alpha * step, stiffness.BEYOND), min(beta * step, stiffness.BEYOND))
    if growth > 1 + STABLE:
        factor = f"1 + {growth - 1:.2g}" if growth < 1.01 else f"{growth:.3g}"
        raise OptionError(
            f"{_gains(alpha, beta)} are unstable with integrator {who} and step {step:g} s: a violation "
            f"grows by the factor {factor} in each step; {INSTEAD[kind]}",
            code="unstable_gains",
        )


def _gains(alpha: float, beta: float) -> str:
    return f"baumgarte_alpha {alpha:g} 1/s and baumgarte_beta {beta:g} 1/s"


def check_stiffness(method: Integrator, system: System, step: float) -> None:
    """OptionError: springs or dampers that are too stiff for an explicit integrator with this step."""
    growth = getattr(method, "growth", None)
    if growth is None:
        return
    fastest = stiffness.fastest(system)
    if fastest is None:
        return
    limit = stiffness.stable_step(growth, fastest.eigenvalue, step)
    if limit < step:
        raise OptionError(
            f"step {step:g} s is too long for integrator '{method.name}': force elements make body "
            f"'{fastest.body}' move with eigenvalue {_complex(fastest.eigenvalue)} 1/s at the start, which "
            f"needs about {limit:.2g} s or less; give such a step, or rtol for steps that follow the motion",
            code="unstable_step",
        )


def _complex(value: complex) -> str:
    real = abs(value.imag) < REAL * abs(value)
    return f"{value.real:.3g}" if real else f"{value.real:.3g} +- {abs(value.imag):.3g}i"


def _inaccuracy(core: _core.Model, found: Residuals, rounding: Floats | float, most: float) -> str:
    """Which joints are violated by more than rounding, "" where none is. ModelError: one by too much.

    Both are relative to the size or speed of the mechanism.
    """
    relative, unit = found.relative, found.unit
    alike = np.round(relative / relative.max(initial=np.finfo(float).tiny), 6)
    worst = np.lexsort((-found.value, -alike))
    worst = worst[(relative > rounding)[worst]]
    if not len(worst):
        return ""
    each = _listed(
        len(worst), lambda k: f"{core.joint_name(int(worst[k]))} {found.value[worst[k]]:.3g}{unit}"
    )
    joints = "1 joint" if len(worst) == 1 else f"{len(worst)} joints"
    message = f"initial {found.level} do not satisfy {joints} (residual, m or 1): {each}"
    if relative[worst[0]] <= most:
        return message
    names = [core.joint_name(int(joint)) for joint in worst]
    allowed = most * found.value[worst[0]] / relative[worst[0]]
    raise ModelError(
        f"{message}: more than {allowed:.2g}{unit} is no inaccuracy; correct it, or simulate the model that "
        "linkwork.assemble(model).model gives; model.view() shows where",
        code=f"inconsistent_{found.level}",
        joints=names,
        residuals=dict(zip(names, found.value[worst].tolist(), strict=True)),
    )


def _listed(count: int, item: Callable[[int], str]) -> str:
    shown = [item(k) for k in range(min(count, LISTED))]
    return "; ".join(shown) + (f"; and {count - LISTED} more" if count > LISTED else "")
