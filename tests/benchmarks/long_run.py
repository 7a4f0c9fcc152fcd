"""Long runs with the defaults: python tests/benchmarks/long_run.py

four_bar(2), which passes a singular pose about every second, and bricard, whose equations are redundant, for
1000 s. In pieces of 100 s: the largest violation of the constraints [m or 1, and 1/s], the largest error of
the energy so far [J], and the memory of the process [MB].
"""

from __future__ import annotations

import resource
from collections.abc import Iterator
from dataclasses import dataclass

import linkwork as lw
from linkwork import mechanisms

MECHANISMS = {"four_bar(2)": lambda: mechanisms.four_bar(2), "bricard": mechanisms.bricard}
STEPS = {"four_bar(2)": 2e-3, "bricard": 1e-2}  # s


@dataclass(frozen=True)
class Piece:
    """One part of a long run."""

    t: float  # at its end [s]
    position: float  # largest |Phi|
    velocity: float  # largest |Phi_dot|
    energy_error: float  # largest since the start of the first piece [J]
    memory: float  # resident at the most, of the whole process [MB]


def run(name: str, t_end: float, pieces: int) -> Iterator[Piece]:
    """One after the other, each from where the one before ended."""
    model, start = MECHANISMS[name](), None
    energy = worst = None
    for k in range(1, pieces + 1):
        result = lw.simulate(model, t_end * k / pieces, STEPS[name], start=start, progress=False)
        start = result.snapshot()
        energy = float(result.energy[0]) if energy is None else energy
        worst = max(worst or 0.0, float(abs(result.energy - energy).max()))
        position, velocity, _ = result.violation.max(axis=0)
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        yield Piece(start.t, float(position), float(velocity), worst, memory)


def main() -> None:
    print(f"{'':14}{'t [s]':>6}  {'position':>9}  {'velocity':>9}  {'energy [J]':>10}  {'memory [MB]':>11}")
    for name in MECHANISMS:
        for piece in run(name, 1000.0, 10):
            print(
                f"{name:14}{piece.t:6.0f}  {piece.position:9.1e}  {piece.velocity:9.1e}  "
                f"{piece.energy_error:10.1e}  {piece.memory:11.1f}"
            )


if __name__ == "__main__":
    main()
