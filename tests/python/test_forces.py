"""Force elements against their closed forms."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest

G = 9.81


def ball(model: lw.Model, position: tuple[float, ...] = (0, 0, 0), **state: object) -> lw.Body:
    return model.body("ball", mass=2.0, inertia=(0.2, 0.2, 0.2), position=position, **state)


def run(model: lw.Model, t_end: float, step: float = 1e-3, **options: object) -> lw.Result:
    return lw.simulate(model, t_end, step, progress=False, **options)


# --- elastic elements ---------------------------------------------------------------------------------------


def test_a_bushing_swings_at_the_frequencies_of_its_six_springs() -> None:
    stiffness, rotational = np.array([50.0, 80.0, 20.0]), np.array([3.0, 1.0, 2.0])
    model = lw.Model(gravity=(0, 0, 0))
    start = np.array([1e-3, -2e-3, 1.5e-3])
    body = model.body("block", mass=2.0, inertia=(0.2, 0.3, 0.25), velocity=start, omega=10 * start)
    model.bushing(
        model.ground, body, at=(0, 0, 0), stiffness=stiffness, rotational_stiffness=rotational, name="mount"
    )
    result = run(model, 3.0)
    w = np.sqrt(stiffness / 2.0)
    turn = np.sqrt(rotational / np.array([0.2, 0.3, 0.25]))
    shift = start / w * np.sin(w * result.t[:, None])
    angles = 10 * start / turn * np.sin(turn * result.t[:, None])
    assert np.abs(result.q[:, 0, :3] - shift).max() < 1e-9
    assert np.abs(2 * result.q[:, 0, 4:] - angles).max() < 1e-4  # small angles to first order
    assert np.abs(result.energy_error).max() < 1e-12


def turned_bushing(q: np.ndarray, w: np.ndarray, C: tuple[float, ...]) -> tuple[np.ndarray, float]:
    """Torque on the body, inertial, and the potential; `w` in body axes."""
    model = lw.Model(gravity=(0, 0, 0))
    body = ball(model, orientation=q, omega=w)
    model.bushing("ground", body, at=((0, 0, 0), (0, 0, 0)), orientation=((1, 0, 0, 0), (1, 0, 0, 0)),
                  rotational_stiffness=(1.0, 20.0, 300.0), rotational_damping=C, frames="body")  # fmt: skip
    result = run(model, 1e-4, 1e-4)
    return result.force(0).torque[0], float(result.potential_energy[0])


def test_a_bushing_turns_by_the_potential_of_its_rotation_vector() -> None:
    """Not by -K phi, from which it is far at one radian where stiffnesses differ."""
    phi, still, h = np.array([1.0, 0.5, 0.2]), np.zeros(3), 1e-5
    q = lw.rotation.about(phi, np.linalg.norm(phi))
    torque, potential = turned_bushing(q, still, (0, 0, 0))
    assert potential == pytest.approx(phi @ (np.array([1.0, 20.0, 300.0]) * phi) / 2, rel=1e-12)
    A = lw.rotation.matrix(q)
    for axis, found in zip(np.eye(3), torque, strict=True):
        ahead, behind = (
            turned_bushing(
                lw.rotation.from_matrix(lw.rotation.matrix(lw.rotation.about(axis, s)) @ A), still, (0, 0, 0)
            )[1]
            for s in (h, -h)
        )
        assert found == pytest.approx(-(ahead - behind) / (2 * h), rel=1e-7)


def test_the_torque_of_a_bushing_is_the_one_of_its_docstring() -> None:
    phi, w, C = np.array([1.0, 0.5, 0.2]), np.array([0.3, -0.4, 0.7]), (0.3, 0.02, 0.5)
    a = float(np.linalg.norm(phi))
    tilde = np.cross(np.eye(3), phi)
    J = np.eye(3) + tilde / 2 + (1 / a**2 - (1 + np.cos(a)) / (2 * a * np.sin(a))) * tilde @ tilde
    expected = -J @ (np.array([1.0, 20.0, 300.0]) * phi + np.array(C) * (J @ w))
    np.testing.assert_allclose(turned_bushing(lw.rotation.about(phi, a), w, C)[0], expected, rtol=1e-12)


def test_a_bushing_turned_far_keeps_the_energy() -> None:
    model = lw.Model()
    body = ball(model, velocity=(0.3, 0.2, 0), omega=(2.0, 1.5, -1.0))
    model.bushing(
        model.ground, body, at=(0.1, 0, 0.2), stiffness=(300, 500, 400), rotational_stiffness=(2, 3, 4)
    )
    result = run(model, 2.0, 5e-4)
    assert np.arccos(result.q[:, 0, 3]).max() > 0.3  # half the angle
    assert np.abs(result.energy_error).max() < 1e-9


def test_a_hardening_spring_by_its_characteristic() -> None:
    """x_ddot = -(k x + a x^3) / m: v^2 = v_0^2 - (k x^2 + a x^4 / 2) / m."""
    x = np.linspace(-3, 3, 61)
    model = lw.Model(gravity=(0, 0, 0))
    body = ball(model, (2.0, 0, 0), velocity=(1.5, 0, 0))
    spring = lw.functions.polynomial(0, 30.0, 0, 20.0)
    model.nonlinear_spring_damper(model.ground, body, at=((0, 0, 0), (2, 0, 0)), spring=spring)
    result = run(model, 3.0)
    stretch = result.q[:, 0, 0] - 2.0
    squared = 1.5**2 - (30.0 * stretch**2 + 10.0 * stretch**4) / 2.0
    assert np.abs(result.v[:, 0, 0] ** 2 - squared).max() < 1e-8

    tabulated = lw.Model(gravity=(0, 0, 0))
    body = ball(tabulated, (2.0, 0, 0), velocity=(1.5, 0, 0))
    table = lw.functions.table(x, 30.0 * x + 20.0 * x**3)  # a cubic spline is exact
    tabulated.nonlinear_spring_damper(tabulated.ground, body, at=((0, 0, 0), (2, 0, 0)), spring=table)
    assert np.abs(run(tabulated, 3.0).q - result.q).max() < 1e-9


def test_springs_by_characteristics_store_energy_and_a_poor_run_shows_what_it_loses() -> None:
    """A table, a number, a sum with a harmonic; free at a length that grows: g . v = -dV/dt + power."""
    x = np.linspace(-3, 3, 61)
    functions = lw.functions
    for spring, potential in (
        (functions.table(x, 30.0 * x + 20.0 * x**3), lambda x: 15.0 * x**2 + 5.0 * x**4),
        (30.0, lambda x: 15.0 * x**2),
        (
            functions.polynomial(1, 30.0) + functions.harmonic(4.0, 3.0, offset=2.0),
            lambda x: 3.0 * x + 15.0 * x**2 + 4.0 / 3.0 * (1 - np.cos(3.0 * x)),
        ),
    ):
        model = lw.Model(gravity=(0, 0, 0))
        body = ball(model, (2.0, 0, 0), velocity=(1.5, 0, 0))
        free = functions.polynomial(2.0, 0.1)
        points = ((0, 0, 0), (2, 0, 0))
        model.nonlinear_spring_damper(
            model.ground, body, at=points, spring=spring, damper=1.0, free_length=free
        )
        poor, good = (
            lw.simulate(model, 1.0, 2e-2, name, on_inaccurate="pass") for name in ("heun", "dop853")
        )
        for found in (poor, good):
            stretch = found.q[:, 0, 0] - 2.0 - 0.1 * found.t
            assert found.potential_energy == pytest.approx(potential(stretch), abs=1e-12)
        assert np.abs(good.energy_error).max() < 1e-10
        lost = poor.energy - good.energy - np.interp(poor.t, good.t, poor.work - good.work)
        assert np.abs(poor.energy_error - lost).max() < 1e-10
        assert np.abs(lost).max() > 1e-5


def test_a_spring_by_a_function_of_python_does_work() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    body = ball(model, (2.0, 0, 0), velocity=(1.5, 0, 0))
    points = ((0, 0, 0), (2, 0, 0))
    model.nonlinear_spring_damper(model.ground, body, at=points, spring=lambda x: 30.0 * x)
    found = run(model, 1.0)
    assert not found.potential_energy.any()
    assert found.work == pytest.approx(found.kinetic_energy - found.kinetic_energy[0], abs=1e-9)


def test_a_motion_that_leaves_a_table_is_an_error() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    body = ball(model, (2.0, 0, 0), velocity=(50.0, 0, 0))
    table = lw.functions.table([-0.5, 0.5], [-1.0, 1.0])
    model.nonlinear_spring_damper(model.ground, body, at=((0, 0, 0), (2, 0, 0)), spring=table, name="stop")
    pattern = r"'stop': spring, pull \[N\] over the extension \[m\], has no value at .*leaves its table"
    for steps in ({"step": 1e-3}, {"rtol": 1e-6}):
        with pytest.raises(lw.OptionError, match=pattern) as caught:
            lw.simulate(model, 1.0, **steps)
        assert 0.0 <= caught.value.time <= 0.02  # the step begins before 0.5 m of stretch


def test_a_bending_spring_is_a_spherical_pendulum_without_weight() -> None:
    """Whatever the direction, (J + m l^2) beta_ddot = -k beta."""
    for axis in ((1, 0, 0), (0.6, 0.8, 0)):
        model = lw.Model(gravity=(0, 0, 0))
        body = model.body("rod", mass=1.0, inertia=(0.4, 0.4, 0.1), omega=0.5 * np.array(axis))
        model.spherical(model.ground, body, at=(0, 0, 0))
        model.bending_spring(model.ground, body, axis=(0, 0, 1), stiffness=10.0)
        result = run(model, 2.0)
        rate = np.sqrt(10.0 / 0.4)
        beta = 0.5 / rate * np.sin(rate * result.t)
        tilt = np.arccos(np.clip(lw.rotation.matrix(result.q[:, 0, 3:])[:, 2, 2], -1, 1))
        assert np.abs(tilt - np.abs(beta)).max() < 1e-7


# --- resistances and motors ---------------------------------------------------------------------------------


def test_a_falling_body_approaches_the_speed_at_which_drag_bears_it() -> None:
    """v = v_t tanh(g t / v_t), v_t^2 = m g / c."""
    model = lw.Model()
    model.drag(model.ground, ball(model), at=(0, 0, 0), coefficient=0.8)
    result = run(model, 4.0)
    terminal = np.sqrt(2.0 * G / 0.8)
    assert np.abs(result.v[:, 0, 2] + terminal * np.tanh(G * result.t / terminal)).max() < 1e-10
    assert np.abs(result.energy_error).max() < 1e-9


def test_linear_damping_slows_all_motion_alike() -> None:
    """v_dot = -c v / m, J w_dot = -C w, about any axis: both fall exponentially."""
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("ball", mass=2.0, inertia=(0.2, 0.2, 0.2), velocity=(1, -2, 3), omega=(0.3, 2, -1))
    model.linear_damping(model.ground, body, at=(0, 0, 0), damping=0.8, rotational_damping=0.1)
    result = run(model, 2.0)
    assert np.abs(result.v[:, 0, :3] - np.outer(np.exp(-0.4 * result.t), (1, -2, 3))).max() < 1e-10
    assert np.abs(result.v[:, 0, 3:] - np.outer(np.exp(-0.5 * result.t), (0.3, 2, -1))).max() < 1e-10
    assert np.abs(result.energy_error).max() < 1e-9


def test_linear_damping_does_not_resist_a_common_rigid_motion() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    omega, at = np.array([0.3, -1.0, 2.0]), np.array([1.0, 0.4, -0.2])
    one = model.body("one", mass=1.0, inertia=(1, 1, 1), omega=omega, velocity=(1, 0, 0))
    other = model.body(
        "other",
        mass=1.0,
        inertia=(1, 1, 1),
        position=at,
        omega=omega,
        velocity=np.array([1, 0, 0]) + np.cross(omega, at),
    )
    model.linear_damping(one, other, at=(0.3, 0.2, 0.1), damping=3.0, rotational_damping=2.0)
    core = model.compiled()
    assert np.abs(lw.System(model).accelerations(0.0, core.q0, core.v0)[0]).max() < 1e-14


def test_a_motor_runs_up_along_its_curve() -> None:
    """J w_dot = n_0 (1 - w / w_0): w = w_0 (1 - exp(-n_0 t / (J w_0)))."""
    model = lw.Model()
    rotor = ball(model)
    model.revolute(model.ground, rotor, at=(0, 0, 0), axis=(0, 0, 1))
    curve = lw.functions.table([-10.0, 50.0], [1.2, 0.0])
    model.motor(model.ground, rotor, at=(0, 0, 0), axis=(0, 0, 1), curve=curve)
    result = run(model, 3.0)
    slope = 1.2 / 60.0
    assert np.abs(result.v[:, 0, 5] - 50.0 * (1 - np.exp(-slope / 0.2 * result.t))).max() < 1e-9


def test_coulomb_friction_stops_a_slider() -> None:
    """It loses mu m g / m in speed each second until the transition speed."""
    model = lw.Model(gravity=(0, 0, 0))
    body = ball(model, velocity=(1.0, 0, 0))
    model.translational(model.ground, body, at=(0, 0, 0), axis=(1, 0, 0))
    model.translational_friction(
        model.ground, body, at=(0, 0, 0), axis=(1, 0, 0), coulomb=1.0, transition=1e-3
    )
    result = run(model, 3.0)
    sliding = result.t < 1.95
    assert np.abs(result.v[sliding, 0, 0] - (1 - 0.5 * result.t[sliding])).max() < 1e-6
    assert np.abs(result.v[result.t > 2.1, 0, 0]).max() < 1e-6
    assert np.abs(result.energy_error).max() < 1e-6


def test_a_stop_returns_a_hinge_with_its_speed() -> None:
    """An elastic stop turns the motion round after half a period of the stop's spring."""
    model = lw.Model(gravity=(0, 0, 0))
    body = ball(model, omega=(0, 0, 1.0))
    model.revolute(model.ground, body, at=(0, 0, 0), axis=(0, 0, 1))
    model.rotational_stop(
        model.ground, body, at=(0, 0, 0), axis=(0, 0, 1), lower=-0.5, upper=0.7, stiffness=2000.0
    )
    result = run(model, 1.6, 1e-4)
    half = np.pi / np.sqrt(2000.0 / 0.2)
    assert result.v[-1, 0, 5] == pytest.approx(-1.0, abs=1e-5)
    angle = 2 * np.arctan2(result.q[-1, 0, 6], result.q[-1, 0, 3])
    assert angle == pytest.approx(0.7 - (1.6 - 0.7 - half), abs=1e-5)


