"""Parts of a model that nothing connects are judged as if each were alone, and the worst counts."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from ensembles import alone
from linkwork.accuracy.measures import Bodies, Differences, Sampled, Scales

OMEGA = 100.0  # rad/s


def vibrating(model: lw.Model, name: str, amplitude: float) -> None:
    """x = A sin(omega t) [m]."""
    model.body(name, mass=1, inertia=(0.01,) * 3, velocity=(amplitude * OMEGA, 0, 0))
    model.translational("ground", name, at=(0, 0, 0), axis=(1, 0, 0))
    model.translational_spring_damper("ground", name, at=(0, 0, 0), axis=(1, 0, 0), stiffness=OMEGA**2)


def slewing(model: lw.Model) -> None:
    """A boom of 200 m and 10 t at half a radian per second."""
    r, omega = 200.0, 0.5
    model.body("boom", mass=1e4, inertia=(4e6,) * 3, position=(r, 0, 500), velocity=(0, omega * r, 0),
               omega=(0, 0, omega))  # fmt: skip
    model.revolute("ground", "boom", at=(0, 0, 500), axis=(0, 0, 1))


def hanging(model: lw.Model) -> None:
    """In its equilibrium, with a preload that rounding shakes."""
    model.body("load", mass=5e3, inertia=(10,) * 3, position=(0, 5, -2))
    model.revolute("ground", "load", at=(0, 5, 0), axis=(0, 1, 0))
    model.translational_spring_damper("load", "ground", at=(0, 5, 0), axis=(1, 0, 0), stiffness=1e3)


def made(*parts: Any, gravity: float = 0.0) -> lw.Model:
    model = lw.Model(gravity=(0, 0, -gravity))
    for part in parts:
        part(model)
    return model


def small(model: lw.Model) -> None:
    vibrating(model, "small", 0.01)


def quick(model: lw.Model, **how: Any) -> lw.Result:
    return lw.simulate(model, 1.0, **{"progress": False, "on_inaccurate": "pass", **how})


def verdict_of(result: lw.Result) -> lw.Verdict:
    assert result.verdict is not None
    return result.verdict


@pytest.mark.parametrize("how", [{}, {"verify": True}])
@pytest.mark.parametrize("step", [1e-2, 5e-3, 1e-3])
def test_a_vibration_that_steps_do_not_follow_is_wrong_beside_a_large_boom_as_well(
    step: float, how: dict[str, Any]
) -> None:
    result = quick(made(small, slewing), step=step, **how)
    off = np.abs(result.position[:, 0, 0] - 0.01 * np.sin(OMEGA * result.t)).max() / 0.01
    single, both = verdict_of(quick(made(small), step=step, **how)), verdict_of(result)
    assert both.error > off / 3
    assert single.error / 2 < both.error < 2 * single.error
    assert both.level == single.level


def test_the_message_names_a_body_of_the_part_that_is_off() -> None:
    with pytest.warns(lw.LinkworkWarning, match="body 'small': the step is too long"):
        quick(made(slewing, small), step=1e-2, on_inaccurate="warn")
    assert verdict_of(quick(made(slewing, small), step=1e-2)).body == "small"
    assert verdict_of(quick(made(small), step=1e-2)).body == ""


@pytest.mark.parametrize("larger", [1e-6, 1e6])
def test_motions_of_any_size_and_speed_beside_each_other_are_judged_alike(larger: float) -> None:
    one, both = lw.Model(gravity=(0, 0, 0)), lw.Model(gravity=(0, 0, 0))
    for model, amplitudes in ((one, [0.01]), (both, [0.01, 0.01 * larger])):
        for k, amplitude in enumerate(amplitudes):
            vibrating(model, f"body {k}", amplitude)
    for step in (5e-3, 5e-4):
        expected = verdict_of(quick(one, step=step)).error
        assert expected / 3 < verdict_of(quick(both, step=step)).error < 3 * expected


@pytest.mark.parametrize("how", [{"step": 5e-4}, {"rtol": 1e-8}, {"step": 5e-4, "verify": True}])
def test_what_hangs_at_rest_beside_a_motion_raises_no_alarm(how: dict[str, Any]) -> None:
    assert verdict_of(quick(made(small, hanging, gravity=9.81), **how)).level == "good"


def test_a_part_that_is_pushed_late_is_seen_beside_one_that_moves_all_the_time() -> None:
    def pushed(model: lw.Model) -> None:
        model.body("late", mass=1e-3, inertia=(1e-6,) * 3, position=(0, 0, 5))
        model.translational("ground", "late", at=(0, 0, 5), axis=(1, 0, 0))
        model.translational_spring_damper("ground", "late", at=(0, 0, 5), axis=(1, 0, 0), stiffness=250.0)
        model.force("late", force=(lambda t: 1e-3 * np.exp(-(((t - 0.8) / 4e-3) ** 2)), 0, 0))

    wrong = verdict_of(quick(made(slewing, pushed), step=4e-3))  # 2 rad of 500 rad/s
    assert wrong.level == "wrong" and wrong.body == "late"
    assert verdict_of(quick(made(slewing, pushed), step=1e-4)).level == "good"


def test_errors_against_another_motion_are_relative_to_each_part() -> None:
    coarse, fine = (Sampled.of(result) for result in (quick(made(small, slewing), step=5e-3, record_every=1),
                    quick(made(small, slewing), step=5e-4, record_every=10)))  # fmt: skip
    bodies = Bodies.of(quick(made(small, slewing), step=5e-3).header)
    scales = Scales.of(fine, bodies)
    assert scales.length[bodies.part] == pytest.approx([0.01, 200.0], rel=0.3)
    assert scales.speed[bodies.part] == pytest.approx([1.0, 100.0], rel=0.3)
    states = Differences.between(coarse, fine).states(scales).max(axis=0)
    assert states[0] > 0.02 and states[1] < 1e-6


def test_verdicts_of_lanes_are_those_of_single_runs() -> None:
    models = []
    for amplitude in (0.01, 0.02, 1e-5):
        model = made(slewing)
        vibrating(model, "small", amplitude)
        models.append(model)
    found = lw.simulate_many(models, None, 1.0, step=5e-3, progress=False, on_inaccurate="pass")
    assert found.alone == {}
    for k, model in enumerate(models):
        verdict = verdict_of(found.member(k))
        single = verdict_of(alone(model, 1.0, 5e-3))  # which follows errors of reactions as they grow, too
        assert verdict == replace(single, reactions=verdict.reactions)
        assert verdict.body == "small"


def swinging(name: str, mass: float, length: float) -> Any:
    def add(model: lw.Model) -> None:
        sine, cosine = np.sin(1.5), -np.cos(1.5)
        model.body(name, mass=mass, inertia=(mass * length**2 / 12,) * 3,
                   position=(length + length / 2 * sine, 0, length / 2 * cosine))  # fmt: skip
        model.revolute("ground", name, at=(length, 0, 0), axis=(0, 1, 0))

    return add


def weight_on_a_spring(model: lw.Model) -> None:
    model.body("weight", mass=0.01, inertia=(1e-5,) * 3, position=(2, 0, 0), velocity=(0, 0, 1))
    model.translational("ground", "weight", at=(2, 0, 0), axis=(0, 0, 1))
    model.nonlinear_spring_damper("ground", "weight", at=((2, 0, -1), (2, 0, 0)), free_length=1.0,
                                  spring=lw.functions.polynomial(0, 1, 0, 40))  # fmt: skip


def of_a_hinge_with_inertia(model: lw.Model) -> None:
    swinging("rotor", 0.01, 0.1)(model)
    model.rotational_inerter("ground", "rotor", at=(0.1, 0, 0), axis=(0, 1, 0), inertance=1e-4)


@pytest.mark.parametrize(("integrator", "step"), [("rk4", 0.015), ("heun", 2e-3), ("rk3", 8e-3)])
@pytest.mark.parametrize(
    "part", [swinging("pendulum", 0.01, 0.1), weight_on_a_spring, of_a_hinge_with_inertia]
)
def test_energy_that_a_small_part_loses_counts_as_if_it_were_alone(
    part: Any, integrator: str, step: float
) -> None:
    """A motion of tenths of a second is late by what it loses; a tonne on 20 m has all of the energy."""

    def judged(*parts: Any) -> lw.Verdict:
        how: dict[str, Any] = {"step": step, "integrator": integrator, "record_every": 5}
        model = made(*parts, gravity=9.81)
        return verdict_of(lw.simulate(model, 20.0, progress=False, on_inaccurate="pass", **how))

    single, both = judged(part), judged(part, swinging("arm", 1000, 20))
    assert both.energy == pytest.approx(single.energy, rel=0.2)
    assert both.error == pytest.approx(single.error, rel=0.5), "by other errors that are followed"


@pytest.mark.parametrize("law", ["joint", "body"])
def test_work_of_a_law_of_the_users_own_is_no_energy_that_the_run_made(law: str) -> None:
    model = made(swinging("one", 1, 1), swinging("other", 1, 2), gravity=9.81)
    if law == "joint":
        model.joint_force("revolute 1", lambda t, angle, rate: -0.5 * rate)
    else:
        model.user_force(lambda t, q, v: [*(-0.5 * v[:3]), 0, 0, 0], "one")
    assert verdict_of(lw.simulate(model, 5.0, 1e-3, progress=False)).error < 1e-6
