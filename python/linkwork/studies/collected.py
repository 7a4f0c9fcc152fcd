"""What becomes of the cases of a study, in columns as they come: each takes little more than its outputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.errors import warn
from linkwork.running.estimation import of_memory
from linkwork.studies.cases import Case, Run
from linkwork.studies.sampling import Cases

__all__ = ["Collected", "Todo"]

NOTHING, FINISHED, FAILED = 0, 1, 2

Shapes = Mapping[str, tuple[int, ...]]


class Collected:
    """By key; cases with the same key are one.

    Outputs of a function may differ in shape from case to case: those unlike the first case are failures.
    """

    def __init__(self, keys: Sequence[str]) -> None:
        self._first: dict[str, int] = {}
        numbers = (self._first.setdefault(key, k) for k, key in enumerate(keys))
        self._place = np.fromiter(numbers, dtype=np.int64, count=len(keys))
        self._state = np.full(len(keys), NOTHING, dtype=np.int8)
        self._seconds, self._accuracy = (np.full(len(keys), np.nan) for _ in range(2))
        self._level = np.zeros(len(keys), dtype="<U6")
        self._unstable: dict[int, float] = {}  # where that is known
        self._memory: list[str] = []
        self._errors: dict[int, Mapping[str, Any]] = {}
        self._remarks: dict[int, str] = {}
        self._texts: dict[str, str] = {}  # of remarks, which many cases share
        self._outputs: dict[str, Floats] = {}
        self._others: dict[int, Mapping[str, Any]] = {}  # outputs of other shapes than those that came first

    def __contains__(self, key: object) -> bool:
        return bool(self._state[self._first[str(key)]] != NOTHING)

    @property
    def done(self) -> int:
        """Cases of which something is known."""
        return self.alike(np.flatnonzero(self._state != NOTHING))

    def alike(self, numbers: NDArray[np.int64]) -> int:
        """Cases that have the keys of these, of which each is the first with its key."""
        return int(np.bincount(self._place)[numbers].sum())

    def warn_of_memory(self) -> None:
        """LinkworkWarning: functions of the user's remember calls, also those of other cases."""
        if self._memory:
            warn(of_memory(self._memory))

    def wants(self, run: Run) -> bool:
        """Whether it is of a case of the study of which no more is known: one that failed may have been tried
        again."""
        if run.key not in self._first:
            return False
        state = self._state[self._first[run.key]]
        return bool(state == NOTHING or (state == FAILED and run.status == "finished"))

    def forget_failed(self, shard: tuple[int, int] | None) -> None:
        """As if nobody had run those of this shard."""
        k, n = _share(shard)
        for place in np.flatnonzero(self._state == FAILED).tolist():
            if place % n == k:
                self._state[place] = NOTHING
                self._clear(place)

    def _clear(self, k: int) -> None:
        self._errors.pop(k, None)
        self._remarks.pop(k, None)
        self._unstable.pop(k, None)
        self._seconds[k], self._accuracy[k], self._level[k] = np.nan, np.nan, ""

    def add(self, run: Run) -> None:
        k = self._first[run.key]
        self._clear(k)
        self._state[k] = FINISHED if run.status == "finished" else FAILED
        self._seconds[k] = run.seconds
        self._accuracy[k] = run.verdict.get("error", np.nan)
        self._level[k] = run.verdict.get("level", "")
        if "unstable" in run.verdict:
            self._unstable[k] = run.verdict["unstable"]
        self._memory += [name for name in run.verdict.get("memory", ()) if name not in self._memory]
        if run.error:
            self._errors[k] = run.error
        if run.remarks:
            self._remarks[k] = self._texts.setdefault(run.remarks, run.remarks)
        if run.status == "finished":
            self._keep(k, run.outputs)

    def _keep(self, k: int, outputs: Mapping[str, Any]) -> None:
        if not self._outputs:
            self._outputs = self._columns(_shapes(outputs))
        if _shapes(outputs) != self._kept_shapes():
            self._others[k] = outputs
            return
        for label, value in outputs.items():
            self._outputs[label][k] = value

    def _columns(self, shapes: Shapes) -> dict[str, Floats]:
        return {label: np.full((len(self._state), *shape), np.nan) for label, shape in shapes.items()}

    def _kept_shapes(self) -> Shapes:
        return {label: column.shape[1:] for label, column in self._outputs.items()}

    def _settle(self) -> None:
        """The shapes of the first case count, whichever came first."""
        if not self._others:
            return
        first = int(np.flatnonzero(self._state == FINISHED)[0])
        kept = self._kept_shapes()
        found: dict[int, Shapes] = {k: _shapes(it) for k, it in self._others.items()}
        if first in found:
            for place in np.flatnonzero(self._state == FINISHED).tolist():
                found.setdefault(place, kept)
            self._outputs = self._columns(found[first])
            for k, outputs in self._others.items():
                if found[k] == found[first]:
                    for label, value in outputs.items():
                        self._outputs[label][k] = value
        usual = found.get(first, kept)
        for k, shapes in found.items():
            if shapes != usual:
                self._refuse(k, shapes, usual)
        self._others = {}

    def _refuse(self, k: int, shapes: Shapes, usual: Shapes) -> None:
        label = next(label for label in shapes if shapes[label] != usual[label])
        message = f"output '{label}' has shape {shapes[label]}, not {usual[label]} as in the first case"
        self._errors[k] = {"type": "OptionError", "code": "shape", "message": message, "reached": None}
        self._state[k], self._accuracy[k], self._level[k] = FAILED, np.nan, ""

    # --- case by case, at the end ---

    def outputs(self, labels: Mapping[str, tuple[int, ...]]) -> dict[str, Floats]:
        """(n, ...) of each label; of a shape that nobody knows as it is given."""
        self._settle()
        usual = self._columns({label: shape for label, shape in labels.items() if label not in self._outputs})
        found = {**self._outputs, **usual}
        return {label: self._each(found[label]) for label in labels}

    def _each(self, column: NDArray[Any]) -> NDArray[Any]:
        """No copy where every case has a key of its own."""
        return column if len(self._first) == len(self._place) else column[self._place]

    def status(self, lost: Mapping[str, str], keys: Sequence[str]) -> NDArray[np.str_]:
        self._settle()
        names = np.array(["skipped", "finished", "failed"])[self._each(self._state)]
        for k, key in enumerate(keys if lost else ()):
            if names[k] == "skipped" and key in lost:
                names[k] = "failed"
        return np.asarray(names)

    def errors(self, lost: Mapping[str, str], keys: Sequence[str]) -> dict[int, Mapping[str, Any]]:
        self._settle()
        found = self._of_each(self._errors)
        for k, key in enumerate(keys if lost else ()):
            if self._state[self._place[k]] == NOTHING and key in lost:
                found[k] = {"type": "Lost", "code": "lost", "message": lost[key], "reached": None}
        return dict(sorted(found.items()))

    def remarks(self) -> dict[int, str]:
        return self._of_each(self._remarks)

    def _of_each(self, found: Mapping[int, Any]) -> dict[int, Any]:
        if not found:
            return {}
        there = np.flatnonzero(np.isin(self._place, np.fromiter(found, dtype=np.int64)))
        return {int(k): found[int(self._place[k])] for k in there}

    @property
    def seconds(self) -> Floats:
        return self._each(self._seconds)

    @property
    def accuracy(self) -> Floats:
        return self._each(self._accuracy)

    @property
    def unstable(self) -> Floats:
        """NaN where that is not known."""
        found = np.full(len(self._state), np.nan)
        for k, growth in self._unstable.items():
            found[k] = growth
        return self._each(found)

    @property
    def level(self) -> NDArray[np.str_]:
        return self._each(self._level)


