"""What makes no sense is refused at every door, by an error of our own that says what to do."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import _core, mechanisms
from linkwork.equations.stiffness import GROWTH
from linkwork.integrators import METHODS
from linkwork.running import forecast
from small_mechanisms import slider_crank_at


def run(t_end: float = 0.1, step: float | None = 1e-2, **options: Any) -> lw.Result:
    return lw.simulate(mechanisms.pendulum(), t_end, step, progress=False, **options)


# --- System -------------------------------------------------------------------------------------------------

NOT_MOMENTS: dict[str, tuple[Any, Any, Any]] = {
    "t is text": ("a", None, None),
    "t is None": (None, ..., ...),
    "t is nan": (np.nan, None, None),
    "t is infinite": (np.inf, None, None),
    "t is many": ([0.0, 1.0], None, None),
    "q is text": (0.0, "q", None),
    "q is ragged": (0.0, [[1.0], [1.0, 2.0]], None),
    "q is short": (0.0, np.zeros(3), None),
    "q is turned": (0.0, np.zeros((7, 1)), None),
    "q is nan": (0.0, np.full((1, 7), np.nan), None),
    "v is complex": (0.0, None, np.zeros(6) + 1j),
    "v is infinite": (0.0, None, np.full((1, 6), np.inf)),
    "v is an object": (0.0, None, object()),
}


@pytest.mark.parametrize("which", NOT_MOMENTS)
def test_a_system_is_evaluated_at_moments_only(which: str) -> None:
    system = lw.System(mechanisms.pendulum())
    core = system.model.compiled()
    t, q, v = NOT_MOMENTS[which]
    t = None if t is None and q is ... else t
    q = core.q0 if q is None or q is ... else q
    v = core.v0 if v is None or v is ... else v
    for evaluate in (system.evaluate, system.accelerations):
        with pytest.raises((lw.OptionError, lw.NotFiniteError)):
            evaluate(t, q, v)
    if which.startswith("t"):
        with pytest.raises(lw.OptionError):
            system.derivative(t, system.initial_state())
    with pytest.raises((lw.OptionError, lw.NotFiniteError)):
        system.derivative(0.0, np.nan * system.initial_state())


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_history_goes_on_from_finite_states_only(value: float) -> None:
    model = mechanisms.rod_pendulum()
    model.rotational_spring_damper("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0), stiffness=1.0)
    system = lw.System(model)
    y = system.initial_state()
    with pytest.raises(lw.OptionError, match=f"t = {value} is not finite"):
        system.advance_history(value, y)
    with pytest.raises(lw.NotFiniteError, match="body 'rod': its state in q and v") as caught:
        system.advance_history(0.0, np.where(np.arange(13) == 9, value, y))
    assert caught.value.bodies == ["rod"]
    with pytest.raises(lw.NotFiniteError, match="history"):
        system.advance_history(0.0, 0.0 * y)
    for ask in (system.advance_history, system.derivative):
        with pytest.raises(lw.OptionError, match="history .* is not finite"):
            ask(0.0, y, [value])


def test_a_pose_by_bodies_and_one_in_a_row_are_the_same() -> None:
    system = lw.System(mechanisms.four_bar())
    core = system.model.compiled()
    rows = system.accelerations(0, core.q0, core.v0)[0]
    bodies = system.accelerations(np.float32(0), core.q0.reshape(-1, 7), core.v0.reshape(-1, 6))[0]
    assert np.array_equal(rows, bodies)


# --- options at the compiled door ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("option", "value"),
    [
        ("on_singular", "halt"), ("on_violation", ""), ("matrix_form", "kk"), ("formulation", "x"),
        ("stabilization", "x"), ("linear_solver", "x"), ("tolerance", 0.0), ("tolerance", np.nan),
        ("max_iterations", 0), ("penalty", -1.0), ("baumgarte_alpha", np.nan), ("baumgarte_beta", -1.0),
        ("penalty_scale", np.inf), ("violation_limit", [np.nan, 1.0, 1.0]),
        ("violation_limit", [1.0, -1.0, 1.0]),
    ],
)  # fmt: skip
def test_the_compiled_module_takes_no_option_that_it_does_not_know(option: str, value: Any) -> None:
    options = _core.Options()
    setattr(options, option, value)
    with pytest.raises(lw.OptionError):
        _core.Dynamics(mechanisms.pendulum().compiled(), options)


def test_kkt_without_a_solver_is_solved_by_blocks_with_redundant_equations_too() -> None:
    redundant = mechanisms.bricard()
    kkt, usual = (lw.System(redundant, **options) for options in ({"matrix_form": "kkt"}, {}))
    assert kkt.options["linear_solver"] == "block"
    y = usual.initial_state()
    assert np.abs(kkt.derivative(0.0, y) - usual.derivative(0.0, y)).max() < 1e-9


# --- steps --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("step", [0.11, 1e11])
def test_a_step_longer_than_the_run_is_refused(step: float) -> None:
    with pytest.raises(lw.OptionError, match=r"longer than the run, from 0 to 0.1 s: give a step of 0.1 s"):
        run(0.1, step)


def test_a_run_goes_on_for_less_than_a_step() -> None:
    first = run(0.1, 4e-3)
    np.testing.assert_array_equal(run(0.103, 4e-3, start=first.snapshot()).q[-1], run(0.103, 4e-3).q[-1])


def test_a_step_of_the_whole_run_and_a_largest_step_beyond_it_are_no_mistakes() -> None:
    assert len(run(0.01, 0.01).t) == 2
    assert len(run(0.1 + 0.2, 0.3, on_inaccurate="pass").t) == 2  # 0.30000000000000004
    assert run(0.1, 1e11, rtol=1e-6).finished
    assert run(0.0, 1e-3).finished


def test_a_run_of_months_is_refused_before_its_first_step() -> None:
    began = time.perf_counter()
    for options in ({"step": 1e-12}, {"step": 1e-13, "rtol": 1e-6}):
        with pytest.raises(
            lw.OptionError, match=r"takes 1e\+1[34] steps, about \S+ (days|years) on this machine: give"
        ):
            run(10.0, **options)
    assert time.perf_counter() - began < 5.0


def test_a_run_of_hours_is_told_and_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(forecast, "LEAST_SECONDS", 1.0)
    monkeypatch.setattr(forecast, "_evaluation_seconds", lambda system, start: 720.0)
    with pytest.warns(lw.LinkworkWarning, match=r"the run takes 10 steps, about 8 hours on this machine"):
        assert run(0.1, 1e-2).finished
    monkeypatch.setattr(forecast, "_evaluation_seconds", lambda system, start: 1.0)
    run(0.1, 1e-2)


# --- starts and frames --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "change",
    [
        {"t": np.nan}, {"t": "now"}, {"t": None}, {"t": np.inf}, {"q": "q"}, {"q": [[1], [2, 3]]},
        {"v": None}, {"q": np.zeros((7, 1))}, {"v": np.full((1, 6), np.inf)}, {"t": 5.0},
        {"history": "x"}, {"history": 3},
        {"history": (np.nan,)},
    ],
    ids=str,
)  # fmt: skip
def test_a_start_that_is_no_state_is_refused(change: dict[str, Any]) -> None:
    start = run().snapshot()._replace(**change)
    with pytest.raises(lw.OptionError, match="start"):
        run(1.0, start=start)


@pytest.mark.parametrize("frame", [1000, -12, "last", 1.0, None, [1]])
def test_a_frame_that_is_not_there_is_refused(frame: Any) -> None:
    with pytest.raises(lw.OptionError, match="none of the 11 of this result"):
        run().snapshot(frame)


@pytest.mark.parametrize(
    "ask",
    [
        lambda result: result.recorded("nix"),
        lambda result: result.recorded(3),
        lambda result: result.sampled_positions(0),
        lambda result: result.sampled_positions("x"),
        lambda result: result.recorded_of("q", [5]),
        lambda result: result.recorded_of("q", [0.5]),
        lambda result: result.recorded_of("q", [True]),
        lambda result: result.view(other=3),
        lambda result: result.view(labels=["a", "b"]),
        lambda result: result.sampled_reactions(-1),
        lambda result: result.body(None),
        lambda result: result.body(7),
        lambda result: result.body([1]),
        lambda result: result.reaction(1.5),
        lambda result: result.reaction(0, frame=3),
        lambda result: result.coordinate("nix"),
        lambda result: result.coordinate(0, which=3),
        lambda result: result.joint_axes(-5),
        lambda result: result.joint_points("x"),
        lambda result: result.index("joint", "x"),
        lambda result: result.index("nix", "x"),
        lambda result: result.plot(kind="nix"),
        lambda result: result.plot(bodies=["nix"]),
        lambda result: result.plot(joints=3),
    ],
)
def test_what_a_result_does_not_have_is_refused(ask: Callable[[lw.Result], Any]) -> None:
    with pytest.raises(lw.LinkworkError):
        ask(run())


# --- functions of the user's own ----------------------------------------------------------------------------


#: From which numbers could be made, with a part or a unit lost.
NOT_REAL = [
    np.complex128(1 + 2j),
    np.complex64(1),
    np.array(1j),
    np.timedelta64(1, "s"),
    np.datetime64(1, "s"),
]


@pytest.mark.parametrize("given", ["much", None, (1.0, 2.0), "1.5", ..., b"1", [1.0], *NOT_REAL], ids=repr)
def test_a_function_of_time_that_returns_no_number_is_named(given: Any) -> None:
    model = mechanisms.rod_pendulum()
    model.force("rod", force=(lambda t: given if t > 0 else 1.0, 0, 0), name="push")
    with pytest.raises(
        lw.ModelError, match=r"applied 'push': force_x: returned .* at t = 0.005 s, not a number"
    ):
        lw.simulate(model, 0.1, 1e-2, progress=False)


@pytest.mark.parametrize(
    "given",
    ["much", None, 3.0, np.zeros(6), np.zeros((2, 6)), [[1], [2, 3]], [["a"] * 6], [["1"] * 6]]
    + [np.full(shape, it) for it in NOT_REAL for shape in (6, (1, 6))],
)
@pytest.mark.parametrize("bodies", [None, ["rod"], "rod"])
def test_a_user_force_that_returns_no_forces_is_named(given: Any, bodies: Any) -> None:
    if bodies == "rod" and isinstance(given, np.ndarray) and given.shape == (6,):
        given = np.full(6, 1j) if given.dtype.kind == "f" else given  # floats are what one body takes
    model = mechanisms.rod_pendulum()
    model.user_force(lambda t, q, v: given, bodies, name="wind")
    with pytest.raises(lw.ModelError, match="user force 'wind'"):
        lw.simulate(model, 0.1, 1e-2, progress=False)


@pytest.mark.parametrize("given", [np.complex128(1 + 2j), np.complex64(1), np.timedelta64(1, "s")])
def test_a_joint_force_is_a_real_number(given: Any) -> None:
    for law in (given, lambda t, x, rate: given):
        model = lw.Model()
        body = model.body("body", mass=1.0, inertia=(1, 1, 1))
        model.translational("ground", body, at=(0, 0, 0), axis=(1, 0, 0), name="slide")
        with pytest.raises(lw.ModelError, match="joint force 'joint force 1'.*not a.* number"):
            model.joint_force("slide", law)
            lw.simulate(model, 0.1, 1e-2, progress=False)


@pytest.mark.parametrize("bodies", ["rod", None])
def test_masked_forces_on_a_body_are_none(bodies: Any) -> None:
    model = mechanisms.rod_pendulum()
    model.user_force(
        lambda t, q, v: np.ma.array(v, mask=np.zeros_like(v) + np.arange(6) > 3), bodies, name="wind"
    )
    with pytest.raises(lw.NotFiniteError, match="force 'wind'"):
        lw.simulate(model, 0.1, 1e-2, progress=False)


# --- runs that fail -----------------------------------------------------------------------------------------


def torn(stiffness: float) -> lw.Model:
    """A four-bar whose bodies are held where they are by forces that nobody looks at before the run."""
    model = mechanisms.four_bar()
    home = model.compiled().q0.reshape(-1, 7)[:, :3].copy()

    def hold(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        out = np.zeros_like(v)
        out[:, :3] = -stiffness * (q[:, :3] - home)
        return out

    model.user_force(hold)
    return model


@pytest.mark.parametrize("integrator", ["euler", "heun", "rk4", "ab4"])
@pytest.mark.parametrize("stiffness", [1e5, 1e6, 1e9])
def test_a_run_that_diverges_is_told_as_such(integrator: str, stiffness: float) -> None:
    with pytest.raises(lw.NotFiniteError, match="diverged") as found:
        lw.simulate(torn(stiffness), 5.0, 1e-2, integrator, progress=False)
    assert found.value.bodies and found.value.state is not None


@pytest.mark.parametrize("integrator", ["hem4", "phem56"])
def test_a_half_explicit_stage_that_turns_too_far_says_what_may_be_behind_it(integrator: str) -> None:
    with pytest.raises(lw.NotConvergedError, match="too long for the motion, or for stiff force elements"):
        lw.simulate(torn(1e7), 5.0, 1e-2, integrator, progress=False)


@pytest.mark.parametrize("integrator", ["hem4", "phem56"])
@pytest.mark.parametrize("damping", [0.0, 2e4])
def test_half_explicit_steps_have_limits_too(integrator: str, damping: float) -> None:
    """1 kg on 1e6 N/m in a slide: refused beyond the limit of the method's growth, stable below it."""
    model = lw.Model()
    model.body("mass", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 0, 1.001))
    model.translational("ground", "mass", at=(0, 0, 1.0), axis=(0, 0, 1))
    model.spring_damper(
        "ground", "mass", at=((0, 0, 0), (0, 0, 1.001)), stiffness=1e6, damping=damping, free_length=1.0
    )
    eigenvalue = max(np.roots([1.0, damping, 1e6]), key=abs)
    limit = lw_limit(integrator, eigenvalue)
    with pytest.raises(lw.OptionError, match=rf"'{integrator}': force elements make body 'mass'"):
        lw.simulate(model, 1.0, 1.1 * limit, integrator, progress=False)
    result = lw.simulate(model, 200 * limit, 0.97 * limit, integrator, progress=False, on_inaccurate="pass")
    assert np.abs(result.position[:, 0, 2] - 1.0).max() < 1.1e-3 * GROWTH ** (200 / 0.97)


