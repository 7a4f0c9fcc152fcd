"""Static equilibrium: where forces and reactions balance, and whether the mechanism returns there."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from linkwork.analyses.constraint_solver import (
    DENSE,
    balance,
    check_regular,
    null_space,
    saddle_point,
    shared,
)
from linkwork.analyses.equations import LAST_DIGITS, Equations, Sparse
from linkwork.analyses.stiffness import Stiffness, stiffness, stiffness_and_parts
from linkwork.analyses.tangent import between, displaced
from linkwork.arrays import Floats, ReadOnly
from linkwork.errors import (
    ModelError,
    NotConvergedError,
    NotFiniteError,
    OptionError,
    SingularSystemError,
    nearest,
)
from linkwork.modeling.model import Model
from linkwork.motion.records import Reaction, Snapshot
from linkwork.running.estimation import told_of_memory

__all__ = ["Equilibrium", "equilibrium"]

#: Forces not in balance, relative to what acts on their body: where the iteration may end, and tries to.
ACCEPTED, WANTED = 1e-9, 1e-13

#: Steps below this part of the size of the mechanism are rounding; and where others have settled.
ROUNDING, SETTLED = 1e-13, 1e-9

#: Violations of joints, relative to the size of the mechanism: none, and what rounding may leave.
MET, NEARLY_MET = 1e-13, 1e-10

#: The most a step may move a body [rad, sizes of the mechanism]; how much longer the next one may be where
#: the imbalance falls in steps of at least that part of it; and the most [rad] of turns that are counted.
LONGEST_STEP, LONGER, LONG, LONGEST_TURN = 0.3, 1.5, 0.25, 1.2

#: How the damping mu of the steps falls after one that was good at once, and grows after one that was not:
#: little, as where the stiffness is negative a step is long only next to the least mu; mu that is none.
FALL, GROWTH, UNDAMPED = 10.0, 3.0, 1e-9

#: The same: the least, the first that damps, and the most.
LEAST_DAMPING, FIRST_DAMPING, MOST_DAMPING = 1e-13, 1e-4, 1e12

#: Steps [rad, sizes of the mechanism] in which rounding hides the work of the forces.
TINY_STEP = 1e-7

#: A body that has turned so often [rad] while the imbalance did not fall by this part goes round for ever,
#: unless turns are counted: it may come to a stop.
ROUND, PROGRESS = 4 * np.pi, 0.01

#: The most that a body may turn in a step, corrections onto the joints included, for its turns to be counted.
COUNTED_TURN = np.pi / 2

#: Of steps in which the imbalance does not fall, and of all; of corrections onto the joints, and of
#: departures from unstable equilibria.
ITERATIONS, ALL_ITERATIONS, CORRECTIONS, DEPARTURES = 400, 4000, 20, 5

#: Of the stiffness, relative, where it counts as that of forces with a potential.
ASYMMETRY = 1e-7

#: Stiffness below this part of the terms that it is the sum of, and of the largest, counts as none.
NEUTRAL, EPSILON = 1e-9, 1e-14


@dataclass(frozen=True, eq=False)
class Equilibrium(ReadOnly):
    """A model at rest in balance: g + D^T lambda = 0, Phi = 0."""

    model: Model  #: the given one in this pose, at rest
    moved: Floats  #: shift of each center of mass (n,) [m]
    turned: Floats  #: angle by which each body was turned, at most pi (n,) [rad]
    multipliers: Floats  #: (m,); of redundant equations those of least norm
    #: largest force, or torque over size, of a body that is not balanced, relative to what acts on it before
    #: it adds up, reactions included; to 1e-5 of the largest such force in the model where that is more; 0
    #: where it is no more than stiffness makes of the last digits of positions
    imbalance: float
    softest: float  #: smallest stiffness among the motions that the joints leave [N/m]; NaN: there is none
    softest_motion: str  #: which this is, in words
    stability: Literal["stable", "neutral", "unstable"]
    iterations: int
    _equations: Equations = field(repr=False)

    def reaction(self, name: str) -> Reaction:
        """Force and torque (3,) of a joint on its second body, inertial axes.

            rest.reaction("pin").force

        ModelError: no joint.
        """
        core = self.model.compiled()
        joint = core.find_joint(name)
        if joint < 0:
            known = [core.joint_name(k) for k in range(core.joint_count)]
            raise ModelError(f"no joint named '{name}'{nearest(name, known)}", code="unknown_name")
        force, torque = self.reactions()
        return Reaction(force[joint], torque[joint])

    def reactions(self) -> Reaction:
        """
        Of all joints: force and torque (J, 3).

            largest = np.linalg.norm(rest.reactions().force, axis=1).max()
        """
        if not self.model.joint_count:
            return Reaction(np.zeros((0, 3)), np.zeros((0, 3)))
        q = np.array(self.model.compiled().q0)
        force, torque = self._equations.dynamics.reactions(np.zeros(1), q[None], self.multipliers[None])
        return Reaction(force[0], torque[0])

    def __str__(self) -> str:
        """One line."""
        soft = f": softest, {self.softest:.4g} N/m, {self.softest_motion}" if self.softest_motion else ""
        return (
            f"{self.stability} equilibrium after {self.iterations} steps; bodies moved by at most "
            f"{self.moved.max():.4g} m and {self.turned.max():.4g} rad; imbalance {self.imbalance:.1e}{soft}"
        )


def equilibrium(model: Model, *, stable: bool = True) -> Equilibrium:
    """Where the mechanism rests, found from its initial pose; drivers and forces as they are at t = 0.

        rest = lw.equilibrium(model)
        print(rest)
        lw.simulate(rest.model, t_end=1.0, step=1e-3)

    g(q, 0) + D^T lambda = 0 and Phi(q, 0) = 0 by Newton's method with the full stiffness, that of the
    constraints included. Steps are limited, and shortened until the forces do work along them, so that the
    mechanism goes down, as it would with much friction: to a stable equilibrium, away from an unstable one.
    Forces of rest count: dampers and regularized friction have none. Masses count by their weight only.
    Springs, stops, laws and couplers count full turns on the way.

    stable  False: the nearest equilibrium of any kind, by steps that reduce the imbalance

    `stability` is that of the stiffness; a rotation counts by the size of the mechanism. Where forces follow
    the bodies, linkwork.linearize has the last word.

    NotConvergedError: no equilibrium, with the body that is driven most, or that goes round and round, as by
    a motor against friction, which does not hold at rest; the error's `state` is the pose that was reached.
    SingularSystemError: a singular pose, as of a parallelogram that rests folded flat: there stiffness tells
    nothing; `state` as well. OptionError: `stable` is no truth value. LinkworkWarning: it is nearly singular;
    functions of the model remember calls, so that it may rest elsewhere.
    """
    if not isinstance(stable, bool):
        raise OptionError(f"stable {stable!r:.80} is not True or False", code="stable")
    with told_of_memory(model, "equilibrium"):
        search = _Search(Equations(model), stable)
        return search.described(search.find())


#: q, and the r and lambda of `_Search._balance` there.
_Balanced = tuple[Floats, Floats, Floats]


@dataclass
class _Way:
    """How far bodies have turned, and in how many steps, since the imbalance was last seen to fall."""

    best: float
    turned: Floats  # (n, 3) sums of rotation vectors [rad]
    last: float
    steps: int = 0
    longest: float = LONGEST_STEP  #: of the next step [sizes of the mechanism]
    far: bool = False  #: the last step was as good as the longest, and the imbalance fell

    @property
    def angle(self) -> Floats:
        angle: Floats = np.linalg.norm(self.turned, axis=1)
        return angle

    def add(self, x: Floats, size: float, reach: float) -> None:
        self.far = size < self.last and reach > LONG * min(self.longest, LONGEST_TURN)
        self.longest = LONGER * self.longest if self.far else LONGEST_STEP
        self.last = size
        if size < (1 - PROGRESS) * self.best:
            self.best, self.turned, self.steps = size, np.zeros_like(self.turned), 0
        else:
            self.turned, self.steps = self.turned + x.reshape(-1, 6)[:, 3:], self.steps + 1


class _Search:
    """W = diag(1, L^2) measures motions; r is the part of the forces that the joints do not take."""

    def __init__(self, equations: Equations, stable: bool) -> None:
        from scipy.sparse import diags_array

        self.eq, self.stable = equations, stable
        self.W = diags_array(1 / equations.scale**2).tocsr()
        self.rest = np.zeros(6 * equations.core.body_count)
        self.steps = 0
        self.limits = np.full_like(self.rest, np.inf)  # of a step
        self.B = self.W  # see _stiffnesses
        self.acting = np.zeros_like(self.rest)  # the most so far, see Equations.acting
        self.counts_turns = len(equations.dynamics.initial_history) > 0

    def find(self) -> Floats:
        q = self._on_joints(np.array(self.eq.core.q0))
        if q is None:
            raise NotConvergedError(
                f"equilibrium: model '{self.eq.model.name}': the joints are not met near the initial pose; "
                "linkwork.assemble(model) says which",
                code="no_start",
            )
        self._accept(q)
        for _ in range(DEPARTURES + 1):
            q = self._descend(q)
            if not self.stable:
                return q
            softest, motion, neutral = self._softest(q)
            if not softest < -neutral:
                return q
            away = self._on_joints(displaced(q, 0.01 * motion / self._reach(motion)))
            if away is None:
                return q
            q = away
            self._accept(q)
        return q

    # (K + mu B) x - D^T dlambda = r,   D x = -Phi
    def _descend(self, q: Floats) -> Floats:
        """NotConvergedError: the cap, or a body that goes round."""
        mu, step = 0.0, np.inf
        r, multipliers = self._balance(q)
        K = stiffness(self.eq, 0.0, q, self.rest, multipliers)
        self.acting = self.eq.acting(0.0, q, self.rest, multipliers, K)
        if not self.eq.beyond_rounding(r, q, K, self.acting).any():
            return q
        size = self._size(r)
        way = _Way(size, np.zeros((self.eq.core.body_count, 3)), size)
        for _ in range(ALL_ITERATIONS):
            if self._size(r) <= WANTED or step < ROUNDING or way.steps >= ITERATIONS:
                break
            self._limit(way.longest)
            found, mu = self._step(q, r, K, max(mu, LEAST_DAMPING))
            self.steps += 1
            if found is None:
                break
            x = between(q, found[0])
            step = self._reach(x)
            if step < SETTLED and self._size(r) <= ACCEPTED and self._size(found[1]) >= self._size(r):
                break  # no better: rounding
            q, r, multipliers = found
            self._accept(q)
            K = stiffness(self.eq, 0.0, q, self.rest, multipliers)
            self.acting = np.maximum(self.acting, self.eq.acting(0.0, q, self.rest, multipliers, K))
            way.add(x, self._size(r), step)
            if way.angle.max() > ROUND and not self.counts_turns:
                break
        if self._size(r) > ACCEPTED and not self._rounded(q, r, K):
            self._fail(q, r, way)
        return q

    def _limit(self, longest: float) -> None:
        """Where turns are not counted, they are as short as ever: a pose may be beyond the next one."""
        turn = min(longest, LONGEST_TURN) if self.counts_turns else LONGEST_STEP
        self.limits = np.tile([longest * self.eq.length] * 3 + [turn] * 3, self.eq.core.body_count)

    def _stiffnesses(self, K: Sparse) -> Sparse:
        """B (6n, 6n), diagonal: what holds each body, at least its forces per size of the model, or rad: so
        that light bodies are damped by no more than they need, and follow stiff ones onto the joints."""
        from scipy.sparse import diags_array

        own = np.abs(K.diagonal()).reshape(-1, 3).max(axis=1).repeat(3)
        return diags_array(np.maximum(own, self.acting / (self.eq.scale * self.eq.length))).tocsr()

    def _rounded(self, q: Floats, r: Floats, K: Sparse) -> bool:
        """Whether r, or the way to the pose in balance, is what positions have no digits for."""
        if not self.eq.beyond_rounding(r, q, K, self.acting).any():
            return True
        x = self._solved(K, self._independent(q), r)
        places = float(np.abs(q.reshape(-1, 7)[:, :3]).max()) / self.eq.length
        return x is not None and self._reach(x) <= max(ROUNDING, LAST_DIGITS * places)

    def _accept(self, q: Floats) -> None:
        """Turns are counted from this pose on."""
        self.eq.dynamics.history = self.eq.dynamics.advanced_history(0.0, q, self.rest)

    def _step(self, q: Floats, r: Floats, K: Sparse, mu: float) -> tuple[_Balanced | None, float]:
        """The state after a step, None where none is good, and mu for the next one."""
        self.B = self._stiffnesses(K)
        fall = FALL
        while mu < MOST_DAMPING:
            found = self._try(q, r, K + mu * self.B)
            if not isinstance(found, float):
                return found, mu / fall
            mu, fall = found * mu if mu > UNDAMPED else FIRST_DAMPING, GROWTH
        return None, mu

    def _try(self, q: Floats, r: Floats, damped: Sparse) -> _Balanced | float:
        """The state after a step; where it goes too far, or up, the factor by which mu should grow."""
        x = self._solved(damped, self._independent(q), r)
        if x is None or not np.isfinite(x).all() or (self.stable and r @ x < 0):
            return GROWTH
        too_far = float(np.abs(x / self.limits).max())
        if too_far > 1.0:
            if self.stable:
                return float(np.clip(1.1 * too_far, 2.0, GROWTH))
            x /= too_far
        new = self._on_joints(displaced(q, x))
        if new is None:
            return GROWTH
        after = self._balance(new)
        x = between(q, new)
        if self.counts_turns and np.linalg.norm(x.reshape(-1, 6)[:, 3:], axis=1).max() > COUNTED_TURN:
            return GROWTH
        decreased = self._size(after[0]) < self._size(r)
        works = (r + after[0]) @ x > 0 if self.stable else decreased
        tiny = self._reach(x) < TINY_STEP
        return (new, *after) if works or (tiny and decreased) else GROWTH

    def _balance(self, q: Floats) -> tuple[Floats, Floats]:
        """r = g + D^T lambda with the lambda that makes it shortest, and lambda (m,)."""
        r, multipliers, _ = balance(self.eq, 0.0, q)
        return r, multipliers

    def _independent(self, q: Floats) -> Sparse:
        """Independent rows of D."""
        D = self.eq.terms(0.0, q).D
        return D[self.eq.independent(D)]

    def _solved(self, A: Sparse, D: Sparse, b: Floats, c: Floats | float = 0.0) -> Floats | None:
        """x of A x - D^T y = b, D x = c; None: singular."""
        found = saddle_point(self.eq, A, D, b, np.broadcast_to(c, D.shape[:1]))
        return None if found is None else found[0]

    def _on_joints(self, q: Floats) -> Floats | None:
        """A near pose on the joints, stiff bodies moved least, by Newton's method; None: not found."""
        before = np.inf
        for _ in range(CORRECTIONS):
            terms = self.eq.terms(0.0, q)
            size = self.eq.violation(np.where(self.eq.holonomic, terms.Phi, 0.0))
            if size <= MET + self.eq.rounding or (size >= before / 2 and size < NEARLY_MET):
                return q
            if not np.isfinite(size) or size > 4 * before:
                return None
            rows = self.eq.independent(terms.D)
            rows = rows[self.eq.holonomic[rows]]  # restrict positions, not velocities only
            x = self._solved(self.B, terms.D[rows], self.rest, -terms.Phi[rows])
            if x is None or self._reach(x) > 2.0:
                return None
            q, before = displaced(q, x), size
        return None

    def _softest(self, q: Floats) -> tuple[float, Floats, float]:
        """The smallest stiffness that the joints leave [N/m], its motion, and which one would be none."""
        from linkwork.analyses.eigenmodes import softest_by_lanczos

        _, multipliers = self._balance(q)
        found = stiffness_and_parts(self.eq, 0.0, q, self.rest, multipliers)
        K, D = found.K, self._independent(q)
        if len(self.rest) > DENSE:
            value, x = softest_by_lanczos(self.W, (K + K.T) / 2, D, self._stiffest(K))
            return value, x, self._neutral(found, x)
        Z = null_space(self.eq, D)
        if not Z.shape[1]:
            return np.nan, self.rest, 0.0
        k = Z.T @ (K @ Z)
        if not np.isfinite(k).all():
            raise NotFiniteError(
                "the stiffness about the equilibrium is not finite: masses, forces or lengths are too large",
                code="not_finite",
            )
        if np.abs(k - k.T).max() <= ASYMMETRY * np.abs(k).max():
            values, y = np.linalg.eigh((k + k.T) / 2)
        else:  # forces that follow the bodies
            values, y = np.linalg.eig(k)
        lowest = int(np.argmin(values.real))
        x = Z @ y[:, lowest].real
        return float(values[lowest].real), x, self._neutral(found, x)

    def _neutral(self, found: Stiffness, x: Floats) -> float:
        """Stiffness of the motion x (6n,) that is rounding of the terms that it is the sum of [N/m]."""
        noise = float(found.rounding(x, NEUTRAL)) / (float(x @ (self.W @ x)) or 1.0)
        return noise + EPSILON * self._stiffest(found.parts)

    def _stiffest(self, K: Sparse) -> float:
        return float(abs(self._scaled(K)).max()) if K.nnz else 0.0

    def described(self, q: Floats) -> Equilibrium:
        """SingularSystemError: a singular pose. LinkworkWarning: nearly so."""
        eq = self.eq
        try:
            check_regular(eq, 0.0, q, "equilibrium: the pose of rest", SingularSystemError)
        except SingularSystemError as error:
            error.state = self._snapshot(q)
            raise
        r, multipliers = self._balance(q)
        softest, motion, neutral = self._softest(q)
        K = stiffness(eq, 0.0, q, self.rest, multipliers)
        self.acting = eq.acting(0.0, q, self.rest, multipliers, K)
        at_rest = eq.model.with_initial_state(q, self.rest, self._turns(q))
        multipliers = shared(eq, 0.0, q, multipliers)
        x = between(np.array(eq.core.q0), q).reshape(-1, 2, 3)
        shift, angle = np.linalg.norm(x, axis=2).T
        kinds: tuple[Literal["unstable", "neutral", "stable"], ...] = ("unstable", "neutral", "stable")
        kind = kinds[2 if np.isnan(softest) else 1 + int(np.sign(softest) * (abs(softest) > neutral))]
        imbalance = self._size(eq.beyond_rounding(r, q, K, self.acting))
        words = "" if np.isnan(softest) else eq.motion(motion)
        return Equilibrium(
            at_rest, moved=shift, turned=angle, multipliers=multipliers, imbalance=imbalance,
            softest=softest, softest_motion=words, stability=kind, iterations=self.steps,
            _equations=eq,
        )  # fmt: skip

    def _fail(self, q: Floats, r: Floats, way: _Way) -> None:
        eq = self.eq
        turning = int(way.angle.argmax()) if way.angle.max() > ROUND and not self.counts_turns else None
        if turning is None:
            body, k = divmod(int(np.abs(r / self.acting).argmax()), 6)
            why = "; is there a joint or a spring that could hold it?"
            if way.far:
                why = ", and still moves on by large steps while that falls: start nearer"
        else:
            body, k = turning, 3 + int(np.abs(r.reshape(-1, 6)[turning, 3:]).argmax())
            why = (
                ", and goes round and round: friction and dampers do not hold at rest; stop what drives it, "
                "or hold it by a joint or a spring"
            )
        value = float(r.reshape(-1, 6)[body, k])
        name = eq.core.body_name(body)
        error = NotConvergedError(
            f"equilibrium: model '{eq.model.name}' found none in {self.steps} steps: body '{name}' is driven "
            f"by {value:.3g} {'N' if k < 3 else 'N m'} still{why}",
            code="no_equilibrium" if turning is None else "goes_round",
            bodies=[name],
            residuals={name: value},
        )
        error.state = self._snapshot(q)
        raise error

    def _snapshot(self, q: Floats) -> Snapshot:
        return Snapshot(0.0, q.reshape(-1, 7), self.rest.reshape(-1, 6), self._turns(q))

    def _turns(self, q: Floats) -> Floats:
        """History variables of the pose; none where they are those of a motion that begins there."""
        at = (0.0, q, self.rest)
        history, begun = self.eq.dynamics.advanced_history(*at), self.eq.dynamics.beginning_history(*at)
        return np.zeros(0) if np.array_equal(history, begun) else history

    def _scaled(self, K: Sparse) -> Any:
        return K.multiply(self.eq.scale[:, None]).multiply(self.eq.scale[None, :])

    def _size(self, force: Floats) -> float:
        """The largest force, or torque, relative to what acts on its body."""
        return float(np.abs(force / self.acting).max(initial=0.0))

    def _reach(self, x: Floats) -> float:
        """The largest shift in sizes of the mechanism, or angle [rad]."""
        return float(np.abs(x / self.eq.scale).max(initial=0.0)) / self.eq.length
