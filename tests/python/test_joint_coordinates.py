"""Free coordinates of joints, and drives that prescribe them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest


def rotor(kind: str = "revolute", **state: object) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("rotor", mass=2.0, inertia=(0.3, 0.3, 0.4), **state)
    place = {"pitch": 0.5} if kind == "screw" else {}
    getattr(model, kind)(model.ground, body, at=(0, 0, 0), axis=(0, 0, 1), name="joint", **place)
    return model


def run(model: lw.Model, t_end: float = 2.0, **options: object) -> lw.Result:
    return lw.simulate(model, t_end, 1e-3, progress=False, **options)


def test_an_angle_goes_on_over_full_turns_however_few_frames_there_are() -> None:
    """Between two frames the rotor turns 3.2 times."""
    result = run(rotor(omega=(0, 0, -20.0)), record_every=1000)
    angle = result.coordinate("joint")
    assert angle.value == pytest.approx(-20.0 * result.t, abs=1e-8)
    assert angle.rate == pytest.approx(np.full(len(result), -20.0), abs=1e-9)


def test_frames_that_are_in_step_with_a_swing_have_no_turns() -> None:
    """At full speed in all of them: that it goes round, or to and fro, looks the same. The run knows."""
    model = rotor(omega=(0, 0, 2 * np.pi))
    J = float(model.compiled().inertia[0][2, 2])
    model.rotational_spring_damper("ground", "rotor", axis=(0, 0, 1), stiffness=J * 4 * np.pi**2)
    result = run(model, t_end=4.0, record_every=1000)
    assert result.coordinate("joint").value == pytest.approx(np.zeros(5), abs=1e-8)


def spun_up() -> lw.Model:
    """A rotor that is at rest at whole seconds, 3 turns further on each: omega = 6 pi (1 - cos 2 pi t)."""
    model = rotor()
    model.force("rotor", torque=(0, 0, lw.functions.harmonic(0.4 * 12 * np.pi**2, 2 * np.pi)), name="torque")
    return model


@pytest.mark.parametrize(
    "how", [{"step": 1e-3, "record_every": 1000}, {"rtol": 1e-8, "times": [0.0, 1.0, 2.0, 3.0]}]
)
def test_turns_from_rest_to_rest_between_frames_are_counted(how: dict[str, Any], tmp_path: Path) -> None:
    """Nothing in the frames shows them: as of one by itself, of lanes, of a file, of outputs."""
    exact = pytest.approx(6 * np.pi * np.arange(4), rel=1e-6, abs=1e-6)
    result = lw.simulate(spun_up(), 3.0, **how)
    assert result.coordinate("joint").value == exact
    result.save(tmp_path / "run.h5")
    assert lw.Result.load(tmp_path / "run.h5").coordinate("joint").value == exact
    if "step" in how:
        many = lw.simulate_many(spun_up(), {"rotor.mass": [1.0, 2.0]}, 3.0, **how)
        assert many.manifest["lanes"] == 2
        assert many.member(1).coordinate("joint").value == exact
        final = lw.simulate_many(
            spun_up(), {"rotor.mass": [1.0]}, 3.0, outputs=["coordinate('joint').value.final"], **how
        )
        assert next(iter(final.outputs.values())) == pytest.approx([18 * np.pi], rel=1e-6)


@pytest.mark.filterwarnings("ignore:kinematics. the work")
@pytest.mark.parametrize("direction", [1, -1])
def test_a_driven_turn_between_two_frames_is_counted(direction: int) -> None:
    """By the run and by kinematics, at times from rest to rest, and amid a turn."""
    model = rotor()
    model.drive("joint", position=lw.functions.cycloidal(direction * 2 * np.pi, 1.0))
    for times, turned in (([0.0, 1.0], [0.0, 1.0]), ([0.0, 0.5, 1.0, 2.0], [0.0, 0.5, 1.0, 1.0])):
        exact = pytest.approx(2 * np.pi * direction * np.array(turned), abs=1e-6)
        assert lw.simulate(model, times[-1], rtol=1e-8, times=times).coordinate("joint").value == exact
        assert lw.kinematics(model, times).coordinate("joint").value == exact


@pytest.mark.filterwarnings("ignore:kinematics. the work")
@pytest.mark.parametrize("turns", [2, -3, 1.3])
def test_rest_before_and_after_turns_counts_for_nothing(turns: float) -> None:
    """Two frames 10 s apart, and a hinge that turns for one of these."""
    model, total = rotor(), 2 * np.pi * turns
    pieces = [[0.0] * 6, [0.0, 0.0, 0.0, 10 * total, -15 * total, 6 * total], [total] + 5 * [0.0]]
    model.drive("joint", position=lw.functions.piecewise_polynomial([0, 4, 5, 10], pieces))
    exact = pytest.approx([0.0, total], abs=1e-4)
    assert run(model, t_end=10.0, record_every=10000).coordinate("joint").value == exact
    assert lw.simulate(model, 10.0, rtol=1e-6, times=[0, 10]).coordinate("joint").value == exact
    assert lw.kinematics(model, [0, 10]).coordinate("joint").value == exact
    many = lw.simulate_many(model, {"rotor.mass": [1.0, 2.0]}, 10.0, step=2e-3, record_every=5000)
    assert many.manifest["lanes"] == 2
    assert many.member(0).coordinate("joint").value == exact


def test_a_rotor_that_is_pushed_after_a_long_rest_turns_by_what_the_push_does() -> None:
    """50 rad/s^2 for 0.2 s, and back to rest: 2 rad."""
    model = rotor()
    torque = lw.functions.piecewise_polynomial([0, 5, 5.2, 5.4, 9], [[0.0], [20.0], [-20.0], [0.0]])
    model.rotational_spring_damper("ground", "rotor", axis=(0, 0, 1), torque=torque)
    result = run(model, t_end=6.0, record_every=6000, on_inaccurate="pass")
    assert result.coordinate("joint").value == pytest.approx([0.0, 2.0], abs=1e-9)


@pytest.mark.filterwarnings("ignore:kinematics. the work")
@pytest.mark.parametrize("times", [[0, 2], [0, 0.5, 1.5], [0, 1, 2], [0, 0.5, 1]])
def test_kinematics_counts_turns_past_breaks_of_drivers(times: list[float]) -> None:
    """Between two of the times, too, where it has frames of its own."""
    model = rotor()
    model.drive("joint", position=lw.functions.cycloidal(6 * np.pi, 1.0))
    exact = 6 * np.pi * np.minimum(times, 1.0)  # as at half and whole seconds
    assert lw.kinematics(model, times).coordinate("joint").value == pytest.approx(exact, abs=1e-9)


@pytest.mark.filterwarnings("ignore:kinematics. the work")
def test_kinematics_takes_no_step_from_rest_to_a_whole_turn_on() -> None:
    """Where nothing tells when a driver of the user's own begins: at 1.5 s it is once round, at speed."""
    law = np.polynomial.Polynomial([0, 0, 0, 40 * np.pi, -60 * np.pi, 24 * np.pi])
    laws = [law.deriv(k) if k else law for k in range(3)]
    model = rotor()
    model.rotational_spring_damper("ground", "rotor", axis=(0, 0, 1), stiffness=1.0, name="spring")
    model.drive("joint", position=tuple(lambda t, f=f: f(min(max(t - 1.0, 0.0), 1.0)) for f in laws))
    motion = lw.kinematics(model, [0, 3])
    assert motion.coordinate("joint").value == pytest.approx([0.0, 4 * np.pi], abs=1e-9)
    assert motion.force("spring").torque[-1, 2] == pytest.approx(-4 * np.pi, abs=1e-9)


