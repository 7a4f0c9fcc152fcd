"""History variables against closed forms: what springs, stops, contacts and couplers know of the past."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms
from linkwork.integrators import METHODS, EmbeddedPair
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

FIXED = sorted(METHODS)
ADAPTIVE = sorted(name for name, method in METHODS.items() if isinstance(method, EmbeddedPair))
MULTISTEP = sorted(name for name in METHODS if name.startswith("ab"))
ONE_STEP = sorted(METHODS.keys() - MULTISTEP)


def run(model: lw.Model, t_end: float, **options: Any) -> lw.Result:
    """Also with steps that are long on purpose."""
    return lw.simulate(model, t_end, progress=False, **{"on_inaccurate": "pass", **options})


def wheel(omega: float, inertia: float = 1.0) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("wheel", mass=1.0, inertia=(1, 1, inertia), omega=(0, 0, omega))
    model.revolute("ground", "wheel", at=(0, 0, 0), axis=(0, 0, 1), name="axle")
    return model


def rotated(angle: float) -> np.ndarray:
    """Euler parameters of a rotation about z (1, 4)."""
    return np.array([[np.cos(angle / 2), 0.0, 0.0, np.sin(angle / 2)]])


class Motion:
    """A model and the angular velocity of its wheel in closed form."""

    def __init__(self, model: lw.Model, rate: Callable[[float], float], t_end: float, size: float) -> None:
        self.model, self.rate, self.t_end, self.size = model, rate, t_end, size

    def error(self, result: lw.Result) -> float:
        """Relative to the largest speed, over all frames."""
        exact = np.array([self.rate(t) for t in result.t])
        return float(np.abs(result.omega[:, 0, 2] - exact).max()) / self.size


def spring() -> Motion:
    """theta = (w_0 / s) sin(s t), 8 turns to either side."""
    model = wheel(100.0)
    model.rotational_spring_damper("ground", "wheel", axis=(0, 0, 1), stiffness=4.0, name="mainspring")
    return Motion(model, lambda t: 100.0 * np.cos(2.0 * t), 2.5, 100.0)


def stop() -> Motion:
    """An elastic stop after 4.8 turns: half a vibration in it, and back."""
    model = wheel(30.0)
    model.rotational_stop(
        "ground", "wheel", at=(0, 0, 0), axis=(0, 0, 1), lower=-100.0, upper=30.0, stiffness=100.0
    )

    def rate(t: float) -> float:
        inside = min(max(t - 1.0, 0.0), np.pi / 10.0)
        return float(30.0 * np.cos(10.0 * inside))

    return Motion(model, rate, 1.8, 30.0)


def belt() -> Motion:
    """Two pulleys and a torque: (J_1 + J_2 / 4) theta_ddot = M."""
    model = wheel(0.0)
    model.body("small", mass=1.0, inertia=(1, 1, 0.4), position=(1, 0, 0))
    model.revolute("ground", "small", at=(1, 0, 0), axis=(0, 0, 1), name="other")
    model.coupler([("axle", 1.0), ("other", -2.0)], name="belt")
    model.rotational_spring_damper("ground", "wheel", axis=(0, 0, 1), torque=11.0)
    return Motion(model, lambda t: 10.0 * t, 2.0, 20.0)


def motor() -> Motion:
    """J w_dot = n_0 (1 - w / w_0)."""
    model = wheel(0.0, 0.5)
    curve = lw.functions.polynomial(10.0, -0.25)
    model.motor("ground", "wheel", at=(0, 0, 0), axis=(0, 0, 1), curve=curve)
    return Motion(model, lambda t: 40.0 * (1.0 - np.exp(-0.5 * t)), 3.0, 40.0)


MOTIONS = {motion.__name__: motion for motion in (spring, stop, belt, motor)}


# --- closed forms -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("integrator", ADAPTIVE)
@pytest.mark.parametrize("name", MOTIONS)
def test_adaptive_steps_meet_their_tolerance_whatever_is_recorded(name: str, integrator: str) -> None:
    motion = MOTIONS[name]()
    rtol = 1e-5 if integrator == "bs32" else 1e-8
    asked: list[dict[str, Any]] = [
        {"record_every": 1},
        {"times": [motion.t_end]},
        {"times": np.linspace(0, motion.t_end, 7)},
        {"times": np.linspace(0, motion.t_end, 1001)},
        {"times": np.sort(np.random.default_rng(0).uniform(0, motion.t_end, 50))},
    ]
    results = [run(motion.model, motion.t_end, rtol=rtol, integrator=integrator, **it) for it in asked]
    for result in results:
        assert motion.error(result) < 10 * rtol
        assert result.statistics["steps"] == results[0].statistics["steps"]
    assert all(np.array_equal(it.q[-1], results[0].q[-1]) for it in results[1:4])
    assert all(np.array_equal(it.v[-1], results[0].v[-1]) for it in results[1:4])


@pytest.mark.parametrize("integrator", FIXED)
@pytest.mark.parametrize("name", ("spring", "belt", "motor"))
def test_fixed_steps_keep_the_order_of_the_method(name: str, integrator: str) -> None:
    motion, order = MOTIONS[name](), min(METHODS[integrator].order, 5)
    step = motion.t_end / (2000 if order == 1 or integrator in MULTISTEP else 1000 if order < 4 else 250)
    errors = [
        motion.error(run(motion.model, motion.t_end, step=h, integrator=integrator)) for h in (step, step / 2)
    ]
    assert errors[1] < max(1.35 * 2.0**-order * errors[0], 1e-11)
    assert errors[0] < 0.1


@pytest.mark.parametrize("integrator", FIXED)
def test_a_stop_after_some_turns_sends_the_wheel_back_as_fast(integrator: str) -> None:
    motion = stop()
    error = motion.error(run(motion.model, motion.t_end, step=2e-4, integrator=integrator, record_every=10))
    assert error < {1: 5e-2, 2: 1e-4}.get(METHODS[integrator].order, 1e-5)


def rebound(hysteresis: float) -> float:
    """v dv/dd = -(K / m) d^n (1 + c v / v_0): v - (v_0 / c) log(1 + c v / v_0) is the same at both ends."""
    side = lambda v: v - np.log1p(hysteresis * v) / hysteresis  # noqa: E731
    return float(brentq(lambda v: side(v) - side(1.0), -min(1.0, 1.0 / hysteresis) * (1 - 1e-12), -1e-3))


def ball(hysteresis: float, height: float = 0.3) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("ball", mass=2.0, inertia=(0.2, 0.2, 0.2), position=(0, 0, height), velocity=(0, 0, -2.0))
    at = ((0, 0, 0), (0, 0, height))
    model.sphere_plane_contact("ground", "ball", at=at, normal=(0, 0, 1), radius=0.1, stiffness=1e6,
                               hysteresis=hysteresis)  # fmt: skip
    return model


@pytest.mark.parametrize("integrator", ADAPTIVE)
@pytest.mark.parametrize("hysteresis", (0.1, 0.8, 3.0))
def test_a_hysteretic_contact_rebounds_as_its_law_says(hysteresis: float, integrator: str) -> None:
    rtol = 1e-5 if integrator == "bs32" else 1e-8
    for times in ([0.2], np.linspace(0, 0.2, 2001)):
        result = run(ball(hysteresis), 0.2, rtol=rtol, integrator=integrator, times=times)
        assert result.v[-1, 0, 2] / -2.0 == pytest.approx(rebound(hysteresis), abs=10 * rtol)


@pytest.mark.parametrize("integrator", ("euler", "rk4", "abm4", "hem4"))
def test_a_hysteretic_contact_is_of_first_order_with_fixed_steps(integrator: str) -> None:
    rebounds = [
        run(ball(0.8), 0.2, step=h, integrator=integrator).v[-1, 0, 2] / -2.0 for h in (2e-5, 1e-5, 5e-6)
    ]
    errors = np.abs(np.array(rebounds) - rebound(0.8))
    assert errors[0] < 5e-3 and errors[2] < 0.6 * errors[0]


# --- the history is part of the state -----------------------------------------------------------------------


@pytest.mark.parametrize("integrator", ONE_STEP)
@pytest.mark.parametrize("name", MOTIONS)
def test_a_restart_in_mid_turn_goes_on_to_the_last_bit(name: str, integrator: str) -> None:
    motion = MOTIONS[name]()
    whole = run(motion.model, 0.3, step=1e-3, integrator=integrator, record_every=50)
    for frame in (1, 4):
        rest = run(
            motion.model, 0.3, step=1e-3, integrator=integrator, start=whole.snapshot(frame), record_every=7
        )
        assert np.array_equal(rest.q[-1], whole.q[-1])
        assert np.array_equal(rest.v[-1], whole.v[-1])
        assert np.array_equal(rest.history[-1], whole.history[-1])
    first = run(motion.model, 0.1, step=1e-3, integrator=integrator)
    rest = run(motion.model, 0.3, step=1e-3, integrator=integrator, start=first.snapshot())
    assert np.array_equal(rest.v[-1], whole.v[-1])


@pytest.mark.parametrize("integrator", ADAPTIVE)
@pytest.mark.parametrize("name", ("spring", "stop", "belt"))
def test_an_adaptive_run_goes_on_from_any_frame(name: str, integrator: str, tmp_path: Path) -> None:
    motion = MOTIONS[name]()
    rtol = 1e-5 if integrator == "bs32" else 1e-8
    path = tmp_path / "run.h5"
    options = {"rtol": rtol, "integrator": integrator}
    times = np.linspace(0, motion.t_end, 11)
    whole = run(motion.model, motion.t_end, times=times, output=path, **options)
    for frame in (3, 7):
        start = lw.Result.load(path).snapshot(frame)
        rest = run(motion.model, motion.t_end, start=start, **options)
        assert motion.error(rest) < 10 * rtol
    assert motion.error(whole) < 10 * rtol


def test_events_between_turns_do_not_disturb_the_count() -> None:
    motion = spring()
    full_turn = lw.Event(lambda t, state: state.q[0, 6], name="full turns")
    kick = lw.Event(lambda t, state: t - 0.377, name="nothing", change=lambda t, state: None)
    result = run(motion.model, motion.t_end, rtol=1e-9, events=[full_turn, kick])
    assert motion.error(result) < 1e-8
    outward = [it for it in result.events if it.t < np.pi / 4 and it.name == "full turns"]
    assert len(outward) == int(50.0 / (2 * np.pi))


def test_a_model_that_begins_wound_up_is_kept_in_files_and_copies(tmp_path: Path) -> None:
    motion = spring()
    half = run(motion.model, 0.5, step=1e-3)
    model = motion.model.with_initial_state(half.q[-1], half.v[-1], half.history[-1])
    model.save(tmp_path / "wound.yaml")
    for copy in (model, lw.Model.load(tmp_path / "wound.yaml"), lw.assemble(model).model):
        assert lw.System(copy).initial_history == pytest.approx([50.0 * np.sin(1.0)], abs=1e-5)
        again = run(copy, 0.5, step=1e-3)
        assert again.v[-1, 0, 5] == pytest.approx(100.0 * np.cos(2.0), abs=1e-5)
    assert lw.Model.load(tmp_path / "wound.yaml").hash() == model.hash() != motion.model.hash()
    model.rotational_spring_damper("ground", "wheel", axis=(0, 0, 1), stiffness=1.0)
    with pytest.raises(lw.ModelError, match=r"1 history variables, but .* have 2"):
        lw.System(model)


def test_inverse_dynamics_counts_turns_between_frames() -> None:
    """A spring of 1 N m/rad is turned by 10 rad from frame to frame."""
    model = wheel(0.0)
    model.rotational_spring_damper("ground", "wheel", axis=(0, 0, 1), stiffness=1.0)
    model.drive("axle", position=lw.functions.polynomial(0.0, 10.0), name="drive")
    needed = lw.inverse_dynamics(model, [0.0, 1.0, 2.0])
    assert needed.effort("drive") == pytest.approx([0.0, 10.0, 20.0], abs=1e-9)
    assert needed.motion.history[:, 0] == pytest.approx([0.0, 10.0, 20.0], abs=1e-9)


# --- evaluations are functions ------------------------------------------------------------------------------


def everything() -> lw.Model:
    """Every kind with history variables."""
    model = belt().model
    model.rotational_spring_damper("ground", "wheel", axis=(0, 0, 1), stiffness=3.0)
    model.rotational_stop("wheel", "small", at=(0, 0, 0), axis=(0, 0, 1), lower=-3, upper=4, stiffness=10.0)
    model.nonlinear_rotational_spring_damper("ground", "small", at=(1, 0, 0), axis=(0, 0, 1), spring=2.0)
    at = ((0, 0, 0), (0, 0, 0.05))
    model.sphere_plane_contact(
        "ground", "wheel", at=at, normal=(0, 0, 1), radius=0.1, stiffness=1e4, hysteresis=0.5
    )
    bead = model.body("bead", mass=1.0, inertia=(1, 1, 1), position=(3, 0, 0))
    angle = np.linspace(0, 2 * np.pi, 20, endpoint=False)
    points = np.column_stack([3 * np.cos(angle), 3 * np.sin(angle), 0 * angle])
    model.point_on_curve("ground", bead, points=points, at=(3, 0, 0), closed=True)
    return model


def test_evaluations_depend_on_their_arguments_alone() -> None:
    system, random = lw.System(everything()), np.random.default_rng(3)
    y = system.initial_state()
    nq = 7 * system.model.body_count
    states = [(0.1 * k, y + 0.2 * random.standard_normal(len(y)), system.initial_history + 20.0 * (k % 3))
              for k in range(8)]  # fmt: skip

    def found(case: tuple[float, np.ndarray, np.ndarray]) -> list[np.ndarray]:
        t, y, history = case
        at = system.evaluate(t, y[:nq], y[nq:], history)
        return [system.derivative(t, y, history), *system.accelerations(t, y[:nq], y[nq:], history),
                at.Phi, at.gamma, at.g, at.history, system.advance_history(t, y, history),
                system.derivative(t, y)]  # fmt: skip

    once = [found(case) for case in states]
    for k in random.permutation(np.repeat(np.arange(len(states)), 3)):
        for first, again in zip(once[k], found(states[k]), strict=True):
            assert np.array_equal(first, again)


def test_scipy_and_integrators_of_ones_own_are_right() -> None:
    motion = spring()
    system = lw.System(motion.model)
    y, history, t, h = system.initial_state(), system.initial_history, 0.0, 0.01
    for _ in range(100):
        found = solve_ivp(system.derivative, (t, t + h), y, rtol=1e-10, atol=1e-10, args=(history,))
        t, y = t + h, found.y[:, -1]
        history = system.advance_history(t, y, history)
    assert y[-1] == pytest.approx(motion.rate(t), abs=1e-6)
    assert history == pytest.approx([50.0 * np.sin(2.0)], abs=1e-6)

    def heun(system: lw.System, t: float, y: np.ndarray, h: float) -> np.ndarray:
        first = system.derivative(t, y)
        return y + h / 2 * (first + system.derivative(t + h, y + h * first))

    own, known = (run(motion.model, 1.0, step=1e-3, integrator=it) for it in (heun, "heun"))
    assert np.abs(own.v - known.v).max() < 1e-9


# --- recording changes nothing ------------------------------------------------------------------------------


@pytest.mark.parametrize("integrator", FIXED)
@pytest.mark.parametrize("name", ("four_bar", "bricard", "slider_crank"))
def test_recording_changes_no_bit_of_fixed_steps(name: str, integrator: str, tmp_path: Path) -> None:
    model = getattr(mechanisms, {"slider_crank": "spatial_slider_crank"}.get(name, name))()
    steps = {"step": 1e-3, "integrator": integrator}
    seldom = run(model, 0.1, record_every=1000, **steps)
    for record in ({"record_every": 1}, {"record_every": 7, "output": tmp_path / "run.h5"}):
        often = run(model, 0.1, **steps, **record)
        assert np.array_equal(often.q[-1], seldom.q[-1]) and np.array_equal(often.v[-1], seldom.v[-1])
        assert often.work[-1] == seldom.work[-1]


CHOICES: list[dict[str, Any]] = [
    {},
    {"stabilization": "projection"},
    {"formulation": "augmented_lagrangian"},
]


@pytest.mark.parametrize("integrator", ADAPTIVE)
@pytest.mark.parametrize("choice", CHOICES)
def test_recording_changes_no_step_of_adaptive_runs(choice: dict[str, Any], integrator: str) -> None:
    model = mechanisms.bricard()
    options = {"rtol": 1e-5, "integrator": integrator, **choice}
    every = run(model, 0.4, record_every=1, **options)
    for times in ([0.4], np.linspace(0, 0.4, 301), every.t):
        other = run(model, 0.4, times=times, **options)
        assert other.statistics["steps"] == every.statistics["steps"]
        assert other.statistics["rejected_steps"] == every.statistics["rejected_steps"]
        assert np.array_equal(other.q[-1], every.q[-1]) and np.array_equal(other.v[-1], every.v[-1])


# --- what cannot be counted is refused ----------------------------------------------------------------------


@pytest.mark.parametrize("rtol", (1e-5, 1e-8, 1e-11))
def test_a_free_wheel_turns_as_exactly_as_asked(rtol: float) -> None:
    """Of dop853 the leading term of the estimate changes the length of Euler parameters alone."""
    result = run(wheel(30.0), 1.0, rtol=rtol, integrator="dop853", times=[1.0])
    found, exact = lw.rotation.matrix(result.q[-1, :, 3:]), lw.rotation.matrix(rotated(30.0))
    assert np.abs(found - exact).max() < 10 * rtol


def test_fixed_steps_of_half_a_turn_are_refused_by_name() -> None:
    said = r"'mainspring': its angle turns by about .* rad in a step of 0\.03 s"
    with pytest.raises(lw.StepSizeError, match=said):
        run(spring().model, 1.0, step=0.03)


@pytest.mark.parametrize("integrator", ["euler", "rk4", "ab4", "semi_implicit_euler"])
@pytest.mark.parametrize("beside", [False, True])
def test_laws_of_joints_that_turn_half_a_turn_in_a_step_are_refused_by_name(
    integrator: str, beside: bool
) -> None:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("rotor", mass=1.0, inertia=(0.1, 0.1, 0.1), omega=(0, 0, 400.0))
    model.revolute("ground", "rotor", at=(0, 0, 0), axis=(0, 0, 1), name="shaft")
    if beside:
        model.linear_damping("ground", "rotor", at=(0, 0, 0), damping=1e-6, name="air")
    model.joint_force("shaft", lambda t, angle, rate: 0.1, name="motor")
    with pytest.raises(lw.StepSizeError, match=r"force 'motor': its angle turns by about") as refused:
        lw.simulate(model, 1.0, 0.01, integrator=integrator)
    assert refused.value.forces == ["motor"]


def test_adaptive_steps_stay_below_half_a_turn() -> None:
    """A spring that is too soft to limit the steps of a wheel that the method turns exactly enough."""
    model = wheel(100.0)
    model.rotational_spring_damper("ground", "wheel", axis=(0, 0, 1), stiffness=1e-12)
    result = run(model, 5.0, rtol=1e-2, integrator="dop853", record_every=1)
    assert np.diff(result.t).max() < np.pi / 100.0
    assert result.history[-1] == pytest.approx([500.0], rel=1e-2)


# --- whose history it is ------------------------------------------------------------------------------------

#: Torques [N m] on wheels.
TORQUES = {"a": 0.4, "b": 0.1, "c": 0.25}


def wheels(bodies: str, springs: str, coupled: tuple[str, ...] = (), **ends: str) -> lw.Model:
    """Wheels that motors turn against springs, made in such orders; each of two coupled ones has a slave.

    ends  of springs, where it is another wheel than that of their name
    """
    model = lw.Model(gravity=(0, 0, 0))

    def wheel(name: str, x: float, y: float) -> None:
        model.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1), position=(x, y, 0))
        model.revolute("ground", name, at=(x, y, 0), axis=(0, 0, 1), name=f"axle {name}")

    for name in bodies:
        wheel(name, 2.0 * "abc".index(name), 0.0)
    for name in coupled:
        wheel(f"{name}2", 2.0 * "abc".index(name), 2.0)
        ratio = 1.5 + "abc".index(name)
        model.coupler([(f"axle {name}", 1.0), (f"axle {name}2", -ratio)], name=f"belt {name}")
    law: dict[str, Any] = {"axis": (0, 0, 1), "stiffness": 0.02, "damping": 0.03}
    for name in springs:
        end = ends.get(name, name)
        model.rotational_spring_damper("ground", end, **law, torque=TORQUES[name], name=f"spring {name}")
    return model


def speeds(result: lw.Result, bodies: str) -> np.ndarray:
    return np.array([result.body(name).omega[-1, 2] for name in bodies])


@pytest.mark.parametrize("from_file", [False, True])
def test_full_turns_are_those_of_their_elements_whatever_their_order(from_file: bool, tmp_path: Path) -> None:
    path = tmp_path / "first.h5" if from_file else None
    first = run(wheels("abc", "abc", ("a", "b")), 5.0, rtol=1e-9, output=path)
    start = lw.Result.load(path).snapshot() if path else first.snapshot()
    whole = run(wheels("abc", "abc", ("a", "b")), 8.0, rtol=1e-9)
    model = wheels("abc", "abc", ("a", "b"))
    turned = {name: first.force(f"spring {name}", model).deflection[-1] for name in "abc"}
    assert turned["a"] > 2 * np.pi
    for model in (wheels("cab", "bca", ("b", "a")), wheels("abc", "cba", ("b", "a"))):
        rest = run(model, 8.0, rtol=1e-9, start=start)
        for name in "abc":
            began = rest.force(f"spring {name}").deflection[0]
            assert began == pytest.approx(turned[name], rel=1e-12)
        assert speeds(rest, "abc") == pytest.approx(speeds(whole, "abc"), rel=1e-6)


def test_an_event_at_the_start_is_that_of_its_body() -> None:
    """The wheel b is thrown back at 60 degrees: whoever goes on from there does not meet that again."""

    def back(t: float, state: lw.State) -> None:
        state.body("b").omega = -state.body("b").omega

    stop = lw.Event(lambda t, state: state.body("b").orientation[3] - 0.5, "stop", change=back)
    model, other = wheels("ab", ""), wheels("ba", "")
    v = np.zeros((2, 6))
    v[:, 5] = -2.0, 3.0
    hit = run(model.with_initial_state(model.compiled().q0, v), 0.5, rtol=1e-9, events=stop, record_every=1)
    start = hit.snapshot(int(np.flatnonzero(hit.t == hit.events[0].t)[0]))
    for again in (model, other):
        rest = run(again, 0.5, rtol=1e-9, events=stop, start=start)
        assert not rest.events
        assert speeds(rest, "ab") == pytest.approx([-2.0, -3.0])


def test_a_state_of_other_bodies_or_elements_is_refused_by_name() -> None:
    start = run(wheels("ab", "ab"), 1.0, rtol=1e-6).snapshot()
    with pytest.raises(lw.OptionError, match="nothing of the body 'c' of the model, and has the body 'b'"):
        run(wheels("ac", "ac"), 2.0, rtol=1e-6, start=start)
    with pytest.raises(lw.OptionError, match="'spring b' between 'ground' and 'a' of the model"):
        run(wheels("ab", "ab", b="a"), 2.0, rtol=1e-6, start=start)
    with pytest.raises(lw.OptionError, match="has the history variable of .*'spring b'.*, which"):
        run(wheels("ab", "a"), 2.0, rtol=1e-6, start=start)
    assert run(wheels("ab", "ab", b="a"), 2.0, rtol=1e-6, start=start._replace(names=None)).finished
    for names in (3, start.names._replace(bodies=["a"])):
        with pytest.raises(lw.OptionError, match="not those of a state of 2 bodies"):
            run(wheels("ab", "ab"), 2.0, rtol=1e-6, start=start._replace(names=names, resume=None))


def test_a_state_is_linearized_with_the_turns_of_its_elements() -> None:
    """Wound up to where they hold the motors, by 20 and 5 rad."""
    start = run(wheels("ab", "ab"), 400.0, rtol=1e-9).snapshot()
    start = start._replace(v=np.zeros((2, 6)))
    for model in (wheels("ab", "ab"), wheels("ba", "ab"), wheels("ab", "ba")):
        found = lw.linearize(model, start=start).eigenvalues
        assert np.abs(found) == pytest.approx(np.sqrt(0.02 / 0.1), rel=1e-6)