def lw_limit(integrator: str, eigenvalue: complex) -> float:
    """The step at which the numerical solution of y' = lambda y begins to grow, from the method's own run."""
    growth, low, high = METHODS[integrator].growth, 0.0, 10.0 / abs(eigenvalue)
    for _ in range(60):
        middle = (low + high) / 2
        z = eigenvalue * middle
        real = abs(z.imag) < 1e-6 * abs(z)
        grows = (growth(-z.real / 2, 0.0) if real else growth(-z.real, abs(z))) > GROWTH
        low, high = (low, middle) if grows else (middle, high)
    return low


# --- kinematics ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("way", [(0.0, 0.1), (0.0, -0.1), (0.0, 0.0, -0.1), (0.0, 0.0, 0.0, -1.0)])
def test_a_slider_cannot_be_driven_from_its_dead_center(way: tuple[float, ...]) -> None:
    """The crank could go either way, or neither."""
    model = slider_crank_at(0.0)
    model.drive("guide", position=lw.functions.polynomial(*way))
    with pytest.raises(lw.NotConvergedError, match="beyond t = 0 s .*begin in a pose beside it") as found:
        lw.kinematics(model, np.linspace(0, 0.5, 11), on_singular="pass")
    assert found.value.code == "dead_point" and found.value.joints


