"""Singular poses are passed on the branch of the motion, at every step: a part of the benchmark."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import _core, mechanisms
from linkwork.running.estimation import unjudged
from scipy.integrate import solve_ivp

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))

import singular_poses
from planar_branches import BRANCHES

#: [rad/s]
TURNS = 2 * np.pi
SIZES = {True: (1e-6, 1e-8, 1e-10, 1e-12), False: (1e-3, 1e-4)}

#: Without those of linear solvers that are not in this build.
AVAILABLE = {info.name for info in _core.linear_solvers() if info.available} | {"auto"}
METHODS = [
    name
    for name, options in singular_poses.METHODS.items()
    if options.get("linear_solver", "auto") in AVAILABLE
]


@pytest.mark.parametrize("branch", BRANCHES)
@pytest.mark.parametrize("method", METHODS)
def test_energy_and_branch_are_kept_through_singular_poses(method: str, branch: str) -> None:
    """Of random speeds, and of poses within 1e-12 .. 1e-6 s of the end or the middle of a step."""
    rng = np.random.default_rng(len(method) + 100 * len(branch))
    for k, size in enumerate(SIZES[method in singular_poses.ADAPTIVE]):
        share = 0.4 if size == 1e-4 else 1.0
        case = singular_poses.one_case(BRANCHES[branch], method, size, 2 * k + 1, rng, share)
        with unjudged():
            found = singular_poses.run(case, always=False)
        assert not found.failure, found
        assert found.energy <= singular_poses.allowed(method, size), found
        assert found.crossings == found.expected, found
        assert found.right, found  # on the same branch


@pytest.mark.parametrize("step", [1e-4, 5e-5, 2.5e-5])
def test_a_smaller_step_is_not_worse(step: float) -> None:
    """Steps of a grid one of whose points is within 1e-7 s of a singular pose, at t = 0.70845."""
    result = lw.simulate(mechanisms.four_bar(1), 1.0, step, record_every=100, progress=False)
    assert np.abs(result.energy_error).max() <= 1e-10 * 21.0
    assert [it.t for it in result.singular_poses] == pytest.approx([0.70845], abs=1e-5)


def test_frames_beside_a_pose_have_the_accelerations_of_the_branch() -> None:
    """Of rods of 1 m and 1 kg: theta_ddot = -2 g cos(theta) / (2/3 + 1) m,
    from the horizontal; the frame at the pose is none of roundoff."""
    result = lw.simulate(mechanisms.four_bar(1), 0.72, 1e-4, progress=False)
    near = np.abs(result.t - 0.70845) < 2e-3
    up = result.orientation[near, 0]
    theta = 2 * np.arctan2(up[:, 3], up[:, 0])  # of the post's x axis, from x
    expected = -1.2 * 9.81 * np.cos(theta)
    assert np.abs(result.angular_acceleration[near, 0, 2] - expected).max() <= 1e-6 * 9.81


@pytest.mark.parametrize(
    ("branch", "integrator", "speed", "pose_at", "t_end"),
    [
        (
            "four-bar",
            "dopri5",
            3.8688720920343838,
            0.8203426236068507,
            3.102,
        ),  # foreseen at half of its distance
        ("folding six-bar", "dop853", 1.8382548011524078, 1.2891294118474574, 6.0),
    ],
)
def test_frames_within_leaps_are_as_accurate_as_the_steps(
    branch: str, integrator: str, speed: float, pose_at: float, t_end: float
) -> None:
    """Many times a leap, at a tolerance of 1e-12: energy to 1e-10, constraints as away from poses."""
    case = singular_poses.Case(branch, integrator, 1e-12, speed, pose_at, t_end, 0)
    it = BRANCHES[branch]
    start = it.flow(np.array([it.singular, speed]), np.array([-pose_at]))[-1]
    result = lw.simulate(
        it.model(start), case.t_end, rtol=1e-12, atol=1e-12, times=np.linspace(0, t_end, 2001),
        progress=False, integrator=integrator,
    )  # fmt: skip
    scale = result.kinetic_energy.max()
    assert np.abs(result.energy_error).max() <= 1e-10 * scale
    near = np.abs(result.t[:, None] - [pose.t for pose in result.singular_poses]).min(axis=1) < 0.02
    away = result.violation[~near, 0].max()
    assert result.violation[near, 0].max() <= max(10 * away, 1e-12)


@pytest.mark.parametrize(
    ("branch", "method", "size", "speed", "pose_at", "t_end"),
    [
        # another singular value is the least one until a third of a step before the pose
        ("antiparallelogram", "dop853", 1e-8, 3.322064534339467, 0.5179777173089074, 3.612),
        # a leap beside a pose, which was foreseen too far ahead, ended in it
        ("unequal", "dopri5", 1e-12, -4.172880152871395, 0.526334175230137, 2.876),
    ],
)
def test_no_step_ends_in_a_pose_that_was_foreseen_badly(
    branch: str, method: str, size: float, speed: float, pose_at: float, t_end: float
) -> None:
    """A pose may be nearer than the least singular values and pivots say from far."""
    found = singular_poses.run(singular_poses.Case(branch, method, size, speed, pose_at, t_end, 0))
    assert found.right and not found.sensitivity, found
    assert found.energy <= 10 * size


@pytest.mark.parametrize("after", [-2e-3, -1e-5, -1e-7, 1e-7, 1e-5, 4.5e-5, 3e-4, 2e-3])
@pytest.mark.parametrize(
    "options", [{"step": 1e-3}, {"step": 1e-4}, {"rtol": 1e-9}, {"rtol": 1e-10}], ids=str
)
@pytest.mark.parametrize("load", [False, True])
def test_a_run_may_end_beside_a_pose(load: bool, options: dict[str, float], after: float) -> None:
    """As if it went on: with a load of the user's own, which nobody asks for values beyond the end."""
    t_end = 0.70845001 + after
    model = mechanisms.four_bar(1)
    asked = [0.0]

    def no_load(t: float, _angle: float, _rate: float) -> float:
        asked.append(t)
        return 0.0

    if load:
        model.joint_force("pin 0", no_load)
    result = lw.simulate(model, t_end, progress=False, **options)
    assert max(asked) <= t_end
    assert np.abs(result.energy_error).max() <= 1e-8 * 21.0
    assert len(result.singular_poses) == (after > 0)
    theta = 2 * np.arctan2(result.orientation[-1, 0, 3], result.orientation[-1, 0, 0])
    expected = -1.2 * 9.81 * np.cos(theta)
    tolerance = 1e-5 if load else 1e-6  # a leap ends with the run: no node beyond the pose, or none in it
    assert abs(result.angular_acceleration[-1, 0, 2] - expected) <= tolerance * 9.81


