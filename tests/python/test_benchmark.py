"""Benchmarks: what is counted is right, what cannot be measured is said, and no test asserts a time."""

from __future__ import annotations

import json
import math
import os
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import benchmark
from linkwork.benchmark import Measured, Missing, Refused, Size, Subject
from linkwork.benchmark.articulated import _Tree, articulated
from linkwork.benchmark.isolated import Failure, isolated
from linkwork.benchmark.residuals import residuals
from linkwork.benchmark.scaling import fitted_exponent
from linkwork.cli import run
from linkwork.mechanisms import MECHANISMS

ALL = [info.name for info in lw._core.linear_solvers()]
PARTS = {"evaluate", "assemble", "factorize", "solve", "reactions", "whole"}


def measured(found: benchmark.Comparison) -> dict[str, Measured]:
    return {solver.solver: solver for solver in found.solvers if isinstance(solver, Measured)}


def refused(found: benchmark.Comparison) -> dict[str, Refused]:
    return {solver.solver: solver for solver in found.solvers if isinstance(solver, Refused)}


@pytest.fixture(scope="module")
def chain() -> benchmark.Comparison:
    return benchmark.compare_solvers(Subject.of("chain", bodies=30), rounds=2, progress=False)


# --- right-hand sides ---


def test_every_linear_solver_is_listed_once_and_solves_both_block_rows(chain: benchmark.Comparison) -> None:
    assert [solver.solver for solver in chain.solvers] == ALL
    for name, solver in measured(chain).items():
        assert max(solver.residuals.values()) < 1e-13, name
    for name, solver in refused(chain).items():
        assert "not in this build" in solver.reason, name


def test_parts_of_a_right_hand_side_are_times(chain: benchmark.Comparison) -> None:
    for name, solver in measured(chain).items():
        assert solver.ns_per_body.keys() == PARTS
        assert min(solver.ns_per_body.values()) >= 0, name
        assert (solver.ns_per_body["assemble"] == 0) == (name == "block")  # it assembles on its way
        first, third = solver.whole_quartiles_ns_per_body
        assert 0 < first <= solver.ns_per_body["whole"] <= third, name


def test_factors_of_a_chain_have_the_entries_and_the_operations_of_a_block_tridiagonal_matrix(
    chain: benchmark.Comparison,
) -> None:
    n, found = chain.bodies, measured(chain)
    for name in {"cholmod", "cholmod_simplicial", "eigen_ldlt"} & found.keys():
        assert found[name].matrix_nonzeros == 15 * n + 25 * (n - 1)
        assert found[name].fill == 1, name
        # a column of the Cholesky factor with k entries takes k^2 operations
        assert found[name].flops == (n - 1) * (6**2 + 7**2 + 8**2 + 9**2 + 10**2) + 55, name
    dense = found["dense"]
    assert dense.factor_nonzeros == (5 * n) ** 2
    assert dense.flops == pytest.approx((5 * n) ** 3 / 3)


def test_factors_fit_into_their_bytes_and_these_into_the_memory_at_its_peak(
    chain: benchmark.Comparison,
) -> None:
    for name, solver in measured(chain).items():
        assert solver.flops is not None and solver.flops > 0, name
        assert solver.factor_bytes is not None and solver.factor_bytes > 8 * solver.factor_nonzeros / 2, name
        if solver.peak_bytes is not None:
            assert solver.factor_bytes < solver.peak_bytes < 10**9, name


def test_redundant_joints_are_left_to_the_solvers_that_can() -> None:
    subject = Subject.of("bricard")
    solvers = ["block", "dense"]
    found = benchmark.compare_solvers(subject, solvers, matrix_form="kkt", rounds=1, progress=False)
    assert measured(found).keys() == {"block"}
    assert refused(found)["dense"].code == "redundant_kkt"
    found = benchmark.compare_solvers(subject, solvers, rounds=1, progress=False)
    assert {solver.matrix_form for solver in measured(found).values()} == {"kkt", "schur"}
    assert max(solver.residuals["constraint"] for solver in measured(found).values()) < 1e-10


def test_matrix_larger_than_the_memory_is_refused_and_harms_nobody() -> None:
    subject = Subject.of("chain", bodies=60_000)  # 300 000 rows: 720 GB
    found = benchmark.compare_solvers(subject, ["dense"], rounds=1, limit=120, progress=False)
    assert refused(found)["dense"].code == "memory"


