"""`bench large`: errors fall with the order of the method; what is no motion of the mechanism has no time."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import benchmark
from linkwork.benchmark import LARGE_MODELS, Large, LargeRun, least_cost
from linkwork.benchmark import large as module
from linkwork.benchmark.large import measure_model
from linkwork.benchmark.large_models import large_subjects
from linkwork.benchmark.large_peers import PEERS
from linkwork.benchmark.motion_to_end import Motion, attempt, distance, move, try_steps, unsound
from linkwork.cli import run

#: Equations that repeat others, in the sizes here.
REDUNDANT = {"tracked vehicle": 6, "ladder": 3 * 29}

#: Where contacts begin between steps no order is seen.
CONTACTS = ("net capture", "tracked vehicle")

#: Simulated [s], where it is less than in the benchmark.
SHORTER = {"tracked vehicle": 0.004, "net capture": 0.02}


def measured(
    name: str,
    methods: Sequence[str] = ("rk4",),
    *,
    links: int = 60,
    peers: bool = False,
    limit: float = 100.0,
) -> Large:
    model, subject = large_subjects([name], links=links)[0]
    model = replace(model, t_end=SHORTER.get(name, model.t_end))
    if subject.bodies > links:  # of one size only
        assert name == "tracked vehicle"
    return measure_model(model, subject, methods, 4, 1, 1, peers, limit)


@pytest.fixture(scope="module", params=LARGE_MODELS)
def found(request: pytest.FixtureRequest) -> Large:
    return measured(request.param)


def test_freedoms_are_those_that_independent_equations_leave(found: Large) -> None:
    assert found.degrees_of_freedom == 6 * found.bodies - found.rank
    assert found.redundant == found.equations - found.rank == REDUNDANT.get(found.model, 0)


def test_energy_and_joints_hold_and_errors_fall_with_the_order(found: Large) -> None:
    """By 16 for RK4, or nearly, where the motion is smooth."""
    runs = [it for it in found.runs if it.cpu_seconds is not None and it.error is not None]
    errors = [it.error for it in runs if it.error is not None]
    assert len(runs) >= 2
    assert all(it.energy_error is not None and it.energy_error < 2e-2 for it in runs)
    assert runs[-1].violation is not None and runs[-1].violation < 1e-6
    assert found.reference_error is not None and found.reference_error < errors[0]
    if found.model not in CONTACTS:
        assert found.reference_error < 1e-6
        assert errors[-2] / errors[-1] > 0.7 * 2**4


def test_semi_implicit_euler_is_of_order_1_on_a_chain() -> None:
    runs = measured("chain", ["semi_implicit_euler"], links=20).runs
    assert runs[-2].error is not None and runs[-1].error is not None
    assert runs[-2].error / runs[-1].error == pytest.approx(2, rel=0.1)


def test_all_models_have_published_sizes() -> None:
    bodies = {(model.name, subject.bodies) for model, subject in large_subjects(size="full")}
    assert {
        ("net", 29_800), ("chain", 10_000), ("chain", 100_000), ("chain", 1_076_748), ("lattice", 3630),
        ("lattice", 26_460), ("hexagonal net", 1260), ("net capture", 29_801), ("rope", 100_000),
        ("ladder", 200_001),
    } <= bodies  # fmt: skip
    parameters = {model.name: subject.parameters for model, subject in large_subjects(size="full")}
    assert parameters["tracked vehicle"] == {"shoes": 90}
    assert 2 * parameters["scissors"]["arms"] * parameters["scissors"]["units"] == 10_000


# --- what counts ---


def motion(**changes: Any) -> Motion:
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    return replace(Motion(points, points + 1, 1.0, 1.0, 10, 0.0, 1e-9, 1e-9, {}), **changes)


@pytest.mark.parametrize(
    "changes, says",
    [
        ({"end": np.full((3, 3), np.nan)}, "not finite"),
        ({"violation": 2e-3}, "violates its joints by 2e-03"),
        ({"violation": np.nan}, "violates"),
        ({"energy_error": 0.06}, "6% of the energy"),
        ({"energy_error": np.inf}, "energy"),
        ({"end": 0.8 * motion().end}, "has collapsed"),
    ],
)
def test_run_that_breaks_a_law_of_mechanics_does_not_count(changes: dict[str, Any], says: str) -> None:
    assert unsound(motion(), motion()) == ""
    assert says in unsound(motion(**changes), motion())


def test_reference_that_has_shrunk_to_a_point_is_none() -> None:
    assert unsound(motion()) == ""
    assert unsound(motion(end=motion().end[:1] + 1e-3 * motion().start)) == "has collapsed"


def test_distance_is_the_largest_of_a_body_over_the_farthest_way() -> None:
    true = motion()
    off = true.end + np.array([[0.0, 0, 0], [0, 0.3, 0.4], [0.1, 0, 0]])
    assert distance(motion(end=off), true) == pytest.approx(0.5 / np.sqrt(3))


def test_chain_that_runs_away_has_a_reason_and_no_time() -> None:
    """ABM4 is unstable at the longest step, and RK4 is not."""
    runs = {(it.method, it.step): it for it in measured("chain", ["abm4", "rk4"], links=100).runs}
    away, kept = runs["abm4", 0.04], runs["rk4", 0.04]
    assert away.cpu_seconds is None and "violates" in away.reason
    assert kept.cpu_seconds is not None and kept.reason == ""


def test_least_cost_is_the_shortest_run_that_is_right_enough_and_known_to_be() -> None:
    def of(error: float, cpu: float | None) -> LargeRun:
        return LargeRun("rk4", 0.1, 1, cpu, cpu, error, 0.0, 0.0)

    one = measured("chain", links=5)
    runs = [of(1e-2, 1.0), of(1e-3, 3.0), of(1e-5, 2.0), of(1e-9, None)]
    some = replace(one, reference_error=1e-4, runs=runs)
    assert least_cost(some, 1e-2)["rk4"].cpu_seconds == 1.0
    assert least_cost(some, 1e-3)["rk4"].cpu_seconds == 2.0
    assert least_cost(some, 1e-4) == {}  # the reference is not known so well
    assert least_cost(replace(some, reference_error=1e-12), 1e-6) == {}


def test_energy_that_is_lost_is_seen() -> None:
    """A pendulum's damper does work, which is counted; a wrong step loses energy, which is not."""
    fine = move(lw.mechanisms.chain(3), 0.5, 1e-3, "rk4")
    coarse = move(lw.mechanisms.chain(3), 0.5, 0.05, "euler")
    assert fine.energy_error < 1e-8 < 0.05 < coarse.energy_error


