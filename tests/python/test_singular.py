"""Dependent constraints, singular poses and massless bodies: solved by the methods that can, else refused."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import _core, mechanisms
from linkwork.validation import Series
from numpy.typing import NDArray
from random_mechanisms import JOINTS
from scipy.integrate import solve_ivp

#: (system, linear solver) of the standard formulation.
STANDARD = [
    (system, solver.name)
    for solver in _core.linear_solvers()
    if solver.available
    for system in solver.matrix_forms
    if system != "normal"
]


def body(model: lw.Model, name: str, position: tuple[float, ...], mass: float = 1.0) -> lw.Body:
    return model.body(name, mass=mass, inertia=(0.1 * mass, 0.2 * mass, 0.25 * mass), position=position)


# --- dependent constraints ----------------------------------------------------------------------------------


def doubled(kind: str) -> lw.Model:
    """A swing and, hanging from it, a body by two equal joints."""
    model = lw.Model()
    swing, load = body(model, "swing", (0.5, 0, 0)), body(model, "load", (1.5, 0.2, 0.1))
    places = {
        "point": {"at": (1, 0, 0)},
        "axis": {"at": (1, 0, 0), "axis": (0, 1, 1)},
        "two_axes": {"at": (1, 0, 0), "axes": ((0, 1, 0), (1, 0, 1))},
        "two_points": {"at": ((1, 0, 0), (1.2, 0.3, 0.4))},
        "frame": {"at": (1, 0, 0)},
        "direction": {"axis": (0, 1, 1)},
        "two_directions": {"axes": ((0, 1, 0), (1, 0, 1))},
        "orientation": {},
        "shafts": {"at": (1, 0, 0), "axes": ((0, 1, 0), (1, 1, 1))},
        "centers": {"at": ((1, 0, 0), (1.2, 0.3, 0.4)), "axis": (0, 1, 1)},
        "disc": {"at": ((1, 0, 0), (1.2, 0.5 * np.sqrt(2 / 3), 0.4)), "axes": ((0, 1, 0), (1, 1, 1))},
    }
    values = {"pitch": 0.1, "radius": 0.5, "teeth_a": 20, "teeth_b": 31, "angle": 0.0, "displacement": 0.0}
    parameters = {name: values[name] for name in JOINTS[kind].parameters if name in values}
    model.spherical(model.ground, swing, at=(0, 0, 0), name="pivot")
    for name in ("first", "second"):
        getattr(model, kind)(swing, load, name=name, **places[JOINTS[kind].placement], **parameters)
    return model


REDUNDANT: dict[str, tuple[Callable[[], lw.Model], set[str]]] = {
    "bricard": (mechanisms.bricard, {f"hinge {k}" for k in range(6)}),
    "four_bar": (mechanisms.four_bar, {"pin 0", "pin 1", "left 0", "right 0"}),
} | {f"two {kind}": (lambda kind=kind: doubled(kind), {"first", "second"}) for kind in JOINTS}


@pytest.mark.parametrize("name", REDUNDANT)
def test_a_dependent_group_is_named_by_its_joints(name: str) -> None:
    make, members = REDUNDANT[name]
    core = make().compiled()
    dynamics = lw.System(make()).compiled()
    rank = dynamics.rank()
    groups = dynamics.dependent_groups(10)
    assert len(groups) == len(rank.redundant_rows) == rank.rows - rank.rank > 0
    for row, others, text in groups:
        rows = [row, *others]
        joints = {core.joint_name(int(j)) for j in np.searchsorted(core.joint_rows, rows, side="right") - 1}
        assert joints == members
        assert text.startswith(core.describe_row(row)) and all(f"'{joint}'" in text for joint in joints)
    named = {core.joint_name(joint) for joint, unique in enumerate(rank.unique) if not unique}
    assert named == members


@pytest.mark.parametrize(("system", "solver"), STANDARD)
@pytest.mark.parametrize("name", REDUNDANT)
def test_every_linear_solver_finds_the_same_motion_or_refuses(name: str, system: str, solver: str) -> None:
    """The sparse kkt matrix has no place for equations that are left out."""
    model = REDUNDANT[name][0]()
    state = model.compiled()
    if system == "kkt" and solver != "block":
        with pytest.raises(lw.OptionError, match="takes no redundant constraints.*'schur'"):
            lw.System(model, matrix_form=system, linear_solver=solver)
        return
    at = state.q0, state.v0
    v_dot, multipliers = lw.System(model, matrix_form=system, linear_solver=solver).accelerations(0.0, *at)
    expected = lw.System(model, formulation="augmented_lagrangian").accelerations(0.0, *at)
    assert np.abs(v_dot - expected[0]).max() <= 1e-9 * np.abs(expected[0]).max()
    assert np.abs(multipliers - expected[1]).max() <= 1e-8 * np.abs(expected[1]).max()


def aligned() -> lw.Model:
    """A crank whose rod points through its hinge: there, and only there, the rod does not hold it."""
    model = lw.Model()
    crank = body(model, "crank", (0.5, 0, 0))
    model.revolute(model.ground, crank, at=(0, 0, 0), axis=(0, 0, 1), name="hinge")
    model.distance(crank, model.ground, at=((1, 0, 0), (3, 0, 0)), name="rod")
    return model


def hinged(model: lw.Model, crank: lw.Body, coupler: lw.Body, rocker: lw.Body) -> lw.Model:
    """Bars on the x axis, joined in a loop."""
    hinges = ((model.ground, crank, 0), (crank, coupler, 1), (coupler, rocker, 3), (rocker, model.ground, 2))
    for a, b, x in hinges:
        model.revolute(a, b, at=(x, 0, 0), axis=(0, 0, 1), name=f"hinge {x}")
    return model


def flat_four_bar() -> lw.Model:
    """All bars on one line: it can go on in two ways, and has redundant equations besides."""
    model = lw.Model(gravity=(0, -9.81, 0))
    crank, coupler, rocker = (
        body(model, name, (x, 0, 0)) for name, x in (("a", 0.5), ("b", 2.0), ("c", 2.5))
    )
    return hinged(model, crank, coupler, rocker)


TURNING = 3.0  # rad/s


def turning_flat_four_bar() -> lw.Model:
    """A parallelogram that turns, at the moment in which it is flat and has a second motion."""
    model = lw.Model(gravity=(0, -9.81, 0))
    turn = {"omega": (0, 0, TURNING), "velocity": (0, 0.5 * TURNING, 0)}
    crank, coupler, rocker = (
        model.body(name, mass=1.0, inertia=(0.1, 0.2, 0.25), position=(x, 0, 0), **motion)
        for name, x, motion in (("a", 0.5, turn), ("b", 2.0, {"velocity": (0, TURNING, 0)}), ("c", 2.5, turn))
    )
    return hinged(model, crank, coupler, rocker)


def test_a_singular_pose_is_told_apart_from_redundancy() -> None:
    rank = lw.System(flat_four_bar()).compiled().rank()
    assert (rank.rows, rank.rank, rank.degrees_of_freedom) == (20, 17, 1)
    assert (len(rank.redundant_rows), len(rank.singular_rows)) == (3, 1)


def least_norm_accelerations(model: lw.Model) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Of all v_dot with D v_dot = gamma the nearest to M^-1 g in the metric M; and M v_dot - g."""
    state = model.compiled()
    at = lw.System(model).evaluate(0.0, state.q0, state.v0)
    n = len(at.M)
    M, D = np.zeros((6 * n, 6 * n)), np.zeros((len(at.gamma), 6 * n))
    for k, block in enumerate(at.M):
        M[6 * k : 6 * k + 6, 6 * k : 6 * k + 6] = block
    data, indices, indptr = at.D
    for row in range(len(D)):
        D[row, indices[indptr[row] : indptr[row + 1]]] = data[indptr[row] : indptr[row + 1]]
    root = np.linalg.inv(np.linalg.cholesky(M)).T
    free = np.linalg.solve(M, at.g)
    v_dot = free + root @ np.linalg.pinv(D @ root, rcond=1e-9) @ (at.gamma - D @ free)
    return v_dot, M @ v_dot - at.g


