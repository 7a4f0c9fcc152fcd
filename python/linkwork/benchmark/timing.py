"""Right-hand sides, repeated in C++ for a moment at a time."""

from __future__ import annotations

import statistics
from dataclasses import dataclass, field

from linkwork.arrays import Floats
from linkwork.equations.system import System

#: Right-hand sides are repeated for about so long at a time [s], as a run would; caches and clocks settle in
#: the fraction before it that does not count.
WINDOW_SECONDS, SETTLING = 2e-2, 0.25

#: One that takes longer than this [s] is not warmed up again in each round.
COLD_SECONDS = 0.1

#: What a slow right-hand side may take in all rounds together [s], and its fewest rounds.
BUDGET_SECONDS, FEWEST_ROUNDS = 20.0, 3


@dataclass
class Timing:
    """The times of a system's right-hand sides at one state, in rounds."""

    system: System
    t: float
    y: Floats
    rounds: int  #: at most; fewer for slow ones
    passes: int = field(init=False)  #: right-hand sides in a round
    samples: list[dict[str, float]] = field(default_factory=list)  #: [s], of each round

    def __post_init__(self) -> None:
        """The first right-hand side allocates and does not count; the second says how many make a round."""
        self._run(1)
        one = sum(self._run(1).values())
        self.passes = max(1, round(WINDOW_SECONDS / max(one, 1e-9)))
        self.rounds = min(self.rounds, max(FEWEST_ROUNDS, int(BUDGET_SECONDS / (one * self.passes))))
        self._warm = one < COLD_SECONDS

    def measure(self) -> None:
        """One more round, until there are enough; after a warm-up, because others had the caches."""
        if len(self.samples) >= self.rounds:
            return
        if self._warm:
            self._run(max(1, round(SETTLING * self.passes)))
        self.samples.append({name: time / self.passes for name, time in self._run(self.passes).items()})

    @property
    def seconds(self) -> dict[str, float]:
        """Of one right-hand side, medians over the rounds; the parts are those of RightHandSideTimes."""
        return {name: statistics.median(s[name] for s in self.samples) for name in self.samples[0]}

    @property
    def whole_quartiles(self) -> tuple[float, float]:
        """Between them half of the rounds have the time of their whole right-hand side [s]."""
        whole = [sample["whole"] for sample in self.samples]
        if len(whole) < 2:
            return whole[0], whole[0]
        first, _, third = statistics.quantiles(whole, n=4, method="inclusive")
        return first, third

    def _run(self, passes: int) -> dict[str, float]:
        times: dict[str, float] = self.system.compiled().right_hand_side_times(self.t, self.y, passes)
        return times