def test_solver_that_takes_too_long_is_refused() -> None:
    found = benchmark.compare_solvers(Subject.of("chain", 10), ["block"], limit=1e-3, progress=False)
    assert refused(found)["block"].reason == "not done after 0.001 s"


def test_timing_repeats_every_part() -> None:
    system = lw.System(lw.mechanisms.bricard())
    before = system.compiled().statistics()
    system.compiled().right_hand_side_times(0.0, system.initial_state(), 3)
    after = system.compiled().statistics()
    assert after["evaluations"] - before["evaluations"] == 6  # part by part, then as a whole
    assert after["factorizations"] - before["factorizations"] == 6
    assert after["solves"] - before["solves"] >= 6


def test_residuals_tell_the_row_that_is_not_solved() -> None:
    model = lw.mechanisms.chain(5)
    penalty = lw.System(model, formulation="penalty", penalty=1e4)
    found = residuals(penalty, 0.0, penalty.initial_state())
    assert found["motion"] < 1e-12 and found["constraint"] > 1e-7


# --- growth ---


def test_growth_measures_each_size_and_counts_its_memory() -> None:
    subjects = [Subject.of("chain", bodies) for bodies in (1000, 4000)]
    found = benchmark.growth(subjects, rounds=1, progress=False)
    small, large = found.sizes
    assert isinstance(small, Size) and isinstance(large, Size)
    assert (small.bodies, large.bodies, large.rows) == (1000, 4000, 20_000)
    assert found.exponent is not None
    for size in (small, large):
        if size.bytes_per_body is not None and size.peak_bytes_per_body is not None:
            # D of a body, its state and its factors are more than a kilobyte
            assert 1000 < size.bytes_per_body <= size.peak_bytes_per_body < 50_000


def test_links_of_a_long_chain_take_so_many_bytes() -> None:
    (found,) = benchmark.growth([Subject.of("chain", 100_000)], rounds=1, progress=False).sizes
    assert isinstance(found, Size)
    if found.bytes_per_body is not None and found.peak_bytes_per_body is not None:
        # of which the model, D and the factors have 1500; a copy of D or of the attachments would show
        assert found.bytes_per_body < 2400
        assert found.peak_bytes_per_body < 2800


def test_size_that_cannot_be_is_missing_with_the_reason() -> None:
    found = benchmark.growth([Subject.of("chain", 10)], limit=1e-3, progress=False)
    assert found.sizes == [Missing(10, "not done after 0.001 s", "time")]
    assert found.exponent is None


def test_exponent_is_that_of_the_power_law() -> None:
    one = Size(10, 50, {"whole": 100.0}, 1, 0.0, 0.0, 0.0, None, None)
    sizes = [replace(one, bodies=n, ns_per_body={"whole": 100.0 * n**0.25}) for n in (10, 200, 3000)]
    assert fitted_exponent(sizes) == pytest.approx(1.25)
    assert fitted_exponent(sizes[:1]) is None


# --- steps ---


def test_step_of_rk4_has_four_evaluations_and_its_shares_are_the_whole() -> None:
    chain, top = benchmark.time_steps(
        [Subject.of("chain", 3), Subject.of("torque_free_top")], rounds=1, progress=False
    )
    for steps in (chain, top):
        assert steps.evaluations_per_step == pytest.approx(4, abs=0.2)  # and that of the first state
        assert sum(steps.shares.values()) == pytest.approx(1)
    assert chain.shares["factorize"] > 0 and top.shares["factorize"] == 0  # no joints


def test_long_run_counts_its_steps_and_their_errors() -> None:
    found = benchmark.long_run(Subject.of("pendulum"), 0.5, 1e-3, progress=False)
    assert found.steps_per_second * found.seconds == pytest.approx(500)
    assert 0 < found.compiled_share <= 1
    assert found.max_energy_error < 1e-6 and found.max_position_violation < 1e-6


# --- what is measured, and where ---


@pytest.mark.parametrize("name", [name for name, record in MECHANISMS.items() if record.size is not None])
def test_subject_is_the_largest_mechanism_with_no_more_bodies(name: str) -> None:
    subject = Subject.of(name, bodies=50)
    size = subject.record.size
    assert size is not None
    assert subject.build().body_count == subject.bodies <= 50
    assert size.bodies(subject.parameters[size.parameter] + 1) > 50


