"""Steps that have become so short that a run hardly goes on."""

from __future__ import annotations

from linkwork.errors import warn

__all__ = ["ShortSteps"]

#: Short are steps of less than this part of those before, where the rest of the run takes so many of them.
SHORTER, MANY = 1e-3, 1e7

#: Looks in a row, and steps in these, after which it is no matter of a moment, such as a hard contact is.
LOOKS, STEPS = 10, 5000


class ShortSteps:
    """Of a run with steps as long as its tolerances allow."""

    def __init__(self, t: float, steps: int, t_end: float) -> None:
        self._t, self._steps, self._t_end = t, steps, t_end
        self._usual = 0.0  # the longest mean between two looks [s]
        self._since: tuple[float, int] | None = None  # time and steps at the first of the short ones
        self._looks, self._told = 0, False

    def look(self, t: float, steps: int) -> None:
        """At time t [s] after that many steps; LinkworkWarning, once: they are short, and stay so."""
        taken, passed = steps - self._steps, t - self._t
        if self._told or taken <= 0:
            return
        before = self._t, self._steps
        self._t, self._steps = t, steps
        self._usual = max(self._usual, passed / taken)
        if passed >= SHORTER * self._usual * taken or (self._t_end - t) * taken < MANY * passed:
            self._since, self._looks = None, 0
            return
        self._since = self._since or before
        self._looks += 1
        if self._looks >= LOOKS and steps - self._since[1] >= STEPS:
            self._tell(*self._since)

    def _tell(self, since: float, steps_before: int) -> None:
        self._told = True
        step = (self._t - since) / (self._steps - steps_before)
        rest = f"{(self._t_end - self._t) / step:.2g} more" if step > 0.0 else "more than can be counted"
        warn(
            f"since t = {since:.6g} s steps are about {step:.2g} s, {self._usual:.2g} s and more before: to "
            f"{self._t_end:.6g} s there would be {rest}. A force that jumps to and fro does so, such as "
            "friction by the sign of a velocity: let it go through zero within a small velocity, as that of "
            "linkwork does, or end the run there by an event. Interrupted (ctrl-C), it keeps what it has"
        )