@pytest.mark.parametrize(("system", "solver"), STANDARD)
@pytest.mark.parametrize(
    "make", [aligned, flat_four_bar, turning_flat_four_bar], ids=lambda make: make.__name__
)
def test_accelerations_in_a_singular_pose_are_those_of_singular_values(
    make: Callable[[], lw.Model], system: str, solver: str
) -> None:
    model = make()
    if system == "kkt" and solver != "block" and make is not aligned:
        with pytest.raises(lw.OptionError, match="takes no redundant constraints"):
            lw.System(model, matrix_form=system, linear_solver=solver)
        return
    state = model.compiled()
    dynamics = lw.System(model, matrix_form=system, linear_solver=solver)
    v_dot, multipliers = dynamics.accelerations(0.0, state.q0, state.v0)
    expected, force = least_norm_accelerations(model)
    scale = 1.0 + np.abs(expected).max()
    assert np.abs(v_dot - expected).max() <= 1e-10 * scale
    data, indices, indptr = dynamics.evaluate(0.0, state.q0, state.v0).D
    joint_force = np.zeros(len(v_dot))
    for row, multiplier in enumerate(multipliers):
        joint_force[indices[indptr[row] : indptr[row + 1]]] += (
            multiplier * data[indptr[row] : indptr[row + 1]]
        )
    assert np.abs(joint_force - force).max() <= 1e-9 * (1.0 + np.abs(force).max())
    statistics = dynamics.compiled().statistics()
    assert (
        statistics["singular_poses"] == 1
        and statistics["singularity_crossings"][0]["fallback_evaluations"] >= 1
    )


