"""Elements about an axis measure the angle of an x axis: runs in which the choice of it counts say so."""

from __future__ import annotations

import re
import warnings
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.mechanisms import MECHANISMS

ELEMENTS: dict[str, dict[str, Any]] = {
    "rotational_spring_damper": {"stiffness": 0.5},
    "nonlinear_rotational_spring_damper": {"spring": 0.5},
    "rotational_friction": {"viscous": 0.05},
    "rotational_stop": {"lower": -0.05, "upper": 0.05, "stiffness": 5.0},
    "rotational_inerter": {"inertance": 0.2},
    "motor": {"curve": lw.functions.table([-99, 99], [0.05, 0.05])},
    "angle_driver": {"angle": lw.functions.cycloidal(0.1, 2.0)},
}
CHOICE = "depends on the choice of x axes"


def cross(p: Any = (1.0, 0.0, 0.0, 0.0), tilting: float = 1.2) -> tuple[lw.Model, dict[str, Any]]:
    """A body on a universal joint, turned by p with all that it has, and where its first axis is."""
    A = lw.rotation.matrix(p)
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("body", mass=1.0, inertia=(0.02, 0.03, 0.05), orientation=p, omega=(0, tilting, 0.0))
    model.universal("ground", body, at=(0, 0, 0), axes=(A[:, 2], A[:, 1]), name="joint")
    return model, {"at": (0, 0, 0), "axis": A[:, 2], "x_axis": A[:, 1]}


def end(model: lw.Model) -> list[float]:
    result = lw.simulate(model, t_end=2.0, rtol=1e-8)
    return [float(result.coordinate("joint", which).value[-1]) for which in ("angle_a", "angle_b")]


@pytest.mark.parametrize("kind", ELEMENTS)
def test_about_an_axis_of_a_universal_joint_the_other_axis_measures_its_angle(kind: str) -> None:
    ends = []
    for p in ((1.0, 0.0, 0.0, 0.0), (0.1, -0.7, 0.5, 0.5)):
        model, place = cross(p, tilting=2.0)  # beyond 90 degrees
        getattr(model, kind)("ground", "body", **place, **ELEMENTS[kind])
        ends.append(end(model))
    assert ends[0] == pytest.approx(ends[1], abs=1e-6)
    assert ends[0][1] > np.pi / 2


@pytest.mark.parametrize("kind", ELEMENTS)
def test_with_another_x_axis_a_run_says_that_its_choice_counts(kind: str) -> None:
    model, place = cross()
    element = getattr(model, kind)
    element("ground", "body", **{**place, "x_axis": (1.0, 2.0, 0.0)}, **ELEMENTS[kind], name="it")
    with pytest.warns(lw.LinkworkWarning, match=f"'it': .* by up to .* degrees .*{CHOICE}"):
        lw.simulate(model, t_end=0.5, step=1e-3, on_inaccurate="pass")


def spinning(count: int) -> lw.Model:
    """Bodies that tumble, each with friction about an axis."""
    model = lw.Model(gravity=(0, 0, 0))
    for k in range(count):
        body = model.body(f"body {k}", mass=1.0, inertia=(0.02, 0.03, 0.05), omega=(1.0, 0.5, 0.1))
        model.rotational_friction("ground", body, at=(0, 0, 0), axis=(0, 0, 1), viscous=0.01, name=f"f{k}")
    return model


def test_three_elements_are_named_and_the_others_counted(tmp_path: Path) -> None:
    for output in (None, tmp_path / "run.h5"):
        with pytest.warns(lw.LinkworkWarning, match="'f0', 'f1', 'f2' and 3 more: .* by up to 6[0-9]"):
            lw.simulate(spinning(6), t_end=1.0, step=1e-2, output=output)


def test_a_run_that_fails_where_the_angle_ends_says_why() -> None:
    model, place = cross(tilting=2.0)
    model.rotational_inerter("ground", "body", **{**place, "x_axis": (1, 0, 0)}, inertance=0.2)
    model = model.with_initial_state(*_spun(model))
    with (
        pytest.warns(
            lw.LinkworkWarning, match="comes to the axis, as at the end here, there is no angle"
        ) as it,
        pytest.raises(lw.NotFiniteError),
    ):
        lw.simulate(model, t_end=3.0, step=1e-3)
    assert it[0].filename == __file__


