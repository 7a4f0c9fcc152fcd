"""Ensembles: a member has the bits of its run by itself, whatever runs beside it; or says why it is alone."""

from __future__ import annotations

import math
import os
import subprocess
import sys
import warnings
from collections.abc import Sequence
from typing import Any

import linkwork as lw
import numpy as np
import pytest
import random_mechanisms
from ensembles import (
    KNOWN,
    alone,
    bits,
    carousel,
    crank_rocker,
    known_variants,
    variants,
    with_functions,
    with_inerters,
)
from hypothesis import given
from light_mechanisms import light_mechanisms
from linkwork import _core, functions, mechanisms
from linkwork.modeling.files import record_of
from linkwork.options import names as option_names
from linkwork.studies.variants import Changed

pytestmark = pytest.mark.filterwarnings("ignore")


def many(
    models: Sequence[lw.Model], t_end: float, step: float | None = None, **options: Any
) -> lw.EnsembleResult:
    return lw.simulate_many(
        models, None, t_end, step, **{"deterministic": True, "progress": False, **options}
    )


@pytest.mark.parametrize("stabilization", option_names()["stabilization"])
@pytest.mark.parametrize("name", KNOWN)
def test_a_lane_has_the_bits_of_its_run_by_itself(name: str, stabilization: str) -> None:
    models, step = known_variants(name, 5, seed=len(name)), KNOWN[name][1]
    options: dict[str, Any] = {"record_every": 7, "stabilization": stabilization}
    found = many(models, 40 * step, step, threads=1, **options)
    assert found.alone == {}
    for k in (0, 2, 4):
        assert bits(found.member(k)) == bits(alone(models[k], 40 * step, step, **options))


@pytest.mark.parametrize("inertance", [0.3, 1e-5])
@pytest.mark.parametrize("name", sorted({*KNOWN} - {"double_wishbone", "rolling_disc"}))
def test_inerters_beside_joints_and_elsewhere_are_those_by_themselves(name: str, inertance: float) -> None:
    """Each member has other ones; delta robot and governor have masses far apart, too."""
    make, step = KNOWN[name]
    models = [with_inerters(make(), seed=7, inertance=inertance * factor) for factor in (1, 2, 30)]
    found = many(models, 30 * step, step, threads=1, record_every=7)
    assert found.alone == {}
    for k in (0, 2):
        assert bits(found.member(k)) == bits(alone(models[k], 30 * step, step, record_every=7))
    how: dict[str, Any] = {"rtol": 1e-6, "record_every": 1}
    followed = lw.simulate_many(models, None, 10 * step, deterministic=True, progress=False, **how)
    assert bits(followed.member(1)) == bits(alone(models[1], 10 * step, **how))


@pytest.mark.parametrize("moment", [1e-4, 0.0])
def test_inerters_of_thin_rods_are_refined_as_by_themselves(moment: float) -> None:
    models = [slender(with_inerters(mechanisms.chain(6), 2, 0.1 * k), moment) for k in (1, 2, 3)]
    found = many(models, 0.05, 1e-3, threads=1, record_every=7)
    assert found.alone == {}
    for k in (0, 2):
        assert bits(found.member(k)) == bits(alone(models[k], 0.05, 1e-3, record_every=7))


@pytest.mark.parametrize("seed", [34, 60])
def test_the_first_frame_is_that_by_itself_however_small_its_pivots(seed: int) -> None:
    """Masses so far apart that pivots look singular where nothing is known of the mechanism yet."""
    random = np.random.default_rng(seed)
    masses = 10 ** random.uniform(-6, 6, 4)
    random = np.random.default_rng(seed)
    model = lw.Model()
    before: lw.Body = model.ground
    for k, mass in enumerate(masses):
        turned = random.standard_normal(4)
        body = model.body(
            f"rod {k}", mass=mass, inertia=np.array((0.1, 0.13, 0.15)) * mass,
            position=(k + 0.5, 0.1 * k, 0.2), orientation=turned / np.linalg.norm(turned),
        )  # fmt: skip
        if k % 2:
            model.spherical(before, body, at=(k, 0.1 * k, 0))
        else:
            model.revolute(before, body, at=(k, 0.1 * k, 0), axis=random.standard_normal(3))
        before = body
    found = many([model], 1e-4, 1e-5)
    assert found.alone == {}
    assert bits(found.member(0)) == bits(alone(model, 1e-4, 1e-5))


@pytest.mark.parametrize("on_violation", ["record", "project", "stop"])
@pytest.mark.parametrize("level", ["position", "velocity"])
def test_who_stays_within_a_limit_of_violation_runs_in_lanes_and_the_others_as_by_themselves(
    level: str, on_violation: str
) -> None:
    models = [mechanisms.spatial_slider_crank(speed) for speed in (0.1, 6.0, 0.2, 12.0, 1.0)]
    step, t_end, row = 0.005, 0.2, ["position", "velocity"].index(level)
    drift = [float(alone(it, t_end, step).recorded("violation")[:, row].max()) for it in models]
    limit = float(np.sqrt(np.sort(drift)[2] * np.sort(drift)[3]))
    options: dict[str, Any] = {"violation_limit": {level: limit}, "on_violation": on_violation}
    found = many(models, t_end, step, **options)
    beyond = {k for k, it in enumerate(drift) if it > limit}
    assert set(found.alone) == beyond == {1, 3}
    for k, model in enumerate(models):
        if on_violation == "stop" and k in beyond:
            assert found.status[k] == "failed" and found.errors[k]["type"] == "ViolationError"
            continue
        single = alone(model, t_end, step, **options)
        assert bits(found.member(k)) == bits(single)
        assert bool(single.violations) == (k in beyond)


@pytest.mark.parametrize("stabilization", ["projection", "position_projection", "velocity_projection"])
def test_projections_are_those_by_themselves_with_drivers_verdicts_and_thin_rods(stabilization: str) -> None:
    models = [with_functions(0.3 + 0.1 * k, 5.0 + k) for k in range(9)]
    models += [slender(mechanisms.four_bar(2), 1e-4), *variants(mechanisms.bricard(), 2, seed=1)]
    found = many(models, 0.2, 1e-3, stabilization=stabilization)
    assert found.alone == {}
    for k in (0, 8, 9, 11):
        single = alone(models[k], 0.2, 1e-3, stabilization=stabilization)
        assert bits(found.member(k)) == bits(single)
        assert single.verdict is not None and found.accuracy[k] == single.verdict.error
        assert single.recorded("violation").max() < 1e-10 or stabilization != "projection"