def test_beside_its_dead_center_it_can() -> None:
    model = slider_crank_at(0.1)
    model.drive("guide", position=lw.functions.polynomial(0.0, 0.0, -0.1))
    motion = lw.kinematics(model, np.linspace(0, 0.5, 11), on_singular="stop")
    assert motion.coordinate("guide").value[-1] == pytest.approx(-0.025, abs=1e-9)


# --- what is no argument ------------------------------------------------------------------------------------

FOUR_BAR = mechanisms.four_bar()

NO_ARGUMENTS: dict[str, Callable[[], object]] = {
    "a complex stiffness": lambda: lw.mechanisms.rod_pendulum().rotational_spring_damper(
        "ground", "rod", at=(0, 0, 0), axis=(0, 1, 0), stiffness=np.complex128(1 + 1j)
    ),
    "a complex place": lambda: lw.mechanisms.rod_pendulum().spherical(
        "ground", "rod", at=(np.complex128(1j), 0, 0)
    ),
    "a complex step": lambda: run(step=np.complex128(1e-2 + 1j)),  # type: ignore[arg-type]
    "a complex constant": lambda: lw.functions.constant(np.complex128(1j)),  # type: ignore[arg-type]
    "complex breaks": lambda: lw.functions.with_breaks(lambda t: 0.0, [np.complex128(1j)]),
    "a place in milliseconds": lambda: lw.Model().body(
        mass=1.0, inertia=(1, 1, 1), position=np.ones(3, "m8[ms]")
    ),
    "assemble, no bodies": lambda: lw.assemble(lw.Model()),
    "linearize, near is text": lambda: lw.linearize(FOUR_BAR, near="x"),  # type: ignore[arg-type]
    "linearize, start is text": lambda: lw.linearize(FOUR_BAR, start="x"),  # type: ignore[arg-type]
    "linearize, another's start": lambda: lw.linearize(
        mechanisms.pendulum(), start=lw.Snapshot(0.0, np.zeros((3, 7)), np.zeros((3, 6)))
    ),
    "equilibrium, stable is empty": lambda: lw.equilibrium(FOUR_BAR, stable=np.array([])),  # type: ignore[arg-type]
    "inverse dynamics, drivers are a number": lambda: lw.inverse_dynamics(FOUR_BAR, [0.0], drivers=1.0),  # type: ignore[arg-type]
    "history, y is text": lambda: lw.System(FOUR_BAR).advance_history(0.0, ("x",)),
    "initial state, history is text": lambda: FOUR_BAR.with_initial_state(
        FOUR_BAR.compiled().q0, FOUR_BAR.compiled().v0, ("x",)
    ),
    "replaced, a list": lambda: FOUR_BAR.replaced(np.array([])),  # type: ignore[arg-type]
    "half a character of a body": lambda: FOUR_BAR.find("\ud800"),
    "half a character of a joint": lambda: FOUR_BAR.drive("\ud800", position=0.0),
    "bodies without a length": lambda: FOUR_BAR.shape(np.array("x")),  # type: ignore[arg-type]
    "names without a length": lambda: run().to_frame(quantities=np.array("x")),  # type: ignore[arg-type]
    "joints, names without a length": lambda: FOUR_BAR.joints(
        "spherical",
        "ground",
        "rocker",
        at=(0, 0, 0),
        name=np.array("x"),  # type: ignore[arg-type]
    ),
    "a point without a length": lambda: FOUR_BAR.distance("ground", "rocker", at=np.array("x")),
    "inertia as it is, or not": lambda: lw.Model().body(mass=1.0, inertia=(1, 1, 1), inertia_as_is=[]),  # type: ignore[arg-type]
    "a folder with a long name": lambda: lw.import_urdf("arm.urdf", search_path="b" * 5000),
    "a builder without a signature": lambda: lw.sweep(int, {"x": [1]}, ["final"], t_end=0.1),  # type: ignore[arg-type]
}


