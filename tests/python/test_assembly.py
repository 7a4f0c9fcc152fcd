"""Initial conditions: corrected with the least change, or refused with the joints that conflict."""

from __future__ import annotations

import warnings
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms
from linkwork.arrays import Floats
from scipy.sparse import csr_array
from small_mechanisms import driven_pendulum, slider_crank


def perturbed(model: lw.Model, size: float, seed: int, speed: float = 0.0) -> lw.Model:
    """Every number of the initial state changed by up to `size` and `speed`."""
    random = np.random.default_rng(seed)
    core = model.compiled()
    q = core.q0 + random.uniform(-size, size, len(core.q0))
    q = q.reshape(-1, 7)
    q[:, 3:] /= np.linalg.norm(q[:, 3:], axis=1, keepdims=True)
    return model.with_initial_state(q, core.v0 + random.uniform(-speed, speed, len(core.v0)))


def state(model: lw.Model) -> tuple[Floats, Floats]:
    return model.compiled().q0.reshape(-1, 7), model.compiled().v0.reshape(-1, 6)


def evaluated(model: lw.Model) -> tuple[Floats, Floats, Floats, Floats]:
    """D (m, 6n), M (6n, 6n), Phi and Phi_dot at the initial state."""
    core = model.compiled()
    at = lw.System(model, formulation="augmented_lagrangian").evaluate(0.0, core.q0, core.v0)
    data, indices, indptr = at.D
    D = np.zeros((model.row_count, 6 * model.body_count))
    np.add.at(D, (np.repeat(np.arange(model.row_count), np.diff(indptr)), indices), data)
    M = np.zeros((6 * model.body_count,) * 2)
    for k, block in enumerate(at.M):
        M[6 * k : 6 * k + 6, 6 * k : 6 * k + 6] = block
    return D, M, at.Phi, at.Phi_dot


def outside_range(D: Floats, x: Floats) -> float:
    """The part of x that is not D^T lambda for any lambda, relative."""
    _, singular, V = np.linalg.svd(D)
    kernel = V[int((singular > 1e-9 * singular[0]).sum()) :]
    return float(np.linalg.norm(kernel @ x) / np.linalg.norm(x))


def free_body(
    model: lw.Model, name: str, position: tuple[float, ...], mass: float = 1.0, **how: object
) -> lw.Body:
    return model.body(name, mass=mass, inertia=(0.1, 0.2, 0.25), position=position, **how)  # type: ignore[arg-type]


def gap(first: float = 1.0, second: float = 1.0) -> lw.Model:
    """Two bodies whose centers ought to be one point and are 0.8 m apart, moving apart with 0.4 m/s."""
    model = lw.Model(name="gap")
    free_body(model, "first", (0, 0, 0), first)
    free_body(model, "second", (0.8, 0, 0), second, velocity=(0.4, 0, 0))
    model.spherical("first", "second", at=((0, 0, 0), (0, 0, 0)), frames="body", name="ball")
    return model


# --- positions ----------------------------------------------------------------------------------------------


def displacement(model: lw.Model, other: lw.Model) -> float:
    """Mean square displacement of the mass between the poses of two models [kg m2]."""
    core, (q, _), (q0, _) = model.compiled(), state(model), state(other)
    turned = lw.rotation.matrix(q[:, 3:]) - lw.rotation.matrix(q0[:, 3:])
    moments = np.trace(core.inertia, axis1=1, axis2=2)[:, None, None] / 2 * np.eye(3) - core.inertia
    moved = core.mass @ ((q - q0)[:, :3] ** 2).sum(axis=1)
    return float(moved + np.einsum("kij,kjl,kil->", turned, moments, turned))


def test_bricards_mechanism_comes_together_near_by() -> None:
    assembly = lw.assemble(perturbed(mechanisms.bricard(), 0.1, seed=0))
    assert np.abs(evaluated(assembly.model)[2]).max() <= 1e-12
    assert assembly.moved.max() <= 0.15


@pytest.mark.parametrize("seed", range(20))
def test_bricards_mechanism_is_found_no_farther_than_where_it_was_perturbed(seed: int) -> None:
    """That is up to 0.17 m away for a body; the nearest pose is nearer."""
    whole = mechanisms.bricard()
    given = perturbed(whole, 0.1, seed)
    found = lw.assemble(given).model
    assert np.abs(evaluated(found)[2]).max() <= 1e-12
    assert displacement(found, given) < displacement(whole, given)


