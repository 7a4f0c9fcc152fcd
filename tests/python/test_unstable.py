"""Unstable and chaotic motion: errors of steps are followed as they grow, so that the verdict knows of it."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms
from linkwork.accuracy.measures import Bodies, Differences, Sampled, Scales
from linkwork.arrays import Floats
from linkwork.running.estimation import unjudged

METHODS: tuple[dict[str, Any], ...] = (
    {"rtol": 1e-5}, {"rtol": 1e-7}, {"step": 0.01, "integrator": "rk4"}, {"step": 2e-3, "integrator": "heun"},
)  # fmt: skip


def rods(*angles: float, gravity: float = 9.81) -> lw.Model:
    """Of 1 m and 1 kg, one on the other on hinges along y, at these angles from upright."""
    model = lw.Model(gravity=(0, 0, -gravity))
    end = np.zeros(3)
    for k, angle in enumerate(angles):
        way = np.array([np.sin(angle), 0, np.cos(angle)])
        model.body(f"rod {k}", mass=1.0, inertia=(1 / 12, 1 / 12, 1e-3), position=end + way / 2,
                   orientation=(np.cos(angle / 2), 0, np.sin(angle / 2), 0))  # fmt: skip
        model.revolute(f"rod {k - 1}" if k else "ground", f"rod {k}", at=end, axis=(0, 1, 0))
        end = end + way
    return model


def run(model: lw.Model, t_end: float, **how: Any) -> lw.Result:
    times = {"times": np.linspace(0, t_end, 301)} if "rtol" in how else {"record_every": 1}
    return lw.simulate(model, t_end, **how, **times, on_inaccurate="pass", progress=False)


EXACT: dict[tuple[str, bytes], lw.Result] = {}


def exact_motion(model: lw.Model, times: Floats) -> lw.Result:
    """Made once for all methods with these times."""
    key = model.hash(), times.tobytes()
    if key not in EXACT:
        with unjudged():
            EXACT[key] = lw.simulate(model, float(times[-1]), rtol=1e-12, atol=1e-15, integrator="dop853",
                                     times=times, on_inaccurate="pass", progress=False)  # fmt: skip
    return EXACT[key]


def true_error(model: lw.Model, result: lw.Result) -> float:
    exact = exact_motion(model, np.asarray(result.t))
    reference = Sampled.of(exact)
    apart = Differences.between(Sampled.of(result), reference)
    return float(apart.state(Scales.of(reference, Bodies.of(exact.header))).max())


def said_by_true(model: lw.Model, result: lw.Result) -> float:
    """Where both are all of the motion, there is nothing more to say."""
    assert result.verdict is not None
    true = true_error(model, result)
    return 1.0 if result.verdict.error > 0.5 < true else result.verdict.error / true


@pytest.mark.parametrize("how", METHODS, ids=str)
@pytest.mark.parametrize("angle", [0.1, 0.01, 1e-4, 1e-8])
def test_a_rod_that_falls_from_upright_is_as_far_off_as_it_is_said_to_be(angle: float, how: Any) -> None:
    model = rods(angle)
    assert 0.5 < said_by_true(model, run(model, 8.0 + 0.1 / angle**0.2, **how)) < 300


@pytest.mark.parametrize("how", METHODS, ids=str)
@pytest.mark.parametrize("angles", [(1.6, 1.6), (1e-6, -2e-6, 1e-6), (1.5, 1.8, 1.2, 2.0)], ids=str)
def test_rods_that_move_chaotically_are_not_said_to_be_better_than_they_are(
    angles: tuple[float, ...], how: Any
) -> None:
    model = rods(*angles)
    assert said_by_true(model, run(model, 6.0, **how)) > 0.5


def test_what_is_unstable_is_told_with_by_how_much_errors_grow() -> None:
    verdict = run(rods(1e-3), 6.0, rtol=1e-6).verdict
    assert verdict is not None and verdict.growth is not None
    assert verdict.growth > 1e4
    assert verdict.level != "good" and "errors grow" in verdict.sentence


def test_how_errors_grow_does_not_depend_on_units_nor_on_the_place() -> None:
    def made(length: float, mass: float, shift: float) -> lw.Model:
        model = lw.Model(gravity=(0, 0, -9.81 * length))
        at = np.array([shift, 0, 0])
        model.body("rod", mass=mass, inertia=np.array([1, 1, 0.01]) * mass * length**2 / 12,
                   position=at + length * np.array([np.sin(0.01), 0, np.cos(0.01)]) / 2,
                   orientation=(np.cos(0.005), 0, np.sin(0.005), 0))  # fmt: skip
        model.revolute("ground", "rod", at=at, axis=(0, 1, 0))
        return model

    found = []
    for length, mass, shift in ((1.0, 1.0, 0.0), (1e-3, 1e-9, 0.0), (1e3, 1e6, 0.0), (1.0, 1.0, 100.0)):
        verdict = run(made(length, mass, shift * length), 5.0, step=0.01, integrator="rk4").verdict
        assert verdict is not None and verdict.growth is not None
        found.append(verdict.growth)
    assert np.allclose(found, found[0], rtol=0.05)


def test_a_carriage_changes_nothing() -> None:
    """Nor how fast it goes: what falls on it is as far off."""
    found = []
    for speed in (0.0, 10.0, 1000.0):
        model = lw.Model(gravity=(0, 0, -9.81))
        model.body("carriage", mass=5.0, inertia=(1, 1, 1), velocity=(0, speed, 0))
        model.translational("ground", "carriage", at=(0, 0, 0), axis=(0, 1, 0))
        model.body("rod", mass=1.0, inertia=(1 / 12, 1 / 12, 1e-3), position=(0.0005, 0, 0.5),
                   orientation=(1, 0, 0.0005, 0), velocity=(0, speed, 0))  # fmt: skip
        model.revolute("carriage", "rod", at=(0, 0, 0), axis=(0, 1, 0))
        verdict = run(model, 6.0, step=0.01, integrator="rk4").verdict
        assert verdict is not None and verdict.growth is not None and verdict.level == "wrong"
        found.append(verdict.growth)
    assert max(found) < 3 * min(found)


@pytest.mark.parametrize("speed", [0.0, 100.0])
def test_what_is_fast_beside_hides_nothing(speed: float) -> None:
    """A rod that is not connected with it, over many short steps."""
    model = rods(1e-4)
    model.body("fast", mass=1.0, inertia=(1, 1, 1), position=(5, 0, 0), velocity=(0, 0, speed))
    verdict = run(model, 6.0, step=1e-3, integrator="heun").verdict
    assert verdict is not None and verdict.growth is not None
    assert verdict.growth > 1e4 and verdict.body == "rod 0"


@pytest.mark.parametrize("count", [8, 20])
def test_of_many_rods_what_is_chaotic_is_seen(count: int) -> None:
    model = rods(*np.linspace(1.0, 2.0, count))
    result = run(model, 10.0, rtol=1e-6)
    assert result.verdict is not None and result.verdict.level == "wrong"
    assert said_by_true(model, result) > 0.5


def test_what_is_small_now_counts_beside_what_it_becomes() -> None:
    """A pendulum on a pivot that moves up and down swings higher and higher, in the end all the way round."""
    model = lw.Model(gravity=(0, 0, -9.81))
    model.body("cart", mass=1.0, inertia=(0.1,) * 3, velocity=(0, 0, 1.24))
    drive = model.translational("ground", "cart", at=(0, 0, 0), axis=(0, 0, 1))
    model.drive(drive, position=lw.functions.harmonic(0.2, 6.2, 0.0, 0.0))
    model.body("rod", mass=1.0, inertia=(0.01,) * 3, position=(1e-3, 0, -1), velocity=(0, 0, 1.24),
               orientation=(1, 0, -5e-4, 0))  # fmt: skip
    model.revolute("cart", "rod", at=(0, 0, 0), axis=(0, 1, 0))
    assert said_by_true(model, run(model, 40.0, step=1e-3, integrator="heun")) > 0.5


@pytest.mark.parametrize(
    "how", [{"rtol": 1e-5}, {"rtol": 1e-6}, {"step": 0.01, "integrator": "rk4"}], ids=str
)
@pytest.mark.parametrize("beside", [0.01, 0.1, 1.0])
def test_a_body_that_tumbles_about_its_middle_axis_again_and_again_is_regular(
    beside: float, how: Any
) -> None:
    """Slow passages of an integrable motion: errors grow in proportion to time."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("top", mass=1.0, inertia=(1, 2, 3), omega=(beside, 5, beside))
    result = run(model, 30.0, **how)
    assert result.verdict is not None and "grow" not in result.verdict.sentence
    assert 0.2 < said_by_true(model, result) < 100


