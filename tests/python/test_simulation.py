"""One run: what is refused before it, how it is recorded, and how it ends."""

from __future__ import annotations

import _thread
import math
import signal
import sys
import threading
import time
import warnings
from pathlib import Path
from types import FrameType
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.arrays import Floats
from linkwork.running.progress import ProgressInfo
from scipy.integrate import solve_ivp


def forgetful(t: float, state: lw.State) -> Any:
    """A function that forgot to return."""


#: Too large for a step of 1 ms.
GAINS = {"baumgarte_alpha": 3e3, "baumgarte_beta": 3e3}


@pytest.mark.parametrize(
    ("arguments", "fragments"),
    [
        ({"step": 0.0}, ["step 0.0 s"]),
        ({"step": -1e-3}, ["step -0.001 s"]),
        ({"step": math.nan}, ["step nan s"]),
        ({"step": "short"}, ["step 'short' s"]),
        ({"t_end": -1.0}, ["t_end -1.0 s"]),
        ({"t_end": True}, ["t_end True s must be a finite number"]),
        ({"step": np.True_}, ["step", "True", "must be a finite number"]),
        ({"rtol": True}, ["rtol True must be a finite number"]),
        ({"t_end": math.inf}, ["t_end inf s"]),
        ({"t_end": 1e300, "step": 1e-300}, ["step"]),
        ({"integrator": "rk5"}, ["'rk5'", "'rk4'"]),
        ({"integrator": 4}, ["integrator 4"]),
        ({"record_every": 0}, ["record_every 0"]),
        ({"integrator": lambda system, t, y, h: None}, ["the state that it returned None is not"]),
        ({"integrator": lambda system, t, y, h: 0.0}, ["shape ()", "(13,)"]),
        ({"progress": "yes"}, ["progress 'yes'"]),
        ({"start": (0, 1)}, ["start (0, 1)", "Snapshot"]),
        ({"rtol": 1e-6, "times": ["soon"]}, ["times ['soon']"]),
        ({"rtol": 1e-6, "events": 5}, ["events: 5"]),
        ({"rtol": 1e-6, "events": lw.Event("f")}, ["'f' is no function of (t, state)"]),  # type: ignore[arg-type]
        ({"rtol": 1e-6, "events": lw.Event(forgetful, "touch")}, ["'touch'", "None, no number"]),
        (
            {"stabilization": "baumgarte", **GAINS},
            ["3000 1/s", "rk4", "0.001 s"],
        ),
    ],
)
def test_a_run_that_cannot_be_made_is_refused(arguments: dict[str, Any], fragments: list[str]) -> None:
    with pytest.raises(lw.OptionError) as caught:
        lw.simulate(lw.mechanisms.pendulum(), **{"t_end": 1.0, "step": 1e-3, **arguments})
    message = str(caught.value)
    assert [fragment for fragment in fragments if fragment not in message] == [], message


def test_a_model_without_bodies_is_refused() -> None:
    with pytest.raises(lw.ModelError, match="'void'.*no bodies"):
        lw.simulate(lw.Model(name="void"), t_end=1.0, step=0.1)


def test_a_result_says_which_equations_are_redundant_and_which_reactions_are_open() -> None:
    result = lw.simulate(lw.mechanisms.four_bar(), t_end=0.1, step=1e-3)
    assert result.manifest["constraints"] == {
        "equations": 20, "rank": 17, "degrees_of_freedom": 1, "redundant": 3, "singular_at_start": 0,
    }  # fmt: skip
    assert len(result.redundant_rows) == 3
    assert not result.unique_reactions.any()
    assert "not unique in 4 of 4 joints (rank 17 of 20)" in result.summary()


def wheel_with_two_drivers(second: lw.functions.TimeFunction) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("wheel", mass=1.0, inertia=(1, 1, 1), omega=(0, 0, 1.0))
    model.revolute("ground", "wheel", at=(0, 0, 0), axis=(0, 0, 1), name="axle")
    model.drive("axle", velocity=1.0, name="first")
    model.drive("axle", position=second, name="second")
    return model


def test_drivers_that_part_from_each_other_are_an_error_that_names_both() -> None:
    agreeing = wheel_with_two_drivers(lw.functions.polynomial(0.0, 1.0))
    assert lw.simulate(agreeing, 3.0, 1e-2).violation.max() < 1e-9
    parting = wheel_with_two_drivers(lw.functions.harmonic(1.0, 1.0))
    with pytest.raises(lw.ViolationError, match="'first', 'second' contradict each other") as caught:
        lw.simulate(parting, 3.0, 1e-2)
    assert caught.value.time < 0.2, "t - sin t = 1e-3"


