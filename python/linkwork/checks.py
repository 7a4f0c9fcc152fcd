"""What is looked at before the first step of a run."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from linkwork import _core, stiffness
from linkwork.assembly import Assembly, assemble
from linkwork.errors import ModelError, OptionError, warn
from linkwork.extent import extent
from linkwork.integrators import HalfExplicit, Integrator
from linkwork.model import Model, check_model
from linkwork.result import Snapshot
from linkwork.system import System

Floats = NDArray[np.float64]

#: Residuals of the initial state that are more than rounding, relative to the size of what is placed.
RESIDUAL_TOLERANCE = 1e-9

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

#: Residuals of equations that others imply, over those of the others, beyond which they are not implied.
CONTRADICTION = 100.0

#: Residuals up to here, relative to the size of the mechanism and to its speed, are corrected.
SMALL_RESIDUAL = 1e-3

#: How many objects a message lists.
LISTED = 5

#: Gains times step above which continuous Baumgarte stabilization lowers the order of the integrator.
ACCURATE_GAIN = 0.1


def check_bodies(model: Model) -> None:
    """ModelError: no model, or nothing to simulate in it."""
    check_model(model)
    if not model.body_count:
        raise ModelError(f"model '{model.name}': has no bodies", code="empty")


def check_tables(model: Model, t_end: float) -> None:
    """OptionError: a function of time is not known from 0 to t_end."""
    for what, signal in model.signals:
        first, last = signal.span
        if first > 0.0 or last < t_end:
            raise OptionError(
                f"{what}: is given from {first:g} to {last:g} s, the run goes from 0 to {t_end:g} s; "
                "extend the table or shorten the run",
                code="time_function_range",
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


def joint_residuals(
    model: Model, dynamics: _core.Dynamics, at: Snapshot | None = None
) -> tuple[Floats, Floats]:
    """Largest of each joint (joints,), of Phi and of Phi_dot = D v + Phi_t; without `at` at t = 0."""
    core = model.compiled()
    t, q, v = (0.0, core.q0, core.v0) if at is None else (at.t, np.ravel(at.q), np.ravel(at.v))
    found = dynamics.evaluate(t, q, v)
    starts = core.joint_rows[:-1]
    if not len(starts):
        return np.zeros(0), np.zeros(0)
    position, velocity = (np.maximum.reduceat(np.abs(found[level]), starts) for level in ("Phi", "Phi_dot"))
    return position, velocity


def consistent(model: Model, dynamics: _core.Dynamics, correct: bool = True) -> Assembly | None:
    """Correct initial conditions that violate the joints by a little more than rounding; None: nothing to do.

    LinkworkWarning: what was corrected; with `correct` False any violation, which then stays. ModelError: the
    violation is too large to be an inaccuracy; its `joints` and `residuals` are those that violate it.
    NotConvergedError: joints contradict each other.
    """
    core = model.compiled()
    size, reach = extent(core)
    speed = max(1.0, float(np.abs(core.v0).max(initial=0.0))) * max(1.0, size)
    position, velocity = joint_residuals(model, dynamics)
    small = SMALL_RESIDUAL if correct else np.inf
    rounding = RESIDUAL_TOLERANCE * max(1.0, size) + ROUNDOFF * reach
    remarks = [
        _inaccuracy(core, "poses", position, "", rounding, small * size),
        _inaccuracy(core, "velocities", velocity, "/s", RESIDUAL_TOLERANCE * speed, small * speed),
    ]
    found = "; ".join(filter(None, remarks))
    if found and not correct:
        warn(found)
    if not found or not correct:
        return None
    assembly = assemble(model)
    moved, turned, faster = (
        float(x.max()) for x in (assembly.moved, assembly.turned, assembly.velocity_change)
    )
    changes = f"bodies by at most {moved:.2g} m and {turned:.2g} rad, velocities by {faster:.2g} m/s"
    warn(f"{found}: corrected {changes}")
    return assembly


def start_time(start: Snapshot | None) -> float:
    """Where a run begins [s]. OptionError: what is no Snapshot."""
    if start is not None and not isinstance(start, Snapshot):
        raise OptionError(f"start {start!r} is no linkwork.Snapshot(t, q, v)", code="start")
    return 0.0 if start is None else float(start.t)


def check_start(model: Model, dynamics: _core.Dynamics, start: Snapshot) -> None:
    """OptionError: the state of another mechanism.

    LinkworkWarning: the joints do not hold in it, or force elements had more to go on from than the state.
    """
    core, y = model.compiled(), start.y
    if len(y) != 13 * model.body_count or not np.isfinite(y).all():
        raise OptionError(
            f"start: q {np.shape(start.q)} and v {np.shape(start.v)} are no finite state of the "
            f"{model.body_count} bodies of model '{model.name}'",
            code="start",
        )
    size, _ = extent(core)
    speed = max(1.0, float(np.abs(start.v).max(initial=0.0))) * max(1.0, size)
    _take_history(core, dynamics, start)
    position, velocity = joint_residuals(model, dynamics, start)
    remarks = [
        _inaccuracy(core, "poses", position, "", SMALL_RESIDUAL * size, np.inf),
        _inaccuracy(core, "velocities", velocity, "/s", SMALL_RESIDUAL * speed, np.inf),
    ]
    if any(remarks):
        warn(f"start: {'; '.join(filter(None, remarks))}: the run goes on from there as it is")


def check_history(dynamics: _core.Dynamics, start: Snapshot) -> None:
    """OptionError: that of another model."""
    given, known = np.asarray(start.history, dtype=float), len(dynamics.initial_history)
    if len(given) and (given.shape != (known,) or not np.isfinite(given).all()):
        raise OptionError(
            f"start: its history has {given.size} variables, or one that is not finite, but the springs, "
            f"stops, contacts and couplers of the model have {known}: start from a run of the same model, or "
            "leave the history out (start._replace(history=()))",
            code="start",
        )


def _take_history(core: _core.Model, dynamics: _core.Dynamics, start: Snapshot) -> None:
    """OptionError: that of another model. LinkworkWarning: there is none."""
    check_history(dynamics, start)
    given = np.asarray(start.history, dtype=float)
    if not len(given):
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


def check_redundant(model: Model, dynamics: _core.Dynamics, end: Snapshot) -> None:
    """LinkworkWarning: what was left out as redundant does not hold at the end, and so contradicts the rest.

    Two drivers of one joint agree at the start and may part later: only one of them was followed.
    """
    rows = np.asarray(dynamics.rank().redundant_rows, dtype=int)
    if not len(rows):
        return
    core = model.compiled()
    Phi = np.abs(dynamics.evaluate(end.t, np.ravel(end.q), np.ravel(end.v))["Phi"])
    kept = float(np.delete(Phi, rows).max(initial=0.0))
    broken = rows[Phi[rows] > max(SMALL_RESIDUAL * extent(core).size, CONTRADICTION * kept)]
    if len(broken):
        joints = np.unique(np.searchsorted(core.joint_rows, broken, side="right") - 1)
        names = [core.joint_name(int(joint)) for joint in joints]
        warn(
            f"redundant equations of {_listed(len(names), names.__getitem__)} are violated by "
            f"{Phi[broken].max():.2g} (m or 1) at t = {end.t:g} s, where the others hold to {kept:.1g}: "
            "joints or drivers contradict each other, and these were not followed"
        )


def check_gains(method: Integrator, dynamics: _core.Dynamics, step: float) -> None:
    """OptionError: Baumgarte gains that the integrator cannot follow; LinkworkWarning: order lost."""
    options = dynamics.options
    alpha, beta = options.baumgarte_alpha, options.baumgarte_beta
    if options.stabilization != "baumgarte" or alpha is None or beta is None:
        return
    if isinstance(method, HalfExplicit):  # refuses these gains itself
        return
    gains = f"baumgarte_alpha {alpha:g} 1/s and baumgarte_beta {beta:g} 1/s"
    growth = method.growth(alpha * step, beta * step)
    if growth > 1 + 1e-9:
        raise OptionError(
            f"{gains} are unstable with integrator '{method.name}' and step {step:g} s: a violation grows "
            f"by the factor {growth:.3g} in each step; use smaller gains, a smaller step, or stabilization "
            "'sampled_baumgarte'",
            code="unstable_gains",
        )
    if max(alpha, beta) * step > ACCURATE_GAIN and method.order > 1:
        lost = f"integrator '{method.name}' loses its order {method.order}"
        warn(f"{gains} are above {ACCURATE_GAIN:g} / step: {lost}")


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
    real = abs(value.imag) < 1e-6 * abs(value)
    return f"{value.real:.3g}" if real else f"{value.real:.3g} +- {abs(value.imag):.3g}i"


def _inaccuracy(
    core: _core.Model, level: str, residuals: Floats, unit: str, rounding: float, most: float
) -> str:
    """Which joints are violated by more than rounding, "" where none is. ModelError: one by too much."""
    worst = np.argsort(-residuals, kind="stable")
    worst = worst[residuals[worst] > rounding]
    if not len(worst):
        return ""
    each = _listed(len(worst), lambda k: f"{core.joint_name(int(worst[k]))} {residuals[worst[k]]:.3g}{unit}")
    joints = "1 joint" if len(worst) == 1 else f"{len(worst)} joints"
    message = f"initial {level} do not satisfy {joints} (residual, m or 1): {each}"
    if residuals[worst[0]] <= most:
        return message
    names = [core.joint_name(int(joint)) for joint in worst]
    raise ModelError(
        f"{message}: more than {most:.2g}{unit} is no inaccuracy; correct it, or simulate the model that "
        "linkwork.assemble(model).model gives",
        code=f"inconsistent_{level}",
        joints=names,
        residuals=dict(zip(names, residuals[worst].tolist(), strict=True)),
    )


def _listed(count: int, item: Callable[[int], str]) -> str:
    shown = [item(k) for k in range(min(count, LISTED))]
    return "; ".join(shown) + (f"; and {count - LISTED} more" if count > LISTED else "")