@pytest.mark.parametrize(
    "make", [mechanisms.four_bar, mechanisms.andrews, mechanisms.spatial_slider_crank, slider_crank]
)
def test_positions_and_velocities_satisfy_all_joints(make: type[lw.Model]) -> None:
    """Also with redundant equations."""
    size = float(np.abs(state(make())[0][:, :3]).max())
    assembly = lw.assemble(perturbed(make(), 0.05 * min(1.0, size), seed=3, speed=0.1))
    _, _, Phi, Phi_dot = evaluated(assembly.model)
    assert np.abs(Phi).max() <= 1e-12
    assert np.abs(Phi_dot).max() <= 1e-11
    assert assembly.position_before.max() > 1e-3
    assert assembly.position_after.max() == pytest.approx(np.abs(Phi).max(), abs=1e-15)
    assert assembly.velocity_after.max() == pytest.approx(np.abs(Phi_dot).max(), abs=1e-13)


@pytest.mark.parametrize(("first", "second"), [(1.0, 1.0), (1.0, 3.0), (5.0, 1.0)])
def test_bodies_move_in_inverse_ratio_to_their_masses(first: float, second: float) -> None:
    assembly = lw.assemble(gap(first, second))
    q, v = state(assembly.model)
    assert q[:, 0] == pytest.approx([0.8 * second / (first + second)] * 2, abs=1e-13)
    assert v[:, 0] == pytest.approx([0.4 * second / (first + second)] * 2, abs=1e-13)
    assert assembly.moved == pytest.approx(np.array([second, first]) * 0.8 / (first + second), abs=1e-13)
    assert assembly.turned.max() <= 1e-13


def test_a_weight_counts_like_a_mass() -> None:
    weighted, heavy = lw.assemble(gap(), weights={"second": 3.0}), lw.assemble(gap(1.0, 3.0))
    assert state(weighted.model)[0][:, 0] == pytest.approx(state(heavy.model)[0][:, 0], abs=1e-13)


@pytest.mark.parametrize("make", [mechanisms.bricard, mechanisms.four_bar, slider_crank])
def test_no_pose_along_the_constraints_is_nearer(make: type[lw.Model]) -> None:
    """The pull of the mass toward where it was is borne by the joints: it is D^T lambda."""
    given = perturbed(make(), 0.1, seed=5)
    found = lw.assemble(given).model
    D, M, _, _ = evaluated(found)
    (q0, _), (q, _) = state(given), state(found)
    A0, A = lw.rotation.matrix(q0[:, 3:]), lw.rotation.matrix(q[:, 3:])
    pull = np.zeros((len(q), 6))
    for k in range(len(q)):
        J = M[6 * k + 3 : 6 * k + 6, 6 * k + 3 : 6 * k + 6]
        G = A[k].T @ A0[k] @ (np.trace(J) / 2 * np.eye(3) - J)  # moments of second order
        pull[k, :3] = M[6 * k, 6 * k] * (q0[k, :3] - q[k, :3])
        pull[k, 3:] = G[2, 1] - G[1, 2], G[0, 2] - G[2, 0], G[1, 0] - G[0, 1]
    assert outside_range(D, pull.ravel()) <= 1e-8


def test_what_is_consistent_stays_as_it_is() -> None:
    model = mechanisms.spatial_slider_crank()
    assembly = lw.assemble(model)
    assert assembly.moved.max() <= 1e-14
    assert assembly.velocity_change.max() <= 1e-13


def test_held_bodies_do_not_move() -> None:
    given = perturbed(mechanisms.four_bar(2), 0.03, seed=1, speed=0.1)
    crank = mechanisms.four_bar(2).compiled()
    q, v = (x.copy() for x in state(given))
    q[0], v[0] = crank.q0[:7], crank.v0[:6]  # where a held body is has to be possible
    given = given.with_initial_state(q, v)
    assembly = lw.assemble(given, hold=["post 0"])
    found = state(assembly.model)
    assert np.array_equal(found[0][0], q[0]) and np.array_equal(found[1][0], v[0])
    assert assembly.position_after.max() <= 1e-12 and assembly.velocity_after.max() <= 1e-11
    assert assembly.moved[1:].min() > 1e-3


