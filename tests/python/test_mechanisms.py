"""The example mechanisms: each starts on its constraints, and has the freedom it should have."""

from __future__ import annotations

import sys
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import _core
from linkwork.arrays import PIECE, Floats
from linkwork.mechanisms import MECHANISMS, Mechanism
from linkwork.running.checks import joint_residuals


def dynamics(model: lw.Model) -> _core.Dynamics:
    return lw.System(model, formulation="penalty").compiled()


def dense_D(model: lw.Model) -> Floats:
    """The constraint matrix (m, 6n) at the initial pose."""
    core = model.compiled()
    sparse = dynamics(model).evaluate(0.0, core.q0, core.v0)["D"]
    D = np.zeros((model.row_count, 6 * model.body_count))
    rows = np.repeat(np.arange(model.row_count), np.diff(sparse["indptr"]))
    D[rows, sparse["indices"]] = sparse["data"]
    return D


@pytest.mark.parametrize("mechanism", MECHANISMS.values(), ids=MECHANISMS)
def test_a_mechanism_starts_on_its_constraints(mechanism: Mechanism) -> None:
    model = mechanism.function()
    position, velocity = joint_residuals(model, dynamics(model))
    assert position.max(initial=0) < 1e-12
    assert velocity.max(initial=0) < 1e-12


#: Relative energy error where it is not 1e-8: contacts begin within steps.
ENERGY = {"tracked_chain": 2e-6, "tracked_vehicle": 2e-6, "capture_net": 2e-6}


@pytest.mark.parametrize("mechanism", MECHANISMS.values(), ids=MECHANISMS)
def test_a_mechanism_runs_with_its_own_settings(mechanism: Mechanism) -> None:
    result = lw.simulate(mechanism.function(), **{**mechanism.settings, "t_end": 0.05})
    scale = max(1.0, float(np.abs(result.kinetic_energy).max()))
    assert np.abs(result.energy_error).max() < ENERGY.get(mechanism.name, 1e-8) * scale
    assert result.violation[:, 0].max() < 1e-8


@pytest.mark.parametrize("mechanism", MECHANISMS.values(), ids=MECHANISMS)
def test_a_mechanism_and_its_parameters_are_described(mechanism: Mechanism) -> None:
    assert mechanism.description.endswith(".")
    assert [parameter.name for parameter in mechanism.parameters if not parameter.description] == []


#: (degrees of freedom, redundant equations) at the initial pose
FREEDOM: dict[str, tuple[dict[str, Any], int, int]] = {
    "pendulum": ({}, 5, 0),
    "rod_pendulum": ({}, 1, 0),
    "chain": ({"bodies": 4}, 4, 0),
    "binary_tree": ({"bodies": 7, "joint": "spherical"}, 21, 0),
    "hub": ({"arms": 5}, 1 + 3 * 5, 0),
    "heavy_top": ({}, 3, 0),
    "torque_free_top": ({}, 6, 0),
    "four_bar": ({"n": 2}, 1, 6),
    "andrews": ({}, 1, 9),
    "bricard": ({}, 1, 1),
    "flyball_governor": ({}, 4, 0),
    "spatial_slider_crank": ({}, 1, 0),
    "net": ({"n": 4}, 36, 0),
    "bennett": ({}, 1, 3),  # where Gruebler counts 6 * 3 - 5 * 4 = -2
    "gyroscope": ({}, 3, 0),
    "planetary_gear": ({"planets": 3}, 2, 2),  # each further planet closes a loop
    "rolling_disc": ({}, 3, 0),
    "tracked_chain": ({"shoes": 60}, 60 + 3 + 2, 3),  # shoes; wheels and slide; rollers
    "double_wishbone": ({}, 3, 0),
    "stewart_platform": ({}, 0, 0),
    "delta_robot": ({}, 0, 0),
    "watt_six_bar": ({}, 1, 6),
    "stephenson_six_bar": ({"mode": 3}, 1, 6),
    "strandbeest_leg": ({}, 0, 9),
    "hub_net": ({"n": 4}, 6 * (16 + 24) - 12 * 12 - 12, 0),  # knots and rods; their ends; the corners
    "hexagonal_net": ({"rings": 3}, 6 * 72 - 3 * (2 * 72 - 37) - 9, 0),  # rods; ends less nodes; corners
    "capture_net": ({"n": 5}, 6 * (25 + 40 + 1) - 12 * 20, 0),  # a ball, too; nothing holds them
    "lattice": ({"n": 2}, 6 * 54 - 3 * (2 * 54 - 27) - 6, 0),
    "rope": ({"links": 12}, 3 * 12, 0),
    "scissors": ({"arms": 3, "units": 4}, 3 + 1, 0),  # each arm one, however long; the hub
    "tracked_vehicle": ({"shoes": 60}, 6 + 2 * (60 + 3 + 7), 6),  # hull; shoes, wheels and slide, rollers
}


