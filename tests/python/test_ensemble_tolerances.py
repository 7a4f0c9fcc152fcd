"""Ensembles whose steps follow tolerances: each run tries its own steps, to the bits of itself alone."""

from __future__ import annotations

import warnings
from typing import Any

import linkwork as lw
import numpy as np
import pytest
import random_mechanisms
from ensembles import KNOWN, alone, bits, known_variants, variants, with_functions
from hypothesis import given
from linkwork import mechanisms
from linkwork.options import names as option_names
from remembering_laws import delayed

pytestmark = pytest.mark.filterwarnings("ignore")

RTOL = 1e-6


def many(models: list[lw.Model], t_end: float, **options: Any) -> lw.EnsembleResult:
    return lw.simulate_many(models, None, t_end, **{"rtol": RTOL, "progress": False, **options})


def same(result: lw.Result, single: lw.Result) -> bool:
    """Motion, steps and verdict."""
    counts = ("steps", "rejected_steps", "singular_poses", "row_changes")
    found = [[it.statistics[name] for name in counts] for it in (result, single)]
    return bits(result) == bits(single) and result.verdict == single.verdict and found[0] == found[1]


@pytest.mark.parametrize("pair", ["bs32", "dopri5", "tsit5", "dop853"])
#: The other one is stiff.
@pytest.mark.parametrize("name", sorted(set(KNOWN) - {"flyball_governor"}))
def test_a_run_in_a_lane_has_the_bits_of_its_run_by_itself(name: str, pair: str) -> None:
    models = known_variants(name, 11, seed=len(name))
    rtol = 1e-4 if pair == "bs32" else RTOL
    options: dict[str, Any] = {"integrator": pair, "rtol": rtol, "record_every": 1}
    found = many(models, 0.03, threads=1, **options)
    assert found.alone == {}
    for k in (0, 7, 10):  # more than there are lanes: the last ones were taken up by lanes that were free
        assert same(found.member(k), alone(models[k], 0.03, **options))


@pytest.mark.parametrize("stabilization", option_names()["stabilization"])
def test_it_has_them_with_every_stabilization(stabilization: str) -> None:
    models = variants(mechanisms.bricard(), 3, seed=2)
    found = many(models, 0.5, stabilization=stabilization)
    assert found.alone == {}
    assert same(found.member(1), alone(models[1], 0.5, rtol=RTOL, stabilization=stabilization))


@random_mechanisms.examples(12)
@given(mechanism=random_mechanisms.mechanisms())
def test_random_mechanisms_with_all_joints_and_forces_have_them(mechanism: Any) -> None:
    options: dict[str, Any] = {"assemble": False, "rtol": 1e-5}
    try:
        single = alone(mechanism.model, 3e-3, **options)
    except lw.LinkworkError as error:
        found = many([mechanism.model, mechanisms.chain(2)], 3e-3, **options)
        assert found.status.tolist() == ["failed", "finished"]
        assert found.errors[0]["type"] == type(error).__name__
        return
    found = many([mechanism.model] * 3, 3e-3, threads=1, **options)
    assert bits(found.member(0)) == bits(found.member(2)) == bits(single)
    assert found.alone == {}


def driven_in_turn(first: float, second: float) -> lw.Model:
    """Two rods on a pin and an elbow, both driven; one of the drivers does not move."""
    model = lw.Model(name="driven")
    upper = model.body("upper", mass=1.0, inertia=(0.01, 0.1, 0.1), position=(0.5, 0, 0))
    lower = model.body("lower", mass=1.0, inertia=(0.01, 0.1, 0.1), position=(1.5, 0, 0))
    axis: dict[str, Any] = {"axis": (0, 1, 0)}
    model.revolute(model.ground, upper, at=(0, 0, 0), name="pin", **axis)
    model.revolute(upper, lower, at=(1, 0, 0), name="elbow", **axis)
    for name, pair, at, amplitude in (("shoulder", (model.ground, upper), (0, 0, 0), first),
                                      ("arm", (upper, lower), (1, 0, 0), second)):  # fmt: skip
        motion: Any = 0.0
        if amplitude:
            motion = lw.functions.harmonic(
                amplitude=amplitude, frequency=1.0, phase=np.pi / 2, offset=-amplitude
            )
        model.angle_driver(*pair, angle=motion, at=at, name=name, **axis)
    return model


def test_a_lane_forgets_the_motion_of_the_drivers_that_it_had() -> None:
    """More members than lanes: the last ones drive another joint than those before."""
    models = [driven_in_turn(1e-8, 0.0)] * 8 + [
        driven_in_turn(0.0, 0.1)
    ] * 3  # so little that wrong steps end, too
    found = many(models, 0.2, threads=1)
    assert found.alone == {}
    for k in (0, 8, 10):
        assert same(found.member(k), alone(models[k], 0.2, rtol=RTOL))


def pushed(kind: str) -> lw.Model:
    model = mechanisms.chain(2)
    calls: list[float] = []

    def remembers(t: float) -> float:
        calls.append(t)
        return 0.1 * t

    pulse = lw.functions.expression("exp(-((t - 0.11) / 0.0005)**2)")
    model.force(model.find("link[0]"), force=(pulse if kind == "pulse" else remembers, 0.0, 0.0), name="push")
    return model


