"""Laws of the user's own along a coordinate of a joint, against force elements and closed forms."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.errors import ModelError

INERTIA = (0.02, 0.03, 0.05)
AXIS = (0.3, 0.2, 1.0)
K, C = 3.0, 0.2


def two_bodies(joint: str, **place: Any) -> lw.Model:
    """Free in space, so that what acts on both is seen on both."""
    model = lw.Model(gravity=(0.0, 0.0, -9.81))
    model.body("a", mass=2.0, inertia=(0.2, 0.3, 0.4), position=(0, 0, 0), omega=(0.3, 0.1, -0.2))
    model.body("b", mass=1.0, inertia=INERTIA, position=(0.4, 0.1, 0.2), omega=(0.1, -0.3, 1.2))
    getattr(model, joint)("a", "b", name="joint", **place)
    return lw.assemble(model).model


def law(t: float, x: float, rate: float) -> float:
    return -K * x - C * rate


@pytest.mark.parametrize("kind", ["angle", "displacement"])
def test_a_linear_law_is_the_force_element_that_says_the_same(kind: str) -> None:
    joint = "revolute" if kind == "angle" else "translational"
    place = {"at": (0.1, 0.05, 0.1), "axis": AXIS}

    def run(add: Callable[[lw.Model], Any]) -> lw.Result:
        model = two_bodies(joint, **place)
        add(model)
        return lw.simulate(model, t_end=1.0, step=1e-3)

    ours = run(lambda model: model.joint_force("joint", law))
    if kind == "angle":

        def spring(model: lw.Model) -> None:
            place = held(model)
            model.rotational_spring_damper("a", "b", stiffness=K, damping=C, frames="body", **place)

        element = run(spring)
        assert np.abs(ours.q - element.q).max() < 1e-9
    momentum = ours.v[:, :, 2] @ np.array([2.0, 1.0])  # only gravity acts from outside
    assert np.abs(momentum - momentum[0] + 3.0 * 9.81 * ours.t).max() < 1e-9
    assert np.ptp(ours.coordinate("joint").value) > 1e-3
    assert np.ptp(ours.energy - ours.work) < 1e-7  # the work that is counted is what the mechanism loses


def held(model: lw.Model) -> dict[str, Any]:
    """The place of the joint in both bodies."""
    arrays = model.compiled().joint_arrays()
    frames = arrays["frame"][0]
    return {
        "at": tuple(arrays["origin"][0]),
        "axis": (frames[0][:, 2], frames[1][:, 2]),
        "x_axis": (frames[0][:, 0], frames[1][:, 0]),
    }


def test_a_spring_in_a_slide_swings_with_the_closed_form() -> None:
    """m x_ddot = -k x - c x_dot + m g along the slide."""
    model = lw.Model()
    axis = np.array([0.6, 0.0, -0.8])
    model.body("b", mass=2.0, inertia=INERTIA)
    model.translational("ground", "b", at=(0, 0, 0), axis=axis, name="slide")
    model.joint_force("slide", lambda t, x, rate: -50.0 * x)
    result = lw.simulate(model, t_end=2.0, step=1e-3)
    rest, omega = 2.0 * 9.81 * 0.8 / 50.0, 5.0
    exact = rest * (1 - np.cos(omega * result.t))
    assert np.abs(result.coordinate("slide").value - exact).max() < 1e-9


@pytest.mark.parametrize("which", ["angle_a", "angle_b"])
def test_a_torque_about_one_axis_of_a_cross_does_its_work_there_only(which: str) -> None:
    """Power is Q x_dot, for both axes moving."""
    model = two_bodies("universal", at=(0.1, 0.05, 0.1), axes=((1, 0, 0), (0, 1, 0)))
    model.joint_force("joint", lambda t, x, rate: 0.3 * np.cos(x), coordinate=which)
    result = lw.simulate(model, t_end=1.0, step=1e-3, record_every=1)
    found = result.coordinate("joint", which)
    power = 0.3 * np.cos(found.value) * found.rate
    work = np.concatenate([[0.0], np.cumsum((power[1:] + power[:-1]) / 2 * np.diff(result.t))])
    assert np.ptp(found.value) > 0.1
    assert np.abs(result.work - result.work[0] - work).max() < 1e-5 * np.abs(work).max()
    assert np.ptp(result.energy - result.work) < 1e-7


@pytest.mark.parametrize(
    "joint, function, message",
    [
        ("nix", law, "joint_force: no joint named 'nix'"),
        ("joint", "law", "joint force 'f': 'law' is not a function"),
        ("joint", None, "joint force 'f': None is not a function"),
        ("joint", float("nan"), "joint force 'f': nan is not finite"),
        (
            "joint",
            lambda t, x, rate: (1.0, 2.0),
            "joint force 'f': returned (1.0, 2.0) at t = 0 s, not a number",
        ),
        ("joint", lambda t, x, rate: "much", "joint force 'f': returned 'much' at t = 0 s, not a number"),
        ("joint", lambda t, x, rate: "3.0", "joint force 'f': returned '3.0' at t = 0 s, not a number"),
        ("joint", lambda t, x, rate: None, "joint force 'f': returned None at t = 0 s, not a number"),
    ],
)
def test_a_mistake_is_named(joint: str, function: Any, message: str) -> None:
    model = two_bodies("revolute", at=(0.1, 0.05, 0.1), axis=AXIS)
    with pytest.raises(ModelError) as found:
        model.joint_force(joint, function, name="f")
        lw.simulate(model, t_end=0.1, step=1e-2)
    assert message in str(found.value)


def turning(omega: float = 0.0) -> lw.Model:
    """A wheel about a vertical axis; nothing acts on it."""
    model = lw.Model()
    model.body("wheel", mass=1.0, inertia=(0.1, 0.1, 0.2), omega=(0, 0, omega))
    model.revolute("ground", "wheel", at=(0, 0, 0), axis=(0, 0, 1), name="bearing")
    return model


def test_the_angle_goes_on_over_full_turns() -> None:
    """I x_ddot = -k x: the wheel swings by more than a turn to either side."""
    model, k, omega = turning(omega=40.0), 0.2 * 9.0, 40.0
    model.joint_force("bearing", lambda t, x, rate: -k * x)
    result = lw.simulate(model, t_end=3.0, step=1e-3)
    angle = result.coordinate("bearing").value
    assert np.abs(angle).max() > 4 * np.pi
    assert np.abs(angle - omega / 3.0 * np.sin(3.0 * result.t)).max() < 1e-6


def test_full_turns_go_on_where_a_run_goes_on() -> None:
    model = turning(omega=40.0)
    model.joint_force("bearing", lambda t, x, rate: -1.8 * x)
    whole = lw.simulate(model, t_end=1.0, step=1e-3)
    half = lw.simulate(model, t_end=0.5, step=1e-3)
    rest = lw.simulate(model, t_end=1.0, step=1e-3, start=half.snapshot())
    assert np.abs(rest.v[-1] - whole.v[-1]).max() < 1e-9


T = np.linspace(0, 1, 5)


@pytest.mark.parametrize(
    "given, impulse",
    [
        (0.7, 0.7),
        (lw.functions.polynomial(0.0, 2.0), 1.0),
        (lw.functions.harmonic(1.0, np.pi), 2 / np.pi),
        (lw.functions.table(T, T**3), 0.25),
        (lambda t, x, rate: np.float32(0.5), 0.5),
        (lambda t, x, rate: 2, 2.0),
    ],
)
def test_a_number_and_a_function_of_time_are_laws(given: Any, impulse: float) -> None:
    """The change of angular momentum is the integral of the torque."""
    model = turning()
    model.joint_force("bearing", given)
    result = lw.simulate(model, t_end=1.0, step=1e-3)
    assert 0.2 * result.v[-1, 0, 5] == pytest.approx(impulse, rel=1e-9)


def test_a_run_beyond_a_table_is_refused_before_it_starts() -> None:
    model = turning()
    model.joint_force("bearing", lw.functions.table(T, T), name="motor")
    with pytest.raises(lw.OptionError, match="joint force 'motor': is given from 0 to 1 s"):
        lw.simulate(model, t_end=2.0, step=1e-3)


def test_a_law_that_is_not_finite_is_named() -> None:
    model = turning()
    model.joint_force("bearing", lambda t, x, rate: np.nan if t > 0.05 else 1.0, name="torn")
    with pytest.raises(lw.NotFiniteError, match="force 'torn'"):
        lw.simulate(model, t_end=0.1, step=1e-3)


def test_an_error_in_the_law_reaches_the_user() -> None:
    def law(t: float, x: float, rate: float) -> float:
        raise ZeroDivisionError("of mine")

    model = turning()
    model.joint_force("bearing", law)
    with pytest.raises(ZeroDivisionError, match="of mine"):
        lw.simulate(model, t_end=0.1, step=1e-3)


def test_names_of_own_forces_are_taken_once() -> None:
    model = turning()
    model.joint_force("bearing", 1.0, name="motor")
    with pytest.raises(ModelError, match="'motor' exists already"):
        model.user_force(lambda t, q, v: np.zeros_like(v), name="motor")
    model.joint_force("bearing", 1.0, name="joint force 3")
    model.joint_force("bearing", 1.0)
    model.joint_force("bearing", 1.0)
    assert model.user_force_count == 4


def test_models_differ_by_where_a_law_acts() -> None:
    hashes = set()
    for coordinate in ("angle_a", "angle_b"):
        model = two_bodies("universal", at=(0.1, 0.05, 0.1), axes=((1, 0, 0), (0, 1, 0)))
        model.joint_force("joint", law, coordinate=coordinate, name="it")
        hashes.add(model.hash())
    assert len(hashes) == 2


@pytest.mark.parametrize("kind", ["revolute", "screw"])
@pytest.mark.parametrize("axis", [(0, 0, 1), (0.3, 0.2, 1.0), (-1, 0.4, 0)])
@pytest.mark.parametrize("turned", [np.pi, -np.pi])
def test_half_a_turn_at_the_start_is_that_of_the_result(
    turned: float, axis: tuple[float, float, float], kind: str
) -> None:
    """Laws, springs and stops count from it as `Result.coordinate` does: none acts where the body rests."""
    z = np.array(axis) / np.linalg.norm(axis)
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("body", mass=1, inertia=INERTIA, orientation=lw.rotation.about(z, turned))
    place: dict[str, Any] = {"at": ((0, 0, 0),) * 2, "axis": (z, z), "frames": "body"}
    place["x_axis"] = (lw.rotation.perpendicular(z),) * 2
    more = {"pitch": 0.1} if kind == "screw" else {}
    if more:
        model = model.with_initial_state([*(0.05 * z), *lw.rotation.about(z, turned)], np.zeros(6))
        body = model.find("body")
    getattr(model, kind)("ground", body, **place, name="joint", **more)
    seen: list[float] = []

    def hold(t: float, x: float, rate: float) -> float:
        seen.append(x)
        return 20 * (np.pi - x) - 3 * rate

    model.joint_force("joint", hold, coordinate="angle" if kind == "screw" else None)
    if kind == "revolute":
        model.rotational_spring_damper("ground", body, **place, stiffness=5, free_angle=np.pi)
        model.rotational_stop("ground", body, **place, lower=0, upper=3.5, stiffness=50)
    result = lw.simulate(model, 0.2, rtol=1e-8, progress=False)
    angle = result.coordinate("joint", "angle").value
    assert seen[0] == pytest.approx(np.pi) and angle == pytest.approx(np.pi)
    assert np.abs(result.omega).max() < 1e-9
