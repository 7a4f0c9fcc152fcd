"""Static equilibrium: where forces and reactions balance, and whether the mechanism returns there."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple, TypeVar

import numpy as np

from linkwork.analyses.softest import softest
from linkwork.analyses.stability import Stability, judged
from linkwork.analyses.step_limits import LONGEST_STEP, LONGEST_TURN, StepLimits
from linkwork.analyses.stiffness import stiffness
from linkwork.arguments import check_switch
from linkwork.arrays import Floats, ReadOnly
from linkwork.blas_threads import one_blas_thread
from linkwork.constraints.equations import LAST_DIGITS, Equations, Sparse
from linkwork.constraints.rolling import rolled
from linkwork.constraints.solver import balance, check_regular, saddle_point, shared
from linkwork.constraints.tangent import between, displaced
from linkwork.errors import (
    NotConvergedError,
    SingularSystemError,
)
from linkwork.modeling.handles import Named, place_of
from linkwork.modeling.model import Model
from linkwork.motion.records import Reaction, Snapshot
from linkwork.motion.state_names import StateNames
from linkwork.running import checks
from linkwork.running.estimation import told_of_memory

__all__ = ["Equilibrium", "equilibrium"]

#: Forces not in balance, relative to what acts on their body: where the iteration may end, and tries to; and
#: below which it ended beside a pose of rest, where that is a singular one.
ACCEPTED, WANTED, BESIDE = 1e-9, 1e-13, 1e-6

#: Steps below this part of the size of the mechanism are rounding; and where others have settled.
ROUNDING, SETTLED = 1e-13, 1e-9

#: Violations of joints, relative to the size of the mechanism: none, and what rounding may leave.
MET, NEARLY_MET = 1e-13, 1e-10

#: How the damping mu of the steps falls after one that was good at once, and grows after one that was not:
#: little, as where the stiffness is negative a step is long only next to the least mu; mu that is none.
FALL, GROWTH, UNDAMPED = 10.0, 3.0, 1e-9

#: The same: the least, the first that damps, and the most.
LEAST_DAMPING, FIRST_DAMPING, MOST_DAMPING = 1e-13, 1e-4, 1e12

#: Steps [rad, sizes of the mechanism] in which rounding hides the work of the forces.
TINY_STEP = 1e-7

#: The most that a body may turn at a time, also by corrections onto the joints, for its turns to be counted.
COUNTED_TURN = np.pi / 2

#: Of steps in which the imbalance does not fall, and of all; of corrections onto the joints, and of
#: departures from unstable equilibria, with one of each body more, up to so many.
ITERATIONS, ALL_ITERATIONS, CORRECTIONS, DEPARTURES, MOST_DEPARTURES = 400, 4000, 20, 5, 500


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
    #: smallest stiffness among the motions that the joints leave [N/m]; NaN: there is none, or it is unknown
    softest: float
    softest_motion: str  #: which this is, in words, and which small motions grow; or why it is unknown
    stability: Stability  #: "unknown" at a kink of the forces, as where a contact or stop just touches
    iterations: int
    _equations: Equations = field(repr=False)

    def reaction(self, name: Named) -> Reaction:
        """Force and torque (3,) of a joint on its second body, inertial axes.

            rest.reaction("pin").force

        ModelError: no joint.
        """
        core = self.model.compiled()
        joint = place_of("joint", name, {core.joint_name(k): k for k in range(core.joint_count)})
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
        called = f"{self.stability} equilibrium"
        if self.stability == "unknown":
            called, soft = "equilibrium of unknown stability", f": {self.softest_motion}"
        return (
            f"{called} after {self.iterations} steps; bodies moved by at most "
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
    Springs, stops, laws and couplers count full turns on the way, and wheels roll without slip. Where that
    restricts velocities only, as for a skate, there are many places to rest in, and which of them is found
    depends on the way of the steps: linkwork.simulate finds that of a motion with friction.

    stable  False: the nearest equilibrium of any kind, by steps that reduce the imbalance

    `stability` is that of the stiffness; a rotation counts by the size of the mechanism. Where forces follow
    the bodies or wheels roll stiffness does not tell: small motions do, with their damping, as
    linkwork.linearize finds them; of large models it is "unknown" then. So it is where a contact or stop just
    touches, and wherever else forces have a kink: stiffness is another one to each side.

    NotConvergedError: no equilibrium, with the body that is driven most, or that goes round and round, as by
    a motor against friction, which does not hold at rest; the error's `state` is the pose that was reached.
    SingularSystemError: a singular pose, as of a parallelogram that rests folded flat: there stiffness tells
    nothing; `state` as well. OptionError: `stable` is no truth value. LinkworkWarning: it is nearly singular;
    joints repeat each other but for digits of their points or axes; functions of the model
    remember calls, so that it may rest elsewhere.
    """
    check_switch("stable", stable)
    with one_blas_thread(), told_of_memory(model, "equilibrium"):
        equations = Equations(model)
        checks.warn_of_near_dependence(equations.dynamics)
        search = _Search(equations, stable)
        return search.described(search.find())


