"""Every integrator keeps its order with constraints and sampled stabilization: motion and reactions.

The order is that of the finest pair of steps, h and h/2, whose error is still above roundoff.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.integrators import METHODS
from small_mechanisms import driven_pendulum, slider_crank, spherical_pendulum, two_body_loop

#: With the time to simulate [s].
MECHANISMS: dict[str, tuple[Callable[[], lw.Model], float]] = {
    "spherical_pendulum": (spherical_pendulum, 2.1),
    "slider_crank": (slider_crank, 1.1),
    "two_body_loop": (two_body_loop, 1.2),
    "driven_pendulum": (driven_pendulum, 1.25),
}

FRAMES = 32
MOST_STEPS, FEWEST_STEPS = 2**13, 2**3
ROUNDOFF = 5e-12  # relative error below which halving the step may change nothing


def run(name: str, steps: int, method: str, **options: Any) -> lw.Result:
    model, t_end = MECHANISMS[name][0](), MECHANISMS[name][1]
    every = max(1, steps // FRAMES)
    return lw.simulate(model, t_end, t_end / steps, method, record_every=every, progress=False,
                       on_inaccurate="pass", **options)  # fmt: skip


@cache
def reference(name: str) -> lw.Result:
    return run(name, 2**14, "tsit5")


def root_mean_square(field: np.ndarray, exact: np.ndarray) -> float:
    """Over all frames, relative to the largest value."""
    return float(np.sqrt(np.mean((field - exact) ** 2)) / np.abs(exact).max())


def errors(name: str, steps: int, method: str, **options: Any) -> tuple[float, float]:
    """Of the motion (positions and velocities), and of the reactions."""
    try:
        found, exact = run(name, steps, method, **options), reference(name)
    except (lw.NotFiniteError, lw.SingularSystemError):  # a step far too large
        return np.inf, np.inf
    every = FRAMES // (len(found) - 1)  # a coarse run has fewer frames than the reference
    motion = np.hypot(*(root_mean_square(getattr(found, x), getattr(exact, x)[::every]) for x in "qv"))
    wrench, exact_wrench = np.array(found.reactions()), np.array(exact.reactions())[:, ::every]
    return float(motion), root_mean_square(wrench, exact_wrench)


def observed_orders(name: str, method: str, **options: Any) -> list[float]:
    """Of the motion, and of the reactions."""
    orders: list[float] = []
    steps, finer = MOST_STEPS, errors(name, MOST_STEPS, method, **options)
    while len(orders) < 2 and steps > FEWEST_STEPS:
        steps //= 2
        coarser = errors(name, steps, method, **options)
        while len(orders) < 2 and finer[len(orders)] > ROUNDOFF:
            orders.append(float(np.log2(coarser[len(orders)] / finer[len(orders)])))
        finer = coarser
    return orders


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", MECHANISMS)
def test_observed_order_is_the_order_of_the_method(name: str, method: str) -> None:
    order = METHODS[method].order
    assert observed_orders(name, method) == pytest.approx([order] * 2, abs=0.2 if order <= 5 else 0.7)


@pytest.mark.parametrize("name", MECHANISMS)
def test_continuous_gains_proportional_to_the_step_take_the_order_of_rk4(name: str) -> None:
    """With alpha = 1/h and beta = sqrt(2)/h positions are of order 2, velocities of order 1, for every h."""
    observed: dict[str, list[float]] = {"q": [], "v": []}
    for steps in (2**10, 2**11):
        step = MECHANISMS[name][1] / steps
        with pytest.warns(lw.LinkworkWarning, match="loses its order 4"):
            found = run(
                name,
                steps,
                "rk4",
                stabilization="baumgarte",
                baumgarte_alpha=1 / step,
                baumgarte_beta=2**0.5 / step,
            )
        for what, of_steps in observed.items():
            of_steps.append(root_mean_square(getattr(found, what), getattr(reference(name), what)))
    orders = {what: np.log2(coarse / fine) for what, (coarse, fine) in observed.items()}
    assert orders == pytest.approx({"q": 2.0, "v": 1.0}, abs=0.1)


def violated(displacement: float, speed: float) -> lw.Model:
    """A weightless body beside its ball joint, moving away from it."""
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body(
        "body", mass=2.0, inertia=(0.3, 0.2, 0.1), position=(1, 0, 0), velocity=(speed, 0, -speed)
    )
    point = np.array([-1.0 + displacement, displacement, 0])
    model.spherical(model.ground, body, at=((0, 0, 0), point), frames="body")
    return model


@pytest.mark.filterwarnings("ignore:initial")
@pytest.mark.parametrize("method", METHODS)
def test_sampled_stabilization_annuls_a_violation_in_two_steps(method: str) -> None:
    """Of positions and velocities, to second order in it; Adams methods first forget how they started."""
    step, size = 1e-3, 1e-6
    order = METHODS[method].order
    annulled = order + 2 if hasattr(METHODS[method], "predictor") else 2
    violation = lw.simulate(
        violated(size, size / step), 10 * step, step, method, progress=False, assemble=False,
        on_inaccurate="pass",
    ).violation  # fmt: skip
    assert violation[0, :2] == pytest.approx([size, size / step])
    assert (violation[annulled:, :2] <= [1e-4 * size, 1e-4 * size / step]).all()