# --- contact ------------------------------------------------------------------------------------------------


def bounce(law: str, restitution: float) -> float:
    """Rebound over approach of a ball that falls at 2 m/s onto a plane, without gravity."""
    model = lw.Model(gravity=(0, 0, 0))
    body = ball(model, (0, 0, 0.1), velocity=(0, 0, -2.0))
    model.sphere_plane_contact(
        model.ground, body, at=((0, 0, 0), (0, 0, 0.1)), normal=(0, 0, 1), radius=0.1, stiffness=1e6,
        hysteresis=lw.contact_hysteresis(law, restitution),
    )  # fmt: skip
    return float(run(model, 0.05, 1e-5).v[-1, 0, 2] / 2.0)


@pytest.mark.parametrize("law", ("hunt_crossley", "lankarani_nikravesh", "flores"))
def test_contact_without_hysteresis_gives_all_back(law: str) -> None:
    assert bounce(law, 1.0) == pytest.approx(1.0, abs=1e-6)


def test_laws_of_contact_lose_what_their_authors_say() -> None:
    """Nearly elastic, all return e; far from it, only that of Flores and others does, roughly."""
    for law in ("hunt_crossley", "lankarani_nikravesh", "flores"):
        assert bounce(law, 0.95) == pytest.approx(0.95, abs=0.01)
    assert bounce("flores", 0.5) == pytest.approx(0.5, abs=0.08)
    assert bounce("hunt_crossley", 0.5) > 0.6
    assert bounce("lankarani_nikravesh", 0.5) > bounce("hunt_crossley", 0.5)