def test_a_body_that_hangs_exactly_the_wrong_way_round_is_turned() -> None:
    """Half a turn away no first step leads nearer."""
    model = lw.Model()
    free_body(model, "rod", (0, 0, 0))
    for name, x in (("left", -1.0), ("right", 1.0)):
        model.spherical("ground", "rod", at=((x, 0, 0), (-x, 0, 0)), frames="body", name=name)
    assembly = lw.assemble(model)
    assert assembly.position_after.max() <= 1e-12
    assert assembly.turned[0] == pytest.approx(np.pi, abs=1e-9)


def test_a_massless_body_is_assembled_with_the_others() -> None:
    model = lw.Model()
    free_body(model, "rod", (1, 0, 0))
    model.body("link", mass=0, inertia=(0, 0, 0), position=(0.1, 0.2, 0))
    model.spherical("ground", "link", at=((0, 0, 0), (0, 0, 0)), frames="body")
    model.spherical("link", "rod", at=((0.5, 0, 0), (-0.4, 0, 0)), frames="body")
    assert lw.assemble(model).position_after.max() <= 1e-12


# --- the other branch ---------------------------------------------------------------------------------------


def hinged(angle: float) -> lw.Model:
    """A body on a hinge about z that is given turned about x [rad]."""
    model = lw.Model()
    orientation = lw.rotation.about((1, 0, 0), angle)
    free_body(model, "door", (0, 0, 0), orientation=orientation)
    model.revolute(
        "ground", "door", at=((0, 0, 0), (0, 0, 0)), axis=((0, 0, 1), (0, 0, 1)), frames="body", name="hinge"
    )
    return model


@pytest.mark.parametrize("degrees", [10, 60, 85, 95, 120, 170])
def test_an_axis_takes_the_nearer_of_its_two_directions(degrees: int) -> None:
    assembly = lw.assemble(hinged(np.radians(degrees)))
    assert assembly.position_after.max() <= 1e-12
    assert np.degrees(assembly.turned[0]) == pytest.approx(min(degrees, 180 - degrees), abs=1e-6)
    assert assembly.opposed == (("hinge",) if degrees > 90 else ())


def test_an_axis_that_is_opposed_already_is_said_and_left() -> None:
    assembly = lw.assemble(hinged(np.pi))
    assert assembly.opposed == ("hinge",)
    assert assembly.turned[0] <= 1e-12
    assert "axes opposed in hinge" in str(assembly)


# --- velocities ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("make", [mechanisms.bricard, mechanisms.four_bar, driven_pendulum, slider_crank])
def test_velocities_change_by_what_joints_can_give(make: type[lw.Model]) -> None:
    """D v + Phi_t = 0 with the least kinetic energy of the change: M dv = D^T lambda."""
    given = perturbed(make(), 0.0, seed=2, speed=1.0)
    found = lw.assemble(given).model
    D, M, _, Phi_dot = evaluated(found)
    change = (state(found)[1] - state(given)[1]).ravel()
    assert np.abs(Phi_dot).max() <= 1e-11
    assert np.linalg.norm(change) > 0.1
    assert outside_range(D, M @ change) <= 1e-9


def test_a_driven_length_gives_its_value_and_its_rate() -> None:
    model = lw.Model()
    bob = free_body(model, "bob", (0.3, 0.4, 0), velocity=(1.0, 2.0, 3.0))
    length = lw.functions.polynomial(1.0, 0.25)
    model.distance("ground", bob, at=((0, 0, 0), (0.3, 0.4, 0)), length=length, name="rod")
    q, v = state(lw.assemble(model).model)
    along = np.array([0.6, 0.8, 0.0])
    assert q[0, :3] == pytest.approx(along, abs=1e-13)
    assert v[0, :3] == pytest.approx((1.0, 2.0, 3.0) + (0.25 - along @ (1.0, 2.0, 3.0)) * along, abs=1e-12)


# --- conflicts ----------------------------------------------------------------------------------------------