def test_a_parallelogram_starts_from_the_pose_in_which_it_is_flat() -> None:
    """It goes on as a parallelogram: theta_ddot = -g cos(theta), its four bars of 1 kg."""
    exact = solve_ivp(
        lambda _, y: (y[1], -9.81 * np.cos(y[0])), (0, 0.5), (0.0, TURNING), rtol=1e-12, atol=1e-12
    ).y[0, -1]
    result = lw.simulate(turning_flat_four_bar(), 0.5, 1e-3, progress=False)
    crank = result.body("a").position[-1]
    assert np.abs(crank[:2] - 0.5 * np.array([np.cos(exact), np.sin(exact)])).max() <= 1e-5
    assert result.violation[10:, 0].max() <= 1e-9
    assert result.singular_poses[0].t <= 1e-3


@pytest.mark.parametrize("n", [1, 2])
def test_singular_poses_on_the_way_are_found_at_their_time(n: int) -> None:
    """All rods lie down where the tops are as high as their pins; every loop is named."""
    result = lw.simulate(mechanisms.four_bar(n), 3.0, 1e-3, record_every=1, progress=False)
    height = result.position[:, 0, 1]
    crossings = result.t[:-1][height[:-1] * height[1:] < 0]
    assert len(crossings) >= 2
    found = result.singular_poses
    assert [it.t for it in found] == pytest.approx(crossings, abs=1.01e-3)
    assert result.statistics["singular_poses"] == len(found)
    assert all(0.0 <= it.pivot <= 1e-3 for it in found)
    for it in found:
        for k in range(n):  # which of its joints depends on the rows that the build's rank service leaves out
            assert {f"pin {k}", f"left {k}", f"right {k}", f"pin {k + 1}"} & set(it.joints)
        assert {"pin 0", f"pin {n}"} <= set(it.joints)


def test_a_run_that_is_to_stop_at_singular_poses_stops_there_naming_time_and_joints() -> None:
    passed = lw.simulate(mechanisms.four_bar(1), 3.0, 1e-3, progress=False).singular_poses[0]
    for choice in ({"step": 1e-3}, {"rtol": 1e-8, "step": 2e-3}):
        with pytest.raises(lw.SingularSystemError, match="singular pose: .*'pin 0'.* 'pass'") as caught:
            lw.simulate(mechanisms.four_bar(1), 3.0, progress=False, on_singular="stop", **choice)
        assert caught.value.code == "singular_pose"
        assert caught.value.time == pytest.approx(passed.t, abs=1e-2)
        assert set(caught.value.joints) == set(passed.joints)