def test_balls_exchange_their_speeds() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    first = ball(model, velocity=(1.0, 0, 0))
    second = model.body("second", mass=2.0, inertia=(0.2, 0.2, 0.2), position=(0.25, 0, 0))
    model.sphere_sphere_contact(
        first, second, at=((0, 0, 0), (0.25, 0, 0)), radius_a=0.1, radius_b=0.1, stiffness=1e6
    )
    result = run(model, 0.1, 1e-5)
    assert result.v[-1, :, 0] == pytest.approx([0.0, 1.0], abs=1e-7)


@pytest.mark.parametrize(("away", "integrator", "rtol"), [(1e3, "dop853", 1e-8), (1e5, "dopri5", 1e-6)])
def test_balls_collide_far_from_the_origin_in_as_many_steps_and_without_a_spin(
    away: float, integrator: str, rtol: float
) -> None:
    """No force has an arm: what their places in space are rounded by is none."""

    def collision(away: float) -> lw.Result:
        model, there = lw.Model(gravity=(0, 0, 0)), np.array((away, away / 2, 0))
        for name, apart in (("a", np.zeros(3)), ("b", np.array((0.5, 0.01, 0)))):
            velocity = (10, 0, 0) if name == "a" else (0, 0, 0)
            model.body(name, mass=0.01, inertia=(4e-7,) * 3, position=there + apart, velocity=velocity)
        model.sphere_sphere_contact(
            "a",
            "b",
            at=(there, there + np.array((0.5, 0.01, 0))),
            radius_a=0.01,
            radius_b=0.01,
            stiffness=1e9,
        )
        return lw.simulate(model, 0.1, rtol=rtol, integrator=integrator, progress=False)

    here, there = collision(0), collision(away)
    assert there.statistics["steps"] <= 1.5 * here.statistics["steps"]
    assert np.abs(there.v[-1, :, 3:]).max() == 0
    assert there.v[-1, :, :3] == pytest.approx(here.v[-1, :, :3], abs=1e-3)