def test_a_projection_that_finds_no_pose_fails_as_by_itself_and_disturbs_no_other() -> None:
    """A rod that a driver pulls longer than it is: no pose closes the loop from then on."""
    models = [torn(rate) for rate in (0.0, 0.5, 4.0, 0.1)]
    options: dict[str, Any] = {"stabilization": "projection"}
    found = many(models, 0.3, 1e-2, **options)
    assert found.status.tolist() == ["finished", "finished", "failed", "finished"]
    with pytest.raises(lw.LinkworkError) as refused:
        alone(models[2], 0.3, 1e-2, **options)
    assert found.errors[2]["type"] == type(refused.value).__name__
    for k in (0, 1, 3):
        assert k not in found.alone
        assert bits(found.member(k)) == bits(alone(models[k], 0.3, 1e-2, **options))


def torn(rate: float) -> lw.Model:
    """A triangle with a side whose length a driver changes."""
    model = lw.Model(gravity=(0, 0, 0), name="torn")
    arm = model.body("arm", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0.5, 0, 0))
    model.revolute(model.ground, arm, at=(0, 0, 0), axis=(0, 1, 0))
    length = lw.functions.polynomial(2.0**0.5, 0.0, 5.0 * rate)
    model.distance(model.ground, arm, at=((0, 0, 1), (1, 0, 0)), length=length)
    return model


def slender(model: lw.Model, moment: float) -> lw.Model:
    """With so small a part of its largest moment about the axis of each body's smallest one."""
    names = [f"{it['name']}.inertia" for it in record_of(model, {})["bodies"]]
    source, record = Changed.of(model, names), {}
    for name in names:
        inertia = np.array(source.value(name), dtype=float)
        moments = inertia if inertia.ndim == 1 else np.diagonal(inertia).copy()
        moments[np.argmin(moments)] = moment * moments.max()
        record[name] = moments.tolist()
    return source.model(record)


@pytest.mark.parametrize("moment", [1e-2, 1e-4, 1e-6, 1e-9, 0.0])
@pytest.mark.parametrize("name", ["four_bar", "bricard", "chain", "spatial_slider_crank", "net"])
def test_thin_rods_are_refined_as_by_themselves(name: str, moment: float) -> None:
    """And lines with mass, but where nothing holds them: between balls."""
    size = {"four_bar": 3, "chain": 6, "net": 3}.get(name)
    make = mechanisms.named(name).function
    models = variants(slender(make(size) if size else make(), moment or 1e-9 * (name == "net")), 4, seed=3)
    found = many(models, 0.05, 1e-3, threads=1, record_every=7)
    assert found.alone == {}
    for k in (0, 3):
        assert bits(found.member(k)) == bits(alone(models[k], 0.05, 1e-3, record_every=7))


def test_thin_rods_beside_what_is_faster_are_refined_as_by_themselves() -> None:
    model = slender(mechanisms.bricard(), 1e-9)
    for k, force in enumerate((1e3, 1e8)):
        free = model.body(f"free {k}", mass=1, inertia=(1, 1, 1), position=(9, 9, k))
        model.force(free, force=(force, 0, 0))
    found = many(variants(model, 4, seed=3), 0.05, 1e-3, threads=1, record_every=7)
    assert found.alone == {}
    for k, it in enumerate(variants(model, 4, seed=3)):
        assert bits(found.member(k)) == bits(alone(it, 0.05, 1e-3, record_every=7))


def robot(rotors: float) -> lw.Model:
    """A torso on slides and a hinge, a leg on three hinges, another on a Cardan joint; massless links."""
    model = lw.Model(gravity=(0, 0, -9.81), name="robot")

    def link(name: str) -> lw.Body:
        return model.body(name, mass=0.0, inertia=(0, 0, 0))

    def solid(name: str, position: tuple[float, float, float]) -> lw.Body:
        return model.body(name, mass=2.0, inertia=(0.3, 0.2, 0.1), position=position)

    x, y, torso = link("x"), link("y"), solid("torso", (0, 0, 0.1))
    model.translational(model.ground, x, at=(0, 0, 0), axis=(1, 0, 0))
    model.translational(x, y, at=(0, 0, 0), axis=(0, 1, 0.2))
    model.revolute(y, torso, at=(0, 0, 0), axis=(0, 0, 1))
    hip, knee, leg = link("hip"), link("knee"), solid("leg", (0.2, 0.1, -0.4))
    for a, b, axis in ((torso, hip, (1, 0, 0)), (hip, knee, (0, 0, 1)), (knee, leg, (0, 1, 0))):
        model.revolute(a, b, at=(0.2, 0.1, 0), axis=axis)
        if rotors:
            model.rotational_inerter(a, b, at=(0.2, 0.1, 0), axis=axis, inertance=rotors)
    other, foot = link("other"), solid("foot", (-0.2, 0.1, -0.4))
    model.universal(torso, other, at=(-0.2, 0.1, 0), axes=((1, 0, 0), (0, 1, 0)))
    model.cylindrical(other, foot, at=(-0.2, 0.1, 0), axis=(0.2, 0, 1))
    model.fixed(foot, link("tip"), at=(-0.2, 0.1, -0.8))
    return model


@pytest.mark.parametrize("rotors", [0.0, 0.2])
def test_massless_links_are_eliminated_as_by_themselves(rotors: float) -> None:
    models = variants(robot(rotors), 4, seed=3)
    found = many(models, 0.05, 1e-3, threads=1, record_every=7)
    assert found.alone == {}
    for k in (0, 3):
        assert bits(found.member(k)) == bits(alone(models[k], 0.05, 1e-3, record_every=7))


def test_hubs_with_branches_inerters_and_masses_far_apart_are_those_by_themselves() -> None:
    models = [with_inerters(mechanisms.hub(24, loops=True), 5, 0.3 * k) for k in (1, 2, 3)]
    for k, model in enumerate(models):
        bob = model.body("bob", mass=10.0 ** (-4 * k), inertia=(0.01, 0.02, 0.02), omega=(0, 0, 5.0))
        model.spherical("hub", bob, at=(0, 0, 0), name="branch")
    found = many(models, 0.03, 1e-3, threads=1, record_every=7)
    assert found.alone == {}
    for k in (0, 1, 2):
        assert bits(found.member(k)) == bits(alone(models[k], 0.03, 1e-3, record_every=7))


