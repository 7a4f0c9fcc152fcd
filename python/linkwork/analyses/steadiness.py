"""Whether small motions about a state in motion have constant coefficients.

The state is looked at again after each of its bodies has turned by one or two rad, beside the ground and the
bodies that it is connected with, or has moved by its own size: periodic coefficients are others then. They
are compared motion by motion, each with its own stiffness or damping, so that nothing is hidden by something
stiffer: in a basis Y with Y^T M Y = 1,

    U^T Y^T (A_then - A_now) Y V   beside the singular values of   Y^T A_now Y = U diag(sigma) V^T.

Of large models this is done for the modes that are found, and all others are compared by random motions, the
bodies that joints connect by themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from linkwork.analyses.coefficients import NEAR, Coefficients, coefficients, refuse_imbalance
from linkwork.analyses.eigenmodes import constrained_solver, of_unit_masses
from linkwork.arrays import Complex, Floats
from linkwork.constraints.equations import Equations, Sparse
from linkwork.constraints.tangent import displaced, to_inertial_axes
from linkwork.errors import ModelError
from linkwork.motion.records import Snapshot

__all__ = ["Steadiness"]

#: By how much each body turns until it is looked at again [rad], or moves [its own sizes]: no simple part of
#: a turn. Bodies up to so much slower than others are looked at with these.
TURN, SLOWER = 2.0, 3.0

#: Motion below this part of the fastest is what is left of one that came to rest, or rounding.
STILL = 1e-6

#: Changes of a coefficient, relative, that are none; those of damping and stiffness count from this part of
#: the inertia on; what is rounding of the terms that they are the sums of.
STEADY, COUNTS, ROUNDING = 1e-5, 1e-9, 1e-10

#: How much farther from a steady state one that is nearly steady may be then.
FARTHER = 10.0

#: Singular values of motions, relative, of those that depend on others.
DEPENDENT = 1e-6

#: Random motions along which coefficients of large models are compared.
PROBES = 8

NAMES = ("inertia", "damping", "stiffness")


class Steadiness:
    """Of a state and its coefficients. ModelError: it will accelerate."""

    def __init__(self, eq: Equations, at: Snapshot, now: Coefficients) -> None:
        self.eq, self.now = eq, now
        q, v = np.ravel(at.q), np.ravel(at.v)
        self.rate = float(np.abs(v / eq.scale).max()) / eq.length
        x_dot = _without_rests(eq, to_inertial_axes(q, v), self.rate)
        self.later: list[Coefficients] = []
        for time in _times(eq, x_dot, self.rate):
            soon = Snapshot(at.t, displaced(q, time * x_dot).reshape(-1, 7), at.v)
            self.later.append(coefficients(eq, soon))
            refuse_imbalance(eq, soon, self.later[-1], FARTHER * NEAR)

    def refuse_change(self, motions: Floats | Complex | None) -> None:
        """ModelError: coefficients of these motions (6n, k), of any without, or freedoms change."""
        if motions is None:
            self._refuse_change_of_any()
        elif motions.shape[1]:
            self._refuse_change_along(motions)

    def _refuse_change_along(self, x: Floats | Complex) -> None:
        Y = of_unit_masses(self.now.M, self._real(x))
        for then in self.later:
            pairs = zip(NAMES, self.now.matrices, then.matrices, strict=True)
            changed = [
                name for k, (name, A, B) in enumerate(pairs) if self._changes(A, B, Y, COUNTS * self.rate**k)
            ]
            self._refuse(changed + self._other_freedoms(then, Y))

    def _refuse_change_of_any(self) -> None:
        """By random motions, of bodies that joints connect."""
        solve, Z = self._random_motions()

        def sizes(motions: Floats) -> Floats:
            return np.column_stack([self._joined(x) for x in motions.T])

        def joined(A: Sparse) -> Floats:
            return sizes(np.column_stack([solve(A @ z) for z in Z.T]))

        units = joined(self.now.M)
        for then in self.later:
            pairs = zip(NAMES, self.now.matrices, then.matrices, strict=True)
            changed = []
            for k, (name, A, B) in enumerate(pairs):
                rounding = self.eq.scale[:, None] ** 2 * (self._parts(A) @ abs(Z))
                limit = STEADY * (joined(A) + COUNTS * self.rate**k * units) + ROUNDING * sizes(rounding)
                if (_lengths(joined(B - A)) > _lengths(limit)).any():
                    changed.append(name)
            self._refuse(changed + self._other_freedoms(then, Z))

    def _real(self, x: Floats | Complex) -> Floats:
        """Of complex motions a basis of what they are made of, orthonormal in scaled columns."""
        if not np.iscomplexobj(x):
            return np.real(x)
        U, sigma, _ = np.linalg.svd(np.hstack([x.real, x.imag]) / self.eq.scale[:, None], full_matrices=False)
        basis: Floats = self.eq.scale[:, None] * U[:, sigma > DEPENDENT * sigma[0]]
        return basis

    def _changes(self, now: Sparse, then: Sparse, Y: Floats, counts: float) -> bool:
        U, sigma, Vt = np.linalg.svd(Y.T @ (now @ Y))
        left, right = Y @ U, Y @ Vt.T
        parts = self._parts(now)
        limits = [
            STEADY * (sigma + counts) + ROUNDING * np.sum(abs(x) * (parts @ abs(x)), axis=0)
            for x in (left, right)
        ]
        change = left.T @ ((then - now) @ right)
        return bool((change**2 > np.outer(*limits)).any())

    def _parts(self, A: Sparse) -> Sparse:
        """What the entries of A are sums of, in size."""
        return self.now.stiffness.parts if A is self.now.K else abs(A)

    def _other_freedoms(self, then: Coefficients, Z: Floats) -> list[str]:
        """Whether rows of D restrict motions that were free, or those of velocities restrict others."""
        rounding = FARTHER * np.linalg.norm(self.now.fixed @ Z, axis=0)
        changed = self._restricts(then.fixed, then.fixed, Z, rounding)
        for k, (now, later) in enumerate(zip(self.now.rolling, then.rolling, strict=True)):
            changed |= self._restricts(later - now, self.now.rolling[0] * self.rate**k, Z)
        return ["freedoms"] if changed else []

    def _restricts(self, A: Sparse, rows: Sparse, Z: Floats, least: Floats | float = 0.0) -> bool:
        """Whether products of A with motions Z (6n, k) are some beside the sizes of the rows."""
        rows, x = rows.multiply(self.eq.scale[None, :]), Z / self.eq.scale[:, None]
        size = np.sqrt(rows.multiply(rows).sum(axis=1))[:, None] * np.linalg.norm(x, axis=0)
        return bool((np.abs(A @ Z) > STEADY * size + least).any())

    def _random_motions(self) -> tuple[Callable[[Floats], Floats], Floats]:
        """What D leaves of a few random motions (6n, k), and what it leaves of forces (6n,)."""
        from scipy.sparse import diags_array

        eq, D = self.eq, self.now.D
        solve = constrained_solver(diags_array(1 / eq.scale**2).tocsr(), D)
        random = np.random.default_rng(0).standard_normal((PROBES, D.shape[1]))
        return solve, np.transpose([solve(b / eq.scale) for b in random])

    def _joined(self, x: Floats) -> Floats:
        """Lengths (c,) of the parts of a motion (6n,) of bodies that joints connect."""
        squares = ((x / self.eq.scale) ** 2).reshape(-1, 6).sum(axis=1)
        return np.sqrt(np.bincount(self.eq.component, squares))

    def _refuse(self, changed: list[str]) -> None:
        if changed:
            change = "changes" if len(changed) == 1 and changed != ["freedoms"] else "change"
            raise ModelError(
                f"linearize: {self.eq.called} moves so that its {' and '.join(changed)} {change} with time, "
                "seen in axes that do not turn: linearize at rest, or in motion that looks the same there at "
                "all times, or simulate a small disturbance",
                code="not_steady",
            )


def _without_rests(eq: Equations, x_dot: Floats, rate: float) -> Floats:
    """The velocities (6n,) without those that are nothing beside the fastest."""
    parts = x_dot.reshape(-1, 2, 3).copy()
    size = np.linalg.norm(parts, axis=2) / (eq.length, 1.0)
    parts[size <= STILL * rate] = 0.0
    return parts.ravel()


def _times(eq: Equations, x_dot: Floats, rate: float) -> Iterator[float]:
    """When to look again [s], soonest first."""
    parts = np.vstack([x_dot.reshape(-1, 2, 3), np.zeros((1, 2, 3))])  # the last one: the ground
    arms = np.append(eq.arms, np.inf)
    pairs = np.vstack([[(body, -1) for body in range(eq.core.body_count)], _connected(eq)])
    relative = np.linalg.norm(parts[pairs[:, 0]] - parts[pairs[:, 1]], axis=2)
    relative[:, 0] /= np.minimum(*arms[pairs.T])
    rates = np.sort(relative[relative > STILL * rate])[::-1]
    while len(rates):
        yield TURN / rates[0]
        rates = rates[rates < rates[0] / SLOWER]


def _connected(eq: Equations) -> NDArray[np.integer]:
    """Pairs of bodies (k, 2) between which there is a joint or a force; -1 is the ground."""
    core = eq.core
    of_joints = [pair for k in range(core.joint_count) for pair in combinations(core.joint_bodies(k), 2)]
    of_forces = np.asarray(core.force_arrays()["bodies"], dtype=int)
    of_laws = np.array(core.joint_force_bodies, dtype=int)
    return np.vstack([np.reshape(it, (-1, 2)).astype(int) for it in (of_joints, of_forces, of_laws)])


def _lengths(rows: Floats) -> Floats:
    return np.asarray(np.linalg.norm(rows, axis=1))