@pytest.mark.parametrize(
    "arguments, code",
    [
        (("chian",), "unknown_mechanism"),
        (("bricard", 7), "one_size"),
        (("hub", 1), "bodies"),
        (("chain", 7, {"joints": "spherical"}), "unknown_option"),
    ],
)
def test_subject_that_cannot_be_is_an_error(arguments: tuple[Any, ...], code: str) -> None:
    with pytest.raises(lw.OptionError) as caught:
        Subject.of(*arguments)
    assert caught.value.code == code


@pytest.mark.parametrize(
    "task, argument, answer",
    [
        (math.sqrt, 4.0, 2.0),
        (float, "one", Failure("the process failed: ValueError: could not convert", "failed")),
        (Subject.of, "bricard", Subject("bricard", {})),
        (Subject.of, "x", Failure("no mechanism 'x'", "unknown_mechanism")),
        (bytes, 2**62, Failure("not enough memory", "memory")),
    ],
)
def test_task_in_a_process_of_its_own_answers_or_says_why_not(task: Any, argument: Any, answer: Any) -> None:
    found = isolated(task, argument, seconds=60)
    if isinstance(answer, Failure):
        assert isinstance(found, Failure) and found.code == answer.code
        assert found.reason.startswith(answer.reason)
    else:
        assert found == answer


def test_task_is_over_after_its_time_and_beats_meanwhile() -> None:
    beats: list[float] = []
    found = isolated(time.sleep, 60, seconds=1.2, beat=lambda: beats.append(time.monotonic()))
    assert found == Failure("not done after 1.2 s", "time")
    assert len(beats) >= 3


def test_process_that_is_killed_is_a_failure() -> None:
    assert isolated(os.abort, seconds=30) == Failure("the process was ended by SIGABRT", "killed")


def test_machine_tells_processor_instruction_set_and_date() -> None:
    found = benchmark.machine()
    assert {"date", "versions", "platform", "cpu", "cores", "instruction_set", "threads"} == found.keys()
    assert found["cpu"] and found["instruction_set"] in {"x86-64-v4", "x86-64-v3", "x86-64-v2", "baseline"}


# --- the command line ---