def test_trial_takes_steps_of_a_run_that_would_go_on() -> None:
    """What a run does at its end, such as a look for singular poses, is no part of a step."""
    trial = try_steps(lw.mechanisms.four_bar(3), 1e-3, "rk4", 3, 100.0)
    assert trial.steps == 3
    assert trial.rank["redundant"] == 9


# --- what is left out ---


def test_trial_ends_at_the_limit_but_takes_a_step() -> None:
    assert try_steps(lw.mechanisms.chain(300), 1e-3, "rk4", 50, 1e-9).steps == 1


def test_run_that_takes_longer_than_expected_ends_and_says_where() -> None:
    reason = attempt(lw.mechanisms.chain(5), 1.0, 1e-6, "rk4", limit=0.0)
    assert isinstance(reason, str) and reason.endswith("of 1000000 steps took 0 s, the limit")


def test_trial_steps_are_part_of_what_the_limit_allows(monkeypatch: pytest.MonkeyPatch) -> None:
    """They were not: a model whose first step took minutes was measured all the same."""
    spent = iter(range(0, 1000, 10))  # [s] at each look at the clock
    monkeypatch.setattr(module.time, "process_time", lambda: float(next(spent)))
    found = measured("chain", links=5, limit=9.0)
    assert found.runs == [] and any("would take about" in it for it in found.left_out)


