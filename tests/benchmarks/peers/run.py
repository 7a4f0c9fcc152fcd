"""The same mechanisms in linkwork, Pinocchio, MuJoCo and Exudyn: first the physics, then the time.

python tests/benchmarks/peers/run.py [--models chain,ladder:100] [--peers mujoco] [--rounds 5] [--json]

Every peer builds the mechanism from the same numbers, those of the linkwork model 20 ms into its motion, and
its accelerations there are compared with linkwork's: `deviation` is the largest difference over the largest
acceleration, marked ! where it is beyond the tolerance that is stated for the peer's formulation (MuJoCo's
soft constraints add up in a large net). Steps, of 1 ms, are compared by the mean acceleration over ten of
them.

Then it is timed, in processor time. In each round every peer runs in turn, in a process of its own with one
thread; the table has medians over the rounds, and the ratio to linkwork's counterpart in the same round:
above 1, linkwork is faster. Evaluations of the others are called from Python, less what a call takes that
has nothing to do; those of linkwork, and all steps beyond the first few, are looped in compiled code.

  linkwork   rhs: accelerations and reactions, as in a stage of its integrators; steps of its driver
  pinocchio  aba, without reactions; constraintDynamics and lcaba, proximal
  mujoco     mj_forward from a cold start; mj_step in motion, warm
  exudyn     a step of its implicit solver, and what the first takes; of an explicit one for open chains
"""

# ruff: noqa: E402 (the environment comes before numpy)

from __future__ import annotations

import os

from comparison import THREADS, Comparison, Row

os.environ.update(THREADS)

import argparse
import json
import platform
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import linkwork as lw
from linkwork_peer import describe
from report import Target, table

PACKAGES = {"linkwork": "linkwork", "pinocchio": "pin", "mujoco": "mujoco", "exudyn": "exudyn"}

#: Mechanisms of linkwork, and the sizes that are compared.
MODELS: Mapping[str, tuple[str, Sequence[int]]] = {
    "chain": ("chain", (100, 200, 400, 1000)),
    "ladder": ("four_bar", (100, 1000)),
    "bricard": ("bricard", ()),
    "net": ("net", (10, 30, 100)),
}

FREE, TREE = "mj_forward free bodies", "mj_forward tree"
TARGETS = (
    *(Target(f"chain:{bodies}", "pinocchio", "aba", 1.25) for bodies in (100, 200, 400)),
    Target("chain:1000", "mujoco", FREE, 6.0),
    Target("ladder:1000", "mujoco", TREE, 1.0),
    Target("ladder:1000", "mujoco", FREE, 6.0),
    Target("ladder:1000", "exudyn", "generalized alpha step", 6.0),
    Target("bricard", "pinocchio", "lcaba", None),
    Target("bricard", "mujoco", TREE, None),
    Target("net:30", "mujoco", FREE, None),
    Target("net:100", "exudyn", "generalized alpha first step", None),
)


def main() -> int:
    """1 where a target is missed."""
    arguments = _arguments()
    versions = _versions(arguments.peers)
    peers = [peer for peer, found in versions.items() if found]
    for peer in versions.keys() - set(peers):
        _say(f"{peer} is not installed and left out: pip install '{PACKAGES[peer]}', or 'linkwork[bench]'")
    machine = {"processor": _processor(), "load": os.getloadavg()[0], "python": platform.python_version()}
    if not arguments.json:
        print(*(f"{peer} {versions[peer]}" for peer in peers), sep=", ")
        print(f"{machine['processor']}, load {machine['load']:.1f}; {arguments.rounds} rounds\n")

    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as folder:
        for model in arguments.models:
            try:
                found = _compare(model, peers, arguments, Path(folder))
            except lw.LinkworkError as error:
                sys.exit(f"{model}: {error}")
            rows += found
            if not arguments.json:
                print(table(found), flush=True)

    targets = [
        target for target in TARGETS if target.model in arguments.models and target.peer in arguments.peers
    ]
    if arguments.json:
        results = {"rows": [row.as_dict() for row in rows], "targets": [t.as_dict(rows) for t in targets]}
        print(json.dumps({"versions": versions, **machine, "rounds": arguments.rounds, **results}, indent=1))
    else:
        print(*(target.line(rows) for target in targets), sep="\n")
    return 1 if any(target.met(rows) is False for target in targets) else 0


