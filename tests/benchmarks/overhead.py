"""How much of a run is spent outside the compiled module: 10 s of a chain of five bodies, RK4, h = 1e-3."""

from __future__ import annotations

import time

import linkwork as lw
from measure import Outcome, medians


def overhead(runs: int) -> Outcome:
    row = medians(runs, _one)
    return Outcome("share of `simulate` spent in C++", [row], row["share"], "above 0.9", row["share"] > 0.9)


def _one() -> dict[str, float]:
    model = lw.mechanisms.chain(5)
    begun = time.perf_counter()
    statistics = lw.simulate(model, 10.0, 1e-3, "rk4", progress=False).statistics
    wall = time.perf_counter() - begun
    parts = {f"{name} s": statistics[f"{name}_time"] for name in ("evaluate", "factorize", "solve")}
    driver = statistics["driver_seconds"]  # with those, the integrator itself and recording
    return {**parts, "driver s": driver, "wall s": wall, "share": driver / wall}
