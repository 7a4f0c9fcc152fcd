"""Runs that go on where another one ended, to the last bit."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from typing import Any

import numpy as np

from linkwork.equations.assembly import Assembly
from linkwork.errors import warn
from linkwork.fingerprints import law, together
from linkwork.integrators import Integrator
from linkwork.modeling.model import Model
from linkwork.motion.records import Checkpoint, Resume, Snapshot
from linkwork.options import without_threads
from linkwork.running import callbacks
from linkwork.running.events import Watched, calls_of
from linkwork.running.returned import differing, left_by_a_run, note_left, text_of
from linkwork.running.written import Written

#: Of what the driver writes: another one is none of ours.
FORMAT = 8

#: After the digest: the initial state of the model had been corrected.
ASSEMBLED = "+assembled"


#: The integrator, where it is a function of the user's own, among names of what reads.
INTEGRATOR = "the integrator"


class Identity:
    """What tells a run from others: equal keys have runs whose steps are the same, whatever they record.

    It changes with what functions read: an event may change that, as the effort that a controller holds.
    """

    def __init__(
        self,
        model: Model,
        model_hash: str,
        method: Any,
        choices: Mapping[str, Any],
        events: Sequence[Watched],
        given: Mapping[str, Any],
        assembly: Assembly | None,
        written: Written | None = None,
    ) -> None:
        """`written`: by functions of the model."""
        self._model, self._method, self._events, self._written = model, method, events, written
        self._calls = [*model._calls, *calls_of(events)]
        self._others = {
            "format": FORMAT,
            "choices": {name: str(value) for name, value in sorted(without_threads(choices).items())},
            "breaks": np.ravel(given["breaks"]).astype(float).tolist(),
            "assemble": given["assemble"],
        }
        self.suffix = "" if assembly is None else ASSEMBLED
        self.model_hash = model_hash
        self._first_key = self._key(self.model_hash)
        self._changes = any(it.event.change for it in events) or not isinstance(method, Integrator)
        self._first = self.read() if self._changes else {}

    @property
    def key(self) -> str:
        """As the run began."""
        return self._first_key + self.suffix

    def checkpoint(self, t: float, state: bytes) -> Checkpoint:
        """With what functions read and return now, where others may have changed that."""
        found, written = self.read() if self._changes else {}, self._written
        changed = tuple((it, then, found[it]) for it, then in self._first.items() if found[it] != then)
        key = self._key(self._model.hash()) + self.suffix if changed else self.key
        differ = any(calls.differs for _, calls in self._calls)
        if not (found or differ or (written is not None and written.changed)):
            return Checkpoint(key, t, state, changed)
        note_left(self._calls, None if written is None else written.began)
        checkpoint = Checkpoint(key, t, state, changed, text_of(self._calls))
        remember = tuple(f"'{name}'" for name, calls in self._model._calls if calls.remembers)
        if written is None or not (unlike := written.changes.unlike_the_end):
            return checkpoint._replace(remember=remember)
        readers = [*((f"'{name}'", calls.function) for name, calls in self._model._calls),
                   *((f"event '{it.label}'", it.event.function) for it in self._events)]  # fmt: skip
        read = {name: found[name] for name, function in readers if written.changes.read_by(function)}
        return checkpoint._replace(unlike=unlike, read=tuple(read.items()), remember=remember)

    def differing(self, checkpoint: Checkpoint) -> list[str]:
        """Functions that are the same, and return something else than then. LinkworkWarning: nobody knows."""
        if checkpoint.method not in (self.key, self.key + ASSEMBLED):
            return []
        found = differing(self._calls, checkpoint.returned)
        warn_of_unknown("start: ", found.unknown)
        return [f"'{name}'" for name in found.names]

    def left_at_the_end(self, checkpoint: Checkpoint) -> list[str]:
        """Functions that read what they read at the end of that run, and not always in it."""
        now = self.read() if checkpoint.read else {}
        found = [name for name, end in checkpoint.read if now.get(name) == end]
        differ = self.differing(checkpoint) if checkpoint.remember else []
        return list(dict.fromkeys([*found, *(it for it in checkpoint.remember if it not in differ)]))

    def goes_on_from(self, checkpoint: Checkpoint) -> None:
        """What was changed in the runs before counts as changed."""
        self.suffix = ASSEMBLED if assembled(checkpoint.method) else self.suffix
        self._changes = self._changes or bool(checkpoint.changed)
        then = {name: then for name, then, _ in checkpoint.changed}
        self._first = (
            {name: then.get(name, now) for name, now in self.read().items()} if self._changes else {}
        )

    def read(self) -> dict[str, str]:
        """Digests of the functions with what they read; what they change themselves is left out."""
        found: dict[str, list[Any]] = {}
        with together():
            for name, calls in self._model._calls:
                found.setdefault(f"'{name}'", []).append(law(calls.function))
            for it in self._events:
                found.setdefault(f"event '{it.label}'", []).append(it.laws())
        if not isinstance(self._method, Integrator):
            found[INTEGRATOR] = [str(callbacks.contents({"": self._method}))]
        return {name: _digest(texts) for name, texts in found.items()}

    def warn_of_what_runs_left(self) -> None:
        """LinkworkWarning: functions read what they or an event have changed in a run before."""
        with self._written.began.as_then() if self._written else nullcontext():  # before the first call
            found = left_by_a_run(self._calls)
        warn_of_unknown("", found.unknown)
        if found.names:
            names = ", ".join(f"'{name}'" for name in found.names[:3])
            what = "reads what events have changed" if self._changes else "remembers what it has kept"
            warn(
                f"{names}: {what} in a run before, as it was at its end: set it anew before each run, or the "
                "second is another one"
            )

    def _key(self, model_hash: str) -> str:
        method = self._method
        events = [(it.label, it.compiled.signature, it.laws()) for it in self._events]
        of_method = repr(method) if isinstance(method, Integrator) else law(method)
        return _digest({**self._others, "model": model_hash, "method": of_method, "events": events})


def warn_of_unknown(start: str, names: Sequence[str]) -> None:
    """LinkworkWarning: nobody knows whether what these functions read is that of another run."""
    if names:
        listed = ", ".join(f"'{name}'" for name in names[:3])
        then = (
            "as at the end of the run that this one goes on from" if start else "set anew since the last run"
        )
        warn(
            f"{start}{listed}: reaches what cannot be looked into, so that it is not known whether what it "
            f"remembers is {then}: keep it in lists, dicts, arrays or attributes"
        )


def warn_of_later_changes(t: float, names: Sequence[str]) -> None:
    """LinkworkWarning: these functions read what was changed after t [s] in the run that this is of."""
    if names:
        warn(
            f"start: {', '.join(names[:3])}: reads what it or events have changed after t = {t:.6g} s, as it "
            "was at the end of that run: set it as it was at that time, or the motion is another one"
        )


def _digest(parts: object) -> str:
    return hashlib.blake2b(json.dumps(parts, sort_keys=True).encode(), digest_size=16).hexdigest()


def of(start: Snapshot | None, identity: Identity, t_end: float) -> Resume | None:
    """What a run can go on from; None: it begins anew at the start.

    It does where functions read something else at the start than at the checkpoint: steps from there on would
    be taken by that. LinkworkWarning: functions do not read what they read at the start.
    """
    if start is None or (start.resume is None and start.t == 0.0):
        identity.warn_of_what_runs_left()
        return None
    resume = start.resume
    if not isinstance(resume, Resume) or not start.t < t_end:
        return None
    checkpoint = resume.checkpoint
    if not checkpoint.state and (checkpoint.remember or checkpoint.is_unlike(start.t, start.t)):
        warn_of_later_changes(start.t, identity.left_at_the_end(checkpoint))
        return None
    if other := _others(checkpoint, identity):
        warn(
            f"start: {', '.join(other[:3])}: reads something else than at the end of the run that this one "
            "goes on from, where it, events or steps have changed that: set it as it was there, or the "
            "motion is another one"
        )
        return None
    try:
        fits = bool(checkpoint.state) and not checkpoint.is_unlike(checkpoint.t, start.t)
        fits = fits and checkpoint.method in (identity.key, identity.key + ASSEMBLED)
        fits = fits and resume.state == start.digest
    except (TypeError, ValueError):  # it is no state, which is told elsewhere
        return None
    if not fits:
        return None
    identity.goes_on_from(checkpoint)
    return resume


def _others(checkpoint: Checkpoint, identity: Identity) -> list[str]:
    """Functions that are as the run began that is gone on from, and not as at its end."""
    found = identity.read() if checkpoint.changed else {}
    began = [
        name
        for name, then, end in checkpoint.changed
        if (now := found.get(name, end)) != end and (now == then or name == INTEGRATOR)
    ]
    return began or identity.differing(checkpoint)


def assembled(key: str) -> bool:
    """Whether the initial state of the model had been corrected."""
    return key.endswith(ASSEMBLED)