def test_turns_that_neither_frames_nor_steps_tell_are_a_warning() -> None:
    result = run(spun_up(), t_end=1.0, record_every=1000)
    assert result.coordinate("joint").value[-1] == pytest.approx(6 * np.pi, abs=1e-6)
    result._statistics["turned"][0][-1] = None
    with pytest.warns(lw.LinkworkWarning, match="angle of 'joint': frames are too far apart"):
        result.coordinate("joint")


def test_a_cylindrical_joint_has_two_coordinates() -> None:
    result = run(rotor("cylindrical", omega=(0, 0, 3.0), velocity=(0, 0, 0.2)))
    assert result.coordinate("joint", "angle").value == pytest.approx(3.0 * result.t, abs=1e-9)
    assert result.coordinate("joint", "displacement").value == pytest.approx(0.2 * result.t, abs=1e-9)
    with pytest.raises(lw.ModelError, match="angle and displacement, say which"):
        result.coordinate("joint")


@pytest.mark.parametrize("joint", ("bearing", "guide"))
def test_rates_are_the_derivatives_of_coordinates(joint: str) -> None:
    """On moving bodies: central differences of the coordinate."""
    result = lw.simulate(lw.mechanisms.spatial_slider_crank(), 0.5, 1e-4, record_every=1, progress=False)
    value, rate = result.coordinate(joint)
    measured = (value[2:] - value[:-2]) / (result.t[2:] - result.t[:-2])
    assert np.abs(measured - rate[1:-1]).max() < 1e-4 * np.abs(rate).max()