@pytest.mark.parametrize("lift", [0.0, 1e-5])
def test_a_pivot_that_waits_for_a_hub_is_left_to_the_run_by_itself(lift: float) -> None:
    models = variants(carousel(lift), 3, seed=3)
    found = many(models, 0.02, 1e-3, threads=1, record_every=5)
    assert sorted(found.alone) == [0, 1, 2] and "order of elimination" in found.alone[0]
    followed = many(models, 0.02, rtol=1e-6)
    for k in (0, 2):
        assert bits(found.member(k)) == bits(alone(models[k], 0.02, 1e-3, record_every=5))
        assert bits(followed.member(k)) == bits(alone(models[k], 0.02, rtol=1e-6))


@pytest.mark.parametrize("method", ["euler", "heun", "rk3", "dopri5", "dop853"])
def test_it_has_them_by_every_explicit_runge_kutta_method(method: str) -> None:
    models = variants(mechanisms.spatial_slider_crank(), 3, seed=1)
    found = many(models, 0.0305, 1e-3, integrator=method, record_every=10)
    assert found.alone == {}
    single = alone(models[1], 0.0305, 1e-3, integrator=method, record_every=10)
    assert bits(found.member(1)) == bits(single)


@random_mechanisms.examples(12)
@given(mechanism=random_mechanisms.mechanisms())
def test_random_mechanisms_with_all_joints_and_forces_have_them(mechanism: Any) -> None:
    models = [mechanism.model, mechanism.model]
    options: dict[str, Any] = {"record_every": 2, "assemble": False}
    try:
        single = alone(models[0], 1.2e-3, 2e-4, **options)
    except lw.LinkworkError as error:  # too stiff for the step, or it locks
        found = many([mechanisms.chain(2), *models], 1.2e-3, 2e-4, **options)
        assert found.status.tolist() == ["finished", "failed", "failed"]
        assert found.errors[1]["type"] == type(error).__name__
        return
    found = many(models, 1.2e-3, 2e-4, threads=1, **options)
    assert bits(found.member(0)) == bits(found.member(1)) == bits(single)


@random_mechanisms.examples(12)
@given(light=light_mechanisms(most=10, forces=()))
def test_random_mechanisms_with_thin_rods_and_points_have_them_and_the_verdict(light: Any) -> None:
    model = light.mechanism.model
    options: dict[str, Any] = {"record_every": 2, "assemble": False}
    found = many([model, model], 1.2e-3, 2e-4, threads=1, **options)
    single = alone(model, 1.2e-3, 2e-4, **options)
    assert bits(found.member(0)) == bits(found.member(1)) == bits(single)
    assert found.member(0).verdict == single.verdict


def test_functions_of_time_and_forces_with_history_are_those_of_each_lane() -> None:
    models = [with_functions(0.1 * (k + 1), 5.0 + k) for k in range(6)]
    found = many(models, 0.2, 1e-3, record_every=20)
    assert found.alone == {}
    for k in (0, 5):
        assert bits(found.member(k)) == bits(alone(models[k], 0.2, 1e-3, record_every=20))


def with_breaks(at: float) -> lw.Model:
    """A chain on a spring that becomes stiffer at that time, and a push that ends there."""
    model = mechanisms.chain(4)
    first, last = model.find("link[0]"), model.find("link[3]")
    stiffness = functions.piecewise_polynomial([-1, at, 9], [[40.0], [90.0]])
    model.spring_damper("ground", last, at=((0.3, 0, -1), (3.5, 0, 0)), stiffness=stiffness)
    model.force(first, force=(functions.with_breaks(lambda t: 3.0 if t <= at else -2.0, [at]), 0, 0))
    return model


@pytest.mark.parametrize("end", [0.2, 0.3])
def test_steps_of_lanes_are_on_their_own_sides_of_breaks(end: float) -> None:
    times = [0.1, 0.1 + 0.2, 0.3, 0.1037, 0.3 * (1 + 1e-12), 0.2, 5.0, 0.201, 3 * 0.1]
    models = [with_breaks(at) for at in times]
    found = many(models, end, 5e-3, record_every=4)
    assert found.alone == {}
    for k, model in enumerate(models):
        single = alone(model, end, 5e-3, record_every=4)
        assert bits(found.member(k)) == bits(single)
        assert found.member(k).verdict == single.verdict
        inside = times[k] == 0.1037 or times[k] == 0.201
        assert found.member(k).verdict.break_points == (1 if inside and times[k] < end else 0)


def test_bits_do_not_depend_on_place_neighbors_and_threads() -> None:
    models = variants(mechanisms.bricard(), 21, seed=3)
    order = np.random.default_rng(4).permutation(len(models))
    q = many(models, 0.05, 1e-3, threads=1).q
    for threads in (1, 2, 3, 4):
        shuffled = many([models[k] for k in order], 0.05, 1e-3, threads=threads)
        assert np.array_equal(shuffled.q, q[order])


def digest() -> str:
    """What a process of other instructions finds, too, and a member that is simulated by itself."""
    models = [*variants(mechanisms.bricard(), 3, seed=5), *variants(mechanisms.chain(), 3, seed=6)]
    models += [with_inerters(make(), 3, 0.2) for make in (mechanisms.bricard, mechanisms.chain)]
    found = many(models, 0.02, 1e-3, deterministic=True)
    return " ".join(found.member(k).q[-1].tobytes().hex() for k in range(len(models)))


@pytest.mark.parametrize("instructions", ["x86-64-v2", "x86-64-v3"])
def test_deterministic_bits_do_not_depend_on_the_width_of_registers(instructions: str) -> None:
    environment = {**os.environ, "LINKWORK_INSTRUCTION_SET": instructions}
    program = "import test_ensemble; print(test_ensemble.digest())"
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", program], env=environment, cwd=os.path.dirname(__file__),
        capture_output=True, text=True,
    )  # fmt: skip
    assert done.stdout.strip() == digest(), done.stderr


def test_a_member_has_the_same_bits_alone_in_its_pack_and_among_others() -> None:
    models = variants(mechanisms.double_wishbone(), 11, seed=9)
    q = many(models, 0.03, 1e-3, threads=1).q
    for k in (0, 5, 10):
        assert np.array_equal(many([models[k]], 0.03, 1e-3).q[0], q[k])


