"""Couplers and curves against closed forms, and against joints that say the same in another way."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import functions
from linkwork.arrays import Floats
from linkwork.errors import ModelError

INERTIA = (0.02, 0.03, 0.05)


def wheels(
    axes: list[tuple[float, float, float]], gravity: tuple[float, float, float] = (0.0, 0.0, 0.0)
) -> tuple[lw.Model, list[lw.Joint]]:
    """Wheels on the ground, hinged at their centers."""
    model, hinges = lw.Model(gravity), []
    for k, axis in enumerate(axes):
        place = (0.7 * k, 0.2 * k, 0.1)
        wheel = model.body(f"wheel {k}", mass=1.0 + k, inertia=INERTIA, position=place)
        hinges.append(model.revolute(model.ground, wheel, at=place, axis=axis, name=f"hinge {k}"))
    return model, hinges


def coordinate(result: lw.Result, joint: str, which: str | None = None) -> Floats:
    return result.coordinate(joint, which).value


@pytest.mark.parametrize("ratio", [-2.0, np.sqrt(7.0)])
def test_two_shafts_accelerate_as_one_and_share_the_torque(ratio: float) -> None:
    """(J_1 + r^2 J_2) a = torque, over many turns, whether the ratio is rational or not."""
    model, (first, second) = wheels([(0, 0, 1), (0, 0, 1)])
    model.coupler([(first, ratio), (second, -1.0)], name="belt")
    model.force("wheel 0", torque=(0.0, 0.0, 1.0))
    result = lw.simulate(model, t_end=5.0, step=2e-3)
    J = INERTIA[2]
    acceleration = 1.0 / (J * (1.0 + ratio**2))
    expected = 0.5 * acceleration * result.t**2
    assert expected[-1] > 8 * np.pi
    assert np.abs(coordinate(result, "hinge 0") - expected).max() < 1e-7 * expected[-1]
    assert np.abs(coordinate(result, "hinge 1") - ratio * expected).max() < 1e-7 * abs(ratio) * expected[-1]
    # what the belt exerts on the first wheel turns it back by the torque of the second
    torque = result.reaction("belt").torque[:, 2]
    assert np.abs(torque + ratio**2 * J * acceleration).max() < 1e-9


@pytest.mark.parametrize("ratio", [-2.0, np.sqrt(7.0), 0.96, 0.999, 1.02])
def test_a_run_goes_on_after_many_turns_from_a_frame_of_another(ratio: float) -> None:
    model, (first, second) = wheels([(0, 0, 1), (0, 0, 1)])
    model.coupler([(first, ratio), (second, -1.0)])
    model.force("wheel 0", torque=(0.0, 0.0, 1.0))
    whole = lw.simulate(model, t_end=6.0, step=2e-3, stabilization="projection")
    half = lw.simulate(model, t_end=3.0, step=2e-3, stabilization="projection")
    assert coordinate(half, "hinge 1")[-1] ** 2 > (4 * np.pi) ** 2
    again = lw.simulate(
        model.with_initial_state(half.q[-1], half.v[-1]), t_end=3.0, step=2e-3, stabilization="projection"
    )
    assert np.abs(again.v[-1] - whole.v[-1]).max() < 1e-5
    assert again.violation[:, 0].max() < 1e-9


def test_a_differential_turns_its_case_by_the_mean_of_its_shafts() -> None:
    """Kinetic energy with th_3 = (th_1 + th_2) / 2: two freedoms, J = [[1 + 1/4, 1/4], [1/4, 1 + 1/4]] J."""
    model, hinges = wheels([(0, 0, 1)] * 3)
    model.coupler(list(zip(hinges, [1.0, 1.0, -2.0], strict=True)))
    model.force("wheel 0", torque=(0.0, 0.0, 0.3))
    result = lw.simulate(model, t_end=2.0, step=2e-3)
    J = INERTIA[2] * np.array([[1.25, 0.25], [0.25, 1.25]])
    acceleration = np.linalg.solve(J, [0.3, 0.0])
    for hinge, a in zip(("hinge 0", "hinge 1", "hinge 2"), (*acceleration, acceleration.mean()), strict=True):
        assert np.abs(coordinate(result, hinge) - 0.5 * a * result.t**2).max() < 1e-9


def test_a_coupled_angle_and_shift_are_a_screw() -> None:
    def nut(coupled: bool) -> lw.Result:
        model = lw.Model(gravity=(0.3, 0.2, -9.81))
        body = model.body("nut", mass=1.3, inertia=INERTIA, position=(0.1, 0.2, 0.3), omega=(0.0, 0.0, 0.0))
        place: dict[str, Any] = {"at": (0.0, 0.1, 0.0), "axis": (0.2, 0.1, 1.0), "name": "joint"}
        if coupled:
            joint = model.cylindrical(model.ground, body, **place)
            model.coupler([(joint, "displacement", 1.0), (joint, "angle", -0.4 / (2 * np.pi))])
        else:
            model.screw(model.ground, body, pitch=0.4, **place)
        return lw.simulate(model, t_end=3.0, step=1e-3)

    ours, screw = nut(True), nut(False)
    assert np.abs(coordinate(screw, "joint", "angle")[-1]) > 4 * np.pi
    assert np.abs(ours.q - screw.q).max() < 1e-8
    assert np.abs(ours.v - screw.v).max() < 1e-7


def test_an_offset_over_time_drives_what_it_couples() -> None:
    motion = functions.harmonic(0.8, 3.0)

    def driven(coupled: bool) -> lw.Result:
        model, (hinge,) = wheels([(0.3, 0.0, 1.0)], gravity=(1.0, 2.0, -9.81))
        if coupled:
            model.coupler([(hinge, 2.0)], offset=functions.harmonic(1.6, 3.0), name="driver")
        else:
            model.drive(hinge, position=motion, name="driver")
        return lw.simulate(lw.assemble(model).model, t_end=2.0, step=1e-3)

    ours, driver = driven(True), driven(False)
    assert np.abs(ours.q - driver.q).max() < 1e-10
    torque = [result.reaction("driver").torque for result in (ours, driver)]
    assert np.abs(torque[0] - torque[1]).max() < 1e-8


def test_angles_of_a_cardan_joint_can_be_coupled() -> None:
    model = lw.Model()
    rod = model.body("rod", mass=1.0, inertia=INERTIA, position=(0.1, 0.0, -0.5), omega=(0.3, 0.0, 0.0))
    cross = model.universal(model.ground, rod, at=(0, 0, 0), axes=((1, 0, 0), (0, 1, 0)), name="cross")
    model.coupler([(cross, "angle_a", 1.0), (cross, "angle_b", -0.5)])
    start = lw.assemble(model).model
    result = lw.simulate(start, t_end=3.0, step=1e-3)
    a, b = coordinate(result, "cross", "angle_a"), coordinate(result, "cross", "angle_b")
    assert np.ptp(b) > 0.3
    assert np.abs(a - 0.5 * b).max() < 1e-9
    assert np.ptp(result.energy) < 1e-7


def test_a_coupler_that_says_the_same_again_is_redundant() -> None:
    model, (first, second) = wheels([(0, 0, 1), (0, 1, 1)], gravity=(1.0, 0.0, 0.0))
    for name in ("once", "again"):
        model.coupler([(first, 1.0), (second, 3.0)], name=name)
    result = lw.simulate(model, t_end=0.1, step=1e-3)
    rows = [model.compiled().describe_row(int(row)) for row in result.redundant_rows]
    assert rows in ([f"coupler '{name}', relation of joint coordinates"] for name in ("once", "again"))
    assert not result.unique_reactions[-2:].any()


@pytest.mark.parametrize(
    "formulation, stabilization",
    [
        ("standard", "sampled_baumgarte"),
        ("penalty", "sampled_baumgarte"),
        ("augmented_lagrangian", "projection"),
    ],
)
def test_every_formulation_moves_coupled_mechanisms_alike(formulation: str, stabilization: str) -> None:
    def run(formulation: str, stabilization: str) -> lw.Result:
        model, hinges = wheels([(0, 0.3, 1), (0.2, 1, 0), (1, 0, 0.4)], gravity=(1.0, 2.0, -9.0))
        for k, hinge in enumerate(hinges):
            arm = model.body(f"arm {k}", mass=0.5, inertia=INERTIA, position=(0.7 * k, 0.3, 0.2))
            model.revolute(f"wheel {k}", arm, at=(0.7 * k, 0.2 * k, 0.1), axis=(1, 1, 0), name=f"elbow {k}")
            model.coupler([(hinge, 1.0), (f"elbow {k}", -1.5)])
        model.coupler([("elbow 0", 1.0), ("elbow 1", 1.0), (hinges[2], -1.2)])
        options: dict[str, Any] = {"formulation": formulation, "stabilization": stabilization}
        return lw.simulate(model, t_end=1.0, step=1e-3, **options)

    assert (
        np.abs(run(formulation, stabilization).q[-1] - run("standard", "sampled_baumgarte").q[-1]).max()
        < 2e-6
    )


def circle(n: int, radius: float) -> Floats:
    angle = np.linspace(0.0, 2 * np.pi, n, endpoint=False)
    return radius * np.stack([np.sin(angle), 0 * angle, -np.cos(angle)], axis=1)


def test_a_bead_on_a_round_wire_is_a_pendulum_that_may_go_over_the_top() -> None:
    """th_ddot = -g/R sin th, here all around: against a rod of length R without inertia."""
    R, speed = 0.8, 7.0
    assert speed**2 > 4 * 9.81 * R

    def bead(wire: bool) -> lw.Result:
        model = lw.Model()
        body = model.body(
            "bead",
            mass=0.4,
            inertia=(1e-9,) * 3,
            position=(0, 0, -R),
            velocity=(speed, 0, 0),
            omega=(0, 0, 0),
        )
        if wire:
            model.point_on_curve(
                model.ground, body, points=circle(96, R), at=(0, 0, -R), closed=True, name="wire"
            )
        else:
            model.distance(model.ground, body, at=((0, 0, 0), (0, 0, -R)))
            model.point_on_plane(model.ground, body, at=(0, 0, -R), axis=(0, 1, 0))
        return lw.simulate(model, t_end=3.0, step=1e-3)

    on_wire, on_rod = bead(True), bead(False)
    turns = np.unwrap(np.arctan2(on_rod.q[:, 0, 0], -on_rod.q[:, 0, 2]))[-1] / (2 * np.pi)
    assert turns > 2
    assert np.abs(on_wire.q[:, 0, :3] - on_rod.q[:, 0, :3]).max() < 2e-5  # the spline's own error
    assert np.ptp(on_wire.energy) < 1e-7
    assert on_wire.violation[:, 0].max() < 1e-9


def test_the_curve_comes_near_to_what_it_goes_through_with_the_fourth_power_of_the_spacing() -> None:
    def error(n: int) -> float:
        model = lw.Model()
        body = model.body("bead", mass=0.4, inertia=INERTIA, position=(0, 0, -1), velocity=(2, 0, 0))
        model.point_on_curve(model.ground, body, points=circle(n, 1.0), at=(0, 0, -1), closed=True)
        result = lw.simulate(model, t_end=1.0, step=1e-3)
        return float(np.abs(np.linalg.norm(result.q[:, 0, :3], axis=1) - 1.0).max())

    errors = np.array([error(n) for n in (16, 32, 64)])
    assert (np.log2(errors[:-1] / errors[1:]) > 3.5).all()


def test_a_straight_curve_is_point_on_line_and_goes_on_beyond_its_ends() -> None:
    axis = np.array([0.6, 0.0, -0.8])

    def slide(curve: bool) -> lw.Result:
        model = lw.Model(gravity=(0.3, 1.0, -9.81))
        body = model.body("body", mass=1.1, inertia=INERTIA, position=(0.1, 0.1, 0.0), omega=(0.5, 1.0, 2.0))
        if curve:
            points = [-0.2 * axis, 0.1 * axis, 0.3 * axis, 0.5 * axis]
            model.point_on_curve(model.ground, body, points=points, at=(0, 0, 0))
        else:
            model.point_on_line(model.ground, body, at=(0, 0, 0), axis=axis)
        return lw.simulate(lw.assemble(model).model, t_end=1.0, step=1e-3)

    ours, line = slide(True), slide(False)
    assert np.abs(line.q[-1, 0, :3]).max() > 2.0
    assert np.abs(ours.q - line.q).max() < 1e-9


def test_a_rail_on_a_moving_body_keeps_energy_and_momentum() -> None:
    """Two free bodies, one with a curved rail in three dimensions: nothing acts from outside."""
    model = lw.Model(gravity=(0, 0, 0))
    s = np.linspace(-2.0, 2.0, 17)
    points = np.stack([s, 0.4 * np.sin(s), 0.3 * np.cos(1.3 * s)], axis=1)
    sled = model.body("sled", mass=2.0, inertia=(0.3, 0.4, 0.5), omega=(0.3, -0.2, 0.5), velocity=(0.1, 0, 0))
    bead = model.body("bead", mass=0.7, inertia=INERTIA, position=(0.1, 0.2, 0.4), velocity=(0.8, 0.3, 0.0))
    model.point_on_curve(sled, bead, points=points, at=points[8], name="rail")
    result = lw.simulate(lw.assemble(model).model, t_end=2.0, step=1e-3)
    mass = np.array([2.0, 0.7])
    momentum = np.einsum("b,kbi->ki", mass, result.v[:, :, :3])
    assert np.ptp(result.energy) < 1e-9
    assert np.abs(momentum - momentum[0]).max() < 1e-11
    assert result.violation[:, 0].max() < 1e-10


def test_a_point_is_found_on_the_curve_from_where_it_is() -> None:
    model = lw.Model()
    body = model.body("bead", mass=1.0, inertia=INERTIA, position=(0.3, 0.05, 1.02))
    model.point_on_curve(model.ground, body, points=circle(64, 1.0), at=(0.3, 0.05, 1.02), closed=True)
    found = lw.assemble(model).model
    r = found.compiled().q0[:3]
    assert np.linalg.norm(r) == pytest.approx(1.0, abs=1e-5)
    assert abs(r[1]) < 1e-9 and r[2] > 0.9


def coupled(terms: Any, **options: Any) -> None:
    model, _ = wheels([(0, 0, 1), (0, 0, 1)])
    model.cylindrical("wheel 0", "wheel 1", at=(0, 0, 0), axis=(1, 0, 0), name="both")
    model.coupler(terms, name="c", **options)


def railed(points: Any, **options: Any) -> None:
    model, _ = wheels([(0, 0, 1)])
    model.point_on_curve(model.ground, "wheel 0", points=points, at=(0, 0, 0.1), name="c", **options)


LINE = [(0, 0, 0), (1, 0, 0), (2, 0, 0)]


@pytest.mark.parametrize(
    "fault, message",
    [
        (lambda: coupled([]), "coupler 'c': its coordinates are a list of (joint, factor)"),
        (lambda: coupled([("hinge 0",)]), "('hinge 0',) is not (joint, factor)"),
        (lambda: coupled([("hinge 7", 1.0)]), "coupler 'c': no joint named 'hinge 7'"),
        (lambda: coupled([("both", 1.0)]), "angle and displacement, say which"),
        (lambda: coupled([("hinge 0", "displacement", 1.0)]), "it has angle, not 'displacement'"),
        (lambda: coupled([("hinge 0", 0.0)]), "factor 0 of 'hinge 0' must be finite and not zero"),
        (lambda: coupled([("hinge 0", float("nan"))]), "factor nan of 'hinge 0' must be finite"),
        (
            lambda: coupled([("hinge 0", 1.0), ("hinge 0", 2.0)]),
            "angle of 'hinge 0' is there twice; add the factors",
        ),
        (lambda: coupled([("hinge 0", "x")]), "factor 'x' of 'hinge 0' is not a number"),
        (lambda: coupled([("hinge 0", None)]), "factor None of 'hinge 0' is not a number"),
        (lambda: coupled([("hinge 0", 1.0)], offset=lambda t: t), "offset enters with its time derivatives"),
        (lambda: railed([(0, 0, 0)]), "point_on_curve 'c': 1 points: a curve needs 2 or more"),
        (lambda: railed(LINE[:2], closed=True), "2 points: a curve needs 3 or more"),
        (lambda: railed([*LINE, LINE[2]]), "points 2 and 3 of the curve coincide"),
        (lambda: railed([(0, 0), (1, 1)]), "points have shape (2, 2), not (k, 3)"),
        (lambda: railed([(0, 0, 0), (np.inf, 0, 0)]), "point 1 of the curve, [inf, 0.0, 0.0], is not finite"),
        (lambda: railed("rail"), "points are not made of numbers"),
        (lambda: railed([LINE[0], LINE[1], LINE[0]]), "the curve turns back after point 1"),
        (lambda: railed(LINE, frames="world"), "frames 'world' is not 'space' or 'body'"),
    ],
)
def test_a_mistake_is_named_and_leaves_the_model_as_it_was(fault: Any, message: str) -> None:
    with pytest.raises(ModelError) as found:
        fault()
    assert message in str(found.value)


@pytest.mark.parametrize("suffix", [".yaml", ".json"])
def test_special_joints_are_saved_and_loaded_to_the_last_bit(suffix: str, tmp_path: Path) -> None:
    model, (first, second) = wheels([(0, 0.3, 1), (0.2, 1, 0)], gravity=(1.0, 2.0, -9.0))
    screw = model.cylindrical("wheel 0", "wheel 1", at=(0, 0, 0), axis=(1, 0, 0), name="both")
    motion = functions.harmonic(0.1, 3.0)
    model.coupler([(first, 1.0), (second, 1 / 3), (screw, "displacement", -0.7)], offset=motion, name="c")
    rail = circle(12, 0.5)
    model.point_on_curve("wheel 0", "wheel 1", points=rail, at=rail[3], closed=True, name="rail")
    moved = model.with_initial_state(model.compiled().q0 + 0.0, np.full((2, 6), 0.1))
    moved.save(tmp_path / f"model{suffix}")
    again = lw.Model.load(tmp_path / f"model{suffix}")
    assert again.hash() == moved.hash()


def test_a_file_may_couple_a_joint_by_its_only_coordinate(tmp_path: Path) -> None:
    text = """
