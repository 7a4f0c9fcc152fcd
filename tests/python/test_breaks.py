"""Steps that follow tolerances end where functions of time are not smooth."""

import itertools
import math
import re
import warnings

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from linkwork import functions
from linkwork.running import breakpoints
from random_mechanisms import examples
from recorded import PAIRS
from scipy.interpolate import CubicSpline, PPoly

MASS = 2.0


def slider(force=0.0, breaks=()) -> lw.Model:
    """A body on a guide along x that a force pushes."""
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("b", mass=MASS, inertia=(1, 1, 1))
    model.translational("ground", body, at=(0, 0, 0), axis=(1, 0, 0), name="guide")
    model.force(body, force=(force, 0, 0), breaks=breaks)
    return model


def driven(**motion) -> lw.Model:
    model = slider()
    model.drive("guide", name="driver", **motion)
    return model


def x_and_v(result: lw.Result) -> np.ndarray:
    return np.array([result.q[-1, 0, 0], result.v[-1, 0, 0]])


def pieces(*knots_and_rows) -> functions.TimeFunction:
    """piecewise_polynomial(t_0, row, t_1, row, ..., t_n)."""
    return functions.piecewise_polynomial(knots_and_rows[::2], _padded(knots_and_rows[1::2]))


def _padded(rows) -> np.ndarray:
    out = np.zeros((len(rows), max(map(len, rows))))
    for k, row in enumerate(rows):
        out[k, : len(row)] = row
    return out


def exact(force: functions.Table, t: float) -> np.ndarray:
    """x and v at t of the body that starts at rest."""
    v = PPoly(force.coefficients.T[::-1], force.breaks).antiderivative()
    return np.array([v.antiderivative()(t), v(t)]) / MASS


def random_force(rng: np.random.Generator, t_end: float) -> functions.Table:
    """Steps, ramps and pulses of 1e-3 s, at rest between them now and then."""
    knots, rows, level = [0.0], [], 0.0
    for t in np.sort(rng.uniform(0.05, t_end - 0.05, 4)):
        kind, size = rng.choice(["step", "ramp", "pulse", "hat"]), rng.uniform(-5, 5)
        if t <= knots[-1]:
            continue
        rows.append([level])
        knots.append(t)
        if kind == "step":
            level = size
        elif kind == "ramp":
            rows.append([level, (size - level) / 0.03])
            knots.append(t + 0.03)
            level = size
        elif kind == "pulse":
            rows.append([level + 1e3 * size])
            knots.append(t + 1e-3)
        else:
            rows += [[level, 1e6 * size], [level + 5e2 * size, -1e6 * size]]
            knots += [t + 5e-4, t + 1e-3]
    if knots[-1] >= t_end:
        return random_force(rng, t_end)
    return functions.piecewise_polynomial([*knots, t_end], _padded([*rows, [level]]))


@pytest.mark.parametrize("pair", PAIRS)
def test_random_steps_ramps_and_pulses_give_the_exact_end(pair: str) -> None:
    rng = np.random.default_rng(PAIRS.index(pair))
    for _ in range(25):
        rtol = 10.0 ** -rng.uniform(5, 9)
        force = random_force(rng, 10.0)
        result = lw.simulate(slider(force), 10.0, rtol=rtol, atol=rtol, integrator=pair)
        wanted = exact(force, 10.0)
        path = np.abs(wanted).max() + 1.0
        assert np.abs(x_and_v(result) - wanted).max() < 10 * rtol * path
        assert set(force.break_points[1:-1]) <= set(_steps_of(force, pair)), "a step ends at each"


def _steps_of(force: functions.Table, pair: str) -> np.ndarray:
    return lw.simulate(slider(force), 10.0, rtol=1e-3, integrator=pair, record_every=1).t


@pytest.mark.parametrize("pair", PAIRS)
def test_random_driven_accelerations_are_followed(pair: str) -> None:
    rng = np.random.default_rng(10 + PAIRS.index(pair))
    for what, _ in itertools.product(("acceleration", "velocity"), range(3)):
        rtol = 10.0 ** -rng.uniform(5, 8)
        given = random_force(rng, 10.0)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            result = lw.simulate(driven(**{what: given}), 10.0, rtol=rtol, atol=rtol, integrator=pair)
        levels = exact(given, 10.0) * MASS if what == "acceleration" else exact(given, 10.0)[1:] * MASS
        wanted = levels if what == "acceleration" else [levels[0], given.evaluate(10.0)[0]]
        assert np.abs(x_and_v(result) - wanted).max() < 10 * rtol * (1 + np.abs(wanted).max())


