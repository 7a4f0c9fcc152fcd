"""Kinematic analysis and inverse dynamics against closed forms, and against forward dynamics."""

from __future__ import annotations

from collections.abc import Sequence

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats
from linkwork.constraints import continuation
from linkwork.constraints.equations import Equations
from numpy.typing import ArrayLike

Z = (0.0, 0.0, 1.0)


def only_careful(monkeypatch: pytest.MonkeyPatch) -> None:
    """Frames are found one by one, as near singular poses."""
    monkeypatch.setattr("linkwork.analyses.kinematics._CompiledContinuation.start", lambda self: False)
    monkeypatch.setattr("linkwork.analyses.kinematics._CompiledContinuation.resume", lambda self: None)


@pytest.fixture(params=("compiled", "dense", "sparse"))
def matrices(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """All ways to solve with D, whatever the size of the model."""
    if request.param != "compiled":
        only_careful(monkeypatch)
    if request.param == "sparse":
        monkeypatch.setattr("linkwork.constraints.solver.DENSE", 0)


every_way = pytest.mark.usefixtures("matrices")


def link(
    model: lw.Model, name: str, a: ArrayLike, b: ArrayLike, mass: float = 1.0, **more: object
) -> lw.Body:
    """A body of general inertia between two points."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    return model.body(name, mass=mass, inertia=(0.03, 0.05, 0.06), position=(a + b) / 2, **more)


def slider_crank(angle: object, r: float = 1.0, rod: float = 3.0, driver: str = "crank") -> lw.Model:
    """In the plane, at 0 rad with the crank along +x; redundant in space."""
    model = lw.Model(gravity=(0, -9.81, 0), name="slider-crank")
    crank = link(model, "crank", (0, 0, 0), (r, 0, 0))
    coupler = link(model, "rod", (r, 0, 0), (r + rod, 0, 0))
    slider = link(model, "slider", (r + rod, 0, 0), (r + rod, 0, 0), mass=2.0)
    model.revolute(model.ground, crank, at=(0, 0, 0), axis=Z, name="bearing")
    model.revolute(crank, coupler, at=(r, 0, 0), axis=Z, name="pin")
    model.revolute(coupler, slider, at=(r + rod, 0, 0), axis=Z, name="wrist")
    model.translational(model.ground, slider, at=(r + rod, 0, 0), axis=(1, 0, 0), name="guide")
    if driver == "crank":
        model.angle_driver(model.ground, crank, at=(0, 0, 0), axis=Z, angle=angle, name="motor")
    elif driver == "slider":
        at = (r + rod, 0, 0)
        model.displacement_driver(
            model.ground, slider, at=at, axis=(1, 0, 0), displacement=angle, name="push"
        )
    return model


def rates(f: object, t: Floats) -> tuple[Floats, Floats]:
    """First and second derivatives of f(t), by differences of fourth order."""
    h = 1e-3
    m2, m1, p0, p1, p2 = (f(t + k * h) for k in (-2, -1, 0, 1, 2))  # type: ignore[operator]
    return (m2 - 8 * m1 + 8 * p1 - p2) / (12 * h), (-m2 + 16 * m1 - 30 * p0 + 16 * p1 - p2) / (12 * h * h)


@every_way
def test_a_slider_crank_moves_as_its_closed_form_says() -> None:
    """x = r cos + sqrt(l^2 - r^2 sin^2), over several turns, with the derivatives."""
    speed, gain, t = 3.0, 0.2, np.linspace(0, 5, 201)
    motion = lw.kinematics(slider_crank(lw.functions.polynomial(0.0, speed, gain)), t)
    angle, rate = speed * t + gain * t**2, speed + 2 * gain * t
    sine, cosine = np.sin(angle), np.cos(angle)
    root = np.sqrt(9 - sine**2)
    slope = -sine - sine * cosine / root
    bend = -cosine - (cosine**2 - sine**2) / root - sine**2 * cosine**2 / root**3
    slider = motion.body("slider")
    assert np.abs(slider.position[:, 0] - (cosine + root)).max() < 1e-12
    assert np.abs(slider.velocity[:, 0] - slope * rate).max() < 1e-11
    assert np.abs(slider.acceleration[:, 0] - (bend * rate**2 + slope * 2 * gain)).max() < 1e-10
    assert motion.singular_poses == ()
    assert motion.violation.max() < 1e-11


def four_bar(angle: object, lengths: tuple[float, float, float, float]) -> lw.Model:
    """Crank a, coupler b, rocker c on a base d along x; assembled with the crank at 60 degrees."""
    a, b, c, d = lengths
    model = lw.Model(gravity=(0, -9.81, 0), name="four-bar")
    tip = a * np.array([np.cos(np.pi / 3), np.sin(np.pi / 3), 0])
    joint = four_bar_joint(np.array([np.pi / 3]), lengths)[0]
    crank = link(model, "crank", (0, 0, 0), tip)
    coupler = link(model, "coupler", tip, joint)
    rocker = link(model, "rocker", (d, 0, 0), joint)
    for name, i, j, at in (
        ("A", model.ground, crank, (0, 0, 0)), ("B", crank, coupler, tip), ("C", coupler, rocker, joint),
        ("D", model.ground, rocker, (d, 0, 0)),
    ):  # fmt: skip
        model.revolute(i, j, at=at, axis=Z, name=name)
    model.angle_driver(model.ground, crank, at=(0, 0, 0), axis=Z, angle=angle, name="motor")
    return model


def four_bar_joint(angle: Floats, lengths: tuple[float, float, float, float]) -> Floats:
    """Where coupler and rocker meet (k, 3): the circles about the ends of crank and base intersect."""
    a, b, c, d = lengths
    tip = a * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    to = np.array([d, 0.0]) - tip
    s = np.linalg.norm(to, axis=-1, keepdims=True)
    along = (s**2 + b**2 - c**2) / (2 * s)
    normal = np.stack([-to[:, 1], to[:, 0]], axis=-1) / s
    meet = tip + along * to / s + np.sqrt(b**2 - along**2) * normal
    return np.column_stack([meet, np.zeros(len(angle))])


def test_a_four_bar_moves_as_two_circles_intersect() -> None:
    lengths, t = (0.5, 1.4, 1.2, 1.5), np.linspace(0, 4, 161)
    motion = lw.kinematics(four_bar(lw.functions.polynomial(0, 4.0), lengths), t)

    def middle(at: Floats) -> Floats:
        return (four_bar_joint(np.pi / 3 + 4.0 * at, lengths) + np.array([1.5, 0, 0])) / 2

    first, second = rates(middle, t)
    rocker = motion.body("rocker")
    assert np.abs(rocker.position - middle(t)).max() < 1e-12
    assert np.abs(rocker.velocity - first).max() < 1e-9
    assert np.abs(rocker.acceleration - second).max() < 1e-6


# --- parallel robots: the platform's motion is given, closed forms say what the drives must do --------------


PLATFORM = {"mass": 5.0, "inertia": (0.3, 0.3, 0.5)}


def stewart(lengths: list[object], base: Floats, top: Floats, height: float) -> lw.Model:
    """Six legs, each a universal and a ball joint with a sliding pair between them."""
    model = lw.Model(name="stewart")
    plate = model.body("platform", position=(0, 0, height), **PLATFORM)
    for k, (b, p) in enumerate(zip(base, top + np.array([0, 0, height]), strict=True)):
        along = p - b
        across = np.cross(along, (0.3, 1.0, 0.2))
        facing = lw.rotation.from_axes(along, across)
        lower = link(model, f"lower {k}", b, b + along / 2, orientation=facing)
        upper = link(model, f"upper {k}", p - along / 2, p, orientation=facing)
        model.universal(model.ground, lower, at=b, axes=(np.cross(along, across), across), name=f"foot {k}")
        model.translational(lower, upper, at=(b + p) / 2, axis=along, name=f"cylinder {k}")
        model.spherical(upper, plate, at=p, name=f"ball {k}")
        model.displacement_driver(
            lower, upper, at=(b + p) / 2, axis=along, displacement=lengths[k], name=f"leg {k}"
        )
    return model


def ring(radius: float, offset: float) -> Floats:
    """Six points in three pairs."""
    angles = np.radians([s * offset + turn for turn in (0, 120, 240) for s in (-1, 1)])
    return radius * np.column_stack([np.cos(angles), np.sin(angles), np.zeros(6)])


def test_a_stewart_platform_takes_the_pose_that_its_legs_say() -> None:
    """The lengths of the legs follow from a pose in closed form; the analysis finds the pose from them."""
    base, top, height = ring(1.0, 15), ring(0.6, 45), 1.2
    t = np.linspace(0, 1.5, 31)

    def centers(at: Floats) -> Floats:
        c = np.stack([0.1 * np.sin(2 * at), 0.08 * (1 - np.cos(3 * at)), 0.1 * np.sin(at)], axis=-1)
        return c + np.array([0, 0, height])

    def turns(at: Floats) -> Floats:
        return lw.rotation.about((1.0, 2.0, 2.0), 0.2 * np.sin(2 * at))

    def legs(at: Floats) -> Floats:
        tips = centers(at)[:, None] + np.einsum("kij,nj->kni", lw.rotation.matrix(turns(at)), top)
        return np.linalg.norm(tips - base, axis=2)

    dense = np.linspace(0, 1.5, 1501)
    extension = legs(dense) - legs(np.zeros(1))
    model = stewart([lw.functions.table(dense, e) for e in extension.T], base, top, height)
    motion = lw.kinematics(model, t)
    plate = motion.body("platform")
    assert np.abs(plate.position - centers(t)).max() < 1e-10
    assert np.abs(np.abs((plate.orientation * turns(t)).sum(axis=1)) - 1).max() < 1e-10
    axis = np.array([1.0, 2.0, 2.0]) / 3
    assert np.abs(plate.omega_inertial - 0.4 * np.cos(2 * t)[:, None] * axis).max() < 1e-6  # of the spline


def test_a_delta_robot_takes_the_place_that_its_arms_say() -> None:
    """|elbow_k(theta_k) + shift_k - p| = forearm: theta_k of p in closed form; the analysis finds p."""
    arm, forearm, base, plate_radius, depth = 0.4, 0.9, 0.3, 0.1, 0.8
    directions = np.array([[np.cos(a), np.sin(a), 0] for a in np.radians([0, 120, 240])])
    t = np.linspace(0, 2, 41)

    def places(at: Floats) -> Floats:
        wave = np.stack([0.15 * np.sin(3 * at), 0.12 * np.sin(2 * at), 0.1 * np.sin(at)], axis=-1)
        return wave - np.array([0, 0, depth])

    def angles(at: Floats) -> Floats:
        """Below the horizontal, the elbow outward: E cos + F sin = G."""
        out = []
        for u in directions:
            w = places(at) + (plate_radius - base) * u  # from the shoulder to the end of the forearm
            E, F = 2 * arm * (w @ u), -2 * arm * w[:, 2]
            G = (w**2).sum(axis=1) + arm**2 - forearm**2
            out.append(np.arctan2(F, E) - np.arccos(G / np.hypot(E, F)))
        return np.array(out)

    dense = np.linspace(0, 2, 2001)
    model = lw.Model(name="delta")
    start, first = places(np.zeros(1))[0], angles(np.zeros(1))[:, 0]
    plate = model.body("plate", position=start, **PLATFORM)
    for k, (u, angle) in enumerate(zip(directions, first, strict=True)):
        across = np.cross(Z, u)
        shoulder, end = base * u, start + plate_radius * u
        elbow = shoulder + arm * (np.cos(angle) * u - np.sin(angle) * np.array(Z))
        upper = link(model, f"arm {k}", shoulder, elbow)
        model.revolute(model.ground, upper, at=shoulder, axis=across, name=f"shoulder {k}")
        for side in (-0.05, 0.05):
            model.distance(upper, plate, at=(elbow + side * across, end + side * across))
        turn = lw.functions.table(dense, angles(dense)[k] - angle)
        model.angle_driver(model.ground, upper, at=shoulder, axis=across, angle=turn, name=f"motor {k}")
    motion = lw.kinematics(model, t)
    plate_motion = motion.body("plate")
    assert np.abs(plate_motion.position - places(t)).max() < 1e-10
    assert np.abs(plate_motion.orientation[:, 1:]).max() < 1e-10  # it does not turn


def driven_mechanisms() -> dict[str, lw.Model]:
    turn = lw.functions.polynomial(0.0, 2.0, 0.3)
    linkage = (0.5, 1.4, 1.2, 1.5)
    legs = [lw.functions.expression(f"0.1 * sin({2 + 0.2 * k} * t)") for k in range(6)]
    loops = lw.mechanisms.four_bar(20)
    loops.angle_driver(
        "ground", loops.compiled().body_name(0), at=(0, 0, 0), axis=Z, angle=turn, name="motor"
    )
    return {
        "slider-crank": slider_crank(turn),
        "four-bar": four_bar(turn, linkage),
        "stewart": stewart(legs, ring(1.0, 15), ring(0.6, 45), 1.2),
        "20 loops": loops,
    }


@pytest.mark.parametrize("name", driven_mechanisms())
def test_compiled_frames_are_those_that_a_closer_look_finds(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With the multipliers of redundant rows; none of them takes a dense decomposition."""
    model, t = driven_mechanisms()[name], np.linspace(0, 0.4, 9)
    with monkeypatch.context() as context:
        context.setattr("numpy.linalg.svd", None)
        quick = lw.kinematics(model, t)
    only_careful(monkeypatch)
    careful = lw.kinematics(model, t)
    for field in ("q", "v", "acceleration", "multipliers", "energy", "work"):
        found, expected = getattr(quick, field), getattr(careful, field)
        assert np.abs(found - expected).max() < 1e-9 * (1 + np.abs(expected).max()), field
    assert quick.violation.max() < 1e-10 * (1 + np.abs(careful.acceleration).max())
    assert quick.statistics["factorizations"] <= 2 * len(t)


# --- singular poses, and what cannot be done ----------------------------------------------------------------


def parallelogram() -> lw.Model:
    return four_bar(lw.functions.polynomial(0.0, 1.0), (1.0, 2.0, 1.0, 2.0))


@every_way
def test_a_parallelogram_passes_its_toggles_and_they_are_told() -> None:
    """All links lie down with the crank at 180 and 360 degrees: there are two ways to go on."""
    t = np.linspace(0, 6, 61)
    with pytest.warns(lw.LinkworkWarning, match=r"singular pose at t = (2\.0944|5\.23599) s"):
        motion = lw.kinematics(parallelogram(), t)
    angle = np.pi / 3 + t
    assert np.abs(motion.body("coupler").position[:, 1] - np.sin(angle)).max() < 1e-9
    found = [pose.t for pose in motion.singular_poses]
    assert np.abs(np.array(found) - [2 * np.pi / 3, 5 * np.pi / 3]).max() < 1e-5
    assert set(motion.singular_poses[0].joints) == {"A", "B", "C", "D"}


@pytest.mark.filterwarnings("ignore:kinematics. the work")
@every_way
def test_a_frame_in_a_toggle_has_the_velocity_from_both_sides() -> None:
    t = np.array([0, 1, 2 * np.pi / 3, 3])
    motion = lw.kinematics(parallelogram(), t, on_singular="pass")
    assert motion.singular_poses[0].t == t[2]
    velocity, acceleration = motion.velocity[2, 1, 1], motion.acceleration[2, 1, 1]
    assert abs(velocity - np.cos(np.pi / 3 + t[2])) < 1e-10
    assert abs(acceleration + np.sin(np.pi / 3 + t[2])) < 1e-8


@pytest.mark.filterwarnings("ignore:kinematics. the work")
@every_way
def test_a_motion_that_starts_in_a_toggle_is_refused() -> None:
    flat = lw.kinematics(parallelogram(), [0, 2 * np.pi / 3], on_singular="pass")
    model = four_bar(lw.functions.polynomial(2 * np.pi / 3, 1.0), (1.0, 2.0, 1.0, 2.0))
    model = model.with_initial_state(flat.q[-1], np.zeros_like(flat.v[-1]))
    refused = "dead point|in this pose the equations of .* start elsewhere|beyond t = .* depend on each other"
    with pytest.raises(lw.LinkworkError, match=refused) as caught:
        lw.kinematics(model, [0, 1], on_singular="pass")
    assert caught.value.time is None or caught.value.time < 1e-4


def test_a_toggle_can_stop_the_analysis() -> None:
    with pytest.raises(lw.SingularSystemError, match="at t = 2.0944 s") as caught:
        lw.kinematics(parallelogram(), np.linspace(0, 6, 61), on_singular="stop")
    assert caught.value.result is not None and len(caught.value.result) == 21


@every_way
def test_a_slider_pushed_beyond_its_dead_point_is_told_with_its_time() -> None:
    """From the crank at 1 rad the slider goes out with 0.5 m/s, and reaches 4 m when all is in line."""
    turned = lw.kinematics(slider_crank(lw.functions.polynomial(1.0)), [0, 1])
    x = turned.position[0, 2, 0]
    model = slider_crank(lw.functions.polynomial(x - 4.0, 0.5), driver="slider")
    model = model.with_initial_state(turned.q[0], np.zeros_like(turned.v[0]))
    with pytest.raises(lw.NotConvergedError, match="cannot follow its drivers beyond") as caught:
        lw.kinematics(model, np.linspace(0, 4, 81))
    error = caught.value
    assert error.code == "dead_point"
    assert error.time == pytest.approx((4 - x) / 0.5, abs=1e-6)
    assert "push" in error.joints and "guide" not in error.joints[:1]
    assert error.result is not None and not error.result.finished
    assert error.result.t[-1] == pytest.approx(np.floor((4 - x) / 0.5 / 0.05) * 0.05)


@every_way
@pytest.mark.filterwarnings("ignore:kinematics. the work is about")
@pytest.mark.parametrize("frames", [2, 3, 4])
def test_full_turns_between_frames_are_counted_through_toggles(frames: int) -> None:
    """The compiled search ends before a toggle, and what it went of the way there is gone a second time."""
    law = lw.functions.expression("6*tanh(8*(t-1))")
    model = four_bar(law, (1.0, 2.0, 1.0, 2.0))
    motion = lw.kinematics(model, np.linspace(0, 2, frames), on_singular="pass")
    angle = np.array([law.evaluate(t)[0] for t in motion.t])
    assert np.ptp(motion.coordinate("A").value - angle) < 1e-9


def test_a_freedom_that_is_left_is_named() -> None:
    with pytest.raises(lw.ModelError, match="1 freedom is left to the model 'slider-crank': body 'crank'"):
        lw.kinematics(slider_crank(None, driver=""), [0, 1])


def steered_wheel(heading: object, spin: object) -> lw.Model:
    """A wheel in a fork that stays upright; it rolls along +x at the start. Its height is held twice."""
    model = lw.Model(gravity=(0, 0, -9.81), name="wheel")
    fork = model.body("fork", mass=3.0, inertia=(0.1, 0.1, 0.2), position=(0, 0, 0.25))
    wheel = model.body("wheel", mass=2.0, inertia=(0.04, 0.06, 0.04), position=(0, 0, 0.25))
    model.planar(model.ground, fork, at=(0, 0, 0.25), axis=Z, name="floor")
    model.revolute(fork, wheel, at=(0, 0, 0.25), axis=(0, 1, 0), name="axle")
    model.rolling_disc(
        model.ground, wheel, at=((0, 0, 0), (0, 0, 0.25)), axes=(Z, (0, 1, 0)), radius=0.25, name="tire"
    )
    if heading is not None:
        model.angle_driver(model.ground, fork, at=(0, 0, 0), axis=Z, angle=heading, name="steering")
    model.angle_driver(fork, wheel, at=(0, 0, 0.25), axis=(0, 1, 0), angle=spin, name="motor")
    return model


@every_way
def test_a_wheel_that_is_steered_rolls_in_a_circle() -> None:
    """Of radius r W / w; the tire gives the force m v w to the center, of 5 kg."""
    turn, spin = lw.functions.polynomial(0.0, 0.8), lw.functions.polynomial(0.0, 4.0)
    needed = lw.inverse_dynamics(steered_wheel(turn, spin), np.linspace(0, 5, 21))
    motion, angle, radius = needed.motion, 0.8 * needed.t, 0.25 * 4.0 / 0.8
    place = radius * np.stack([np.sin(angle), 1 - np.cos(angle)], axis=1)
    assert np.abs(motion.body("wheel").position[:, :2] - place).max() < 1e-9
    assert np.abs(motion.body("fork").velocity[:, 0] - np.cos(angle)).max() < 1e-9
    inward = 5.0 * 0.8 * np.stack([-np.sin(angle), np.cos(angle)], axis=1)
    assert np.abs(motion.reaction("tire").force[:, :2] - inward).max() < 1e-8
    assert np.abs(needed.effort("motor")).max() < 1e-8


def test_a_wheel_that_is_not_steered_has_a_freedom_left() -> None:
    with pytest.raises(
        lw.ModelError, match="1 freedom is left to the model 'wheel': body '(fork|wheel)' turns"
    ):
        lw.kinematics(steered_wheel(None, lw.functions.polynomial(0.0, 4.0)), [0, 1])


@pytest.mark.parametrize(
    "times", ([0.0], [0, 0.5, 0.5], [-1, 1], [0, np.nan], [[0, 1], [2, 3]], "ab", [[0, 1], [2]])
)
def test_times_that_do_not_increase_from_zero_are_refused(times: ArrayLike) -> None:
    with pytest.raises(lw.OptionError, match="must be two or more finite numbers|are not numbers"):
        lw.kinematics(slider_crank(0.0), times)


@every_way
def test_drivers_that_contradict_each_other_are_named() -> None:
    model = slider_crank(0.0)
    model.displacement_driver(
        model.ground, "slider", at=(4, 0, 0), axis=(1, 0, 0), displacement=1.0, name="too far"
    )
    with pytest.raises(lw.NotConvergedError, match="'too far'"):
        lw.kinematics(model, [0, 1])


# --- large models -------------------------------------------------------------------------------------------


def test_a_thousand_parallelograms_move_as_the_first() -> None:
    """2001 bodies, 2000 redundant equations: rods stay level, cranks parallel."""
    n = 1000
    model = lw.Model(gravity=(0, -9.81, 0), name="row")
    x = np.arange(n + 1.0)[:, None] * (1.0, 0, 0)
    cranks = model.bodies("crank", mass=1.0, inertia=(0.1, 0.1, 0.1), position=x + np.array([0, 0.5, 0]))
    rods = model.bodies("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=x[:-1] + (0.5, 1, 0))
    model.joints("revolute", model.ground, cranks, at=x, axis=Z, name="bearing")
    model.joints("revolute", cranks.indices[:-1], rods, at=x[:-1] + (0, 1, 0), axis=Z, name="left")
    model.joints("revolute", rods, cranks.indices[1:], at=x[1:] + (0, 1, 0), axis=Z, name="right")
    with pytest.raises(lw.ModelError, match="1 freedom is left to the model 'row'"):
        lw.kinematics(model, [0, 1])
    model.angle_driver(
        model.ground, cranks[0], at=(0, 0, 0), axis=Z, angle=lw.functions.harmonic(0.4, 3.0), name="motor"
    )
    needed = lw.inverse_dynamics(model, np.linspace(0, 1, 6))
    angle, rate, acceleration = (
        0.4 * np.sin(3 * needed.t),
        1.2 * np.cos(3 * needed.t),
        -3.6 * np.sin(3 * needed.t),
    )
    tip = np.stack([-np.sin(angle), np.cos(angle)], axis=1)
    motion = needed.motion
    assert np.abs(motion.position[:, n + 1 :, :2] - x[:-1, :2] - (0.5, 0) - tip[:, None]).max() < 1e-10
    assert np.abs(motion.velocity[:, : n + 1, 0] + rate[:, None] / 2 * np.cos(angle)[:, None]).max() < 1e-10
    inertia = (n + 1) * (0.1 + 0.25) + n  # of all about a bearing
    weight = 9.81 * np.sin(angle) * ((n + 1) * 0.5 + n)
    assert needed.effort("motor") == pytest.approx(inertia * acceleration - weight, rel=1e-8, abs=1e-6)


def test_a_driven_chain_of_1000_links_bends_as_its_angles_say() -> None:
    """All equations are needed, and the smallest singular value is small everywhere: no pose is singular."""
    n, y = 1000, (0, 1, 0)
    model = lw.Model(name="snake")
    at = np.arange(float(n))[:, None] * (1.0, 0, 0)
    links = model.bodies("link", mass=1.0, inertia=(0.1, 0.1, 0.1), position=at + np.array([0.5, 0, 0]))
    model.joints("revolute", np.arange(n) - 1, links, at=at, axis=y, name="hinge")
    share = 0.02 * np.cos(np.arange(n) / 30)
    for k in range(n):
        angle = lw.functions.harmonic(share[k], 2.0)
        before = links[k - 1] if k else model.ground
        model.angle_driver(before, links[k], at=at[k], axis=y, angle=angle, name=f"motor {k}")
    motion = lw.kinematics(model, np.linspace(0, 1, 6), on_singular="stop")
    turned = np.sin(2.0 * motion.t)[:, None] * np.cumsum(share)
    assert (
        np.abs(motion.position[..., 0] - np.cumsum(np.cos(turned), axis=1) + np.cos(turned) / 2).max() < 1e-10
    )
    assert (
        np.abs(motion.position[..., 2] + np.cumsum(np.sin(turned), axis=1) - np.sin(turned) / 2).max() < 1e-10
    )


# --- inverse dynamics ---------------------------------------------------------------------------------------


@every_way
def test_a_driven_pendulum_needs_its_inertia_and_weight() -> None:
    """n = (J + m l^2) phi'' + m g l cos(phi)."""
    model = lw.Model(gravity=(0, -9.81, 0))
    rod = model.body("rod", mass=2.0, inertia=(0.1, 0.2, 0.3), position=(0.7, 0, 0))
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=Z)
    swing = lw.functions.harmonic(amplitude=1.5, frequency=2.0)
    model.angle_driver(model.ground, rod, at=(0, 0, 0), axis=Z, angle=swing, name="motor")
    needed = lw.inverse_dynamics(model, np.linspace(0, 3, 61))
    phi = 1.5 * np.sin(2 * needed.t)
    torque = -(0.3 + 2 * 0.49) * 4 * phi + 2 * 9.81 * 0.7 * np.cos(phi)
    assert np.abs(needed.effort("motor") - torque).max() < 1e-11
    assert np.abs(needed.drives["motor"].power - torque * 3 * np.cos(2 * needed.t)).max() < 1e-10
    assert needed.drives["motor"].unique


def test_inverse_then_forward_dynamics_returns_the_motion() -> None:
    """The slider-crank over 5 s, its motor's torque given to a free crank as a table."""
    t = np.linspace(0, 5, 2501)
    turn = lw.functions.polynomial(0.0, 3.0, 0.1)
    needed = lw.inverse_dynamics(slider_crank(turn), t)
    free = slider_crank(None, driver="")
    torque = lw.functions.table(t, needed.effort("motor"))
    free.force("crank", torque=(0, 0, torque))
    free = free.with_initial_state(needed.motion.q[0], needed.motion.v[0])
    result = lw.simulate(free, 5.0, 1e-3, record_every=2, progress=False)
    assert np.abs(result.position - needed.motion.position).max() < 1e-6


def test_the_work_of_the_drives_is_the_energy_gained() -> None:
    motion = lw.kinematics(slider_crank(lw.functions.polynomial(0.0, 2.0, 0.5)), np.linspace(0, 3, 1201))
    assert np.abs(motion.energy_error).max() < 1e-7
    assert np.ptp(motion.energy) > 10


def test_a_driver_that_does_not_exist_is_refused() -> None:
    with pytest.raises(lw.ModelError, match="no joint named 'moto'; the nearest is 'motor'"):
        lw.inverse_dynamics(slider_crank(0.0), [0, 1], drivers=["moto"])
    with pytest.raises(lw.ModelError, match="has 5 equations and drives nothing"):
        lw.inverse_dynamics(slider_crank(0.0), [0, 1], drivers=["pin"])
    with pytest.raises(lw.ModelError, match="no driver named 'moto'; the nearest is 'motor'"):
        lw.inverse_dynamics(slider_crank(0.0), [0, 1]).effort("moto")
    with pytest.raises(lw.ModelError, match=r"no driver named \[\]; choose from 'motor'"):
        lw.inverse_dynamics(slider_crank(0.0), [0, 1]).effort([])  # type: ignore[arg-type]


@pytest.mark.filterwarnings("ignore:kinematics. the work")
def test_handles_of_drivers_are_taken_where_their_names_are() -> None:
    model = slider_crank(None, driver="")
    motor = model.drive("bearing", position=lw.functions.polynomial(0.0, 2.0), name="motor")
    needed = lw.inverse_dynamics(model, [0, 1], drivers=[motor])
    assert (needed.effort(motor) == needed.effort("motor")).all()
    other = slider_crank(None, driver="")
    other.drive("guide", position=0.0, name="push")
    other.drive("bearing", position=0.0, name="motor")
    with pytest.raises(lw.ModelError, match="'motor' belongs to another model"):
        lw.inverse_dynamics(other, [0, 1], drivers=[motor])


@pytest.mark.parametrize("drivers", ("motor", [], [1]))
def test_drivers_are_given_by_a_list_of_names(drivers: object) -> None:
    with pytest.raises(lw.OptionError, match="are not a list of names of joints"):
        lw.inverse_dynamics(slider_crank(0.0), [0, 1], drivers=drivers)  # type: ignore[arg-type]


@pytest.mark.parametrize("analysis", (lw.inverse_dynamics, lw.kinematics))
def test_a_function_in_the_place_of_a_model_is_named(analysis: object) -> None:
    with pytest.raises(
        lw.ModelError, match="a linkwork.Model is wanted, not the function slider_crank: call"
    ):
        analysis(slider_crank, [0, 1])  # type: ignore[operator]


def test_what_a_driver_needs_is_told_in_a_line() -> None:
    """m g l at the level, at rest: 1 kg and 9.81 m/s2 at 0.5 m."""
    model = lw.Model(gravity=(0, -9.81, 0))
    arm = link(model, "arm", (0, 0, 0), (1, 0, 0))
    model.revolute(model.ground, arm, at=(0, 0, 0), axis=Z)
    model.angle_driver(model.ground, arm, at=(0, 0, 0), axis=Z, angle=0.0, name="hold")
    found = str(lw.inverse_dynamics(model, [0, 1]))
    assert found == "hold: 4.905 N m at t = 0 s, power from 0 to 0 W"


def test_a_rod_without_mass_and_one_of_almost_none_need_the_same_torque() -> None:
    efforts = []
    for mass in (0.0, 1e-9):
        model = lw.Model()
        crank = link(model, "crank", (0, 0, 0), (1, 0, 0))
        rod = model.body("rod", mass=mass, inertia=np.full(3, mass), position=(2.5, 0, 0))
        slider = link(model, "slider", (4, 0, 0), (4, 0, 0))
        for i, j, x in ((model.ground, crank, 0), (crank, rod, 1), (rod, slider, 4)):
            model.revolute(i, j, at=(x, 0, 0), axis=Z)
        model.translational(model.ground, slider, at=(4, 0, 0), axis=(1, 0, 0))
        turn = lw.functions.polynomial(0.3, 2.0)
        model.angle_driver(model.ground, crank, at=(0, 0, 0), axis=Z, angle=turn, name="motor")
        efforts.append(lw.inverse_dynamics(model, np.linspace(0, 1, 11)).effort("motor"))
    assert np.abs(efforts[0]).max() > 1
    assert np.abs(efforts[0] - efforts[1]).max() < 1e-7


def cranked(angle: lw.functions.Function) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("crank", mass=1.0, inertia=(0.1,) * 3)
    model.revolute("ground", "crank", at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    model.rotational_spring_damper("ground", "crank", axis=(0, 0, 1), stiffness=0.5, name="spring")
    model.drive("pin", position=angle, name="drive")
    return model


@pytest.mark.filterwarnings("ignore:kinematics. the work")
@pytest.mark.parametrize("frames", [2, 3, 5, 9])
def test_turns_between_frames_count_for_springs(frames: int) -> None:
    """From rest to rest: at frames a turn apart the crank stands as if it had not moved."""
    model = cranked(lw.functions.cycloidal(4 * np.pi, 2.0))
    effort = lw.inverse_dynamics(model, np.linspace(0, 2.0, frames))
    assert effort.motion.force("spring").deflection[-1] == pytest.approx(4 * np.pi, rel=1e-9)
    assert effort.effort("drive")[-1] == pytest.approx(2 * np.pi, rel=1e-9)


@pytest.mark.usefixtures("matrices")
@pytest.mark.filterwarnings("ignore:kinematics. the work")
@pytest.mark.parametrize("frames", [8, 60, 301])
def test_contacts_know_the_speed_at_which_they_began_between_frames(frames: int) -> None:
    """Two balls on a lever that swings, K d^1.5 (1 + c d_dot / d_dot_0) each: touch in closed form."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("lever", mass=1.0, inertia=(1, 1, 1), position=(0, 0, 0.3))
    model.revolute("ground", "lever", at=(0, 0, 0.3), axis=(0, -1, 0), name="pin")
    places, size, stiffness, loss = {"left": -0.8, "right": 1.0}, 0.12, 1e4, 0.4
    for name, x in places.items():
        at = ((0, 0, 0), (x, 0, 0.3))
        model.sphere_plane_contact("ground", "lever", at=at, normal=(0, 0, 1), radius=size,
                                   stiffness=stiffness, hysteresis=loss, name=name)  # fmt: skip
    model.drive("pin", position=lw.functions.harmonic(0.25, 3.0))
    t = np.linspace(0.0, 2.0, frames)
    motion = lw.kinematics(model, t)
    angle, rate = 0.25 * np.sin(3 * t), 0.75 * np.cos(3 * t)
    for name, x in places.items():
        touch = np.arcsin((size - 0.3) / x)  # angle
        speed = abs(x) * np.cos(touch) * 0.75 * np.sqrt(1 - (touch / 0.25) ** 2)
        depth = np.maximum(size - 0.3 - x * np.sin(angle), 0.0)
        expected = stiffness * depth**1.5 * (1 - loss * x * np.cos(angle) * rate / speed)
        assert depth.max() > 0.01
        found = motion.force(name).force[:, 2]
        np.testing.assert_allclose(found, expected, atol=1e-8 * expected.max())


def test_work_that_frames_are_too_few_for_is_told() -> None:
    model = cranked(lw.functions.harmonic(1.0, 2 * np.pi))
    with pytest.warns(lw.LinkworkWarning, match="the work is about .* % off"):
        coarse = lw.kinematics(model, np.linspace(0, 2.0, 8))
    assert np.abs(coarse.energy_error).max() > 0.1 * coarse.kinetic_energy.max()
    fine = lw.kinematics(model, np.linspace(0, 2.0, 400))
    assert np.abs(fine.energy_error).max() < 1e-4 * fine.kinetic_energy.max()


@pytest.mark.parametrize("turn", [0.51, 0.5, 0.503, 0.999])
def test_work_over_times_at_which_accelerations_jump_is_what_the_bar_has(turn: float) -> None:
    """Driven at 60 rad/s2, then at -60: W = T + U at every frame, which a spline over the jump misses."""
    model = lw.Model()
    bar = model.body("bar", mass=1.0, inertia=(0.003, 0.03, 0.03), position=(0.3, 0, 0))
    model.revolute("ground", bar, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    acceleration = lw.functions.piecewise_polynomial([-1, turn, 9], [[60.0], [-60.0]])
    model.drive("hinge", acceleration=acceleration)
    result = lw.kinematics(model, np.linspace(0, 1, 201))
    t = result.t
    rate = np.where(t < turn, 60 * t, 60 * turn - 60 * (t - turn))
    after = np.maximum(t - turn, 0.0)
    angle = 30 * np.minimum(t, turn) ** 2 + 60 * turn * after - 30 * after**2
    expected = 0.5 * (0.03 + 0.09) * rate**2 - 9.81 * 0.3 * np.sin(angle)
    assert np.abs(result.work - expected).max() < 1e-4 * expected.max()


def struck_bar(jumps: list[float], rates: list[float], g: float = 9.81) -> lw.Model:
    """Hinged at its end, of moment of inertia 0.12; driven at `rates` from 0 and each of `jumps` on."""
    model = lw.Model(gravity=(0, 0, -g))
    bar = model.body("bar", mass=1.0, inertia=(0.003, 0.03, 0.03), position=(0.3, 0, 0))
    model.revolute("ground", bar, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
    pieces = [[rate] for rate in rates]
    velocity = lw.functions.piecewise_polynomial([-1, *jumps, 9], pieces)
    model.drive("hinge", velocity=velocity, name="drive")
    return model


@pytest.mark.parametrize("jumps", [[0.5], [0.503], [0.25, 0.7501], [0.505, 0.5051]])
@pytest.mark.parametrize("frames", [21, 201])
def test_work_over_blows_is_what_the_bar_has(jumps: list[float], frames: int) -> None:
    rates = [2.0, -1.0, 3.0][: len(jumps) + 1]
    with pytest.warns(lw.LinkworkWarning, match=rf"'drive'.* jumps by 3 at t = {jumps[0]} s.*: an impact"):
        result = lw.kinematics(struck_bar(jumps, rates), np.linspace(0, 1, frames))
    assert result.statistics["impacts"] == len(jumps)
    edges = [0.0, *jumps]
    rate = np.array(rates)[np.searchsorted(jumps, result.t, side="right")]
    ends = np.append(jumps, np.inf)
    angle = sum(w * np.clip(result.t - a, 0, b - a) for w, a, b in zip(rates, edges, ends, strict=True))
    gained = 0.06 * (rate**2 - rates[0] ** 2) - 9.81 * 0.3 * np.sin(angle)
    assert np.abs(result.work - gained).max() < (2e-3 if frames == 21 else 1e-7)
    assert list(result.t) == list(np.linspace(0, 1, frames))


def test_efforts_say_that_they_are_without_the_impulse_of_a_blow() -> None:
    """Without weight nothing else is needed: T = 0 beside the blow, which gives the bar its energy."""
    model = struck_bar([0.5], [0.0, 2.0], g=0.0)
    with pytest.warns(lw.LinkworkWarning, match="by 2 at t = 0.5 s: an impact, by .* efforts"):
        needed = lw.inverse_dynamics(model, np.linspace(0, 1, 101))
    assert np.abs(needed.effort("drive")).max() < 1e-12
    assert needed.motion.work[-1] == pytest.approx(0.24)
    assert "impacts: bodies struck 1 time at 0.5 s" in str(needed)
    assert "bodies struck 1 time at 0.5 s" in needed.motion.summary()


def test_blows_before_the_first_frame_are_not_told() -> None:
    needed = lw.inverse_dynamics(struck_bar([0.5], [0.0, 2.0]), np.linspace(0.6, 1, 11))
    assert "impacts" not in str(needed)


@pytest.mark.usefixtures("matrices")
@pytest.mark.parametrize("end", [0.5, 1.0, 1.0 + 2e-16])
def test_the_last_frame_at_a_break_is_of_what_comes_before_it(end: float) -> None:
    """A driver turns the bar by 3 rad/s and stops it at the end: it is not struck there yet, as in a run."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("bar", mass=1.0, inertia=(0.03, 0.03, 0.03), position=(0.3, 0, 0))
    model.revolute("ground", "bar", at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    knots = [[0.0, 3.0], [3.0 * round(end, 1), 0.0]]
    model.drive("pin", position=lw.functions.piecewise_polynomial([0.0, round(end, 1), 3.0], knots))
    t = np.append(np.linspace(0.0, 0.95 * end, 20), end)
    motion = lw.kinematics(model, t)
    energy = 0.5 * (1.0 * 0.3**2 + 0.03) * 3.0**2
    assert motion.kinetic_energy[-1] == pytest.approx(energy, rel=1e-12)
    assert motion.work[-1] - motion.work[0] == pytest.approx(0.0, abs=1e-12)
    assert motion.t[-1] == end


@pytest.mark.parametrize("size", [0.3, 1e-3])
@pytest.mark.parametrize("when", [0.5, 1.0])
def test_positions_that_jump_are_refused_by_every_analysis_and_run(size: float, when: float) -> None:
    model = struck_bar([], [0.0]).without("drive")
    step = lw.functions.piecewise_polynomial([-1, when, 9], [[0.0], [size]])
    model.drive("hinge", position=step, name="step")
    for run in (
        lambda: lw.kinematics(model, np.linspace(0, 1, 11)),
        lambda: lw.simulate(model, 1.0, 0.01),
        lambda: lw.simulate(model, 1.0, rtol=1e-6),
    ):
        with pytest.raises(lw.ModelError, match=rf"'step'.* jumps by {size:.4g} at t = {when:.6g} s"):
            run()


def folding(pairs: int) -> lw.Model:
    """Parallelograms of cranks of 0.3 m beside each other, all driven at 2 rad/s from 0.3 rad on."""
    model = lw.Model()
    for k in range(pairs):
        y, bodies = 0.5 * k, []
        start = lw.rotation.about((0, 1, 0), -0.3)
        along, up = 0.3 * np.cos(0.3), 0.3 * np.sin(0.3)
        for n, x in enumerate((0.0, 1.0)):
            crank = model.body(f"crank {k} {n}", mass=1.0, inertia=(0.01, 0.02, 0.02), orientation=start,
                               position=(x + along / 2, y, up / 2))  # fmt: skip
            model.revolute("ground", crank, at=(x, y, 0), axis=(0, -1, 0), name=f"shaft {k} {n}")
            bodies.append(crank)
        rod = model.body(f"rod {k}", mass=1.0, inertia=(0.01, 0.1, 0.1), position=(0.5 + along, y, up))
        for n, crank in enumerate(bodies):
            at = (n + along, y, up)
            model.revolute(crank, rod, at=at, axis=(0, -1, 0), name=f"pin {k} {n}")
        model.drive(f"shaft {k} 0", position=lw.functions.polynomial(0.0, 2.0), name=f"motor {k}")
    return model


@every_way
@pytest.mark.filterwarnings("ignore:kinematics. the work")
@pytest.mark.parametrize(("pairs", "frames"), [(1, 2), (1, 61), (2, 8), (3, 2), (3, 61)])
def test_poses_in_which_any_number_of_parallelograms_fold_are_told(pairs: int, frames: int) -> None:
    t_end = 3.5
    with pytest.warns(lw.LinkworkWarning, match=r"singular pose at t = (1.420|2.99)"):
        result = lw.kinematics(folding(pairs), np.linspace(0, t_end, frames))
    folds = [(np.pi - 0.3) / 2, (2 * np.pi - 0.3) / 2]
    assert [pose.t for pose in result.singular_poses] == pytest.approx(folds, abs=1e-5)
    rod = result.body("rod 0").position
    assert rod[:, 2] == pytest.approx(0.3 * np.sin(0.3 + 2 * result.t), abs=1e-9)
    with pytest.raises(lw.SingularSystemError, match=r"singular pose at t = 1.420"):
        lw.kinematics(folding(pairs), np.linspace(0, t_end, frames), on_singular="stop")


@every_way
@pytest.mark.filterwarnings("ignore:kinematics. the work")
@pytest.mark.parametrize("times", [[0.0, 1.0, 2.0], [0.2, 1.0], np.linspace(0, 2, 21)])
def test_what_drivers_do_between_two_frames_counts(times: Sequence[float]) -> None:
    """A turn of 0.3 s between two rests, halved by a belt, winds a spring by a turn."""
    model = lw.Model(gravity=(0, 0, 0))
    for name, x in (("a", 0.0), ("b", 3.0)):
        wheel = model.body(name, mass=1.0, inertia=(0.01, 0.02, 0.03), position=(x, 0, 0))
        model.revolute("ground", wheel, at=(x, 0, 0), axis=(0, 0, 1), name=f"pin {name}")
    model.coupler([("pin a", 0.5), ("pin b", -1.0)], name="belt")
    model.rotational_spring_damper("ground", "a", at=(0, 0, 0), axis=(0, 0, 1), stiffness=1.0, name="spring")
    model.drive("pin a", position=lw.functions.cycloidal(2 * np.pi, 0.3, start=0.25), name="drive")
    effort = lw.inverse_dynamics(model, times)
    k = list(times).index(1.0) if 1.0 in times else -1
    assert effort.motion.body("b").orientation[k] == pytest.approx((0, 0, 0, 1), abs=1e-9)
    assert effort.effort("drive")[k] == pytest.approx(2 * np.pi, abs=1e-9)


def test_a_dead_point_before_the_first_frame_is_told_as_such() -> None:
    """Beyond a break of the driver, beside which the motion is known."""
    model, lift = lw.Model(gravity=(0, 0, 0)), 0.25
    pin, end = np.array([0.0, 0, lift]), np.array([np.sqrt(1 - lift**2), 0, 0])
    for name, at in (("crank", pin / 2), ("rod", (pin + end) / 2), ("slider", end)):
        model.body(name, mass=1.0, inertia=(0.01, 0.02, 0.02), position=at)
    model.revolute("ground", "crank", at=(0, 0, 0), axis=(0, 1, 0))
    model.revolute("crank", "rod", at=pin, axis=(0, 1, 0))
    model.revolute("rod", "slider", at=end, axis=(0, 1, 0))
    model.translational("ground", "slider", at=end, axis=(1, 0, 0), name="guide")
    push = lw.functions.piecewise_polynomial([-1, 0.1, 9], [[0.2], [1.0]])
    model.drive("guide", velocity=push)
    dead = 0.1 + (1 + lift - end[0] - 0.02) / 1.0
    with pytest.raises(lw.NotConvergedError, match="a dead point") as told:
        lw.kinematics(model, [2.0, 3.0])
    assert told.value.result is None and told.value.state.t == pytest.approx(dead, abs=1e-6)
    with pytest.warns(lw.LinkworkWarning, match="an impact"), pytest.raises(lw.NotConvergedError) as later:
        lw.kinematics(model, [0.05, 2.0])
    assert list(later.value.result.t) == [0.05]


def test_short_steps_of_a_long_way_are_no_dead_point(monkeypatch: pytest.MonkeyPatch) -> None:
    """A wheel turns to and fro between two frames: each step is a small part of the way, and goes on."""
    monkeypatch.setattr(continuation, "MOST_TINY", 5)
    monkeypatch.setattr(continuation, "TINY", 0.1)
    model = lw.Model()
    model.body("wheel", mass=1.0, inertia=(0.1, 0.1, 0.1))
    model.revolute("ground", "wheel", at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    model.drive("pin", position=lw.functions.harmonic(20.0, 1.0))
    motion = continuation.Continuation(Equations(model), 3.0)
    motion.prepare()
    motion.begin()
    motion.go_to(3.0)
    assert 2 * np.arctan2(motion.at.q[6], motion.at.q[3]) % np.pi == pytest.approx(
        20 * np.sin(3.0) % np.pi, abs=1e-12
    )