def test_angles_of_a_cardan_joint_compose_its_rotation() -> None:
    model = lw.Model()
    body = model.body(
        "body", mass=1.0, inertia=(0.1, 0.2, 0.25), position=(0.1, 0.2, -0.5), omega=(0.3, 0.2, 0)
    )
    model.universal(model.ground, body, at=(0, 0, 0), axes=((0, 1, 0), (1, 0, 0)), name="cross")
    model = lw.assemble(model).model
    result = run(model)
    a, b = (result.coordinate("cross", which) for which in ("angle_a", "angle_b"))
    composed = lw.rotation.matrix(lw.rotation.about((0, 1, 0), a.value)) @ lw.rotation.matrix(
        lw.rotation.about((1, 0, 0), b.value)
    )
    start = lw.rotation.matrix(result.q[0, 0, 3:])
    assert np.abs(composed - lw.rotation.matrix(result.q[:, 0, 3:]) @ start.T).max() < 1e-8
    for coordinate in (a, b):
        assert np.gradient(coordinate.value, result.t)[5:-5] == pytest.approx(coordinate.rate[5:-5], abs=1e-3)


def test_a_coordinate_is_the_same_in_a_file(tmp_path: object) -> None:
    result = run(rotor("screw", omega=(0, 0, 3.0), velocity=(0, 0, 1.5 / (2 * np.pi))))
    result.save(f"{tmp_path}/run.h5")
    for which in ("angle", "displacement"):
        loaded = lw.Result.load(f"{tmp_path}/run.h5").coordinate("joint", which)
        assert np.array_equal(loaded.value, result.coordinate("joint", which).value)


@pytest.mark.parametrize(
    ("motion", "expected"),
    (
        ({"position": lw.functions.harmonic(0.5, 3.0)}, lambda t: 0.5 * np.sin(3 * t)),
        ({"velocity": 2.0}, lambda t: 2.0 * t),
        ({"velocity": lw.functions.harmonic(0.6, 2.0, 0.3, 1.0)},
         lambda t: 0.3 * (np.cos(0.3) - np.cos(2 * t + 0.3)) + t),
        ({"acceleration": lw.functions.polynomial(1.0, 3.0)}, lambda t: t**2 / 2 + t**3 / 2),
        ({"position": lw.functions.expression("0.2*(1 - cos(4*t))")}, lambda t: 0.2 * (1 - np.cos(4 * t))),
        ({"position": lw.functions.cycloidal(1.0, 2.0)}, lambda t: t / 2 - np.sin(np.pi * t) / (2 * np.pi)),
    ),
)  # fmt: skip
def test_a_driven_hinge_follows(motion: dict[str, object], expected: object) -> None:
    model = rotor()
    driver = model.drive("joint", name="motor", **motion)
    assert driver.kind == "angle_driver"
    result = run(lw.assemble(model).model)
    assert result.coordinate("joint").value == pytest.approx(expected(result.t), abs=1e-8)  # type: ignore[operator]
    acceleration = np.gradient(result.coordinate("joint").rate, result.t)
    torque = result.reaction("motor").torque[:, 2]
    assert torque[5:-5] == pytest.approx(0.4 * acceleration[5:-5], abs=1e-3)


def test_an_acceleration_continues_the_initial_motion() -> None:
    model = rotor("translational", velocity=(0, 0, 0.7))
    model.drive("joint", acceleration=-0.5)
    result = run(model)
    assert result.q[:, 0, 2] == pytest.approx(0.7 * result.t - 0.25 * result.t**2, abs=1e-9)


@pytest.mark.parametrize(
    ("joint", "motion", "words"),
    (
        ("hinge", {"position": 1.0}, "no joint named 'hinge'"),
        ("joint", {}, "one of position"),
        ("joint", {"position": 1.0, "velocity": 1.0}, "one of position"),
        ("joint", {"velocity": np.sin}, "integral"),
        ("joint", {"position": np.sin}, "derivatives"),
        ("joint", {"position": 1.0, "coordinate": "displacement"}, "it has angle, not 'displacement'"),
    ),
)
def test_drives_that_cannot_be_are_refused(joint: str, motion: dict[str, object], words: str) -> None:
    with pytest.raises(lw.ModelError, match=words):
        rotor().drive(joint, **motion)


def test_frames_too_far_apart_to_count_turns_are_a_warning() -> None:
    """Between frames a second apart the wheel goes round up to 16 times, and turns back."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("wheel", mass=1.0, inertia=(1, 1, 1), omega=(0, 0, 150.0))
    model.revolute("ground", "wheel", at=(0, 0, 0), axis=(0, 0, 1), name="axle")
    model.drive("axle", position=lw.functions.harmonic(50.0, 3.0))
    fine, coarse = (lw.simulate(model, 5.0, 1e-3, record_every=k, progress=False) for k in (20, 1000))
    assert fine.coordinate("axle").value == pytest.approx(50 * np.sin(3 * fine.t), abs=1e-6)
    assert coarse.coordinate("axle").value == pytest.approx(50 * np.sin(3 * coarse.t), abs=1e-6)
    coarse._statistics.pop("turned")  # as in a file whose end is lost
    with pytest.warns(lw.LinkworkWarning, match="angle of 'axle': frames are too far apart"):
        coarse.coordinate("axle")