def parallelogram(model: lw.Model, place: float, theta: float, rate: float) -> None:
    """Three rods of 1 m that turn by `rate` [rad/s], at `theta` from being in line."""
    along, across = np.array([np.cos(theta), np.sin(theta), 0]), np.array([-np.sin(theta), np.cos(theta), 0])
    inertia, ends = mechanisms.thin_rod(1.0, 1.0), [np.array([place + k, 0.0, 0.0]) for k in (0, 1)]
    pose = lw.rotation.from_axes(x=along, y=across)
    turn = {"orientation": pose, "velocity": rate * across / 2, "omega": (0, 0, rate)}
    bars = [model.body(mass=1.0, inertia=inertia, position=end + along / 2, **turn) for end in ends]
    middle = ends[0] + along + np.array((0.5, 0, 0))
    beam = model.body(mass=1.0, inertia=inertia, position=middle, velocity=rate * across)
    for bar, end in zip(bars, ends, strict=True):
        model.revolute(model.ground, bar, at=end, axis=(0, 0, 1))
        model.revolute(bar, beam, at=end + along, axis=(0, 0, 1))


@pytest.mark.parametrize("theta", [0.005, 0.05, -0.02])
def test_a_start_beside_a_pose_asks_a_users_load_only_where_the_motion_goes(theta: float) -> None:
    model = lw.Model(gravity=(0, 0, -9.81))
    parallelogram(model, 0.0, theta, -1.5)
    asked: list[float] = []

    def load(_t: float, angle: float, _rate: float) -> float:
        asked.append(angle)
        return 0.0

    model.joint_force("revolute 1", load)
    result = lw.simulate(model, 1e-3, step=1e-5, progress=False)
    assert np.ptp(asked) == pytest.approx(1.5e-3, abs=1e-6)
    expected = lw.System(model).accelerations(0.0, result.q[0], result.v[0])[0]
    assert result.recorded("vdot")[0].ravel() == pytest.approx(np.ravel(expected), abs=1e-12)


def struck_parallelogram(start: float, torque: float = 200.0, told: str = "force") -> lw.Model:
    """In line at 1/3 s; a torque [N m] for 5 ms from `start` on, whose breaks the function, the `force` or
    nobody but the `run` knows."""
    model = lw.Model(gravity=(0, 0, 0))
    parallelogram(model, 0.0, 0.5, -1.5)
    end = start + 5e-3
    table = lw.functions.piecewise_polynomial([-1, start, end, 9], [[0], [torque], [0]])
    pulse = table if told == "function" else lambda t: torque * (start <= t < end)
    model.force("body 1", torque=(0, 0, pulse), breaks=(start, end) if told == "force" else ())
    return model


@pytest.mark.parametrize("told", ["function", "force", "run"])
@pytest.mark.parametrize("start", [0.3295, 0.3332, 0.33343, 0.338])
def test_fixed_steps_do_not_leap_over_breaks(start: float, told: str) -> None:
    """By 5/3 kg m2 the torque adds 0.6 rad/s: up to what one step of it does, as away from poses."""
    breaks = (start, start + 5e-3) if told == "run" else ()
    options = {"step": 1e-4, "breaks": breaks, "on_inaccurate": "pass", "progress": False}
    result = lw.simulate(struck_parallelogram(start, told=told), 0.4, **options)
    assert result.omega[-1, 0, 2] == pytest.approx(-1.5 + 0.6, abs=200 * 1e-4 / (5 / 3))
    assert len(result.singular_poses) == 1


@pytest.mark.parametrize("middle", [0.325, 0.3334, 0.341])
def test_fixed_steps_do_not_leap_over_narrow_forces(middle: float) -> None:
    """Smooth, known to nobody: of some steps, it fits between the nodes of a leap. It gives 1 N m s."""
    model, width = lw.Model(gravity=(0, 0, 0)), 4e-4
    parallelogram(model, 0.0, 0.5, -1.5)
    model.force(
        "body 1", torque=(0, 0, lambda t: np.exp(-(((t - middle) / width) ** 2)) / (width * np.pi**0.5))
    )
    result = lw.simulate(model, 0.4, 1e-4, progress=False)
    assert result.omega[-1, 0, 2] == pytest.approx(-1.5 + 0.6, abs=1e-5)
    assert len(result.singular_poses) == 1