def test_runs_that_would_take_too_long_are_left_out_and_said() -> None:
    found = measured("chain", links=50, limit=1e-6)
    assert found.runs == [] and found.reference == ""
    assert any("would take about" in it for it in found.left_out)
    assert found.cpu_seconds_per_step > 0


def test_beyond_the_largest_size_there_is_only_the_cost_of_a_step(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MOST_BODIES", 10)
    found = measured("chain", links=20)
    assert (found.runs, found.reference_error) == ([], None)
    assert found.left_out == ["beyond 10 bodies: no error, only the cost of a step"]
    assert found.cpu_seconds_per_step > 0


def test_peer_that_is_not_installed_is_left_out_and_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "missing_peers", lambda: ["mujoco", "exudyn"])
    found = measured("chain", links=10, peers=True)
    assert {it.method for it in found.runs} == {"rk4"}
    assert [it.split(":")[0] for it in found.left_out] == ["mujoco", "exudyn"]


@pytest.mark.parametrize("peer", PEERS, ids=lambda it: it.name)
def test_peers_have_the_same_motion(peer: Any) -> None:
    """Their errors against our reference fall at least by the order that they have."""
    pytest.importorskip(peer.package)
    name = "chain" if peer.only_chains else "net"
    found = measured(name, (), links=30, peers=True)
    errors = [it.error for it in found.runs if it.method == peer.name]
    assert len(errors) == 4
    last, before = errors[-1], errors[-2]
    assert last is not None and before is not None
    order = {"exudyn": 2, "mujoco": 1}[peer.package]
    assert last < 2e-2 and before / last > 0.8 * 2**order


@pytest.mark.parametrize("peer", PEERS, ids=lambda it: it.name)
def test_peers_refuse_what_they_have_no_translation_for(peer: Any) -> None:
    assert "spherical joints" in peer.refusal(lw.mechanisms.four_bar(2))
    assert "spherical joints" in peer.refusal(lw.mechanisms.capture_net(3))
    assert (peer.refusal(lw.mechanisms.net(3)) != "") == peer.only_chains


# --- the command line ---


def words(capture: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = run(["bench", "large", *arguments], debug=False)
    output = capture.readouterr()
    return code, output.out, output.err


SMALL = ["--models", "chain", "--links", "5", "--repeats", "1", "--no-peers", "--steps", "2"]


def test_json_is_one_document_with_every_run(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = words(capsys, *SMALL, "--json")
    assert (code, err) == (0, "")
    found = json.loads(out)
    assert found.keys() == {"benchmark", "machine", "models"}
    runs = found["models"][0]["runs"]
    assert {it["method"] for it in runs} == set(benchmark.LARGE_METHODS)
    assert len(runs) == 2 * len(benchmark.LARGE_METHODS) - 1  # the last is the reference


def test_table_shows_each_model_and_the_least_times(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = words(capsys, *SMALL)
    assert code == 0
    assert "chain (bodies 5, joint spherical)" in out and "Reference: dop853" in out
    assert "error 0.001" in out.split("Least CPU seconds")[1]


@pytest.mark.parametrize(
    "arguments, says",
    [
        (["--models", "nett"], "the nearest is 'net'"),
        (["--size", "ful"], "the nearest is 'full'"),
        (["--method", "rk5"], "integrator 'rk5' does not exist"),
        (["--steps", "1"], "steps 1"),
        (["--repeats", "0"], "repeats 0 is too small"),
        (["--limit", "0"], "limit 0 s"),
        (["--links", "0"], "links 0 is not a whole number of at least 1"),
        (["--models", "rope", "--links", "-3"], "links -3 is not"),
        (["--models", "lattice", "--links", "2"], "links 2: the smallest 'lattice' has"),
    ],
)
def test_mistakes_are_named(arguments: list[str], says: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = words(capsys, *arguments)
    assert (code, out) == (1, "") and says in err
