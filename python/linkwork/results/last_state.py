"""The end of a motion of which nothing else is looked at."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from linkwork.accuracy.verdict import Verdict
from linkwork.arrays import Floats

__all__ = ["LastState"]


@dataclass(frozen=True)
class LastState:
    """What a Result says of q and v of its last frame, and how accurate they are.

    Without a Header, which each of many members of an ensemble would have for nothing.

    frames    as of Result
    verdict   None: there was no step
    manifest  "model" alone
    """

    frames: Mapping[str, Floats]
    verdict: Verdict | None
    manifest: Mapping[str, Any]

    def recorded(self, name: str, part: int) -> Floats:
        """As Result.recorded, of one frame."""
        return np.reshape(self.frames[name][part], (-1, {"q": 7, "v": 6}[name]))