def test_fixed_steps_do_not_leap_over_narrow_motions_of_drivers() -> None:
    model, middle, width = lw.Model(gravity=(0, 0, 0)), 0.325, 1e-3
    parallelogram(model, 0.0, 0.5, -1.5)
    cart = model.body("cart", mass=1.0, inertia=(1, 1, 1), position=(0, 0, 3))
    along = {"at": (0, 0, 3), "axis": (1, 0, 0)}
    model.translational("ground", cart, **along)

    def bump(t: float) -> float:
        return float(1e-3 * np.exp(-(((t - middle) / width) ** 2)))

    def speed(t: float) -> float:
        return -2 * (t - middle) / width**2 * bump(t)

    def acceleration(t: float) -> float:
        return (4 * ((t - middle) / width**2) ** 2 - 2 / width**2) * bump(t)

    model.displacement_driver("ground", cart, **along, displacement=(bump, speed, acceleration))
    result = lw.simulate(model, 0.4, 1e-4, progress=False)
    assert result.position[:, -1, 0] == pytest.approx([bump(t) for t in result.t], abs=2e-7)


def stiffening_parallelogram(*times: float) -> lw.Model:
    """In line at 1/3 s; soft springs become stiffer after these times."""
    model = lw.Model(gravity=(0, 0, 0))
    parallelogram(model, 0.0, 0.5, -1.5)
    for t in times:
        stiffness = (lambda now, t=t: 1.0 if now > t else 0.2), lambda now: 0.0, lambda now: 0.0
        model.rotational_spring_damper(
            "ground", "body 1", at=(0, 0, 0), axis=(0, 0, 1), free_angle=0.3, name=f"spring of {t!r}",
            stiffness=lw.functions.with_breaks(stiffness, [t]),
        )  # fmt: skip
    return model


@pytest.mark.parametrize("start", [0.3, 0.335])
@pytest.mark.parametrize("apart", [False, True])
def test_a_leap_that_begins_at_a_break_is_of_what_comes_after_it(start: float, apart: bool) -> None:
    """Also where several functions break there, up to roundoff."""
    times = [start, start + 1e-16] if apart else [start]
    model = stiffening_parallelogram(*times)
    for rtol in (1e-4, 1e-8):
        result = lw.simulate(model, 0.4, rtol=rtol, times=[0.2, start, 0.4], progress=False)
        stored = sum(result.force(f"spring of {t!r}").potential for t in times)
        np.testing.assert_allclose(result.potential_energy, stored, rtol=1e-12)
        assert np.abs(result.energy_error).max() < rtol
        assert len(result.singular_poses) == 1


@pytest.mark.parametrize("after", [1e-3, 0.01, 0.02])
def test_a_pose_in_a_step_that_a_break_ends_is_listed(after: float) -> None:
    result = lw.simulate(stiffening_parallelogram(1 / 3 + after), 0.4, rtol=1e-8, progress=False)
    assert [it.t for it in result.singular_poses] == pytest.approx([1 / 3], abs=5e-3)


def test_ensembles_do_not_leap_over_breaks_either() -> None:
    models = [struck_parallelogram(0.338, torque, "run") for torque in (0.0, 100.0, 200.0)]
    options = {"step": 1e-3, "breaks": (0.338, 0.343), "deterministic": True, "progress": False}
    found = lw.simulate_many(models, None, 0.4, threads=1, on_inaccurate="pass", **options)
    assert found.alone == {}
    alone = lw.simulate(models[2], 0.4, on_inaccurate="pass", **options)
    assert found.member(2).omega[-1].tolist() == alone.omega[-1].tolist()
    assert alone.omega[-1, 0, 2] == pytest.approx(-1.5 + 0.6, abs=0.12)


@pytest.mark.parametrize("options", [{"step": 1e-3}, {"step": 5e-3}, {"rtol": 1e-4}, {"rtol": 1e-8}], ids=str)
@pytest.mark.parametrize("apart", [0.005, 0.03, 0.06, 0.15])
def test_poses_of_independent_loops_are_all_listed(apart: float, options: dict[str, float]) -> None:
    """Two parallelograms that know nothing of each other, in line at 1 s and `apart` [s] later."""
    model = lw.Model(gravity=(0, 0, -9.81))
    for place, passes in ((0.0, 1.0), (5.0, 1.0 + apart)):
        parallelogram(model, place, 1.5 * passes, -1.5)
    result = lw.simulate(model, 2.0, progress=False, **options)
    assert [it.t for it in result.singular_poses] == pytest.approx([1.0, 1.0 + apart], abs=1e-4)


@pytest.mark.parametrize(
    "options",
    [{"step": 1e-2}, {"step": 2e-3}, {"rtol": 1e-4}, {"rtol": 1e-6}, {"rtol": 1e-6, "integrator": "dop853"}],
    ids=str,
)
@pytest.mark.parametrize("theta", [0.8, 1.5])
def test_a_linkage_that_is_always_near_a_pose_hides_none_of_another(
    theta: float, options: dict[str, Any]
) -> None:
    alone, beside = lw.Model(gravity=(0, -9.81, 0)), lw.mechanisms.strandbeest_leg()
    found = []
    for model in (alone, beside):
        parallelogram(model, 5.0, theta, -1.5)
        result = lw.simulate(model, 3.0, progress=False, on_inaccurate="pass", **options)
        found.append([it.t for it in result.singular_poses])
    assert len(found[0]) > 3
    assert found[1] == pytest.approx(found[0], abs=2e-3)