@pytest.mark.parametrize("pair", PAIRS)
def test_a_short_rise_after_a_long_rest_is_not_leapt_over(pair: str) -> None:
    model = driven(position=functions.cycloidal(1, 0.01, start=0.5))
    result = lw.simulate(model, 1.0, rtol=1e-6, integrator=pair, record_every=1)
    assert result.q[-1, 0, 0] == pytest.approx(1.0, abs=1e-5)
    assert {0.5, 0.5 + 0.01} <= set(result.t)
    assert result.statistics["breaks"] == 2


def bump(t: float, order: int) -> float:
    """A rise by 1 between 0.5 and 0.51 s, smooth up to the second derivative."""
    s = (t - 0.5) / 0.01
    if not 0 < s < 1:
        return float(s >= 1) if order == 0 else 0.0
    rows = ((10, 3), (-15, 4), (6, 5))
    value = sum(c * math.perm(k, order) * s ** (k - order) for c, k in rows)
    return value / 0.01**order


def test_a_driver_that_nobody_declared_is_seen_by_its_violation() -> None:
    rise = tuple(lambda t, order=order: bump(t, order) for order in range(3))
    result = lw.simulate(driven(position=rise), 1.0, rtol=1e-6)
    assert result.q[-1, 0, 0] == pytest.approx(1.0, abs=1e-4)
    assert result.violation[:, 0].max() < 1e-2


# --- tables -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("drives", [True, False])
def test_a_dense_smooth_table_costs_no_step_a_knot(pair: str, drives: bool) -> None:
    t = np.linspace(0, 10, 5001)
    spline = CubicSpline(t, 1 - np.cos(2 * t), bc_type="clamped" if drives else "not-a-knot")
    table = functions.piecewise_polynomial(t, spline.c[::-1].T)
    wave = functions.harmonic(-1.0, 2.0, phase=np.pi / 2, offset=1.0)
    make = (lambda f: driven(position=f)) if drives else slider
    runs = [lw.simulate(make(f), 9.0, rtol=1e-5, integrator=pair) for f in (table, wave)]
    steps, usual = (run.statistics["steps"] for run in runs)
    assert steps <= (3 if drives and pair == "dop853" else 1.2) * usual + 5, "4500 knots"
    assert np.abs(x_and_v(runs[0]) - x_and_v(runs[1])).max() < 1e-3


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("shape", ["pulse", "doublet"])
def test_a_pulse_in_a_dense_table_is_seen(pair: str, shape: str) -> None:
    t = np.linspace(0, 10, 10001)
    values = np.where(np.abs(t - 7.3) < 2.5e-3, 100.0, 0.0)
    if shape == "doublet":
        values *= np.sign(t - 7.3)
    table = functions.table(t, values)
    result = lw.simulate(slider(table), 10.0, rtol=1e-7, integrator=pair)
    wanted = exact(table, 10.0)
    assert np.abs(wanted).max() > 1e-5
    assert np.abs(x_and_v(result) - wanted).max() < 1e-5 * max(np.abs(wanted).max(), 1e-2)


def test_knots_are_breaks_where_a_derivative_up_to_the_second_jumps() -> None:
    spline = functions.table([0, 1, 2.5, 3, 4], [0, 1, 0, 1, 0])
    assert spline.break_points == [0, 4]
    line = pieces(0.0, [0, 1], 1.0, [1, 1], 2.0, [2, -1], 3.0)
    assert line.break_points == [0, 2, 3]
    assert line.integral().break_points == [0, 2, 3]
    assert line.integral().integral().break_points == [0, 3], "continuous up to the second derivative"
    total = functions.with_breaks(lambda t: abs(t - 0.7), [0.7])
    assert total.break_points == [0.7]
    assert functions.cycloidal(1, 2, start=3).break_points == [3, 5]


# --- users' functions ---------------------------------------------------------------------------------------

SIDES = {
    "half open": lambda t: 1e3 if 3.0 <= t < 3.001 else 0.0,
    "open": lambda t: 1e3 if 3.0 < t < 3.001 else 0.0,
    "closed": lambda t: 1e3 if 3.0 <= t <= 3.001 else 0.0,
}


