"""What `linkwork bench` shows people."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from linkwork import benchmark, integrators
from linkwork.benchmark import (
    Comparison,
    Growth,
    Lanes,
    Large,
    LargeRun,
    Left,
    Measured,
    Missing,
    Refused,
    Run,
    Size,
    Steps,
)
from linkwork.benchmark.articulated import NOT_INSTALLED
from linkwork.cli import output as out
from linkwork.errors import counted

#: Keys of ns_per_body, and columns.
PARTS = ("evaluate", "assemble", "factorize", "solve", "reactions", "whole")
FACTORS = ("solver", "analyze", "flops", "GFlop/s", "factors", "nonzeros", "fill", "peak memory", "residuals")
SIZES = ("bodies", "ns per body", "build", "compile", "analyze", "bytes per body", "at the peak")
STEPS = ("mechanism", "method", "bodies", "us per step", "ns per body, rhs")
SHARES = ("evaluate", "factorize", "solve", "rest")
VERDICT = ("steps", "watching", "verdict")
RUNS = ("mechanism", "method", "bodies", "step [s]", "time [s]", "setup [s]", "compiled", "energy error [J]")
LARGE = (
    "bodies",
    "equations",
    "rank",
    "redundant",
    "freedoms",
    "setup",
    "CPU s per step of RK4",
    "bytes per body",
)
LARGE_RUNS = ("method", "step [s]", "CPU [s]", "error", "violation", "energy", "why it does not count")


def show_comparison(found: Comparison) -> None:
    each = (found.bodies, "body"), (found.joints, "joint"), (found.rows, "constraint")
    counts = ", ".join(counted(*it, form=",") for it in each)
    print(f"{found.mechanism}{_shown(found.parameters)}: {counts}")
    print(f"formulation {found.formulation}")
    measured = [solver for solver in found.solvers if isinstance(solver, Measured)]
    if measured:
        out.print_table(
            ("solver", "matrix", *PARTS),
            [(s.solver, s.matrix_form, *(f"{s.ns_per_body[part]:,.0f}" for part in PARTS)) for s in measured],
            title="One right-hand side, ns per body (assemble 0: part of factorize)",
            left=2,
        )
        out.print_table(
            FACTORS,
            [_factor_cells(solver) for solver in measured],
            title="Analysis, one factorization, residuals of M v_dot - D^T lambda = g and D v_dot = gamma",
        )
    refused = [(s.solver, s.reason) for s in found.solvers if isinstance(s, Refused)]
    if refused:
        out.print_table(("solver", "why not"), refused, title="Left out", left=2)
    _show_machine()


def show_growth(found: Growth) -> None:
    print(f"{found.mechanism}, linear solver {found.linear_solver}")
    print(f"formulation {found.formulation}")
    measured = [_size_cells(size) for size in found.sizes if isinstance(size, Size)]
    if measured:
        title = "One right-hand side, time to set up, resident memory"
        out.print_table(SIZES, measured, title=title, left=0)
    missing = [(f"{size.bodies:,}", size.reason) for size in found.sizes if isinstance(size, Missing)]
    if missing:
        out.print_table(("bodies", "why not"), missing, title="Left out", left=2)
    if found.exponent is not None:
        print(f"\nA right-hand side takes ~ bodies ^ {found.exponent:.2f}.")
    _show_machine()


def show_steps(steps: Sequence[Steps], runs: Sequence[Run]) -> None:
    title = (
        "One step of RK4, and what takes its time (factorize: with the first solution; watch: the look at "
        "redundant equations, part of the rest)"
    )
    columns = (*STEPS, *SHARES, "watch", *VERDICT)
    out.print_table(columns, [_step_cells(one) for one in steps], title=title, left=2)
    if runs:
        title = f"Runs of {runs[0].t_end:g} s through simulate"
        out.print_table(RUNS, [_run_cells(run) for run in runs], title=title, left=2)
    _show_machine()


def show_lanes(found: Sequence[Lanes]) -> None:
    """Of one body, and of one mechanism."""
    threads = list(found[0].packed)
    columns: tuple[str, ...] = ("mechanism", "bodies", "by itself", "deterministic")
    columns += tuple(f"lanes, {counted(it, 'thread')}" for it in threads)
    columns += ("times", "whole [us]", "MuJoCo rollout", "Pinocchio", "difference")
    rows = []
    for it in found:
        packed = [it.packed[count] for count in threads]
        each = [f"{ns / it.bodies:,.0f}" for ns in (it.single, it.deterministic, *packed)]
        peers = [", ".join(f"{ns / it.bodies:,.0f}" for ns in times.values())
                 for times in (it.mujoco, it.pinocchio)]  # fmt: skip
        rows.append((it.mechanism, f"{it.bodies}", *each, f"{it.single / packed[0]:.1f}",
                     f"{packed[0] / 1e3:.2f}", *peers, f"{it.difference:.0e}"))  # fmt: skip
    title = (
        f"One right-hand side with reactions, ns per body of all {found[0].lanes} lanes (times: as fast as "
        "by itself, on one thread; MuJoCo: a step of Euler's method; Pinocchio: accelerations alone)"
    )
    out.print_table(columns, rows, title=title, left=1)
    _show_peers(found)
    _show_machine()


def show_large(found: Sequence[Large | Left]) -> None:
    """A section for each model, then the least time for each error."""
    for it in found:
        if isinstance(it, Left):
            print(f"\n{it.model}: not measured: {it.reason}")
        else:
            _show_one_large(it)
    measured = [it for it in found if isinstance(it, Large) and it.runs]
    if measured:
        columns = ("model", "bodies", *(f"error {error:g}" for error in benchmark.ERRORS))
        rows = [
            (it.model, f"{it.bodies:,}", *(_least(it, error) for error in benchmark.ERRORS))
            for it in measured
        ]
        title = (
            "Least CPU seconds of a run with no larger error, by linkwork and, where it takes less, a peer"
        )
        out.print_table(columns, rows, title=title, left=1)
    _show_machine()


def _show_one_large(it: Large) -> None:
    what = f"{it.mechanism}{_shown(it.parameters)}"
    print(f"\n{it.model}: {what}, {it.t_end:g} s, {counted(it.threads, 'thread')}")
    cells = (f"{n:,}" for n in (it.bodies, it.equations, it.rank, it.redundant, it.degrees_of_freedom))
    each = f"{it.setup_seconds:.3g} s", f"{it.cpu_seconds_per_step:.3g}", _count(it.bytes_per_body)
    out.print_table(LARGE, [(*cells, *each)], left=0)
    if it.runs:
        print(f"Reference: {it.reference}; it differs from twice the step by {it.reference_error:.0e}")
        out.print_table(LARGE_RUNS, [_large_cells(run) for run in it.runs])
    for reason in it.left_out:
        print(f"left out: {reason}")


def _large_cells(run: LargeRun) -> tuple[str, ...]:
    sizes = (run.error, run.violation, run.energy_error)
    cells = ("" if size is None else f"{size:.0e}" for size in sizes)
    return (
        run.method, f"{run.step:g}", "" if run.cpu_seconds is None else f"{run.cpu_seconds:.3g}", *cells,
        run.reason,
    )  # fmt: skip


def _least(it: Large, error: float) -> str:
    """In CPU seconds, with its method: ours, and a peer's where that is less."""
    runs = benchmark.least_cost(it, error).values()
    ours = [run for run in runs if run.method in integrators.METHODS]
    best = [min(some, key=_cpu) for some in (ours, [*runs]) if some]
    shown = dict.fromkeys(f"{_cpu(run):.3g} ({run.method}, {run.step:g} s)" for run in best)
    return "; ".join(shown) or "-"


