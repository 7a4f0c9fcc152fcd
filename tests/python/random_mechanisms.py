"""Random spatial mechanisms as plain data, and hypothesis strategies for them.

A `Mechanism` is what a user would type: bodies, joints and forces in body coordinates. Because it is data, a
test can turn it, renumber it, swap the bodies of its joints or change its units, and build both as models.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Any

import linkwork as lw
import numpy as np
from hypothesis import HealthCheck, Phase, assume, settings
from hypothesis import seed as seeded
from hypothesis import strategies as st
from linkwork import _core
from linkwork.arrays import Floats

JOINTS = {kind.name: kind for kind in _core.joint_kinds()}
FORCES = {kind.name: kind for kind in _core.force_kinds()}

#: Joints whose points may differ along the axis, and whose x axes may differ about it, at no violation.
SLIDING, TURNING = ("cylindrical", "translational"), ("cylindrical", "revolute")

#: Smallest singular value of D, rows of unit length in the metric M^-1, that counts as full row rank.
#: Solutions of the Schur system are off by roundoff / s_min^2: below this, 1e-9 could not be asked of them.
RANK = 1e-3

#: Singular values below this, relative, are zero.
ZERO = 1e-9


def examples(count: int, shared: int | None = None) -> Callable[[Any], Any]:
    """Settings of a property test: the same examples in every run.

    shared  a seed: the parameters of the test, such as solvers, have the same examples, which are made once
            for all of them; None: each has examples of its own

    The environment variable LINKWORK_EXAMPLES multiplies their number, draws them at random, and makes those
    that fail smaller, which takes minutes.
    """
    factor = float(os.environ.get("LINKWORK_EXAMPLES", "0"))
    chosen = settings(
        max_examples=int(count * factor) if factor else count,
        derandomize=not factor,
        deadline=None,
        database=None,
        phases=list(Phase) if factor else [Phase.explicit, Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    return chosen if factor or shared is None else lambda test: chosen(seeded(shared)(test))


@dataclass(frozen=True)
class Body:
    """Mass, inertia (3, 3) about the center of mass, pose and velocity; omega body-fixed."""

    mass: float
    inertia: Floats
    r: Floats
    p: Floats
    r_dot: Floats
    omega: Floats


@dataclass(frozen=True)
class Element:
    """A joint or force between bodies a and b (-1 = ground): points s, frames C (columns x, y, z) in each."""

    kind: str
    a: int
    b: int
    s: tuple[Floats, Floats]
    C: tuple[Floats, Floats]
    parameters: tuple[Any, ...] = ()  #: numbers or functions of time, in the order of the kind
    name: str = ""


@dataclass(frozen=True, repr=False, eq=False)
class Mechanism:
    gravity: Floats
    bodies: tuple[Body, ...]
    joints: tuple[Element, ...]
    forces: tuple[Element, ...]
    origin: str = ""  #: how it was drawn

    def __repr__(self) -> str:
        return self.origin

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:
        printer.text(self.origin)  # what hypothesis shows

    @cached_property
    def model(self) -> lw.Model:
        """Through the public interface; bodies are named "body 0", ..."""
        model = lw.Model(gravity=self.gravity)
        handles = [
            model.body(
                f"body {k}", mass=body.mass, inertia=body.inertia, position=body.r, orientation=body.p,
                velocity=body.r_dot, omega=body.omega,
            )
            for k, body in enumerate(self.bodies)
        ]  # fmt: skip
        handles.append(model.ground)  # index -1
        for joint in self.joints:
            add = getattr(model, joint.kind)
            add(
                handles[joint.a],
                handles[joint.b],
                frames="body",
                name=joint.name,
                **_arguments(JOINTS, joint),
            )
        for force in self.forces:
            model.forces(
                force.kind, handles[force.a], handles[force.b], frames="body", **_arguments(FORCES, force)
            )
        return model

    @cached_property
    def equations(self) -> Equations:
        """At the initial state."""
        return Equations.at(self, 0.0, self.q, self.v)

    def dynamics(self, **options: Any) -> _core.Dynamics:
        chosen = _core.Options()
        for name, value in options.items():
            setattr(chosen, name, value)
        return _core.Dynamics(self.model.compiled(), chosen)

    @property
    def q(self) -> Floats:
        return np.concatenate([np.concatenate([body.r, body.p]) for body in self.bodies])

    @property
    def v(self) -> Floats:
        return np.concatenate([np.concatenate([body.r_dot, body.omega]) for body in self.bodies])

    @lru_cache(maxsize=256)  # noqa: B019 for parameters of a test that share their examples
    def with_masses(self, factors: tuple[float, ...]) -> Mechanism:
        """Masses and inertias times such factors, one for each body."""
        pairs = zip(self.bodies, factors, strict=True)
        return replace(
            self, bodies=tuple(replace(it, mass=f * it.mass, inertia=f * it.inertia) for it, f in pairs)
        )

    def with_velocity(self, v: Floats) -> Mechanism:
        pairs = zip(self.bodies, v.reshape(-1, 6), strict=True)
        return replace(self, bodies=tuple(replace(body, r_dot=x[:3], omega=x[3:]) for body, x in pairs))


def _arguments(kinds: dict[str, Any], element: Element) -> dict[str, Any]:
    """Arguments of the public interface (`frames="body"`), by the placement of the kind."""
    (s_a, s_b), (C_a, C_b) = element.s, element.C
    kind = kinds[element.kind]
    place: dict[str, Any] = {}
    if kind.placement == "plane":
        place["normal"] = C_a[:, 2]
    if kind.placement not in ("direction", "two_directions", "orientation"):
        place["at"] = s_a, s_b
    if kind.placement in ("axis", "direction"):
        place |= {"axis": (C_a[:, 2], C_b[:, 2]), "x_axis": (C_a[:, 0], C_b[:, 0])}
    elif kind.placement == "centers":
        place["axis"] = C_a[:, 2], C_b[:, 2]
    elif kind.placement in ("two_axes", "two_directions", "shafts", "disc"):
        place["axes"] = C_a[:, 2], C_b[:, 2]
    elif kind.placement in ("frame", "orientation"):
        place |= {"orientation": (lw.rotation.from_matrix(C_a), lw.rotation.from_matrix(C_b))}
    return place | dict(zip(kind.parameters, element.parameters, strict=True))


# --- the equations as dense matrices ------------------------------------------------------------------------


@dataclass(frozen=True)
class Equations:
    """M v_dot - D^T lambda = g, D v_dot = gamma at a state, dense."""

    M: Floats
    D: Floats
    Phi: Floats
    Phi_t: Floats
    Phi_dot: Floats
    gamma: Floats
    g: Floats
    bodies: Floats  #: M without inerters

    @classmethod
    def of(cls, mechanism: Mechanism) -> Equations:
        return mechanism.equations

    @classmethod
    def at(cls, mechanism: Mechanism, t: float, q: Floats, v: Floats) -> Equations:
        at = mechanism.dynamics(formulation="penalty").evaluate(t, q, v)
        bodies = block_diagonal(at["M"])
        M = bodies.copy()
        d = dense(at["inerters"], (len(at["inertance"]), len(M)))
        M += d.T @ np.diag(at["inertance"]) @ d
        D = dense(at["D"], (len(at["Phi"]), len(M)))
        return cls(M, D, *(at[name] for name in ("Phi", "Phi_t", "Phi_dot", "gamma", "g")), bodies)

    @cached_property
    def scaled_D(self) -> Floats:
        """D M^-1/2 with rows of unit length."""
        D = np.linalg.solve(np.linalg.cholesky(self.M), self.D.T).T
        scaled: Floats = D / np.linalg.norm(D, axis=1, keepdims=True)
        return scaled

    @cached_property
    def free_v_dot(self) -> Floats:
        """M^-1 g: what the bodies would do without joints."""
        return np.linalg.solve(self.M, self.g)

    @property
    def smallest_singular_value(self) -> float:
        """0 where there are more rows than velocities."""
        rows, columns = self.D.shape
        if rows == 0:
            return 1.0
        return float(np.linalg.svd(self.scaled_D, compute_uv=False)[-1]) if rows <= columns else 0.0

    @cached_property
    def solution(self) -> tuple[Floats, Floats]:
        """(v_dot, lambda) by dense LU of the KKT matrix, refined with residuals in extended precision."""
        n, m = len(self.M), len(self.D)
        K = np.block([[self.M, self.D.T], [self.D, np.zeros((m, m))]])
        weight = 1 / np.sqrt(
            np.concatenate([np.diag(self.M), np.einsum("ij,ij->i", self.D, self.D @ np.linalg.inv(self.M))])
        )
        long_K, right = K.astype(np.longdouble), np.concatenate([self.g, self.gamma]).astype(np.longdouble)
        scaled_inverse = np.linalg.inv(weight[:, None] * K * weight)
        x = np.zeros(n + m, np.longdouble)
        for _ in range(5):
            x += weight * (scaled_inverse @ (weight * (right - long_K @ x)).astype(float))
        return x[:n].astype(float), -x[n:].astype(float)


def mean_delassus_diagonal(mechanism: Mechanism, at: Equations) -> Floats:
    """diag(D M^-1 D^T) without inerters, the mean over each joint's translations and over its rotations."""
    delassus = np.einsum("ij,ji->i", at.D, np.linalg.solve(at.bodies, at.D.T))
    out, row = delassus.copy(), 0
    for joint in mechanism.joints:
        names = JOINTS[joint.kind].equations
        for rotation in (False, True):
            group = [
                row + k for k, it in enumerate(names.values()) if (it.quantity == "rotation") == rotation
            ]
            if group:
                out[group] = delassus[group].mean()
        row += len(names)
    return out