@pytest.mark.parametrize("kind", ["pulse", "memory"])
def test_verdicts_know_of_pulses_and_of_functions_that_remember(kind: str) -> None:
    found = many([pushed(kind) for _ in range(3)], 0.2, threads=1)
    assert found.alone == {}
    verdict, single = found.member(1).verdict, alone(pushed(kind), 0.2, rtol=RTOL).verdict
    assert verdict is not None and single is not None
    assert verdict.error == pytest.approx(single.error, rel=0.2)  # where a pulse is looked for takes its time
    assert (verdict.sentence == single.sentence) or kind == "pulse"


def falls(t: float, state: Any) -> float:
    return float(state.body("link[1]").position[2]) + 0.05


def thrown_back(t: float, state: Any) -> bool:
    """An impact on the last link; the run ends at a late one."""
    state.body("link[1]").velocity = (0.0, 0.0, 1.0)
    return t > 0.3


def test_events_in_lanes_are_those_of_runs_alone() -> None:
    options: dict[str, Any] = {"events": [lw.Event(falls, name="falls", direction=-1, change=thrown_back)]}
    models = variants(mechanisms.chain(2), 11, seed=5)
    found = many(models, 1.0, **options)
    assert found.alone == {}
    for k in (0, 7, 10):
        result, single = found.member(k), alone(models[k], 1.0, rtol=RTOL, **options)
        assert len(result.events) == len(single.events) >= 2 and result.t[-1] < 1.0
        assert [it.t for it in result.events] == [it.t for it in single.events]
        assert same(result, single)


def test_an_event_that_fails_in_one_lane_fails_that_member_alone() -> None:
    def broken(t: float, state: Any) -> float:
        if state.body("link[1]").velocity[2] < -0.5:
            raise ArithmeticError("too fast")
        return 1.0

    models = mechanisms.chain(2)
    found = lw.simulate_many(models, {"gravity[2]": [-9.81, -0.01, -0.02]}, 0.3, rtol=RTOL, progress=False,
                             events=[lw.Event(broken, name="broken")])  # fmt: skip
    assert found.status.tolist() == ["failed", "finished", "finished"]
    assert "too fast" in found.errors[0]["message"]
    without = lw.simulate_many(models, {"gravity[2]": [-0.01]}, 0.3, rtol=RTOL, progress=False)
    assert bits(found.member(1)) == bits(without.member(0))


def test_functions_of_time_and_full_turns_are_those_of_each_lane() -> None:
    models = [with_functions(0.1 * (k + 1), 5.0 + k) for k in range(10)]
    found = many(models, 0.3)
    assert found.alone == {}
    for k in (0, 9):
        assert same(found.member(k), alone(models[k], 0.3, rtol=RTOL))


def test_bits_do_not_depend_on_place_neighbors_and_threads() -> None:
    models = variants(mechanisms.spatial_slider_crank(), 21, seed=3)
    order = np.random.default_rng(4).permutation(len(models))
    first = many(models, 0.3, threads=1)
    for threads in (1, 2, 3):
        shuffled = many([models[k] for k in order], 0.3, threads=threads)
        for place, k in enumerate(order):
            assert bits(shuffled.member(place)) == bits(first.member(int(k)))


def test_runs_leap_over_singular_poses_and_change_their_rows_by_themselves() -> None:
    models = [*variants(mechanisms.four_bar(1), 5, seed=5), *(mechanisms.planetary_gear() for _ in range(3))]
    found = many(models, 1.0)
    passed = 0
    for k, model in enumerate(models):
        passed += found.member(k).statistics["singular_poses"] + found.member(k).statistics["row_changes"]
        assert same(found.member(k), alone(model, 1.0, rtol=RTOL))
    assert passed > 0


def bouncing(k: int, contact: bool) -> lw.Model:
    """A rod that falls onto a stop, a slider between two, and a ball on the floor."""
    model = lw.Model(name="bouncing")
    rod = model.body("rod", mass=1.0 + 0.1 * k, inertia=(0.01, 0.1, 0.1), position=(0.5, 0, 0))
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    model.rotational_stop(model.ground, rod, at=(0, 0, 0), axis=(0, 1, 0), lower=-1, upper=0.1, stiffness=1e4)
    slider = model.body(
        "slider", mass=2.0, inertia=(0.1, 0.1, 0.1), position=(0, 2, 0), velocity=(1 + 0.1 * k, 0, 0)
    )
    model.translational(model.ground, slider, at=(0, 2, 0), axis=(1, 0, 0), name="rail")
    model.translational_stop("ground", slider, at=(0, 2, 0), axis=(1, 0, 0), lower=-0.02, upper=0.03,
                             stiffness=1e4, damping=5.0)  # fmt: skip
    if contact:
        center = (0, -1, 0.06 + 0.01 * k)
        ball = model.body("ball", mass=0.5, inertia=(1e-3, 1e-3, 1e-3), position=center)
        model.sphere_plane_contact(
            "ground", ball, at=((0, 0, 0), center), normal=(0, 0, 1), radius=0.05, stiffness=1e5,
            hysteresis=lw.contact_hysteresis("flores", 0.8),
        )  # fmt: skip
    return model


