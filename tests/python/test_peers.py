"""The comparison with other packages: their mechanisms move like ours, and a difference would be noticed.

The packages are optional (pip install 'linkwork[bench]'); what is not installed is skipped.
"""

from __future__ import annotations

import importlib
import importlib.util
import sys
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import linkwork as lw
import numpy as np
import pytest
from linkwork.mechanisms.bricard import AXES, POINTS
from linkwork.mechanisms.rods import square_rod
from linkwork.rotation import from_axes

sys.path.append(str(Path(__file__).parents[1] / "benchmarks" / "peers"))

from comparison import Comparison, Row
from linkwork_peer import describe
from mechanism import GROUND, Mechanism, spanning_tree
from report import Target, table

PEERS = {"linkwork": "linkwork", "pinocchio": "pinocchio", "mujoco": "mujoco", "exudyn": "exudyn"}


def spatial_chain() -> lw.Model:
    """Bricard's rods with their hinges about all three axes, but the last one open."""
    model = lw.Model(gravity=(0, -9.81, 0))
    link = model.ground
    for start, end, axis in zip(POINTS, POINTS[1:], AXES, strict=False):
        along = from_axes(x=end - start, y=axis)
        inertia, center = square_rod(1.0, 1.0, 0.1), (start + end) / 2
        rod = model.body(mass=1.0, inertia=inertia, position=center, orientation=along)
        model.revolute(link, rod, at=start, axis=axis)
        link = rod
    return model


MODELS: dict[str, Callable[[], tuple[lw.Model, str]]] = {
    "chain": lambda: (lw.mechanisms.chain(8), "standard"),
    "spatial chain": lambda: (spatial_chain(), "standard"),
    "ladder": lambda: (lw.mechanisms.four_bar(3), "augmented_lagrangian"),
    "bricard": lambda: (lw.mechanisms.bricard(), "augmented_lagrangian"),
    "net": lambda: (lw.mechanisms.net(4), "standard"),
}


def described(name: str) -> Mechanism:
    model, formulation = MODELS[name]()
    return describe(model, name, formulation)


def deviations(peer: str, mechanism: Mechanism) -> dict[str, tuple[float, float]]:
    """(deviation, tolerance) of every operation that has one."""
    if importlib.util.find_spec(PEERS[peer]) is None:
        pytest.skip(f"{peer} is not installed")
    builders = importlib.import_module(f"{peer}_peer").OPERATIONS
    built = {name: build(mechanism) for name, build in builders.items()}
    return {
        name: (operation.deviation, operation.tolerance)
        for name, operation in built.items()
        if operation is not None and operation.deviation is not None
    }


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("peer", PEERS)
def test_every_operation_has_the_accelerations_of_linkwork(peer: str, name: str) -> None:
    found = deviations(peer, described(name))
    assert found
    assert {operation: pair for operation, pair in found.items() if not pair[0] <= pair[1]} == {}


def test_arms_with_rotors_are_timed_beside_mujoco_at_the_same_accelerations(tmp_path: Path) -> None:
    pytest.importorskip("mujoco")
    robots = importlib.import_module("robots")
    file = tmp_path / "arm.xml"
    file.write_text(robots.arm(4))
    ours, theirs = robots.compare("arm:4", file, 2, 0.001)
    assert ours.bodies == 4 and theirs.agrees and theirs.deviation > 0.0
    assert len(theirs.ratios) == 2 and min(theirs.ratios) > 0.0


@pytest.mark.parametrize("peer", PEERS)
def test_a_mass_that_is_wrong_is_noticed(peer: str) -> None:
    right = described("bricard")
    found = deviations(peer, replace(right, mass=right.mass * (1, 1, 3, 1, 1)))
    assert found
    assert {operation: pair for operation, pair in found.items() if pair[0] <= pair[1]} == {}


@pytest.mark.parametrize("name", MODELS)
def test_frames_and_points_of_a_joint_coincide(name: str) -> None:
    mechanism = described(name)
    for joint in range(mechanism.joint_count):
        (r_i, A_i), (r_j, A_j) = (mechanism.pose(int(body)) for body in mechanism.bodies[joint])
        (s_i, s_j), (C_i, C_j) = mechanism.origin[joint], mechanism.frame[joint]
        np.testing.assert_allclose(r_i + A_i @ s_i, r_j + A_j @ s_j, atol=1e-9)
        np.testing.assert_allclose(A_i @ C_i, A_j @ C_j, atol=1e-9)
        np.testing.assert_allclose(C_i.T @ C_i, np.eye(3), atol=1e-9)