def _cpu(run: LargeRun) -> float:
    return float("inf") if run.cpu_seconds is None else run.cpu_seconds


def _show_peers(found: Sequence[Lanes]) -> None:
    """What they solve, and which are not there."""
    missing = [] if all(it.mujoco for it in found if it.mechanism == "chain") else ["MuJoCo"]
    solved = [(it.mechanism, it.pinocchio_solves) for it in found if it.pinocchio_solves != NOT_INSTALLED]
    if solved:
        out.print_table(("mechanism", "what Pinocchio solves"), solved, title="", left=2)
    else:
        missing.append("Pinocchio")
    for name in missing:
        print(f"\n{name} {NOT_INSTALLED}: pip install 'linkwork[bench]'")


def _factor_cells(solver: Measured) -> tuple[str, ...]:
    rate = solver.flops_per_second
    return (
        solver.solver,
        f"{1e3 * solver.analyze_seconds:.3g} ms",
        "unknown" if solver.flops is None else f"{solver.flops:.3g}",
        "unknown" if rate is None else f"{1e-9 * rate:.2f}",
        _bytes(solver.factor_bytes),
        f"{solver.factor_nonzeros:,}",
        f"{solver.fill:.2f}",
        _bytes(solver.peak_bytes),
        f"{solver.residuals['motion']:.0e} {solver.residuals['constraint']:.0e}",
    )


def _size_cells(size: Size) -> tuple[str, ...]:
    times = (size.build_seconds, size.compile_seconds, size.analyze_seconds)
    return (
        f"{size.bodies:,}",
        f"{size.ns_per_body['whole']:,.0f}",
        *(f"{seconds:.3g} s" for seconds in times),
        _count(size.bytes_per_body),
        _count(size.peak_bytes_per_body),
    )


def _step_cells(one: Steps) -> tuple[str, ...]:
    return (
        one.mechanism,
        f"{one.formulation}, {one.linear_solver}",
        f"{one.bodies:,}",
        f"{one.us_per_step:,.1f}",
        f"{one.ns_per_body_and_evaluation:,.0f}",
        *(f"{one.shares[part]:.0%}" for part in SHARES),
        f"{one.watch_share:.2%}",
        f"{one.steps:,}",
        f"{one.watching:.1%}",
        f"{one.verdict:.1%}",
    )


def _run_cells(run: Run) -> tuple[str, ...]:
    return (
        run.mechanism + _shown(run.parameters),
        f"{run.formulation}, {run.linear_solver}",
        f"{run.bodies:,}",
        f"{run.step:g}",
        f"{run.seconds:.3g}",
        f"{run.setup_seconds:.3g}",
        f"{run.compiled_share:.1%}",
        f"{run.max_energy_error:.1e}",
    )


def _show_machine() -> None:
    facts = benchmark.machine()
    version, when = facts["versions"]["linkwork"], facts["date"]
    print(f"\n{facts['cpu']}, {facts['instruction_set']}, linkwork {version}, {when}")


def _shown(parameters: Mapping[str, Any]) -> str:
    return f" ({', '.join(f'{name} {value}' for name, value in parameters.items())})" if parameters else ""


def _bytes(count: int | None) -> str:
    if count is None:
        return "unknown"
    for limit, unit in ((1e9, "GB"), (1e6, "MB"), (1e3, "kB")):
        if count >= limit:
            return f"{count / limit:.3g} {unit}"
    return f"{count} B"


def _count(value: float | None) -> str:
    return "unknown" if value is None else f"{value:,.0f}"