def test_a_massless_body_that_a_hinge_leaves_free_is_refused_by_name_and_direction() -> None:
    model = lw.Model()
    model.body("feather", mass=0, inertia=(0, 0, 0))
    model.revolute("ground", "feather", at=(0, 0, 0), axis=(0, 0, 1))
    with pytest.raises(lw.SingularSystemError, match=r"'feather'.*no joint resists, .*\(0, 0, 1\).*give it"):
        lw.simulate(model, t_end=1.0, step=1e-3)


def inconsistent(joints: int, speed: float = 1.0) -> lw.Model:
    """Bodies that leave their pins with 1, 2, 3, ... times a speed."""
    model = lw.Model()
    for k in range(joints):
        model.body(f"body {k}", mass=1, inertia=(1, 1, 1), velocity=((k + 1) * speed, 0, 0))
        model.spherical("ground", f"body {k}", at=(0, 0, 0), name=f"pin {k}")
    return model


def test_inconsistent_velocities_are_refused_with_the_residual_of_each_joint() -> None:
    with pytest.raises(
        lw.ModelError, match=r"velocities.*2 joints.*pin 1 2/s; pin 0 1/s.*assemble"
    ) as caught:
        lw.simulate(inconsistent(2), t_end=0.0, step=1e-3)
    assert caught.value.residuals == {"pin 1": 2.0, "pin 0": 1.0}


def test_the_message_lists_the_worst_five_joints() -> None:
    with pytest.raises(lw.ModelError, match=r"7 joints.*pin 6 7/s; .*pin 2 3/s; and 2 more"):
        lw.simulate(inconsistent(7), t_end=0.0, step=1e-3)


def test_slightly_inconsistent_velocities_are_corrected_with_a_warning() -> None:
    with pytest.warns(lw.LinkworkWarning, match=r"2 joints.*pin 1 0\.0002/s.*velocities by 0\.0002 m/s"):
        result = lw.simulate(inconsistent(2, 1e-4), t_end=0.0, step=1e-3)
    assert np.abs(result.v).max() <= 1e-15


def test_a_run_can_start_from_a_violation_with_a_warning() -> None:
    with pytest.warns(lw.LinkworkWarning, match=r"velocities.*2 joints.*pin 1 2/s; pin 0 1/s$"):
        result = lw.simulate(inconsistent(2), t_end=0.0, step=1e-3, assemble=False)
    assert result.violation[0, 1] == pytest.approx(2.0)
    assert result.manifest["assembled"] is None


def test_the_warning_points_at_the_call_of_simulate() -> None:
    with pytest.warns(lw.LinkworkWarning) as caught:
        lw.simulate(inconsistent(1, 1e-4), t_end=0.0, step=1e-3)
    assert [Path(warning.filename).name for warning in caught] == ["test_simulation.py"]


def test_an_inconsistent_pose_is_refused() -> None:
    model = lw.Model()
    model.body("rod", mass=1, inertia=(1, 1, 1), position=(0, 0, 1))
    model.spherical("ground", "rod", at=((0, 0, 0.25), (0, 0, 0)), frames="body", name="ball")
    with pytest.raises(lw.ModelError, match=r"poses.*ball 0\.75"):
        lw.simulate(model, t_end=0.0, step=1e-3)


def test_large_baumgarte_gains_are_a_warning() -> None:
    gains = {"baumgarte_alpha": 500.0, "baumgarte_beta": 500.0}
    with pytest.warns(lw.LinkworkWarning, match=r"500 1/s.*'rk4' loses its order 4"):
        lw.simulate(lw.mechanisms.pendulum(), 0.01, 1e-3, stabilization="baumgarte", **gains)


def test_baumgarte_gains_that_are_not_given_are_told_and_checked() -> None:
    result = lw.simulate(lw.mechanisms.pendulum(), 0.01, 1e-3, stabilization="baumgarte")
    assert {name: result.manifest["options"][f"baumgarte_{name}"] for name in ("alpha", "beta")} == {
        "alpha": 5.0, "beta": 5.0
    }  # fmt: skip
    with pytest.warns(lw.LinkworkWarning, match=r"alpha 5 1/s .* are above 0.1 / step: .* loses its order"):
        lw.simulate(lw.mechanisms.pendulum(), 0.1, 0.025, stabilization="baumgarte", on_inaccurate="pass")
    with pytest.raises(lw.OptionError, match="alpha 5 1/s .* unstable with integrator 'euler' and step 0.5"):
        lw.simulate(lw.mechanisms.pendulum(), 1.0, 0.5, stabilization="baumgarte", integrator="euler")