def block_diagonal(blocks: Floats) -> Floats:
    n, size = len(blocks), blocks.shape[1]
    out = np.zeros((n, size, n, size))
    out[np.arange(n), :, np.arange(n), :] = blocks
    return out.reshape(n * size, n * size)


def dense(csr: dict[str, Any], shape: tuple[int, int]) -> Floats:
    """A matrix in compressed rows as an array; repeated entries add up."""
    out = np.zeros(shape)
    rows = np.repeat(np.arange(shape[0]), np.diff(csr["indptr"]))
    np.add.at(out, (rows, csr["indices"]), csr["data"])
    return out


# --- how mechanisms are drawn -------------------------------------------------------------------------------


class Maker:
    """Random parts from one seed: structure is hypothesis' to shrink, numbers are not."""

    def __init__(self, seed: int) -> None:
        self.rng = np.random.default_rng(seed)
        self.bodies: list[Body] = []

    def vector(self, scale: float = 1.0) -> Floats:
        return scale * self.rng.uniform(-1, 1, 3)

    def orientation(self) -> Floats:
        p = self.rng.standard_normal(4)
        unit: Floats = p / np.linalg.norm(p)
        return unit

    def body(self, near: int) -> None:
        """Masses from 0.03 to 30 kg; the inertia of four masses at random places within about 0.5 m."""
        mass = 10 ** self.rng.uniform(-1.5, 1.5)
        points = 0.5 * self.rng.standard_normal((4, 3))
        points -= points.mean(axis=0)
        spread = mass * points.T @ points / 4 + 0.01 * mass * np.eye(3)
        inertia = np.trace(spread) * np.eye(3) - spread
        center = self.bodies[near].r if near >= 0 else np.zeros(3)
        self.bodies.append(
            Body(mass, inertia, center + self.vector(1.5), self.orientation(), np.zeros(3), np.zeros(3))
        )

    def pose(self, body: int) -> tuple[Floats, Floats]:
        if body < 0:
            return np.zeros(3), np.eye(3)
        return self.bodies[body].r, lw.rotation.matrix(self.bodies[body].p)

    def element(self, kind: Any, a: int, b: int, parameters: tuple[Any, ...] = (), name: str = "") -> Element:
        """Placed so that a joint of this kind holds at the initial pose."""
        (r_a, A_a), (r_b, A_b) = self.pose(a), self.pose(b)
        C_a = lw.rotation.matrix(self.orientation())
        P_a = 0.5 * (r_a + r_b) + self.vector(0.7)
        P_b, C_b = P_a, C_a
        if kind.name in SLIDING:
            P_b = P_a + self.rng.uniform(-0.5, 0.5) * C_a[:, 2]
        if kind.name in TURNING:
            C_b = C_a @ about_z(self.rng.uniform(-3, 3))
        if kind.placement in ("two_axes", "two_directions"):  # z_b along y of the common frame, x along x
            C_a, C_b = C_a, C_a @ np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]], float).T
        if kind.placement == "two_points":
            P_b = P_a + self.vector() + np.array([0.5, 0, 0])
        if kind.placement == "centers":
            P_b = P_a + self.rng.uniform(0.3, 1.0) * C_a[:, 0]
        if kind.placement in ("shafts", "disc"):
            C_b = lw.rotation.matrix(lw.rotation.about(C_a[:, 0], self.rng.uniform(0.5, 1.2))) @ C_a
        if kind.placement == "disc":
            down = (C_a[:, 2] @ C_b[:, 2]) * C_b[:, 2] - C_a[:, 2]
            P_a = P_b + kind.parameters["radius"].example * down / np.linalg.norm(down)
        if kind.name in FORCES and kind.placement in ("axis", "frame"):
            C_b = lw.rotation.matrix(self.orientation())
        if kind.name in JOINTS:
            distance = float(np.linalg.norm(P_b - P_a))
            parameters = tuple(self.parameter(it, distance) for it in kind.parameters.values())
        s = A_a.T @ (P_a - r_a), A_b.T @ (P_b - r_b)
        return Element(kind.name, a, b, s, (A_a.T @ C_a, A_b.T @ C_b), parameters, name)

    def parameter(self, info: _core.ParameterInfo, distance: float) -> Any:
        """Of a joint: a length, a motion from zero, or a constant."""
        if info.initial_distance:
            return self.length(distance)
        if info.constant:
            return info.example
        return lw.functions.polynomial(0.0, self.rng.uniform(-1, 1), self.rng.uniform(-1, 1))

    def length(self, distance: float) -> Any:
        """Constant, or a harmonic or parabola through the initial distance."""
        choice = self.rng.integers(3)
        if choice == 0:
            return distance
        if choice == 1:
            rate, bend = self.rng.uniform(-1, 1), self.rng.uniform(0.3, 1)  # bend: never down to zero
            return lw.functions.polynomial(distance, rate, bend * rate**2 / distance)
        amplitude, phase = self.rng.uniform(0, 0.3) * distance, self.rng.uniform(-3, 3)
        return lw.functions.harmonic(
            amplitude, self.rng.uniform(0, 5), phase, distance - amplitude * np.sin(phase)
        )

    def force(self, kind: Any, a: int, b: int) -> Element:
        parameters = tuple(map(self.quantity, kind.parameters.values()))
        return self.element(kind, a, b, parameters)

    def quantity(self, info: _core.ParameterInfo) -> Any:
        """A number; for a third of the forces a function of time."""
        value = info.example * self.rng.uniform(max(0.1, (info.least or 0.0) / info.example), 1)
        if info.name.startswith(("force", "torque")):
            value *= self.rng.choice([-1, 1])
            if self.rng.random() < 1 / 3:
                return lw.functions.harmonic(
                    value, self.rng.uniform(0, 10), self.rng.uniform(-3, 3), value / 2
                )
        return float(value)


