"""Linearization: small vibrations of a mechanism about a pose at rest, or about steady motion."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwork.analyses.constraint_solver import DENSE, balance, null_space
from linkwork.analyses.equations import Equations, Sparse, Terms
from linkwork.analyses.stiffness import damping, stiffness
from linkwork.analyses.tangent import displaced, to_inertial_axes
from linkwork.arguments import is_number
from linkwork.arrays import Floats
from linkwork.equations.system import System
from linkwork.errors import ModelError, NotConvergedError, OptionError
from linkwork.modeling.model import Model
from linkwork.modeling.tables import Table
from linkwork.motion.records import Snapshot
from linkwork.running import checks

__all__ = ["Linearization", "linearize"]

Complex = NDArray[np.complex128]

#: Forces that are not in balance, relative to what acts on their body.
BALANCE = 1e-6

#: A motion whose stiffness is below this part of the terms that it is the sum of is neutral: that is the
#: rounding of the differences. Its eigenvalue is rounding up to such a part of the largest, of a double one.
NEUTRAL, ROUNDED = 1e-10, 1e-7

#: And below this part of the largest stiffness.
EPSILON = 1e-14

#: Growth below this part of an eigenvalue, or this part of the largest one, is none.
GROWTH, GROWTH_OF_LARGEST = 1e-6, 1e-12

#: Velocities that do not follow the drivers, relative to the rates of the motion: squares count.
FOLLOWED = 1e-4

#: Velocities below this part of the rates of its forces are those of a mechanism at rest.
REST = 1e-9

#: Asymmetry of the stiffness that counts as none, relative to the largest entries of the bodies: rounding.
SMALL = 1e-10

#: A turn of this size [rad] must leave the coefficients as they are, but for such a part; those of damping
#: and stiffness count from this part of the inertia on.
TURN, STEADY, COUNTS = 1e-3, 1e-5, 1e-9

#: Mass of a motion, relative to the largest, that is none.
MASSLESS = 1e-14

#: Imaginary parts, relative to |s|, that are rounding: of one of a conjugate pair they are positive. And |s|,
#: relative to the shift from which it was found.
REAL = 1e-12

#: Shifts of the spectrum, relative to the largest possible eigenvalues (squares, or themselves): enough for
#: factors where there are neutral motions, and such as are only just enough.
SQUARE_SHIFT, SHIFTS = 1e-8, (1e-4, 1e-6)

#: How often twice as many eigenvalues are asked for, until those that are wanted are certain.
DOUBLINGS = 6

#: Vectors of a Krylov space, per eigenvalue, and at least; restarts until it is tried with more vectors.
VECTORS, FEWEST, RESTARTS = (2, 4), 20, 300

#: Velocities that the joints do not allow, relative, in what is no motion.
ALLOWED = 1e-3

#: In place of zero, where only a division by it is to be avoided.
TINY = 1e-300

#: Modes in the table of a notebook.
MODES_SHOWN = 20

#: Random motions along which coefficients of large models are compared.
PROBES = 8

#: Distances of eigenvalues from a shift that differ by less, relative, are equal: by so much those of neutral
#: motions may be off.
EQUAL = 1e-6

#: Of the inverse, that are enough for one motion where others are hardly there.
POWERS = 3

#: A shift lies below the smallest eigenvalue by this part of the largest, or of its distance from a bound,
#: where the eigenvalue is known as roughly as this.
BELOW, ROUGH = 0.1, 1e-2

#: Modes of models that are too large for dense matrices, where no number is given.
MODES = 10


@dataclass(frozen=True, eq=False)
class Linearization:
    """M x'' + C x' + K x = D^T mu, D x = 0, and the motions x = Re(shape exp(s t)) that it has.

    x (6n,): of each body a shift of its center of mass [m] and a rotation vector [rad], inertial axes. K has
    the geometric stiffness, C the gyroscopic terms.
    """

    model: Model
    snapshot: Snapshot  #: the state about which it holds
    M: Sparse  #: (6n, 6n) compressed rows
    C: Sparse
    K: Sparse
    D: Sparse  #: (m, 6n), redundant rows left out
    eigenvalues: Complex  #: s (k,) [1/s], one of each conjugate pair, slow ones first
    shapes: Complex  #: (k, n, 6) of the bodies, the largest motion 1 (of rotations: angle times size)
    _equations: Equations = field(repr=False)

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
        """
        shape = self.shapes[mode].ravel()
        turned = shape * np.exp(-1j * np.angle(shape[np.argmax(np.abs(shape))]))
        return self._equations.motion(turned.real)

    def displaced(self, mode: int, amplitude: float, phase: float = 0.0) -> Model:
        """The model in a pose of a mode: q displaced by amplitude Re(shape exp(i phase)), for pictures.

            start = lw.assemble(vibration.displaced(0, 0.01)).model

        `lw.assemble(...)` makes it exact where the amplitude is large.
        """
        x = amplitude * (self.shapes[mode] * np.exp(1j * phase)).real.ravel()
        at = self.snapshot
        return self.model.with_initial_state(displaced(at.q.ravel(), x), at.v, at.history)

    def __repr__(self) -> str:
        slow = ", ".join(f"{f:.6g}" for f in self.frequencies[:5])
        more = ", ..." if len(self.eigenvalues) > 5 else ""
        return f"<Linearization of '{self.model.name}': {slow}{more} rad/s, {self._verdict()}>"

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
    constant angular velocity about axes fixed in space, such as an upright top; not one that precesses, nor
    a mechanism on a turning shaft, whose centers of mass go round.

    M, C, K over the motions of all bodies, sparse, and restricted to D x = 0: exactly by a null space for
    small models; for large ones with the constraints in the matrix that is factorized, by shift and inversion
    (Lanczos, Arnoldi), so that nothing is lost to a penalty.

    start  another state: `Result.snapshot()`; functions of time have the values that they have then
    modes  how many; all of a small model, 10 of a large one
    near   for large models: those whose eigenvalue is nearest to i near [rad/s]

    ModelError: the state is not in balance, or accelerates, is singular, has coefficients that change with
    time, or a massless motion. OptionError: modes or near. NotConvergedError: the iteration of a large model.
    """
    if modes is not None and (not isinstance(modes, int) or modes < 1):
        raise OptionError(f"modes {modes!r} is not a positive whole number", code="modes")
    if not is_number(near) or near < 0:
        raise OptionError(f"near {near!r} rad/s must be a finite number, zero or positive", code="near")
    eq = Equations(model)
    at = _at_rest(eq, _begun(eq, start))
    coefficients = _coefficients(eq, at)
    M, C, K, D = coefficients
    moving = np.abs(at.v).max(initial=0.0) > 0
    if moving:
        _refuse_velocity_rows(eq)
    small = D.shape[1] <= DENSE
    if small or moving:
        Z = null_space(eq, D) if small else _some_motions(eq, D)
    if moving:
        _refuse_change(eq, at, coefficients, Z)
    symmetric = _symmetric(_scaled(eq, K))
    if small:
        eigenvalues, shapes = _dense(M, C, K, Z, symmetric)
    elif symmetric and not C.count_nonzero():
        eigenvalues, shapes = _lanczos(M, K, D, modes or MODES, near)
    else:
        eigenvalues, shapes = _arnoldi(M, C, K, D, modes or MODES, near)
    eigenvalues, shapes = _one_of_each_pair(_without_rounding(eq, eigenvalues, shapes, M, K), shapes)
    if small:
        eigenvalues, shapes = eigenvalues[:modes], shapes[:, :modes]
    size = np.abs(shapes / eq.scale[:, None]).max(axis=0, initial=0.0)
    shapes = (shapes / np.where(size > 0, size, 1.0)).T.reshape(-1, model.body_count, 6)
    return Linearization(model, at, M, C, K, D, eigenvalues, shapes, eq)


def _begun(eq: Equations, start: Snapshot | None) -> Snapshot:
    """The state, with the history of which forces are evaluated. OptionError: none of this model."""
    if start is None:
        return Snapshot(0.0, *_initial(eq.model))
    checks.start_time(start)
    checks.check_state(eq.model, start)
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


def _coefficients(
    eq: Equations, at: Snapshot, *, check: bool = True
) -> tuple[Sparse, Sparse, Sparse, Sparse]:
    """M, C, K and the independent rows of D. ModelError: no balance."""
    q, v = np.ravel(at.q).astype(float), np.ravel(at.v).astype(float)
    M = eq.mass(q)
    _check_rank(eq)
    if v.any():
        v_dot, multipliers = _accelerations(eq, at.t, q, v)
        unbalanced = M @ to_inertial_axes(q, v_dot)
    else:  # of drivers only the present value counts
        unbalanced, multipliers, _ = balance(eq, at.t, q)
    terms = eq.terms(at.t, q, v)
    if check:
        _check_velocities(eq, terms, v, eq.gross_forces(at.t, q, v))
    K, C = stiffness(eq, at.t, q, v, multipliers), damping(eq, at.t, q, v)
    if check:
        _check_balance(eq, eq.acting(at.t, q, v, multipliers), K, unbalanced, moving=bool(v.any()))
    return M, C, K, terms.D[eq.independent]


def _accelerations(eq: Equations, t: float, q: Floats, v: Floats) -> tuple[Floats, Floats]:
    return System(eq.model).accelerations(t, q, v, eq.dynamics.history)


def _check_balance(eq: Equations, acting: Floats, K: Sparse, unbalanced: Floats, *, moving: bool) -> None:
    """ModelError: forces in the directions that the joints leave, or accelerations."""
    size = np.abs(unbalanced) / np.maximum(acting, eq.preload(K))
    if size.max() > BALANCE:
        body, k = divmod(int(size.argmax()), 6)
        value = f"{unbalanced.reshape(-1, 6)[body, k]:.3g} {'N' if k < 3 else 'N m'}"
        name = eq.core.body_name(body)
        why = (
            f"is not in balance: body '{name}' is driven by {value}; start from "
            "linkwork.equilibrium(model).model"
        )
        if moving:
            why = (
                f"accelerates: body '{name}' needs {value} for it; linearize at rest, or in motion in which "
                "no center of mass and no rotation accelerates, such as that of an upright top"
            )
        raise ModelError(
            f"linearize: the model '{eq.model.name}' {why}", code="not_in_balance", bodies=[name]
        )


def _check_velocities(eq: Equations, terms: Terms, v: Floats, gross: Floats) -> None:
    """ModelError: a driver moves, and the bodies do not."""
    off = np.abs(terms.Phi_dot) / eq.row_lengths
    if off.max(initial=0.0) > FOLLOWED * eq.rate(v, gross):
        name = eq.joints([int(off.argmax())])[0]
        raise ModelError(
            f"linearize: the velocities of the model '{eq.model.name}' do not satisfy joint '{name}', as "
            "where a driver moves: start from linkwork.assemble(model).model",
            code="inconsistent_velocity",
            joints=[name],
        )


def _check_rank(eq: Equations) -> None:
    if eq.rank.singular_rows:
        names = eq.joints(eq.rank.singular_rows)
        raise ModelError(
            f"linearize: the pose is singular: the equations of {', '.join(names)} depend on others for the "
            "moment, so that small motions are not linear; choose another pose",
            code="singular_pose",
            joints=names,
        )


def _refuse_velocity_rows(eq: Equations) -> None:
    names = eq.joints(np.flatnonzero(~eq.holonomic))
    if names:
        raise ModelError(
            f"linearize: {', '.join(names)} restrict{'s' if len(names) == 1 else ''} velocities only: "
            "linearize at rest",
            code="velocity_constraints",
            joints=names,
        )


def _refuse_change(
    eq: Equations, at: Snapshot, now: tuple[Sparse, Sparse, Sparse, Sparse], Z: Floats
) -> None:
    """ModelError: the coefficients are other ones after a small turn."""
    q, v = np.ravel(at.q), np.ravel(at.v)
    rate = float(np.abs(v / eq.scale).max() / eq.length)
    later = TURN / rate
    soon = Snapshot(at.t, displaced(q, later * to_inertial_axes(q, v)).reshape(-1, 7), at.v)
    then = _coefficients(eq, soon, check=False)
    names = ("inertia", "damping", "stiffness")
    inertia = _norm(Z.T @ (now[0] @ Z))
    changed = [
        name
        for k, (name, a, b) in enumerate(zip(names, now, then, strict=False))
        if _norm(Z.T @ (a @ Z) - Z.T @ (b @ Z))
        > STEADY * max(_norm(Z.T @ (a @ Z)), COUNTS * inertia * rate**k)
    ]
    if then[3].nnz and _norm((then[3] @ Z) / np.abs(then[3]).max()) > STEADY * _norm(Z):
        changed.append("freedoms")
    if changed:
        change = "changes" if len(changed) == 1 and changed != ["freedoms"] else "change"
        raise ModelError(
            f"linearize: the model '{eq.model.name}' moves so that its {' and '.join(changed)} {change} "
            "with time: there are no frequencies; linearize at rest, or in motion that looks the same at all "
            "times",
            code="not_steady",
        )


def _scaled(eq: Equations, K: Sparse) -> Sparse:
    """In N/m: rotations by the size of the mechanism."""
    return K.multiply(eq.scale[:, None]).multiply(eq.scale[None, :])


def _norm(a: Floats) -> float:
    return float(np.linalg.norm(a))


def _without_rounding(eq: Equations, s: Complex, shapes: Complex, M: Sparse, K: Sparse) -> Complex:
    """Zero for neutral motions: those whose stiffness is none, and that no damping brings to rest."""

    def of(A: Sparse, x: Complex | Floats) -> Floats:
        return np.asarray(np.abs(np.sum(x.conj() * (A @ x), axis=0)))

    largest = np.abs(s).max(initial=0.0)
    stiffest = float(abs(_scaled(eq, K)).max()) if K.nnz else 0.0
    noise = NEUTRAL * of(abs(K), np.abs(shapes))
    noise += EPSILON * stiffest * np.sum(np.abs(shapes / eq.scale[:, None]) ** 2, axis=0)
    mass = of(M, shapes)
    neutral = (of(K, shapes) <= noise) & (np.abs(s) ** 2 * mass <= noise + (ROUNDED * largest) ** 2 * mass)
    return np.where(neutral, 0.0, s)


def _symmetric(K: Sparse) -> bool:
    """Whether scaled entries differ from those across the diagonal by rounding of their bodies' largest."""
    skew, entries = abs(K - K.T).tocoo(), K.tocoo()
    size = np.zeros(K.shape[0] // 6)
    for place in (entries.row, entries.col):
        np.maximum.at(size, place // 6, np.abs(entries.data))
    return bool((skew.data <= SMALL * np.sqrt(size[skew.row // 6] * size[skew.col // 6])).all())


# --- small models ---


def _dense(M: Sparse, C: Sparse, K: Sparse, Z: Floats, symmetric: bool) -> tuple[Complex, Complex]:
    """Eigenvalues (k,) and shapes (6n, k): y'' + ... over x = Z y; of conjugate pairs both."""
    from scipy.linalg import eig, eigh

    m, c, k = (Z.T @ (a @ Z) for a in (M, C, K))
    f = len(m)
    if not f:
        return np.zeros(0, complex), np.zeros((len(Z), 0), complex)
    unit = _unit_masses((m + m.T) / 2)
    m, c, k = (unit[:, None] * a * unit for a in ((m + m.T) / 2, c, k))
    _, y = eigh((k + k.T) / 2, m)
    squares, shapes = _quotients(k, m, y), Z @ (unit[:, None] * y)
    if symmetric and not C.count_nonzero():
        return _from_squares(squares), shapes.astype(complex)
    # a'' + c a' + k a = 0 over motions y without damping: their rates may be far apart
    k = np.diag(squares) if symmetric else y.T @ k @ y
    s, a = eig(np.block([[np.zeros((f, f)), np.eye(f)], [-k, -y.T @ c @ y]]))
    return s, shapes @ a[:f]


def _unit_masses(m: Floats) -> Floats:
    """Factors (f,) of the motions by which each has the mass 1. ModelError: one moves no mass."""
    diagonal = np.diagonal(m)
    unit = 1 / np.sqrt(np.where(diagonal > 0, diagonal, 1.0))
    values = np.linalg.eigvalsh(unit[:, None] * m * unit)
    if values[0] <= MASSLESS * values[-1]:
        raise ModelError(
            "linearize: a motion that the joints allow moves no mass: give its bodies mass and inertia",
            code="massless",
        )
    return np.asarray(unit)


def _quotients(K: Any, M: Any, x: Floats) -> Floats:
    """Rayleigh's quotients (k,) of x (n, k): slow motions beside quick ones have more digits by them."""
    return np.asarray(np.sum(x * (K @ x), axis=0) / np.sum(x * (M @ x), axis=0))


def _from_squares(squares: Floats) -> Complex:
    """s = i omega of omega^2, real where it is negative."""
    root = np.sqrt(np.abs(squares))
    return np.where(squares >= 0, 1j * root, root)


def _one_of_each_pair(s: Complex, shapes: Complex) -> tuple[Complex, Complex]:
    keep = s.imag >= -REAL * np.abs(s)
    s, shapes = s[keep], shapes[:, keep]
    order = np.argsort(np.abs(s), kind="stable")
    return s[order], shapes[:, order]


# --- large models ---


def _some_motions(eq: Equations, D: Sparse) -> Floats:
    """What D leaves of a few random motions (6n, k): enough to see whether coefficients change."""
    from scipy.sparse import diags_array

    W = diags_array(1 / eq.scale**2).tocsr()
    solve = _constrained_solver(W, D)
    random = np.random.default_rng(0).standard_normal((PROBES, D.shape[1]))
    return np.transpose([solve(b / eq.scale) for b in random])


def _rate(M: Sparse, C: Sparse | None, K: Sparse) -> float:
    """About the largest that frequencies may be [1/s], 1 without stiffness and damping."""
    heaviest = max(M.diagonal().max(), TINY)
    strongest, stiffest = (0.0 if a is None else float(abs(a).sum(axis=1).max()) for a in (C, K))
    return float(np.sqrt(stiffest / heaviest)) or strongest / heaviest or 1.0


def _constrained_solver(A: Sparse, D: Sparse) -> Callable[[Floats], Floats]:
    """b -> x with A x + D^T mu = b, D x = 0. ModelError: singular."""
    from scipy.sparse import block_array
    from scipy.sparse.linalg import splu

    size = A.shape[0]
    try:
        factor = splu(block_array([[A, D.T], [D, None]], format="csc"))
    except RuntimeError as error:
        raise ModelError(
            "linearize: the matrix of the small motions is singular: the pose is singular, or `near` is a "
            "frequency of the model",
            code="singular_pose",
        ) from error
    rest = np.zeros(D.shape[0])

    def solve(b: Floats) -> Floats:
        x: Floats = factor.solve(np.concatenate([b, rest]).astype(A.dtype))[:size]
        return x

    return solve


# Of a multiple eigenvalue a Krylov space has one motion, and others by rounding: so it is asked again, for
# one without those that are known, until there is none nearer. In omega^2 others are nearest than in omega:
# so it is asked for more until those are all known that may be nearer to `near`.
def _lanczos(M: Sparse, K: Sparse, D: Sparse, modes: int, near: float) -> tuple[Complex, Complex]:
    """(K - sigma M) x + D^T mu = M b, D x = 0 solved for each vector b of a Krylov space."""
    from scipy.sparse.linalg import LinearOperator

    symmetric, sigma = (K + K.T) / 2, near**2 or -SQUARE_SHIFT * _rate(M, None, K) ** 2
    solve = _constrained_solver(symmetric - sigma * M, D)
    random, free = np.random.default_rng(0), M.shape[0] - D.shape[0]
    squares, x, count = np.zeros(0), np.zeros((M.shape[0], 0)), min(modes, free)
    wanted = count

    def without_known(b: Floats) -> Floats:
        z = solve(b)
        return np.asarray(z - x @ (x.T @ (M @ z)))

    inverse = LinearOperator(M.shape, matvec=without_known, dtype=float)
    while len(squares) < free:
        first = without_known(M @ random.standard_normal(M.shape[0]))
        missing = max(wanted - len(squares), 1)
        more, shapes = _converged(symmetric, M, missing, sigma, inverse, first)
        far = np.sort(np.abs(squares - sigma))[wanted - 1] if len(squares) >= wanted else np.inf
        nearer = np.abs(more - sigma) < (1 - EQUAL) * far
        squares, x = np.append(squares, more[nearer]), np.hstack([x, shapes[:, nearer]])
        if not nearer.any():
            farthest = np.sort(np.abs(_from_squares(squares) - 1j * near))[count - 1]
            if farthest <= _known_to(sigma, (1 + EQUAL) * far, near):
                break
            wanted = min(2 * wanted, free)
    order = np.argsort(np.abs(_from_squares(squares) - 1j * near), kind="stable")[:count]
    return _from_squares(_quotients(symmetric, M, x[:, order])), x[:, order].astype(complex)


def _known_to(sigma: float, radius: float, near: float) -> float:
    """Up to which distance of s from i near all are known, where the radius about sigma has all omega^2."""
    above = np.sqrt(max(sigma + radius, 0.0)) - near
    least = sigma - radius
    below = near - np.sqrt(least) if least > 0 else np.sqrt(near**2 - least)
    return float(min(above, below))


def _converged(
    K: Sparse, M: Sparse, count: int, sigma: float, inverse: Any, first: Floats
) -> tuple[Floats, Floats]:
    """Squares (k,) and motions (6n, k) of at most so many modes: of equal ones not all may be found, and one
    where so many are equal that the Krylov space has hardly another."""
    from scipy.sparse.linalg import ArpackError, ArpackNoConvergence, eigsh

    try:
        squares, x = eigsh(K, k=count, M=M, sigma=sigma, OPinv=inverse, v0=first)
    except ArpackNoConvergence as error:
        if not len(error.eigenvalues):
            raise
        squares, x = error.eigenvalues, error.eigenvectors
    except ArpackError:
        x = first[:, None]
        for _ in range(POWERS):
            x = inverse.matvec(M @ x[:, 0])[:, None]
            x = x / np.sqrt(np.sum(x * (M @ x)))
        squares = _quotients(K, M, x)
    return squares, x


# Where the shift is far from i near others are nearest to it: so it is asked again, from a nearer shift and
# for more, until those are all known that may be nearer to i near.
def _arnoldi(M: Sparse, C: Sparse, K: Sparse, D: Sparse, modes: int, near: float) -> tuple[Complex, Complex]:
    every = 2 * (D.shape[1] - D.shape[0])
    count, found = min(modes, every), (np.zeros(0, complex), np.zeros((D.shape[1], 0), complex))
    shifts = [1j * near] if near else [-shift * _rate(M, C, K) for shift in SHIFTS]
    needed = int(np.ceil(np.log2(every / count))) if count else 0
    doublings = min(needed, DOUBLINGS)
    for sigma in shifts if count else ():
        nearest = _nearest(M, C, K, D, sigma)
        for k in range(doublings + 1 if sigma == shifts[-1] else 1):
            s, shapes, radius = nearest(2 * count * 2**k + 2, every)
            distance = np.abs(s - 1j * near)
            chosen = np.sort(np.argsort(distance, kind="stable")[:count])
            found = s[chosen], shapes[:, chosen]
            farthest = distance[chosen].max() if len(chosen) == count else np.inf
            if farthest + abs(sigma - 1j * near) <= (1 + EQUAL) * radius:
                return found
    if doublings < needed:
        raise NotConvergedError(
            f"linearize: beside what is stiff here it is not certain which {count} modes are nearest: ask "
            "for more modes, or give `near`",
            code="modes_not_found",
        )
    return found


# With eta = x':  x_new = (x_old's share) of (sigma^2 M + sigma C + K) x_new = -(C + sigma M) x - M eta,
# eta_new = sigma x_new + x: one application of (A - sigma B)^-1 B of the first-order equations.
def _nearest(
    M: Sparse, C: Sparse, K: Sparse, D: Sparse, sigma: complex
) -> Callable[[int, int], tuple[Complex, Complex, float]]:
    """Of a number, of so many that there are: s nearest to sigma, one of each pair, their shapes, and the
    radius in which these are all."""
    from scipy.sparse.linalg import LinearOperator

    real = np.imag(sigma) == 0
    shift = np.real(sigma) if real else sigma
    solve = _constrained_solver((shift * shift * M + shift * C + K).tocsr(), D)
    size = M.shape[0]

    def apply(z: Complex) -> Complex:
        x, eta = z[:size], z[size:]
        new = solve(-(C @ x + shift * (M @ x)) - M @ eta)
        return np.concatenate([new, shift * new + x])

    operator = LinearOperator((2 * size, 2 * size), matvec=apply, dtype=float if real else complex)
    allowed = solve(M @ np.random.default_rng(0).standard_normal(size))
    first = np.concatenate([allowed, allowed])

    def found(number: int, every: int) -> tuple[Complex, Complex, float]:
        theta, z = _largest(operator, min(number, 2 * size - 2), min(number, every), first)
        off = np.abs(D @ z[size:]).max(axis=0, initial=0.0)  # a Krylov space that is exhausted has others
        all_terms = (abs(D) @ np.abs(z[size:])).max(axis=0, initial=0.0)
        rounding = ALLOWED**3 * abs(D).max() * np.abs(z[size:]).max(axis=0, initial=0.0) if D.nnz else 0.0
        motion = off <= np.maximum(ALLOWED * all_terms, rounding)  # joints may have no part in it
        s = sigma + 1 / theta[motion]
        s[np.abs(s) <= REAL * np.abs(sigma)] = 0.0
        s, shapes = _one_of_each_pair(s, z[:size, motion])
        return s, shapes, float(np.abs(1 / theta).max()) if number < every else np.inf

    return found


def _largest(operator: Any, number: int, enough: int, first: Complex) -> tuple[Complex, Complex]:
    """Eigenvalues and vectors, `enough` at least: where there are no more others do not converge."""
    from scipy.sparse.linalg import ArpackNoConvergence, eigs

    error: ArpackNoConvergence | None = None
    for vectors in VECTORS:
        ncv = min(max(vectors * number + 1, FEWEST), operator.shape[0])
        try:
            theta, z = eigs(operator, k=number, v0=first, ncv=ncv, maxiter=RESTARTS)
            return theta, z
        except ArpackNoConvergence as failure:
            error = failure
            if len(failure.eigenvalues) >= enough - 1:  # of a pair one may be left out
                return failure.eigenvalues, failure.eigenvectors
    raise NotConvergedError(
        f"linearize: the iteration for {number} eigenvalues did not converge: ask for fewer modes, or give "
        "`near`",
        code="modes_not_found",
    ) from error


# Lanczos finds the eigenvalue nearest to the shift: the smallest, if the shift is below all. A safe bound is
# far below, where digits are few: from there the shift goes most of the way up to a rough value.
def softest_by_lanczos(W: Sparse, K: Sparse, D: Sparse, scale: float) -> tuple[float, Floats]:
    """The smallest k of K x + D^T mu = k W x, D x = 0, and its x (6n,).

    K symmetric, W diagonal, `scale` of K in units of W.
    """
    from scipy.sparse.linalg import LinearOperator, eigsh

    if D.shape[0] >= D.shape[1]:
        return np.nan, np.zeros(D.shape[1])
    sigma = min(_lower_bound(W, K), 0.0) - BELOW * (scale or 1.0)
    first = np.random.default_rng(0).standard_normal(W.shape[0])
    for tolerance in (ROUGH, 0.0):
        inverse = LinearOperator(W.shape, matvec=_constrained_solver(K - sigma * W, D), dtype=float)
        first = inverse @ (W @ first)
        values, x = eigsh(K, k=1, M=W, sigma=sigma, OPinv=inverse, v0=first, tol=tolerance)
        sigma, first = sigma + (1 - BELOW) * (float(values[0]) - sigma), x[:, 0]
    return float(values[0]), x[:, 0]


def _lower_bound(W: Sparse, K: Sparse) -> float:
    """Of the eigenvalues of K x = k W x, those of W^-1/2 K W^-1/2: Gershgorin's discs."""
    from scipy.sparse import diags_array

    root = diags_array(1 / np.sqrt(W.diagonal()))
    scaled = (root @ K @ root).tocsr()
    diagonal = scaled.diagonal()
    return float((diagonal + np.abs(diagonal) - abs(scaled).sum(axis=1)).min())