def test_consistent_mechanisms_run_without_a_warning() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        lw.simulate(lw.mechanisms.spatial_slider_crank(), t_end=0.01, step=1e-3)


def classical(system: lw.System, t: float, y: Floats, h: float) -> Floats:
    k1 = system.derivative(t, y)
    k2 = system.derivative(t + h / 2, y + h / 2 * k1)
    k3 = system.derivative(t + h / 2, y + h / 2 * k2)
    k4 = system.derivative(t + h, y + h * k3)
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


@pytest.mark.parametrize("stabilization", ["none", "baumgarte", "sampled_baumgarte"])
def test_an_integrator_of_the_users_own_runs_as_the_compiled_one(stabilization: str) -> None:
    model = lw.mechanisms.spatial_slider_crank()
    own, compiled = (
        lw.simulate(model, 0.1, 1e-3, method, stabilization=stabilization) for method in (classical, "rk4")
    )
    assert len(own) == len(compiled) == 101
    apart = 10.0 if stabilization == "sampled_baumgarte" else 1.0  # the correction is added beside the step
    assert np.abs(own.q - compiled.q).max() < 1e-12 * apart
    assert np.abs(own.multipliers - compiled.multipliers).max() < 1e-9 * apart


def with_either_sign(system: lw.System, t: float, y: Floats, h: float) -> Floats:
    """Orientations as of libraries whose quaternions change their sign now and then."""
    new = classical(system, t, y, h)
    p = new[3:7]
    p *= np.sign(np.sin(300 * t)) or 1.0
    return new


def test_euler_parameters_of_a_step_may_change_their_sign() -> None:
    model = lw.mechanisms.rod_pendulum()
    model.linear_damping("ground", "rod", at=((0, 0, 0), (0.3, 0, 0)), frames="body", damping=1.0)
    flipped, plain = (
        lw.simulate(model, 0.3, 2e-3, method, progress=False) for method in (with_either_sign, classical)
    )
    assert (np.abs(np.diff(np.sign(flipped.q[:, 0, 3]))) > 0).sum() > 10
    assert np.abs(flipped.work - plain.work).max() < 1e-10
    assert np.abs(flipped.energy_error).max() < 1e-6
    assert flipped.verdict.growth == pytest.approx(plain.verdict.growth, rel=0.1)  # step errors are rounding


class Adams:
    """Of order 2, with the rates of the last step in its memory."""

    def __init__(self) -> None:
        self.rates: Floats | None = None

    def __call__(self, system: lw.System, t: float, y: Floats, h: float) -> Floats:
        rates = system.derivative(t, y)
        before, self.rates = self.rates, rates
        if before is None:
            return y + h * system.derivative(t + h / 2, y + h / 2 * rates)
        return y + h / 2 * (3 * rates - before)


def implicit_euler(system: lw.System, t: float, y: Floats, h: float) -> Floats:
    new = y
    for _ in range(20):
        new = y + h * system.derivative(t + h, new)
    return new


def semi_implicit(system: lw.System, t: float, y: Floats, h: float) -> Floats:
    q = 7 * system.model.body_count
    v = y[q:] + h * system.derivative(t, y)[q:]
    return np.concatenate([y[:q] + h * system.derivative(t, np.concatenate([y[:q], v]))[:q], v])


@pytest.mark.parametrize(
    ("make_method", "order"),
    [(Adams, 2), (lambda: implicit_euler, 1), (lambda: semi_implicit, 1), (lambda: classical, 4)],
)
def test_integrators_of_the_users_own_keep_their_order(make_method: Any, order: int) -> None:
    """Those of several steps and implicit ones, too, by the default stabilization: in states and in work."""
    model = lw.mechanisms.spatial_slider_crank()
    model.linear_damping("ground", "slider", at=((0, 0, 0), (0, 0, 0)), frames="body", damping=2.0)
    truth = lw.simulate(model, 0.25, rtol=1e-11, integrator="dop853", times=[0.25])
    errors, told = [], []
    for step in (1e-3, 5e-4):
        run = lw.simulate(model, 0.25, step, make_method(), on_inaccurate="pass")
        errors.append([np.abs(run.v[-1] - truth.v[-1]).max(), abs(run.work[-1] - truth.work[-1])])
        assert run.verdict is not None
        told.append(run.verdict.error)
    assert np.log2(told[0] / told[1]) > 0.5 * order
    assert (np.log2(np.divide(*errors)) > order - 0.35).all()