def steady_parallelogram(ahead: float = 0.0, driven: bool = False, size: float = 1.0) -> lw.Model:
    """Bars of 1 kg and this size [m] turn once a second, upright but for `ahead` [rad] at the start, without
    weight: each pin of the rod carries half of what its path on a circle takes."""
    model = lw.Model(gravity=(0, 0, 0))
    upright, inertia = np.array((-np.sin(ahead), 0, np.cos(ahead))), mechanisms.thin_rod(1.0, size)
    turned, along = lw.rotation.from_axes(x=upright, y=(0, 1, 0)), size * upright
    across = np.cross((0, -TURNS, 0), along)
    for name, x in (("a", 0.0), ("b", size)):
        foot = np.array((x, 0, 0))
        model.body(name, mass=1.0, inertia=inertia, position=foot + along / 2, velocity=across / 2,
                   orientation=turned, omega=(0, -TURNS, 0))  # fmt: skip
    model.body("rod", mass=1.0, inertia=inertia, position=along + np.array((size / 2, 0, 0)), velocity=across)
    for name, x in (("a", 0.0), ("b", size)):
        model.revolute("ground", name, at=(x, 0, 0), axis=(0, 1, 0), name=f"foot {name}")
        model.revolute(name, "rod", at=along + np.array((x, 0, 0)), axis=(0, 1, 0), name=f"top {name}")
    if driven:
        model.drive("foot a", velocity=-TURNS)
    return model


def error_of_pins(result: lw.Result, ahead: float = 0.0) -> float:
    """Largest of any frame, relative to the force."""
    angle = ahead + TURNS * result.t
    inward = -(TURNS**2) / 2 * np.stack([-np.sin(angle), 0 * angle, np.cos(angle)], axis=1)
    errors = [result.reaction(pin).force - inward for pin in ("top a", "top b")]
    return float(np.abs(errors).max() / (TURNS**2 / 2))


@pytest.mark.parametrize("driven", [False, True], ids=["free", "driven"])
@pytest.mark.parametrize("ahead", [0.0, 1e-7, -1e-5, 1e-4])
@pytest.mark.parametrize("steps", [8, 13, 25, 40])
def test_frames_in_and_beside_singular_poses_have_the_forces_of_the_motion(
    steps: int, ahead: float, driven: bool
) -> None:
    """A step ends where the bars are flat, or almost: the equations there tell nothing of forces in pins."""
    result = lw.simulate(
        steady_parallelogram(ahead, driven), 1.0, 0.25 / steps, record_every=1, progress=False
    )
    assert [pose.t for pose in result.singular_poses] == pytest.approx([0.25, 0.75], abs=1e-4)
    assert error_of_pins(result, ahead) <= max(1e-3, 3 * result.verdict.error)


@pytest.mark.parametrize("driven", [False, True], ids=["free", "driven"])
@pytest.mark.parametrize("ahead", [0.0, -1e-6, 1e-4, 1e-2])
@pytest.mark.parametrize("rtol", [1e-4, 1e-6, 1e-8])
@pytest.mark.parametrize("integrator", ["dopri5", "dop853"])
def test_frames_between_long_steps_do_in_singular_poses(
    integrator: str, rtol: float, ahead: float, driven: bool
) -> None:
    options = {"integrator": integrator, "rtol": rtol, "times": np.linspace(0, 1, 101), "progress": False}
    result = lw.simulate(steady_parallelogram(ahead, driven), 1.0, **options, on_inaccurate="pass")
    assert error_of_pins(result, ahead) <= max(2e-3, 3 * result.verdict.error)


@pytest.mark.parametrize("driven", [False, True], ids=["free", "driven"])
@pytest.mark.parametrize("size", [1e-6, 1e6])
def test_leaps_are_the_same_whatever_the_unit_of_length(size: float, driven: bool) -> None:
    runs = [
        lw.simulate(steady_parallelogram(1e-3, driven, it), 1.0, 1e-3, progress=False) for it in (1.0, size)
    ]
    one, other = (run.statistics["evaluations"] for run in runs)
    assert other == pytest.approx(one, rel=0.02)


def test_members_of_ensembles_too() -> None:
    models = [steady_parallelogram(ahead) for ahead in (0.0, 1e-6, 1e-4)]
    found = lw.simulate_many(models, None, 0.5, 0.0125, threads=1, progress=False)
    for k, ahead in enumerate((0.0, 1e-6, 1e-4)):
        assert error_of_pins(found.member(k), ahead) <= 1e-3


def flat_parallelogram(rocker: float) -> lw.Model:
    """Crank and rocker of 1 m on one line, the crank at 3 rad/s: D v = 0 with any rate of the rocker."""
    model = lw.Model(gravity=(0, -9.81, 0))

    def bar(name: str, x: float, omega: float, velocity: float) -> lw.Body:
        return model.body(
            name,
            mass=1.0,
            inertia=(0.1, 0.2, 0.25),
            position=(x, 0, 0),
            omega=(0, 0, omega),
            velocity=(0, velocity, 0),
        )

    crank, rod = bar("crank", 0.5, 3.0, 1.5), bar("rod", 2.0, (rocker - 3.0) / 2, (rocker + 3.0) / 2)
    end = bar("rocker", 2.5, rocker, rocker / 2)
    for a, b, x in ((model.ground, crank, 0), (crank, rod, 1), (rod, end, 3), (end, model.ground, 2)):
        model.revolute(a, b, at=(x, 0, 0), axis=(0, 0, 1), name=f"pin {x}")
    return model


