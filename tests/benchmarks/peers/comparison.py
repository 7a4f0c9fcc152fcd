"""One mechanism, all peers: in each round every peer in turn, in a process of its own."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from statistics import median
from typing import Any

WORKER = Path(__file__).parent / "worker.py"
THREADS = {f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL", "VECLIB")}

SLOW = 20.0  #: an operation that takes longer in all is measured in the first round only [s]


@dataclass
class Row:
    """An operation of a peer on a model, over the rounds."""

    model: str
    peer: str
    operation: str
    bodies: int
    rounds: dict[int, float] = field(default_factory=dict)  # seconds of a call, by round
    ratios: list[float] = field(default_factory=list)  # to the counterpart in the same round
    counterpart: str = ""
    deviation: float | None = None
    tolerance: float = 0.0
    note: str = ""
    failure: str = ""
    finished: bool = False  # in no further round

    @property
    def seconds(self) -> float:
        return median(self.rounds.values())

    @property
    def ratio(self) -> float | None:
        return median(self.ratios) if self.ratios else None

    @property
    def spread(self) -> float:
        """Of the rounds: largest less smallest, over the median."""
        return (max(self.rounds.values()) - min(self.rounds.values())) / self.seconds

    @property
    def agrees(self) -> bool:
        return self.deviation is None or self.deviation <= self.tolerance

    def add(self, number: int, result: dict[str, Any]) -> None:
        """What a worker found in that round."""
        spent, seconds = result.pop("spent"), result.pop("seconds", None)
        if seconds is not None:
            self.rounds[number] = seconds
        self.finished = seconds is None or spent > SLOW
        vars(self).update(result)

    def as_dict(self) -> dict[str, Any]:
        found = asdict(self) | {"rounds": list(self.rounds.values())}
        return found | ({"seconds": self.seconds, "ratio": self.ratio} if self.rounds else {})


@dataclass
class Comparison:
    """Of the mechanism in `file`; each operation is timed for `seconds`.

    A process may use so many `gigabytes`; an operation that takes more than `limit` seconds with all that it
    needs is given up.
    """

    model: str
    bodies: int
    file: Path
    peers: Sequence[str]
    seconds: float
    gigabytes: float
    limit: int
    rows: dict[tuple[str, str], Row] = field(default_factory=dict)

    def run(self, rounds: int, say: Callable[[str], None]) -> list[Row]:
        """Of every operation that was measured or failed. `say` is told what goes on."""
        for number in range(rounds):
            for peer in self.peers:
                say(f"{self.model}: round {number + 1} of {rounds}, {peer}")
                self._run_peer(peer, number)
            self._take_ratios(number)
        return [row for row in self.rows.values() if row.rounds or row.failure]

    def _run_peer(self, peer: str, number: int) -> None:
        """Begins again after an operation that ended the process. RuntimeError: it ended before the first."""
        done = {row.operation for row in self.rows.values() if row.peer == peer and row.finished}
        ended = True
        while ended:
            why = self._run_worker(peer, sorted(done))
            results = list(self._results())
            if why and not results:
                raise RuntimeError(f"the process of {peer} {why}")
            ended = any("spent" not in result for result in results)
            for result in results:
                name = result.pop("operation")
                row = self.rows.setdefault((peer, name), Row(self.model, peer, name, self.bodies))
                row.add(number, result if "spent" in result else {"spent": 0.0, "failure": why})
                done.add(name)

    def _run_worker(self, peer: str, skipped: Sequence[str]) -> str:
        """Empty, or why the process ended early."""
        self._results_file.unlink(missing_ok=True)
        arguments = [peer, self.file, self._results_file, self.seconds, self.gigabytes, self.limit]
        command = [sys.executable, str(WORKER), *map(str, arguments), *skipped]
        ended = subprocess.run(command, env=os.environ | THREADS, capture_output=True, text=True)
        if ended.returncode == 0:
            return ""
        if ended.returncode == -signal.SIGALRM:
            return f"took more than {self.limit} s"
        if ended.returncode < 0:
            return f"ended with {signal.Signals(-ended.returncode).name}"
        return f"ended: {(ended.stderr.strip().splitlines() or ['without a message'])[-1]}"

    @property
    def _results_file(self) -> Path:
        return self.file.with_suffix(".jsonl")

    def _results(self) -> Iterator[dict[str, Any]]:
        """The last of each operation: what was found, or only its name where it ended the process."""
        lines = self._results_file.read_text().splitlines() if self._results_file.exists() else []
        return iter({result["operation"]: result for result in map(json.loads, lines)}.values())

    def _take_ratios(self, number: int) -> None:
        for row in self.rows.values():
            counterpart = self.rows.get(("linkwork", row.counterpart))
            if number in row.rounds and counterpart and counterpart.rounds:
                row.ratios.append(row.rounds[number] / counterpart.rounds.get(number, counterpart.seconds))