def words(capture: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = run(["bench", *arguments], debug=False)
    output = capture.readouterr()
    return code, output.out, output.err


@pytest.mark.parametrize(
    "arguments, keys",
    [
        (
            ["rhs", "--mechanism", "hub", "--set", "arms=4", "--set", "loops=yes", "--solver", "block"],
            {"mechanism", "parameters", "bodies", "joints", "rows", "formulation", "threads", "t", "solvers"},
        ),
        (
            ["scaling", "--mechanism", "net", "--bodies", "12,24"],
            {"mechanism", "formulation", "linear_solver", "threads", "sizes", "exponent"},
        ),
        (["step", "--mechanism", "pendulum", "--no-runs"], {"steps", "runs"}),
    ],
)
def test_json_is_one_document_with_machine_and_numbers(
    arguments: list[str], keys: set[str], capsys: pytest.CaptureFixture[str]
) -> None:
    code, out, err = words(capsys, *arguments, "--repeats", "1", "--json")
    assert (code, err) == (0, "")
    found = json.loads(out, parse_constant=lambda word: pytest.fail(f"{word} is not JSON"))
    assert found.keys() == keys | {"benchmark", "machine"}
    assert found["benchmark"] == arguments[0]


def test_tables_show_what_was_measured_and_what_was_left_out(capsys: pytest.CaptureFixture[str]) -> None:
    one = ["--mechanism", "bricard", "--repeats", "1"]
    code, out, _ = words(capsys, "rhs", *one, "--matrix-form", "kkt", "--solver", "block,dense")
    assert code == 0
    assert "5 bodies, 6 joints, 30 constraints" in out and "formulation standard" in out
    assert "redundant" in out.split("Left out")[1]
    code, out, _ = words(capsys, "scaling", "--bodies", "5,10", "--repeats", "1")
    assert code == 0 and "bodies ^" in out
    code, out, _ = words(capsys, "step", "--mechanism", "chain", "--no-runs", "--repeats", "1")
    assert code == 0 and "standard, block" in out


@pytest.mark.parametrize(
    "arguments, says",
    [
        (["rhs", "--mechanism", "chian"], "the nearest is 'chain'"),
        (["rhs", "--solver", "blok"], "the nearest is 'block'"),
        (["rhs", "--set", "joint"], "'joint' is not NAME=VALUE"),
        (["rhs", "--set", "bodies=many"], "bodies=many: give a value of type int"),
        (["rhs", "--repeats", "0"], "repeats 0 is too small"),
        (["rhs", "--limit", "nan"], "limit nan s must be a finite number"),
        (["rhs", "--bodies", "0"], "bodies 0: the smallest 'chain' has 1"),
        (["scaling", "--bodies", "10,x"], "'10,x' are not whole numbers"),
        (["scaling", "--mechanism", "bricard"], "has one size only"),
        (["step", "--mechanism", "cain"], "the nearest is 'chain'"),
    ],
)
def test_mistakes_are_named(arguments: list[str], says: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = words(capsys, *arguments)
    assert (code, out) == (1, "") and says in err


@pytest.mark.parametrize("command", ["rhs", "scaling", "step"])
def test_help_has_an_example(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = words(capsys, command, "--help")
    assert code == 0 and f"linkwork bench {command}" in out.split("Usage")[1].split("\n", 1)[1]
    assert all(option in out for option in ("--mechanism", "--repeats", "--json"))


def test_lanes_are_timed_beside_the_run_by_itself_once_their_accelerations_are_right() -> None:
    chain, crank = benchmark.measure_lanes([("chain", 3), ("spatial_slider_crank", None)], rounds=1)
    assert (chain.bodies, crank.bodies) == (3, 3)
    assert list(chain.packed) == [1, 2]
    assert max(chain.difference, crank.difference) < 1e-9
    assert min(chain.single, chain.deterministic, *chain.packed.values()) > 0
    assert not crank.mujoco


def test_a_mechanism_that_lanes_refuse_is_no_benchmark_of_lanes() -> None:
    """In a process of its own, as it takes half a gigabyte, which those would copy that other tests fork."""
    found = isolated(benchmark.measure_lanes, [("lattice", 2700)], seconds=120)
    assert isinstance(found, Failure) and found.reason.startswith("lattice: its loops are too large")


def test_command_prints_lanes(capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["--mechanism", "chain", "--repeats", "1", "--threads", "1"]
    assert run(["bench", "ensemble", *arguments], debug=False) == 0
    assert "lanes, 1 thread" in capsys.readouterr().out


# --- Pinocchio beside lanes ---

SOLVED: dict[str, tuple[Callable[[], lw.Model], str]] = {
    "chain": (lambda: lw.mechanisms.chain(4), "aba"),
    "ball joints": (lambda: lw.mechanisms.chain(3, joint="spherical"), "aba"),
    "ladder": (lambda: lw.mechanisms.four_bar(2), "constraintDynamics, 6 equations"),
    "bricard": (lw.mechanisms.bricard, "constraintDynamics, 6 equations"),
    "slider-crank": (lw.mechanisms.spatial_slider_crank, "constraintDynamics, 3 equations"),
    "free platform": (
        lambda: lw.mechanisms.stewart_platform(driven=False),
        "constraintDynamics, 15 equations",
    ),
}


@pytest.mark.parametrize("name", SOLVED)
def test_pinocchio_has_the_accelerations_of_every_mechanism_that_it_is_timed_on(name: str) -> None:
    pytest.importorskip("pinocchio")
    build, algorithm = SOLVED[name]
    found = articulated(build(), [1, 2])
    assert found.solves.startswith(algorithm)
    assert list(found.seconds) == ([1, 2] if algorithm == "aba" else [1])
    assert all(measure() > 0 for measure in found.seconds.values())


@pytest.mark.parametrize("name", ["chain", "slider-crank"])
def test_pinocchio_that_moves_otherwise_is_not_timed(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pinocchio")
    monkeypatch.setattr(_Tree, "_moving", lambda *_: np.zeros((2, 3)))  # velocities that are not there
    found = articulated(SOLVED[name][0](), [1])
    assert not found.seconds
    assert "accelerations" in found.solves and found.solves.endswith("off")


def test_what_pinocchio_is_not_given_is_named() -> None:
    pytest.importorskip("pinocchio")
    found = articulated(lw.mechanisms.stewart_platform(), [1])
    assert (found.solves, found.seconds) == ("not translated: displacement_driver", {})


def test_lanes_are_timed_without_the_peers_and_it_is_said_which_are_missing(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    for package in ("pinocchio", "mujoco"):
        monkeypatch.setitem(sys.modules, package, None)
    assert run(["bench", "ensemble", "--mechanism", "chain", "--repeats", "1"], debug=False) == 0
    out = capsys.readouterr().out
    assert "MuJoCo is not installed" in out and "Pinocchio is not installed" in out