@pytest.mark.parametrize("sides", SIDES)
@pytest.mark.parametrize("where", ["force", "user force", "joint force", "simulate", "with_breaks"])
def test_breaks_of_python_functions(sides: str, where: str) -> None:
    pair = PAIRS[(len(sides) + len(where)) % len(PAIRS)]
    f, breaks, options = SIDES[sides], (3.0, 3.001), {}
    model = slider(f, breaks=breaks) if where == "force" else slider()
    if where == "user force":
        model.user_force(lambda t, q, v: [f(t), 0, 0, 0, 0, 0], "b", breaks=breaks)
    elif where == "joint force":
        model.joint_force("guide", lambda t, x, rate: f(t), breaks=breaks)
    elif where == "simulate":
        model, options = slider(f), {"breaks": breaks}
    elif where == "with_breaks":
        model = slider(functions.with_breaks(f, breaks))
    result = lw.simulate(model, 10.0, rtol=1e-9, integrator=pair, **options)
    v = 1e3 * (3.001 - 3.0) / MASS
    assert np.allclose(x_and_v(result), [v * (10 - 3.0005), v], rtol=1e-8)


def test_breaks_at_the_start_the_end_an_event_and_the_output() -> None:
    f = functions.with_breaks(lambda t: 3.0 if 0 < t < 1.5 else -1.0, [0, 0.5, 1.5, 2.0])
    event = lw.Event(lambda t, state: t - 0.5, name="halfway", change=lambda t, state: None)
    result = lw.simulate(slider(f), 2.0, rtol=1e-8, times=[0.0, 0.5, 1.0, 1.5, 2.0], events=event)
    v = 3.0 * 1.5 / MASS
    assert result.t.tolist() == [0.0, 0.5, 1.0, 1.5, 2.0]
    assert result.v[:, 0, 0] == pytest.approx([0.0, v / 3, 2 * v / 3, v, v - 0.25], abs=1e-9)
    assert [it.t for it in result.events] == pytest.approx([0.5], abs=1e-12)
    after = [3.0, 3.0, 3.0, -1.0, -1.0]
    assert result.acceleration[:, 0, 0] == pytest.approx(np.array(after) / MASS, abs=1e-9)


def test_a_run_that_starts_at_a_break_sees_what_is_after_it() -> None:
    f = functions.with_breaks(lambda t: 1.0 if t <= 1.0 else 4.0, [1.0])
    first = lw.simulate(slider(f), 1.0, rtol=1e-9)
    second = lw.simulate(slider(f), 2.0, rtol=1e-9, start=first.snapshot())
    assert first.v[-1, 0, 0] == pytest.approx(1.0 / MASS, rel=1e-9)
    assert second.v[-1, 0, 0] == pytest.approx(5.0 / MASS, rel=1e-9)
    assert second.acceleration[0, 0, 0] == pytest.approx(4.0 / MASS, rel=1e-9)


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("gap", [1e-6, 1e-9, 1e-12, 1e-15])
def test_breaks_close_together(pair: str, gap: float) -> None:
    f = functions.with_breaks(lambda t: 1.0 / gap if 0.3 <= t < 0.3 + gap else 0.0, [0.3, 0.3 + gap])
    result = lw.simulate(slider(f), 1.0, rtol=1e-8, integrator=pair)
    v = (0.3 + gap - 0.3) / gap / MASS if gap > 1e-14 else result.v[-1, 0, 0]
    assert result.v[-1, 0, 0] == pytest.approx(v, rel=1e-6)
    assert result.violation[:, :2].max() < 1e-9


def test_breaks_that_are_none_are_refused() -> None:
    for breaks in ("soon", [math.nan], [math.inf]):
        with pytest.raises(lw.ModelError, match="breaks"):
            functions.with_breaks(abs, breaks)
        with pytest.raises(lw.OptionError, match="breaks"):
            lw.simulate(slider(), 1.0, rtol=1e-6, breaks=breaks)
    with pytest.raises(lw.ModelError, match="no function of time"):
        slider(1.0, breaks=[1.0])


# --- drivers that jump --------------------------------------------------------------------------------------


@pytest.mark.parametrize("steps", [{"rtol": 1e-6}, {"step": 1e-3}])
def test_a_driver_whose_position_jumps_is_refused(steps) -> None:
    model = driven(position=pieces(0.0, [0.0], 0.4, [0.1], 1.0))
    with pytest.raises(lw.ModelError, match=r"'driver'.*jumps by 0.1 at t = 0.4 s") as caught:
        lw.simulate(model, 1.0, **steps)
    assert caught.value.time == 0.4


