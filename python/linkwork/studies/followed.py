"""Cases and members in lanes whose errors are followed as they grow, and what these say of the others.

At fixed steps following costs as much as some runs in a lane. So errors of some are followed, chosen by what
these are, not by their places: where their motion is unstable or chaotic, that of the others may be, too.
"""

from __future__ import annotations

import heapq
from collections import Counter
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.fingerprints import digest

__all__ = ["ALL", "LEAST", "apart", "last_followed", "of_the_others", "summary"]

#: Of all keys, as a hexadecimal number, and at least so many.
SHARE, LEAST = "04", 16

#: Behind all keys.
ALL = "~"


def last_followed(keys: Sequence[str]) -> str:
    """Cases with a key up to this one: one in 64, at least 16."""
    there = set(keys)
    return ALL if len(there) <= LEAST else max(SHARE, heapq.nsmallest(LEAST, there)[-1])


def apart(keys: Sequence[str]) -> list[str]:
    """Others for those that come again: of many equal members no more are followed than of other ones."""
    seen = Counter[str]()
    out = []
    for key in keys:
        out.append(digest(key, seen[key]) if seen[key] else key)
        seen[key] += 1
    return out


def of_the_others(unstable: Floats, status: NDArray[np.str_], what: str, *, every: bool) -> str:
    """A sentence where errors of some grow, and it is not known of others, NaN; else nothing. `every`: errors
    of all were followed, as far as they can be."""
    finished = unstable[status == "finished"]
    known = finished[~np.isnan(finished)]
    others, grow = len(finished) - len(known), known[known > 1.0]
    if not len(grow) or not others:
        return ""
    times = f"{grow.max():.0e}".replace("e+0", "e").replace("e+", "e")
    return (
        f"errors grow up to {times} times in the motion of {len(grow)} of the {len(known)} {what} of which "
        f"that is known: the other {others} may be much farther off than their verdicts say"
        f"{'' if every else ' (follow_errors=True looks at all)'}"
    )


def summary(unstable: Floats, status: NDArray[np.str_], what: str, *, every: bool) -> str:
    """That sentence, or of how many it is not known."""
    finished = unstable[status == "finished"]
    unknown = int(np.count_nonzero(np.isnan(finished)))
    if every or not unknown:
        return of_the_others(unstable, status, what, every=every)
    about = "whether errors grow, as in unstable motion, is known of"
    if unknown == len(finished):
        return f"{about} none of the {unknown} {what}, though some were looked at: verify=True of one tells"
    return of_the_others(unstable, status, what, every=every) or (
        f"{about} {len(finished) - unknown} of the {len(finished)} {what}, where they do not "
        "(follow_errors=True looks at all)"
    )