@pytest.mark.parametrize("threads", [1, 2])
def test_what_is_computed_afterwards_is_not_deterministic_for_that(threads: int) -> None:
    """Each member takes the path of instructions that all processors have, and leaves that of the caller."""
    before = _core.instruction_set()
    many(variants(mechanisms.chain(3), 20, seed=10), 5e-3, 1e-3, threads=threads)
    assert _core.instruction_set() == before


# --- lanes that leave ---


def failing(t: float) -> lw.Model:
    """A force that is no number from t [s] on."""
    model = with_functions(0.1, 5.0)
    burst = lambda now: float("nan") if now > t else 0.0  # noqa: E731
    model.force(model.find("rod"), force=(burst, 0.0, 0.0), name="burst")
    return model


def raising(error: type[BaseException]) -> lw.Model:
    """A force by a function that raises from 0.03 s on."""
    model = mechanisms.chain(3)

    def broken(now: float) -> float:
        if now > 0.03:
            raise error("broken")
        return 0.0

    model.force(model.find("link[0]"), force=(broken, 0.0, 0.0), name="broken")
    return model


STEPS = pytest.mark.parametrize("steps", [{"step": 1e-3}, {"rtol": 1e-6}])


@STEPS
@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("error", [ValueError, StopIteration, ZeroDivisionError])
def test_an_error_in_a_function_of_one_member_ends_no_other(
    error: type[Exception], threads: int, steps: dict[str, float]
) -> None:
    models = [mechanisms.chain(3) for _ in range(10)]
    options: dict[str, Any] = {"progress": False, "threads": threads, **steps}
    good = lw.simulate_many(models, None, 0.1, **options)
    models[4] = raising(error)
    found = lw.simulate_many(models, None, 0.1, **options)
    assert found.status.tolist() == ["finished"] * 4 + ["failed"] + ["finished"] * 5
    assert "broken" in found.errors[4]["message"] or error is StopIteration
    for k in (0, 3, 5, 9):
        assert bits(found.member(k)) == bits(good.member(k)) and k not in found.alone


def test_an_interruption_keeps_the_members_that_are_done() -> None:
    models = [mechanisms.chain(2), mechanisms.chain(3), raising(KeyboardInterrupt), mechanisms.chain(3)]
    how: dict[str, Any] = {"step": 1e-2, "integrator": "ab2"}  # one after the other
    with pytest.raises(KeyboardInterrupt, match="interrupted: 2 of 4 members are done") as caught:
        lw.simulate_many(models, None, 0.1, progress=False, **how)
    found: Any = caught.value.result  # type: ignore[attr-defined]
    assert found.status.tolist() == ["finished", "finished", "skipped", "skipped"]
    alone = lw.simulate(models[1], 0.1, deterministic=True, **how)
    assert np.array_equal(found.member(1).q, alone.q) and "2 skipped" in repr(found)
    with pytest.raises(lw.OptionError, match="member 3: .*interrupted"):
        found.member(3)


@STEPS
def test_an_interruption_in_a_function_ends_all(steps: dict[str, float]) -> None:
    models = [*(mechanisms.chain(3) for _ in range(3)), raising(KeyboardInterrupt)]
    with pytest.raises(KeyboardInterrupt):
        lw.simulate_many(models, None, 0.1, progress=False, threads=1, **steps)


def test_what_goes_wrong_in_one_lane_disturbs_no_other() -> None:
    """Forces that are no numbers, and redundant equations that change, in random places among 40."""
    good = [with_functions(0.05 + 0.01 * k, 5.0) for k in range(40)]
    before = many(good, 0.1, 1e-3, threads=2)
    places = np.random.default_rng(7).choice(40, 6, replace=False)
    models = list(good)
    for place in places[:4]:
        models[place] = failing(0.03)
    for place in places[4:]:
        models[place] = mechanisms.planetary_gear()
    after = many(models, 0.1, 1e-3, threads=2)
    others = np.setdiff1d(np.arange(40), places)
    for k in others:
        assert bits(after.member(k)) == bits(before.member(k))
        assert k not in after.alone
    for place in places[:4]:
        assert after.status[place] == "failed"
        assert after.errors[place]["type"] == "NotFiniteError"
        assert after.errors[place]["reached"] == pytest.approx(0.03, abs=2e-3)
    for place in places[4:]:
        assert place not in after.alone
        assert after.member(place).statistics["row_changes"] > 0
        assert bits(after.member(place)) == bits(alone(mechanisms.planetary_gear(), 0.1, 1e-3))


@pytest.mark.parametrize(
    ("name", "size", "step", "t_end"),
    [
        ("four_bar", 1, 1e-3, 1.0),
        ("four_bar", 1, 5e-3, 3.0),  # frames where other equations become the redundant ones
        ("four_bar", 1, 1e-3, 0.7094),  # ends in leaps
        ("four_bar", 3, 1e-3, 1.5),
        ("planetary_gear", None, 1e-3, 0.1),
    ],
)
def test_lanes_leap_over_singular_poses_and_go_on(
    name: str, size: int | None, step: float, t_end: float
) -> None:
    make = mechanisms.named(name).function
    models = variants(make(size) if size else make(), 6, seed=3)
    found = many(models, t_end, step, threads=1, record_every=7, follow_errors=True)
    assert found.alone == {}
    counts: list[int] = []
    for k, model in enumerate(models):
        member, single = found.member(k), alone(model, t_end, step, record_every=7)
        assert bits(member) == bits(single)
        assert member.singular_poses == single.singular_poses
        assert member.verdict is not None and single.verdict is not None
        assert member.verdict.numbers() == single.verdict.numbers()
        counts.append(len(single.singular_poses) + single.statistics["row_changes"])
        assert member.statistics["row_changes"] == single.statistics["row_changes"]
    assert sum(counts) > 0


@pytest.mark.parametrize("steps", [{"step": 5e-4}, {"rtol": 1e-6}])
@pytest.mark.parametrize("stabilization", ["none", "baumgarte", "velocity_projection"])
def test_members_go_back_to_the_constraints_as_by_themselves_where_other_rows_become_redundant(
    stabilization: str, steps: dict[str, float]
) -> None:
    models = variants(mechanisms.planetary_gear(2), 4, seed=7)
    options: dict[str, Any] = {"stabilization": stabilization, "record_every": 7, **steps}
    found = many(models, 0.1, threads=1, **options)
    for k, model in enumerate(models):
        single = alone(model, 0.1, **options)
        assert bits(found.member(k)) == bits(single)
        assert found.member(k).verdict == single.verdict
        assert single.statistics["row_changes"] > 0