def too_short(rate: float = 0.0, length: float = 2.0) -> lw.Model:
    """A bob between two rods that do not reach it both, on a cart that has nothing to do with it."""
    model = lw.Model(name="short")
    bob, cart = free_body(model, "bob", (0, 0, 0)), free_body(model, "cart", (5, 0, 0))
    for name, x in (("left", -2.0), ("right", 2.0)):
        given = lw.functions.polynomial(length, rate)
        model.distance("ground", bob, at=((x, 0, 0), (0, 0, 0)), length=given, name=name)
    model.spherical("ground", cart, at=((5, 0, 0.5), (0, 0, 0)), frames="body", name="pin")
    return model


def test_joints_that_contradict_each_other_are_named_and_no_others() -> None:
    with pytest.raises(
        lw.NotConvergedError, match=r"'short': initial positions.*conflict.*(left|right) 0\.5"
    ) as caught:
        lw.assemble(too_short(length=1.5))
    assert sorted(caught.value.joints) == ["left", "right"]
    assert caught.value.residuals == pytest.approx({"left": 0.5, "right": 0.5}, abs=1e-6)
    assert caught.value.code == "conflicting_positions"


def test_rates_that_contradict_each_other_are_named() -> None:
    with pytest.raises(lw.NotConvergedError, match="initial velocities") as caught:
        lw.assemble(too_short(rate=-0.1))
    assert sorted(caught.value.joints) == ["left", "right"]
    assert caught.value.residuals == pytest.approx({"left": 0.1, "right": 0.1}, abs=1e-6)


def length_that_a_hinge_holds(seed: int, rate: float) -> lw.Model:
    """A hinge between two bodies, and a rod whose length it keeps but which has a rate."""
    rng = np.random.default_rng(seed)
    model = lw.Model(gravity=(0, 0, 0))
    first, second = (free_body(model, name, rng.normal(size=3)) for name in ("first", "second"))
    turned, axis, at = rng.normal(size=3), rng.normal(size=3), rng.normal(size=3)
    axis /= np.linalg.norm(axis)
    cross = np.cross(axis, turned)
    model.universal("ground", first, at=rng.normal(size=3), axes=(axis, cross), name="foot")
    model.revolute(first, second, at=at, axis=turned, name="hinge")
    end = at + 1.4 * rng.normal(size=3)
    length = lw.functions.polynomial(0.6, rate)
    other = end + 0.6 * cross / np.linalg.norm(cross)
    model.revolute_spherical(first, second, at=(end, other), axis=axis, length=length, name="rod")
    return model


@pytest.mark.parametrize("seed", [0, 14, 59, 114, 210])
def test_no_velocity_is_so_large_that_it_excuses_what_it_leaves(seed: int) -> None:
    """Whatever is returned meets the joints, by a least-squares solution of the test's own."""
    model = length_that_a_hinge_holds(seed, 0.2)
    core, system = model.compiled(), lw.System(model)
    at = system.evaluate(0.0, np.ravel(core.q0), 0.0 * np.ravel(core.v0))
    D = csr_array(at.D, shape=(len(at.Phi), core.v0.size)).toarray()
    least = D @ np.linalg.lstsq(D, -at.Phi_dot, rcond=1e-10)[0] + at.Phi_dot
    try:
        v = np.ravel(lw.assemble(model).model.compiled().v0)
    except lw.NotConvergedError as error:
        assert error.code == "conflicting_velocities" and np.abs(least).max() > 1e-9
    else:
        assert np.abs(least).max() < 1e-12
        assert np.abs(D @ v + at.Phi_dot).max() < 1e-9


@pytest.mark.parametrize("angle", [1e-2, 1e-4, 1e-6])
def test_large_velocities_near_a_dead_point_are_met(angle: float) -> None:
    """A bob on a rod of 1 m that is drawn in along it at 1 m/s goes cot(angle) across."""
    model = lw.Model()
    place = (np.cos(angle), np.sin(angle), 0)
    bob = free_body(model, "bob", place)
    model.distance("ground", bob, at=((0, 0, 0), place), length=1.0, name="rod")
    inward = lw.functions.polynomial(0.0, -1.0)
    model.displacement_driver("ground", bob, at=place, axis=(1, 0, 0), displacement=inward, name="draw")
    v = state(lw.assemble(model).model)[1][0, :2]
    assert v[0] == pytest.approx(-1.0, abs=1e-9 / angle)
    assert v[1] == pytest.approx(1.0 / np.tan(angle), rel=1e-14 / angle**2)


