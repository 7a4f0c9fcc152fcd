"""How fast force elements can make a mechanism move, and what steps an explicit integrator allows then."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from linkwork.arrays import Floats, Indices
from linkwork.equations.system import System
from linkwork.errors import LinkworkError

#: Of Arnoldi's method: two right-hand sides each.
ITERATIONS = 20

#: Relative size of the finite differences.
DIFFERENCE = 1e-6

#: A vibration that goes on less than this in a step [rad] is not stiff, even where a method lets it grow.
SLOW = 0.5

#: Of h times an eigenvalue: no explicit method is stable there, and its growth is beyond all numbers.
BEYOND = 1e6

#: By which a motion may grow in a step before the step counts as unstable.
GROWTH = 1.01

#: Imaginary parts, relative to |s|, that are none; by how much a step is known at which a method is unstable.
REAL, KNOWN = 1e-6, 1e-3


@dataclass(frozen=True)
class FastestMode:
    """The eigenvalue [1/s] of largest modulus of the linearized equations; the body that moves most in it."""

    eigenvalue: complex
    body: str


def fastest(system: System) -> FastestMode | None:
    """By Arnoldi's method on finite differences of y_dot at the initial state; None without force elements.

    Only motions that the constraints allow count: those that the forces can excite.
    """
    core = system.model.compiled()
    if not core.force_count:
        return None
    y = system.initial_state()
    nq = 7 * system.model.body_count
    try:
        reach = _reach(system, y)
        H, basis = _arnoldi(lambda z: _directional(system, y, reach, z), _start(system))
    except LinkworkError:  # no accelerations beside the initial state: the run will say so, if it must
        return None
    if not len(H):
        return None
    values, vectors = np.linalg.eig(H)
    largest = int(np.argmax(np.abs(values)))
    motion = np.abs(basis @ vectors[:, largest])[nq:].reshape(-1, 6).max(axis=1)
    return FastestMode(complex(values[largest]), core.body_name(int(motion.argmax())))


def stable_step(growth: Callable[[float, float], float], eigenvalue: complex, step: float) -> float:
    """The longest step up to `step` with which a method does not blow the motion up.

    growth  of the method, as in ButcherTableau: of alpha h and beta h, s^2 + 2 alpha s + beta^2 = 0
    """

    def unstable(h: float) -> bool:
        z = eigenvalue * h
        damped = z.real < -0.1 * abs(z)
        growing = z.real > 0.1 * abs(z)  # by itself, which is no fault of the method
        if growing or not (damped or abs(z) > SLOW):
            return False
        if not abs(z) < BEYOND:
            return True
        real = abs(z.imag) < REAL * abs(z)
        return growth(-z.real / 2, 0.0) > GROWTH if real else growth(-z.real, abs(z)) > GROWTH

    if not unstable(step):
        return step
    stable, bad = 0.0, step
    while bad - stable > KNOWN * bad:
        middle = (stable + bad) / 2
        stable, bad = (stable, middle) if unstable(middle) else (middle, bad)
    return stable


def _reach(system: System, y: Floats) -> Floats:
    """Units of the linearization (13n,): of positions, Euler parameters, velocities, angular velocities."""
    count = system.model.body_count
    q, v = y[: 7 * count], y[7 * count :]
    lengths, rates, parts = system.compiled().scales(0.0, q, v)
    rates = np.maximum(rates, _elastic_rates(system, q, v, lengths, parts))
    speeds, spins = np.linalg.norm(v.reshape(-1, 2, 3), axis=2).T
    poses = np.repeat([lengths, np.ones(count)], [3, 4], axis=0)
    motion = np.repeat([np.maximum(lengths * rates, speeds), np.maximum(rates, spins)], 3, axis=0)
    return np.concatenate([poses.T.ravel(), motion.T.ravel()])


def _elastic_rates(system: System, q: Floats, v: Floats, lengths: Floats, parts: Indices) -> Floats:
    """Of each body that of its part [1/s]: what is at rest and in balance has no other."""
    step = np.random.default_rng(2).standard_normal((len(lengths), 7))
    step[:, :3] *= lengths[:, None]
    accelerations = system.compiled().accelerations
    step *= DIFFERENCE
    forth = accelerations(0.0, q + step.ravel(), v)[0]
    back = accelerations(0.0, q - step.ravel(), v)[0]
    change = np.linalg.norm((forth - back).reshape(-1, 2, 3), axis=2) / (2 * DIFFERENCE)
    squares = np.zeros(len(lengths))
    np.maximum.at(squares, parts, np.maximum(change[:, 0] / lengths, change[:, 1]))
    return np.asarray(np.sqrt(squares)[parts])


def _directional(system: System, y: Floats, reach: Floats, z: Floats) -> Floats:
    """Derivative of y_dot along z, both in units of `reach`."""
    dy = DIFFERENCE * reach * z / max(np.abs(z).max(), 1e-300)
    change = system.derivative(0.0, y + dy) - system.derivative(0.0, y - dy)
    return np.asarray(change / (2 * DIFFERENCE * reach) * np.abs(z).max())


def _start(system: System) -> Floats:
    """Velocities at random."""
    count = system.model.body_count
    return np.concatenate([np.zeros(7 * count), np.random.default_rng(1).standard_normal(6 * count)])


def _arnoldi(multiply: Callable[[Floats], Floats], start: Floats) -> tuple[Floats, Floats]:
    """H (k, k) and an orthonormal basis (n, k) with A basis = basis H, nearly."""
    count = min(ITERATIONS, len(start))
    basis = np.zeros((len(start), count + 1))
    H = np.zeros((count + 1, count))
    basis[:, 0] = start / np.linalg.norm(start)
    for k in range(count):
        image = multiply(basis[:, k])
        size = np.linalg.norm(image)
        for _ in range(2):  # twice is enough for orthogonality
            projection = basis[:, : k + 1].T @ image
            image = image - basis[:, : k + 1] @ projection
            H[: k + 1, k] += projection
        H[k + 1, k] = np.linalg.norm(image)
        if H[k + 1, k] <= 1e-10 * size:
            return H[: k + 1, : k + 1], basis[:, : k + 1]
        basis[:, k + 1] = image / H[k + 1, k]
    return H[:count, :count], basis[:, :count]
