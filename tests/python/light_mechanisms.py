"""Random mechanisms with thin rods, point masses and massless bodies, and their accelerations."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st
from linkwork.arrays import Floats
from random_mechanisms import Equations, Mechanism, mechanisms

#: Small moments, relative to the others of the body.
RATIOS = (0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2)

#: The least inertia of a motion that joints allow, relative to those of compact bodies: below, nearly nothing
#: decides it.
DECIDED = 1e-6


@dataclass(frozen=True)
class Light:
    """A mechanism with small inertias, its equations, and the masses of compact bodies in their places."""

    mechanism: Mechanism
    at: Equations
    compact: Floats  #: (6n,) diagonal of a mass matrix

    def solution(self) -> tuple[Floats, Floats]:
        """(v_dot, lambda) of [M -D^T; D 0], scaled by the compact masses, refined in extended precision."""
        M, D = self.at.M, self.at.D
        n, m = len(M), len(D)
        K = np.block([[M, -D.T], [D, np.zeros((m, m))]])
        weight = 1 / np.sqrt(np.concatenate([self.compact, np.einsum("ij,ij->i", D, D / self.compact)]))
        long_K = K.astype(np.longdouble)
        right = np.concatenate([self.at.g, self.at.gamma]).astype(np.longdouble)
        scaled_inverse = np.linalg.inv(weight[:, None] * K * weight)
        x = np.zeros(n + m, np.longdouble)
        for _ in range(6):
            x += weight * (scaled_inverse @ (weight * (right - long_K @ x)).astype(float))
        return x[:n].astype(float), x[n:].astype(float)

    def least_decided(self) -> float:
        """The least eigenvalue of M on ker D, M and D scaled by the compact masses."""
        root = 1 / np.sqrt(self.compact)
        M, D = root[:, None] * self.at.M * root, self.at.D * root
        _, sigma, V = np.linalg.svd(D, full_matrices=True)
        Z = V[len(sigma) :].T
        return float(np.linalg.eigvalsh(Z.T @ M @ Z)[0]) if Z.shape[1] else 1.0


def lighten(mechanism: Mechanism, seed: int, ratio: float, part: float = 0.6) -> Mechanism:
    """A part of the bodies become rods, with a small moment about an axis, points or massless bodies."""
    rng, bodies = np.random.default_rng(seed), []
    for body in mechanism.bodies:
        moments, axes = np.linalg.eigh(body.inertia)
        if rng.random() < part:
            kind = rng.integers(3)
            moments = moments[2] * np.array([ratio, 1.0, 1.0] if kind else [ratio] * 3)
            if kind == 2:
                axes = np.eye(3)
        bodies.append(replace(body, inertia=axes @ np.diag(moments) @ axes.T))
    return replace(mechanism, bodies=tuple(bodies), origin=f"lighten({mechanism.origin}, {seed}, {ratio})")


def equations_of(mechanism: Mechanism, original: Mechanism) -> Light:
    """Those of `original`, whose bodies are compact, but for the masses and the gyroscopic torques."""
    at, M = Equations.of(original), Equations.of(original).M.copy()
    g = at.g.copy()
    for k, (body, before) in enumerate(zip(mechanism.bodies, original.bodies, strict=True)):
        part = slice(6 * k + 3, 6 * k + 6)
        M[part, part] += body.inertia - before.inertia
        g[part] -= np.cross(body.omega, (body.inertia - before.inertia) @ body.omega)
    return Light(mechanism, replace(at, M=M, g=g), np.diag(at.M))


@st.composite
def light_mechanisms(draw: Callable[[Any], Any], ratios: tuple[float, ...] = RATIOS, **choices: Any) -> Light:
    """Their motion is decided by joints and by the rest of the bodies."""
    original = draw(mechanisms(**choices))
    seed, ratio = draw(st.integers(0, 2**32 - 1)), draw(st.sampled_from(ratios))
    light = equations_of(lighten(original, seed, ratio), original)
    assume(light.least_decided() > DECIDED)
    return light
