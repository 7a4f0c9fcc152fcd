"""Steps that become so short that a run does not come to its end."""

import warnings
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.running import short_steps
from linkwork.running.short_steps import Pace, Places, ShortSteps, Suspects


def sliding_block(law) -> lw.Model:
    """1 kg with 1 m/s on a slide, held by a force along it."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("block", mass=1.0, inertia=(1, 1, 1), velocity=(1, 0, 0))
    model.translational("ground", "block", at=(0, 0, 0), axis=(1, 0, 0), name="slide")
    model.joint_force("slide", law)
    return model


def interrupted_when_told(model: lw.Model, t_end: float, **how: Any) -> tuple[list[str], BaseException]:
    """The warnings of a run, and with what it ended."""
    told: list[str] = []

    def interrupt(info: lw.ProgressInfo) -> None:
        if told or info.elapsed > 30.0:
            raise KeyboardInterrupt

    def listen(message: Warning | str, *_: object) -> None:
        told.append(str(message))

    with warnings.catch_warnings():
        warnings.simplefilter("always")
        warnings.showwarning = listen
        with pytest.raises((KeyboardInterrupt, lw.StepSizeError)) as stopped:
            lw.simulate(model, t_end, progress=interrupt, **how)
    return told, stopped.value


def test_friction_by_the_sign_of_a_velocity_is_told_when_it_holds() -> None:
    """The block stops after 0.5 s; then the force jumps with each step, and the run is interrupted."""
    told, end = interrupted_when_told(sliding_block(lambda t, x, v: -2 * np.sign(v)), 2.0, rtol=1e-6)
    assert "since t = 0.500" in told[0] and "a force that jumps" in told[0].lower()
    assert isinstance(end, KeyboardInterrupt) and 0.49 < end.result.t[-1] < 0.6


def test_smooth_friction_comes_to_its_end_without_a_word() -> None:
    model = sliding_block(lambda t, x, v: -2 * np.tanh(v / 1e-3))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert lw.simulate(model, t_end=2.0, rtol=1e-6).t[-1] == 2.0


def state_at(x: float) -> np.ndarray:
    """y of two bodies 1 m apart, one with 10 m/s."""
    q, v = np.tile([0, 0, 0, 1.0, 0, 0, 0], (2, 1)), np.zeros((2, 6))
    q[:, 0], v[0, 0] = (x, x + 1), 10
    return np.concatenate((q.ravel(), v.ravel()))


STEADY = [1e-3] * 20  # s
LOOKS = [
    (STEADY + [1e-9] * 30, True),
    (STEADY + [1e-9] * 9 + STEADY, False),  # a moment
    ([1e-9] * 50, False),  # always so
    (STEADY + [1e-6] * 40, False),  # not so many
]


@pytest.mark.parametrize(("steps", "told"), LOOKS)
def test_short_steps_that_stay_are_told_once(steps: list[float], told: bool) -> None:
    """One look after 600 steps of each length."""
    looking, t = ShortSteps(0.0, 0, 100.0, lambda: state_at(0.0)), 0.0
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        for count, step in enumerate(steps, start=1):
            t += 600 * step
            looking.look(t, 600 * count)
    assert len(found) == told


@pytest.mark.parametrize(("away", "came", "told"), [(1e6, 0, True), (0, 0, False), (1e6, 1e5, False)])
def test_short_steps_far_from_the_origin_are_told_by_the_rounding_there(
    away: float, came: float, told: bool
) -> None:
    """1e6 m away positions are rounded to 1e-10 m: in 1e-10 s 10 m/s are hardly more. Who came from near
    there, a tenth of the way, is not badly placed."""
    start, now = Places.of(state_at(away - came)), Places.of(state_at(away))
    assert ("rounded to 1e-10 m" in now.rounded(start, 1e-10)) == told
    assert not now.rounded(start, 1e-3)


def test_a_stiff_contact_far_from_the_origin_is_told_by_the_rounding_there() -> None:
    """No step resolves by how much balls touch."""
    model, there = lw.Model(gravity=(0, 0, 0)), np.array((1e6, 0, 0))
    for name, x, speed in (("a", 0, 10), ("b", 0.03, 0)):
        position = there + np.array((x, 0, 0))
        model.body(name, mass=0.01, inertia=(4e-7,) * 3, position=position, velocity=(speed, 0, 0))
    model.sphere_sphere_contact(
        "a", "b", at=(there, there + np.array((0.03, 0, 0))), radius_a=0.01, radius_b=0.01, stiffness=1e9
    )
    told, end = interrupted_when_told(model, 3.0, rtol=1e-9, integrator="dop853")
    assert "m from the origin are rounded to 1e-10 m" in " ".join([*told, str(end)])


def braked(transition: float) -> lw.Model:
    """A pendulum that falls against the friction of two brakes."""
    model = lw.Model()
    model.body("rod", mass=1.0, inertia=(0.003, 0.03, 0.03), position=(0.3, 0, 0))
    model.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    for name, width in (("brake", transition), ("drum", 1.0)):
        model.rotational_friction("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0), coulomb=5, transition=width,
                                  name=name)  # fmt: skip
    return model


def test_a_run_that_would_take_hours_says_so_and_what_may_be_why(monkeypatch: pytest.MonkeyPatch) -> None:
    """From the first step on they are as short as the friction asks for."""
    monkeypatch.setattr(short_steps, "PACE_SECONDS", 0.3)
    told, end = interrupted_when_told(braked(1e-9), 10.0, rtol=1e-6)
    assert len(told) == 1 and isinstance(end, KeyboardInterrupt)
    assert "at this pace it takes" in told[0]
    assert "here perhaps 'brake' with transition 1e-09, 'drum' with transition 1." in told[0]


def test_forces_by_functions_are_named_where_a_run_would_take_hours(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(short_steps, "PACE_SECONDS", 0.3)
    model = braked(1.0)
    model.joint_force("pin", lambda t, x, v: -5 * np.sign(v), name="clutch")
    told, _ = interrupted_when_told(model, 1.0, rtol=1e-6)
    assert "'drum' with transition 1, the function of 'clutch'" in told[0]


def test_a_run_that_goes_on_is_told_nothing_of_its_pace(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(short_steps, "PACE_SECONDS", 0.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert lw.simulate(braked(1e-3), t_end=2.0, rtol=1e-6).t[-1] == 2.0


#: Of 100 s to be simulated, in 11 s of wall time.
PACES = [
    (1e-7, 1000, True),  # 1e-4 s of motion, for 4 months
    (1e-7, 10**7, False),  # 1 s: the rest takes 18 min
    (1e-3, 100, False),  # long, and in steps as of any motion
    (0.0, 1000, True),
    (-1e-7, 1000, False),  # a run that is resumed takes some steps again
]


@pytest.mark.parametrize(("step", "steps", "told"), PACES)
def test_a_pace_is_slow_where_tiny_steps_take_hours(
    monkeypatch: pytest.MonkeyPatch, step: float, steps: int, told: bool
) -> None:
    now = [50.0]
    monkeypatch.setattr(short_steps.time, "monotonic", lambda: now[0])
    pace = Pace(0.0, 0, 100.0)
    now[0] += 9.0
    assert not pace.look(9 * step * steps / 11, 9 * steps // 11)  # not yet
    now[0] += 2.0
    assert bool(pace.look(step * steps, steps)) == told


def test_the_pace_of_now_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where half of the run went in a moment."""
    now = [0.0]
    monkeypatch.setattr(short_steps.time, "monotonic", lambda: now[0])
    pace = Pace(0.0, 0, 100.0)
    now[0] = 10.0
    assert not pace.look(50.0, 1000)
    now[0] = 20.0
    slow = pace.look(50.0 + 1e-4, 2000)
    assert slow is not None and "1e-07 s" in slow.told