def test_the_verdict_is_that_by_itself_where_other_rows_become_redundant_in_the_course_of_a_run() -> None:
    """To the last bit: a step before which other rows were left out is taken again as by itself, too."""
    models = variants(crank_rocker(), 16, seed=5)
    found = many(models, 1.0, 2e-3, threads=1)
    assert found.alone == {}
    for k, model in enumerate(models):
        member, single = found.member(k), alone(model, 1.0, 2e-3)
        assert member.statistics["row_changes"] == single.statistics["row_changes"] > 0
        assert member.verdict == single.verdict


def driven_row(speed: float, stiffness: float) -> lw.Model:
    """A driver, a spring whose full turns are counted, a force of time: what a leap knows beside states."""
    model = mechanisms.four_bar(2)
    model.drive("pin 0", velocity=-speed)
    model.rotational_spring_damper("ground", model.find("post 0"), at=(0, 0, 0), axis=(0, 0, 1),
                                   stiffness=stiffness, damping=0.02)  # fmt: skip
    model.force(model.find("post 1"), force=(lambda t: 0.1 * np.sin(3 * t), 0.0, 0.0))
    return lw.assemble(model).model


def test_lanes_leap_with_drivers_and_history_variables() -> None:
    models = [driven_row(3.0 + 0.1 * k, 0.5 + 0.1 * k) for k in range(3)]
    found = many(models, 2.5, 1e-3, threads=1, record_every=7)
    assert found.alone == {}
    for k, model in enumerate(models):
        member, single = found.member(k), alone(model, 2.5, 1e-3, record_every=7)
        assert bits(member) == bits(single)
        assert member.verdict == single.verdict
        assert member.singular_poses == single.singular_poses and len(single.singular_poses) >= 2


def flat_parallelogram(*breaks: float) -> lw.Model:
    """Flat at about t = 0.2016 s; a push and a spring that jump at these times."""
    at = lw.Model(gravity=(0, 0, 0))
    c, s, rate = math.cos(0.6), math.sin(0.6), 3.0
    crank: dict[str, Any] = {"inertia": (0.1, 0.1, 0.1), "omega": (0, rate, 0)}
    half = (0.5 * rate * s, 0, -0.5 * rate * c)
    first = at.body("first", mass=1, position=(0.5 * c, 0, 0.5 * s), velocity=half, **crank)
    last = at.body("last", mass=1, position=(2 + 0.5 * c, 0, 0.5 * s), velocity=half, **crank)
    coupler = at.body("coupler", mass=1, inertia=(0.3, 0.3, 0.3), position=(c + 1, 0, s),
                      velocity=(rate * s, 0, -rate * c))  # fmt: skip
    for i, j, x, z in (("ground", first, 0, 0), (first, coupler, c, s), (coupler, last, 2 + c, s),
                       (last, "ground", 2, 0)):  # fmt: skip
        at.revolute(i, j, at=(x, 0, z), axis=(0, 1, 0))
    jumps = [float(k % 2) for k in range(len(breaks) + 1)]
    push, stiffness = (functions.piecewise_polynomial([-1, *breaks, 9], [[value] for value in values])
                       for values in ([3.0 * k for k in jumps], [2.0 - k for k in jumps]))  # fmt: skip
    at.force(coupler, force=(0, 0, push))
    at.rotational_spring_damper("ground", first, at=(0, 0, 0), axis=(0, 1, 0), stiffness=stiffness)
    return at


@pytest.mark.parametrize("record_every", [1, 7])
@pytest.mark.parametrize("method", ["heun", "dopri5"])
def test_lanes_pass_breaks_beside_singular_poses_as_by_themselves(method: str, record_every: int) -> None:
    """Before, in and after the step over the pose, at its ends, and where a leap is from break to break."""
    once, twice = (0.2003, 0.201, 0.2014, 0.2016, 0.202, 0.2025), ((0.194, 0.203), (0.198, 0.21), (0.2, 0.22))
    models = [flat_parallelogram(*times) for times in [*((at,) for at in once), *twice]]
    options: dict[str, Any] = {"integrator": method, "record_every": record_every}
    found = many(models, 0.25, 1e-3, threads=1, **options)
    assert found.alone == {}
    for k, model in enumerate(models):
        member, single = found.member(k), alone(model, 0.25, 1e-3, **options)
        assert bits(member) == bits(single)
        assert member.verdict == single.verdict
        assert member.singular_poses == single.singular_poses and len(single.singular_poses) == 1


def test_a_lane_stops_at_a_singular_pose_where_that_is_asked_for() -> None:
    models = [mechanisms.four_bar(1), mechanisms.four_bar(1)]
    assert many(models, 0.5, 1e-3, on_singular="stop").status.tolist() == ["finished", "finished"]
    stopped = many(models, 0.8, 1e-3, on_singular="stop")
    assert stopped.status.tolist() == ["failed", "failed"]
    assert stopped.errors[0]["code"] == "singular_pose"
    assert stopped.errors[0]["reached"] == pytest.approx(0.7, abs=0.02)


def test_a_variation_without_a_model_fails_and_the_others_run() -> None:
    model = mechanisms.spatial_slider_crank()
    found = lw.simulate_many(model, {"crank.mass": [0.1, -1.0, 0.2]}, 0.02, 1e-3, progress=False)
    assert found.status.tolist() == ["finished", "failed", "finished"]
    assert "crank" in found.errors[1]["message"]
    assert np.isnan(found.q[1]).all() and np.isfinite(found.q[[0, 2]]).all()


@pytest.mark.parametrize(
    ("options", "reason"),
    [
        ({"integrator": "ab2"}, "Runge-Kutta"),
        ({"formulation": "augmented_lagrangian"}, "standard"),
        ({"linear_solver": "dense"}, "block"),
        ({"violation_limit": {"acceleration": 1e-2}}, "violation_limit"),
    ],
)
def test_what_lanes_do_not_have_is_simulated_alone_and_says_so(options: dict[str, Any], reason: str) -> None:
    model = mechanisms.spatial_slider_crank()
    found = many([model, model], 0.02, 1e-3, **options)
    assert set(found.alone) == {0, 1} and reason in found.alone[0]
    assert bits(found.member(1)) == bits(alone(model, 0.02, 1e-3, **options))