CHOICES = [
    {"step": 1e-3},
    {"rtol": 1e-8},
    {"step": 1e-3, "formulation": "penalty"},
    {"step": 1e-3, "formulation": "augmented_lagrangian"},
    {"step": 1e-3, "linear_solver": "eigen_ldlt"},
]


@pytest.mark.parametrize("options", CHOICES, ids=str)
@pytest.mark.parametrize("rocker", [-1.0, 1.5])
def test_velocities_of_no_branch_are_refused_in_a_singular_pose(
    rocker: float, options: dict[str, object]
) -> None:
    with pytest.raises(lw.SingularSystemError, match="velocities that belong to none of them") as caught:
        lw.simulate(flat_parallelogram(rocker), 1.0, progress=False, **options)
    assert caught.value.code == "no_branch"


@pytest.mark.parametrize("options", CHOICES, ids=str)
@pytest.mark.parametrize("rocker", [3.0, -9.0])
def test_a_run_leaves_a_singular_pose_on_the_branch_of_its_velocities(
    rocker: float, options: dict[str, object]
) -> None:
    """As a parallelogram, or crossed: 2 m apart it turns by -3 times the crank's rate there."""
    result = lw.simulate(flat_parallelogram(rocker), 0.3, progress=False, **options)
    assert np.abs(result.energy_error).max() <= 1e-6
    turns = [2 * np.arctan2(result.orientation[-1, k, 3], result.orientation[-1, k, 0]) for k in (0, 2)]
    assert np.sign(turns[0] * turns[1]) == np.sign(rocker)


def folded_parallelogram(
    masses: tuple[float, float, float],
    omega: float = 0.0,
    gravity: tuple[float, float, float] = (0, 0, -9.81),
    away: float = 0.0,
) -> lw.Model:
    """Bars of 1 m on one line, crank and rocker 2 m apart at `omega` [rad/s] as those of a parallelogram."""
    model = lw.Model(gravity=gravity)
    for name, mass, x, turn, rise in zip(
        ("crank", "rod", "rocker"), masses, (-0.5, -0.5, 0.5), (omega, 0, omega), (0.5, 1, 0.5), strict=True
    ):
        model.body(
            name,
            mass=mass,
            inertia=(0.001, 0.08, 0.081),
            position=(away + x, -away, 0.3 * away),
            omega=(0, turn, 0),
            velocity=(0, 0, rise * omega),
        )
    for a, b, x in (
        ("ground", "crank", 0),
        ("crank", "rod", -1),
        ("rod", "rocker", 0),
        ("ground", "rocker", 1),
    ):
        model.revolute(a, b, at=(away + x, -away, 0.3 * away), axis=(0, 1, 0), name=f"{a}-{b}")
    return model


ANY_METHOD = [
    {"step": 1e-3},
    {"step": 1e-4, "integrator": "ab4"},
    {"step": 1e-3, "integrator": "hem4"},
    {"rtol": 1e-6, "integrator": "dop853"},
    {"step": 1e-3, "formulation": "penalty"},
    {"step": 1e-3, "formulation": "penalty", "linear_solver": "eigen_ldlt"},
]


@pytest.mark.parametrize("options", ANY_METHOD, ids=str)
def test_rest_from_which_several_motions_are_possible_is_refused(options: dict[str, Any]) -> None:
    """The parallelogram falls, or crank and rod as one arm: nothing says which."""
    model = folded_parallelogram((3.0, 0.2, 0.7))
    with pytest.raises(lw.SingularSystemError, match="several motions are possible from rest") as caught:
        lw.simulate(model, 0.3, progress=False, **options)
    assert caught.value.code == "several_motions" and caught.value.time == 0.0
    assert set(caught.value.joints) == {"ground-crank", "crank-rod", "rod-rocker", "ground-rocker"}


def test_members_of_ensembles_that_may_leave_rest_in_several_ways_are_refused() -> None:
    models = [folded_parallelogram((3.0, 0.2, 0.7)), folded_parallelogram((3.0, 0.2, 0.7), 1.0)]
    found = lw.simulate_many(models, None, 0.1, 1e-3, progress=False)
    assert found.errors[0]["code"] == "several_motions"
    assert list(found.errors) == [0]


@pytest.mark.parametrize("masses", [(3.0, 0.2, 0.7), (1.0, 1.0, 1.0)])
@pytest.mark.parametrize("gravity", [(9.81, 0, 0), (0, 0, 0)], ids=["along", "none"])
def test_rest_in_equilibrium_in_a_singular_pose_goes_on(
    masses: tuple[float, float, float], gravity: tuple[float, float, float]
) -> None:
    result = lw.simulate(folded_parallelogram(masses, gravity=gravity), 0.1, 1e-2, progress=False)
    assert np.abs(result.v[-1]).max() <= 1e-12


