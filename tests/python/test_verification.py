"""A second, finer run: what it says of the error of everything that is recorded."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms
from linkwork.accuracy.verification import Finer, state_error
from matplotlib.collections import PolyCollection


def quick(model: lw.Model, t_end: float, **how: Any) -> lw.Result:
    return lw.simulate(model, t_end, **{"progress": False, "on_inaccurate": "pass", **how})


def exact(model: lw.Model, result: lw.Result) -> lw.Result:
    return quick(model, result.t[-1], rtol=1e-12, atol=1e-14, integrator="dop853", stabilization="projection",
                 times=result.t)  # fmt: skip


HOW: list[dict[str, Any]] = [
    {"step": 0.01},
    {"step": 0.005, "integrator": "heun"},
    {"step": 0.002, "integrator": "ab3"},
    {"rtol": 1e-5},
    {"rtol": 1e-7, "integrator": "dop853"},
]


@pytest.mark.parametrize("how", HOW)
@pytest.mark.parametrize("name", ["spatial_slider_crank", "bricard", "four_bar"])
def test_three_times_the_band_contains_the_true_error(name: str, how: dict[str, Any]) -> None:
    model = mechanisms.MECHANISMS[name].function()
    result = quick(model, 0.5, verify=True, **how)
    best = exact(model, result)
    for what in ("q", "v", "acceleration", "energy", "reactions"):
        values, true, error = (_array(it) for it in (getattr(result, what), getattr(best, what),
                                                     result.error_of(what)))  # fmt: skip
        rounding = 1e-11 * np.abs(true).max()
        assert np.mean(np.abs(values - true) <= 3 * error + rounding) > 0.95, what
        assert error.max() <= 100 * np.abs(values - true).max() + rounding, what


def _array(of: Any) -> Any:
    of = of() if callable(of) else of
    return np.stack(of) if isinstance(of, tuple) else of


def test_errors_have_the_shape_and_the_names_of_what_they_are_of() -> None:
    result = quick(mechanisms.four_bar(), 0.5, step=0.02, verify=True)
    pin = result.error_of("reaction", "pin 0", frame="joint")
    assert isinstance(pin, lw.Reaction) and pin.force.shape == (len(result), 3)
    body = result.error_of("body", 1)
    assert isinstance(body, lw.BodyResult) and body.name == result.body_names[1]
    np.testing.assert_array_equal(body.position, result.error_of("position")[:, 1])
    angle = result.error_of("coordinate", "pin 0").value
    assert 0 < angle.max() < 1e-3
    with pytest.raises(lw.OptionError, match="the nearest is 'reaction"):
        result.error_of("reactoin")
    with pytest.raises(lw.OptionError, match="verify=True"):
        quick(mechanisms.four_bar(), 0.1, step=0.02).error_of("energy")


def test_the_finer_run_is_kept_in_files(tmp_path: Path) -> None:
    kept = quick(mechanisms.four_bar(), 0.5, step=0.02, verify=True)
    written = quick(mechanisms.four_bar(), 0.5, step=0.02, verify=True, output=tmp_path / "written.h5")
    kept.save(tmp_path / "kept.h5")
    for result in (written, lw.Result.load(tmp_path / "written.h5"), lw.Result.load(tmp_path / "kept.h5")):
        assert result.verified and result.verdict == kept.verdict
        np.testing.assert_array_equal(result.error_of("q"), kept.error_of("q"))
        np.testing.assert_array_equal(result.error_of("reactions").force, kept.error_of("reactions").force)


def test_the_verdict_is_that_of_the_finer_run() -> None:
    model = mechanisms.spatial_slider_crank()
    result = quick(model, 1.0, step=1e-2, verify=True)
    found = result.verdict
    assert found is not None and found.verified is not None and "by a second run" in found.sentence
    best = exact(model, result)
    true = np.abs(result.q - best.q).max()
    assert 0.1 < found.verified / true < 10


def test_plots_show_the_bands() -> None:
    verified = quick(mechanisms.four_bar(), 1.0, step=0.05, verify=True)
    for result, there in ((verified, True), (quick(mechanisms.four_bar(), 1.0, step=0.05), False)):
        for kind in ("overview", "coordinates", "reactions"):
            axes = result.plot(kind=kind).axes
            bands = [it for ax in axes for it in ax.collections if isinstance(it, PolyCollection)]
            assert bool(bands) is there, kind


def test_a_function_that_remembers_is_not_run_twice() -> None:
    model, calls = lw.Model(gravity=(0, 0, -9.81)), [0]
    rod = model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0.5, 0, 0))
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, 1, 0))

    def wind(t: float, q: Any, v: Any) -> Any:
        calls[0] += 1
        return np.full_like(v, 1e-6 * calls[0])

    model.user_force(wind, bodies=[rod], name="wind")
    with pytest.warns(lw.LinkworkWarning, match="no second run was made, as 'wind' may remember"):
        result = quick(model, 0.1, step=1e-2, verify=True)
    assert not result.verified and calls[0] < 1.2 * result.statistics["evaluations"]


def test_a_function_of_time_that_remembers_is_not_run_twice() -> None:
    model, calls = lw.Model(), [0]
    body = model.body("weight", mass=1.0, inertia=(0.1, 0.1, 0.1))

    def gust(t: float) -> float:
        calls[0] += 1
        return 1e-3 * calls[0]

    model.force(body, force=(gust, 0, 0), name="gust")
    with pytest.warns(
        lw.LinkworkWarning, match="no second run was made, as 'applied 'gust': force_x' may remember"
    ):
        assert not quick(model, 0.1, step=1e-2, verify=True, on_inaccurate="pass").verified


def test_a_function_that_counts_is_run_twice_and_keeps_the_count_of_the_first_run() -> None:
    model, calls = lw.Model(gravity=(0, 0, -9.81)), [0]
    rod = model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0.5, 0, 0))
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, 1, 0))

    def wind(t: float, q: Any, v: Any) -> Any:
        calls[0] += 1
        return -0.1 * v

    model.user_force(wind, bodies=[rod], name="wind")
    result = quick(model, 0.1, step=1e-3, verify=True)
    assert result.verified and calls[0] < 1.2 * result.statistics["evaluations"]


def test_verify_is_true_or_false() -> None:
    with pytest.raises(lw.OptionError, match="verify 'yes' is not True or False"):
        lw.simulate(lw.mechanisms.pendulum(), 0.1, 1e-2, verify="yes", progress=False)  # type: ignore[arg-type]


@pytest.mark.parametrize("size", [1e-2, 1.0, 100.0])
@pytest.mark.parametrize("how", [{"step": 1e-3}, {"step": 1e-2}, {"rtol": 1e-4}, {"rtol": 1e-6}], ids=str)
def test_a_mechanism_at_rest_is_as_it_is(how: dict[str, float], size: float) -> None:
    """Rods that hang straight down, along no axis: what moves is rounding, and no other motion."""
    down = np.array([0.3, -0.7, -0.64]) / np.linalg.norm([0.3, -0.7, -0.64])
    model = lw.Model(gravity=9.81 * down)
    above = model.ground
    for k in range(3):
        rod = model.body(
            f"rod {k}", mass=1, inertia=np.full(3, 0.1 * size**2), position=(k + 0.5) * size * down
        )
        model.spherical(above, rod, at=k * size * down, name=f"pin {k}")
        above = rod
    verdict = quick(model, 2.0, verify=True, **how).verdict
    assert verdict is not None
    assert verdict.error <= (1e-4 if "step" in how else 5e-3)


def test_a_finer_run_that_leaps_over_a_pulse_does_not_make_the_first_accurate() -> None:
    """1000 N for 2 ms: both runs see nothing of it, and agree."""
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("body", mass=1.0, inertia=(0.1,) * 3, velocity=(1, 0, 0))
    model.translational(model.ground, body, at=(0, 0, 0), axis=(1, 0, 0))
    model.force(body, force=(lambda t: 1000 * np.exp(-(((t - 0.5) / 1e-3) ** 2)), 0, 0))
    options: dict[str, Any] = {"rtol": 1e-6, "on_inaccurate": "pass", "progress": False}
    for verify in (False, True):
        found = lw.simulate(model, 1.0, verify=verify, **options).verdict
        assert found is not None and found.level == "wrong"
        assert "leap over" in found.sentence


# --- runs that go on ---


@pytest.mark.parametrize("every, end", [(1, 0.5), (3, 0.5), (7, 0.25), (None, 0.25), (3, 0.5007)])
def test_frames_of_a_run_that_goes_on_are_compared_at_their_times(every: int | None, end: float) -> None:
    """They are at multiples of the steps of the run before, which the finer run knows nothing of."""
    model = mechanisms.spatial_slider_crank()
    start = quick(model, end, step=1e-3).snapshot()
    result = quick(model, 1.0, step=1e-3, record_every=every, start=start, verify=True)
    best = quick(model, 1.0, rtol=1e-12, atol=1e-14, integrator="dop853", times=result.t,
                 start=start._replace(resume=None))  # fmt: skip
    assert result.manifest["resumed"]
    for what in ("position", "velocity"):
        error, true = result.error_of(what), np.abs(getattr(result, what) - getattr(best, what))
        assert true.max() / 3 < error.max() < 3 * true.max()
        assert np.isfinite(error).all()


@pytest.mark.parametrize("how", [{"step": 1e-3}, {"rtol": 1e-8}])
def test_the_error_of_the_work_is_of_this_run_where_it_goes_on(how: dict[str, Any], tmp_path: Path) -> None:
    """The work itself counts from the start of the run before."""
    model = lw.Model()
    model.body("arm", mass=1.0, inertia=(0.01, 0.1, 0.1), position=(0.3, 0, 0))
    model.revolute("ground", "arm", at=(0, 0, 0), axis=(0, 1, 0))
    model.rotational_spring_damper("ground", "arm", at=(0, 0, 0), axis=(0, 1, 0), damping=0.5)
    start = quick(model, 0.5, **how).snapshot()
    result = quick(model, 1.0, start=start, verify=True, output=tmp_path / "rest.h5", **how)
    assert result.manifest["resumed"] and result.work[0] < -1.0
    for it in (result, lw.Result.load(tmp_path / "rest.h5")):
        assert it.error_of("work").max() < 1e-7


# --- events ---


def ball(drag: float) -> lw.Model:
    model = lw.Model()
    model.body("ball", mass=1.0, inertia=(1, 1, 1), position=(0, 0, 1.0), velocity=(0.3, 0, 0))
    model.drag("ground", "ball", at=(0, 0, 1), coefficient=drag)
    return model


def bounce(t: float, state: Any) -> None:
    state.body("ball").velocity[2] *= -0.8


def floor(level: float = 0.0, **how: Any) -> lw.Event:
    return lw.Event(lambda t, state: state.body("ball").position[2] - level, "floor", -1, **how)


@pytest.mark.parametrize("drag", np.linspace(0.1, 1.0, 6))
def test_frames_between_the_times_of_an_impact_in_both_runs_are_no_error(drag: float, tmp_path: Path) -> None:
    """There one ball falls still, and the other rises."""
    how: dict[str, Any] = {"events": floor(change=bounce), "record_every": 1}
    result = quick(ball(drag), 1.0, rtol=1e-6, verify=True, **how)
    best = quick(ball(drag), 1.0, rtol=1e-12, **how)
    true = float(np.abs(result.v[-1] - best.v[-1]).max())
    assert len(result.events) == len(best.events) > 0
    assert result.verdict is not None and result.verdict.level == "good"
    result.save(tmp_path / "run.h5")
    for it in (result, lw.Result.load(tmp_path / "run.h5")):
        error = it.error_of("velocity")
        assert true / 5 < error.max() < 20 * true and np.isfinite(error).all()


@pytest.mark.parametrize("events", [(), floor(0.3, change=bounce)])
def test_impacts_that_the_finer_run_has_not_or_at_other_times_are_told(events: Any) -> None:
    first = quick(ball(0.2), 1.0, rtol=1e-6, events=floor(change=bounce), record_every=1)
    second = quick(ball(0.2), 1.0, rtol=1e-7, events=events, times=first.t)
    assert state_error(first, Finer.of(first, second, 1.1)).error > 0.1


def test_a_finer_run_without_a_frame_in_common_is_of_another_motion() -> None:
    first = quick(ball(0.2), 0.3, rtol=1e-6, times=[0.2, 0.3])
    finer = Finer.of(first, quick(ball(0.2), 0.1, rtol=1e-7), 1.1)
    assert state_error(first, finer).error == 1.0
    first._finer = finer
    assert np.isnan(first.error_of("position")).all()


def test_runs_that_an_event_ends_are_compared_there() -> None:
    result = quick(ball(0.5), 1.0, rtol=1e-4, events=floor(terminal=True), record_every=1, verify=True)
    best = quick(ball(0.5), 1.0, rtol=1e-12, events=floor(terminal=True), record_every=1)
    error, true = result.error_of("velocity")[-1], np.abs(result.velocity[-1] - best.velocity[-1])
    assert result.t[-1] < 0.9 and true.max() / 5 < error.max() < 20 * true.max()


def test_a_verified_result_is_saved_over_its_own_file(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    result = quick(mechanisms.four_bar(), 0.1, step=1e-2, verify=True, output=path)
    error = result.error_of("q")
    result.save(path, overwrite=True)
    found = lw.Result.load(path)
    assert found.verified and found.finished
    np.testing.assert_array_equal(found.error_of("q"), error)


def test_events_that_count_begin_anew_in_the_second_run() -> None:
    passed: list[float] = []

    def third(t: float, state: lw.State) -> bool:
        passed.append(t)
        return len(passed) == 3

    bottom = lw.Event(lambda t, state: state.body("bob").position[0], "bottom", change=third)
    result = quick(lw.mechanisms.pendulum(), 10.0, rtol=1e-9, events=bottom, verify=True)
    assert passed == [it.t for it in result.events] and len(passed) == 3
    assert result.verified and result.finished


def test_an_error_is_known_where_the_largest_step_limits_steps_and_not_the_tolerances() -> None:
    model = mechanisms.pendulum()
    exact = quick(model, 0.5, rtol=1e-12, on_inaccurate="pass")
    for step in (0.05, 0.02):
        result = quick(model, 0.5, rtol=1e-2, step=step, record_every=1, verify=True)
        error, told = np.abs(result.q[-1] - exact.q[-1]).max(), np.abs(result.error_of("q")[-1]).max()
        assert error < 1.5 * told < 5 * error, step


class _Sampled:
    """A controller that an event samples every 0.05 s."""

    def __init__(self) -> None:
        self.held = 0.0
        self.clock = lw.Event(lambda t, state: np.sin(20 * np.pi * t + 0.1), "clock", change=self.sample)

    def sample(self, t: float, state: lw.State) -> None:
        self.held = -3.0 * state.body("bob").position[0] - 2.0 * state.body("bob").velocity[0]

    def model(self) -> lw.Model:
        model = mechanisms.pendulum()
        model.user_force(lambda t, q, v: [self.held, 0, 0, 0, 0, 0], "bob", name="controller")
        return model


def test_a_sampled_controller_is_run_twice_and_left_with_what_the_first_run_held() -> None:
    sampled, exact, once = _Sampled(), _Sampled(), _Sampled()
    how: dict[str, Any] = {"step": 0.02, "record_every": 1}
    result = quick(sampled.model(), 0.5, rtol=1e-4, events=sampled.clock, verify=True, **how)
    truth = quick(exact.model(), 0.5, rtol=1e-11, events=exact.clock, **how)
    quick(once.model(), 0.5, rtol=1e-4, events=once.clock, **how)
    assert result.verified and sampled.held == once.held != exact.held
    error = np.abs(result.q[-1] - truth.q[-1]).max()
    assert error < 2 * np.abs(result.error_of("q")[-1]).max() < 20 * error
    with pytest.warns(lw.LinkworkWarning, match="'controller': reads what events have changed in a run"):
        quick(sampled.model(), 0.5, rtol=1e-4, events=sampled.clock, **how)


def test_a_second_run_that_fails_loses_nothing() -> None:
    """A force that is not known at odd multiples of a quarter of the step, where only a finer run asks."""
    model, step = lw.Model(), 1e-2
    body = model.body("weight", mass=1.0, inertia=(0.1, 0.1, 0.1))

    def gust(t: float) -> float:
        return np.nan if t > 0.05 and abs(t / (step / 2) % 1.0 - 0.5) < 0.01 else 1.0

    model.force(body, force=(gust, 0, 0), name="gust")
    with pytest.warns(lw.LinkworkWarning, match="verify: the second run failed.*gust"):
        result = quick(model, 0.1, step=step, verify=True)
    assert not result.verified
    assert result.t[-1] == 0.1


@pytest.mark.parametrize(("height", "hysteresis"), [(0.3228, 0.5), (0.2995, 1.0), (0.3268, 2.0)])
def test_a_contact_that_begins_in_the_second_half_of_a_step_is_seen(height: float, hysteresis: float) -> None:
    """Half the step would end where the step does: both take the speed there for that of the touch."""
    model = lw.Model()
    ball = model.body("ball", mass=0.1, inertia=(4e-5,) * 3, position=(0, 0, height))
    model.sphere_plane_contact(
        model.ground, ball, at=((0, 0, 0), (0, 0, height)), normal=(0, 0, 1), radius=0.03, stiffness=1e4,
        hysteresis=hysteresis,
    )  # fmt: skip
    exact = quick(model, 0.5, rtol=1e-12, times=[0.5])
    result = quick(model, 0.5, step=2e-4, verify=True)
    off = float(np.abs(result.v[-1] - exact.v[-1]).max()) / 2.3
    assert result.verdict is not None and off / 3 < result.verdict.error < 0.01
    assert np.abs(result.error_of("body", "ball").velocity).max() > off * 2.3 / 5