def _spun(model: lw.Model) -> tuple[Any, Any]:
    """Turning about the first axis as well."""
    v = np.array(model.compiled().v0)
    v[5] = 0.3
    return model.compiled().q0, v


def test_kinematics_says_so_too() -> None:
    model, place = cross()
    model.angle_driver("ground", "body", **{**place, "x_axis": (1, 2, 0)}, angle=0.0, name="first")
    model.angle_driver("body", "ground", at=(0, 0, 0), axis=(0, 1, 0), x_axis=(0, 0, 1),
                       angle=lw.functions.polynomial(0.0, -0.5))  # fmt: skip
    with pytest.warns(lw.LinkworkWarning, match=f"'first': .*{CHOICE}"):
        lw.kinematics(model, np.linspace(0, 1, 11))


def test_members_of_ensembles_say_so() -> None:
    many = lw.Ensemble([spinning(1), spinning(1)]).simulate(1.0, step=1e-2)
    assert all("'f0'" in many.remarks[k] and CHOICE in many.remarks[k] for k in range(2))


@pytest.mark.parametrize("formulation", ["standard", "penalty"])
def test_joints_that_keep_the_axis_are_silent_where_they_are_violated(formulation: Any) -> None:
    model = lw.Model()
    bodies = ["ground", "a", "b", "c"]
    for k, joint in enumerate((lw.Model.revolute, lw.Model.cylindrical, lw.Model.screw)):
        body = model.body(bodies[k + 1], mass=1.0, inertia=(0.02, 0.03, 0.05), position=(0.3 * k + 0.2, 0, 0))
        more = {"pitch": 0.1} if joint is lw.Model.screw else {}
        where: dict[str, Any] = {"at": (0.3 * k, 0, 0), "axis": (0, 1, 0.2)}
        joint(model, bodies[k], body, **where, **more)
        model.rotational_spring_damper(bodies[k], body, **where, stiffness=1.0, damping=0.1)
        model.rotational_inerter(bodies[k], body, **where, inertance=0.01)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        lw.simulate(model, t_end=0.5, step=1e-3, formulation=formulation, on_inaccurate="pass")


@pytest.mark.parametrize("name", ["flyball_governor", "gyroscope", "delta_robot", "double_wishbone"])
def test_mechanisms_are_silent(name: str) -> None:
    mechanism = MECHANISMS[name]
    with warnings.catch_warnings():
        warnings.simplefilter("error", lw.LinkworkWarning)
        lw.simulate(mechanism.function(), t_end=0.5, rtol=1e-5, on_inaccurate="pass")


def flick() -> lw.Model:
    """The second axis of a universal joint tilts for a moment, and returns to where it was."""
    model, place = cross(tilting=20.0)
    model.joint_force("joint", lambda t, x, v: -0.03 * (60.0**2 * x + 60.0 * v), coordinate="angle_b")
    place["x_axis"] = (1.0, 2.0, 0.0)
    model.rotational_spring_damper("ground", "body", **place, stiffness=1e-3, name="it")
    return model


def told(model: lw.Model) -> tuple[str, float, float]:
    """'up to' or 'at least', and the tilt [degrees]: told, and the largest of all frames."""
    with pytest.warns(lw.LinkworkWarning, match=CHOICE) as caught:
        result = lw.simulate(model, t_end=2.0, step=1e-3, on_inaccurate="pass")
    (text,) = (str(it.message) for it in caught if CHOICE in str(it.message))
    found = re.search(r"tilts by (up to|at least) (\S+) degrees", text)
    assert found
    upright = lw.rotation.matrix(result.q[:, 0, 3:])[:, 2, 2]
    return found[1], float(found[2]), float(np.degrees(np.arccos(upright.min())))


def test_the_tilt_that_is_told_is_the_largest_of_all_frames() -> None:
    word, tilt, largest = told(flick())
    assert word == "up to" and tilt == pytest.approx(largest, rel=1e-2)
    assert largest > 5.0


def test_of_a_sample_of_the_frames_the_tilt_is_at_least_what_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("linkwork.running.sampled_frames.LOOKS", 100)
    word, tilt, largest = told(flick())
    assert word == "at least" and 0.0 < tilt < largest