linkwork: 1
gravity: [0, 0, 0]
bodies:
  - {name: a, mass: 1, inertia: [0.02, 0.03, 0.05], omega: [0, 0, 1]}
  - {name: b, mass: 1, inertia: [0.02, 0.03, 0.05], omega: [0, 0, 2]}
joints:
  - {kind: revolute, name: p, a: ground, b: a, at: [0, 0, 0], axis: [0, 0, 1]}
  - {kind: revolute, name: q, a: ground, b: b, at: [0, 0, 0], axis: [0, 0, 1]}
  - {kind: coupler, name: belt, coordinates: [{joint: p, factor: 2}, {joint: q, factor: -1}]}
"""
    (tmp_path / "belt.yaml").write_text(text)
    result = lw.simulate(lw.Model.load(tmp_path / "belt.yaml"), t_end=1.0, step=1e-2)
    assert coordinate(result, "q")[-1] == pytest.approx(2.0, abs=1e-9)
    (tmp_path / "belt.yaml").write_text(text.replace("joint: q", "joint: r"))
    with pytest.raises(lw.LinkworkError, match=r"belt.yaml:10: joints\[2\].*no joint named 'r'"):
        lw.Model.load(tmp_path / "belt.yaml")


def test_eigenfrequencies_of_coupled_pendulums_are_those_of_one_freedom() -> None:
    """Pendulums with th_2 = r th_1: omega^2 = g (m_1 c_1 + r^2 m_2 c_2) / (J_1 + r^2 J_2)."""
    r, m, c, Jc = -1.7, np.array([1.2, 0.8, 0.5]), np.array([0.5, 0.3, 0.4]), np.array([0.1, 0.05, 0.02])
    model = lw.Model()
    hinges = []
    for k in range(3):
        body = model.body(f"rod {k}", mass=m[k], inertia=(Jc[k],) * 3, position=(k, 0, -c[k]))
        hinges.append(model.revolute(model.ground, body, at=(k, 0, 0), axis=(0, 1, 0)))
    model.coupler([(hinges[0], r), (hinges[1], -1.0)])
    model.coupler([(hinges[0], 2.0), (hinges[1], 1.0), (hinges[2], 1.0)])
    ratios = np.array([1.0, r, -2.0 - r])
    omega = np.sqrt(9.81 * (ratios**2 * m * c).sum() / (ratios**2 * (Jc + m * c**2)).sum())
    found = lw.linearize(model)
    assert found.frequencies == pytest.approx([omega], rel=1e-8)


def test_a_bead_at_the_bottom_of_a_bent_wire_swings_by_its_curvature() -> None:
    """omega^2 = g kappa; the curvature of the curve is felt through the constraint only."""
    x = np.linspace(-1.0, 1.0, 81)
    points = np.stack([x, 0 * x, 0.5 * 3.0 * x**2 + 0.2 * x**4], axis=1)
    model = lw.Model()
    body = model.body("bead", mass=0.3, inertia=INERTIA)
    model.point_on_curve(model.ground, body, points=points, at=(0, 0, 0))
    model.orientation(model.ground, body)
    found = lw.linearize(model)
    assert found.frequencies == pytest.approx([np.sqrt(9.81 * 3.0)], rel=1e-3)


@pytest.mark.parametrize("far", [1e160, 1e308])
def test_a_curve_whose_length_is_no_number_is_refused(far: float) -> None:
    model = lw.Model()
    bead = model.body("bead", mass=1.0, inertia=INERTIA)
    with pytest.raises(ModelError, match="points 0 and 1 of the curve are too far apart"):
        model.point_on_curve(model.ground, bead, points=[(0, 0, 0), (far, 0, 0)], at=(0, 0, 0))


def coupled_and_railed(R: Floats, shift: Floats, order: tuple[int, ...], swap: bool = False) -> lw.Model:
    """Three hinged bodies with a coupler, and a bead on a rail of one; turned by R, shifted, renumbered."""

    def place(*x: float) -> Floats:
        return R @ np.array(x) + shift

    model = lw.Model(gravity=R @ np.array([0.3, -0.4, -9.0]))
    places = [(0.2, 0.1, 0.0), (0.9, 0.3, 0.2), (1.4, -0.2, 0.5), (0.9, 0.1, 0.6)]
    turn = lw.rotation.from_matrix(R)
    for k in order:
        motion = {"velocity": R @ np.array([0.1 * k, 0.2, -0.1]), "omega": (0.3, -0.2 * k, 0.4)}
        moments = np.array(INERTIA) * (k + 1)
        model.body(
            str(k), mass=1.0 + k, inertia=moments, position=place(*places[k]), orientation=turn, **motion
        )
    x, y, z = R.T
    hinges = [
        model.revolute("ground", "0", at=place(0, 0, 0), axis=z + 0.3 * x),
        model.revolute("0", "1", at=place(0.5, 0.2, 0), axis=y),
        model.cylindrical("1", "2", at=place(1.2, 0, 0.3), axis=x - 0.2 * y),
    ]
    terms = [(hinges[0], 0.7), (hinges[1], -1.3), (hinges[2], "angle", 0.4), (hinges[2], "displacement", 2.0)]
    model.coupler(terms[::-1] if swap else terms, name="coupler")
    s = np.linspace(-1.0, 1.0, 9)
    rail = [place(0.9 + t, 0.1 + 0.3 * np.sin(t), 0.6 + 0.2 * t**2) for t in s]
    model.point_on_curve("1", "3", points=rail, at=place(*places[3]), name="rail")
    return model


def motion(model: lw.Model) -> tuple[dict[str, Floats], dict[str, Floats]]:
    """v_dot of each body (6,) at a consistent state, and multipliers of the special joints."""
    model = lw.assemble(model).model  # off the curve, its two equations are a matter of choice
    system, core = lw.System(model), model.compiled()
    v_dot, multipliers = system.compiled().accelerations(0.0, core.q0, core.v0)
    rows = core.joint_rows
    joints = {name: core.find_joint(name) for name in ("coupler", "rail")}
    return (
        {core.body_name(k): x for k, x in enumerate(v_dot.reshape(-1, 6))},
        {name: multipliers[rows[k] : rows[k + 1]] for name, k in joints.items()},
    )


@pytest.mark.parametrize("swap", [False, True])
def test_special_joints_do_not_care_where_they_are_nor_for_numbers(swap: bool) -> None:
    R = lw.rotation.matrix(np.array([0.5, -0.1, 0.7, 0.5]) / np.linalg.norm([0.5, -0.1, 0.7, 0.5]))
    v_dot, forces = motion(coupled_and_railed(np.eye(3), np.zeros(3), (0, 1, 2, 3)))
    other, other_forces = motion(coupled_and_railed(R, np.array([3.0, -20.0, 7.0]), (2, 3, 0, 1), swap))
    scale = max(np.abs(x).max() for x in v_dot.values())
    for name, x in v_dot.items():
        assert np.abs(R @ x[:3] - other[name][:3]).max() < 1e-8 * scale
        assert np.abs(x[3:] - other[name][3:]).max() < 1e-8 * scale
    assert forces["coupler"] == pytest.approx(other_forces["coupler"], rel=1e-7)
    assert np.linalg.norm(forces["rail"]) == pytest.approx(np.linalg.norm(other_forces["rail"]), rel=1e-7)


def test_a_coupler_takes_one_freedom_and_a_curve_two() -> None:
    model = coupled_and_railed(np.eye(3), np.zeros(3), (0, 1, 2, 3))
    rank = lw.System(model).compiled().rank()
    hinged = 6 * 3 - 5 - 5 - 4
    assert rank.degrees_of_freedom == hinged - 1 + 6 - 2
    assert not rank.redundant_rows


def test_special_joints_do_no_work() -> None:
    model = lw.assemble(coupled_and_railed(np.eye(3), np.zeros(3), (0, 1, 2, 3))).model
    result = lw.simulate(model, t_end=1.0, step=1e-3)
    assert np.ptp(result.energy) < 1e-7 * np.abs(result.energy).max()
    assert result.violation[:, 0].max() < 1e-8


@pytest.mark.parametrize("kind", ["coupler", "point_on_curve"])
def test_special_joints_in_bulk_are_refused_with_the_way_to_add_them(kind: str) -> None:
    model, _ = wheels([(0, 0, 1), (0, 0, 1)])
    with pytest.raises(lw.OptionError, match=f"one by one, by linkwork.Model.{kind}"):
        model.joints(kind, "wheel 0", "wheel 1")


@pytest.mark.parametrize("grounded", [True, False])
def test_the_reaction_of_a_coupler_is_that_on_the_second_body_of_its_first_joint(grounded: bool) -> None:
    """On the ground its torque is the multiplier times the factor, whatever else the arm has to do with."""
    model = lw.Model()
    arm = model.body("arm", mass=1.0, inertia=INERTIA, position=(0.4, 0, 0))
    wheel = model.body("wheel", mass=0.5, inertia=INERTIA, position=(0.8, 0, 0))
    ends = (arm, model.ground) if grounded else (model.ground, arm)
    first = model.revolute(*ends, at=(0, 0, 0), axis=(0, 1, 0))
    second = model.revolute(arm, wheel, at=(0.8, 0, 0), axis=(0, 1, 0))
    model.coupler([(first, 0.7), (second, 2.0)], name="coupler")
    result = lw.simulate(model, t_end=0.5, step=1e-3)
    multiplier = result.multipliers[:, -1]
    expected = 0.7 * multiplier if grounded else (0.7 - 2.0) * multiplier  # on the arm both terms act
    reaction = result.reaction("coupler")
    assert np.abs(multiplier).max() > 0.1
    assert np.abs(reaction.torque - expected[:, None] * [0, 1, 0]).max() < 1e-10
    assert np.abs(reaction.force).max() < 1e-12


@pytest.mark.parametrize("length", [1.0, 1e-3, 1e-6, 1e-9])
def test_a_link_with_two_hinges_may_be_of_any_length(length: float) -> None:
    """A rod that hangs on it: a double pendulum, whose first link has no mass."""
    model = lw.Model(gravity=(0, 0, -9.81 * length))
    rod = model.body("rod", mass=2.0, inertia=(1e-3 * length**2, length**2 / 6, length**2 / 6),
                     position=(1.5 * length, 0, 0))  # fmt: skip
    model.revolute_revolute(model.ground, rod, at=[(0, 0, 0), (length, 0, 0)], axis=(0, 1, 0), name="link")
    v_dot, _ = lw.System(model).accelerations(0.0, model.compiled().q0, model.compiled().v0)
    fall = [0, 0, -9.81 * length, 0, 0, 0]  # nothing holds it but a link that points along it
    np.testing.assert_allclose(v_dot, fall, atol=1e-9 * length)


@pytest.mark.parametrize("offset", [1.0, 2 * np.pi, -20 * np.pi])
def test_an_offset_that_is_not_met_where_joints_are_made_is_refused(offset: float) -> None:
    """Whole turns, too: nothing has turned yet."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("disc", mass=1.0, inertia=INERTIA)
    model.body("slider", mass=1.0, inertia=INERTIA, position=(0, 1, 0))
    model.revolute("ground", "disc", at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    model.translational("ground", "slider", at=(0, 1, 0), axis=(1, 0, 0), name="slide")
    model.coupler([("pin", 1.0), ("slide", 10.0)], offset=offset, name="coupler")
    with pytest.raises(lw.ModelError, match="do not satisfy 1 joint"):
        lw.simulate(model, t_end=0.1, step=1e-3)


@pytest.mark.parametrize(
    ("offset", "holds"), [(0.0, True), (4 * np.pi, True), (-2 * np.pi, True), (1.0, False)]
)
def test_joints_at_angles_may_have_made_whole_turns_before(offset: float, holds: bool) -> None:
    """Which coordinates of the result are without: they begin within half a turn."""
    model = lw.Model(gravity=(0, 0, 0))
    for name, angle in (("first", 1.0), ("second", 0.5)):
        turned = lw.rotation.about((0, 0, 1), angle)
        model.body(name, mass=1.0, inertia=INERTIA, orientation=turned)
        pin = {"at": 2 * [(0, 0, 0)], "axis": 2 * [(0, 0, 1)], "x_axis": 2 * [(1, 0, 0)], "frames": "body"}
        model.revolute("ground", name, **pin, name=f"{name} pin")
    model.coupler([("first pin", 1.0), ("second pin", -2.0)], offset=offset, name="coupler")
    model.force("first", torque=(0, 0, 1.0))
    if not holds:
        with pytest.raises(lw.ModelError, match="do not satisfy 1 joint"):
            lw.simulate(model, t_end=0.1, step=1e-3)
        return
    result = lw.simulate(model, t_end=0.1, step=1e-3)
    first, second = (coordinate(result, f"{name} pin") for name in ("first", "second"))
    assert (first[0], second[0]) == pytest.approx((1.0, 0.5), abs=1e-12)
    assert first - 2.0 * second == pytest.approx(np.zeros(len(first)), abs=1e-9)
    assert result.violation[:, 0].max() < 1e-9


@pytest.mark.parametrize("kind", ["fixed", "revolute"])
def test_frames_that_are_turned_by_half_a_turn_are_told(kind: str) -> None:
    """The equations of joints say that axes are perpendicular: they hold for opposite ones as well."""
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("body", mass=1.0, inertia=INERTIA, orientation=(0, 1, 0, 0))
    place: dict[str, Any] = {"at": ((0, 0, 0), (0, 0, 0)), "frames": "body", "name": "joint"}
    if kind == "fixed":
        model.fixed("ground", body, orientation=((1, 0, 0, 0), (1, 0, 0, 0)), **place)
    else:
        model.revolute("ground", body, axis=((0, 0, 1), (0, 0, 1)), **place)
    with pytest.warns(lw.LinkworkWarning, match="axes of 'joint' point in opposite directions"):
        lw.simulate(model, t_end=0.1, step=1e-2)
    with pytest.warns(lw.LinkworkWarning, match="axes of 'joint' point in opposite directions"):
        lw.simulate_many(model, {"body.mass": [1.0, 2.0]}, 0.1, step=1e-2)
    with pytest.warns(lw.LinkworkWarning, match="axes of 'joint' point in opposite directions"):
        lw.sweep(model, {"body.mass": [1.0, 2.0]}, outputs=["final"], t_end=0.1, step=1e-2, processes=1)
    if kind == "fixed":  # without freedoms
        with pytest.warns(lw.LinkworkWarning, match="axes of 'joint' point in opposite directions"):
            lw.kinematics(model, [0.0, 0.1])