def far_apart(mass: float) -> lw.Model:
    model = mechanisms.chain(2)
    speck = model.body("speck", mass=mass, inertia=np.full(3, mass), position=(0, 0, 1))
    model.revolute(model.ground, speck, at=(0, 0, 0), axis=(0, 1, 0))
    return model


def unconnected(speed: float, inertance: float = 0.0) -> lw.Model:
    """A body that flies through air, and another on a spring and stops; or with an inerter between them."""
    model = lw.Model(name="unconnected")
    ball = model.body("ball", mass=0.5, inertia=((0.2, 0.01, 0.03), (0.01, 0.25, 0.02), (0.03, 0.02, 0.3)),
                      position=(0, 0, 1), velocity=(speed, 0, 3), omega=(0.3, -2, speed))  # fmt: skip
    load = model.body("load", mass=3.0, inertia=(0.3, 0.1, 0.2), position=(1, 0, 0), omega=(1, 2, 3))
    model.drag("ground", ball, at=(0, 0, 1.1), coefficient=0.1)
    model.spring_damper(ball, load, at=((0.1, 0, 1), (1, 0, 0.1)), stiffness=20.0, damping=0.1)
    model.translational_stop("ground", load, at=(1, 0, 0), axis=(1, 0, 0), lower=-0.01, upper=0.01,
                             stiffness=500.0, damping=1.0)  # fmt: skip
    if inertance:
        model.inerter(ball, load, at=((0, 0, 1), (1, 0.1, 0)), inertance=inertance)
    return model


def tumbling(seed: int) -> lw.Model:
    """A free body whose inertia has no zeros."""
    random = np.random.default_rng(seed)
    axes = np.linalg.qr(random.normal(size=(3, 3))).Q
    inertia = axes @ np.diag([0.2, 0.3, 0.4]) @ axes.T
    model = lw.Model(name="tumbling")
    model.body("body", mass=1.3, inertia=(inertia + inertia.T) / 2, omega=2 * random.normal(size=3))
    return model


@pytest.mark.parametrize("inertance", [0.0, 0.3])
@pytest.mark.parametrize("stabilization", ["sampled_baumgarte", "projection"])
def test_mechanisms_without_joints_run_in_lanes(stabilization: str, inertance: float) -> None:
    models = [unconnected(0.5 * k, inertance) for k in range(9)]
    options: dict[str, Any] = {"stabilization": stabilization, "record_every": 10, "violation_limit": 1e-6}
    found = many(models, 0.2, 1e-3, **options)
    assert found.alone == {}
    for k, model in enumerate(models):
        single = alone(model, 0.2, 1e-3, **options)
        assert bits(found.member(k)) == bits(single)
        assert single.verdict is not None and found.accuracy[k] == single.verdict.error


def test_frames_at_other_times_are_not_put_beside_each_other() -> None:
    """Steps that follow tolerances are each member's own: frame k of two members is at two times."""
    model = mechanisms.four_bar(1)
    own = many(variants(model, 3, seed=1), 0.3, rtol=1e-6, record_every=1)
    for ask in (lambda: own.q, lambda: own.v, own.to_xarray):
        with pytest.raises(lw.OptionError, match="times of their own"):
            ask()
    assert [own.member(k).t[-1] for k in range(3)] == [0.3] * 3
    same = many(variants(model, 3, seed=1), 0.3, 1e-3)
    assert len(same.t) == same.q.shape[1] and np.isfinite(same.q).all()
    assert all(np.array_equal(same.q[k], same.member(k).q) for k in range(3))


def test_mechanisms_without_joints_follow_tolerances_in_lanes() -> None:
    models = [*variants(mechanisms.torque_free_top(), 5, seed=2), *(tumbling(seed) for seed in range(5))]
    for same in (models[:5], models[5:]):
        found = many(same, 0.5, rtol=1e-8)
        assert found.alone == {}
        assert all(
            bits(found.member(k)) == bits(alone(model, 0.5, rtol=1e-8)) for k, model in enumerate(same)
        )


@pytest.mark.parametrize("stabilization", ["sampled_baumgarte", "projection"])
def test_masses_far_apart_are_refined_as_by_themselves_beside_usual_ones(stabilization: str) -> None:
    bricards = variants(mechanisms.bricard(), 4, seed=1)
    names = [f"rod {k}.{what}" for k in (2, 4) for what in ("mass", "inertia")]
    source = Changed.of(mechanisms.bricard(), names)
    usual = {name: np.asarray(source.value(name)) for name in names}
    for factor in (1e-7, 1e-9, 3e7):
        bricards.insert(1, source.model({name: (factor * value).tolist() for name, value in usual.items()}))
    thin_and_light = slender(bricards[1], 1e-6)
    models = [*bricards, thin_and_light, *(far_apart(10.0**-k) for k in (3, 9, 12))]
    options: dict[str, Any] = {"stabilization": stabilization, "on_singular": "pass"}
    found = many(models, 0.1, 1e-3, **options)
    for k, model in enumerate(models):
        single = alone(model, 0.1, 1e-3, **options)
        assert bits(found.member(k)) == bits(single)
        assert single.verdict is not None and found.accuracy[k] == single.verdict.error
    assert set(found.alone) <= {7}, found.alone


# --- what is asked for ---


def test_outputs_are_those_of_a_sweep() -> None:
    variations = {"gravity[2]": [-9.81, -5.0, -1.0]}
    asked = {"force": "reaction('crank pin').force.max", "end": "final", "e": "energy_error.abs_max"}
    model = mechanisms.spatial_slider_crank()
    found = lw.simulate_many(model, variations, 0.05, 1e-3, outputs=asked, progress=False,
                             deterministic=True)  # fmt: skip
    study = lw.sweep(model, variations, asked, t_end=0.05, step=1e-3, deterministic=True, processes=1,
                     progress=False)  # fmt: skip
    assert found.trajectories == {} and found.alone == {}
    assert set(found.outputs) == set(study.outputs)
    for label, values in study.outputs.items():
        assert np.array_equal(found.outputs[label], values), label
        assert found.units[label] == study.units[label]