@pytest.mark.parametrize("pair", ["bs32", "dopri5"])
@pytest.mark.parametrize("contact", [False, True])
def test_steps_in_lanes_end_where_contacts_and_stops_begin(contact: bool, pair: str) -> None:
    models = [bouncing(k, contact) for k in range(11)]
    found = many(models, 0.25, threads=1, integrator=pair)
    assert found.alone == {}
    for k in (0, 7, 10):
        result = found.member(k)
        assert same(result, alone(models[k], 0.25, rtol=RTOL, integrator=pair))
        turns = np.diff(np.sign(result.v[:, 1, 0]))
        assert np.count_nonzero(turns) >= 3


def grazing(depth: float) -> lw.Model:
    """A pendulum that turns back on a soft stop, so far beyond where that begins [rad]."""
    model = lw.Model(name="grazing")
    rod = model.body("rod", mass=1.0, inertia=(0.01, 0.1, 0.1), position=(0, 0, -0.5), velocity=(1.0, 0, 0),
                     omega=(0, -2.0, 0))  # fmt: skip
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, -1, 0), name="pin")
    highest = np.arccos(1 - 0.35 * 2.0**2 / 2 / (9.81 * 0.5))
    model.rotational_stop(model.ground, rod, at=(0, 0, 0), axis=(0, -1, 0), lower=-3, upper=highest - depth,
                          stiffness=0.1)  # fmt: skip
    return model


def test_lanes_see_a_contact_that_comes_and_goes_within_a_step() -> None:
    models = [grazing(depth) for depth in (1e-5, 1e-4, 3e-4, 1e-3, 3e-3)]
    found = many(models, 1.0, rtol=1e-4, integrator="dopri5")
    assert found.alone == {}
    for k, model in enumerate(models):
        assert same(found.member(k), alone(model, 1.0, rtol=1e-4, integrator="dopri5"))


def failing(t: float) -> lw.Model:
    """A force that is no number from t [s] on."""
    model = mechanisms.chain(3)
    burst = lambda now: 0.0 if now < t else float("nan")  # noqa: E731
    model.force(model.find("link[0]"), force=(burst, 0.0, 0.0), name="burst")
    return model


def test_what_has_another_structure_or_fails_disturbs_no_other() -> None:
    good = variants(mechanisms.chain(3), 20, seed=8)
    before = many(good, 0.2)
    models = list(good)
    for place in (3, 11):
        models[place] = failing(0.05)
    models[7] = bouncing(0, contact=True)
    after = many(models, 0.2, threads=2)
    for k in range(20):
        if k not in {3, 7, 11}:
            assert after.status[k] == "finished"
            assert bits(after.member(k)) == bits(before.member(k))
    assert after.status[[3, 11]].tolist() == ["failed", "failed"]
    assert after.errors[3]["type"] == "StepSizeError"
    assert after.errors[3]["reached"] == pytest.approx(0.05, abs=5e-3)
    assert not {*after.alone} - {3, 11}
    assert same(after.member(7), alone(models[7], 0.2, rtol=RTOL))


def test_studies_that_follow_tolerances_run_in_lanes() -> None:
    asked = {"end": "final", "force": "reaction('crank pin').force.max"}
    study = lw.sweep(mechanisms.spatial_slider_crank(), {"gravity[2]": [-9.81, -5.0, -1.0]}, asked,
                     t_end=0.1, rtol=RTOL, processes=1, progress=False)  # fmt: skip
    assert study.manifest["lanes"]
    model = mechanisms.spatial_slider_crank()
    source = lw.Ensemble(model, {"gravity[2]": [-9.81, -5.0, -1.0]})
    single = source.single(1, 0.1, rtol=RTOL, record_every=1, progress=False)
    assert study.outputs["force"][1] == np.linalg.norm(single.reaction("crank pin").force, axis=1).max()


def test_members_that_share_a_delay_line_come_to_an_end_each_with_its_own() -> None:
    """In lanes they would read each other's angles at ever more times."""

    def build(law: Any, omega: float) -> lw.Model:
        model = lw.Model()
        moving: Any = {"omega": (0, omega, 0), "velocity": (-0.3 * omega, 0, 0)}
        bar = model.body("bar", mass=1.0, inertia=(0.003, 0.03, 0.03), position=(0, 0, -0.3), **moving)
        model.revolute("ground", bar, at=(0, 0, 0), axis=(0, 1, 0), name="hinge")
        model.joint_force("hinge", law)
        return model

    how: Any = {"rtol": 1e-6, "on_inaccurate": "pass", "deterministic": True}
    law, omega = delayed(), [3.0, 2.0, 2.5]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.LinkworkWarning)
        many = lw.simulate_many(lambda omega: build(law, omega), {"omega": omega}, 0.2, **how)
        alone = [lw.simulate(build(delayed(), it), 0.2, progress=False, **how) for it in omega]
    assert all(np.array_equal(many.member(k).q[-1], alone[k].q[-1]) for k in range(3))