@pytest.mark.parametrize("name", ["four_bar", "bricard", "stewart_platform", "double_wishbone", "heavy_top"])
def test_regular_motion_is_not_called_unstable(name: str) -> None:
    verdict = run(getattr(mechanisms, name)(), 2.0, step=1e-3, integrator="rk4").verdict
    assert verdict is not None and verdict.level == "good"
    assert "grow" not in verdict.sentence and (verdict.growth is None or verdict.growth < 1e3)


def test_an_inherited_error_grows_on() -> None:
    """A run that is good by itself goes on from one that is not that good, in the same unstable motion."""
    model = rods(1e-3)
    first = run(model, 2.0, rtol=1e-4)
    second = lw.simulate(model, 6.0, rtol=1e-9, start=first.snapshot(), times=np.linspace(2, 6, 101),
                         on_inaccurate="pass", progress=False)  # fmt: skip
    assert second.verdict is not None and first.verdict is not None
    assert second.verdict.before > 30 * first.verdict.error


def test_a_law_of_the_users_own_that_drives_away_is_seen() -> None:
    """x'' = 9 x - x^3 from 1e-6: leaves the saddle, and comes back to it time and again."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("mass", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1e-6, 0, 0))
    joint = model.translational("ground", "mass", at=(1e-6, 0, 0), axis=(1, 0, 0))
    model.joint_force(joint, lambda t, x, v: 9 * (x + 1e-6) - (x + 1e-6) ** 3)
    result = run(model, 10.0, rtol=1e-6)
    assert said_by_true(model, result) > 0.5


TOUCHES: tuple[dict[str, Any], ...] = ({"rtol": 1e-5}, {"rtol": 1e-7}, {"step": 5e-4, "integrator": "rk4"})


def touching(kind: str, number: int) -> lw.Model:
    """Two or three rods, the last of which bounces on the floor, or which bounce on stops at their hinges."""
    angles = np.random.default_rng(number).uniform(1.0, 2.2, 2 if kind == "floor" else 3)
    model = rods(*angles)
    for k in range(1, len(angles) if kind != "floor" else 0):
        at = tuple(np.sum([[np.sin(a), 0, np.cos(a)] for a in angles[:k]], axis=0))
        model.rotational_stop(
            f"rod {k - 1}", f"rod {k}", at=at, axis=(0, 1, 0), x_axis=(1, 0, 0), lower=-1.2, upper=1.2,
            stiffness=2000.0, damping=0.0 if kind == "stops" else 50.0,
        )  # fmt: skip
    if kind == "floor":
        tip = tuple(np.sum([[np.sin(a), 0, np.cos(a)] for a in angles], axis=0))
        model.sphere_plane_contact("ground", "rod 1", at=((0, 0, -1.2), tip), normal=(0, 0, 1), radius=0.1,
                                   stiffness=1e5, hysteresis=0.2 * (number % 2), friction=0.1)  # fmt: skip
    return model


@pytest.mark.parametrize("how", TOUCHES, ids=str)
@pytest.mark.parametrize("number", range(4))
@pytest.mark.parametrize("kind", ["floor", "stops", "soft stops"])
def test_what_bounces_is_as_far_off_as_it_is_said_to_be(kind: str, number: int, how: Any) -> None:
    model = touching(kind, number)
    assert 0.5 < said_by_true(model, run(model, 4.0, **how)) < 5000


@pytest.mark.parametrize("how", TOUCHES, ids=str)
def test_what_bounces_on_a_plane_is_not_unstable(how: Any) -> None:
    model = lw.Model(gravity=(0, 0, -9.81))
    model.body("ball", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 0, 1.0))
    model.sphere_plane_contact("ground", "ball", at=((0, 0, 0), (0, 0, 1.0)), normal=(0, 0, 1), radius=0.1,
                               stiffness=1e5)  # fmt: skip
    verdict = run(model, 20.0, **how).verdict
    assert verdict is not None and verdict.growth is not None and verdict.unstable == 1.0


@pytest.mark.parametrize("how", [*TOUCHES, {"rtol": 1e-8, "integrator": "dop853"}], ids=str)
@pytest.mark.parametrize(
    ("stiffness", "damping"), [(1e5, 0.0), (1e5, 1e4), (1e7, 1e-9), (1e7, 1.0), (1e7, 1e6)]
)
def test_what_comes_and_goes_between_stops_is_not_unstable(
    stiffness: float, damping: float, how: Any
) -> None:
    """Where they begin and end derivatives are those of either side; energy hides nothing where they damp."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("slider", mass=1.0, inertia=(1e-3,) * 3, velocity=(1.0, 0, 0))
    along: Any = {"at": (0, 0, 0), "axis": (1, 0, 0)}
    model.translational("ground", "slider", **along)
    model.translational_stop(
        "ground", "slider", lower=-0.1, upper=0.1, stiffness=stiffness, damping=damping, **along
    )
    steps = how if "rtol" in how else {**how, "step": 2e-5}
    verdict = lw.simulate(model, 5.0, **steps, progress=False, on_inaccurate="pass").verdict
    assert verdict is not None and verdict.unstable == 1.0
    assert verdict.growth is None or verdict.growth < 1e5


