"""Stiffness and damping of a mechanism: derivatives of its forces by small motions, sparse.

Over motions x in inertial axes (see constraints.tangent); torques, too, in inertial axes, turned by the
T of before the motion:

    K = -T^T d(g + D^T lambda)/dx,   C = -T^T dg/dv T + T^T M T',   T' = diag(0, -omega~ A^T)

Differences of fourth order, many bodies at a time: those that no joint, or no force element, has in common
(Curtis, Powell, Reid, On the estimation of sparse Jacobian matrices, 1974). The part of the constraints is
the geometric stiffness: it is what a string gains by its tension.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwork import _core
from linkwork.arrays import Complex, Floats
from linkwork.constraints.equations import LAST_DIGITS, Equations, Sparse
from linkwork.constraints.tangent import displaced

__all__ = ["Stiffness", "damping", "stiffness", "stiffness_and_parts", "velocity_part"]

Indices = NDArray[np.intp]

#: Of a small motion (6n,): the change of g, and what is its rounding (6n,).
Difference = Callable[[Floats], tuple[Floats, Floats]]

#: Of the differences: in sizes of the mechanism and rad for constraints and forces; of velocities relative.
CONSTRAINT_STEP, FORCE_STEP, VELOCITY_STEP = 1e-3, 1e-5, 1e-4

#: Of those of forces at least, in distances from the origin: positions have 16 digits.
PLACE_STEP = 1e-10

#: f' = sum w_k f(k h) / h.
STENCIL = ((-2, 1 / 12), (-1, -2 / 3), (1, 2 / 3), (2, -1 / 12))

#: Differences below this part of what is subtracted are zero.
ROUNDING = 1e-15

#: How far a product with the sparse matrix may be from a difference along a random direction, in each row;
#: models of so many bodies have few entries, whatever the user's forces act between.
AGREEMENT, FEW = 1e-6, 50

#: Differences in steps shorter by this factor are the same but for such a part, or the steps become shorter,
#: so often at most.
SHORTEN, SMOOTH, SHORTER = 8.0, 1e-6, 5


class Stiffness(NamedTuple):
    """K, and what is left of it where its parts cancel: rounding."""

    K: Sparse  # (6n, 6n)
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
    places = float(np.abs(q.reshape(-1, 7)[:, :3]).max(initial=equations.length))
    step = max(FORCE_STEP * equations.length, PLACE_STEP * places)
    digits = LAST_DIGITS * places / step
    elastic = _force_part(equations, force, step / units, gross, digits)
    parts = abs(turn.T @ geometric) + abs(turn.T @ elastic)
    return Stiffness(-(turn.T @ (geometric + elastic)).tocsr(), parts.tocsr(), digits)


def damping(equations: Equations, t: float, q: Floats, v: Floats) -> Sparse:
    """C (6n, 6n), gyroscopic terms included."""
    from scipy.sparse import bsr_array

    turn, n = equations.turn(q), equations.core.body_count

    def force(change: Floats) -> Floats:
        g: Floats = equations.dynamics.evaluate(t, q, v + change)["g"]
        return g

    gross = equations.gross_forces(t, q, v)
    steps = VELOCITY_STEP * equations.scale * equations.length * equations.rate(v, gross)
    digits = LAST_DIGITS / VELOCITY_STEP
    C = -(turn.T @ _force_part(equations, force, steps, gross, digits) @ turn)
    omega = v.reshape(-1, 6)[:, 3:]
    if omega.any():  # v_dot of a small motion x is T x'' - omega x (T x') in the rotations
        blocks = np.zeros((n, 6, 6))
        blocks[:, 3:, 3:] = -np.cross(omega[:, None, :], np.eye(3)).swapaxes(1, 2)
        turning = bsr_array((blocks, np.arange(n), np.arange(n + 1)), shape=C.shape)
        C = C + equations.mass(q) @ turn.T @ turning @ turn
    return C.tocsr()


def _constraint_part(equations: Equations, t: float, q: Floats, multipliers: Floats) -> Sparse:
    """d(D^T lambda)/dx, torques in body axes: each joint's share depends on its own bodies only."""
    from scipy.sparse import coo_array

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
    return _assembled(parts, 6 * n, coo_array)


def velocity_part(equations: Equations, t: float, q: Floats, v: Floats) -> Sparse:
    """d(D v)/dx (m, 6n) of the rows that restrict velocities only, at constant omega in body axes."""
    from scipy.sparse import coo_array

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
    return _assembled(parts, 6 * n, coo_array, core.row_count)


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
    color = _colors(core.body_count, pairs)
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
    """Steps (n, 6) in which the forces of joints change as in shorter ones: for short rods they are short."""
    steps = CONSTRAINT_STEP * equations.length * equations.scale
    blur = LAST_DIGITS * float(np.abs(q.reshape(-1, 7)[:, :3]).max()) / (CONSTRAINT_STEP * equations.length)
    difference = partial(_difference, force, np.abs(force(np.zeros_like(steps))))
    direction = np.random.default_rng(0).uniform(0.5, 1.0, len(steps))
    return _resolving(equations, difference, steps, direction, pairs, blur).reshape(-1, 6)