def stretched(lengths: tuple[float, ...], gravity: tuple[float, float, float]) -> lw.Model:
    """Bars on one line as long as the way between their held ends."""
    model = lw.Model(gravity=gravity)
    x, last = 0.0, "ground"
    for i, length in enumerate(lengths):
        bar = model.body(f"bar {i}", mass=1, inertia=(0.01, 0.1, 0.1), position=(x + 0.5 * length, 0, 0))
        model.revolute(last, bar, at=(x, 0, 0), axis=(0, 1, 0))
        x, last = x + length, bar.name
    model.revolute(last, "ground", at=(x, 0, 0), axis=(0, 1, 0), name="end")
    return model


@pytest.mark.parametrize("options", [*ANY_METHOD, {"rtol": 1e-8}], ids=str)
@pytest.mark.parametrize("lengths", [(1.0, 1.0), (1.0, 0.3, 2.0), (0.5, 1.0, 1.0, 0.7, 0.2)], ids=len)
def test_loads_that_no_reactions_hold_are_refused(
    lengths: tuple[float, ...], options: dict[str, Any]
) -> None:
    """A toggle stretched to the full holds a load across it with infinite forces."""
    with pytest.raises(lw.SingularSystemError, match="no finite reactions hold it") as caught:
        lw.simulate(stretched(lengths, (0, 0, -9.81)), 0.1, progress=False, **options)
    assert caught.value.code == "no_motion" and "end" in caught.value.joints


def test_loads_along_a_stretched_toggle_are_held() -> None:
    result = lw.simulate(stretched((1.0, 0.3, 2.0), (9.81, 0, 0)), 0.1, 1e-2, progress=False)
    assert np.abs(result.v).max() <= 1e-12


def fall(masses: tuple[float, float, float], omega: float, t_end: float) -> float:
    """Rate of the parallelogram [rad/s] that leaves the line with omega."""
    crank, rod, rocker = masses
    weight, inertia = 0.5 * (crank + rocker) + rod, 0.16 + 0.25 * (crank + rocker) + rod
    found = solve_ivp(
        lambda _, y: (y[1], -weight * 9.81 * np.cos(y[0]) / inertia),
        (0, t_end),
        (0.0, omega),
        rtol=1e-11,
        atol=1e-12,
    )
    return float(found.y[1, -1])


def test_rest_is_left_by_the_branch_on_which_reactions_are_finite() -> None:
    masses = (1.0, 1.0, 1.0)
    result = lw.simulate(folded_parallelogram(masses), 0.2, 1e-3, progress=False)
    assert result.omega[-1, [0, 2], 1] == pytest.approx(fall(masses, 0.0, 0.2), rel=1e-6)


@pytest.mark.parametrize("options", [{"step": 1e-3}, {"rtol": 1e-8}], ids=str)
@pytest.mark.parametrize("omega", [0.1, 0.03, 0.01, 1e-3, -1e-3, -0.01])
@pytest.mark.parametrize("masses", [(1.0, 1.0, 1.0), (3.0, 0.2, 0.7)])
def test_slow_velocities_of_a_branch_decide_as_fast_ones_do(
    masses: tuple[float, float, float], omega: float, options: dict[str, Any]
) -> None:
    """Those that rise are turned back by the weights, and come through the pose once more."""
    result = lw.simulate(folded_parallelogram(masses, omega), 0.2, progress=False, **options)
    assert result.omega[-1, [0, 2], 1] == pytest.approx(fall(masses, omega, 0.2), rel=1e-5)
    assert result.omega[-1, 1, 1] == pytest.approx(0.0, abs=1e-5)


#: Masses [kg] and inertias about the axes of the pins [kg m^2] of a crank of 1 m, a rod of 1 m and a slider.
CRANK, ROD, SLIDER, OF_CRANK, OF_ROD = 1.3, 0.8, 0.6, 0.11, 0.07


def equal_slider_crank(turn: float, omega: float, slides: bool, gravity: tuple[float, float]) -> lw.Model:
    """At `turn` [rad] from the pose with the slider over the pivot: it slides, or crank and rod are one."""
    c, s = -np.sin(turn), np.cos(turn)
    pin, speed = np.array([c, 0, s]), omega * np.array([-s, 0, c])
    end, of_end = slides * np.array([2 * c, 0, 0]), slides * omega * np.array([-2 * s, 0, 0])
    model = lw.Model(gravity=(gravity[0], 0, gravity[1]))

    def bar(name: str, mass: float, inertia: float, ends: Any, speeds: Any, rate: float) -> None:
        model.body(
            name,
            mass=mass,
            inertia=(0.01, inertia, inertia),
            position=sum(ends) / 2,
            orientation=lw.rotation.from_axes(ends[0] - ends[1], (0, 1, 0)),
            velocity=sum(speeds) / 2,
            omega=(0, -rate, 0),
        )

    bar("crank", CRANK, OF_CRANK, (pin, 0 * pin), (speed, 0 * speed), omega)
    bar("rod", ROD, OF_ROD, (pin, end), (speed, of_end), -omega if slides else omega)
    model.body("slider", mass=SLIDER, inertia=(0.01, 0.01, 0.01), position=end, velocity=of_end)
    for a, b, at in (("ground", "crank", 0 * pin), ("crank", "rod", pin), ("rod", "slider", end)):
        model.revolute(a, b, at=at, axis=(0, 1, 0))
    model.translational("ground", "slider", at=end, axis=(1, 0, 0))
    return model