def test_a_run_that_is_to_warn_of_singular_poses_warns_and_goes_on() -> None:
    with pytest.warns(lw.LinkworkWarning, match="singular pose at t = .*('pin 0'|of the same)"):
        warned = lw.simulate(mechanisms.four_bar(1), 3.0, 1e-3, progress=False, on_singular="warn")
    passed = lw.simulate(mechanisms.four_bar(1), 3.0, 1e-3, progress=False)
    assert np.array_equal(warned.q, passed.q)


@pytest.mark.parametrize(("t_end", "told"), [(4.0, 4), (20.0, 10)])
def test_each_singular_pose_is_told_by_a_run_and_by_a_lane(t_end: float, told: int) -> None:
    """Of very many the first ten, and then how many more there were."""
    run: dict[str, Any] = {"t_end": t_end, "rtol": 1e-6, "on_singular": "warn", "progress": False}
    model = mechanisms.four_bar()
    with pytest.warns(lw.LinkworkWarning) as caught:
        alone = lw.simulate(model, deterministic=True, **run)
    texts = [str(it.message) for it in caught if "singular pose" in str(it.message)]
    poses = alone.singular_poses
    assert len(poses) > 3
    expected = [f"singular pose at t = {it.t:.6g} s" for it in poses[:told]]
    more = len(poses) - told
    expected += [f"singular poses: {more} more up to t = {poses[-1].t:.6g} s"] if more > 0 else []
    assert all(text.startswith(it) for text, it in zip(texts, expected, strict=True))
    assert all(f"'{name}'" in texts[0] for name in poses[0].joints)
    study = lw.sweep(model, {"gravity[1]": [-9.81]}, "final", processes=1, **run)
    assert study.manifest["lanes"]
    assert [it for it in study.remarks[0].split("; ") if "singular pose" in it] == texts


@pytest.mark.parametrize("name", ["chain", "net", "binary_tree", "bricard", "spatial_slider_crank"])
def test_small_pivots_alone_are_no_singular_pose(name: str) -> None:
    """A straight chain of n links has pivots ~ 1/n^3."""
    mechanism = mechanisms.MECHANISMS[name]
    model = mechanism.function(1000) if name == "chain" else mechanism.function()
    result = lw.simulate(model, 0.2, 2e-3, progress=False)
    assert result.singular_poses == ()
    assert result.statistics["row_changes"] == 0


@pytest.mark.parametrize("formulation", ("standard", "augmented_lagrangian"))
@pytest.mark.parametrize("kind", JOINTS)
def test_a_joint_that_is_there_twice_does_not_matter(kind: str, formulation: str) -> None:
    """It moves as if the joint were there once, and the two share the load of that one equally."""
    twice = lw.simulate(doubled(kind), 0.5, 1e-3, formulation=formulation, progress=False)
    once = lw.simulate(without_second(kind), 0.5, 1e-3, progress=False)
    assert np.abs(twice.q - once.q).max() <= 1e-9
    shared = [twice.reaction(name).force for name in ("first", "second")]
    load = once.reaction("first").force
    assert np.abs(shared[0] - load / 2).max() <= 1e-7 * np.abs(load).max()
    assert np.abs(shared[1] - load / 2).max() <= 1e-7 * np.abs(load).max()
    assert list(twice.unique_reactions) == [True, False, False]
    assert once.unique_reactions.all()


def without_second(kind: str) -> lw.Model:
    """`doubled` with the first of the two joints only."""
    full = doubled(kind)
    arrays, core = full.compiled().joint_arrays(), full.compiled()
    model = lw.Model()
    bodies = [body(model, core.body_name(k), tuple(core.q0[7 * k : 7 * k + 3])) for k in range(2)]
    model.spherical(model.ground, bodies[0], at=(0, 0, 0), name="pivot")
    values = arrays["parameters"][: len(JOINTS[kind].parameters)]
    model.compiled().add_joints(
        kind, ["first"], arrays["bodies"][1:2], arrays["origin"][1:2], arrays["frame"][1:2],
        values.reshape(1, -1), np.full((1, len(values)), -1, np.int32),
    )  # fmt: skip
    return model