@examples(200)
@given(
    start=st.floats(1e-3, 1e3), duration=st.floats(1e-4, 10.0), rise=st.floats(1e-6, 1e6), fall=st.booleans()
)
def test_a_cycloidal_driver_jumps_nowhere(start: float, duration: float, rise: float, fall: bool) -> None:
    """Beside its ends its value is a small difference of numbers."""
    motion = functions.cycloidal(rise, duration, start=start)
    if fall:
        motion = functions.Sum((motion, functions.cycloidal(-rise, duration, start=start + 2 * duration)))
    breakpoints.check_drivers(driven(position=motion), 0.0, start + 5 * duration, adaptive=True)


@pytest.mark.parametrize("jump", [1e-6, 1.0, 1e3])
@pytest.mark.parametrize("at", [1e-2, 0.3, 70.0])
def test_a_jump_of_any_size_is_seen(at: float, jump: float) -> None:
    model = driven(position=pieces(0.0, [0.0, 0.3], at, [0.3 * at + jump, 0.3], 2 * at))
    with pytest.raises(lw.ModelError, match="jumps by"):
        breakpoints.check_drivers(model, 0.0, 2 * at, adaptive=True)


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("stabilization", ["sampled_baumgarte", "projection", "none"])
def test_a_driver_whose_velocity_jumps_strikes(pair: str, stabilization: str) -> None:
    """A cart jerks a hanging rod: m v_c = P, I omega = P l, v_c = V - l omega."""
    V, m, inertia, arm = 0.5, 3.0, 0.4, 0.7
    model = lw.Model(gravity=(0, 0, 0))
    cart = model.body("cart", mass=1.0, inertia=(1, 1, 1))
    rod = model.body("rod", mass=m, inertia=(inertia, inertia, 0.1), position=(0, 0, -arm))
    model.translational("ground", cart, at=(0, 0, 0), axis=(1, 0, 0), name="guide")
    model.revolute(cart, rod, at=(0, 0, 0), axis=(0, 1, 0))
    model.drive("guide", position=pieces(0.0, [0.0], 0.25, [0.0, V], 1.0), name="driver")
    result = lw.simulate(
        model, 0.3, rtol=1e-8, integrator=pair, times=[0, 0.25, 0.3], stabilization=stabilization
    )
    v_c = V * inertia / (inertia + m * arm**2)
    assert result.v[1, 0, 0] == pytest.approx(V, abs=1e-9)
    assert result.v[1, 1, [0, 4]] == pytest.approx([v_c, (V - v_c) / arm], abs=1e-8)
    assert result.statistics["impacts"] == 1
    assert re.search("bodies struck 1 time at 0.25 s, first as the rate of .*'driver'", result.summary())
    assert np.abs(result.energy_error).max() < 1e-7
    assert result.q[-1, 0, 0] == pytest.approx(V * 0.05, abs=1e-7)


def test_fixed_steps_warn_of_an_impact() -> None:
    model = driven(position=pieces(0.0, [0.0], 0.25, [0.0, 0.5], 1.0))
    with pytest.warns(lw.LinkworkWarning, match=r"'driver'.* jumps by 0.5 at t = 0.25 s"):
        lw.simulate(model, 0.5, 1e-3, on_inaccurate="pass")


# --- functions that break at one time up to roundoff --------------------------------------------------------

#: [s], such as a user writes them.
NEARLY = [(0.3, 0.1 + 0.2), (0.1 + 0.2, 0.3), (0.6, 3 * 0.2), (0.7, 0.7 * (1 + 1e-14))]


def stiffening(*times: float) -> lw.Model:
    """A body on springs along x, each of which becomes stiffer at one of these times."""
    model = slider()
    for k, (t, rest) in enumerate(zip(times, (0.2, 0.1), strict=True)):
        stiffness = pieces(-1.0, [10.0], t, [40.0 + 30 * k], 9.0)
        model.translational_spring_damper("ground", "b", at=(0, 0, 0), axis=(1, 0, 0), stiffness=stiffness,
                                          free_displacement=rest, name=f"spring {k}")  # fmt: skip
    return model