def _force_part(
    equations: Equations, force: Callable[[Floats], Floats], steps: Floats, gross: Floats, blur: float
) -> Sparse:
    """dg/dx (6n, 6n) for any g(x), x = 0 at the state, by force elements between two bodies each.

    `gross` (6n,): what g is the sum of, see Equations.gross_forces; `blur`: rounding of x in these steps.
    """
    difference = partial(_difference, force, gross)
    core, n = equations.core, equations.core.body_count
    laws = np.array(core.joint_force_bodies, dtype=int).reshape(-1, 2)
    pairs = np.concatenate([np.asarray(core.force_arrays()["bodies"], dtype=int).reshape(-1, 2), laws])
    direction = np.random.default_rng(0).uniform(0.5, 1.0, 6 * n)
    steps = _resolving(equations, difference, steps, direction, pairs, blur)
    J = _colored(n, pairs, difference, steps)
    if equations.model.user_force_count:  # these act between whichever bodies
        expected, noise = difference(steps * direction)
        off = np.abs(J @ (steps * direction) - expected)
        if n <= FEW or (off > AGREEMENT * np.abs(expected) + noise).any():
            J = _colored(n, np.stack(np.triu_indices(n, 1), axis=1), difference, steps)
    return J


def _resolving(
    equations: Equations,
    difference: Difference,
    steps: Floats,
    direction: Floats,
    pairs: Indices,
    blur: float,
) -> Floats:
    """Steps (6n,) that are shorter at bodies whose forces change otherwise in them than in shorter ones: as
    where a contact is less deep than the steps are long, or friction sticks."""

    def largest(forces: Floats) -> Floats:  # of each body [N]
        return np.asarray(np.abs(forces * equations.scale).reshape(-1, 6).max(axis=1))

    turned = direction * np.random.default_rng(1).choice([-1.0, 1.0], len(direction))
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
        inner = pairs[(pairs >= 0).all(axis=1)]
        off[inner[off[inner].any(axis=1)]] = True
        steps = np.where(off.repeat(6), steps / SHORTEN, steps)
        blurred = np.where(off, SHORTEN * blurred, blurred)
    return steps


def _colored(n: int, pairs: NDArray[np.integer], difference: Difference, steps: Floats) -> Sparse:
    from scipy.sparse import coo_array, eye_array

    inner = pairs[(pairs >= 0).all(axis=1)]
    ones = np.ones(len(inner))
    touch = coo_array((ones, (inner[:, 0], inner[:, 1])), shape=(n, n))
    touch = (touch + touch.T + eye_array(n)).tocsr()
    both = (touch @ touch).tocoo()
    color = _colors(n, np.column_stack([both.row, both.col]))
    near = touch.tocoo()
    parts: list[tuple[Floats, Indices, Indices]] = []
    for c in range(color.max(initial=-1) + 1):
        moved = np.full(n, -1)
        of_color = color[near.col] == c
        moved[near.row[of_color]] = near.col[of_color]  # per body the one that moves near it
        bodies = np.flatnonzero(moved >= 0)
        rows = (6 * bodies[:, None] + np.arange(6)).ravel()
        for k in range(6):
            x = np.zeros((n, 6))
            x[color == c, k] = steps.reshape(n, 6)[color == c, k]
            h = steps.reshape(n, 6)[moved[bodies], k].repeat(6)
            values = difference(x.ravel())[0][rows] / h
            parts.append((values, rows, (6 * moved[bodies] + k).repeat(6)))
    return _assembled(parts, 6 * n, coo_array)


def _difference(force: Callable[[Floats], Floats], gross: Floats, x: Floats) -> tuple[Floats, Floats]:
    """The derivative of force(s x) by s at s = 0, and below which size it is rounding: there it is zero."""
    terms = np.array([w * force(s * x) for s, w in STENCIL])
    total, rounding = terms.sum(axis=0), ROUNDING * np.maximum(np.abs(terms).sum(axis=0), gross)
    return np.where(np.abs(total) > rounding, total, 0.0), rounding


def _assembled(
    parts: list[tuple[Floats, Indices, Indices]],
    size: int,
    coo: Callable[..., Sparse],
    row_count: int | None = None,
) -> Sparse:
    values, rows, columns = (
        (np.concatenate(list(part)) for part in zip(*parts, strict=True)) if parts else (np.zeros(0),) * 3
    )
    keep = values != 0.0
    places = rows[keep].astype(int), columns[keep].astype(int)
    return coo((values[keep], places), shape=(size if row_count is None else row_count, size)).tocsr()


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


def _colors(n: int, pairs: NDArray[np.integer]) -> Indices:
    """A color (n,) for each body, other than those of its partners: the first that is free."""
    from scipy.sparse import coo_array

    inner = pairs[(pairs >= 0).all(axis=1) & (pairs[:, 0] != pairs[:, 1])]
    graph = coo_array((np.ones(len(inner)), (inner[:, 0], inner[:, 1])), shape=(n, n))
    graph = (graph + graph.T).tocsr()
    color = np.full(n, -1)
    for body in range(n):
        taken = set(color[graph.indices[graph.indptr[body] : graph.indptr[body + 1]]].tolist())
        color[body] = next(c for c in range(n + 1) if c not in taken)
    return color
