"""Inerters against closed forms, against wheels that are coupled to the joints, and by every method."""

from __future__ import annotations

from pathlib import Path

import linkwork as lw
import numpy as np
import pytest
from linkwork import _core
from linkwork.arrays import Floats
from linkwork.options import TABLE

COMPLIANT = {it.name: it.compliant for it in _core.formulations()}

AXES = ((0, 0, 1), (0, 1, 0), (1, 0.2, 0))


def arm(joints: int = 3, inertance: float = 0.3, *, wheels: bool = False) -> lw.Model:
    """Hinges about changing axes, each with a rotor: an inerter, or a wheel on the ground and a coupler."""
    model = lw.Model()
    links = [
        model.body(f"link {k}", mass=1 + 0.3 * k, inertia=(0.02, 0.1, 0.12), position=(0.5 + k, 0, 0))
        for k in range(joints)
    ]
    for k, (a, b) in enumerate(zip([model.ground, *links], links, strict=False)):
        at, axis = (k, 0, 0), AXES[k % 3]
        model.revolute(a, b, at=at, axis=axis, name=f"hinge {k}")
        if not wheels:
            model.rotational_inerter(a, b, at=at, axis=axis, inertance=inertance, name=f"rotor {k}")
            continue
        wheel = model.body(f"wheel {k}", mass=1.0, inertia=(inertance,) * 3, position=(0, k, 0))
        model.revolute(model.ground, wheel, at=(0, k, 0), axis=(0, 0, 1), name=f"bearing {k}")
        model.coupler([(f"bearing {k}", "angle", 1.0), (f"hinge {k}", "angle", -1.0)], name=f"gear {k}")
    return model


