"""Redundant equations are judged all along a run."""

import warnings

import linkwork as lw
import numpy as np
import pytest
from linkwork import functions

#: Every way to run, by name.
WAYS = {
    "rk4": {"step": 1e-3},
    "dopri5": {"rtol": 1e-6},
    "dop853": {"rtol": 1e-9, "integrator": "dop853"},
    "bs32": {"rtol": 1e-5, "integrator": "bs32"},
    "tsit5": {"rtol": 1e-7, "integrator": "tsit5"},
    "abm4": {"step": 1e-3, "integrator": "abm4"},
    "hem4": {"step": 1e-3, "integrator": "hem4"},
    "euler": {"step": 1e-3, "integrator": "euler", "on_inaccurate": "pass"},
    "schur": {"step": 1e-3, "matrix_form": "schur"},
    "penalty": {"step": 1e-3, "formulation": "penalty"},
    "augmented_lagrangian": {"step": 1e-3, "formulation": "augmented_lagrangian"},
    "projection": {"step": 1e-3, "stabilization": "projection"},
    "none": {"step": 1e-3, "stabilization": "none"},
}


def twice_driven(second: functions.TimeFunction, size: float = 1.0) -> lw.Model:
    """A slide that `first` drives to 1 and back, and `second` likewise; lengths times `size`."""
    model = lw.Model(gravity=(0, 0, 0))
    slide = model.body("slide", mass=2.0, inertia=(1, 1, 1))
    rod = model.body("rod", mass=1.0, inertia=(size**2, size**2, size**2), position=(0, 0, -size))
    guide = model.translational("ground", slide, at=(0, 0, 0), axis=(1, 0, 0), name="guide")
    model.revolute(slide, rod, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    model.drive(guide, position=functions.expression(f"{size} * t**2 * (1 - t)**2"), name="first")
    model.drive(guide, position=second, name="second")
    return model


@pytest.mark.parametrize("way", WAYS)
def test_drivers_that_agree_at_both_ends_and_part_between_are_an_error(way: str) -> None:
    other = functions.expression("2 * t**2 * (1 - t)**2")
    with pytest.raises(lw.ViolationError, match="contradict each other") as caught:
        lw.simulate(twice_driven(other), 1.0, **WAYS[way])
    assert caught.value.joints == ["first", "second"]
    assert 0.0 < caught.value.time < 0.02
    assert caught.value.result is not None


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e3])
def test_when_it_is_noticed_does_not_depend_on_units(size: float) -> None:
    other = functions.expression(f"2 * {size} * t**2 * (1 - t)**2")
    with pytest.raises(lw.ViolationError) as caught:
        lw.simulate(twice_driven(other, size), 1.0, 1e-4)
    assert caught.value.time == pytest.approx(4e-4, abs=2e-4)


@pytest.mark.parametrize("way", WAYS)
def test_a_contradiction_within_the_inaccuracy_of_tables_is_told(way: str) -> None:
    other = functions.expression("(1 + 2e-3) * t**2 * (1 - t)**2")
    with pytest.warns(lw.LinkworkWarning, match="'?first'?.*contradict each other") as caught:
        result = lw.simulate(twice_driven(other), 1.0, **WAYS[way])
    assert len(caught) == 1
    found = result.statistics["contradiction"]
    assert found["joints"] == ["first", "second"]
    assert found["t"] < 0.3
    with pytest.raises(lw.ViolationError, match="contradict"):
        lw.simulate(twice_driven(other), 1.0, violation_limit=1.0, on_violation="stop", **WAYS[way])


@pytest.mark.parametrize("way", WAYS)
def test_drivers_that_agree_are_no_matter(way: str) -> None:
    same = functions.expression("(1 + 1e-9 * t) * t**2 * (1 - t)**2")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        result = lw.simulate(twice_driven(same), 1.0, **WAYS[way])
    assert result.finished


def test_redundant_mechanisms_raise_no_alarm() -> None:
    """Coarse steps let the equations that are kept drift, and the others with them."""
    for name in ("bricard", "bennett", "four_bar", "double_wishbone", "planetary_gear", "stewart_platform"):
        model = lw.mechanisms.named(name).function()
        for options in ({"step": 1e-3}, {"rtol": 1e-4}):
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                result = lw.simulate(model, 0.2, **options)
            assert result.finished
            assert "contradiction" not in result.statistics


#: A platform in the plane that three parallel legs hold: alpha is their angle, theta its own.
ALPHA, THETA, LEGS = "(0.3 + 0.2*t + 0.3*t**2)", "(0.5*t**2)", (0.0, 1.0, 2.5)