# --- massless bodies ----------------------------------------------------------------------------------------


def two_arms(connect: Callable[[lw.Model, lw.Body, lw.Body], object]) -> lw.Model:
    """Two bodies that swing on ball joints, connected somehow between (1, 0, 0) and (1, 1, 0.5)."""
    model = lw.Model()
    a, b = body(model, "a", (0.5, 0, 0)), body(model, "b", (0.5, 1, 0.5), mass=2.0)
    model.spherical(model.ground, a, at=(0, 0, 0))
    model.spherical(model.ground, b, at=(0, 1, 0.5))
    connect(model, a, b)
    return model


def feather(model: lw.Model, position: tuple[float, ...]) -> lw.Body:
    return model.body("feather", mass=0.0, inertia=(0, 0, 0), position=position)


def massless_rod(model: lw.Model, a: lw.Body, b: lw.Body) -> None:
    """Held against turning about itself by a universal joint at one end."""
    coupler = feather(model, (1, 0.5, 0.25))
    model.spherical(a, coupler, at=(1, 0, 0))
    model.universal(coupler, b, at=(1, 1, 0.5), axes=((1, 0, 0), (0, -0.5, 1)))


def massless_cross(model: lw.Model, a: lw.Body, b: lw.Body) -> None:
    cross = feather(model, (1, 0.5, 0.25))
    model.revolute(a, cross, at=(1, 0.5, 0.25), axis=(0, 1, 0))
    model.revolute(cross, b, at=(1, 0.5, 0.25), axis=(1, 0, 1))


def massless_sleeve(model: lw.Model, a: lw.Body, b: lw.Body) -> None:
    sleeve = feather(model, (1, 0.5, 0.25))
    model.revolute(a, sleeve, at=(1, 0.5, 0.25), axis=(0, 2, 1))
    model.translational(sleeve, b, at=(1, 0.5, 0.25), axis=(0, 2, 1))


def weightless_joint(kind: str, **place: object) -> Callable[[lw.Model, lw.Body, lw.Body], object]:
    return lambda model, a, b: getattr(model, kind)(a, b, **place)


EQUIVALENT = {
    "rod is distance": (massless_rod, weightless_joint("distance", at=((1, 0, 0), (1, 1, 0.5)))),
    "cross is universal": (
        massless_cross,
        weightless_joint("universal", at=(1, 0.5, 0.25), axes=((0, 1, 0), (1, 0, 1))),
    ),
    "sleeve is cylindrical": (
        massless_sleeve,
        weightless_joint("cylindrical", at=(1, 0.5, 0.25), axis=(0, 2, 1)),
    ),
}


@pytest.mark.parametrize("formulation", ["standard", "augmented_lagrangian"])
@pytest.mark.parametrize("name", EQUIVALENT)
def test_a_massless_coupler_is_the_joint_that_it_makes(name: str, formulation: str) -> None:
    with_coupler, with_joint = (two_arms(connect) for connect in EQUIVALENT[name])
    massless = lw.simulate(with_coupler, 0.5, 1e-3, formulation=formulation, progress=False)
    direct = lw.simulate(with_joint, 0.5, 1e-3, progress=False)
    assert np.abs(massless.q[:, :2] - direct.q).max() <= 1e-9
    assert np.abs(massless.v[:, :2] - direct.v).max() <= 1e-8
    for joint in ("spherical 1", "spherical 2"):
        force, expected = massless.reaction(joint).force, direct.reaction(joint).force
        assert np.abs(force - expected).max() <= 1e-7 * np.abs(expected).max()