@pytest.mark.parametrize("which", NO_ARGUMENTS)
def test_what_is_no_argument_is_an_error_of_linkwork(which: str) -> None:
    with pytest.raises(lw.LinkworkError):
        NO_ARGUMENTS[which]()


def hinged() -> lw.Model:
    model = lw.Model()
    body = model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
    model.revolute("ground", body, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    return model


WORDS: dict[str, tuple[Callable[[], object], str]] = {
    "a law of one joint that takes too little": (
        lambda: hinged().joint_force("pin", lambda t, x: 0.0, name="controller 7"),  # type: ignore[misc, arg-type]
        r"joint force 'controller 7': its function does not take \(t, x, x_dot\)",
    ),
    "a force that takes too little": (
        lambda: hinged().user_force(lambda t: np.zeros(6), "rod", name="wind"),
        r"user force 'wind': its function does not take \(t, q, v\)",
    ),
    "two functions": (
        lambda: hinged().drive("pin", velocity=(lambda t: 1.0, lambda t: 0.0)),
        r"velocity: 2 functions in a tuple: give one, or three \(f, df, ddf\)",
    ),
    "ends without an order": (
        lambda: hinged().distance("ground", "rod", at={(0, 0, 1), (1, 0, 0)}),
        "at must be a pair",
    ),
    "a folder that is True": (
        lambda: lw.compare(hinged(), 0.02, steps=[1e-2], integrators=["rk4"], resume=True),  # type: ignore[arg-type]
        "resume True is no path",
    ),
    "a step beyond all numbers": (
        lambda: lw.sensitivity(lambda x: hinged(), {"x": 1.0}, {"t": len}, steps=10**400),
        "sensitivity: steps 1000.* is not a finite number",
    ),
    "times beyond all numbers": (
        lambda: lw.sweep(hinged(), {"rod.mass": [1.0]}, ["final"], t_end=0.1, times=10**400, step=0.01),
        "times 1000.* are no numbers",
    ),
    "a rod with a side in words": (lambda: lw.mechanisms.square_rod(1, 1, "a"), "square_rod: side 'a'"),  # type: ignore[arg-type]
    "a rod of negative mass": (lambda: lw.mechanisms.thin_rod(-1, 1), "thin_rod: mass -1 .* at least 0"),
    "strokes beyond reach": (
        lambda: lw.mechanisms.stewart_platform(amplitude=0.7),
        "amplitude 0.7 is out of its bounds: from -0.63 to 0.63",
    ),
    "an angle in words": (lambda: lw.rotation.about((0, 0, 1), "90"), "rotation.about: angle '90' is not"),
    "an axis in words": (lambda: lw.rotation.about("z", 1.0), "rotation.about: axis 'z' is not"),
    "a restitution in words": (
        lambda: lw.contact_hysteresis("flores", "0.5"),  # type: ignore[arg-type]
        "restitution '0.5' is not a finite number",
    ),
    "a name in capitals": (lambda: run(integrator="RK4"), "the nearest is 'rk4'"),
}


@pytest.mark.parametrize("which", WORDS)
def test_what_is_wrong_with_an_argument_is_told(which: str) -> None:
    wrong, words = WORDS[which]
    with pytest.raises(lw.LinkworkError, match=words):
        wrong()