@pytest.mark.parametrize("name", MECHANISMS)
def test_the_freedom_of_a_mechanism_is_known(name: str) -> None:
    arguments, freedom, redundant = FREEDOM[name]
    D = dense_D(MECHANISMS[name].function(**arguments))
    rank = int(np.linalg.matrix_rank(D, tol=1e-9)) if D.size else 0
    assert (D.shape[1] - rank, D.shape[0] - rank) == (freedom, redundant)


@pytest.mark.parametrize("n", [3, 4, 5, 6])
def test_a_net_has_full_rank_by_a_wide_margin(n: int) -> None:
    singular_values = np.linalg.svd(dense_D(lw.mechanisms.net(n)), compute_uv=False)
    assert singular_values[-1] > 0.03 * singular_values[0]


@pytest.mark.parametrize("n", [3, 7])
def test_the_rods_of_a_net_are_a_meter_long(n: int) -> None:
    """Each node is met by ends of rods, half a meter from their centers."""
    model = lw.mechanisms.net(n)
    joints = model.compiled().joint_arrays()
    arms = np.linalg.norm(joints["origin"], axis=2)[joints["bodies"] >= 0]
    assert (model.body_count, np.abs(arms - 0.5).max()) == (2 * n * (n - 1), pytest.approx(0, abs=1e-14))


@pytest.mark.parametrize("arms", [3, 4, 5, 12, 13])
def test_each_loop_of_a_hub_takes_one_freedom(arms: int) -> None:
    D = dense_D(lw.mechanisms.hub(arms, loops=True))
    singular_values = np.linalg.svd(D, compute_uv=False)
    assert D.shape[1] - D.shape[0] == 1 + 2 * arms
    assert singular_values[-1] > 0.5 / arms * singular_values[0]


def test_a_hub_keeps_its_angular_momentum_about_the_axle_while_its_arms_rise() -> None:
    model = lw.mechanisms.hub(5)
    result = lw.simulate(model, t_end=0.5, step=1e-3)
    mass, inertia = model.compiled().mass, model.compiled().inertia
    spin = np.einsum("kbij,bjl,kbl->kbi", lw.rotation.matrix(result.orientation), inertia, result.omega)
    momentum = (mass[:, None] * np.cross(result.position, result.velocity) + spin).sum(axis=1)[:, 2]
    assert momentum == pytest.approx(np.full(len(result), momentum[0]), rel=1e-9)
    assert result.body("arm[0]").position[-1, 2] > result.body("arm[0]").position[0, 2] + 0.01


def test_the_left_and_the_right_half_of_a_binary_tree_fall_alike() -> None:
    result = lw.simulate(lw.mechanisms.binary_tree(7, "spherical"), t_end=0.5, step=1e-3)
    mirrored = [0, 2, 1, 6, 5, 4, 3]
    assert result.position == pytest.approx(result.position[:, mirrored] * (1, -1, 1), abs=1e-9)
    assert result.position[-1, :, 2].max() < -0.1


@pytest.mark.parametrize("name", [name for name, mechanism in MECHANISMS.items() if mechanism.size])
@pytest.mark.parametrize("bodies", [24, 25, 100])
def test_the_size_of_a_mechanism_is_the_largest_with_no_more_bodies(name: str, bodies: int) -> None:
    mechanism = MECHANISMS[name]
    assert mechanism.size
    value = mechanism.size.value_for(bodies)
    counts = [mechanism.function(**{mechanism.size.parameter: v}).body_count for v in (value, value + 1)]
    assert counts[0] == mechanism.size.bodies(value)
    assert counts[0] <= bodies < counts[1]


def test_a_large_net_is_built_at_once() -> None:
    assert lw.mechanisms.net(100).body_count == 19800


def python_calls(name: str, bodies: int) -> int:
    """How many functions are called in building a mechanism."""
    mechanism = MECHANISMS[name]
    assert mechanism.size
    value, calls = mechanism.size.value_for(bodies), 0

    def count(*_: Any) -> None:
        nonlocal calls
        calls += 1

    sys.setprofile(count)
    try:
        mechanism.function(**{mechanism.size.parameter: value})
    finally:
        sys.setprofile(None)
    return calls


