"""What is looked at before the first step of a run."""

from __future__ import annotations

import warnings
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from linkwork import _core, stiffness
from linkwork.errors import LinkworkWarning, ModelError, OptionError
from linkwork.integrators import HalfExplicit, Integrator
from linkwork.model import Model
from linkwork.system import System

Floats = NDArray[np.float64]

#: Residuals of the initial state that are more than rounding, relative to the size of what is placed.
RESIDUAL_TOLERANCE = 1e-9

#: How many objects a message lists.
LISTED = 5

#: Gains times step above which continuous Baumgarte stabilization lowers the order of the integrator.
ACCURATE_GAIN = 0.1


def check_bodies(model: Model) -> None:
    """ModelError: there is nothing to simulate."""
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


def joint_residuals(model: Model, dynamics: _core.Dynamics) -> tuple[Floats, Floats]:
    """Largest residual of each joint (joints,) at the initial state: of Phi, and of Phi_dot = D v + Phi_t."""
    core = model.compiled()
    found = dynamics.evaluate(0.0, core.q0, core.v0)
    starts = core.joint_rows[:-1]
    if not len(starts):
        return np.zeros(0), np.zeros(0)
    position, velocity = (np.maximum.reduceat(np.abs(found[level]), starts) for level in ("Phi", "Phi_dot"))
    return position, velocity


def warn_of_residuals(model: Model, dynamics: _core.Dynamics) -> None:
    """LinkworkWarning: the initial pose or the initial velocities do not satisfy the joints."""
    core = model.compiled()
    reach = max(1.0, float(np.abs(core.q0).max(initial=0.0)))
    speed = max(1.0, float(np.abs(core.v0).max(initial=0.0))) * reach
    for residuals, scale, level in zip(
        joint_residuals(model, dynamics), (reach, speed), ("poses", "velocities"), strict=True
    ):
        worst = np.argsort(-residuals, kind="stable")
        worst = worst[residuals[worst] > RESIDUAL_TOLERANCE * scale]
        if len(worst):
            _warn_of(core, level, worst, residuals)


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
        warnings.warn(f"{gains} are above {ACCURATE_GAIN:g} / step: {lost}", LinkworkWarning, stacklevel=4)


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


def _warn_of(core: _core.Model, level: str, worst: NDArray[np.int64], residuals: Floats) -> None:
    unit = "" if level == "poses" else "/s"
    each = _listed(len(worst), lambda k: f"{core.joint_name(int(worst[k]))} {residuals[worst[k]]:.3g}{unit}")
    message = f"initial {level} do not satisfy {len(worst)} joints (residual, m or 1): {each}"
    warnings.warn(message, LinkworkWarning, stacklevel=4)


def _listed(count: int, item: Callable[[int], str]) -> str:
    shown = [item(k) for k in range(min(count, LISTED))]
    return "; ".join(shown) + (f"; and {count - LISTED} more" if count > LISTED else "")