def test_outputs_over_time_stand_at_the_times() -> None:
    found = lw.simulate_many(
        mechanisms.spatial_slider_crank(), {"gravity[2]": [-9.81, -5.0]}, 0.05, 1e-3,
        outputs={"energy": "energy"}, times=[0.01, 0.03], progress=False,
    )  # fmt: skip
    assert found.outputs["energy"].shape == (2, 2)
    dataset = pytest.importorskip("xarray") and found.to_xarray()
    assert dataset["energy"].dims == ("member", "time") and dataset["time"].values.tolist() == [0.01, 0.03]


def test_parameters_are_coordinates_of_the_data_set() -> None:
    pytest.importorskip("xarray")
    found = lw.simulate_many(mechanisms.spatial_slider_crank(), {"crank.mass": [0.1, 0.2]}, 0.01, 1e-3,
                             progress=False)  # fmt: skip
    dataset = found.to_xarray()
    assert dataset["crank.mass"].values.tolist() == [0.1, 0.2]
    assert dataset["crank.mass"].attrs["units"] == "kg"
    assert dataset["q"].dims == ("member", "time", "body", "q_component")


def test_motions_are_variables_of_the_data_set_and_have_means_over_members() -> None:
    pytest.importorskip("xarray")
    found = lw.simulate_many(mechanisms.rod_pendulum(), {"gravity[2]": [-9.81, -5.0]}, 0.05, 1e-2,
                             progress=False)  # fmt: skip
    mean = found.to_xarray().mean("member")
    assert set(mean.data_vars) == {"q", "v", "vdot", "lambda", "energy"}
    assert np.array_equal(mean["q"].values, found.q.mean(axis=0))
    height, spin = mean.q.sel(q_component="z"), mean.v.sel(v_component="omega_y")
    assert np.array_equal(height.values, found.q[..., 2].mean(axis=0))
    assert np.array_equal(spin.values, found.v[..., 4].mean(axis=0))


def test_what_an_ensemble_gives_out_cannot_make_it_another_one() -> None:
    values = np.array([-9.81, -5.0])
    ensemble = lw.Ensemble(mechanisms.rod_pendulum(), {"gravity[2]": values})
    found = ensemble.simulate(0.05, 1e-2, progress=False)
    outputs = ensemble.simulate(0.05, 1e-2, outputs=["energy.max"], progress=False).outputs["energy.max"]
    for it in (found.q, found.v, found.t, found.member(0).q, found.parameters["gravity[2]"],
               found.accuracy, outputs):  # fmt: skip
        with pytest.raises(ValueError, match="read-only"):
            it -= 1.0
    models = [mechanisms.chain(1), mechanisms.chain(2)]
    listed = lw.Ensemble(models)
    ensemble.parameters["gravity[2]"][:] = values[:] = 0.0
    models[0] = mechanisms.chain(3)
    assert listed.model(0).body_count == 1
    assert ensemble.parameters["gravity[2]"].tolist() == [-9.81, -5.0]
    if pytest.importorskip("xarray"):
        found.to_xarray()["q"].values[:] = 0.0
        assert found.q.any()


def test_members_may_differ_in_the_number_of_bodies() -> None:
    models = [mechanisms.chain(2), mechanisms.chain(5), mechanisms.chain(2)]
    found = many(models, 0.02, 1e-3)
    assert found.alone == {} and found.status.tolist() == ["finished"] * 3
    assert bits(found.member(1)) == bits(alone(models[1], 0.02, 1e-3))
    with pytest.raises(lw.OptionError, match="or other bodies: ask for member"):
        found.q  # noqa: B018
    assert found.trajectories["energy"].shape == (3, len(found.t))


class Mine(Exception):
    """Of a user."""


@pytest.mark.parametrize("error", [RuntimeError, AttributeError, KeyError, Mine])
def test_an_error_in_an_output_fails_one_member_with_the_facts_of_a_study(error: type[Exception]) -> None:
    def crossing(result: lw.Result) -> float:
        if result.header.mass[0] == 2.0:
            raise error("none found")
        return 1.0

    model, masses = mechanisms.chain(1), {"link[0].mass": [1.0, 2.0, 3.0]}
    found = lw.simulate_many(model, masses, 0.02, 1e-3, outputs=[crossing], progress=False)
    study = lw.sweep(model, masses, [crossing], t_end=0.02, step=1e-3, processes=1, progress=False)
    assert found.status.tolist() == study.status.tolist() == ["finished", "failed", "finished"]
    assert found.errors == study.errors and "output 'crossing': " in found.errors[1]["message"]
    assert np.isnan(found.accuracy[1]) and np.isfinite(found.accuracy[[0, 2]]).all()
    assert repr(found).startswith("<EnsembleResult: 3 members: 2 finished, 1 failed, 3 in lanes>")


def test_outputs_of_another_shape_than_the_first_fail() -> None:
    models = [mechanisms.chain(2), mechanisms.chain(3), mechanisms.chain(2)]
    found = many(models, 0.02, 1e-3, outputs="final")
    assert found.status.tolist() == ["finished", "failed", "finished"]
    assert found.errors[1]["message"] == (
        "output 'final.q' has shape (3, 7), not (2, 7) as in the first case"
    )
    assert found.outputs["final.q"].shape == (3, 2, 7) and np.isnan(found.outputs["final.q"][1]).all()
    np.testing.assert_array_equal(found.outputs["final.q"][2], alone(models[2], 0.02, 1e-3).q[-1])
    assert np.isnan(found.accuracy[1]) and np.isfinite(found.accuracy[[0, 2]]).all()


def test_parameters_that_no_array_can_hold_are_told_in_words() -> None:
    paths = [[1.0, 2.0], [1.0, 2.0, 3.0]]
    found = lw.simulate_many(lambda path: mechanisms.chain(len(path)), {"path": paths},
                             0.01, 1e-3, outputs="energy.max", progress=False)  # fmt: skip
    assert found.status.tolist() == 2 * ["finished"]
    assert found.parameters["path"].tolist() == ["[1.0, 2.0]", "[1.0, 2.0, 3.0]"]