def rate_of_crank(
    turn: float, omega: float, slides: bool, gravity: tuple[float, float], t_end: float
) -> float:
    """[rad/s], of the branch as a mechanism of its own."""

    def rates(_: float, y: Any) -> tuple[float, float]:
        c, s = -np.sin(y[0]), np.cos(y[0])
        if not slides:
            inertia, slope = OF_CRANK + CRANK / 4 + OF_ROD + ROD / 4, 0.0
            load = (CRANK + ROD) / 2 * (gravity[1] * c - gravity[0] * s)
        else:
            inertia = OF_CRANK + CRANK / 4 + OF_ROD + ROD * (2.25 * s * s + 0.25 * c * c) + 4 * SLIDER * s * s
            slope = (4 * ROD + 8 * SLIDER) * s * c
            load = (CRANK + ROD) / 2 * gravity[1] * c - (CRANK / 2 + 1.5 * ROD + 2 * SLIDER) * gravity[0] * s
        return y[1], (load - slope * y[1] ** 2 / 2) / inertia

    return float(solve_ivp(rates, (0, t_end), (turn, omega), rtol=1e-11, atol=1e-13).y[1, -1])


@pytest.mark.parametrize("options", [{"rtol": 1e-4}, {"rtol": 1e-6}, {"rtol": 1e-9}, {"step": 1e-3}], ids=str)
@pytest.mark.parametrize(
    ("turn", "omega", "slides", "gravity"),
    [
        (-3e-5, 0.03, False, (9.81, 0)),
        (-1e-5, 0.01, False, (3, -5)),
        (-1e-5, 0.01, True, (3, -5)),
        (-1e-4, 0.1, False, (9.81, 0)),
        (0, 1e-3, False, (3, -5)),
    ],
)
def test_a_motion_that_loads_turn_back_beside_a_pose_keeps_its_branch(
    turn: float, omega: float, slides: bool, gravity: tuple[float, float], options: dict[str, Any]
) -> None:
    """It comes through the pose slowly, and back through it at once."""
    model = equal_slider_crank(turn, omega, slides, gravity)
    result = lw.simulate(model, 0.25, progress=False, **options)
    assert -result.omega[-1, 0, 1] == pytest.approx(
        rate_of_crank(turn, omega, slides, gravity, 0.25), rel=1e-3
    )
    if not slides:
        assert result.body("slider").position[-1, 0] == pytest.approx(0, abs=1e-6)


@pytest.mark.parametrize("options", [{"step": 1e-3}, {"rtol": 1e-8}], ids=str)
@pytest.mark.parametrize("omega", [1e-3, -1e-3, 2e-3])
@pytest.mark.parametrize("slides", [True, False])
def test_slow_velocities_decide_where_weights_balance_in_the_pose(
    slides: bool, omega: float, options: dict[str, Any]
) -> None:
    """It is left like an upright pendulum, at a rate that the accelerations of the pose do not tell."""
    model = equal_slider_crank(0, omega, slides, (0, -9.81))
    result = lw.simulate(model, 1.0, progress=False, **options)
    assert -result.omega[-1, 0, 1] == pytest.approx(
        rate_of_crank(0, omega, slides, (0, -9.81), 1.0), rel=1e-4
    )


@pytest.mark.parametrize(
    "options", [*ANY_METHOD, {"rtol": 1e-5}, {"step": 1e-3, "stabilization": "projection"}], ids=str
)
@pytest.mark.parametrize("gravity", [(0, 0, 0), (0, 0, -9.81)], ids=["none", "down"])
def test_a_driver_that_accelerates_from_rest_decides_nothing(
    gravity: tuple[float, float, float], options: dict[str, Any]
) -> None:
    """The rocker may turn like the crank, or rest."""
    model = folded_parallelogram((1.0, 1.0, 1.0), gravity=gravity)
    model.drive("ground-crank", velocity=lw.functions.harmonic(1.0, 3.0))
    with pytest.raises(lw.SingularSystemError, match="several motions are possible from rest") as caught:
        lw.simulate(model, 0.2, progress=False, **options)
    assert caught.value.time == 0.0


@pytest.mark.parametrize("power", [2, 3])
def test_nor_does_one_that_begins_without_an_acceleration(power: int) -> None:
    model = folded_parallelogram((1.0, 1.0, 1.0), gravity=(0, 0, 0))
    model.drive("ground-crank", velocity=lw.functions.polynomial(*power * [0.0], 3.0))
    with pytest.raises(lw.SingularSystemError, match="several motions are possible from rest"):
        lw.simulate(model, 0.2, 1e-3, progress=False)


def test_a_driver_at_rest_holds_a_mechanism_in_a_pose() -> None:
    model = folded_parallelogram((1.0, 1.0, 1.0), gravity=(9.81, 0, 0))
    model.drive("ground-crank", velocity=0.0)
    result = lw.simulate(model, 0.2, 1e-2, progress=False)
    assert np.abs(result.v).max() <= 1e-12


@pytest.mark.parametrize("acceleration", [0.0, 0.1, 100.0])
def test_a_driver_of_another_mechanism_decides_nothing(acceleration: float) -> None:
    """Reactions are finite on the branch that is taken."""
    masses = (1.0, 1.0, 1.0)
    model = folded_parallelogram(masses)
    model.body("wheel", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 3, 0))
    model.revolute("ground", "wheel", at=(0, 3, 0), axis=(0, 1, 0), name="shaft")
    model.drive("shaft", velocity=lw.functions.polynomial(0.0, acceleration))
    result = lw.simulate(model, 0.2, 1e-3, progress=False)
    assert result.omega[-1, [0, 2], 1] == pytest.approx(fall(masses, 0.0, 0.2), rel=1e-5)