@pytest.mark.parametrize("formulation", ["standard", "augmented_lagrangian"])
def test_a_mass_without_inertia_on_a_hinge_is_the_simple_pendulum(formulation: str) -> None:
    """IFToMM A01 as it is defined: M is singular, D holds the rotation."""
    reference = Series("A01_pendulum")
    model = lw.Model(gravity=(0, -9.81, 0))
    bob = model.body("bob", mass=1.0, inertia=(0, 0, 0), position=(-1, 0, 0))
    model.revolute(model.ground, bob, at=(0, 0, 0), axis=(0, 0, 1))
    every = round(reference.interval / 1e-3)
    result = lw.simulate(model, 10.0, 1e-3, formulation=formulation, record_every=every, progress=False)
    assert np.abs(result.position[:, 0, :2] - reference("x", "y")).max() <= 1e-8


@pytest.mark.parametrize("formulation", ["standard", "penalty", "augmented_lagrangian"])
@pytest.mark.parametrize("held", ["not at all", "but for its own axis"])
def test_a_massless_motion_that_nothing_holds_is_refused_naming_the_body(held: str, formulation: str) -> None:
    """ker M and ker D meet: a massless rod with balls at both ends turns about itself as it likes."""

    def connect(model: lw.Model, a: lw.Body, b: lw.Body) -> None:
        coupler = feather(model, (1, 0.5, 0.25))
        if held == "but for its own axis":
            model.spherical(a, coupler, at=(1, 0, 0))
            model.spherical(coupler, b, at=(1, 1, 0.5))

    with pytest.raises(lw.SingularSystemError, match="body 'feather' has a motion without inertia") as caught:
        lw.simulate(two_arms(connect), 0.1, 1e-3, formulation=formulation, progress=False)
    assert caught.value.bodies == ["feather"]


def on_three_hinges(turned: float, inertance: float) -> lw.Model:
    """A body on hinges with massless links between; the third axis is the first one, turned by an angle."""
    model = lw.Model()
    links = [model.body(name, mass=0.0, inertia=(0, 0, 0)) for name in ("first link", "second link")]
    links.append(body(model, "arm", (0.3, 0.4, 0.5)))
    axes = ((1, 0, 0), (0, 1, 0), (np.cos(turned), 0, np.sin(turned)))
    for before, link, axis in zip([model.ground, *links], links, axes, strict=False):
        model.revolute(before, link, at=(0, 0, 0), axis=axis)
        if inertance:
            model.rotational_inerter(before, link, at=(0, 0, 0), axis=axis, inertance=inertance)
    return model


@pytest.mark.parametrize("deterministic", [False, True])
@pytest.mark.parametrize("turned", [1e-2, 1e-4, 1e-6, 0.0])
def test_hinges_with_rotors_pass_the_pose_in_which_two_are_one(turned: float, deterministic: bool) -> None:
    """Where massless links alone would move without inertia."""
    model = on_three_hinges(turned, 0.1)
    state = model.compiled()
    found = lw.System(model, deterministic=deterministic).accelerations(0.0, state.q0, state.v0)
    expected = lw.System(model, formulation="augmented_lagrangian").accelerations(0.0, state.q0, state.v0)
    for x, exact in zip(found, expected, strict=True):
        assert np.abs(x - exact).max() <= 1e-8 * np.abs(exact).max()


def gimbal(middle: float, torque: float) -> tuple[lw.Model, NDArray[np.float64]]:
    """Three hinges across each other, and a pose with the middle one turned: at pi/2 the others are one."""
    model = lw.Model()
    links = [model.body(name, mass=0.0, inertia=(0, 0, 0)) for name in ("first link", "second link")]
    links.append(body(model, "arm", (0, 0, 0)))
    for before, link, axis in zip([model.ground, *links], links, np.eye(3), strict=False):
        model.revolute(before, link, at=(0, 0, 0), axis=axis)
    model.force(links[0], torque=(torque, 0, 0))
    q = model.compiled().q0.reshape(-1, 7).copy()
    q[1:, 3:] = np.cos(middle / 2), 0, np.sin(middle / 2), 0
    return model, q.ravel()