def test_two_balls_that_meet_again_and_again_part_on_and_on() -> None:
    """In a box, of which the one is kept out of the middle: as two discs of a billiard."""
    model = lw.Model(gravity=(0, 0, 0))
    for k, (x, z, along, across) in enumerate([(-0.5, 0.13, 1.0, 0.3), (0.4, -0.2, -0.7, 0.8)]):
        model.body(
            f"ball {k}", mass=1.0, inertia=(4e-3,) * 3, position=(x, 0, z), velocity=(along, 0, across)
        )
        for n in (1, 0, 0), (-1, 0, 0), (0, 0, 1), (0, 0, -1):
            wall = (tuple(-1.0 * c for c in n), (x, 0, z))
            model.sphere_plane_contact("ground", f"ball {k}", at=wall, normal=n, radius=0.1, stiffness=1e6)
    model.sphere_sphere_contact("ball 0", "ball 1", at=((-0.5, 0, 0.13), (0.4, 0, -0.2)), radius_a=0.3,
                                radius_b=0.3, stiffness=1e6)  # fmt: skip
    for how in TOUCHES:
        result = run(model, 10.0, **how)
        assert result.verdict is not None and result.verdict.unstable > 1e3
        assert 0.5 < said_by_true(model, result) < 5000


@pytest.mark.parametrize(
    "how", [{"rtol": 1e-7}, {"step": 0.0125}, {"step": 1 / 480, "integrator": "heun"}], ids=str
)
def test_from_next_to_rest_errors_grow_as_small_motions_do(how: Any) -> None:
    """By e^(w t): differences of energies are rounding where speeds are."""
    verdict = run(rods(1e-10), 10.0, **how).verdict
    assert verdict is not None and verdict.growth is not None
    assert 1e4 < verdict.growth < 10 * np.exp(10 * np.sqrt(1.5 * 9.81))