def check_of_one_side(result: lw.Result, at: float) -> None:
    """The frames at the break are of motion before it or after it, by forces, energies and readings."""
    x, a = result.position[:, 0, 0], result.acceleration[:, 0, 0]
    springs = [result.force(f"spring {k}") for k in (0, 1)]
    np.testing.assert_allclose(sum(it.force[:, 0] for it in springs), MASS * a, rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(sum(it.potential for it in springs), result.potential_energy, rtol=1e-12)
    assert np.abs(result.energy_error).max() < 1e-9
    (frames,) = np.nonzero(np.abs(result.t - at) < 1e-12)
    assert len(frames)
    for k in frames:
        before, after = (np.array([10, 10]), np.array([40, 70]))
        forces = [-c @ (x[k] - [0.2, 0.1]) for c in (before, after)]
        assert MASS * a[k] == pytest.approx(forces[int(result.work[k] != 0.0)], rel=1e-12)


@pytest.mark.parametrize("times", NEARLY)
def test_functions_that_break_at_one_time_up_to_roundoff_break_together(times: tuple[float, float]) -> None:
    first, last = sorted(times)
    result = lw.simulate(stiffening(*times), 1.0, rtol=1e-10)
    check_of_one_side(result, first)
    assert result.verdict is not None and result.verdict.level == "good"
    assert result.statistics["breaks"] == 1
    inside = [0.1, first, 0.5 * (first + last), last, 0.9]
    listed = lw.simulate(stiffening(*times), 1.0, rtol=1e-10, times=np.unique(inside))
    check_of_one_side(listed, first)
    assert listed.t.tolist() == np.unique(inside).tolist()
    assert np.all(listed.work[1:] > 0.01)


@pytest.mark.parametrize("end", [0.3, 0.1 + 0.2])
@pytest.mark.parametrize("record", [{}, {"record_every": 1}, {"times": [0.3, 0.1 + 0.2, 0.5]}])
def test_runs_end_before_functions_that_break_together_and_go_on_after_them(end: float, record) -> None:
    model = stiffening(0.3, 0.1 + 0.2)
    times = {"times": [t for t in record["times"] if t <= end]} if "times" in record else record
    first = lw.simulate(model, end, rtol=1e-10, **times)
    check_of_one_side(first, end)
    assert np.all(first.work == 0.0)
    times = {"times": [t for t in record["times"] if t >= end]} if "times" in record else record
    rest = lw.simulate(model, 0.5, rtol=1e-10, start=first.snapshot(), **times)
    check_of_one_side(rest, end)
    assert rest.t[0] == end and np.all(rest.work > 0.01)


@pytest.mark.parametrize("times", NEARLY)
def test_drivers_that_jump_at_one_time_up_to_roundoff_strike_together(times: tuple[float, float]) -> None:
    model = slider()
    model.body("c", mass=1, inertia=(1, 1, 1), position=(0, 1, 0))
    model.translational("b", "c", at=(0, 1, 0), axis=(1, 0, 0), name="on it")
    for joint, t in zip(("guide", "on it"), times, strict=True):
        model.drive(joint, velocity=pieces(-1.0, [0.0], t, [1.0], 9.0))
    asked = np.unique([0.2, *times, 0.9])
    run = lw.simulate(model, 1.0, rtol=1e-9, times=asked)
    for result in (run, driven_motion(model, asked)):
        at_rest = result.t < min(times)
        expected = np.where(at_rest[:, None], 0.0, [[1.0, 2.0]])
        np.testing.assert_allclose(result.velocity[:, :, 0], expected, atol=1e-12)
        assert result.violation[:, 1].max() < 1e-12
        assert result.statistics["impacts"] == 1
        np.testing.assert_allclose(
            result.work, np.where(at_rest, 0.0, 3.0), atol=1e-12
        )  # 2 * 1 / 2 + 1 * 4 / 2


def driven_motion(model: lw.Model, times: np.ndarray) -> lw.Result:
    with pytest.warns(lw.LinkworkWarning, match="jumps by 1"):
        return lw.kinematics(model, times)


# --- fixed steps --------------------------------------------------------------------------------------------


def test_fixed_steps_warn_of_a_pulse_that_is_at_the_end_of_one() -> None:
    """It has an impulse of 1 N s, however short it is; breaks that rounding parts have none between them."""

    def pulse(begin: float, end: float) -> lw.Model:
        return slider(lambda t: 1 / (end - begin) if begin <= t < end else 0.0, breaks=[begin, end])

    model = pulse(0.3, 0.3 + 9e-11)
    with pytest.warns(lw.LinkworkWarning, match="force_x: the breaks at t = 0.3 s and 9e-11 s later"):
        left_out = lw.simulate(model, 1.0, 0.1)
    assert x_and_v(left_out)[1] == 0.0
    assert x_and_v(lw.simulate(model, 1.0, rtol=1e-6)) == pytest.approx([0.7 / MASS, 1 / MASS], rel=1e-6)
    by_rounding = slider(lambda t: 1.0, breaks=[0.3, 3 * 0.1])
    members = lw.simulate_many([model, by_rounding], None, 1.0, 0.1, progress=False)
    assert list(members.remarks) == [0] and "9e-11 s later" in members.remarks[0]
    for begin, end in ((1.0, 1.0 + 9e-11), (0.35, 0.35 + 9e-11)):  # after the run; in a step
        with warnings.catch_warnings():
            warnings.filterwarnings("error", "left out")
            lw.simulate(pulse(begin, end), 1.0, 0.1, on_inaccurate="pass")


def test_fixed_steps_say_how_many_contain_breaks() -> None:
    force = pieces(0.0, [0.0], 0.1004, [1.0], 0.1007, [0.0], 0.5, [1.0], 0.6003, [0.0], 2.0)
    result = lw.simulate(slider(force), 1.0, 1e-3, on_inaccurate="pass")
    assert result.verdict is not None and result.verdict.break_points == 2
    assert result.statistics["steps_with_breaks"] == 2
    assert result.manifest["breaks"] == {"count": 4, "steps_with_breaks": 2}
    assert "2 steps contain break points" in result.summary()
    smooth = lw.simulate(slider(functions.harmonic(1, 2)), 1.0, 1e-3)
    assert "steps_with_breaks" not in smooth.statistics
    assert "break points" not in smooth.summary()


#: (step, break, end) [s]: steps end at the break, as they are counted and as it is written.
MET = [(0.1, 0.3, 1.0), (0.1, 0.1 + 0.2, 1.0), (1e-3, 0.3, 0.3), (0.1, 0.3, 0.1 + 0.2), (0.1, 0.1 + 0.2, 0.3),
       (1 / 3, 2 / 3, 1.0), (0.07, 0.21, 0.5), (0.3, 0.9, 0.9 + 1e-16), (0.4, 0.5, 0.5)]  # fmt: skip


@pytest.mark.parametrize(("step", "at", "end"), MET)
@pytest.mark.parametrize("integrator", ["rk4", "heun", "rk3", "ab4", "abm4", "hem4"])
def test_fixed_steps_that_end_at_a_break_see_each_its_own_side(integrator, step, at, end) -> None:
    """A force that is constant on both sides: the methods are exact."""
    for force in (lambda t: 1.0 if t < at else -4.0, lambda t: 1.0 if t <= at else -4.0):
        result = lw.simulate(slider(force, breaks=[at]), end, step, integrator)
        after = max(end - at, 0.0)
        assert x_and_v(result) == pytest.approx(
            [(0.5 * end**2 - 2.5 * after**2) / MASS, (end - 5.0 * after) / MASS], abs=1e-13
        )
        accelerations = np.where(result.t < min(at, result.t[-1]) - 1e-9, 1.0, -4.0) / MASS
        if abs(end - at) < 1e-9:
            accelerations[-1] = 1.0 / MASS
        np.testing.assert_allclose(result.acceleration[:, 0, 0], accelerations, rtol=1e-12)
        assert result.verdict is not None and result.verdict.break_points == 0
        assert result.verdict.error < 1e-6


def test_fixed_steps_keep_their_order_over_steps_ramps_and_pulses_between_them() -> None:
    rng = np.random.default_rng(7)
    for _ in range(10):
        force = random_force(rng, 2.0)
        knots = np.round(np.asarray(force.breaks) / 1e-3) * 1e-3
        if np.any(np.diff(knots) < 0.5e-3):
            continue
        force = functions.piecewise_polynomial(knots, force.coefficients)
        result = lw.simulate(slider(force), 2.0, 1e-3)
        np.testing.assert_allclose(x_and_v(result), exact(force, 2.0), rtol=1e-10, atol=1e-10)


@pytest.mark.parametrize("step", [0.1, 0.05, 0.1 / 3])
@pytest.mark.parametrize("times", NEARLY[:2])
def test_fixed_steps_go_over_functions_that_break_together(step: float, times: tuple[float, float]) -> None:
    result = lw.simulate(stiffening(*times), 1.0, step / 100)
    check_of_one_side(result, times[0])
    assert np.all(result.work[result.t > 0.3 + 1e-9] > 0.01)


@pytest.mark.parametrize("end", [0.3, 0.1 + 0.2])
@pytest.mark.parametrize("integrator", ["rk4", "ab4"])
def test_fixed_steps_end_before_a_break_and_go_on_after_it(integrator: str, end: float) -> None:
    model = stiffening(0.3, 0.1 + 0.2)
    first = lw.simulate(model, end, 1e-3, integrator)
    check_of_one_side(first, end)
    assert np.all(first.work == 0.0)
    rest = lw.simulate(model, 0.5, 1e-3, integrator, start=first.snapshot())
    check_of_one_side(rest, end)
    assert rest.t[0] == end and np.all(rest.work > 0.01)
    whole = lw.simulate(model, 0.5, 1e-3, integrator)
    assert rest.q[-1].tolist() == whole.q[-1].tolist() and rest.work[-1] == whole.work[-1]


@pytest.mark.parametrize("integrator", ["rk4", "heun"])
def test_a_verdict_knows_the_break_at_which_a_run_begins(integrator: str) -> None:
    force = lambda t: 100.0 if t <= 0.3 else 1.0  # noqa: E731
    model = slider(force, breaks=[0.3])
    first = lw.simulate(model, 0.3, 1e-2, integrator)
    for start in (first.snapshot(), first.snapshot()._replace(resume=None)):
        rest = lw.simulate(model, 1.0, 1e-2, integrator, start=start)
        assert rest.v[-1, 0, 0] == pytest.approx((30.0 + 0.7) / MASS, rel=1e-12)
        assert rest.verdict is not None and rest.verdict.error < 1e-6


@pytest.mark.parametrize("step", [104, 276, 392])
def test_a_step_over_a_break_does_not_stand_for_those_beside_it(step: int) -> None:
    model, h = lw.Model(gravity=(0, 0, -9.81)), 1e-3
    rod = model.body("rod", mass=1, inertia=(0.1, 0.1, 0.02), position=(0.5, 0, 0))
    model.revolute("ground", rod, at=(0, 0, 0), axis=(0, 1, 0))
    model.force(rod, force=(pieces(-1, [2.0], (step + 0.35) * h, [0.0], 99), 0, 0))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        run = lw.simulate(model, 1.0, h, "rk4", record_every=10)
    exact = lw.simulate(model, run.t[-1], times=run.t, integrator="dop853", rtol=1e-11, atol=1e-13)
    error = np.abs(run.velocity - exact.velocity).max() / np.abs(exact.velocity).max()
    assert error > 1e-6
    assert error < run.verdict.error < 30 * error


def test_of_many_breaks_at_which_steps_end_verdicts_leave_nothing_out() -> None:
    count, h = 2000, 1e-3
    rows = [[(-1.0) ** k] for k in range(count)]
    force = functions.piecewise_polynomial(h * np.arange(count + 1), rows)
    run = lw.simulate(slider(force), count * h, h, "rk4")
    np.testing.assert_allclose(x_and_v(run), exact(force, count * h), rtol=1e-12, atol=1e-15)
    assert run.verdict.error < 1e-8


def test_a_blow_of_one_function_is_seen_beside_the_noise_of_another() -> None:
    t_end, h, blow = 5.0, 1e-2, (3.2011, 3.2041)
    knots = np.arange(0.0, t_end + 0.1, 0.0037)
    values = np.random.default_rng(1).uniform(-1e-6, 1e-6, (len(knots) - 1, 1))
    model = slider(functions.piecewise_polynomial(knots, values))
    model.force("b", force=(pieces(-1.0, [0.0], blow[0], [100.0], blow[1], [0.0], t_end + 1), 0, 0))
    run = lw.simulate(model, t_end, h, on_inaccurate="pass")
    given = 100.0 * (blow[1] - blow[0]) / MASS
    error = given / np.abs(run.velocity).max()
    assert error > 1e5, "it falls between the stages of a step"
    assert run.verdict is not None and error < run.verdict.error < 100 * error


def test_the_second_run_of_contacts_ends_steps_at_the_breaks_of_the_first() -> None:
    """A ball that lies softly; a push along the plane, which errors of the contact do not change."""
    model, at = lw.Model(gravity=(0, 0, -9.81)), 0.302
    center = (0, 0, 0.10001)
    ball = model.body("ball", mass=1, inertia=(0.01,) * 3, position=center, velocity=(1, 0, 0))
    model.sphere_plane_contact("ground", ball, at=((0, 0, 0), center), normal=(0, 0, 1), radius=0.1,
                               stiffness=200.0, exponent=1.0, hysteresis=0.01)  # fmt: skip
    model.force(ball, force=(pieces(-1, [0.0], at, [200.0], at + 0.053, [0.0], 9), 0, 0))
    run = lw.simulate(model, 0.5, 1e-3, "rk4", verify=True, on_inaccurate="pass")
    exact = lw.simulate(model, run.t[-1], times=run.t, rtol=1e-11, atol=1e-13)
    along = np.abs(run.velocity - exact.velocity)[:, 0, 0].max()
    assert along < 1e-9
    assert np.nanmax(run.error_of("velocity")[:, 0, 0]) < 1e-6


@pytest.mark.parametrize("integrator", ["rk4", "ab4"])
def test_a_run_that_goes_on_inside_a_step_answers_for_the_whole_of_it(integrator: str) -> None:
    force, at = (lambda t: 100.0 if t <= 2.003 else -50.0), 2.003
    model = slider(force, breaks=[at])
    first = lw.simulate(model, at, 1e-2, integrator, on_inaccurate="pass")
    rest = lw.simulate(model, 4.0, 1e-2, integrator, start=first.snapshot(), on_inaccurate="pass")
    exactly = (100.0 * at - 50.0 * (4.0 - at)) / MASS
    error = abs(rest.v[-1, 0, 0] - exactly) / 100.0
    assert error > 1e-4, "the step from 2 to 2.01 goes over the break"
    assert rest.verdict.error > error


def test_a_run_that_goes_back_to_the_constraints_at_a_break_sees_what_is_after_it() -> None:
    model = lw.Model(gravity=(0, 0, -9.81))
    upper = model.body("upper", mass=1.0, inertia=(0.1, 0.1, 0.02), position=(0.5, 0, 0))
    lower = model.body("lower", mass=0.7, inertia=(0.1, 0.1, 0.02), position=(1.5, 0, 0))
    model.revolute("ground", upper, at=(0, 0, 0), axis=(0, 1, 0))
    model.revolute(upper, lower, at=(1, 0, 0), axis=(0, 1, 0))
    model.force(lower, force=(lambda t: 5.0 if t <= 0.5 else -20.0, 0, 0), breaks=[0.5])
    back = lw.simulate(model, 0.6, 1e-3, "abm4", violation_limit=1e-13, on_violation="project")
    best = lw.simulate(model, 0.6, rtol=1e-11, times=[0.5, 0.6])
    np.testing.assert_allclose(back.v[-1], best.v[-1], atol=1e-6)
    np.testing.assert_allclose(back.acceleration[500], best.acceleration[0], atol=1e-5)


def test_steps_counted_from_elsewhere_end_at_breaks_as_well() -> None:
    model = stiffening(0.30037, 0.30037)
    first = lw.simulate(model, 0.10037, 1e-3)
    rest = lw.simulate(model, 0.5, 1e-3, start=lw.Snapshot(0.10037, first.q[-1], first.v[-1]))
    check_of_one_side(rest, 0.30037)
    assert "steps_with_breaks" not in rest.statistics
    again = lw.simulate(model, 0.5, 1e-3, start=first.snapshot(), on_inaccurate="pass")
    assert (
        again.manifest["resumed"] and again.statistics["steps_with_breaks"] == 1
    ), "as it began, at 0.3 and 0.301"


@pytest.mark.parametrize("pair", PAIRS)
def test_the_end_of_a_stop_that_jumps_into_what_moves_takes_effect_at_once(pair: str) -> None:
    """A rotor is 0.1 rad beyond it at 0.05 s then: vibration with k / J."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("rotor", mass=2.0, inertia=(0.3, 0.3, 0.4), omega=(0, 0, 3.0))
    model.revolute("ground", "rotor", at=(0, 0, 0), axis=(0, 0, 1), name="hinge")
    end = functions.piecewise_polynomial([-1.0, 0.05, 9.0], [[2.0], [0.05]])
    place = {"at": (0, 0, 0), "axis": (0, 0, 1)}
    model.rotational_stop("ground", "rotor", **place, lower=-1.0, upper=end, stiffness=30.0)
    result = lw.simulate(model, 0.3, rtol=1e-8, integrator=pair, progress=False)
    rate = math.sqrt(30.0 / 0.4)
    exact = 0.05 + 0.1 * math.cos(rate * 0.25) + 3.0 / rate * math.sin(rate * 0.25)
    assert result.coordinate("hinge").value[-1] == pytest.approx(exact, rel=1e-6)
    assert np.abs(result.energy_error).max() < 1e-6
