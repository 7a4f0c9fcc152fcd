"""The terms of a model's equations of motion, as sparse matrices over small motions in inertial axes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwork import _core, rotation
from linkwork.arrays import Floats
from linkwork.constraints.row_choice import RowChoice
from linkwork.modeling.model import Model, check_bodies

__all__ = ["LAST_DIGITS", "Equations", "Sparse", "Terms", "called"]

#: A matrix of scipy.sparse.
Sparse = Any

#: Of positions, relative: what they have no digits for.
LAST_DIGITS = 1e-15

#: Of what acts on a body: what may be rounding of it.
SMALL_PART = 1e-4

#: Of the size of a mechanism: arms that are none; of a body's arms.
HARDLY, NO_ARM = 1e-2, 1e-9

#: Of the largest force in a model: what acts on other bodies is known to no less, by rounding.
DIGITS_OF_LARGEST = 1e-5

#: Motions, in sizes of the mechanism and rad, by which springs may be stretched against each other.
PRELOAD = 1e-6

#: Joints or motions that a message names.
LISTED = 4

#: In what is told of a motion: sizes that differ by this part are equal, smaller components have no sign.
EQUAL, SIGNLESS = 1e-9, 1e-6


@dataclass(frozen=True)
class Terms:
    """At one state. Torques and angular velocities in inertial axes: M x'' - D^T lambda = g where v = 0."""

    D: Sparse  # (m, 6n) compressed rows
    Phi: Floats  # (m,) [m] or [1]
    Phi_t: Floats  # (m,)
    Phi_dot: Floats  # (m,)
    gamma: Floats  # (m,) of D v_dot = gamma
    g: Floats  # (6n,)
    potential: float  # [J]
    force_power: float  # [W]


class Equations:
    """A model with what analyses need of it beside the terms: rank, names, the length that scales rotations.

    ModelError: no bodies.
    """

    def __init__(self, model: Model) -> None:
        check_bodies(model)
        self.model, self.core = model, model.compiled()
        options = _core.Options()
        options.formulation = "augmented_lagrangian"  # takes redundant joints and massless bodies, too
        self.dynamics = _core.Dynamics(self.core, options)
        self.rank = self.dynamics.rank()
        self.length = _size(self.core)
        found = self.dynamics.residuals(0.0, self.core.q0, self.core.v0)
        self.row_lengths, self.rounding = found[2], float(np.max(found[4], initial=0.0))
        self.joint_of_row = np.repeat(np.arange(self.core.joint_count), np.diff(self.core.joint_rows))
        self.holonomic = self._holonomic()
        self._still = np.zeros(6 * self.core.body_count)
        self.scale = np.tile([1.0] * 3 + [1 / self.length] * 3, self.core.body_count)
        self.arms = _arms(self.core, self.length)

    def __reduce__(self) -> tuple[type[Equations], tuple[Model]]:
        """Compiled anew in another process."""
        return Equations, (self.model,)

    @property
    def called(self) -> str:
        """In messages."""
        return called(self.model)

    def terms(self, t: float, q: Floats, v: Floats | None = None) -> Terms:
        """At t [s], q (7n,), v (6n,) as the model has it (omega in body axes), at rest without v."""
        from scipy.sparse import csr_array

        found = self.dynamics.evaluate(t, q, self._still if v is None else v)
        entries, columns, starts = (found["D"][part] for part in ("data", "indices", "indptr"))
        shape = (self.core.row_count, len(self._still))
        in_body = csr_array((entries, columns, starts), shape=shape)
        turn = self.turn(q)
        return Terms(
            D=(in_body @ turn).tocsr(),
            Phi=found["Phi"],
            Phi_t=found["Phi_t"],
            Phi_dot=found["Phi_dot"],
            gamma=found["gamma"],
            g=turn.T @ found["g"],
            potential=found["potential"],
            force_power=found["force_power"],
        )

    def independent(self, D: Sparse) -> NDArray[np.intp]:
        """Rows of this D, that of one pose: as many as are independent away from singular poses."""
        return self._row_choice.of(D)

    @cached_property
    def _row_choice(self) -> RowChoice:
        first = np.delete(np.arange(self.rank.rows), self.rank.redundant_rows)
        choice = RowChoice(first, self.component[self._body_of_row], self.scale)
        choice.of(self.terms(0.0, self.core.q0).D)
        return choice

    def gross_forces(self, t: float, q: Floats, v: Floats) -> Floats:
        """How large what acts on each body is before it adds up (6n,) [N, N m]: where springs balance weights
        nothing is left of it but its rounding."""
        return self._gross(t, q, v, self.length)

    # unit_F = max(F, T / a), unit_T = a unit_F with the arm a of the body
    def acting(self, t: float, q: Floats, v: Floats, multipliers: Floats, K: Sparse) -> Floats:
        """What counts on each body where balance is judged (6n,) [N, N m]: its own gross forces, with those
        of lambda (m,), by its own size; at least those of its stiffness K by small motions, as of springs
        that balance each other; and at least the part of the model's largest that has digits."""
        D = self.terms(t, q, v).D
        own = self._joined(self._gross(t, q, v, self.arms) + abs(D).T @ np.abs(multipliers))
        preload = self._joined(PRELOAD * self.length * (abs(K) @ self.scale))
        size = np.maximum(own, preload)
        return self._apart(np.maximum(size, DIGITS_OF_LARGEST * size.max()) if size.any() else size + 1)

    def beyond_rounding(self, r: Floats, q: Floats, K: Sparse, acting: Floats) -> Floats:
        """r (6n,) where it is more than the stiffness K makes of the last digits of positions, which joints
        pass on from one body to others; or no small part of what is acting."""
        place = max(self.length, float(np.abs(q.reshape(-1, 7)[:, :3]).max()))
        own = self._joined(LAST_DIGITS * place * (abs(K) @ self.scale))
        largest = np.zeros(self.component.max() + 1)
        np.maximum.at(largest, self.component, own)
        rounding = np.minimum(self._apart(largest[self.component]), SMALL_PART * acting)
        return np.where(np.abs(r) > rounding, r, 0.0)

    @cached_property
    def _body_of_row(self) -> NDArray[np.intp]:
        """One of those that the row holds (m,)."""
        found = self.dynamics.evaluate(0.0, self.core.q0, self._still)["D"]
        return np.asarray(found["indices"][found["indptr"][:-1]] // 6)

    @cached_property
    def component(self) -> NDArray[np.intp]:
        """Of each body that which joints connect it with (n,)."""
        from scipy.sparse import csr_array
        from scipy.sparse.csgraph import connected_components

        found = self.dynamics.evaluate(0.0, self.core.q0, self._still)["D"]
        bodies = found["indices"] // 6
        rows = csr_array(
            (np.ones(len(bodies)), bodies, found["indptr"]), shape=(self.core.row_count, self.core.body_count)
        )
        return np.asarray(connected_components(rows.T @ rows, directed=False)[1])

    def _joined(self, parts: Floats) -> Floats:
        """unit_F (n,) of forces and torques (6n,)."""
        force, torque = parts.reshape(-1, 2, 3).max(axis=2).T
        return np.asarray(np.maximum(force, torque / self.arms))

    def _apart(self, unit_F: Floats) -> Floats:
        """Forces and torques (6n,)."""
        return np.column_stack([unit_F, unit_F * self.arms]).repeat(3, axis=1).ravel()

    def _gross(self, t: float, q: Floats, v: Floats, arms: Floats | float) -> Floats:
        """Sizes before they add up (6n,) [N, N m]: of g, weights, and force elements at these arms."""
        core, rest = self.core, np.zeros_like(v)
        parts = np.abs(self.dynamics.evaluate(t, q, v)["g"]).reshape(-1, 2, 3)
        parts[:, 0] += (np.asarray(core.mass) * np.linalg.norm(core.gravity))[:, None]
        arm = np.broadcast_to(arms, len(parts))
        history = np.asarray(self.dynamics.history)
        for element, pair in enumerate(core.force_arrays()["bodies"].reshape(-1, 2)):
            found = self.dynamics.force_element(element, np.array([t]), q, v, rest, history)
            force, torque = (float(np.linalg.norm(it)) for it in found[:2])
            for body in pair[pair >= 0]:
                parts[body] += np.array([[force], [torque + force * arm[body]]])
        gross: Floats = parts.ravel()
        return gross

    def rate(self, v: Floats, gross: Floats) -> float:
        """Of its motion, or of what its gross forces would do one by one [1/s]; 1 where there are none."""
        force = float(np.abs(gross * self.scale).reshape(-1, 6).max(axis=1).sum())
        inertia = self.length * float(np.sum(self.core.mass))
        of_forces = np.sqrt(force / inertia) if inertia > 0 else 0.0
        return max(float(np.abs(v / self.scale).max(initial=0.0)) / self.length, float(of_forces)) or 1.0

    def Phi(self, t: float, q: Floats) -> Floats:
        """(m,) [m] or [1]"""
        found: Floats = self.dynamics.evaluate(t, q, self._still)["Phi"]
        return found

    def violation(self, Phi: Floats) -> float:
        """The largest residual of all, relative to the size of the mechanism."""
        return float((np.abs(Phi) / self.row_lengths).max(initial=0.0))

    def turn(self, q: Floats) -> Sparse:
        """T = diag(I, A^T) (6n, 6n): what has omega in inertial axes to what has it in body axes."""
        from scipy.sparse import bsr_array

        n = self.core.body_count
        blocks = np.zeros((n, 6, 6))
        blocks[:, range(3), range(3)] = 1.0
        blocks[:, 3:, 3:] = np.swapaxes(rotation.matrix(q.reshape(-1, 7)[:, 3:]), 1, 2)
        return bsr_array((blocks, np.arange(n), np.arange(n + 1)), shape=(6 * n, 6 * n)).tocsr()

    def mass(self, q: Floats) -> Sparse:
        """diag(m I, A J A^T) (6n, 6n), and what inerters add to it."""
        from scipy.sparse import bsr_array, csr_array, diags_array

        n = self.core.body_count
        A = rotation.matrix(q.reshape(-1, 7)[:, 3:])
        blocks = np.zeros((n, 6, 6))
        blocks[:, range(3), range(3)] = np.asarray(self.core.mass)[:, None]
        blocks[:, 3:, 3:] = A @ self.core.inertia @ np.swapaxes(A, 1, 2)
        of_bodies = bsr_array((blocks, np.arange(n), np.arange(n + 1)), shape=(6 * n, 6 * n)).tocsr()
        found = self.dynamics.evaluate(0.0, q, self._still)
        if not len(found["inertance"]):
            return of_bodies
        parts = tuple(found["inerters"][part] for part in ("data", "indices", "indptr"))
        rows = csr_array(parts, shape=(len(found["inertance"]), 6 * n)) @ self.turn(q)
        return (of_bodies + rows.T @ diags_array(found["inertance"]) @ rows).tocsr()

    def joints(self, rows: Sequence[int] | NDArray[np.integer[Any]]) -> list[str]:
        """The names of the joints to which these rows belong."""
        found = dict.fromkeys(int(joint) for joint in self.joint_of_row[rows])
        return [self.core.joint_name(joint) for joint in found]

    def motion(self, x: Floats) -> str:
        """The largest part of a small motion x (6n,), in words: `body 'rod' turns about (0, 1, 0)`."""
        parts = x.reshape(-1, 2, 3)
        size = np.linalg.norm(parts, axis=2) * (1.0, self.length)
        size[size > (1 - EQUAL) * size.max()] = size.max()  # of equals the first
        body, kind = divmod(int(np.argmax(size)), 2)
        direction = parts[body, kind] / np.linalg.norm(parts[body, kind])
        direction *= np.sign(direction[np.argmax(np.abs(direction) > SIGNLESS)])
        where = ", ".join(f"{c:.3g}" for c in np.round(direction, 3) + 0.0)
        return f"body '{self.core.body_name(body)}' {'turns about' if kind else 'moves along'} ({where})"

    def _holonomic(self) -> NDArray[np.bool_]:
        """Per row: whether it restricts positions, not velocities only."""
        rows = np.ones(self.core.row_count, dtype=bool)
        counts = {info.name: info.velocity_rows for info in _core.joint_kinds() if info.velocity_rows}
        if counts:
            for joint in range(self.core.joint_count):
                end = self.core.joint_rows[joint + 1]
                rows[end - counts.get(self.core.joint_kind(joint), 0) : end] = False
        return rows


def called(model: Model) -> str:
    """The model 'rig', or the model where it has no name."""
    return f"the model '{model.name}'" if model.name else "the model"


def _size(core: _core.Model) -> float:
    """The largest arm of a joint, or distance of a body from the middle of all [m].

    Where these are as good as none the largest arm of a force element, distance of the middle from a point
    on the ground, or the smallest radius of gyration; 1 for none.
    """
    r = core.q0.reshape(-1, 7)[:, :3]
    middle = r.mean(axis=0)
    arms, way = _reach(core.joint_arrays(), middle)
    size = max(arms, float(np.linalg.norm(r - middle, axis=1).max(initial=0.0)))
    other = max(way, *_reach(core.force_arrays(), middle), _gyration(core))
    return (size if size > HARDLY * other else other) or 1.0


def _reach(elements: dict[str, Any], middle: Floats) -> tuple[float, float]:
    """The largest arm on a body, and distance of a point on the ground from the middle [m]."""
    on_bodies, origin = elements["bodies"] >= 0, elements["origin"]
    way = np.linalg.norm(origin[~on_bodies] - middle, axis=1)
    return float(np.abs(origin[on_bodies]).max(initial=0.0)), float(way.max(initial=0.0))


def _arms(core: _core.Model, length: float) -> Floats:
    """The size of each body (n,) [m]: its largest arm, or radius of gyration; `length` where it has none."""
    arms = _radii(core)
    for elements in (core.joint_arrays(), core.force_arrays()):
        on_bodies = elements["bodies"] >= 0
        reach = np.linalg.norm(elements["origin"][on_bodies], axis=-1)
        np.maximum.at(arms, elements["bodies"][on_bodies], reach)
    out: Floats = np.where(arms > NO_ARM * length, arms, length)
    return out


def _radii(core: _core.Model) -> Floats:
    """The bodies' radii of gyration (n,) [m]; 0 without mass or inertia."""
    mass = np.asarray(core.mass)
    inertia = np.trace(np.asarray(core.inertia), axis1=1, axis2=2)
    squares: Floats = np.divide(inertia, 2 * mass, out=np.zeros_like(mass), where=mass > 0)
    return np.sqrt(squares)


def _gyration(core: _core.Model) -> float:
    """The smallest of the bodies' radii of gyration [m]; 0 where none has mass and inertia."""
    radii = _radii(core)
    return float(radii[radii > 0].min()) if (radii > 0).any() else 0.0
