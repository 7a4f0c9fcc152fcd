"""How long the steps to an equilibrium may be, and when they lead nowhere."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from linkwork.arrays import Floats

__all__ = ["LONGEST_STEP", "LONGEST_TURN", "StepLimits"]

#: The most a step may move a body at first [rad, sizes of the mechanism]; how much longer the next one may be
#: where the imbalance falls in steps of at least that part; and the most [rad] of turns that are counted.
LONGEST_STEP, LONGER, LONG, LONGEST_TURN = 0.3, 1.5, 0.25, 1.2

#: Work of the forces that stiffness foretells but for this part. After a full turn of which all was foretold,
#: so that nothing was met on the way, turns may be so many times longer, and this long at most [rad], such as
#: those of fine threads and small pinions.
FORETOLD, FULL_TURN, LONGER_TURN, MOST_TURN = 1e-3, 2 * np.pi, 2.0, 1e3

#: A body that has turned so often [rad] goes round for ever where the steps that are left are not enough for
#: the imbalance to fall as it did by then; it is counted anew from where it has fallen by this part.
ROUND, PROGRESS = 4 * np.pi, 0.01


@dataclass
class StepLimits:
    """With how far bodies have turned, and in how many steps, since the imbalance was last seen to fall."""

    best: float
    body_count: int
    last: float = np.inf
    steps: int = 0
    longest: float = LONGEST_STEP  #: of the next step [sizes of the mechanism]
    turn: float = LONGEST_STEP  #: of the next step [rad], of turns that nothing else but the step counts
    far: bool = False  #: the last step was as good as the longest, and the imbalance fell
    foretold: float = 0.0  #: turn [rad] of which the work was foretold, and the imbalance did not grow
    turned: Floats = field(init=False)  # (n, 3) sums of rotation vectors [rad]

    def __post_init__(self) -> None:
        self.last, self.turned = self.best, np.zeros((self.body_count, 3))

    @property
    def angle(self) -> Floats:
        """By which bodies have turned (n,)."""
        angle: Floats = np.linalg.norm(self.turned, axis=1)
        return angle

    def goes_round(self, steps_left: int) -> bool:
        """Whether a body turns, and the steps that are left are not enough for the imbalance to fall."""
        angle, fallen = self.angle.max(), 1.0 - self.last / self.best
        longest = MOST_TURN if self.foretold > FULL_TURN else self.turn
        return bool(angle > ROUND and fallen * steps_left * longest < angle)

    def add(self, x: Floats, size: float, reach: float, off: float) -> None:
        """A step x (6n,) of this reach, to an imbalance of this size; `off`: see FORETOLD."""
        self.far = size < self.last and reach > LONG * min(self.longest, LONGEST_TURN)
        self.longest = LONGER * self.longest if self.far else LONGEST_STEP
        if off > FORETOLD or size > self.last:
            self.foretold, self.turn = 0.0, LONGEST_STEP
        else:
            self.foretold += float(np.linalg.norm(x.reshape(-1, 6)[:, 3:], axis=1).max())
        if self.foretold > FULL_TURN:
            self.turn = min(LONGER_TURN * self.turn, MOST_TURN)
        self.last = size
        if size < (1 - PROGRESS) * self.best:
            self.best, self.turned, self.steps = size, np.zeros_like(self.turned), 0
        else:
            self.turned, self.steps = self.turned + x.reshape(-1, 6)[:, 3:], self.steps + 1