def test_a_ball_thrown_onto_the_ground_ends_rolling() -> None:
    """Sliding friction turns v into rolling at v / (1 + J / (m r^2)), for any coefficient."""
    model = lw.Model()
    radius, stiffness = 0.5, 1e7
    depth = (2.0 * G / stiffness) ** (1 / 1.5)
    body = ball(model, (0, 0, radius - depth), velocity=(1.0, 0, 0))
    model.sphere_plane_contact(
        model.ground, body, at=((0, 0, 0), (0, 0, radius - depth)), normal=(0, 0, 1), radius=radius,
        stiffness=stiffness, friction=0.3, transition=1e-3,
    )  # fmt: skip
    result = run(model, 1.0, 1e-4)
    assert result.v[-1, 0, 0] == pytest.approx(1.0 / (1 + 0.2 / (2.0 * radius**2)), abs=1e-3)
    assert result.v[-1, 0, 4] * (radius - depth) == pytest.approx(result.v[-1, 0, 0], abs=1e-3)


@pytest.mark.parametrize(("law", "restitution"), (("hertz", 0.5), ("flores", 0.0), ("flores", 1.5)))
def test_restitution_that_no_law_has_is_refused(law: str, restitution: float) -> None:
    with pytest.raises(lw.OptionError):
        lw.contact_hysteresis(law, restitution)


