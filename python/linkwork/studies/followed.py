"""Cases and members in lanes whose errors are followed as they grow, and what these say of the others.

Following costs as much as some runs in a lane. So errors of some are followed, chosen by what these are, not
by their places: where their motion is unstable or chaotic, that of the others may be, too.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats

__all__ = ["ALL", "last_followed", "of_the_others"]

#: One in so many, and at least so many of all.
EACH, LEAST = 64, 4

#: Behind all keys.
ALL = "~"


def last_followed(keys: Sequence[str]) -> str:
    """Cases with a key up to this one."""
    there = set(keys)
    return max(heapq.nsmallest(max(math.ceil(len(there) / EACH), LEAST), there))


def of_the_others(unstable: Floats, status: NDArray[np.str_], what: str) -> str:
    """What the growth of errors in some (n,), NaN in others, says of these: a sentence, or nothing."""
    finished = status == "finished"
    known = unstable[finished & ~np.isnan(unstable)]
    others = int(np.count_nonzero(finished & np.isnan(unstable)))
    grow = known[known > 1.0]
    if not len(grow) or not others:
        return ""
    times = f"{grow.max():.0e}".replace("e+0", "e").replace("e+", "e")
    return (
        f"errors grow up to {times} times in the motion of {len(grow)} of the {len(known)} {what} where they"
        f" were followed: how far off the other {others} are, their verdicts may not know "
        "(follow_errors=True follows all)"
    )