def test_an_own_integrator_is_named_in_the_manifest() -> None:
    result = lw.simulate(lw.mechanisms.pendulum(), 0.01, 1e-3, classical)
    assert result.manifest["options"]["integrator"] == "classical"


def test_an_own_integrator_that_returns_too_little_is_refused() -> None:
    with pytest.raises(lw.OptionError, match="7"):
        lw.simulate(lw.mechanisms.pendulum(), 0.01, 1e-3, lambda system, t, y, h: y[:7])


def test_an_error_in_an_own_integrator_reaches_the_user() -> None:
    def broken(system: lw.System, t: float, y: Floats, h: float) -> Floats:
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine") as caught:
        lw.simulate(lw.mechanisms.pendulum(), 0.01, 1e-3, broken)
    assert caught.value.__notes__ == ["linkwork: in the step after t = 0 s; its `result` has 1 frame"]


@pytest.mark.parametrize("in_file", [True, False])
def test_an_error_of_a_users_own_law_has_the_frames_up_to_there_and_the_state_to_go_on_from(
    in_file: bool, tmp_path: Path
) -> None:
    model, broken = lw.mechanisms.pendulum(), [True]

    def law(t: float, q: Floats, v: Floats) -> list[float]:
        if broken[0] and t > 0.1005:
            raise OSError("no answer")
        return [-v[0], 0, 0, 0, 0, 0]

    model.user_force(law, "bob", name="remote")
    with pytest.raises(OSError, match="no answer") as caught:
        lw.simulate(model, 0.2, step=1e-3, output=tmp_path / "run.h5" if in_file else None)
    error: Any = caught.value
    assert error.__notes__[0].endswith("its `result` has 101 frames")
    assert not error.result.finished and error.state.t == error.result.t[-1] == pytest.approx(0.1)
    broken[0] = False
    whole, rest = lw.simulate(model, 0.2, step=1e-3), lw.simulate(model, 0.2, step=1e-3, start=error.state)
    assert np.abs(rest.q[-1] - whole.q[-1]).max() < 1e-12


def test_an_error_of_a_users_own_that_has_a_result_keeps_it() -> None:
    class Refused(Exception):
        result = "mine"

    def law(t: float, q: Floats, v: Floats) -> list[float]:
        raise Refused

    model = lw.mechanisms.pendulum()
    model.user_force(law, "bob", name="remote")
    with pytest.raises(Refused) as caught:
        lw.simulate(model, 0.2, step=1e-3)
    assert caught.value.result == "mine"


def test_the_derivative_fits_solve_ivp() -> None:
    model = lw.mechanisms.rod_pendulum()
    system = lw.System(model, stabilization="none")
    solution = solve_ivp(system.derivative, (0, 1), system.initial_state(), rtol=1e-10, atol=1e-12)
    result = lw.simulate(model, 1.0, 1e-3)
    assert solution.y[:3, -1] == pytest.approx(result.position[-1, 0], abs=1e-8)


def test_the_terms_of_a_system_are_its_equations() -> None:
    """M v_dot - D^T lambda = g and D v_dot = gamma."""
    system = lw.System(lw.mechanisms.spatial_slider_crank())
    y = system.initial_state()
    q, v = y[: 7 * 3], y[7 * 3 :]
    at = system.evaluate(0.0, q, v)
    v_dot, multipliers = system.accelerations(0.0, q, v)
    D = np.zeros((17, 18))
    data, columns, starts = at.D
    for row in range(17):
        part = slice(starts[row], starts[row + 1])
        D[row, columns[part]] = data[part]
    M_v_dot = np.einsum("nij,nj->ni", at.M, v_dot.reshape(3, 6)).ravel()
    assert np.abs(M_v_dot - D.T @ multipliers - at.g).max() < 1e-12 * np.abs(at.g).max()
    assert np.abs(D @ v_dot - at.gamma).max() < 1e-12 * np.abs(at.gamma).max()


@pytest.mark.parametrize(("steps", "every", "frames"), [(10, 1, 11), (10, 3, 5), (10, 100, 2), (0, 1, 1)])
def test_the_first_and_the_last_state_are_always_recorded(steps: int, every: int, frames: int) -> None:
    result = lw.simulate(lw.mechanisms.pendulum(), steps * 0.01, 0.01, record_every=every)
    assert len(result) == frames
    assert (result.t[0], result.t[-1]) == (0.0, pytest.approx(steps * 0.01, abs=1e-15))


def test_about_a_thousand_frames_are_recorded() -> None:
    assert 500 <= len(lw.simulate(lw.mechanisms.pendulum(), 2.5, 1e-3)) <= 1001