def test_a_held_body_that_is_out_of_reach_is_named_with_its_joint() -> None:
    model = gap()
    with pytest.raises(lw.NotConvergedError, match=r"while first, second are held.*ball 0\.8") as caught:
        lw.assemble(model, hold=["first", "second"])
    assert caught.value.joints == ["ball"] and caught.value.bodies == ["first", "second"]


def test_what_does_not_exist_is_refused() -> None:
    with pytest.raises(lw.ModelError, match="'secnd'; the nearest is 'second'"):
        lw.assemble(gap(), hold=["secnd"])
    for weight in (0.0, -1.0, float("nan"), float("inf")):
        with pytest.raises(lw.ModelError, match=f"'first': weight {weight}.*positive"):
            lw.assemble(gap(), weights={"first": weight})


def test_the_residuals_of_each_joint_are_listed_before_and_after() -> None:
    (residual,) = lw.assemble(gap()).residuals
    assert residual.joint == "ball"
    assert (residual.position_before, residual.velocity_before) == pytest.approx((0.8, 0.4), abs=1e-14)
    assert max(residual.position_after, residual.velocity_after) <= 1e-13


# --- what simulate does -------------------------------------------------------------------------------------


def slightly_off(size: float) -> lw.Model:
    return perturbed(mechanisms.bricard(), size, seed=4, speed=size)


def test_a_small_violation_is_corrected_before_the_run() -> None:
    model = slightly_off(1e-5)
    with pytest.warns(lw.LinkworkWarning, match=r"poses.*6 joints.*velocities.*corrected bodies by at most"):
        result = lw.simulate(model, t_end=0.0, step=1e-3)
    q, v = state(lw.assemble(model).model)
    assert result.q[0] == pytest.approx(q, abs=1e-12)
    assert result.v[0] == pytest.approx(v, abs=1e-12)
    assert result.violation.max() <= 1e-11
    assert "moved by at most" in result.manifest["assembled"]


def test_a_large_violation_is_refused_with_its_joints() -> None:
    with pytest.raises(lw.ModelError, match=r"poses do not satisfy 6 joints.*linkwork\.assemble") as caught:
        lw.simulate(slightly_off(0.05), t_end=0.1, step=1e-3)
    assert sorted(caught.value.joints) == [f"hinge {k}" for k in range(6)]
    assert max(caught.value.residuals.values()) > 0.01


def test_an_assembled_model_runs_without_a_remark() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        result = lw.simulate(lw.assemble(slightly_off(0.1)).model, t_end=0.1, step=1e-3)
    assert result.violation[:, 0].max() <= 1e-11
    assert result.manifest["assembled"] is None


def test_a_run_goes_on_from_one_of_its_frames() -> None:
    model = mechanisms.spatial_slider_crank()
    whole = lw.simulate(model, t_end=0.2, step=1e-3, record_every=100)
    half = model.with_initial_state(whole.q[1], whole.v[1])
    assert half.find("crank").name == "crank"
    rest = lw.simulate(half, t_end=0.1, step=1e-3)
    assert rest.q[-1] == pytest.approx(whole.q[-1], abs=1e-9)


def driven_chain(rates: np.ndarray) -> lw.Model:
    """Light rods of 1 m in a zigzag in space, each turned by a motor on the one before."""
    model = lw.Model(name="driven chain")
    before, end = model.ground, np.zeros(3)
    for k, rate in enumerate(rates):
        along = np.array([np.cos(0.5), 0, (-1) ** k * np.sin(0.5)])
        body = model.body(f"rod {k}", mass=1e-3, inertia=(1e-6, 1e-6, 1e-6), position=end + along / 2)
        place: dict[str, Any] = {"at": end, "axis": (0, k % 2, 1 - k % 2)}
        model.revolute(before, body, **place, name=f"pin {k}")
        angle = lw.functions.polynomial(0.0, float(rate))
        model.angle_driver(before, body, **place, angle=angle, name=f"motor {k}")
        before, end = body, end + along
    return model