@pytest.mark.parametrize("t_end", [60.0, 100.0])
@pytest.mark.parametrize("how", [{"rtol": 1e-5}, {"rtol": 1e-7}, {"step": 0.02}], ids=str)
def test_a_driven_oscillator_between_two_wells_by_a_law_is_not_said_to_be_better_than_it_is(
    how: Any, t_end: float
) -> None:
    """Duffing's, x'' = x - x^3 - x'/4 + cos(t)/2, chaotic."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("mass", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1.0, 0, 0))
    joint = model.translational("ground", "mass", at=(1.0, 0, 0), axis=(1, 0, 0))
    model.joint_force(joint, lambda t, x, v: (x + 1) - (x + 1) ** 3 - 0.25 * v + 0.5 * np.cos(t))
    assert said_by_true(model, run(model, t_end, **how)) > 0.3


# --- many at once: errors of one in 64 are followed in lanes, which say so of the others ---

MASSES = np.linspace(0.9, 1.1, 130).tolist()
HOW: tuple[dict[str, Any], ...] = ({"step": 5e-3}, {"rtol": 1e-6})


def many(angle: float, masses: list[float], **how: Any) -> lw.EnsembleResult:
    varied = {"rod 1.mass": masses}
    return lw.simulate_many(rods(angle, angle), varied, 10.0, outputs="final", progress=False, **how)


def known(found: lw.EnsembleResult | lw.Study) -> np.ndarray[Any, Any]:
    return ~np.isnan(found.unstable)


def test_some_members_of_an_ensemble_say_that_those_like_them_may_be_unstable() -> None:
    said = r"errors grow up to \de\d times in the motion of \d+ of the 16 members .* the other 114 may"
    with (
        pytest.warns(lw.LinkworkWarning, match=said),
        pytest.warns(lw.LinkworkWarning, match="at least .* more than 1 % off"),
    ):
        found = many(1e-3, MASSES, step=5e-3)
    assert known(found).sum() == 16 and np.nanmax(found.unstable) > 1e4
    assert re.search(said, repr(found)) and "follow_errors=True" in repr(found)


def test_with_tolerances_errors_of_all_members_are_followed() -> None:
    found = many(1e-3, MASSES[:40], rtol=1e-6, on_inaccurate="pass")
    assert known(found).all() and "follow" not in repr(found)


def test_which_members_are_followed_depends_on_what_they_are_not_on_their_places() -> None:
    found, turned = (many(1e-3, it, step=5e-3, on_inaccurate="pass") for it in (MASSES, MASSES[::-1]))
    np.testing.assert_array_equal(found.unstable, turned.unstable[::-1])
    np.testing.assert_array_equal(found.accuracy, turned.accuracy[::-1])


def test_of_equal_members_no_more_are_followed_than_of_others() -> None:
    alike = many(1e-3, [1.0] * 130, step=5e-3, on_inaccurate="pass")
    listed = lw.simulate_many([rods(1e-3)] * 130, None, 3.0, 5e-3, outputs="final", progress=False,
                            on_inaccurate="pass")  # fmt: skip
    assert known(alike).sum() < 30 and known(listed).sum() < 30


@pytest.mark.parametrize("how", HOW, ids=str)
def test_where_errors_of_all_are_followed_each_has_the_verdict_of_its_run_by_itself(how: Any) -> None:
    ensemble = lw.Ensemble(rods(1e-3, 1e-3), {"rod 1.mass": MASSES[:3]})
    found = ensemble.simulate(10.0, **how, follow_errors=True, on_inaccurate="pass", progress=False)
    for k in range(3):
        member = found.member(k).verdict
        single = ensemble.single(k, 10.0, **how, on_inaccurate="pass", progress=False).verdict
        assert member is not None and single is not None and member.unstable > 1e3
        assert member.numbers() == single.numbers()
    assert "follow" not in repr(found)


def test_of_regular_motion_it_is_said_in_how_many_errors_were_followed() -> None:
    found = many(3.0, MASSES[:70], step=5e-3)
    assert np.nanmax(found.unstable) == 1.0 and known(found).sum() == 16
    assert "is known of 16 of the 70 members, where they do not" in repr(found)


def vibrating(stiffness: float, *, model: lw.Model | None = None) -> lw.Model:
    """A mass on a spring beside it: on a stiff one it comes and goes too often to be followed to the end."""
    model = lw.Model() if model is None else model
    model.body("mass", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(5, 0, 0), velocity=(1, 0, 0))
    along: Any = {"at": (5, 0, 0), "axis": (1, 0, 0)}
    model.translational("ground", "mass", **along)
    model.translational_spring_damper("ground", "mass", **along, stiffness=stiffness)
    return model


def test_nobody_is_told_to_follow_errors_that_are_followed() -> None:
    def mixed(stiffness: float) -> lw.Model:
        return vibrating(stiffness, model=rods(1e-3, 1e-3))

    off = pytest.warns(lw.LinkworkWarning, match="members are more than 1 % off")
    with off, pytest.warns(lw.LinkworkWarning, match="the other 2 may be") as said:
        found = lw.simulate_many(mixed, {"stiffness": [2e6, 3e6, 100.0, 200.0]}, 10.0, rtol=1e-6,
                                 outputs="final", progress=False)  # fmt: skip
    assert known(found).tolist() == [False, False, True, True]
    assert all("follow_errors" not in str(it.message) for it in said)


def test_a_study_is_told_by_some_of_its_cases_also_when_it_is_read_again(tmp_path: Path) -> None:
    def study(count: int = 50, **more: Any) -> lw.Study:
        given = {"t_end": 10.0, "step": 5e-3, "progress": False, "processes": 1, **more}
        return lw.sweep(rods(1e-3, 1e-3), {"rod 1.mass": MASSES[:count]}, "final", **given)

    some = tmp_path / "some"
    with pytest.warns(lw.LinkworkWarning, match="errors grow up to .* of the 16 cases"):
        found = study(directory=some)
    assert found.manifest["lanes"] is True and known(found).sum() == 16
    assert found.to_table()["unstable"].tolist() == pytest.approx(found.unstable.tolist(), nan_ok=True)
    again = study(directory=some, on_inaccurate="pass")
    np.testing.assert_array_equal(found.unstable, again.unstable)
    assert repr(again) == repr(found)
    with pytest.raises(lw.FileError, match="holds a study with other follow_errors"):
        study(directory=some, follow_errors=True)
    every = study(follow_errors=True)
    assert known(every).all() and "follow" not in repr(every)
    assert (every.accuracy >= found.accuracy).all()
    np.testing.assert_array_equal(every.accuracy[known(found)], found.accuracy[known(found)])


def test_a_study_that_has_more_cases_now_follows_as_many_as_it_has(tmp_path: Path) -> None:
    """Of those that are there already nothing more is known than when they ran."""

    def followed(count: int) -> int:
        found = lw.sweep(
            rods(1e-3, 1e-3),
            {"rod 1.mass": MASSES[:count]},
            "final",
            t_end=3.0,
            step=5e-3,
            on_inaccurate="pass",
            progress=False,
            processes=1,
            directory=tmp_path / "grows",
        )
        assert ("follow_errors" in repr(found)) == (count > 16)
        return int(known(found).sum())

    assert followed(10) == 10
    assert 16 <= followed(130) <= 26
    assert followed(10) == 10


def test_what_is_unstable_beside_other_parts_is_told_by_its_own_number() -> None:
    model = rods(1e-6)
    model.body("top", mass=1.0, inertia=(0.1, 0.2, 0.25), position=(5, 0, 0), omega=(0.1, 20.0, 0.1))
    found = lw.simulate_many([model], None, 4.0, 1e-2, outputs="final", progress=False, on_inaccurate="pass")
    assert 1e4 < found.unstable[0] < 1e7


@pytest.mark.parametrize("count", [3, 20])
@pytest.mark.parametrize("stiff", [True, False])
def test_nobody_is_told_to_follow_errors_where_that_does_not_help(stiff: bool, count: int) -> None:
    """Where evaluations end it, and of few members, which all are."""
    model = vibrating(2.5e5 if stiff else 100.0)
    found = lw.simulate_many([model] * count, None, 15.0 if stiff else 2.0, 1e-3, outputs="final",
                             progress=False, on_inaccurate="pass")  # fmt: skip
    assert np.isnan(found.unstable).all() == stiff
    assert ("follow_errors" in repr(found)) == (not stiff and count > 16)
    assert ("verify=True" in repr(found)) == (stiff and count > 16)


def test_members_out_of_lanes_are_all_followed() -> None:
    found = lw.simulate_many(rods(1e-3), {"rod 0.mass": MASSES[:20]}, 2.0, 1e-2, integrator="ab4",
                             outputs="final", progress=False, on_inaccurate="pass")  # fmt: skip
    assert known(found).all() and found.manifest["follow_errors"] is True


def test_with_tolerances_a_study_goes_on_whatever_is_said_of_errors(tmp_path: Path) -> None:
    for follow in (False, True, False):
        found = lw.sweep(
            rods(1e-3),
            {"rod 0.mass": MASSES[:3]},
            "final",
            t_end=1.0,
            rtol=1e-6,
            progress=False,
            processes=1,
            directory=tmp_path / "same",
            follow_errors=follow,
        )
        assert len(found) == 3


def test_cases_that_run_by_themselves_are_all_followed() -> None:
    found = lw.sweep(rods(1e-3), {"rod 0.mass": [1.0, 2.0, 3.0]}, "final", t_end=5.0, step=5e-3, processes=1,
                     deterministic=False, progress=False)  # fmt: skip
    assert found.manifest["lanes"] is False and (found.unstable > 1e3).all()
    assert "follow" not in repr(found)


@pytest.mark.parametrize("wrong", [1, "all", None])
def test_whether_errors_are_followed_is_true_or_false(wrong: Any) -> None:
    with pytest.raises(lw.OptionError, match="follow_errors .* is not True or False"):
        many(1e-3, MASSES[:2], step=5e-3, follow_errors=wrong)
    with pytest.raises(lw.OptionError, match="follow_errors .* is not True or False"):
        lw.sweep(rods(1e-3), {"rod 0.mass": [1.0]}, "final", t_end=1.0, step=5e-3, follow_errors=wrong)
