"""How the time of a step grows with the number of bodies: chains, standard formulation, RK4."""

from __future__ import annotations

import linkwork as lw
import numpy as np
from measure import Outcome, medians

BODIES = (1000, 1778, 3162, 5623, 10000)
EVALUATIONS = 200_000  # of bodies, in one run
STEP = 1e-3


def step_scaling(runs: int) -> Outcome:
    rows = [
        {"bodies": float(bodies), **medians(runs, lambda bodies=bodies: _one(bodies))} for bodies in BODIES
    ]
    logarithms = (np.log([row[name] for row in rows]) for name in ("bodies", "ms a step"))
    exponent = float(np.polyfit(*logarithms, 1)[0])
    title = "a step of a chain takes ~ bodies ^ exponent"
    return Outcome(title, rows, exponent, "at most 1.15", exponent <= 1.15)


def _one(bodies: int) -> dict[str, float]:
    steps = EVALUATIONS // (4 * bodies)
    result = lw.simulate(lw.mechanisms.chain(bodies), steps * STEP, STEP, record_every=steps, progress=False)
    statistics = result.statistics
    ms = 1e3 * statistics["driver_seconds"] / steps
    parts = {name: 1e3 * statistics[f"{name}_time"] / steps for name in ("evaluate", "factorize", "solve")}
    return {
        "ms a step": ms,
        "ns a body and evaluation": 1e6 * ms / (4 * bodies),
        **parts,
        "setup s": statistics["setup_seconds"],
    }
