"""Steps that become so short that a run does not come to its end."""

import warnings
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.running.short_steps import Places, ShortSteps


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
        if told:
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