# --- forces of the user's own -------------------------------------------------------------------------------


def planets() -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    model.bodies(
        "planet", mass=1.0, inertia=(0.1, 0.1, 0.1), position=[(1, 0, 0), (0, 4, 0)],
        velocity=[(0, 1, 0), (-0.5, 0, 0)],
    )  # fmt: skip
    return model


def attraction(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """To the origin, with 1 / r^2: circles of period 2 pi r^1.5."""
    r = q[..., :3]
    out = np.zeros_like(v)
    out[..., :3] = -r / np.linalg.norm(r, axis=-1, keepdims=True) ** 3
    return out


def test_a_vectorized_force_moves_planets_in_circles() -> None:
    model = planets()
    model.user_force(attraction)
    result = run(model, 16 * np.pi, 1e-2)
    assert np.abs(result.q[-1, :, :3] - [(1, 0, 0), (0, 4, 0)]).max() < 1e-5
    assert np.abs(np.linalg.norm(result.q[:, :, :3], axis=2) - [1, 4]).max() < 1e-6
    assert np.abs(result.energy_error).max() < 1e-7  # its work is the change of kinetic energy


def test_a_force_on_some_bodies_or_one_is_the_same() -> None:
    expected = planets()
    expected.user_force(attraction)
    some, each = planets(), planets()
    some.user_force(attraction, [some.find("planet[1]"), some.find("planet[0]")])
    each.user_force(attraction, "planet[0]")
    each.user_force(attraction, "planet[1]", name="on the other")
    for model in (some, each):
        assert np.array_equal(run(model, 1.0, 1e-2).q, run(expected, 1.0, 1e-2).q)


SOURCE = """
#include <math.h>
#include <stdint.h>
void attraction(double t, int64_t n, const double* q, const double* v, double* g, void* data) {
  for (int64_t k = 0; k < n; ++k, q += 7, g += 6) {
    const double r = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
    for (int c = 0; c < 3; ++c) g[c] -= *(const double*)data * q[c] / (r * r * r);
  }
}
"""


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no C compiler")
def test_a_compiled_force_is_the_same_without_python(tmp_path: Path) -> None:
    (tmp_path / "force.c").write_text(SOURCE)
    library = tmp_path / "force.so"
    subprocess.run(["gcc", "-shared", "-fPIC", "-O2", "-o", library, tmp_path / "force.c", "-lm"], check=True)
    strength = ctypes.c_double(1.0)
    model, expected = planets(), planets()
    model.compiled_force(ctypes.CDLL(str(library)).attraction, data=ctypes.addressof(strength))
    expected.user_force(attraction)
    assert np.abs(run(model, 2.0, 1e-2).q - run(expected, 2.0, 1e-2).q).max() < 1e-12


@pytest.mark.parametrize("data", ["x", [1.0], 1.5, None])
def test_data_of_a_compiled_force_without_an_address_are_refused(data: Any) -> None:
    with pytest.raises(lw.ModelError, match=r"'push': data .* is not an array of NumPy; .* or an address"):
        lw.mechanisms.pendulum().compiled_force(12345, data=data, name="push")


def test_a_compiled_function_of_another_signature_is_refused() -> None:
    numbers = ctypes.POINTER(ctypes.c_double)
    model = planets()
    for taken in ((ctypes.c_double,), (ctypes.c_double, ctypes.c_int32, *[numbers] * 3, ctypes.c_void_p),
                  (ctypes.c_float, ctypes.c_int64, *[numbers] * 3, ctypes.c_void_p)):  # fmt: skip
        function = ctypes.CFUNCTYPE(None, *taken)(lambda *given: None)
        with pytest.raises(lw.ModelError, match=r"'compiled force 1': takes .*, not \(double t"):
            model.compiled_force(function)


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
def test_what_a_function_behind_ctypes_raises_ends_the_run() -> None:
    numbers = ctypes.POINTER(ctypes.c_double)
    kind = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_int64, *[numbers] * 3, ctypes.c_void_p)

    def fails(t: float, n: int, q: Any, v: Any, g: Any, data: Any) -> None:
        raise ValueError("no wind here")

    model = planets()
    model.compiled_force(kind(fails), name="wind")
    with pytest.raises(lw.NotFiniteError, match="'wind'"):
        run(model, 1.0)


