"""Linearization: small vibrations of a mechanism about a pose at rest, or about steady motion."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial

import numpy as np
from numpy.typing import NDArray

from linkwork.analyses.coefficients import Coefficients, coefficients, refuse_imbalance
from linkwork.analyses.eigenmodes import (
    by_arnoldi,
    by_dense_matrices,
    by_lanczos,
    nearest_to,
    one_of_each_pair,
)
from linkwork.analyses.held_in_time import warn_of_time
from linkwork.analyses.kinks import kink
from linkwork.analyses.steadiness import Steadiness
from linkwork.analyses.stiffness import Stiffness, has_potential, scaled
from linkwork.arguments import is_number, number
from linkwork.arrays import Complex, Floats, ReadOnly
from linkwork.blas_threads import one_blas_thread
from linkwork.constraints.equations import Equations, Sparse, Terms
from linkwork.constraints.solver import DENSE, check_regular, null_space
from linkwork.constraints.tangent import displaced
from linkwork.errors import ModelError, OptionError, warn
from linkwork.modeling.model import Model
from linkwork.modeling.tables import Table
from linkwork.motion.records import Snapshot
from linkwork.running import checks
from linkwork.running.estimation import told_of_memory
from linkwork.running.own_order import in_own_order

__all__ = ["Linearization", "linearize"]


#: A motion whose stiffness is below this part of the terms that it is the sum of is neutral: that is the
#: rounding of the differences. Its eigenvalue is rounding up to such a part of the largest, of a double one.
NEUTRAL, ROUNDED = 1e-10, 1e-7

#: And below this part of the largest stiffness.
EPSILON = 1e-14

#: What the forces of a mode may leave, relative to them, for it to be sure.
SURE = 1e-6

#: Growth below this part of an eigenvalue, or this part of the largest one, is none.
GROWTH, GROWTH_OF_LARGEST = 1e-6, 1e-12

#: Velocities that do not follow the drivers, relative to the rates of the motion: squares count.
FOLLOWED = 1e-4

#: Velocities below this part of the rates of its forces are those of a mechanism at rest.
REST = 1e-9

#: Modes in the table of a notebook.
MODES_SHOWN = 20

#: Modes of models that are too large for dense matrices, where no number is given.
MODES = 10


@dataclass(frozen=True, eq=False)
class Linearization(ReadOnly):
    """M x'' + C x' + K x = D^T mu, D x = 0, and the motions x = Re(shape exp(s t)) that it has.

    x (6n,): of each body a shift of its center of mass [m] and a rotation vector [rad], inertial axes. K has
    the geometric stiffness, C the gyroscopic terms. In motion rows that restrict velocities only, as of
    wheels that roll, are D x' + E x = 0 instead.
    """

    model: Model
    snapshot: Snapshot  #: the state about which it holds
    M: Sparse  #: (6n, 6n) compressed rows
    C: Sparse
    K: Sparse
    D: Sparse  #: (m, 6n), redundant rows left out
    E: Sparse  #: (m, 6n), zero in all rows with D x = 0
    #: s (k,) [1/s], slow ones first: one of each conjugate pair; without damping, where motions also have -s,
    #: that of the two which grows
    eigenvalues: Complex
    shapes: Complex  #: (k, n, 6) of the bodies, the largest motion 1 (of rotations: angle times size)
    _equations: Equations = field(repr=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        for matrix in (self.M, self.C, self.K, self.D, self.E):
            matrix.sum_duplicates()
            matrix.data.flags.writeable = False

    @property
    def frequencies(self) -> Floats:
        """|s| (k,) [rad/s]; undamped vibrations have this frequency."""
        return np.abs(self.eigenvalues)

    @property
    def damping_ratios(self) -> Floats:
        """-Re(s) / |s| (k,); 1 and -1 for motions that do not vibrate, 0 for neutral ones."""
        size = self.frequencies
        return np.divide(0.0 - self.eigenvalues.real, size, out=np.zeros_like(size), where=size > 0)

    @property
    def stable(self) -> bool:
        """False where a motion among those found grows."""
        size = self.frequencies
        none = np.maximum(GROWTH * size, GROWTH_OF_LARGEST * size.max(initial=0.0))
        return bool((self.eigenvalues.real <= none).all())

    def describe(self, mode: int) -> str:
        """
        The largest part of a mode in words: `body 'rod' turns about (0, 1, 0)`.

            print(vibration.describe(0))

        OptionError: there is no such mode.
        """
        shape = self.shapes[self._mode(mode)].ravel()
        turned = shape * np.exp(-1j * np.angle(shape[np.argmax(np.abs(shape))]))
        return self._equations.motion(turned.real)

    def displaced(self, mode: int, amplitude: float, phase: float = 0.0) -> Model:
        """The model in a pose of a mode: q displaced by amplitude Re(shape exp(i phase)), for pictures.

            start = lw.assemble(vibration.displaced(0, 0.01)).model

        `lw.assemble(...)` makes it exact where the amplitude is large. OptionError: there is no such mode, or
        amplitude and phase are no finite numbers.
        """
        amplitude, phase = number(amplitude, "amplitude"), number(phase, "phase")
        x = amplitude * (self.shapes[self._mode(mode)] * np.exp(1j * phase)).real.ravel()
        at = self.snapshot
        return self.model.with_initial_state(displaced(at.q.ravel(), x), at.v, at.history)

    def _mode(self, mode: int) -> int:
        """OptionError: none of those found."""
        count = len(self.shapes)
        if not isinstance(mode, int | np.integer) or not -count <= mode < count:
            raise OptionError(f"mode {mode!r:.80}: there are {count}, from 0 on", code="mode")
        return int(mode)

    def __repr__(self) -> str:
        slow = ", ".join(f"{f:.6g}" for f in self.frequencies[:5])
        more = ", ..." if len(self.eigenvalues) > 5 else ""
        return f"<Linearization of {self.model.name or 'model'}: {slow}{more} rad/s, {self._verdict()}>"

    def _repr_html_(self) -> str:
        """In a notebook: the modes, slow ones first."""
        columns = ("mode", "frequency [rad/s]", "[Hz]", "damping ratio", "largest part")
        pairs = zip(self.frequencies[:MODES_SHOWN], self.damping_ratios[:MODES_SHOWN], strict=True)
        rows = [
            (str(k), f"{w:.6g}", f"{w / (2 * np.pi):.6g}", f"{ratio:.4g}", self.describe(k))
            for k, (w, ratio) in enumerate(pairs)
        ]
        more = len(self.eigenvalues) - len(rows)
        title = f"{self.model.name or 'model'}, {self._verdict()}: modes" + (f", {more} more" if more else "")
        return Table(title, columns, rows)._repr_html_()

    def _verdict(self) -> str:
        return "stable" if self.stable else "unstable"


def linearize(
    model: Model, *, start: Snapshot | None = None, modes: int | None = None, near: float = 0.0
) -> Linearization:
    """Frequencies, damping and shapes of the small motions that the joints allow.

        vibration = lw.linearize(lw.equilibrium(model).model)
        vibration.frequencies, vibration.damping_ratios, vibration.describe(0)

    About the model's initial state, or `start`: at rest in balance, or in motion without accelerations that
    looks the same at all times: centers of mass at rest or in straight uniform motion, bodies that spin at
    constant angular velocity about axes fixed in space, such as an upright top, or a bicycle that rolls
    straight ahead; not one that precesses, nor a mechanism on a turning shaft, whose centers of mass go
    round.

    M, C, K over the motions of all bodies, sparse, and restricted to D x = 0: exactly by a null space for
    small models; for large ones with the constraints in the matrix that is factorized, by shift and inversion
    (Lanczos, Arnoldi), so that nothing is lost to a penalty.

    start  another state: `Result.snapshot()`; functions of time have the values that they have then
    modes  how many; all of a small model, 10 of a large one
    near   with `modes`, or of a large model: those whose eigenvalue is nearest to i near [rad/s]

    ModelError: the state is not in balance, or accelerates, is singular, moves so that coefficients change,
    is a kink of the forces, as where a contact just touches, or has a massless motion. OptionError: modes or
    near. NotConvergedError: the iteration of a large model. LinkworkWarning: joints repeat each other
    but for digits of their points or axes; functions of time change stiffness or
    damping, which are held as they are at that time; modes that are not sure, as the digits of numbers are
    too few for stiffness and damping, or for a pose that is nearly singular; functions of the model remember
    calls, so that what they return next to the state is no stiffness or damping.
    """
    if modes is not None and (not isinstance(modes, int) or modes < 1):
        raise OptionError(f"modes {modes!r} is not a positive whole number", code="modes")
    if not is_number(near) or near < 0:
        raise OptionError(f"near {near!r} rad/s must be a finite number, zero or positive", code="near")
    with one_blas_thread(), told_of_memory(model, "linearize"):
        return _linearized(model, start, modes, near)


def _linearized(model: Model, start: Snapshot | None, modes: int | None, near: float) -> Linearization:
    eq, start = _equations(model, start)
    at = _at_rest(eq, _begun(eq, start))
    now = _in_balance(eq, at)
    warn_of_time(eq, at, now.doubts)
    steadiness = Steadiness(eq, at, now) if np.any(at.v) else None
    Z = null_space(eq.scale, now.fixed) if now.D.shape[1] <= DENSE else None
    if steadiness is not None:
        steadiness.refuse_change(Z)
    eigenvalues, shapes = _modes(eq, now, Z, modes, near)
    if steadiness is not None and Z is None:
        steadiness.refuse_change(shapes)
    size = np.abs(shapes / eq.scale[:, None]).max(axis=0, initial=0.0)
    shapes = (shapes / np.where(size > 0, size, 1.0)).T.reshape(-1, model.body_count, 6)
    return Linearization(model, at, now.M, now.C, now.K, now.D, now.E, eigenvalues, shapes, eq)


def _in_balance(eq: Equations, at: Snapshot) -> Coefficients:
    """ModelError: it is singular, does not follow its drivers, or is not in balance."""
    q, v = np.ravel(at.q).astype(float), np.ravel(at.v).astype(float)
    check_regular(eq, at.t, q, "linearize: the pose", ModelError)
    _check_velocities(eq, eq.terms(at.t, q, v), v, eq.gross_forces(at.t, q, v))
    now = coefficients(eq, at)
    refuse_imbalance(eq, at, now)
    _refuse_kink(eq, at, now)
    return now


def _refuse_kink(eq: Equations, at: Snapshot, now: Coefficients) -> None:
    """ModelError: there is no stiffness or damping at the state."""
    found = kink(eq, at, now.D, *now.doubts)
    if found is not None:
        raise ModelError(
            f"linearize: {eq.called} is where small motions are not linear: {found}, as of a contact or stop "
            "that just touches, or a spring whose ends coincide; press the bodies together by a preload, or "
            "move them apart",
            code="kink",
            bodies=[found.body],
            forces=[found.force] if found.force else [],
        )


def _modes(
    eq: Equations, now: Coefficients, Z: Floats | None, modes: int | None, near: float
) -> tuple[Complex, Complex]:
    """Eigenvalues and shapes (6n, k), of small models over the motions Z (6n, f)."""
    M, C, K, D, found = now.M, now.C, now.K, now.fixed, now.stiffness
    symmetric = has_potential(eq, found)
    if Z is not None:
        s, shapes, off = by_dense_matrices(M, C, K, Z, symmetric, now.rolling)
    else:
        modes = modes or MODES
        undamped = symmetric and not C.count_nonzero() and not now.rolling[0].shape[0]
        by_rates = partial(by_arnoldi, M, C, K, D, now.rolling)
        s, shapes = (partial(by_lanczos, M, K, D) if undamped else by_rates)(modes, near)
        off = np.zeros(len(s))
    s = np.where(_neutral(eq, s, shapes, M, found) & (off <= SURE), 0.0, s)
    chosen = one_of_each_pair(s)
    chosen = chosen[nearest_to(s[chosen], near, modes)]
    _warn_of_unsure(off[chosen])
    return s[chosen], shapes[:, chosen]


def _warn_of_unsure(off: Floats) -> None:
    unsure = int((off > SURE).sum())
    if unsure:
        warn(
            f"linearize: {unsure} of {len(off)} modes are not sure; of mode {off.argmax()} the forces leave "
            f"{off.max():.1e} of their size: stiffness and damping are too far apart for 16 digits"
        )


def _equations(model: Model, start: Snapshot | None) -> tuple[Equations, Snapshot | None]:
    """And the state in the order of the model. OptionError: it is none of this model."""
    eq = Equations(model)
    checks.warn_of_near_dependence(eq.dynamics)
    if start is None:
        return eq, None
    checks.start_time(start)
    start = in_own_order(eq.core, eq.dynamics, start)
    checks.check_state(model, start)
    if eq.rank.singular_rows:  # there it is not known which equations are redundant
        eq = Equations(model.with_initial_state(start.q, start.v))
    return eq, start


def _begun(eq: Equations, start: Snapshot | None) -> Snapshot:
    """The state, with the history of which forces are evaluated. OptionError: none of this model."""
    if start is None:
        return Snapshot(0.0, *_initial(eq.model))
    if len(start.history):
        checks.check_history(eq.dynamics, start)
        eq.dynamics.history = np.asarray(start.history, dtype=float)
    else:
        y = np.ravel(start.q), np.ravel(start.v)
        eq.dynamics.history = eq.dynamics.beginning_history(start.t, *y)
    return start


def _initial(model: Model) -> tuple[Floats, Floats]:
    core = model.compiled()
    return np.array(core.q0).reshape(-1, 7), np.array(core.v0).reshape(-1, 6)


def _at_rest(eq: Equations, at: Snapshot) -> Snapshot:
    """The same without velocities that are nothing beside those that its forces could make: what is left of a
    motion that came to rest."""
    q, still = np.ravel(at.q).astype(float), np.zeros(np.size(at.v))
    gross = eq.gross_forces(at.t, q, still)
    speed = float(np.abs(np.ravel(at.v) / eq.scale).max(initial=0.0)) / eq.length
    came_to_rest = gross.any() and 0.0 < speed <= REST * eq.rate(still, gross)
    return at._replace(v=still.reshape(-1, 6)) if came_to_rest else at


def _check_velocities(eq: Equations, terms: Terms, v: Floats, gross: Floats) -> None:
    """ModelError: a driver moves, and the bodies do not."""
    off = np.abs(terms.Phi_dot) / eq.row_lengths
    if off.max(initial=0.0) > FOLLOWED * eq.rate(v, gross):
        name = eq.joints([int(off.argmax())])[0]
        raise ModelError(
            f"linearize: the velocities of {eq.called} do not satisfy joint '{name}', as "
            "where a driver moves: start from linkwork.assemble(model).model",
            code="inconsistent_velocity",
            joints=[name],
        )


def _neutral(eq: Equations, s: Complex, shapes: Complex, M: Sparse, found: Stiffness) -> NDArray[np.bool_]:
    """Which motions have no stiffness, and no damping that brings them to rest (k,)."""

    def of(A: Sparse) -> Floats:
        return np.asarray(np.abs(np.sum(shapes.conj() * (A @ shapes), axis=0)))

    largest = np.abs(s).max(initial=0.0)
    stiffest = float(scaled(eq, found.parts).max()) if found.parts.nnz else 0.0
    noise = found.rounding(shapes, NEUTRAL)
    noise += EPSILON * stiffest * np.sum(np.abs(shapes / eq.scale[:, None]) ** 2, axis=0)
    mass = of(M)
    slow = np.abs(s) ** 2 * mass <= noise + (ROUNDED * largest) ** 2 * mass
    return np.asarray((of(found.K) <= noise) & slow)