def leg(place: float) -> functions.TimeFunction:
    x = f"(sin{ALPHA} + {place}*cos{THETA} - {place})"
    y = f"(cos{ALPHA} + {place}*sin{THETA})"
    return functions.expression(f"sqrt({x}**2 + {y}**2)")


def platform() -> lw.Model:
    """As long as the legs are equal and parallel one depends on the others, and the platform moves freely."""
    model = lw.Model(gravity=(0, 0, 0))
    start = np.array([np.sin(0.3), np.cos(0.3), 0.0])
    body = model.body(
        "platform", mass=1.0, inertia=(0.3, 0.3, 0.3), position=start,
        velocity=0.2 * np.array([np.cos(0.3), -np.sin(0.3), 0.0]),
    )  # fmt: skip
    model.planar("ground", body, at=(0, 0, 0), axis=(0, 0, 1), name="plane")
    for k, place in enumerate(LEGS):
        ends = ((place, 0, 0), np.add(start, (place, 0, 0)))
        model.distance("ground", body, at=ends, length=leg(place), name=f"leg {k}")
    return model


@pytest.mark.parametrize("way", [way for way in WAYS if way not in ("none", "euler", "penalty")])
def test_rows_that_become_independent_count_from_there_on(way: str) -> None:
    result = lw.simulate(platform(), 1.0, **WAYS[way])
    alpha, theta = 0.3 + 0.2 + 0.3, 0.5
    assert result.q[-1, 0, :2] == pytest.approx([np.sin(alpha), np.cos(alpha)], abs=1e-4)
    assert 2 * np.arcsin(result.q[-1, 0, 6]) == pytest.approx(theta, abs=1e-4)
    assert result.statistics["row_changes"] >= 1
    assert np.abs(result.violation[-1, 0]) < 1e-5


def test_check_names_redundant_equations_that_ask_for_other_accelerations() -> None:
    from linkwork.cli.checking import examine

    other = functions.expression("2 * t**2 * (1 - t)**2")
    found = examine(twice_driven(other))["contradictions"]
    (equation,) = found
    assert "first" in equation or "second" in equation
    assert found[equation] == pytest.approx(2.0, rel=1e-6), "4 - 2 m/s2"
    assert not examine(twice_driven(functions.expression("t**2 * (1 - t)**2")))["contradictions"]


@pytest.mark.parametrize("way", [{"step": 1e-4}, {"rtol": 1e-6}, {"rtol": 1e-9, "integrator": "dop853"}])
@pytest.mark.parametrize("height", [0.02, 2e-4])
def test_drivers_that_part_for_a_millisecond_only_are_told(height: float, way: dict[str, object]) -> None:
    start, half = 0.4137, 5e-4
    up, down = functions.cycloidal(height, half, start), functions.cycloidal(-height, half, start + half)
    model = twice_driven(functions.Sum((functions.polynomial(0, 0, 1, -2, 1), up, down)))
    with pytest.raises(lw.ViolationError, match="contradict each other") as caught:
        lw.simulate(model, 1.0, progress=False, **way)
    assert caught.value.joints == ["first", "second"]
    assert start <= caught.value.time <= start + 2 * half


def test_accelerations_are_right_in_the_evaluation_in_which_rows_change() -> None:
    """Along the motion of a planetary gear, whose loops turn; beside a System that begins at each state."""
    model = lw.mechanisms.named("planetary_gear").function()
    result = lw.simulate(model, 0.2, 1e-3, progress=False)
    along = lw.System(model)
    for frame in range(0, len(result.t), 2):
        state = result.snapshot(frame)
        found, _ = along.accelerations(state.t, state.q, state.v)
        fresh, _ = lw.System(model.with_initial_state(state.q, state.v)).accelerations(
            state.t, state.q, state.v
        )
        assert np.abs(found - fresh).max() <= 1e-6 * np.abs(fresh).max(), state.t


SUN, PLANET, RING, ARM = 18, 27, 72, 0.225  # teeth; of the carrier [m]