@pytest.mark.parametrize("deterministic", [False, True])
def test_massless_links_move_by_what_inertia_a_pose_leaves_them(deterministic: bool) -> None:
    """A torque n about the first axis turns its link by n / (J_x cos^2) of the middle angle, down to none."""
    model, locked = gimbal(np.pi / 2, torque=0.3)
    system, rest = lw.System(model, deterministic=deterministic), np.zeros(18)
    for away in (0.5, 1e-1, 1e-3, 1e-5, 1e-3):
        _, q = gimbal(np.pi / 2 - away, torque=0.3)
        found = system.accelerations(0.0, q, rest)[0].reshape(3, 6)
        assert found[0, 3] == pytest.approx(3.0 / np.sin(away) ** 2, rel=1e-8)
        assert found[2, 3] == pytest.approx(3.0 / np.sin(away), rel=1e-8)
    free = lw.System(gimbal(1.0, torque=0.0)[0], deterministic=deterministic)
    assert np.abs(free.accelerations(0.0, locked, rest)[0]).max() <= 1e-12


@pytest.mark.parametrize(("system", "solver"), STANDARD)
def test_a_massless_body_is_moved_by_every_solver_of_standard(system: str, solver: str) -> None:
    model = two_arms(massless_rod)
    state = model.compiled()
    found = lw.System(model, matrix_form=system, linear_solver=solver).accelerations(0.0, state.q0, state.v0)
    expected = lw.System(model, formulation="augmented_lagrangian").accelerations(0.0, state.q0, state.v0)
    for x, exact in zip(found, expected, strict=True):
        assert np.abs(x - exact).max() <= 1e-11 * np.abs(exact).max()


def test_a_policy_that_nothing_could_watch_for_is_refused() -> None:
    with pytest.raises(
        lw.OptionError, match=r"on_singular 'stop'.*'penalty'.*'eigen_ldlt'.*use linear solver 'block'"
    ):
        lw.System(
            mechanisms.four_bar(), formulation="penalty", linear_solver="eigen_ldlt", on_singular="stop"
        )


@pytest.mark.parametrize("masses", [(1.0, 2.0, 3.0), (60.0, 1.0, 3.1), (1e-2, 1e2, 1e2)])
@pytest.mark.parametrize("formulation", ["standard", "augmented_lagrangian"])
def test_accelerations_are_known_to_all_digits_beside_a_singular_pose(
    masses: tuple[float, float, float], formulation: str
) -> None:
    """A parallelogram turned out of its line by so much, where a model begins, falls as from a little more.

    Of the angles of crank and rocker and the height of the rod, which change by the square of it.
    """

    def fall(turned: float) -> Any:
        model = lw.Model(gravity=(0, -9.81, 0))
        along, up = np.array((2.0, 0, 0)), np.array((np.cos(turned), np.sin(turned), 0))
        ends = (np.zeros(3), up), (up, up + along), (along, along + up)
        bars = [
            model.body(name, mass=mass, inertia=mass * np.array((0.01, 0.1, 0.1)), position=sum(at) / 2)
            for name, mass, at in zip(("crank", "rod", "rocker"), masses, ends, strict=True)
        ]
        model.revolute(model.ground, bars[0], at=np.zeros(3), axis=(0, 0, 1))
        model.universal(bars[0], bars[1], at=up, axes=((0, 0, 1), (1, 0, 0)))
        model.spherical(bars[1], bars[2], at=up + along)
        model.revolute(model.ground, bars[2], at=along, axis=(0, 0, 1))
        core = model.compiled()
        return lw.System(model, formulation=formulation).accelerations(0.0, core.q0, core.v0)[0][[5, 17, 7]]

    usual = fall(1e-3)
    assert np.abs(usual[:2]).max() > 5.0
    for turned in (1e-5, 1e-6, 1e-7, 3e-8):
        np.testing.assert_allclose(fall(turned), usual, rtol=1e-5, atol=1e-9)