def about_z(angle: float) -> Floats:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


@st.composite
def mechanisms(
    draw: Callable[[Any], Any],
    most: int = 30,
    floating: bool | None = None,
    forces: Sequence[str] = tuple(FORCES),
    kinds: Sequence[str] = tuple(JOINTS),
    **choices: Any,
) -> Mechanism:
    """2 to `most` bodies in a tree of joints of every kind, with loops where they keep full row rank.

    The initial state is consistent.

    floating  without any joint to the ground; None: either
    forces    kinds of force elements         kinds    of joints         choices  see `make`
    """
    joint_kinds = st.sampled_from(sorted(kinds))
    count = draw(st.integers(2, most))
    mechanism = _made(
        seed=draw(st.integers(0, 2**32 - 1)),
        joints=tuple(draw(st.lists(joint_kinds, min_size=count, max_size=count))),
        loops=tuple(draw(st.lists(joint_kinds, max_size=1 + count // 3))),
        forces=tuple(draw(st.lists(st.sampled_from(sorted(forces)), max_size=4))) if forces else (),
        floating=draw(st.booleans()) if floating is None else floating,
        **choices,
    )
    assume(Equations.of(mechanism).smallest_singular_value > RANK)
    return mechanism


@lru_cache(maxsize=256)
def _made(**given: Any) -> Mechanism:
    """For parameters of a test that share their examples."""
    return make(**given)


def make(
    seed: int,
    joints: Sequence[str],
    loops: Sequence[str] = (),
    forces: Sequence[str] = (),
    floating: bool = False,
    driven: bool = True,
    isolated: bool = False,
) -> Mechanism:
    """A mechanism with one body for each of the kinds in `joints`, and those `loops` that keep full row rank.

    floating  the first body is free, and nothing else is joined to the ground
    driven    distances may change in time
    isolated  no gravity, and springs only between bodies
    """
    maker = Maker(seed)
    tree = _tree(maker, joints, floating)
    pairs = [_acted_on(kind, *_two_bodies(maker, 0 if isolated else -1)) for kind in forces]
    elements = [maker.force(FORCES[kind], a, b) for kind, (a, b) in zip(forces, pairs, strict=True)]
    gravity = np.zeros(3) if isolated else maker.vector(10.0)
    given = {"joints": list(joints), "loops": list(loops), "forces": list(forces), "floating": floating}
    origin = ", ".join(f"{name}={value!r}" for name, value in given.items())
    origin = f"make({seed}, {origin}, driven={driven}, isolated={isolated})"
    mechanism = Mechanism(gravity, tuple(maker.bodies), tuple(tree), tuple(elements), origin)
    kept = Equations.of(mechanism)
    for kind in loops:
        loop = maker.element(JOINTS[kind], *_two_bodies(maker, 0 if floating else -1))
        loop = replace(loop, name=f"joint {len(mechanism.joints)}")
        rows = Equations.of(replace(mechanism, joints=(loop,), forces=())).D  # of this joint alone: soon made
        closed = replace(kept, D=np.vstack([kept.D, rows]))
        if closed.smallest_singular_value > RANK:
            kept, mechanism = closed, replace(mechanism, joints=(*mechanism.joints, loop))
    if not driven:
        mechanism = replace(mechanism, joints=tuple(_at_rest(joint) for joint in mechanism.joints))
    return consistent(mechanism, maker)


def _tree(maker: Maker, kinds: Sequence[str], floating: bool) -> list[Element]:
    """Each body hangs on an earlier one, half of the time the last, or the ground; in either direction."""
    joints: list[Element] = []
    for k, kind in enumerate(kinds):
        root = k == 0
        parent = (
            k - 1 if maker.rng.random() < 0.5 else int(maker.rng.integers(0 if floating else -1, max(k, 1)))
        )
        parent = -1 if root else parent
        maker.body(parent)
        if root and floating:
            continue
        a, b = (parent, k) if maker.rng.random() < 0.7 else (k, parent)
        joints.append(maker.element(JOINTS[kind], a, b, name=f"joint {len(joints)}"))
    return joints


def _two_bodies(maker: Maker, lowest: int) -> tuple[int, int]:
    a, b = maker.rng.choice(np.arange(lowest, len(maker.bodies)), 2, replace=False)
    return int(a), int(b)


def _acted_on(kind: str, a: int, b: int) -> tuple[int, int]:
    """What acts on b alone does not act on the ground."""
    return (b, a) if kind in ("applied", "drag") and b < 0 else (a, b)


def _at_rest(joint: Element) -> Element:
    """With the initial length instead of a function of time."""
    fixed = (x.evaluate(0.0)[0] if isinstance(x, lw.functions.TimeFunction) else x for x in joint.parameters)
    return replace(joint, parameters=tuple(fixed))


def consistent(mechanism: Mechanism, maker: Maker) -> Mechanism:
    """With random velocities projected on D v + Phi_t = 0 in the metric M."""
    v = np.concatenate([maker.vector(1.0) for _ in range(2 * len(mechanism.bodies))])
    at = Equations.at(mechanism, 0.0, mechanism.q, v)
    if not len(at.D):
        return mechanism.with_velocity(v)
    root = np.linalg.inv(np.linalg.cholesky(at.M))
    correction = root.T @ np.linalg.lstsq(at.D @ root.T, -at.Phi_dot, rcond=ZERO)[0]
    return mechanism.with_velocity(v + correction)


# --- planted redundancy -------------------------------------------------------------------------------------

#: A joint there twice, a weaker one inside another, hinges with parallel axes in a ring, one link too many.
PLANTS = ("twice", "within", "planar loop", "parallelogram")


@st.composite
def redundant_mechanisms(draw: Callable[[Any], Any], most: int = 8) -> Mechanism:
    """Random trees on which redundant joints and loops have been planted; the initial state is consistent."""
    mechanism = plant(
        seed=draw(st.integers(0, 2**32 - 1)),
        joints=draw(st.lists(st.sampled_from(sorted(JOINTS)), min_size=1, max_size=most)),
        plants=draw(st.lists(st.sampled_from(PLANTS), min_size=1, max_size=3)),
    )
    sigma = np.linalg.svd(Equations.of(mechanism).scaled_D, compute_uv=False)
    assume(not np.any((sigma > ZERO * sigma[0]) & (sigma < RANK)))
    return mechanism


def plant(seed: int, joints: Sequence[str], plants: Sequence[str]) -> Mechanism:
    """A tree with one body for each of `joints`, and `plants` on bodies and joints of it."""
    maker = Maker(seed)
    elements = [_at_rest(joint) for joint in _tree(maker, joints, floating=False)]
    for kind in plants:
        elements += _planted(maker, kind, elements)
    named = tuple(replace(joint, name=f"joint {k}") for k, joint in enumerate(elements))
    origin = f"plant({seed}, joints={list(joints)}, plants={list(plants)})"
    return consistent(Mechanism(maker.vector(10.0), tuple(maker.bodies), named, (), origin), maker)


def _planted(maker: Maker, kind: str, elements: Sequence[Element]) -> list[Element]:
    if kind == "twice":
        return [elements[maker.rng.integers(len(elements))]]
    if kind == "within":
        pointed = [
            joint for joint in elements if joint.kind in ("revolute", "universal", "fixed", "spherical")
        ]
        return [replace(pointed[maker.rng.integers(len(pointed))], kind="spherical")] if pointed else []
    host = int(maker.rng.integers(-1, len(maker.bodies)))
    C = lw.rotation.matrix(maker.orientation())
    origin = maker.pose(host)[0] + maker.vector()

    def in_plane() -> Floats:
        point: Floats = origin + C[:, :2] @ maker.rng.uniform(-1, 1, 2)
        return point

    def hinge(a: int, b: int, point: Floats) -> Element:
        (r_a, A_a), (r_b, A_b) = maker.pose(a), maker.pose(b)
        shifted = point + maker.rng.uniform(-0.3, 0.3) * C[:, 2]
        s = A_a.T @ (shifted - r_a), A_b.T @ (shifted - r_b)
        return Element("revolute", a, b, s, (A_a.T @ C, A_b.T @ C))

    def link() -> int:
        maker.body(host)
        return len(maker.bodies) - 1

    if kind == "planar loop":
        ring = [host, *(link() for _ in range(maker.rng.integers(3, 5))), host]
        return [hinge(a, b, in_plane()) for a, b in pairwise(ring)]
    coupler, across = link(), C[:, :2] @ maker.rng.uniform(0.3, 1, 2)
    cranks = [(link(), in_plane()) for _ in range(3)]
    return [
        joint
        for crank, foot in cranks
        for joint in (hinge(host, crank, foot), hinge(crank, coupler, foot + across))
    ]