def test_a_step_that_does_not_divide_the_time_is_shortened_at_the_end() -> None:
    result = lw.simulate(lw.mechanisms.pendulum(), 0.1, 0.03)
    assert result.t == pytest.approx((0, 0.03, 0.06, 0.09, 0.1), abs=1e-15)


def test_a_result_in_a_file_is_that_in_memory(tmp_path: Path) -> None:
    model = lw.mechanisms.spatial_slider_crank()
    in_memory = lw.simulate(model, 0.1, 1e-3)
    in_file = lw.simulate(model, 0.1, 1e-3, output=tmp_path / "run.h5")
    for name in ("t", "q", "v", "acceleration", "multipliers", "energy", "work", "violation"):
        assert np.array_equal(getattr(in_file, name), getattr(in_memory, name)), name
    assert in_file.finished


def test_an_output_that_cannot_be_written_is_refused_before_the_run() -> None:
    """The run itself would take years."""
    with pytest.raises(lw.FileError, match="/no/such/place"):
        lw.simulate(lw.mechanisms.pendulum(), 1e11, 1e-3, output="/no/such/place/run.h5")


def test_progress_is_told_up_to_the_end() -> None:
    told: list[ProgressInfo] = []
    lw.simulate(lw.mechanisms.heavy_top(), 1.0, 1e-5, progress=told.append)
    assert len(told) > 1
    assert told[-1].t == 1.0
    assert told[-1].steps_done == told[-1].steps_total == 100_000


def test_a_diverging_run_names_body_and_time() -> None:
    model = lw.mechanisms.heavy_top()
    with pytest.raises(lw.NotFiniteError) as caught:
        lw.simulate(model, 100.0, 0.5, "euler", stabilization="none")
    assert caught.value.time is not None
    assert "'top'" in str(caught.value) or "diverged" in str(caught.value)


def reports_after_interrupt(integrator: Any, **arguments: Any) -> int:
    """Reports of progress, ten a second, of an endless run between Ctrl-C and its KeyboardInterrupt."""
    pressed, under_way, late = threading.Event(), threading.Event(), []

    def press() -> None:
        if not under_way.wait(60):
            return  # it has failed, and nobody is there to be interrupted
        time.sleep(0.2)
        pressed.set()
        _thread.interrupt_main()

    def progress(info: lw.ProgressInfo) -> None:
        if pressed.is_set():
            late.append(info)
        if info.fraction > 0:
            under_way.set()

    threading.Thread(target=press).start()
    with pytest.raises(KeyboardInterrupt):
        lw.simulate(lw.mechanisms.heavy_top(), 1e4, 1e-4, integrator, progress=progress, **arguments)
    return len(late)


@pytest.mark.parametrize("integrator", ["rk4", classical], ids=["compiled", "own"])
def test_an_interrupt_ends_a_run_before_its_next_piece(integrator: Any) -> None:
    assert reports_after_interrupt(integrator) <= 1


def test_an_interrupted_run_leaves_a_readable_file(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    reports_after_interrupt("rk4", record_every=100, output=path)
    result = lw.Result.load(path)
    assert len(result) > 10
    assert not result.finished
    assert np.isfinite(result.energy).all()


def test_ctrl_c_means_again_what_it_meant_before_the_run() -> None:
    before = signal.getsignal(signal.SIGINT)
    lw.simulate(lw.mechanisms.pendulum(), 0.01, 1e-3)
    assert signal.getsignal(signal.SIGINT) is before


def test_the_manifest_says_what_was_given_and_what_was_chosen() -> None:
    model = lw.mechanisms.pendulum()
    manifest = lw.simulate(model, 0.01, 1e-3, linear_solver="auto").manifest
    assert manifest["model_hash"] == model.hash()
    assert manifest["options_given"]["linear_solver"] == "auto"
    assert manifest["options"]["linear_solver"] != "auto"
    assert manifest["versions"].keys() == {"linkwork", "numpy", "python"}


def python_calls(steps: int) -> int:
    """Of Python functions, during a run of so many steps."""
    calls = 0

    def count(frame: FrameType, event: str, argument: Any) -> None:
        nonlocal calls
        calls += event == "call"

    sys.setprofile(count)
    try:
        lw.simulate(lw.mechanisms.chain(5), steps * 1e-4, 1e-4, record_every=100, progress=False)
    finally:
        sys.setprofile(None)
    return calls


def test_no_python_runs_in_the_loop() -> None:
    """Only between pieces of the run, a tenth of a second each."""
    python_calls(10)  # imports
    assert python_calls(20_000) - python_calls(1_000) < 500