@pytest.mark.parametrize(
    "name",
    ["chain", "binary_tree", "hub", "net", "hub_net", "capture_net", "lattice", "rope", "scissors"],
)
def test_building_a_mechanism_takes_no_more_calls_for_more_bodies(name: str) -> None:
    """But for the levels of the tree, one in every doubling, and for each further piece of large arrays."""
    assert PIECE > 2 * 1600
    python_calls(name, 100)
    few, many = python_calls(name, 100), python_calls(name, 1600)
    assert many - few < 20 * np.log2(1600 / 100)


@pytest.mark.parametrize("joint", ["revolute", "spherical"])
def test_each_joint_of_a_binary_tree_leaves_its_freedom(joint: str) -> None:
    D = dense_D(lw.mechanisms.binary_tree(10, joint))
    assert D.shape[1] - np.linalg.matrix_rank(D, tol=1e-9) == 10 * {"revolute": 1, "spherical": 3}[joint]


@pytest.mark.parametrize("joint", ["revolute", "spherical", "universal"])
def test_a_chain_can_have_several_joints(joint: str) -> None:
    model = lw.mechanisms.chain(bodies=3, joint=joint)
    assert {model.compiled().joint_kind(k) for k in range(3)} == {joint}


@pytest.mark.parametrize(
    ("name", "arguments", "fragments"),
    [
        ("chain", {"bodies": 0}, ["bodies 0"]),
        ("chain", {"joint": "sperical"}, ["'sperical'", "'spherical'"]),
        ("binary_tree", {"bodies": 0}, ["bodies 0"]),
        ("binary_tree", {"joint": "univresal"}, ["'univresal'", "'revolute'"]),
        ("hub", {"arms": 0}, ["arms 0"]),
        ("hub", {"arms": 2, "loops": True}, ["arms 2", "3"]),
        ("four_bar", {"n": 0}, ["n 0"]),
        ("watt_six_bar", {"mode": 5}, ["mode 5", "1 to 4"]),
        ("gyroscope", {"spin": 10.0}, ["10 rad/s", "too slow"]),
        ("gyroscope", {"tilt": 3.0}, ["tilt 3", "2.8"]),
        ("planetary_gear", {"planets": 5}, ["5 planets", "30", "78"]),
        ("rolling_disc", {"tilt": 1.5}, ["tilt 1.5", "1.3"]),
        ("tracked_chain", {"shoes": 41}, ["shoes 41", "even", "40"]),
        ("net", {"n": 2}, ["n 2", "3"]),
        ("hub_net", {"n": 2}, ["n 2", "3"]),
        ("capture_net", {"n": 2}, ["n 2", "3"]),
        ("hexagonal_net", {"rings": 0}, ["rings 0", "1"]),
        ("lattice", {"n": 0}, ["n 0", "1"]),
        ("rope", {"links": 11}, ["links 11", "12"]),
        ("scissors", {"arms": 0}, ["arms 0"]),
        ("scissors", {"units": 1}, ["units 1", "2"]),
        ("tracked_vehicle", {"shoes": 59}, ["shoes 59", "even", "60"]),
    ],
)
def test_a_parameter_that_makes_no_mechanism_is_refused(
    name: str, arguments: dict[str, Any], fragments: list[str]
) -> None:
    with pytest.raises(lw.LinkworkError) as caught:
        MECHANISMS[name].function(**arguments)
    assert [fragment for fragment in fragments if fragment not in str(caught.value)] == []


def test_the_slider_crank_turns_all_the_way_round() -> None:
    result = lw.simulate(lw.mechanisms.spatial_slider_crank(), t_end=2.0, step=1e-3)
    speed = result.body("crank").omega_inertial[:, 0]
    assert speed.min() > 0
    assert np.mean(speed) * result.t[-1] > 4 * np.pi


def test_the_slider_crank_keeps_the_axes_of_its_universal_joint_far_from_parallel() -> None:
    result = lw.simulate(lw.mechanisms.spatial_slider_crank(), t_end=2.0, step=1e-3)
    along = lw.rotation.matrix(result.body("coupler").orientation)[:, :, 0]
    assert np.abs(along[:, 1]).max() < 0.7


@pytest.mark.parametrize("formulation", ("standard", "augmented_lagrangian"))
def test_a_row_of_two_four_bars_passes_its_singular_poses(formulation: str) -> None:
    """Every quarter turn. On a wrong branch the tops, level at the start, would not stay so."""
    model = lw.mechanisms.four_bar(2)
    settings = {**MECHANISMS["four_bar"].settings, "t_end": 2.0}
    result = lw.simulate(model, **settings, formulation=formulation)
    heights = [2 * result.body(f"post {i}").position[:, 1] for i in range(3)]
    assert np.abs(result.energy_error).max() < 1e-8
    assert min(heights[0]) < -0.99
    assert np.ptp(heights, axis=0).max() < 1e-8