def _share(shard: tuple[int, int] | None) -> tuple[int, int]:
    """Of (k, n) every nth, from the kth on; all without."""
    return (0, 1) if shard is None else (shard[0] % shard[1], shard[1])


def _shapes(outputs: Mapping[str, Any]) -> Shapes:
    return {label: np.shape(value) for label, value in outputs.items()}


class Todo(Sequence[Case]):
    """Cases that are made when they are asked for: of many a study holds no more than their numbers."""

    def __init__(self, cases: Cases, keys: Sequence[str], numbers: NDArray[np.int64]) -> None:
        self._cases, self._keys, self.numbers = cases, keys, numbers

    @classmethod
    def of(cls, cases: Cases, keys: Sequence[str], found: Collected, shard: tuple[int, int] | None) -> Todo:
        """Each key once, of this shard, of which nothing is known."""
        k, n = _share(shard)
        seen: set[str] = set()
        numbers = []
        for number, key in enumerate(keys):
            if key in seen:
                continue
            seen.add(key)
            if number % n == k and key not in found:
                numbers.append(number)
        return cls(cases, keys, np.array(numbers, dtype=np.int64))

    def __len__(self) -> int:
        return len(self.numbers)

    @overload
    def __getitem__(self, place: int) -> Case: ...
    @overload
    def __getitem__(self, place: slice) -> Todo: ...
    def __getitem__(self, place: int | slice) -> Case | Todo:
        if isinstance(place, slice):
            return Todo(self._cases, self._keys, self.numbers[place])
        number = int(self.numbers[place])
        return Case(number, self._keys[number], self._cases.case(number))