@pytest.mark.parametrize("name", MODELS)
def test_spanning_tree_carries_every_body_once_and_leaves_one_joint_for_each_loop(name: str) -> None:
    mechanism = described(name)
    branches, loops = spanning_tree(mechanism)
    assert sorted(branch.body for branch in branches) == list(range(mechanism.body_count))
    assert len(loops) == mechanism.joint_count - mechanism.body_count
    assert {branch.joint for branch in branches} | set(loops) == set(range(mechanism.joint_count))
    for branch in branches:
        assert list(mechanism.bodies[branch.joint][:: 1 if branch.side else -1]) == [
            branch.parent,
            branch.body,
        ]


@pytest.mark.parametrize("name", MODELS)
def test_spanning_tree_is_depth_first(name: str) -> None:
    """A branch grows on the one before it, or on one of that one's ancestors."""
    branches, _ = spanning_tree(described(name))
    parent = {branch.body: branch.parent for branch in branches}
    assert branches[0].parent == GROUND
    for before, branch in pairwise(branches):
        ancestors = [before.body]
        while ancestors[-1] != GROUND:
            ancestors.append(parent[ancestors[-1]])
        assert branch.parent in ancestors


def test_body_without_a_way_to_the_ground_is_named() -> None:
    mechanism = described("chain")
    bodies = mechanism.bodies.copy()
    bodies[5] = 5, 6  # twice the same joint: nothing holds body 5
    with pytest.raises(ValueError, match="body 5"):
        spanning_tree(replace(mechanism, bodies=bodies))


def test_other_joints_are_refused_by_name() -> None:
    with pytest.raises(ValueError, match="revolute and spherical"):
        describe(lw.mechanisms.spatial_slider_crank(), "slider-crank")


# --- processes and tables -----------------------------------------------------------------------------------


def test_comparison_measures_in_processes_and_takes_ratios_within_rounds(tmp_path: Path) -> None:
    file = tmp_path / "chain.npz"
    described("chain").save(file)
    comparison = Comparison("chain:8", 8, file, ["linkwork"], seconds=0.002, gigabytes=8.0, limit=60)
    rows = comparison.run(2, lambda _: None)
    assert [row.operation for row in rows] == ["rhs", "semi_implicit_euler step", "rk4 step", "first step"]
    for row in rows:
        assert len(row.rounds) == 2 and row.failure == "" and row.agrees, row
        assert row.ratios == [1.0, 1.0]


FRAGILE = """
import os, time
from operation import Operation, OutOfReach

def too_much(mechanism):
    raise MemoryError

def too_long(mechanism):
    raise OutOfReach("hours")

OPERATIONS = {
    "crashes": lambda mechanism: os.abort(),
    "needs too much": too_much,
    "hangs": lambda mechanism: time.sleep(30),
    "declines": too_long,
    "has no meaning": lambda mechanism: None,
    "works": lambda mechanism: Operation(lambda seconds: 2.0, "rhs", 0.25, 0.5),
}
"""


def test_operation_that_fails_is_reported_once_and_the_others_are_measured(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "fragile_peer.py").write_text(FRAGILE)
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    file = tmp_path / "chain.npz"
    described("chain").save(file)
    rows = Comparison("chain:8", 8, file, ["fragile"], 0.01, gigabytes=8.0, limit=1).run(2, lambda _: None)
    assert {row.operation: row.failure for row in rows} == {
        "crashes": "ended with SIGABRT",
        "needs too much": "needs more than 8.0 GiB",
        "hangs": "took more than 1 s",
        "declines": "hours",
        "works": "",
    }
    assert list(rows[-1].rounds.values()) == [2.0, 2.0] and rows[-1].ratio is None


def test_process_that_cannot_begin_is_an_error_with_its_message(tmp_path: Path) -> None:
    comparison = Comparison("none", 1, tmp_path / "none.npz", ["linkwork"], 0.01, 8.0, 60)
    with pytest.raises(RuntimeError, match=r"none\.npz"):
        comparison.run(1, lambda _: None)


def row(peer: str, seconds: float, ratio: float) -> Row:
    return Row("chain:2", peer, "rhs", 2, {0: seconds}, [ratio], "rhs", deviation=0.5, tolerance=0.1)


def test_targets_are_judged_by_the_ratio() -> None:
    rows = [row("linkwork", 1e-6, 1.0), row("mujoco", 3e-6, 3.0)]
    verdicts = {limit: Target("chain:2", "mujoco", "rhs", limit).met(rows) for limit in (2.9, 3.1, None)}
    assert verdicts == {2.9: True, 3.1: False, None: None}
    assert Target("chain:2", "exudyn", "rhs", 1.0).met(rows) is None
    assert "not measured" in Target("chain:2", "exudyn", "rhs", 1.0).line(rows)


def test_table_marks_what_does_not_agree() -> None:
    lines = table([row("linkwork", 1e-6, 1.0), row("mujoco", 3e-6, 3.0)]).splitlines()
    assert lines[0] == "chain:2: 2 bodies"
    assert lines[3].split() == ["mujoco", "rhs", "3.0", "1,500", "3.00", "rhs", "once", "5e-01", "!"]