@pytest.mark.parametrize("seed", (5, 8, 18, 35))
def test_a_massless_carrier_of_a_door_whose_forces_balance_is_no_free_motion(seed: int) -> None:
    """Accelerations are roundoff of what turns the door: all of them are known to that."""
    rng = np.random.default_rng(seed)

    def unit() -> NDArray[np.float64]:
        x = rng.normal(size=3)
        return np.asarray(x / np.linalg.norm(x))

    model = lw.Model(gravity=(0, 0, 0))
    model.body("carrier", mass=0, inertia=(0, 0, 0), position=rng.normal(size=3))
    model.body("door", mass=5, inertia=(1, 1.2, 1.1), position=rng.normal(size=3), omega=(1, 0.5, -0.7))
    axis, at = unit(), rng.normal(size=3)
    for along in (0.0, 0.7):
        model.revolute("carrier", "door", at=at + along * axis, axis=axis)
    of_ground = unit()
    across = np.cross(of_ground, unit())
    model.perpendicular_axes("ground", "carrier", axes=(of_ground, across / np.linalg.norm(across)))
    model.distance("ground", "carrier", at=(rng.normal(size=3), rng.normal(size=3)))
    model = lw.assemble(model).model
    runs = [
        lw.simulate(model, 0.5, 1e-3, formulation=formulation, progress=False)
        for formulation in ("standard", "augmented_lagrangian")
    ]
    np.testing.assert_allclose(runs[1].q, runs[0].q, atol=1e-9)
    assert all(run.verdict is not None and run.verdict.error < 1e-6 for run in runs)


@pytest.mark.parametrize("held_twice", (False, True))
@pytest.mark.parametrize("form", ("kkt", "schur"))
def test_a_driven_block_without_mass_follows_its_driver(held_twice: bool, form: str) -> None:
    """There is no energy that could be made, and no force."""
    model = lw.Model()
    model.body("block", mass=0, inertia=(0, 0, 0), position=(0.1, 0.2, 0.3))
    model.translational("ground", "block", at=(0, 0, 0), axis=(1, 0, 0), name="rail")
    if held_twice:
        model.orientation("ground", "block")
    rise, duration = 0.3, 0.5
    model.drive("rail", position=lw.functions.cycloidal(rise, duration))
    run = lw.simulate(model, 0.2, 1e-3, matrix_form=form, progress=False)
    share = run.t / duration
    exact = 0.1 + rise * (share - np.sin(2 * np.pi * share) / (2 * np.pi))
    np.testing.assert_allclose(run.position[:, 0, 0], exact, atol=1e-12)
    assert run.verdict is not None and run.verdict.error < 1e-8


def test_a_light_body_that_is_pressed_across_its_guide_takes_no_digits_from_what_hangs_on_it() -> None:
    """Every second link has no mass; by its mass the force is a trillion times the accelerations."""

    def accelerations(force: float, **how: Any) -> NDArray[np.float64]:
        rng = np.random.default_rng(0)
        model = lw.Model(gravity=(0, 0, -9.81))
        before = model.body("light", mass=1e-7, inertia=(1e-7,) * 3, position=(0, 0, 0))
        model.translational("ground", before, at=(0, 0, 0), axis=(1, 0, 0))
        model.force(before, force=(0, force, 0))
        place = np.zeros(3)
        for k in range(24):
            mass = 0.0 if k % 2 == 0 else 10 ** rng.uniform(-3, 0)
            way = np.array([np.cos(0.3 * k), 0, -np.sin(0.3 * k)])
            link = model.body(f"link {k}", mass=mass, inertia=(0.01 * mass,) * 3, position=place + way / 2)
            model.revolute(before, link, at=place, axis=(0, 1, 0))
            place = place + way
            if mass == 0.0:
                weight = model.body(
                    f"weight {k}", mass=10 ** rng.uniform(-10, -8), inertia=(0, 0, 0), position=place
                )
                model.fixed(link, weight, at=place)
            before = link
        run = lw.simulate(model, 1e-6, 1e-6, on_inaccurate="pass", progress=False, **how)
        return np.array(run.acceleration[0])

    exact = accelerations(0.0)
    pressed = accelerations(1e6, formulation="augmented_lagrangian")
    assert np.abs(pressed - exact).max() < 1e-8 * np.abs(exact).max()
