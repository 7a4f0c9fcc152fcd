"""Stiffness and damping of a mechanism: derivatives of its forces by small motions, sparse.

Over motions x in inertial axes (see constraints.tangent); torques, too, in inertial axes, turned by the
T of before the motion:

    K = -T^T d(g + D^T lambda)/dx,   C = -T^T dg/dv T + T^T M T',   T' = diag(0, -omega~ A^T)

Differences of fourth order, many bodies at a time: those that no joint, or no force element, has in common.
The part of the constraints is the geometric stiffness: it is what a string gains by its tension.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwork import _core
from linkwork.analyses.force_derivatives import (
    ROUNDING,
    STENCIL,
    Derivative,
    Doubt,
    Steps,
    assembled,
    colors,
    force_derivative,
    partners_of,
)
from linkwork.arrays import Complex, Floats
from linkwork.constraints.equations import LAST_DIGITS, Equations, Sparse
from linkwork.constraints.tangent import displaced

__all__ = [
    "Stiffness", "damping", "damping_and_doubt", "has_potential", "scaled", "stiffness",
    "stiffness_and_parts", "velocity_part",
]  # fmt: skip

Indices = NDArray[np.intp]

#: Of a small motion (6n,): the change of g, and what is its rounding (6n,).
Difference = Callable[[Floats], tuple[Floats, Floats]]

#: Of the differences: in sizes of the mechanism and rad for constraints and forces; of velocities relative.
CONSTRAINT_STEP, FORCE_STEP, VELOCITY_STEP = 1e-3, 1e-5, 1e-4

#: Of those of forces at least, in distances from the origin: positions have 16 digits.
PLACE_STEP = 1e-10

#: How far a product with the sparse matrix may be from a difference along a random direction, in each row;
#: models of so many bodies have few entries, whatever the user's forces act between.
AGREEMENT, FEW = 1e-6, 50

#: Differences of the constraints in steps shorter by this factor are the same but for such a part, or the
#: steps become shorter, so often at most.
SHORTEN, SMOOTH, SHORTER = 8.0, 1e-6, 5

#: Asymmetry of the stiffness that counts as none, relative to the largest entries of the bodies: rounding.
SMALL = 1e-10


class Stiffness(NamedTuple):
    """K, and what is left of it where its parts cancel: rounding."""

    K: Sparse  # (6n, 6n)
    doubt: Doubt  # at a kink of the forces; torques in inertial axes
    parts: Sparse  # |K| before that of joints and that of force elements add up
    digits: float  # of differences, that positions do not have, relative

    def rounding(self, x: Complex | Floats, least: float) -> Floats:
        """Of the stiffnesses of motions x (6n, ...); `least`, relative to its parts."""
        size = np.abs(x)
        return np.asarray(max(least, self.digits) * np.sum(size * (self.parts @ size), axis=0))


def stiffness(equations: Equations, t: float, q: Floats, v: Floats, multipliers: Floats) -> Sparse:
    """K (6n, 6n) at t, q (7n,), v (6n,) and multipliers (m,); at constant omega in body axes."""
    return stiffness_and_parts(equations, t, q, v, multipliers).K


def stiffness_and_parts(
    equations: Equations, t: float, q: Floats, v: Floats, multipliers: Floats
) -> Stiffness:
    """The same, and what may be rounding of it."""
    turn = equations.turn(q)
    geometric = _constraint_part(equations, t, q, multipliers)
    units = 1 / equations.scale  # 1, or the length of the mechanism times the angle

    def force(x: Floats) -> Floats:
        g: Floats = equations.dynamics.evaluate(t, displaced(q, x), v)["g"]
        return g

    gross = equations.gross_forces(t, q, v)
    place = np.abs(q.reshape(-1, 7)[:, :3]).max(axis=1)
    farthest = float(place.max(initial=equations.length))
    step = max(FORCE_STEP * equations.length, PLACE_STEP * farthest)
    blur = LAST_DIGITS * (place + equations.arms) / step
    start = Steps(step / units, step / equations.length, blur, equations.arms, np.zeros_like(gross))
    elastic, doubt = _force_part(equations, force, start, gross)
    parts = abs(turn.T @ geometric) + abs(turn.T @ elastic)
    K = -(turn.T @ (geometric + elastic)).tocsr()
    doubt = doubt._replace(entries=(turn.T @ doubt.entries).tocsr())
    return Stiffness(K, doubt, parts.tocsr(), LAST_DIGITS * farthest / step)


def damping(equations: Equations, t: float, q: Floats, v: Floats) -> Sparse:
    """C (6n, 6n), gyroscopic terms included."""
    return damping_and_doubt(equations, t, q, v, np.zeros_like(v))[0]


def damping_and_doubt(
    equations: Equations, t: float, q: Floats, v: Floats, largest: Floats
) -> tuple[Sparse, Doubt]:
    """The same, and at a kink of the forces what is none of it; torques in inertial axes.

    `largest` (6n,): forces whose rounding is no kink, see Steps.
    """
    from scipy.sparse import bsr_array

    turn, n = equations.turn(q), equations.core.body_count

    def force(change: Floats) -> Floats:
        g: Floats = equations.dynamics.evaluate(t, q, v + change)["g"]
        return g

    gross = equations.gross_forces(t, q, v)
    steps = VELOCITY_STEP * equations.scale * equations.length * equations.rate(v, gross)
    blur = np.full(n, LAST_DIGITS / VELOCITY_STEP)
    start = Steps(steps, VELOCITY_STEP, blur, equations.arms, largest)
    found, doubt = _force_part(equations, force, start, gross)
    C = -(turn.T @ found @ turn)
    omega = v.reshape(-1, 6)[:, 3:]
    if omega.any():  # v_dot of a small motion x is T x'' - omega x (T x') in the rotations
        blocks = np.zeros((n, 6, 6))
        blocks[:, 3:, 3:] = -np.cross(omega[:, None, :], np.eye(3)).swapaxes(1, 2)
        turning = bsr_array((blocks, np.arange(n), np.arange(n + 1)), shape=C.shape)
        C = C + equations.mass(q) @ turn.T @ turning @ turn
    return C.tocsr(), doubt._replace(entries=(turn.T @ doubt.entries).tocsr())


def _constraint_part(equations: Equations, t: float, q: Floats, multipliers: Floats) -> Sparse:
    """d(D^T lambda)/dx, torques in body axes: each joint's share depends on its own bodies only."""
    core, n = equations.core, equations.core.body_count

    def constraints(x: Floats) -> Any:
        return equations.dynamics.evaluate(t, displaced(q, x), np.zeros(6 * n))["D"]

    found = constraints(np.zeros(6 * n))
    columns, row = found["indices"], np.repeat(np.arange(core.row_count), np.diff(found["indptr"]))
    pairs = _partners(core)
    vector = np.unique(2 * n * row + columns // 3, return_inverse=True)[1]
    weight = multipliers[row]
    used = weight != 0.0

    def force(x: Floats) -> Floats:
        sums = np.bincount(columns, constraints(x)["data"] * weight, minlength=6 * n)
        return np.asarray(sums, dtype=float)

    steps = _geometric_steps(equations, q, force, pairs)
    parts: list[tuple[Floats, Indices, Indices]] = []
    for bodies, mover in _movers(core, pairs):
        moved = mover[equations.joint_of_row[row]]  # per entry the body that moves, or -1
        wanted = used & (moved >= 0)
        if not wanted.any():
            continue
        for k in range(6):
            x = np.zeros((n, 6))
            x[bodies, k] = steps[bodies, k]
            terms = np.array([w * constraints(s * x.ravel())["data"] for s, w in STENCIL])
            values = (_change(terms, vector) * weight)[wanted] / steps[moved[wanted], k]
            parts.append((values, columns[wanted], 6 * moved[wanted] + k))
    return assembled(parts, 6 * n)


def velocity_part(equations: Equations, t: float, q: Floats, v: Floats) -> Sparse:
    """d(D v)/dx (m, 6n) of the rows that restrict velocities only, at constant omega in body axes."""
    core, n = equations.core, equations.core.body_count
    pairs, rows = _partners(core), np.flatnonzero(~equations.holonomic)
    steps = np.column_stack([equations.arms] * 3 + [np.ones(n)] * 3) * CONSTRAINT_STEP

    def rates(x: Floats) -> Floats:
        found: Floats = equations.dynamics.evaluate(t, displaced(q, x), v)["Phi_dot"]
        return found

    parts: list[tuple[Floats, Indices, Indices]] = []
    for bodies, mover in _movers(core, pairs):
        moved = mover[equations.joint_of_row[rows]]
        own, moved = rows[moved >= 0], moved[moved >= 0]
        for k in range(6) if len(own) else ():
            x = np.zeros((n, 6))
            x[bodies, k] = steps[bodies, k]
            terms = np.array([w * rates(s * x.ravel())[own] for s, w in STENCIL])
            parts.append((_change(terms, np.arange(len(own))) / steps[moved, k], own, 6 * moved + k))
    return assembled(parts, 6 * n, core.row_count)


def scaled(equations: Equations, K: Sparse) -> Sparse:
    """In N/m: rotations by the size of the mechanism."""
    return K.multiply(equations.scale[:, None]).multiply(equations.scale[None, :])


def has_potential(equations: Equations, found: Stiffness) -> bool:
    """Whether scaled entries differ from those across the diagonal by rounding of their bodies' largest."""
    K, parts = scaled(equations, found.K), scaled(equations, found.parts).tocoo()
    skew = abs(K - K.T).tocoo()
    size = np.zeros(K.shape[0] // 6)
    for place in (parts.row, parts.col):
        np.maximum.at(size, place // 6, parts.data)
    rounding = max(SMALL, found.digits) * np.sqrt(size[skew.row // 6] * size[skew.col // 6])
    return bool((skew.data <= rounding).all())


def _partners(core: _core.Model) -> Indices:
    """Pairs of bodies (k, 2) that a joint has in common, each with itself, too."""
    from scipy.sparse import coo_array

    joint, body = _incidence(core)
    shape = (core.joint_count, core.body_count)
    share = coo_array((np.ones(len(joint)), (joint, body)), shape=shape).tocsr()
    partners = (share.T @ share).tocoo()
    return np.column_stack([partners.row, partners.col])


def _movers(core: _core.Model, pairs: Indices) -> Iterator[tuple[Indices, Indices]]:
    """All bodies in turn, those together that no joint has in common; and the one of these that each joint
    has (joints,), or -1."""
    joint, body = _incidence(core)
    color = colors(core.body_count, pairs)
    for c in range(color.max(initial=-1) + 1):
        mover = np.full(core.joint_count, -1)
        mover[joint[color[body] == c]] = body[color[body] == c]
        yield np.flatnonzero(color == c), mover


def _change(terms: Floats, vector: Indices) -> Floats:
    """Sums of the terms (4, k); zero where they are rounding of the largest of their vector."""
    change, rounding = terms.sum(axis=0), np.zeros(len(vector))
    with np.errstate(invalid="ignore"):  # on the way to an equilibrium a disc may lie flat, which has no row
        np.maximum.at(rounding, vector, ROUNDING * np.abs(terms).sum(axis=0))
    return np.where(np.abs(change) > rounding[vector], change, 0.0)


def _geometric_steps(
    equations: Equations, q: Floats, force: Callable[[Floats], Floats], pairs: Indices
) -> Floats:
    """Steps (n, 6) in which the forces of joints change as in shorter ones: for short rods they are short.

    They are looked at along random motions that are at least as long.
    """
    steps = CONSTRAINT_STEP * equations.length * equations.scale
    blur = LAST_DIGITS * float(np.abs(q.reshape(-1, 7)[:, :3]).max()) / (CONSTRAINT_STEP * equations.length)
    difference = partial(_difference, force, np.abs(force(np.zeros_like(steps))))
    direction = np.random.default_rng(0).uniform(1.0, 2.0, len(steps))
    turned = direction * np.random.default_rng(1).choice([-1.0, 1.0], len(direction))

    def largest(forces: Floats) -> Floats:  # of each body [N]
        return np.asarray(np.abs(forces * equations.scale).reshape(-1, 6).max(axis=1))

    blurred = np.full(len(steps) // 6, blur)
    for _ in range(SHORTER):
        value, _ = difference(steps * direction)
        other, _ = difference(steps * turned)  # one of them may hardly stretch what is stiff
        shorter, noise = (SHORTEN * part for part in difference(steps * direction / SHORTEN))
        blurring = SHORTEN * blurred * np.maximum(largest(value), largest(other))
        limit = SMOOTH * np.abs(value) + blurring.repeat(6) / equations.scale + noise
        off = (np.abs(value - shorter) > limit).reshape(-1, 6).any(axis=1)
        if not off.any():
            break
        off[pairs[off[pairs].any(axis=1)]] = True
        steps = np.where(off.repeat(6), steps / SHORTEN, steps)
        blurred = np.where(off, SHORTEN * blurred, blurred)
    return steps.reshape(-1, 6)


def _force_part(
    equations: Equations, force: Callable[[Floats], Floats], start: Steps, gross: Floats
) -> Derivative:
    """dg/dx (6n, 6n) for any g(x), x = 0 at the state, by force elements between two bodies each.

    `gross` (6n,): what g is the sum of, see Equations.gross_forces.
    """
    core, n = equations.core, equations.core.body_count
    laws = np.array(core.joint_force_bodies, dtype=int).reshape(-1, 2)
    pairs = np.concatenate([np.asarray(core.force_arrays()["bodies"], dtype=int).reshape(-1, 2), laws])
    any_pairs = np.stack(np.triu_indices(n, 1), axis=1)
    of_user = equations.model.user_force_count > 0  # these act between whichever bodies
    if of_user and n <= FEW:
        pairs = any_pairs
    start = start._replace(blur=partners_of(start.blur, pairs))
    found = force_derivative(force, gross, start, pairs)
    if of_user and n > FEW:
        x = found.doubt.h * np.random.default_rng(0).uniform(0.5, 1.0, 6 * n)
        expected, noise = _difference(force, gross, x)
        if (np.abs(found.J @ x - expected) > AGREEMENT * np.abs(expected) + noise).any():
            found = force_derivative(force, gross, start, any_pairs)
    return found


def _difference(force: Callable[[Floats], Floats], gross: Floats, x: Floats) -> tuple[Floats, Floats]:
    """The derivative of force(s x) by s at s = 0, and below which size it is rounding: there it is zero."""
    terms = np.array([w * force(s * x) for s, w in STENCIL])
    total, rounding = terms.sum(axis=0), ROUNDING * np.maximum(np.abs(terms).sum(axis=0), gross)
    return np.where(np.abs(total) > rounding, total, 0.0), rounding


def _incidence(core: _core.Model) -> tuple[Indices, Indices]:
    """(joint, body) for every body of every joint, without the ground."""
    arrays = core.joint_arrays()
    pairs = np.asarray(arrays["bodies"]).reshape(-1, 2)
    special = np.flatnonzero(arrays["kind"] >= len(_core.joint_kinds()))
    joint, body = np.repeat(np.arange(len(pairs)), 2), pairs.ravel().astype(int)
    keep = (body >= 0) & ~np.isin(joint, special)
    more = [(k, b) for k in special.tolist() for b in core.joint_bodies(k) if b >= 0]
    added = np.array(more, dtype=int).reshape(-1, 2)
    return np.append(joint[keep], added[:, 0]), np.append(body[keep], added[:, 1])