@pytest.mark.parametrize(
    "name", ["status", "accuracy", "alone", "error", "time", "member", "q", "energy", "row"]
)
def test_a_name_that_the_data_set_has_is_refused(name: str) -> None:
    """Those of motions only where these are kept."""

    def build(**given: float) -> lw.Model:
        return mechanisms.chain(1)

    def found(outputs: Any) -> lw.EnsembleResult:
        return lw.simulate_many(build, {name: [1.0, 2.0]}, 0.01, 1e-3, outputs=outputs, progress=False)

    with pytest.raises(lw.OptionError, match=f"'{name}': is the name of a part of the data set"):
        found(None)
    if name in ("q", "energy", "row"):
        pytest.importorskip("xarray")
        assert found("energy.max").to_xarray()[name].values.tolist() == [1.0, 2.0]
    else:
        with pytest.raises(lw.OptionError, match=f"'{name}': is the name of a part of the data set"):
            found("energy.max")


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"variations": {"krank.mass": [1.0]}}, "krank"),
        ({"variations": {"crank.mass": []}}, "no values"),
        ({"variations": {"crank.inertia": [1.0]}}, "shape"),
        ({"variations": {"crank.mass": (0.1, 0.2)}, "sampler": "sobol", "cases": 4}, "seed"),
        ({"variations": None}, "variations"),
        ({"t_end": None}, "t_end"),
        ({"t_end": -1.0}, "t_end"),
        ({"step": None}, "step"),
        ({"threads": 0}, "threads"),
        ({"formulation": "standart"}, "standart"),
        ({"integrator": "rk5"}, "rk5"),
        ({"outputs": ["reaction('krank pin').force.max"]}, "krank pin"),
        ({"outputs": ["energy"]}, "energy"),
        ({"times": [0.01]}, "times"),
        ({"outputs": {"crank.mass": "energy.max"}}, "name of a parameter"),
        ({"outputs": {"status": "energy.max"}}, "data set of every ensemble"),
        ({"outputs": ["energy[::2].max"]}, "among the frames"),
        ({"output": "run.h5"}, "output"),
        ({"start": None}, "start"),
        ({"deterministic": False}, "deterministic"),
        ({"on_inaccurate": "stop"}, "accuracy"),
        ({"setp": 1e-3}, "setp"),
    ],
)
def test_wrong_input_is_refused_by_name(wrong: dict[str, Any], said: str) -> None:
    given = {
        "variations": {"crank.mass": [0.1, 0.2]},
        "t_end": 0.05,
        "step": 1e-3,
        "progress": False,
        **wrong,
    }
    with pytest.raises(lw.LinkworkError, match=said.replace("(", r"\(")):
        lw.simulate_many(mechanisms.spatial_slider_crank(), **given)


def test_an_empty_list_of_models_is_refused() -> None:
    with pytest.raises(lw.OptionError, match="empty"):
        lw.Ensemble([])


def test_one_member_by_itself_has_the_same_bits_and_a_verdict() -> None:
    ensemble = lw.Ensemble(mechanisms.spatial_slider_crank(), {"crank.mass": [0.1, 0.2]})
    found = ensemble.simulate(0.05, 1e-3, progress=False, deterministic=True)
    single = ensemble.single(1, 0.05, 1e-3, progress=False, deterministic=True)
    assert bits(single) == bits(found.member(1))
    verdict = found.member(1).verdict
    assert single.verdict is not None and verdict is not None
    assert verdict.numbers() == single.verdict.numbers()
    assert found.accuracy[1] == verdict.error


def test_elements_along_one_coordinate_have_the_same_bits_in_lanes() -> None:
    """The angle of the hinge and the shift of the slider are found once for all of them, but in the last
    member, where one acts along a line of its own."""
    model = lw.Model()
    arm = model.body("arm", mass=1.0, inertia=(0.1, 0.2, 0.3), position=(1, 0, 0))
    block = model.body("block", mass=2.0, inertia=(0.1, 0.2, 0.3), position=(2, 0, 0))
    hinge: dict[str, Any] = {"at": (0, 0, 0), "axis": (0, 1, 0)}
    rail: dict[str, Any] = {"at": (1.5, 0, 0), "axis": (1, 0, 0)}
    model.revolute("ground", arm, **hinge)
    model.rotational_friction("ground", arm, **hinge, coulomb=0.5, viscous=0.1, transition=0.1)
    model.rotational_spring_damper("ground", arm, **hinge, stiffness=20.0, damping=0.1)
    model.rotational_stop("ground", arm, **hinge, lower=-0.2, upper=0.2, stiffness=300.0, damping=2.0)
    model.rotational_inerter("ground", arm, **hinge, inertance=0.3)
    model.translational(arm, block, **rail)
    model.translational_friction(arm, block, **rail, coulomb=1.0, viscous=0.2, transition=0.05, name="rail")
    model.translational_stop(arm, block, **rail, lower=-0.1, upper=0.1, stiffness=500.0, damping=3.0)
    model.translational_inerter(arm, block, **rail, inertance=0.4)
    ensemble = lw.Ensemble(model, {"gravity[2]": [-9.81, -5.0, -1.0], "rail.at[1]": [0.0, 0.0, 0.1]})
    found = ensemble.simulate(0.3, 1e-3, progress=False, deterministic=True)
    for k in range(3):
        assert bits(ensemble.single(k, 0.3, 1e-3, progress=False, deterministic=True)) == bits(
            found.member(k)
        )


@pytest.mark.filterwarnings("default::linkwork.LinkworkWarning")
@pytest.mark.parametrize("outputs", [None, ["final"]])
def test_members_that_are_too_coarse_say_so(outputs: list[str] | None) -> None:
    """A pendulum by Euler in steps of 10 ms gains a tenth of its energy."""
    given: dict[str, Any] = {"integrator": "euler", "outputs": outputs, "progress": False}
    models = [mechanisms.pendulum(), mechanisms.pendulum()]
    with pytest.warns(lw.LinkworkWarning, match="2 of 2 members are more than 1 % off, the worst is"):
        coarse = lw.simulate_many(models, None, 1.0, 1e-2, **given)
    assert (coarse.accuracy > 0.01).all()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fine = lw.simulate_many(models, None, 1.0, 1e-3, outputs=outputs, progress=False)
        lw.simulate_many(models, None, 1.0, 1e-2, on_inaccurate="pass", **given)
    assert (fine.accuracy < 1e-6).all()


@pytest.mark.parametrize("threads", [1, 2])
def test_what_follows_a_deterministic_ensemble_has_the_bits_that_it_had(threads: int) -> None:
    model = mechanisms.four_bar()
    before = lw.simulate(model, 0.1, 1e-3, progress=False)
    lw.simulate_many([model] * 9, None, 0.02, 1e-3, deterministic=True, threads=threads, progress=False)
    assert lw.simulate(model, 0.1, 1e-3, progress=False).q.tobytes() == before.q.tobytes()