_Found = TypeVar("_Found")


class _Step(NamedTuple):
    """Where one has led, with what `_Search._balance` finds there."""

    q: Floats
    x: Floats  # the motion, full turns included
    history: Floats
    r: Floats
    multipliers: Floats


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
                f"equilibrium: of {self.eq.called} the joints are not met near the initial pose; "
                "linkwork.assemble(model) says which",
                code="no_start",
            )
        self._accept(q)
        for left in range(DEPARTURES + min(self.eq.core.body_count, MOST_DEPARTURES), -1, -1):
            q = self._descend(q)
            if not self.stable or not left:
                break
            soft = softest(self.eq, q, self._balance(q)[1])
            if soft.kink or not soft.stiffness < -soft.neutral:
                break
            away = self._moved(q, 0.01 * soft.away / self._reach(soft.away))
            if away is None:
                break
            q = away[0]
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
        limits = StepLimits(self._size(r), self.eq.core.body_count)
        for left in range(ALL_ITERATIONS, 0, -1):
            rounded = step < ROUNDING and mu < 1.0  # others are short by damping
            if self._size(r) <= WANTED or rounded or limits.steps >= ITERATIONS:
                break
            if not self.counts_turns and limits.goes_round(left):
                break
            self._limit(limits)
            found, mu = self._step(q, r, K, max(mu, LEAST_DAMPING))
            self.steps += 1
            if found is None:
                break
            step = self._reach(found.x)
            if step < SETTLED and self._size(r) <= ACCEPTED and self._size(found.r) >= self._size(r):
                break  # no better: rounding
            off = abs((found.r - r + K @ found.x) @ found.x) / (abs(r @ found.x) or 1.0)
            q, r, multipliers = found.q, found.r, found.multipliers
            self.eq.dynamics.history = found.history
            K = stiffness(self.eq, 0.0, q, self.rest, multipliers)
            self.acting = np.maximum(self.acting, self.eq.acting(0.0, q, self.rest, multipliers, K))
            limits.add(found.x, self._size(r), step, off)
        if self._size(r) > ACCEPTED and not self._rounded(q, r, K):
            if self._size(r) <= BESIDE:
                self._check_regular(q)
            self._fail(q, r, limits)
        return q

    def _limit(self, limits: StepLimits) -> None:
        """Where turns are not counted, a pose may be beyond the next one: they are short unless foretold."""
        counted = min(limits.longest, LONGEST_TURN) if self.counts_turns else LONGEST_STEP
        parts = [limits.longest * self.eq.length] * 3 + [max(limits.turn, counted)] * 3
        self.limits = np.tile(parts, self.eq.core.body_count)

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

    def _step(self, q: Floats, r: Floats, K: Sparse, mu: float) -> tuple[_Step | None, float]:
        """The state after a step, None where none is good, and mu for the next one."""
        self.B = self._stiffnesses(K)
        fall = FALL
        while mu < MOST_DAMPING:
            found = self._try(q, r, K + mu * self.B)
            if not isinstance(found, float):
                return found, mu / fall
            mu, fall = found * mu if mu > UNDAMPED else FIRST_DAMPING, GROWTH
        return None, mu

    def _try(self, q: Floats, r: Floats, damped: Sparse) -> _Step | float:
        """The state after a step; where it goes too far, up, or to no balance: by what mu should grow."""
        x = self._solved(damped, self._independent(q), r)
        if x is None or not np.isfinite(x).all() or (self.stable and r @ x < 0):
            return GROWTH
        too_far = float(np.abs(x / self.limits).max())
        if too_far > 1.0:
            if self.stable:
                return float(np.clip(1.1 * too_far, 2.0, GROWTH))
            x /= too_far
        moved = self._moved(q, x)
        if moved is None:
            return GROWTH
        new, x, history = moved
        try:
            after, multipliers = self._counting(history, lambda: self._balance(new))
        except SingularSystemError:  # a shorter one may end beside it
            return GROWTH
        decreased = self._size(after) < self._size(r)
        works = (r + after) @ x > 0 if self.stable else decreased
        tiny = self._reach(x) < TINY_STEP
        return _Step(new, x, history, after, multipliers) if works or (tiny and decreased) else GROWTH

    def _moved(self, q: Floats, x: Floats) -> tuple[Floats, Floats, Floats] | None:
        """The pose on the joints after the motion x (6n,), the motion to there, and its history variables.

        None: not found.
        """
        near = displaced(q, x) if self.eq.holonomic.all() else self._rolled(q, x)
        if near is None:
            return None
        history = self._counted(q, x)
        new = self._counting(history, lambda: self._on_joints(near))
        if new is None:
            return None
        if self.counts_turns:
            if _largest_turn(between(near, new)) > COUNTED_TURN:
                return None
            history = self._advanced(history, new)
        return new, x + between(displaced(q, x), new), history

    def _rolled(self, q: Floats, x: Floats) -> Floats | None:
        """Where the motion x leads by rolling; None: to a singular pose."""

        def velocity(_: float, q: Floats) -> Floats:
            found = self._solved(self.B, self._independent(q), self.B @ x)
            if found is None or not np.isfinite(found).all():
                raise ArithmeticError
            return found

        try:
            return rolled(q, velocity, 0.0, 1.0)
        except ArithmeticError:
            return None

    def _counted(self, q: Floats, x: Floats) -> Floats:
        """History variables on the way along x, so far that less than half a turn of it is left."""
        history = np.asarray(self.eq.dynamics.history)
        count = int(_largest_turn(x) / LONGEST_TURN) + 1 if self.counts_turns else 1
        for k in range(1, count):
            history = self._advanced(history, displaced(q, k / count * x))
        return history

    def _advanced(self, history: Floats, q: Floats) -> Floats:
        found = self._counting(history, lambda: self.eq.dynamics.advanced_history(0.0, q, self.rest))
        return np.asarray(found)

    def _counting(self, history: Floats, found: Callable[[], _Found]) -> _Found:
        """What is found where turns are counted from there."""
        before = self.eq.dynamics.history
        self.eq.dynamics.history = history
        try:
            return found()
        finally:
            self.eq.dynamics.history = before

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
            missing = np.where(self.eq.holonomic, -terms.Phi, 0.0)[rows]  # without slip
            x = self._solved(self.B, terms.D[rows], self.rest, missing)
            if x is None or self._reach(x) > 2.0:
                return None
            q, before = displaced(q, x), size
        return None

    def _check_regular(self, q: Floats) -> None:
        """SingularSystemError: a singular pose. LinkworkWarning: nearly so."""
        try:
            check_regular(self.eq, 0.0, q, "equilibrium: the pose of rest", SingularSystemError)
        except SingularSystemError as error:
            error.state = self._snapshot(q)
            raise

    def described(self, q: Floats) -> Equilibrium:
        """As _check_regular raises and warns."""
        eq = self.eq
        self._check_regular(q)
        r, multipliers = self._balance(q)
        soft = softest(eq, q, multipliers)
        K = stiffness(eq, 0.0, q, self.rest, multipliers)
        self.acting = eq.acting(0.0, q, self.rest, multipliers, K)
        at_rest = eq.model.with_initial_state(q, self.rest, self._turns(q))
        multipliers = shared(eq, 0.0, q, multipliers)
        x = between(np.array(eq.core.q0), q).reshape(-1, 2, 3)
        shift, angle = np.linalg.norm(x, axis=2).T
        found = judged(eq, at_rest, soft)
        imbalance = self._size(eq.beyond_rounding(r, q, K, self.acting))
        return Equilibrium(
            at_rest, moved=shift, turned=angle, multipliers=multipliers, imbalance=imbalance,
            softest=found.softest, softest_motion=found.words, stability=found.stability,
            iterations=self.steps, _equations=eq,
        )  # fmt: skip

    def _fail(self, q: Floats, r: Floats, limits: StepLimits) -> None:
        eq = self.eq
        round_and_round = not self.counts_turns and limits.goes_round(0)
        turning = int(limits.angle.argmax()) if round_and_round else None
        if turning is None:
            body, k = divmod(int(np.abs(r / self.acting).argmax()), 6)
            why = "; is there a joint or a spring that could hold it?"
            if limits.far:
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
            f"equilibrium: of {eq.called} found none in {self.steps} steps: body '{name}' is driven "
            f"by {value:.3g} {'N' if k < 3 else 'N m'} still{why}",
            code="no_equilibrium" if turning is None else "goes_round",
            bodies=[name],
            residuals={name: value},
        )
        error.state = self._snapshot(q)
        raise error

    def _snapshot(self, q: Floats) -> Snapshot:
        names = StateNames.of(self.eq.model.compiled(), self.eq.dynamics)
        return Snapshot(0.0, q.reshape(-1, 7), self.rest.reshape(-1, 6), self._turns(q), names=names)

    def _turns(self, q: Floats) -> Floats:
        """History variables of the pose; none where they are those of a motion that begins there."""
        at = (0.0, q, self.rest)
        history, begun = self.eq.dynamics.advanced_history(*at), self.eq.dynamics.beginning_history(*at)
        return np.zeros(0) if np.array_equal(history, begun) else history

    def _size(self, force: Floats) -> float:
        """The largest force, or torque, relative to what acts on its body."""
        return float(np.abs(force / self.acting).max(initial=0.0))

    def _reach(self, x: Floats) -> float:
        """The largest shift in sizes of the mechanism, or angle [rad]."""
        return float(np.abs(x / self.eq.scale).max(initial=0.0)) / self.eq.length


def _largest_turn(x: Floats) -> float:
    return float(np.linalg.norm(x.reshape(-1, 6)[:, 3:], axis=1).max())