BRAKE, LAW = "'brake' with transition 1e-09", "the function of 'law'"
COSTS = [
    (1e-7, 10**5, (BRAKE, LAW), ()),  # 1e9 steps are left, each is cheap
    (5e-5, 50, ("Each step takes 0.2 s", LAW), (BRAKE, "tolerances", "atol")),  # 2e6 steps are left
    (1e-7, 50, ("Each step takes 0.2 s", BRAKE, "larger rtol"), ()),
]


@pytest.mark.parametrize(("step", "steps", "said", "unsaid"), COSTS)
def test_a_slow_run_is_told_by_the_number_of_its_steps_or_by_what_each_takes(
    monkeypatch: pytest.MonkeyPatch, step: float, steps: int, said: tuple[str, ...], unsaid: tuple[str, ...]
) -> None:
    """Of 100 s to be simulated, in 10 s of wall time."""
    now = [0.0]
    monkeypatch.setattr(short_steps.time, "monotonic", lambda: now[0])
    suspects = Suspects([BRAKE], [LAW])
    looking = ShortSteps(0.0, 0, 100.0, lambda: state_at(0.0), lambda: suspects)
    now[0] = 10.0
    with pytest.warns(lw.LinkworkWarning) as told:
        looking.look(step * steps, steps)
    text = str(told[0].message)
    assert all(it in text for it in said) and not any(it in text for it in unsaid)


def test_a_slow_run_that_is_verified_is_told_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Both runs are slow here, at any pace."""
    for name, value in (("PACE_SECONDS", 0.0), ("SLOW_SECONDS", -1.0), ("TINY", 1e9)):
        monkeypatch.setattr(short_steps, name, value)
    with pytest.warns(lw.LinkworkWarning, match="at this pace") as told:
        lw.simulate(braked(1e-2), 0.5, rtol=1e-6, times=[0.1, 0.2], verify=True)
    assert sum("at this pace" in str(it.message) for it in told) == 1


def test_a_second_run_that_alone_is_slow_is_told_as_that() -> None:
    found = []
    for first_was_told in (False, True):
        with short_steps.second_run(first_was_told), warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            looking, t = ShortSteps(0.0, 0, 100.0, lambda: state_at(0.0)), 0.0
            for count, step in enumerate(STEADY + [1e-9] * 30, start=1):
                t += 600 * step
                looking.look(t, 600 * count)
        found.append([str(it.message) for it in told])
    assert not found[1] and len(found[0]) == 1 and found[0][0].startswith("the second run, by verify: since")


def test_fixed_steps_are_told_of_before_the_run_not_of_their_pace(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(short_steps, "PACE_SECONDS", 0.0)
    looking = ShortSteps(0.0, 0, 100.0, lambda: state_at(0.0))
    looking.look(1e-9, 1)