def _compare(model: str, peers: Sequence[str], arguments: argparse.Namespace, folder: Path) -> list[Row]:
    _say(f"{model}: simulated")
    name, _, size = model.partition(":")
    known = lw.mechanisms.MECHANISMS[MODELS[name][0]]
    formulation = arguments.formulation or known.settings.get("formulation", "standard")
    mechanism = describe(known.function(*([int(size)] if size else [])), model, formulation)
    file = folder / f"{model.replace(':', '_')}.npz"
    mechanism.save(file)
    limits = (arguments.seconds, arguments.memory, arguments.limit)
    comparison = Comparison(model, mechanism.body_count, file, peers, *limits)
    return comparison.run(arguments.rounds, _say)


def _say(text: str) -> None:
    """One line on a terminal, over the last one."""
    if sys.stderr.isatty():
        print(f"\r\033[K{text}", end="", file=sys.stderr, flush=True)


def _versions(peers: Sequence[str]) -> dict[str, str | None]:
    def installed(package: str) -> str | None:
        try:
            return version(package)
        except PackageNotFoundError:
            return None

    return {peer: installed(PACKAGES[peer]) for peer in ("linkwork", *peers)}


def _models(words: str) -> Iterator[str]:
    """chain -> chain:100, chain:200, ...; chain:50 as it is. ValueError: no such model or size."""
    for word in words.split(","):
        name, _, size = word.partition(":")
        if name not in MODELS or (size and not (MODELS[name][1] and size.isdecimal())):
            raise ValueError(f"no model '{word}'; there are {', '.join(MODELS)}, with a size as in chain:50")
        sizes = [size] if size else [str(size) for size in MODELS[name][1]]
        yield from (f"{name}:{size}" for size in sizes) if sizes else [name]


def _arguments() -> argparse.Namespace:
    description, _, details = (__doc__ or "").partition("\n")
    parser = argparse.ArgumentParser(
        description=description, epilog=details, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    others = [peer for peer in PACKAGES if peer != "linkwork"]
    parser.add_argument("--models", default=",".join(MODELS), help="such as chain,ladder:100 (all)")
    parser.add_argument("--peers", default=",".join(others), help="such as mujoco,exudyn (all)")
    parser.add_argument("--rounds", type=int, default=5, help="of which medians are taken (5)")
    parser.add_argument(
        "--seconds", type=float, default=0.3, help="that an operation is timed in a round (0.3)"
    )
    parser.add_argument("--memory", type=float, default=8.0, help="that a peer may use [GiB] (8)")
    parser.add_argument("--limit", type=int, default=200, help="that an operation may take in all [s] (200)")
    parser.add_argument("--formulation", help="of linkwork; without: as recommended for each mechanism")
    parser.add_argument("--json", action="store_true", help="numbers for machines")
    arguments = parser.parse_args()
    try:
        arguments.models = list(_models(arguments.models))
    except ValueError as error:
        parser.error(str(error))
    arguments.peers = arguments.peers.split(",")
    for peer in arguments.peers:
        if peer not in others:
            parser.error(f"no peer '{peer}'; there are {', '.join(others)}")
    if arguments.rounds < 1 or arguments.seconds <= 0 or arguments.memory <= 0 or arguments.limit < 1:
        parser.error("--rounds, --seconds, --memory and --limit must be positive")
    return arguments


def _processor() -> str:
    try:
        with open("/proc/cpuinfo") as lines:
            return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor()


if __name__ == "__main__":
    sys.exit(main())