@pytest.mark.parametrize("options", [{"step": 1e-3}, {"rtol": 1e-5}], ids=str)
def test_a_slow_driver_leaves_a_pose_by_the_branch_of_its_velocities(options: dict[str, Any]) -> None:
    model = folded_parallelogram((3.0, 0.2, 0.7), 0.01)
    model.drive("ground-crank", velocity=0.01)
    result = lw.simulate(model, 0.2, progress=False, **options)
    assert result.omega[-1, :, 1] == pytest.approx([0.01, 0, 0.01], abs=1e-6)


def test_rest_far_from_the_origin_is_left_by_the_branch_on_which_reactions_are_finite() -> None:
    """Roundoff of the positions does not hide it."""
    masses = (1.0, 1.0, 1.0)
    model = folded_parallelogram(masses, away=1e6)
    result = lw.simulate(model, 0.2, 1e-3, progress=False)
    assert result.omega[-1, [0, 2], 1] == pytest.approx(fall(masses, 0.0, 0.2), rel=1e-5)


#: Lengths [m] of crank, coupler and ground: with a rocker as long as the coupler they pass a singular pose.
BARS = (0.3, 0.6, 0.9)


def pin_of_rocker(crank: Any, rocker: float) -> Any:
    """Where coupler and rocker meet [m], shape (n, 2), at angles of the crank [rad]: on one side for all."""
    length, coupler, ground = BARS
    start = length * np.stack([np.cos(crank), np.sin(crank)], axis=-1)
    across = np.array([ground, 0.0]) - start
    apart = np.linalg.norm(across, axis=-1, keepdims=True)
    along = (apart**2 + coupler**2 - rocker**2) / (2 * apart)
    normal = np.stack([-across[..., 1], across[..., 0]], axis=-1)
    return start + (along * across + np.sqrt(coupler**2 - along**2) * normal) / apart


def four_bar_beside_its_line(excess: float, rate: float) -> lw.Model:
    """The rocker is longer than the coupler by `excess` [m]; the crank turns at `rate` [rad/s]."""
    turn, z = 0.7, np.array([0.0, 0.0, 1.0])
    at = np.zeros((4, 3))
    at[1, :2] = BARS[0] * np.cos(turn), BARS[0] * np.sin(turn)
    at[2, :2] = pin_of_rocker(turn, BARS[1] + excess)
    at[3, 0] = BARS[2]
    speed = rate * np.cross(z, at[1])
    across = np.cross(z, [at[2] - at[1], at[2] - at[3]])[:, :2].T
    coupler, rocker = np.linalg.solve(across * [1, -1], -speed[:2])
    speeds = (np.zeros(3), speed, rocker * np.cross(z, at[2] - at[3]), np.zeros(3))
    model, names = lw.Model(gravity=(0, 0, 0)), ("crank", "coupler", "rocker")
    for k, (name, omega) in enumerate(zip(names, (rate, coupler, rocker), strict=True)):
        model.body(
            name,
            mass=1.0,
            inertia=(0.01, 0.03, 0.03),
            position=(at[k] + at[k + 1]) / 2,
            orientation=lw.rotation.from_axes(x=at[k + 1] - at[k], y=np.cross(z, at[k + 1] - at[k])),
            velocity=(speeds[k] + speeds[k + 1]) / 2,
            omega=omega * z,
        )
    for a, b, pin in zip(("ground", *names), (*names, "ground"), at, strict=True):
        model.revolute(a, b, at=pin, axis=z)
    return model


@pytest.mark.parametrize(
    "options",
    [
        {"rtol": 1e-8},
        {"rtol": 1e-8, "integrator": "dop853", "stabilization": "projection"},
        {"rtol": 1e-8, "integrator": "tsit5", "stabilization": "none"},
        {"step": 1e-4},
    ],
    ids=str,
)
@pytest.mark.parametrize("excess", [1e-5, 3e-6, 1e-6])
def test_a_mechanism_that_passes_a_singular_pose_at_a_distance_bends_there(
    excess: float, options: dict[str, Any]
) -> None:
    """It is never on one line: its motion is the only one, though velocities turn as if to another branch."""
    result = lw.simulate(four_bar_beside_its_line(excess, 8.0), 1.0, progress=False, **options)
    assert result.t[-1] == 1.0
    assert not result.singular_poses
    crank, rocker = result.body("crank").position, result.body("rocker").position
    pin = pin_of_rocker(np.arctan2(crank[:, 1], crank[:, 0]), BARS[1] + excess)
    turns = np.cumsum(np.abs(np.diff(np.arctan2(crank[:, 1], crank[:, 0]))) > np.pi)
    assert turns[-1] >= 1
    assert 2 * rocker[:, :2] - [BARS[2], 0] == pytest.approx(pin, abs=1e-6)
    assert abs(result.energy_error).max() < 1e-5 * result.kinetic_energy[0]


@pytest.mark.parametrize(("excess", "step"), [(1e-6, 2e-3), (1e-7, 1e-3)])
def test_steps_that_leave_a_bend_beside_a_singular_pose_are_said_to_be_too_long(
    excess: float, step: float
) -> None:
    with pytest.raises(lw.SingularSystemError, match="beside a singular pose.*shorter step") as error:
        lw.simulate(four_bar_beside_its_line(excess, 8.0), 1.0, step, progress=False)
    assert len(error.value.joints) == 4