@pytest.mark.parametrize("n", [20, 400])
def test_a_long_chain_of_motors_gets_the_velocities_that_they_add_up_to(n: int) -> None:
    """omega of a rod is the sum over the motors before it: their axes stand still in the initial pose."""
    rates = np.random.default_rng(3).normal(size=n)
    model = lw.assemble(driven_chain(rates)).model
    axes = np.array([(0, k % 2, 1 - k % 2) for k in range(n)])
    omega = np.cumsum(rates[:, None] * axes, axis=0)
    v = model.compiled().v0.reshape(n, 6)
    np.testing.assert_allclose(v[:, 3:], omega, rtol=0, atol=1e-9 * np.abs(omega).max())
    along = np.array([(np.cos(0.5), 0, (-1) ** k * np.sin(0.5)) for k in range(n)])
    across = np.cross(omega, along)
    center = np.cumsum(across, axis=0) - across / 2
    np.testing.assert_allclose(v[:, :3], center, rtol=0, atol=1e-9 * np.abs(center).max())


@pytest.mark.parametrize("n", [1, 2, 3, 30])
def test_motors_that_contradict_each_other_are_told_however_they_are_tried(n: int) -> None:
    model = driven_chain(np.random.default_rng(1).normal(size=n))
    other = lw.functions.polynomial(0.0, 7.0)
    model.angle_driver("ground", "rod 0", at=(0, 0, 0), axis=(0, 0, 1), angle=other, name="other")
    with pytest.raises(lw.NotConvergedError, match="initial velocities.*conflict.*(other|motor 0)"):
        lw.assemble(model)


@pytest.mark.parametrize("far", [0.0, 6e6])
def test_joints_that_contradict_each_other_do_so_beside_what_is_far_away(far: float) -> None:
    model = lw.Model()
    model.body("near", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0.5, 0, 0))
    model.body("far", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(far + 0.5, 0, 0))
    model.spherical("ground", "far", at=(far, 0, 0))
    model.spherical("ground", "near", at=(0, 0, 0))
    model.spherical("ground", "near", at=((1.001, 0, 0), (0.5, 0, 0)), frames="body")
    with pytest.raises(lw.NotConvergedError, match="were not found"):
        lw.assemble(model)


def belt(**initial: float) -> lw.Model:
    """Two wheels without gravity, one of which turns thrice as fast."""
    model = lw.Model(gravity=(0, 0, 0))
    for name, x in (("a", 0.0), ("b", 1.0)):
        model.body(
            name, mass=1.0, inertia=(0.1, 0.1, 0.1), position=(x, 0, 0), omega=(0, 0, initial.get(name, 0))
        )
        model.revolute("ground", name, at=(x, 0, 0), axis=(0, 0, 1), name=f"{name} pin")
    model.coupler([("a pin", 1.0), ("b pin", -3.0)], name="belt")
    return model


@pytest.mark.parametrize("how", [{"rtol": 1e-8}, {"step": 1e-3}])
def test_a_run_goes_on_from_where_it_has_come_to_rest(how: dict[str, float]) -> None:
    """No speed is left there to which the roundoff of velocities could be relative."""
    model = belt()
    model.rotational_spring_damper("ground", "a", axis=(0, 0, 1), stiffness=3.0, damping=0.3)
    model.force("b", torque=(0, 0, 30.0))
    rest = lw.simulate(model, t_end=20.0, progress=False, **how)
    onward = model.with_initial_state(rest.q[-1], rest.v[-1], rest.history[-1])
    found = lw.simulate(onward, t_end=0.1, progress=False, **how)
    assert np.abs(found.q[-1] - rest.q[-1]).max() < 1e-10


def test_roundoff_of_velocities_at_rest_is_no_violation() -> None:
    """As of cos(pi / 2): without a warning. A hundred times as much of what moves as slowly is one."""
    lw.simulate(belt(a=1e-16), t_end=0.01, step=1e-3, progress=False)
    with pytest.raises(lw.ModelError, match="belt 1e-10/s: more than"):
        lw.simulate(belt(a=1e-10), t_end=0.01, step=1e-3, progress=False)


def test_roundoff_of_velocities_is_beside_what_torques_would_give() -> None:
    """The belt is held by torques, which would give it some 1/s: 6e-11/s are none of a motion."""
    held = belt(a=6e-11)
    held.force("a", torque=(0, 0, -10.0))
    held.force("b", torque=(0, 0, 30.0))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = lw.simulate(held, t_end=0.01, step=1e-3, progress=False)
    assert np.abs(found.v[-1]).max() < 1e-10
