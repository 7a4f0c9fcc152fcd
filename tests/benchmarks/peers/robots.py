"""Robots in linkwork and in MuJoCo, rotors included: first the accelerations, then the time.

python tests/benchmarks/peers/robots.py [--models arm:6,ant] [--rounds 9] [--seconds 0.05] [--json]

Models are arms of so many hinges about changing axes, each with a rotor, and the MJCF files of the package
gymnasium that linkwork takes. Both codes read the same file, and their accelerations are compared at random
states; `deviation` is the largest difference over the largest acceleration, marked ! beyond round-off: some
files have forces, noted at import, that linkwork does not.

Both are timed at one state in motion, on one thread, in turn in each round: linkwork's right-hand side with
the reactions of all joints, looped in compiled code, and mj_forward without contacts, constraints and
actuators, called past the Python bindings, less such a call that has nothing to do. Times are medians over
the rounds, and `x linkwork` is that of the ratios: above 1, linkwork is faster.
"""

# ruff: noqa: E402 (the environment comes before numpy)

from __future__ import annotations

import os

from comparison import THREADS, Row

os.environ.update(THREADS)

import argparse
import importlib.util
import json
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import linkwork as lw
import numpy as np
from mujoco_peer import native_forward
from operation import Batch, calls, typical
from report import table

sys.path.append(str(Path(__file__).parents[2] / "python"))

from mujoco_comparison import State, largest_difference

ARMS = (3, 6, 20)
ROUNDOFF = 1e-10
SPREAD = 0.3  #: of the random states [m, rad, and of their rates]

HINGE = '<joint type="hinge" axis="{axis}" armature="0.3"/>'
LINK = '<inertial pos="0.5 0 0" mass="{mass}" diaginertia="0.02 0.1 0.12"/>'
AXES = ("0 0 1", "0 1 0", "1 0.2 0")


def arm(hinges: int) -> str:
    """MJCF of links of 1 m, each on the one before it."""
    text = ""
    for k in reversed(range(hinges)):
        parts = HINGE.format(axis=AXES[k % 3]) + LINK.format(mass=1 + 0.3 * k)
        text = f'<body name="link {k}" pos="{1 if k else 0} 0 0">{parts}{text}</body>'
    return f'<mujoco model="arm of {hinges}"><worldbody>{text}</worldbody></mujoco>'


def robots() -> dict[str, Path]:
    """Of gymnasium, where it is installed; those that linkwork takes."""
    found = importlib.util.find_spec("gymnasium")
    if not found or not found.origin:
        return {}
    files = sorted((Path(found.origin).parent / "envs/mujoco/assets").glob("*.xml"))
    return {file.stem: file for file in files if taken(file)}


def taken(file: Path) -> bool:
    try:
        lw.import_mjcf(file)
    except lw.ModelFileError:
        return False
    return True


def deviation(file: Path) -> float:
    return max(largest_difference(file, np.random.default_rng(seed), SPREAD) for seed in range(3))


def batches(file: Path) -> tuple[Batch, Batch, int]:
    """Of linkwork and of MuJoCo, at the same state; and how many bodies there are."""
    state = State(file, np.random.default_rng(0), SPREAD)
    state.move_scalars()
    model = lw.import_mjcf(
        file, coordinates=state.coordinates, velocities=state.velocities, couple=False
    ).model
    system = lw.System(model, threads=1)
    core, y = system.compiled(), system.initial_state()

    def batch(count: int) -> float:
        begun = time.process_time()
        core.repeat_right_hand_side(0.0, y, count)
        return time.process_time() - begun

    forward, nothing = native_forward(state.model, state.data)
    whole, empty = calls(forward), calls(nothing)

    def native_batch(count: int, _held: State = state) -> float:
        return whole(count) - empty(count)

    return batch, native_batch, model.body_count


def compare(name: str, file: Path, rounds: int, seconds: float) -> list[Row]:
    """A row of each code."""
    ours, theirs, bodies = batches(file)
    rows = [
        Row(name, "linkwork", "rhs", bodies, counterpart="rhs", note="with reactions"),
        Row(name, "mujoco", "mj_forward", bodies, counterpart="rhs", deviation=deviation(file),
            tolerance=ROUNDOFF),
    ]  # fmt: skip
    for number in range(rounds):
        times = [typical(batch, seconds) for batch in (ours, theirs)]
        for row, taken_time in zip(rows, times, strict=True):
            row.rounds[number] = taken_time
            row.ratios.append(taken_time / times[0])
    return rows


def main() -> None:
    arguments = _arguments()
    if not arguments.json:
        print(f"load {os.getloadavg()[0]:.1f}; {arguments.rounds} rounds\n")
    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as folder:
        for name, file in _files(arguments.models, Path(folder)):
            found = compare(name, file, arguments.rounds, arguments.seconds)
            rows += found
            if not arguments.json:
                print(table(found), flush=True)
    if arguments.json:
        print(json.dumps([row.as_dict() for row in rows], indent=1))
        return
    for row in rows:
        if row.peer == "mujoco":
            print(f"{row.model}: mujoco mj_forward / linkwork rhs = {row.ratio:.2f}")


def _files(words: str, folder: Path) -> Iterator[tuple[str, Path]]:
    """Those that are named, or all."""
    known = robots()
    for word in words.split(",") if words else [*(f"arm:{hinges}" for hinges in ARMS), *known]:
        name, _, hinges = word.partition(":")
        if name == "arm" and hinges.isdecimal() and int(hinges) > 0:
            file = folder / f"arm_{hinges}.xml"
            file.write_text(arm(int(hinges)))
            yield word, file
        elif word in known:
            yield word, known[word]
        else:
            sys.exit(f"no model '{word}'; there are arm:6 and the like, {', '.join(known)}")


def _arguments() -> argparse.Namespace:
    description, _, details = (__doc__ or "").partition("\n")
    parser = argparse.ArgumentParser(
        description=description, epilog=details, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--models", default="", help="such as arm:6,ant (all)")
    parser.add_argument("--rounds", type=int, default=9, help="of which medians are taken (9)")
    parser.add_argument("--seconds", type=float, default=0.05, help="that each is timed in a round (0.05)")
    parser.add_argument("--json", action="store_true", help="numbers for machines")
    return parser.parse_args()


if __name__ == "__main__":
    main()