def test_a_force_that_goes_wrong_is_named() -> None:
    model = planets()
    with pytest.raises(lw.ModelError, match="not a function"):
        model.user_force(3.0)  # type: ignore[arg-type]
    with pytest.raises(lw.ModelError, match="no address"):
        model.compiled_force("attraction")
    model.user_force(lambda t, q, v: v[:3], "planet[0]", name="short")
    with pytest.raises(lw.ModelError, match=r"'short'.*\(3,\)"):
        run(model, 1.0)

    torn = planets()
    torn.user_force(lambda t, q, v: np.full_like(v, np.nan if t > 0.5 else 0.0), name="torn")
    with pytest.raises(lw.NotFiniteError, match="force 'torn'") as caught:
        run(torn, 1.0, 1e-2)
    assert caught.value.state is not None


def test_an_error_in_a_users_function_reaches_the_user() -> None:
    model = planets()

    def broken(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        raise ZeroDivisionError("in my own function")

    model.user_force(broken)
    with pytest.raises(ZeroDivisionError, match="my own"):
        run(model, 1.0)


@pytest.mark.parametrize("kind", ["spring_damper", "translational_spring_damper"])
def test_a_road_moves_a_spring_and_with_a_force_its_damper(kind: str) -> None:
    """Free length and force as a road has them are a spring and a damper on a plate that is driven."""
    functions = lw.functions
    road, rate = functions.harmonic(0.1, 7.0), functions.harmonic(0.7, 7.0, np.pi / 2)
    height = []
    for driven in (False, True):
        model = lw.Model(gravity=(0, 0, 0))
        car = model.body("car", mass=1.0, inertia=(1, 1, 1), position=(0, 0, 2))
        model.translational("ground", car, at=(0, 0, 0), axis=(0, 0, 1))
        common = {"stiffness": 100.0, "damping": 4.0}
        if driven:
            plate = model.body("plate", mass=1.0, inertia=(1, 1, 1), velocity=(0, 0, 0.7))
            model.translational("ground", plate, at=(0, 0, 0), axis=(0, 0, 1), name="lift")
            model.drive("lift", position=road)
            model.spring_damper(plate, car, at=((0, 0, 0), (0, 0, 2)), free_length=2.0, **common)
        elif kind == "spring_damper":
            at = ((0, 0, 0), (0, 0, 2))
            model.spring_damper("ground", car, at=at, free_length=2.0 + road, force=-4.0 * rate, **common)
        else:
            model.translational_spring_damper("ground", car, at=(0, 0, 2), axis=(0, 0, 1),
                                              free_displacement=road, force=4.0 * rate, **common)  # fmt: skip
        result = lw.simulate(model, 1.0, rtol=1e-9, times=[0.5, 1.0], progress=False)
        height.append(result.body("car").position[:, 2])
    np.testing.assert_allclose(height[0], height[1], atol=1e-7)