def planets_between_gears(planets: int) -> lw.Model:
    """1 N m on the sun, a carrier at 20 rad/s, the ring held: all planets but one close a loop."""
    model, z, speed = lw.Model(gravity=(0, 0, 0)), (0, 0, 1), 20.0
    model.body("sun", mass=1.0, inertia=(0.02, 0.02, 0.02), omega=(0, 0, speed * (1 + RING / SUN)))
    model.body("carrier", mass=1.0, inertia=(0.1, 0.1, 0.1), omega=(0, 0, speed))
    for name in ("sun", "carrier"):
        model.revolute("ground", name, at=(0, 0, 0), axis=z, name=f"bearing of {name}")
    for k in range(planets):
        angle = 0.3 + 2 * np.pi * k / planets
        pin = ARM * np.array([np.cos(angle), np.sin(angle), 0.0])
        turning = (0, 0, speed * (1 - RING / PLANET))
        body = model.body(
            f"planet {k}", mass=0.8, inertia=(0.01, 0.01, 0.01), position=pin,
            velocity=speed * np.cross(z, pin), omega=turning,
        )  # fmt: skip
        model.revolute("carrier", body, at=pin, axis=z, name=f"pin {k}")
        for wheel, teeth in (("sun", SUN), ("ground", -RING)):
            model.gear(
                wheel, body, at=((0, 0, 0), pin), axis=z, teeth_a=teeth, teeth_b=PLANET, name=f"{wheel} {k}"
            )
    model.force("sun", torque=(0, 0, 1.0))
    return model


#: Stabilizations that leave drift, of positions or of velocities, where it is.
KEEPING = {
    "none": {"step": 1e-3, "stabilization": "none"},
    "none, rtol": {"rtol": 1e-7, "stabilization": "none"},
    "baumgarte": {"step": 1e-3, "stabilization": "baumgarte"},
    "baumgarte, rtol": {"rtol": 1e-7, "stabilization": "baumgarte"},
    "own gains": {"step": 1e-3, "baumgarte_alpha": 5.0, "baumgarte_beta": 5.0},
    "velocity_projection": {"step": 1e-3, "stabilization": "velocity_projection"},
    "position_projection": {"step": 1e-3, "stabilization": "position_projection"},
    "hem4": {"step": 1e-3, "integrator": "hem4"},
    "penalty": {"step": 1e-3, "formulation": "penalty", "stabilization": "none"},
}


@pytest.mark.parametrize("way", KEEPING)
def test_drift_does_not_grow_from_choice_to_choice_where_planets_go_round(way: str) -> None:
    """The carrier of a planetary gear has a constant acceleration, however many planets there are."""
    planets, t_end = 3, 1.0
    result = lw.simulate(planets_between_gears(planets), t_end, **KEEPING[way])
    turning = RING / SUN + 1, RING / PLANET - 1
    inertia = 0.1 + 0.02 * turning[0] ** 2 + planets * (0.8 * ARM**2 + 0.01 * turning[1] ** 2)
    angle = 20.0 * t_end + turning[0] / inertia * t_end**2 / 2
    assert result.statistics["row_changes"] > 0
    assert result.coordinate("bearing of carrier").value[-1] == pytest.approx(angle, abs=1e-4)


@pytest.mark.parametrize("way", KEEPING)
def test_drift_does_not_grow_from_choice_to_choice_where_lead_screws_turn(way: str) -> None:
    """A plate on three screws that belts couple sinks with a constant acceleration; nothing else holds it."""
    model, z, rise, speed, t_end = lw.Model(), (0, 0, 1), 0.05 / (2 * np.pi), 40.0, 1.5
    model.body("plate", mass=10.0, inertia=(1, 1, 1), position=(0, 0, 0.1), velocity=(0, 0, -speed * rise))
    for k in range(3):
        at = (np.cos(2.1 * k), np.sin(2.1 * k), 0.0)
        screw = model.body(f"screw {k}", mass=1.0, inertia=(0.1, 0.1, 0.02), position=at, omega=(0, 0, speed))
        model.revolute("ground", screw, at=at, axis=z, name=f"bearing {k}")
        model.screw(screw, "plate", at=at, axis=z, pitch=2 * np.pi * rise, name=f"nut {k}")
        if k > 0:
            model.coupler([(f"bearing {k}", 1.0), ("bearing 0", -1.0)], name=f"belt {k}")
    result = lw.simulate(model, t_end, **KEEPING[way])
    angle = speed * t_end + 10 * 9.81 * rise / (3 * 0.02 + 10 * rise**2) * t_end**2 / 2
    assert result.statistics["row_changes"] > 0
    assert result.coordinate("bearing 0").value[-1] == pytest.approx(
        angle, abs=1e-4 if "penalty" in way else 1e-5
    )
    assert result.position[-1, 0] == pytest.approx([0, 0, 0.1 - rise * angle], abs=1e-5)
