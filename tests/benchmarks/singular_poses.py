"""Every method through singular poses: the worst of many runs, beside what is asked for.

python tests/benchmarks/singular_poses.py [--runs 200] [--few 20] [--only NAME ...] [--seed 7] [--json FILE]

Seven mechanisms (planar_branches.py) with random initial speeds, and with starts from which a pose falls
within 1e-12 .. 1e-6 s of the end or a stage of a step; steps of 1e-3 .. 1e-5 s, tolerances 1e-6 .. 1e-12.
Errors are those of the total energy, relative to the largest kinetic energy, and of positions, relative to
the size of the mechanism, against the motion along the same branch in minimal coordinates. Positions may be
ten times as far off as by the same method (Runge-Kutta at 1e-3 s, a pair of the same order at the tolerance)
in minimal coordinates, or as far as the energy. Motions that turn beside an unstable equilibrium multiply
any error by hundreds or thousands: where that is not enough, they may be as far off as the exact motion whose
energy is off at the start by what is asked of the energy. The table counts these runs as "unstable".
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import warnings
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass
from typing import Any

import linkwork as lw
import numpy as np
from numpy.typing import NDArray
from planar_branches import BRANCHES, Branch
from scipy.integrate import solve_ivp

Array = NDArray[np.float64]
METHODS: dict[str, dict[str, Any]] = {
    "default": {},
    "penalty": {"formulation": "penalty"},
    "schur": {"matrix_form": "schur"},
    "cholmod": {"linear_solver": "cholmod"},
    "augmented_lagrangian": {"formulation": "augmented_lagrangian"},
    "projection": {"stabilization": "projection"},
    "hem4": {"integrator": "hem4", "stabilization": "projection"},
    "phem56": {"integrator": "phem56", "stabilization": "projection"},
    "dopri5": {"integrator": "dopri5"},
    "tsit5": {"integrator": "tsit5"},
    "dop853": {"integrator": "dop853"},
}
OFTEN = ("default", "penalty", "dopri5")
ADAPTIVE = ("dopri5", "tsit5", "dop853")
STEPS = {1e-3: 1.0, 1e-4: 1.0, 1e-5: 0.4}  # and how much of the usual time [s]
TOLERANCES = (1e-6, 1e-8, 1e-10, 1e-12)
ENERGY = {1e-3: 1e-6, 1e-4: 1e-7, 1e-5: 1e-8}
OFFSETS = (0.0, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6)  # s


def allowed(method: str, size: float) -> float:
    return max(100 * size, 1e-10) if method in ADAPTIVE else ENERGY[size]


@dataclass(frozen=True)
class Case:
    """One run: its step [s] or tolerance, and when the first pose is passed [s]."""

    branch: str
    method: str
    size: float
    speed: float
    pose_at: float
    t_end: float
    seed: int


@dataclass(frozen=True)
class Found:
    case: Case
    energy: float = np.inf
    position: float = np.inf
    reference: float = 0.0  # the same in minimal coordinates
    sensitivity: float = 0.0  # of the exact motion to the energy, where it is needed
    violation: float = np.inf
    crossings: int = 0
    expected: int = 0
    steps: int = 0
    failure: str = ""

    @property
    def right(self) -> bool:
        bound = allowed(self.case.method, self.case.size)
        near = self.position <= max(10 * self.reference, bound, self.sensitivity)
        return self.energy <= bound and near and self.crossings == self.expected


def cases(runs: int, few: int, branches: list[str], methods: list[str], seed: int = 7) -> Iterator[Case]:
    for method in methods:
        for size in TOLERANCES if method in ADAPTIVE else STEPS:
            for name in branches:
                count = runs if method in OFTEN else few
                if size == 1e-5:
                    count = max(2, count // 10)
                rng = np.random.default_rng([len(method), len(name), seed])
                for k in range(count):
                    yield one_case(BRANCHES[name], method, size, k, rng)


def one_case(
    branch: Branch, method: str, size: float, k: int, rng: np.random.Generator, share: float | None = None
) -> Case:
    """`share` of the usual time; None: that of STEPS."""
    speed = float(rng.uniform(*branch.speed) * rng.choice((-1, 1)))
    fixed = method not in ADAPTIVE
    duration = (share or STEPS.get(size, 1.0)) * 3.0 / max(abs(speed) / 4.0, 0.5)
    pose_at = float(rng.uniform(0.1, 0.4) * duration)
    if fixed and k % 2 == 1:  # a pose at the end or in the middle of a step
        place = round(pose_at / size) + 0.5 * ((k // 2) % 2)
        pose_at = place * size + OFFSETS[(k // 8) % len(OFFSETS)] * (1 if (k // 4) % 2 else -1)
    t_end = round(duration / 1e-3) * 1e-3
    return Case(branch.name, method, size, speed, pose_at, t_end, k)


def run(case: Case, always: bool = True) -> Found:
    """`always`: with the error of the reference also where none is needed to say that positions are right."""
    branch = BRANCHES[case.branch]
    at_pose = np.array([branch.singular, case.speed, 0.0, 1.1])[: 4 if branch.turntable is not None else 2]
    start = branch.flow(at_pose, np.array([-case.pose_at]))[-1]
    if branch.turntable is not None:
        start[2] = 0.0
    times = np.linspace(0.0, case.t_end, 31)
    options = dict(METHODS[case.method])
    if case.method in ADAPTIVE:
        options |= {"rtol": case.size, "atol": case.size, "times": times}
    else:
        options |= {"step": case.size, "record_every": max(1, round(case.t_end / 30 / case.size))}
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            result = lw.simulate(branch.model(start), case.t_end, progress=False, **options)
    except lw.LinkworkError as error:
        return Found(case, failure=f"{type(error).__name__}: {error}")
    exact, turns = branch.flow_and_turns(start, result.t)
    energies = np.array([branch.energy(state) for state in exact])
    first = 1 if branch.turntable is not None else 0
    off = result.position[:, first:] - branch.positions(exact)
    energy = result.energy_error / energies[:, 0].max()
    position = float(np.abs(off).max() / branch.size)
    near = position <= allowed(case.method, case.size)
    reference = reference_error(branch, case, start, result.t, exact) if always or not near else 0.0
    unstable = not near and position > 10 * reference
    return Found(
        case,
        float(np.abs(energy).max()),
        position,
        reference,
        sensitivity(branch, case, start, result.t, exact) if unstable else 0.0,
        float(result.violation[:, :2].max()),
        int(result.statistics["singular_poses"]),
        crossings(branch, np.array([start[0], *turns, exact[-1, 0]])),
        int(result.statistics["steps"] + result.statistics.get("rejected_steps", 0)),
    )


def reference_error(branch: Branch, case: Case, start: Array, times: Array, exact: Array) -> float:
    """Of positions, by a method of the same order in minimal coordinates, relative to the size."""
    if case.method in ADAPTIVE:
        pair = "DOP853" if case.method == "dop853" else "RK45"
        rtol = max(case.size, 1e-13)
        states = solve_ivp(branch.rates, (0, times[-1]), start, pair, times, rtol=rtol, atol=case.size).y.T
    elif case.size == 1e-3:
        states = runge_kutta(branch, start, case.size, np.round(times / case.size).astype(int))
    else:
        return 0.0
    return float(np.abs(branch.positions(states) - branch.positions(exact)).max() / branch.size)


def sensitivity(branch: Branch, case: Case, start: Array, times: Array, exact: Array) -> float:
    """Of positions, when the energy at the start is off by what is asked of it, relative to the size."""
    asked = allowed(case.method, case.size)
    kinetic = [branch.energy(state)[0] for state in exact]
    other = start.copy()
    other[1] *= np.sqrt(1.0 + asked * max(kinetic) / kinetic[0])
    return float(
        np.abs(branch.positions(branch.flow(other, times)) - branch.positions(exact)).max() / branch.size
    )


def runge_kutta(branch: Branch, start: Array, h: float, steps: NDArray[np.int_]) -> Array:
    """States after so many steps of the classical method."""
    out, y = [], start
    for n in range(steps[-1] + 1):
        if n in steps:
            out.append(y)
        k_1 = branch.rates(0.0, y)
        k_2 = branch.rates(0.0, y + 0.5 * h * k_1)
        k_3 = branch.rates(0.0, y + 0.5 * h * k_2)
        k_4 = branch.rates(0.0, y + h * k_3)
        y = y + h / 6 * (k_1 + 2 * k_2 + 2 * k_3 + k_4)
    return np.array(out)


def crossings(branch: Branch, s: Array) -> int:
    """How often a motion passes a singular value, which grows or falls from each of these s to the next."""
    return int(np.abs(np.diff(np.floor((s - branch.singular) / branch.period))).sum())


def table(found: list[Found]) -> str:
    lines = [f"{'method':22}{'step/rtol':>10}{'mechanism':>20}{'runs':>6}{'median':>10}{'worst dE':>10}"
             f"{'asked':>9}"
             f"{'worst x':>10}{'of ref.':>9}{'violation':>11}{'listed':>8}"
             f"{'unstable':>10}{'failed':>8}"]  # fmt: skip
    groups: dict[tuple[str, float, str], list[Found]] = {}
    for it in found:
        groups.setdefault((it.case.method, it.case.size, it.case.branch), []).append(it)
    for (method, size, branch), group in groups.items():
        energy = [it.energy for it in group]
        listed = sum(it.crossings == it.expected for it in group)
        failed, unstable = sum(not it.right for it in group), sum(it.sensitivity > 0.0 for it in group)
        ratio = max(it.position / it.reference if it.reference else 0.0 for it in group)
        lines.append(
            f"{method:22}{size:10.0e}{branch:>20}{len(group):6}{np.median(energy):10.1e}{max(energy):10.1e}"
            f"{allowed(method, size):9.0e}{max(it.position for it in group):10.1e}"
            f"{ratio:9.1f}{max(it.violation for it in group):11.1e}{listed:8}{unstable:10}{failed:8}"
        )
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--runs", type=int, default=200, help="of default, penalty and dopri5")
    parser.add_argument("--few", type=int, default=20, help="of the others")
    parser.add_argument("--only", nargs="*", default=[], help="mechanisms or methods")
    parser.add_argument("--seed", type=int, default=7, help="of the initial speeds")
    parser.add_argument("--json", help="write every run to this file")
    given = parser.parse_args()
    branches = [name for name in BRANCHES if name in given.only] or list(BRANCHES)
    methods = [name for name in METHODS if name in given.only] or list(METHODS)
    work = list(cases(given.runs, given.few, branches, methods, given.seed))
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        found = []
        for it in pool.map(run, work, chunksize=8):
            found.append(it)
            print(f"\r{len(found)} of {len(work)} runs", end="", file=sys.stderr)
    print(file=sys.stderr)
    print(table(found))
    wrong = [it for it in found if not it.right]
    print(f"{len(found)} runs, {len(wrong)} not as asked")
    for it in wrong[:20]:
        print(it)
    if given.json:
        with open(given.json, "w") as file:
            json.dump([asdict(it) for it in found], file)


if __name__ == "__main__":
    main()
