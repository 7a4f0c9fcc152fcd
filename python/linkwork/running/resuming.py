"""Runs that go on where another one ended, to the last bit."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from linkwork.equations.assembly import Assembly
from linkwork.fingerprints import law
from linkwork.integrators import Integrator
from linkwork.motion.records import Resume, Snapshot
from linkwork.options import without_threads
from linkwork.running.events import Watched

#: Of what the driver writes: another one is none of ours.
FORMAT = 4

#: After the digest: the initial state of the model had been corrected.
ASSEMBLED = "+assembled"


def key(
    model_hash: str,
    method: Any,
    choices: Mapping[str, Any],
    events: Sequence[Watched],
    given: Mapping[str, Any],
    assembly: Assembly | None,
) -> str:
    """Equal for runs whose steps are the same: of one model, by one method, whatever they record."""
    parts = {
        "format": FORMAT,
        "model": model_hash,
        "method": repr(method) if isinstance(method, Integrator) else law(method),
        "choices": {name: str(value) for name, value in sorted(without_threads(choices).items())},
        "events": [(it.label, it.compiled.signature, it.laws) for it in events],
        "breaks": np.ravel(given["breaks"]).astype(float).tolist(),
        "assemble": given["assemble"],
    }
    digest = hashlib.blake2b(json.dumps(parts).encode(), digest_size=16).hexdigest()
    return digest if assembly is None else digest + ASSEMBLED


def of(start: Snapshot | None, key: str, t_end: float) -> Resume | None:
    """What a run with this key can go on from; None: it begins anew at the start."""
    resume = None if start is None else start.resume
    if start is None or not isinstance(resume, Resume) or not start.t < t_end:
        return None
    try:
        fits = resume.checkpoint.method in (key, key + ASSEMBLED) and resume.state == start.digest
    except (TypeError, ValueError):  # it is no state, which is told elsewhere
        return None
    return resume if fits else None


def assembled(key: str) -> bool:
    """Whether the initial state of the model had been corrected."""
    return key.endswith(ASSEMBLED)
