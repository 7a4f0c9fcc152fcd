"""Mechanisms of one to three bodies with smooth, brisk motion in space: what integrators are measured on."""

from __future__ import annotations

import linkwork as lw
import numpy as np

X, Y = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])


def spherical_pendulum() -> lw.Model:
    """A body that swings and spins about a ball joint."""
    model = lw.Model()
    center, omega = np.array([0.6, 0.2, -0.5]), np.array([2.0, -4.0, 6.0])
    bob = model.body(
        "bob",
        mass=2.0,
        inertia=(0.3, 0.2, 0.1),
        position=center,
        omega=omega,
        velocity=np.cross(omega, center),
    )
    model.spherical(model.ground, bob, at=(0, 0, 0), name="pivot")
    return model


def two_body_loop() -> lw.Model:
    """Ground, hinge, body, universal joint, body, rod, ground: two degrees of freedom, released at rest."""
    model = lw.Model()
    a = model.body("a", mass=1.0, inertia=(0.02, 0.1, 0.1), position=(0.5, 0, 0))
    b = model.body("b", mass=1.5, inertia=(0.03, 0.15, 0.12), position=(1.0, 0.5, 0.3))
    model.revolute(model.ground, a, at=(0, 0, 0), axis=(0, 1, 0.2), name="hinge")
    model.universal(a, b, at=(1, 0, 0), axes=((0, 1, 0), (1, 0, 1)), name="cross")
    model.distance(b, model.ground, at=((1.0, 1.0, 0.6), (1.5, 1.0, 1.0)), name="rod")
    return model


def slider_crank(speed: float = 6.0) -> lw.Model:
    """A crank of 1 m about x, a rod, and a slider along x, in the proportions of a textbook."""
    model = lw.Model()
    bearing, pin, piston = np.array([0, 0.3, 0]), np.array([0, 0.3, 1.0]), np.array([2.5, 0, 0])
    rod = piston - pin
    across = np.cross(rod, Y)
    pin_velocity = np.cross(speed * X, pin - bearing)
    slider_velocity = (rod @ pin_velocity) / rod[0] * X
    # w x rod = slider_velocity - pin_velocity,   w . (across x y) = 0
    equations = np.vstack([np.cross(np.eye(3), rod).T, np.cross(across, Y)])
    omega = np.linalg.lstsq(equations, np.append(slider_velocity - pin_velocity, 0.0), rcond=None)[0]
    along = lw.rotation.from_axes(rod, across)
    A = lw.rotation.matrix(along)
    crank = model.body(
        "crank", mass=3.0, inertia=(0.3, 0.3, 0.3), position=(bearing + pin) / 2, velocity=pin_velocity / 2,
        omega=speed * X,
    )  # fmt: skip
    coupler = model.body(
        "rod", mass=1.0, inertia=(0.1, 0.8, 0.8), position=(pin + piston) / 2, orientation=along,
        velocity=(pin_velocity + slider_velocity) / 2, omega=A.T @ omega,
    )  # fmt: skip
    slider = model.body(
        "slider", mass=1.0, inertia=(0.1, 0.1, 0.1), position=piston, velocity=slider_velocity
    )
    model.revolute(model.ground, crank, at=bearing, axis=X, name="bearing")
    model.spherical(crank, coupler, at=pin, name="crank pin")
    model.universal(coupler, slider, at=piston, axes=(across, Y), name="piston pin")
    model.translational(model.ground, slider, at=piston, axis=X, name="guide")
    return model


def driven_pendulum() -> lw.Model:
    """A body on a rod whose length is harmonic in time: 0.1 m at 4 rad/s."""
    model = lw.Model()
    start = np.array([0.6, 0.2, -0.5])
    length = float(np.linalg.norm(start))
    lengthening = 0.1 * 4.0 * start / length
    bob = model.body(
        "bob", mass=2.0, inertia=(0.3, 0.2, 0.1), position=start, omega=(1, 2, 3),
        velocity=lengthening + np.cross((0.5, 1.0, 1.5), start),
    )  # fmt: skip
    driven = lw.functions.harmonic(amplitude=0.1, frequency=4.0, offset=length)
    model.distance(model.ground, bob, at=((0, 0, 0), start), length=driven, name="rod")
    return model


def slider_crank_at(angle: float, crank: float = 0.3, rod: float = 1.0) -> lw.Model:
    """In the plane y = 0 with its crank at this angle [rad] to the slider's guide, the x axis."""
    pin = crank * np.array([np.cos(angle), 0, np.sin(angle)])
    end = np.array([pin[0] + np.sqrt(rod**2 - pin[2] ** 2), 0, 0])
    model, Y = lw.Model(), (0, 1, 0)
    for name, position in (("crank", pin / 2), ("rod", (pin + end) / 2), ("piston", end)):
        model.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1), position=position)
    model.revolute("ground", "crank", at=(0, 0, 0), axis=Y, name="bearing")
    model.revolute("crank", "rod", at=pin, axis=Y, name="crank pin")
    model.revolute("rod", "piston", at=end, axis=Y, name="piston pin")
    model.translational("ground", "piston", at=end, axis=(1, 0, 0), name="guide")
    return model
