"""Digests of short deterministic runs: `python deterministic_bits.py NAME...` prints them as JSON.

Mechanisms are built by numpy and the C library, whose last bits are those of the processor: what is run here
is their text, rounded. To make all anew: `python deterministic_bits.py > deterministic_bits.json`.
"""

from __future__ import annotations

import hashlib
import json
import sys
import tempfile
import warnings
from pathlib import Path
from typing import Any

import linkwork as lw
from linkwork import integrators, mechanisms
from linkwork.running.estimation import unjudged

FORMULATIONS = ("standard", "penalty", "augmented_lagrangian")
ONE_STEP = [name for name in integrators.METHODS if not name.startswith("ab")]
STEPS = 5
SMALLER = {
    "tracked_chain": {"shoes": 40}, "net": {"n": 5}, "hub_net": {"n": 3}, "capture_net": {"n": 3},
    "hexagonal_net": {"rings": 2}, "lattice": {"n": 2}, "rope": {"links": 20},
    "scissors": {"arms": 2, "units": 3}, "tracked_vehicle": {"shoes": 60},
}  # fmt: skip

#: Numbers of a model are rounded to so many digits, and to zero below this.
DIGITS, NOTHING = 11, 1e-13

Listed = sorted(mechanisms.MECHANISMS)


def rounded(tree: Any) -> Any:
    if isinstance(tree, dict):
        return {key: rounded(value) for key, value in tree.items()}
    if isinstance(tree, list):
        return [rounded(value) for value in tree]
    if isinstance(tree, float):
        return float(f"{tree:.{DIGITS}g}") if abs(tree) > NOTHING else 0.0
    return tree


def model(name: str) -> lw.Model:
    whole = mechanisms.MECHANISMS[name].function(**SMALLER.get(name, {}))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "model.json"
        whole.save(path)
        path.write_text(json.dumps(rounded(json.loads(path.read_text()))))
        return lw.Model.load(path)


def run(it: lw.Model, settings: dict[str, Any]) -> bytes:
    """The bits of the frames; the code of the error where a method cannot run this mechanism."""
    try:
        found = lw.simulate(it, **settings, deterministic=True, progress=False, on_inaccurate="pass")
    except lw.LinkworkError as error:
        return error.code.encode()
    return b"".join(found.recorded(name).tobytes() for name in ("t", "q", "v", "vdot", "lambda"))


def digest(name: str) -> str:
    """Over all formulations and integrators."""
    it, found = model(name), hashlib.sha256()
    step = float(mechanisms.MECHANISMS[name].settings.get("step") or 1e-3)
    with unjudged():  # which would take ten times as long as such a run, and changes none of its bits
        for formulation in FORMULATIONS:
            for integrator in ONE_STEP:
                settings = {"t_end": STEPS * step, "step": step, "record_every": 1}
                found.update(run(it, {**settings, "integrator": integrator, "formulation": formulation}))
            adaptive = {"t_end": STEPS * step, "rtol": 1e-6, "record_every": 1, "formulation": formulation}
            found.update(run(it, adaptive))
    return found.hexdigest()[:32]


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    print(json.dumps({name: digest(name) for name in sys.argv[1:] or Listed}, indent=1))
