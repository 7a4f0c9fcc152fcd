"""What long runs say of their own accuracy, beside the truth: many periods of linkwork.mechanisms.

python tests/benchmarks/long_verdicts.py [--mechanisms four_bar,heavy_top] [--seconds 6,24]

Each runs by fixed steps and by tolerances of several orders. The truth is DOP853 with projection at rtol
1e-11; left out are mechanisms of which the one at 1e-9 differs from it by more than 1e-5, whose motion is
chaotic.

ratio     of the verdict's error to the true one, where that is between 1e-7 and 1
silent    runs more than 1 % off that are called good
false     runs less than 0.1 % off that are not
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import linkwork as lw
import numpy as np
from linkwork.arrays import Floats
from linkwork.errors import LinkworkError
from verdicts import RIGHT, WRONG, difference, exact, quiet

MECHANISMS = ("four_bar", "pendulum", "rod_pendulum", "bricard", "spatial_slider_crank", "gyroscope",
              "heavy_top", "torque_free_top", "bennett", "flyball_governor", "rolling_disc",
              "planetary_gear")  # fmt: skip
STEPS = {"rk4": (1e-2, 2e-3), "rk3": (1e-2, 2e-3), "heun": (1e-2, 2e-3), "ab4": (1e-2, 2e-3),
         "semi_implicit_euler": (1e-2, 2e-3)}  # fmt: skip
TOLERANCES = {"dopri5": (1e-4, 1e-6, 1e-8), "bs32": (1e-4, 1e-6, 1e-8)}

#: Between frames that are compared [s], and what the truth may be off by.
EVERY, KNOWN = 0.02, 1e-5

#: Errors that are neither rounding nor a lost motion.
JUDGED = (1e-7, 1.0)


@dataclass
class Found:
    """One run."""

    name: str
    true: float
    error: float
    level: str

    @property
    def fault(self) -> str:
        if self.true > WRONG and self.level == "good":
            return "silent"
        return "false" if self.true < RIGHT and self.level != "good" else ""


def methods() -> Iterator[tuple[str, dict[str, Any]]]:
    for integrator, steps in STEPS.items():
        for step in steps:
            how = {"integrator": integrator, "step": step, "record_every": round(EVERY / step)}
            yield f"{integrator} {step:g} s", how
    for integrator, tolerances in TOLERANCES.items():
        for rtol in tolerances:
            yield f"{integrator} rtol {rtol:g}", {"integrator": integrator, "rtol": rtol}


def study(mechanism: str, seconds: float) -> Iterator[Found]:
    """Nothing of one whose motion nobody knows."""
    model, times = getattr(lw.mechanisms, mechanism)(), np.linspace(0.0, seconds, round(seconds / EVERY) + 1)
    try:
        truth = exact(model, seconds, times)
        if difference(exact(model, seconds, times, 1e-9), truth).max() > KNOWN:
            return
    except (LinkworkError, TimeoutError):
        return
    for name, how in methods():
        given = how if "step" in how else {**how, "times": times}
        try:
            run = quiet(model, seconds, **given)
        except (LinkworkError, TimeoutError):
            continue
        assert run.verdict is not None
        true = float(difference(run, truth).max())
        yield Found(f"{mechanism}, {seconds:g} s, {name}", true, run.verdict.error, run.verdict.level)


def ratios(found: list[Found]) -> Floats:
    least, most = JUDGED
    return np.array([it.error / it.true for it in found if least < it.true < most] or [np.nan])


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--mechanisms", default=",".join(MECHANISMS), help="names (all that are listed)")
    parser.add_argument("--seconds", default="6,24", help="of the runs (6,24)")
    given = parser.parse_args()
    found: list[Found] = []
    for mechanism in given.mechanisms.split(","):
        for seconds in given.seconds.split(","):
            for it in study(mechanism, float(seconds)):
                found.append(it)
                if it.fault or it.error < it.true < JUDGED[1]:
                    print(
                        f"{it.name}: {it.true:.2g} off, said {it.error:.2g}, {it.level} {it.fault}",
                        flush=True,
                    )
    print(f"{len(found)} runs, ratios at 0, 5, 25, 50, 75, 95 and 100 %:")
    print(" ".join(f"{q:.2g}" for q in np.quantile(ratios(found), (0, 0.05, 0.25, 0.5, 0.75, 0.95, 1))))
    counts = ", ".join(f"{what}: {sum(it.fault == what for it in found)}" for what in ("silent", "false"))
    print(f"below the error: {100 * np.mean(ratios(found) < 1):.1f} %; {counts}")


if __name__ == "__main__":
    main()