def test_a_pendulum_with_a_rotor_swings_as_its_inertias_say() -> None:
    model = lw.Model()
    rod = model.body("rod", mass=2.0, inertia=(0.01, 0.2, 0.2), position=(0.5, 0, 0))
    model.revolute("ground", rod, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    model.rotational_inerter("ground", rod, at=(0, 0, 0), axis=(0, 1, 0), inertance=0.7, name="rotor")
    result = lw.simulate(model, 1.0, 1e-3, progress=False)
    spin = 2.0 * 9.81 * 0.5 / (0.2 + 2.0 * 0.25 + 0.7)
    assert result.angular_acceleration[0, 0] == pytest.approx([0, spin, 0], abs=1e-13)
    assert result.force("rotor").torque[0] == pytest.approx([0, -0.7 * spin, 0], abs=1e-13)
    assert np.abs(result.energy_error).max() < 1e-10


def test_an_inerter_between_free_bodies_shares_a_force_as_their_masses_and_it_say() -> None:
    """No joints: m x'' + b (x'' - y'') = f, m y'' = b (x'' - y''), and sideways as without it."""
    model = lw.Model(gravity=(0, 0, 0))
    first = model.body("first", mass=1.0, inertia=(1, 1, 1))
    second = model.body("second", mass=3.0, inertia=(1, 1, 1), position=(2, 0, 0))
    model.inerter(first, second, at=((0, 0, 0), (2, 0, 0)), inertance=5.0)
    model.force(first, force=(4.0, 1.0, 0))
    result = lw.simulate(model, 0.01, 1e-3, progress=False)
    relative = 4.0 / (1 + 5 * (1 + 1 / 3))
    assert result.acceleration[0, 0] == pytest.approx([4 - 5 * relative, 1, 0], abs=1e-13)
    assert result.acceleration[0, 1] == pytest.approx([5 * relative / 3, 0, 0], abs=1e-13)


@pytest.mark.filterwarnings("ignore:.*depends on the choice of x axes")
def test_momentum_is_kept_by_inerters_between_bodies() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    bodies = [
        model.body(f"body {k}", mass=1.0 + k, inertia=(0.3, 0.5, 0.7), position=(k, k * k, 0.3 * k),
                   velocity=(0.3, -k, 0.2), omega=(k, 1.0, 2.0 - k))
        for k in range(3)
    ]  # fmt: skip
    model.inerter(bodies[0], bodies[1], at=((0, 0, 0), (1, 1, 0.5)), inertance=2.0)
    model.rotational_inerter(bodies[1], bodies[2], at=(1, 1, 0), axis=(0, 0, 1), inertance=0.4)
    model.translational_inerter(bodies[0], bodies[2], at=(1, 0, 0), axis=(1, 0, 0), inertance=1.5)
    result = lw.simulate(model, 0.5, 1e-3, progress=False)
    mass = model.compiled().mass
    linear = np.einsum("n,knj->kj", mass, result.velocity)
    A = lw.rotation.matrix(result.orientation)
    spin = np.einsum("knij,njl,knl->kni", A, model.compiled().inertia, result.omega)
    angular = (spin + np.cross(result.position, mass[:, None] * result.velocity)).sum(axis=1)
    assert np.abs(linear - linear[0]).max() < 1e-12
    assert np.abs(angular - angular[0]).max() < 1e-10
    assert np.abs(result.energy_error).max() < 1e-9


def test_rotors_do_what_wheels_do_that_are_coupled_to_the_joints() -> None:
    rotors, wheels = (lw.simulate(arm(wheels=it), 0.5, 1e-3, progress=False) for it in (False, True))
    assert np.abs(rotors.acceleration[-1] - wheels.acceleration[-1, :3]).max() < 1e-9
    assert np.abs(rotors.kinetic_energy - wheels.kinetic_energy).max() < 1e-10
    for joint in ("hinge 0", "hinge 1", "hinge 2"):
        a, b = (it.reaction(joint) for it in (rotors, wheels))
        assert np.abs(a.force - b.force).max() < 1e-9
        assert np.abs(a.torque - b.torque).max() < 1e-9


@pytest.mark.parametrize("inertance", (1e-6, 0.3, 1e5))
def test_accelerations_and_reactions_are_those_with_wheels_whatever_the_inertance(inertance: float) -> None:
    rotors, wheels = (
        lw.simulate(arm(6, inertance, wheels=it), 1e-3, 1e-3, progress=False) for it in (False, True)
    )
    assert np.abs(rotors.acceleration[0] - wheels.acceleration[0, :6]).max() < 2e-12
    for k in range(6):
        a, b = (it.reaction(f"hinge {k}") for it in (rotors, wheels))
        scale = max(np.abs(b.force[0]).max(), np.abs(b.torque[0]).max())
        assert np.abs(a.force[0] - b.force[0]).max() < 1e-12 * scale
        assert np.abs(a.torque[0] - b.torque[0]).max() < 1e-12 * scale


@pytest.mark.parametrize("formulation", TABLE["formulation"].choices)
@pytest.mark.parametrize("solver", TABLE["linear_solver"].choices)
def test_every_method_has_them(formulation: str, solver: str) -> None:
    options = {"formulation": formulation, "linear_solver": solver, "on_inaccurate": "pass"}
    try:
        found = lw.simulate(arm(), 0.1, 1e-3, progress=False, **options)
    except lw.OptionError as error:
        pytest.skip(str(error))
    usual = lw.simulate(arm(), 0.1, 1e-3, progress=False)
    near = 1e-5 if COMPLIANT[formulation] else 1e-10
    if not COMPLIANT[formulation]:
        assert np.abs(found.acceleration[0] - usual.acceleration[0]).max() < 1e-12  # of 10 m/s2
    assert np.abs(found.acceleration - usual.acceleration).max() < near
    assert np.abs(found.energy_error).max() < near


@pytest.mark.parametrize("integrator", ("hem4", "phem56", "dopri5", "dop853", "abm4"))
def test_every_kind_of_integrator_has_them(integrator: str) -> None:
    how = {"stabilization": "projection"} if "hem" in integrator else {}
    found = lw.simulate(arm(), 0.2, 1e-3, integrator=integrator, progress=False, **how)
    usual = lw.simulate(arm(), 0.2, 1e-3, progress=False)
    assert np.abs(found.acceleration[-1] - usual.acceleration[-1]).max() < 1e-7


def test_closed_loops_and_redundant_joints_have_them() -> None:
    """The middle of a four-bar's beam moves as with a mass that is as large along the circle."""
    model = lw.mechanisms.four_bar(2)
    model.rotational_inerter("ground", "post 0", at=(0, 0, 0), axis=(0, 0, 1), inertance=2.5)
    rotor = lw.simulate(model, 0.4, 1e-3, progress=False)
    heavy = lw.mechanisms.four_bar(2)
    bodies = [heavy.find(f"post {k}") for k in range(3)]
    core = heavy.compiled()
    inertia = np.array(core.inertia)
    spin = rotor.body("post 0").omega
    assert np.abs(rotor.energy_error).max() < 1e-8
    # T = (sum J + b) w^2 / 2 of the posts, which turn with w, and that of beams of 1 kg
    posts = sum(inertia[it.index][1, 1] + 0.25 for it in bodies)
    w = np.linalg.norm(spin, axis=1)
    assert rotor.kinetic_energy == pytest.approx(0.5 * (posts + 2.0 + 2.5) * w**2, abs=1e-9)


def test_files_and_analyses_know_them(tmp_path: Path) -> None:
    model = arm()
    model.save(tmp_path / "arm.yaml")
    again = lw.Model.load(tmp_path / "arm.yaml")
    a, b = (lw.simulate(it, 0.1, 1e-3, progress=False) for it in (model, again))
    assert np.array_equal(a.q, b.q)


def test_modes_of_a_spring_and_an_inerter_are_those_of_their_masses() -> None:
    model = lw.Model(gravity=(0, 0, 0))
    block = model.body("block", mass=2.0, inertia=(1, 1, 1), position=(1, 0, 0))
    model.translational("ground", block, at=(1, 0, 0), axis=(1, 0, 0), name="guide")
    model.spring_damper("ground", block, at=((0, 0, 0), (1, 0, 0)), stiffness=300.0)
    model.inerter("ground", block, at=((0, 0, 0), (1, 0, 0)), inertance=1.0)
    modes = lw.linearize(model)
    assert modes.frequencies == pytest.approx([10.0], rel=1e-9)  # rad/s


@pytest.mark.parametrize("b", (0.05, 0.3))
def test_modes_of_a_disk_that_spins_have_what_its_inerters_do_while_they_turn_with_it(b: float) -> None:
    """On a Cardan joint, isotropic: A z'' - i C W z' + k z + b (z'' - 2 i W z' - W^2 z) = 0 of the tilt z."""
    A, C, W, k = 0.2, 0.4, 20.0, 30.0
    model = lw.Model(gravity=(0, 0, 0))
    shaft = model.body("shaft", mass=1.0, inertia=(0.2, 0.2, 0.1), omega=(0, 0, W))
    disk = model.body("disk", mass=3.0, inertia=(A, A, C), omega=(0, 0, W))
    model.revolute("ground", shaft, at=(0, 0, 0), axis=(0, 0, 1), name="bearing")
    model.universal(shaft, disk, at=(0, 0, 0), axes=((1, 0, 0), (0, 1, 0)), name="cardan")
    model.bushing(shaft, disk, at=(0, 0, 0), rotational_stiffness=(k, k, 0))
    for axis in ((1, 0, 0), (0, 1, 0)):
        model.rotational_inerter(shaft, disk, at=(0, 0, 0), axis=axis, inertance=b)
    found = lw.linearize(model).eigenvalues
    expected = np.abs(np.roots([A + b, -1j * (C + 2 * b) * W, k - b * W**2]))
    assert np.sort(np.abs(found.imag))[-2:] == pytest.approx(np.sort(expected), rel=1e-9)


@pytest.mark.parametrize("solver", ["block", "eigen_ldlt", "dense", "cholmod"])
def test_inerters_are_inertia_of_bodies_without_any(solver: str) -> None:
    """Two massless disks on a shaft: b_1 x'' + k (x - y) = 0 and b_2 y'' = k (x - y)."""
    model = lw.Model()
    disks = [
        model.body(f"disk {k}", mass=0, inertia=(0, 0, 0), position=(k, 0, 0), omega=(rate, 0, 0))
        for k, rate in enumerate((0.6, -0.3))
    ]
    for k, (disk, b) in enumerate(zip(disks, (0.5, 1.0), strict=True)):
        model.revolute("ground", disk, at=(k, 0, 0), axis=(1, 0, 0), name=f"bearing {k}")
        model.rotational_inerter("ground", disk, at=(k, 0, 0), axis=(1, 0, 0), inertance=b)
    model.rotational_spring_damper(*disks, at=(0.5, 0, 0), axis=(1, 0, 0), stiffness=12.0)
    result = lw.simulate(model, 1.0, 1e-3, linear_solver=solver, progress=False)
    for k, rate in enumerate((0.6, -0.3)):
        assert result.coordinate(f"bearing {k}", "angle").value == pytest.approx(
            rate / 6 * np.sin(6 * result.t), abs=1e-10
        )
    assert np.abs(result.energy_error).max() < 1e-10
    loose = lw.Model()
    body = loose.body("disk", mass=0, inertia=(0, 0, 0))
    loose.cylindrical("ground", body, at=(0, 0, 0), axis=(1, 0, 0))
    loose.rotational_inerter("ground", body, at=(0, 0, 0), axis=(1, 0, 0), inertance=1.0)
    with pytest.raises(lw.LinkworkError, match="'disk' has a motion without inertia"):
        lw.simulate(loose, 1.0, 1e-3, linear_solver=solver, progress=False)


def test_a_blow_shares_momentum_as_rotors_have_it() -> None:
    """A driver whose velocity jumps: as with wheels that are coupled to the joints."""
    results = []
    for wheels in (False, True):
        model = arm(3, wheels=wheels)
        model.drive("hinge 0", position=lw.functions.piecewise_polynomial([0, 0.1, 0.3], [[0, 0], [0, 2]]))
        results.append(lw.simulate(model, 0.25, rtol=1e-10, progress=False))
    rotors, wheels_ = results
    assert np.abs(rotors.v[-1, :3] - wheels_.v[-1, :3]).max() < 1e-6


def test_a_driven_joint_takes_the_torque_that_its_rotor_needs() -> None:
    """Inverse dynamics, and forward dynamics of the same motion."""
    model = arm(1)
    model.drive("hinge 0", position=lw.functions.polynomial(0, 0, 1.5), name="motor")
    driven = lw.inverse_dynamics(model, np.linspace(0, 1, 11)).motion
    forward = lw.simulate(model, 1.0, 1e-3, record_every=100, progress=False)
    torque = driven.reaction("motor").torque[:, 2]
    inertia = 0.12 + 0.25 + 0.3
    assert torque == pytest.approx(np.full(11, inertia * 3.0), abs=1e-9)
    assert forward.reaction("motor").torque[:, 2] == pytest.approx(torque, abs=1e-6)
    assert driven.kinetic_energy == pytest.approx(forward.kinetic_energy, abs=1e-8)


def test_studies_vary_them_in_lanes() -> None:
    many = lw.simulate_many(arm(), {"rotor 0.inertance": [0.1, 0.5]}, 0.05, step=1e-3, progress=False)
    assert many.alone == {}
    for k, inertance in enumerate((0.1, 0.5)):
        model = arm()
        changed = model.without("rotor 0")
        changed.rotational_inerter("ground", "link 0", at=(0, 0, 0), axis=AXES[0], inertance=inertance)
        single = lw.simulate(changed, 0.05, 1e-3, progress=False)
        assert np.abs(many.results[k].v[-1] - single.v[-1]).max() < 1e-11


@pytest.mark.parametrize("inertance", (0.0, -1.0, np.nan, np.inf, lw.functions.harmonic(1.0, 1.0)))
def test_an_inertance_is_a_positive_number(inertance: object) -> None:
    model = lw.Model()
    rod = model.body("rod", mass=2.0, inertia=(0.01, 0.2, 0.2), position=(0.5, 0, 0))
    with pytest.raises(lw.ModelError, match="inertance"):
        model.rotational_inerter("ground", rod, at=(0, 0, 0), axis=(0, 1, 0), inertance=inertance)


@pytest.mark.parametrize("inertance", (0.0, 1e-3, 1.0, 1e6))
@pytest.mark.parametrize("seed", (10, 34))
def test_which_reactions_are_unique_does_not_depend_on_inerters(seed: int, inertance: float) -> None:
    """The kernel of D^T is that of a weld and a cylindrical joint on the same body alone."""
    rng = np.random.default_rng(seed)

    def unit() -> Floats:
        x = rng.normal(size=3)
        return np.asarray(x / np.linalg.norm(x))

    def across(axis: Floats) -> Floats:
        x = np.cross(axis, unit())
        return np.asarray(x / np.linalg.norm(x))

    model = lw.Model()
    model.body("base", mass=60, inertia=(8, 8, 8), position=rng.normal(size=3))
    model.fixed("ground", "base", at=rng.normal(size=3), name="weld")
    model.cylindrical("ground", "base", at=rng.normal(size=3), axis=unit(), name="rail")
    model.body("arm", mass=150, inertia=(20, 20, 20), position=rng.normal(size=3))
    model.point_on_line("ground", "arm", at=rng.normal(size=3), axis=unit())
    axis = unit()
    model.revolute_translational("base", "arm", at=rng.normal(size=3), axes=(axis, across(axis)))
    shaft = unit()
    centers = [rng.normal(size=3)]
    centers.append(centers[0] + across(shaft))
    for name, center in zip("ab", centers, strict=True):
        model.body(name, mass=2000, inertia=(300, 400, 500), position=center + 0.1 * rng.normal(size=3))
        model.revolute("arm", name, at=center, axis=shaft)
    model.gear("a", "b", at=centers, axis=shaft, teeth_a=13, teeth_b=21)
    if inertance:
        model.inerter("arm", "b", at=(rng.normal(size=3), rng.normal(size=3)), inertance=inertance)
    found = lw.simulate(model, 1e-3, 1e-3, on_inaccurate="pass", progress=False)
    shared = [
        name for name, unique in zip(found.joint_names, found.unique_reactions, strict=True) if not unique
    ]
    assert shared == ["weld", "rail"]
