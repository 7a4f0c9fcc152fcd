"""Written by `./dev stubs`."""

from collections.abc import Mapping
from typing import Literal, TypedDict

from linkwork import _core

Level = Literal["position", "velocity", "acceleration"]
IntegratorName = Literal[
    "euler",
    "semi_implicit_euler",
    "heun",
    "rk3",
    "rk4",
    "ab2",
    "ab3",
    "ab4",
    "ab5",
    "abm4",
    "bs32",
    "dopri5",
    "tsit5",
    "dop853",
    "hem4",
    "phem56",
]

class Options(TypedDict, total=False):
    """What `simulate` and `System` take by name; what is left out, or None, has its default."""

    formulation: Literal["standard", "penalty", "augmented_lagrangian"]
    """how accelerations and multipliers follow from the equations: standard, penalty, augmented_lagrangian, default standard"""
    matrix_form: Literal["auto", "kkt", "schur", "normal"]
    """matrix of the formulation, of the standard one kkt (12.3) or schur (12.5): auto, kkt, schur, normal, default auto"""
    stabilization: Literal[
        "none", "baumgarte", "sampled_baumgarte", "projection", "position_projection", "velocity_projection"
    ]
    """how drift off the constraints is held; of half-explicit methods projection: none, baumgarte, sampled_baumgarte, projection, position_projection, velocity_projection, default sampled_baumgarte"""
    linear_solver: Literal[
        "auto",
        "block",
        "cholmod",
        "cholmod_simplicial",
        "cholmod_supernodal",
        "umfpack",
        "klu",
        "spqr",
        "eigen_ldlt",
        "dense",
    ]
    """what factorizes the matrix: auto, block, cholmod, cholmod_simplicial, cholmod_supernodal, umfpack, klu, spqr, eigen_ldlt, dense, default auto"""
    baumgarte_alpha: float | None
    """gain of the velocity violation, with baumgarte_beta; without both 5, and of sampled_baumgarte what the step takes [1/s] (of baumgarte, sampled_baumgarte)"""
    baumgarte_beta: float | None
    """gain of the position violation, with baumgarte_alpha; without both 5, and of sampled_baumgarte what the step takes [1/s] (of baumgarte, sampled_baumgarte)"""
    penalty: float | None
    """penalty factor of all equations; without it scaled to the inertia of each (of penalty, augmented_lagrangian)"""
    penalty_scale: float | None
    """penalty factor of each equation times its D M^-1 D^T; without it chosen by the method (of penalty, augmented_lagrangian)"""
    damping_ratio: float | None
    """mu of (12.14), 1 where only frequency is given (of penalty, augmented_lagrangian)"""
    frequency: float | None
    """omega of (12.14), 10 where only damping_ratio is given [rad/s] (of penalty, augmented_lagrangian)"""
    tolerance: float | None
    """change of the accelerations, relative to |v_dot| + |M^-1 g|, at which the iteration stops (of augmented_lagrangian), default 1e-12"""
    max_iterations: int | None
    """cap of the iteration (of augmented_lagrangian), default 100"""
    deterministic: bool | None
    """the same bits on every x86-64 processor: one path of instructions for all, without solvers that use BLAS; takes 1.3 to 1.8 times as long"""
    threads: int | None
    """that share the work of one evaluation, with the same bits whatever their number; without it one for each processor that this process may use, and in the processes of studies and comparisons 1; models too small to gain take 1 in any case"""
    on_singular: Literal["pass", "warn", "stop"]
    """what a singular pose means to the run: pass, warn, stop, default pass"""
    violation_limit: float | Mapping[Level, float] | None
    """largest violation at the ends of steps, of positions or by level: position, velocity, acceleration [m or 1]"""
    on_violation: Literal["record", "project", "stop"]
    """what is done beyond violation_limit: record, project, stop, default record"""

def described(option: _core.OptionInfo) -> str: ...
