"""Kinks: states at which forces have no derivative along a motion that the joints leave.

A contact or stop that just touches is stiff to one side only; the ends of a spring that coincide have no
direction. About such a state small motions are not linear, however small.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np

from linkwork.analyses.eigenmodes import constrained_solver
from linkwork.analyses.force_derivatives import DOUBT, SMOOTH, Doubt, unsmooth
from linkwork.arrays import Floats
from linkwork.constraints.equations import Equations, Sparse
from linkwork.constraints.tangent import displaced
from linkwork.motion.records import Snapshot

__all__ = ["Kink", "kink"]

#: Of the forces at a kink what joints leave over, squared, relative: less is rounding. Of damping beside the
#: largest on its body: the same.
TAKEN, BESIDE = 1e-12, 1e-9

#: Forces at a state: of q (7n,) and v (6n,).
Force = Callable[[Floats, Floats], Floats]


class Kink(NamedTuple):
    body: str
    force: str | None  # its name, where it is known

    def __str__(self) -> str:
        of = f"force '{self.force}'" if self.force else "what acts"
        return f"{of} on body '{self.body}' has a kink there"


def kink(
    eq: Equations, at: Snapshot, D: Sparse, stiffness: Doubt, damping: Doubt | None = None
) -> Kink | None:
    """The first one along a motion with D x = 0. Without `damping` where stiffness alone counts."""
    search = _Search(eq, at, D)
    found = search.along(stiffness, of_rates=False)
    if found is None and damping is not None:
        found = search.along(damping, of_rates=True) or search.leap(stiffness.h, damping)
    return found


class _Search:
    def __init__(self, eq: Equations, at: Snapshot, D: Sparse) -> None:
        self.eq, self.t, self.D = eq, at.t, D
        self.q, self.v = np.ravel(at.q).astype(float), np.ravel(at.v).astype(float)

    def along(self, doubt: Doubt, *, of_rates: bool) -> Kink | None:
        """In the directions that are doubtful."""
        columns = doubt.entries.tocsc()
        for column in np.flatnonzero(np.diff(columns.indptr)).tolist():
            if self._is_felt(columns[:, [column]].toarray().ravel()):
                x = np.where(np.arange(len(doubt.h)) == column, doubt.h, 0.0)
                return self._told(column // 6, partial(self._unsmooth, x, of_rates))
        return None

    def leap(self, h: Floats, damping: Doubt) -> Kink | None:
        """Of damping that is another right beside the state, in whichever direction, in steps h."""
        random = np.random.default_rng(2)
        u, x = (step * random.uniform(0.5, 1.0, len(step)) for step in (damping.h, h))
        eq, turn = self.eq, self.eq.turn(self.q)

        def force(q: Floats, v: Floats) -> Floats:
            return np.asarray(turn.T @ eq.dynamics.evaluate(self.t, q, v)["g"])

        change = self._change(force, u, x, damping.noise)
        if not change.any() or not self._is_felt(change):
            return None
        body = int(np.abs(change * eq.scale).argmax()) // 6
        return self._told(body, lambda it: self._change(it, u, x, np.zeros(6)))

    def _change(self, force: Force, u: Floats, x: Floats, noise: Floats) -> Floats:
        """Of what a velocity u makes, by a motion x, where a smaller one does not change it less."""

        def damped(s: float) -> Floats:
            q = displaced(self.q, s * x)
            return np.asarray(force(q, self.v + u) - force(q, self.v - u)) / 2

        here, far, near = damped(0.0), damped(0.1), damped(0.1 / 8)
        size, leap = np.maximum(np.abs(here), np.abs(far)), np.abs(near - here)
        least = np.maximum(DOUBT * size, BESIDE * self._largest(size) + noise)
        return np.where((leap > least) & (leap > np.abs(far - here) / 4), near - here, 0.0)

    def _largest(self, forces: Floats) -> Floats:
        """Of each force and torque (6k,) the largest on its body, torques by the size of the model."""
        parts, unit = forces.reshape(-1, 2, 3), np.array([1.0, self.eq.length])
        most = (parts.max(axis=2) / unit).max(axis=1)
        return np.asarray((most[:, None] * unit).repeat(3, axis=1).ravel())

    def _unsmooth(self, x: Floats, of_rates: bool, force: Force) -> Floats:
        """Of a force element along x."""
        q, v = self.q, self.v
        s = (-2, -1, 0, 1, 2)
        f = [force(q, v + k * x) if of_rates else force(displaced(q, k * x), v) for k in s]
        off, size = unsmooth(*f), max(float(np.abs(np.diff(f, axis=0)).max()), np.finfo(float).tiny)
        return np.where(np.abs(off) > SMOOTH * size, off / size, 0.0)

    def _is_felt(self, force: Floats) -> bool:
        """Whether joints do not take it."""
        left = force @ self._given_way(force)
        return bool(left > TAKEN * np.sum((self.eq.scale * force) ** 2))

    @cached_property
    def _given_way(self) -> Callable[..., Floats]:
        """Motions that the joints leave to forces, as if all bodies had the same mass."""
        from scipy.sparse import diags_array

        return constrained_solver(diags_array(1 / self.eq.scale**2).tocsr(), self.D)

    def _told(self, body: int, kinked: Callable[[Force], Floats]) -> Kink:
        """With the force element on the body that has most of it."""
        core = self.eq.core
        pairs = np.asarray(core.force_arrays()["bodies"]).reshape(-1, 2)
        most, name = 0.0, None
        for element in np.flatnonzero((pairs == body).any(axis=1)).tolist():
            size = float(np.abs(kinked(self._element(element))).max())
            if size > most:
                most, name = size, core.force_name(element)
        laws = [
            law for (law, _), it in zip(core.joint_forces, core.joint_force_bodies, strict=True) if body in it
        ]
        return Kink(core.body_name(body), laws[0] if name is None and len(laws) == 1 else name)

    def _element(self, element: int) -> Force:
        dynamics, t = self.eq.dynamics, np.array([self.t])
        rest, history = np.zeros_like(self.v), np.asarray(self.eq.dynamics.history)

        def force(q: Floats, v: Floats) -> Floats:
            found = dynamics.force_element(element, t, q, v, rest, history)
            return np.hstack([np.ravel(found[0]), np.ravel(found[1])])

        return force
