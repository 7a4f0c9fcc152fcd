"""Pictures of studies show what the cases are; swings are those of the linear fit."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from drawn_words import HOSTILE, words_of
from linkwork.studies.pictures import KINDS, MOST_BINS, _at_points

RUN: dict[str, Any] = {"t_end": 0.05, "step": 5e-3, "processes": 1, "progress": False}


def rod(mass: float = 1.0, length: float = 1.0, kind: str = "rod") -> lw.Model:
    model = lw.Model(name=kind)
    J = mass * length**2 / 12
    body = model.body("rod", mass=mass, inertia=(1e-3, J, J), position=(length / 2, 0, 0))
    model.revolute(model.ground, body, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    return model


def weight(result: lw.Result) -> float:
    """Linear in the mass, nothing to do with the length."""
    return 9.81 * float(result.header.mass[0])


def mixed(result: lw.Result) -> list[float]:
    mass, length = float(result.header.mass[0]), 2.0 * float(result.q[0, 0, 0])
    return [3.0 * mass - 0.5 * length, mass * mass]


@pytest.fixture(scope="module")
def study() -> lw.Study:
    parameters = {"mass": (1.0, 2.0), "length": (0.5, 1.5)}
    outputs = {"weight": (weight, "N"), "mixed": mixed, "height": "body('rod').position.z"}
    return lw.sweep(
        rod, parameters, outputs, sampler="sobol", cases=32, seed=3, times=[0.01, 0.03, 0.05], **RUN
    )


def test_swings_of_what_is_linear_are_exact(study: lw.Study) -> None:
    first, second = study.swings("weight")
    low, high = np.percentile(study.parameters["mass"], [5, 95])
    assert (first.parameter, second.parameter) == ("mass", "length")
    assert first.change == pytest.approx(9.81 * (high - low), rel=1e-9)
    assert abs(second.change) < 1e-9 and first.explained == pytest.approx(1.0, abs=1e-12)


def test_outputs_that_differ_by_roundoff_are_constant_and_far_ones_leave_bins_that_can_be_seen() -> None:
    rows = [{"mass": 1.0 + 1e-3 * k} for k in range(40)]
    outputs = {
        "noise": lambda result: 1e9 * (1.0 + 1e-15 * float(result.header.mass[0])),
        "far": lambda result: 1e12 if result.header.mass[0] == 1.0 else float(result.header.mass[0]),
    }
    study = lw.sweep(rod, rows, outputs, **RUN)
    with pytest.raises(lw.OptionError, match="needs 1 outputs"):
        study.plot("histogram", outputs="noise")
    (ax,) = study.plot("histogram", outputs="far").axes
    assert len(ax.patches) == MOST_BINS
    assert len(study.plot("scatter").axes) == 4  # of mass and the far one


def test_a_surface_shows_the_mean_over_what_else_varies_and_says_so() -> None:
    turning = {"light": 0.125, "heavy": 0.375}

    def design(mass: float, length: float, kind: str) -> lw.Model:
        return rod(mass, length).replaced("rod", inertia=(turning[kind], 1.0, 1.0))

    def load(result: lw.Result) -> float:
        return 8.0 * float(result.header.mass[0]) * float(np.ravel(result.header.inertia)[0])

    parameters = {"mass": [1.0, 2.0, 4.0], "length": [0.5, 1.0], "kind": ["light", "heavy"]}
    study = lw.sweep(design, parameters, {"load": load}, **RUN)
    points, means = _at_points(
        *(study.parameters[name] for name in ("mass", "length")), study.outputs["load"]
    )
    np.testing.assert_allclose(means, 2.0 * points[:, 0], rtol=1e-15)
    assert len(points) == 6
    title = study.plot("surface").get_suptitle()
    assert "1 other parameter varies" in title and "without kind, no number" in title
    assert "without kind" in study.plot("tornado").get_suptitle()


def test_panels_say_how_many_cases_have_no_number() -> None:
    rows = [{"mass": 1.0 + k} for k in range(8)]

    def heavy(result: lw.Result) -> float:
        mass = float(result.header.mass[0])
        return mass if mass > 3.5 else float("nan")

    study = lw.sweep(rod, rows, {"heavy": heavy}, **RUN)
    for kind in ("histogram", "tornado"):
        (ax,) = study.plot(kind).axes
        assert ax.get_title().endswith("3 cases without a number")


def test_the_fit_says_how_much_of_what_is_not_linear_it_explains() -> None:
    rows = [{"mass": m, "length": x} for m in np.linspace(-1, 1, 9) + 2 for x in (0.5, 1.0, 1.5)]

    def square(result: lw.Result) -> float:
        return (float(result.header.mass[0]) - 2.0) ** 2

    (first, second) = lw.sweep(rod, rows, {"square": square}, **RUN).swings("square")
    assert max(abs(first.change), abs(second.change)) < 1e-12 and abs(first.explained) < 1e-12


def test_a_parameter_that_only_failed_cases_change_is_left_out_with_a_word() -> None:
    grid = {"mass": [1.0, -1.0], "length": np.linspace(1.0, 2.0, 10).tolist()}

    def turning(result: lw.Result) -> float:
        return 6.0 * float(result.q[0, 0, 0])  # 3 lengths

    study = lw.sweep(rod, grid, {"turning": turning}, **RUN)
    assert (study.status == "finished").sum() == 10
    with pytest.warns(lw.LinkworkWarning, match="without 'mass', the same in all cases that have 'turning'"):
        (swing,) = study.swings("turning")
    assert swing.parameter == "length"
    assert swing.change == pytest.approx(3.0 * 0.9, rel=1e-12)
    (ax,) = study.plot("tornado").axes
    assert len(ax.patches) == 1
    assert "without 'mass', the same in these cases" in ax.get_title()


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_is_drawn_and_written(kind: str, study: lw.Study, tmp_path: Path) -> None:
    figure = study.plot(kind, tmp_path / f"{kind}.png")
    assert (tmp_path / f"{kind}.png").stat().st_size > 5000
    assert "32 cases" in figure._suptitle.get_text()


@pytest.fixture(scope="module")
def oddly_named() -> lw.Study:
    def model(_mass: float, length: float) -> lw.Model:
        return rod(_mass, length)

    outputs = {name: mixed for name in HOSTILE} | {"_$high$": "body('rod').position.z"}
    ranges = {"_mass": (1.0, 2.0), "length": (0.5, 1.5)}
    return lw.sweep(model, ranges, outputs, sampler="sobol", cases=16, seed=3, times=[0.01, 0.05], **RUN)


@pytest.mark.parametrize("kind", KINDS)
def test_names_are_drawn_letter_by_letter(kind: str, oddly_named: lw.Study, tmp_path: Path) -> None:
    before = "change of " if kind == "tornado" else ""
    outputs = ["_$high$"] if kind == "bands" else [*HOSTILE]
    for name in outputs:
        words = words_of(oddly_named.plot(kind, outputs=name), tmp_path)
        assert any(word.startswith(before + name) for word in words), name
        assert kind not in ("scatter", "surface", "tornado") or "_mass" in words


def test_what_is_drawn_is_what_was_found(study: lw.Study) -> None:
    axes = study.plot("scatter", outputs="weight").axes
    assert [ax.get_xlabel() for ax in axes[-3:]] == ["mass", "length", "weight [N]"]
    points = axes[6].lines[0]  # weight over mass
    np.testing.assert_array_equal(points.get_xdata(), study.parameters["mass"])
    np.testing.assert_array_equal(points.get_ydata(), study.outputs["weight"])
    (bands,) = study.plot("bands").axes
    middle = next(line for line in bands.lines if line.get_label() == "median")
    np.testing.assert_allclose(middle.get_ydata(), np.median(study.outputs["height"], axis=0), rtol=1e-15)
    tornado = study.plot("tornado", outputs="mixed").axes
    assert [label.get_text() for label in tornado[0].get_yticklabels()] == ["length", "mass"]
    widths = [bar.get_width() for bar in tornado[0].patches]
    assert widths[1] > 0 > widths[0]  # 3 mass - length / 2


def test_bands_have_each_case_while_it_lasts() -> None:
    def fast(t: float, state: lw.Snapshot) -> float:
        return abs(float(state.body("rod").omega[1])) - 2.5

    times = np.linspace(0.0, 0.2, 5)
    study = lw.sweep(
        rod, {"mass": [1.0], "length": [0.5, 0.8, 1.0, 3.0]}, {"height": "body('rod').position.z"},
        t_end=0.2, rtol=1e-6, times=times, events=[lw.Event(fast, terminal=True)], processes=1,
    )  # fmt: skip
    heights = study.outputs["height"]
    assert np.isnan(heights).any() and not np.isnan(heights).all(axis=0).any()
    (bands,) = study.plot("bands").axes
    middle = next(line for line in bands.lines if line.get_label() == "median")
    np.testing.assert_allclose(middle.get_ydata(), np.nanmedian(heights, axis=0), rtol=1e-15)
    ended = int(np.isnan(heights).any(axis=1).sum())
    assert f"{ended} case" in bands.get_title() and "not at all times" in bands.get_title()


def test_failed_cases_are_marked() -> None:
    study = lw.sweep(rod, [{"mass": m, "length": 1 + m / 5} for m in (1, 2, -1, 4)], {"w": weight}, **RUN)
    figure = study.plot("scatter")
    assert "1 failed" in figure._suptitle.get_text()
    crosses = [line for line in figure.axes[1].lines if line.get_marker() == "x"]
    assert crosses[0].get_ydata().tolist() == [-1.0]


@pytest.mark.parametrize(("kind", "options", "said"), [
    ("pie", {}, "does not exist"),
    ("scatter", {"outputs": "wieght"}, "output 'wieght' is none of this study; the nearest is 'weight'"),
    ("scatter", {"outputs": 3}, "output '3' is none of this study"),
    ("tornado", {"parameters": ["mess"]}, "parameter 'mess' is none"),
    ("surface", {"parameters": "mass"}, "needs 2 parameters"),
    ("bands", {"outputs": "weight"}, "no output is an array over time"),
    ("histogram", {"outputs": "height"}, "needs 1 outputs"),
])  # fmt: skip
def test_what_cannot_be_drawn_is_refused(
    kind: str, options: dict[str, Any], said: str, study: lw.Study
) -> None:
    with pytest.raises(lw.OptionError, match=said):
        study.plot(kind, **options)


def test_too_few_cases_and_parameters_that_move_together_are_refused() -> None:
    few = lw.sweep(rod, [{"mass": 1.0, "length": 1.0}, {"mass": 2.0, "length": 2.0}], {"w": weight}, **RUN)
    with pytest.raises(lw.OptionError, match="^swings: 2 finished cases are too few for 2 parameters"):
        few.swings("w")
    rows = [{"mass": m, "length": m} for m in (1.0, 2.0, 3.0, 4.0, 5.0)]
    with pytest.raises(lw.OptionError, match="move together"):
        lw.sweep(rod, rows, {"w": weight}, **RUN).swings("w")

    def nothing(result: lw.Result) -> float:
        raise ValueError("of mine")

    failed = lw.sweep(rod, {"mass": [1.0, 2.0]}, {"w": nothing}, **RUN)
    with pytest.raises(lw.OptionError, match="no case has finished"):
        failed.plot()


def test_a_picture_of_no_known_format_is_refused_before_it_is_drawn(study: lw.Study, tmp_path: Path) -> None:
    with pytest.raises(lw.FileError, match="no format 'xyz'"):
        study.plot("scatter", tmp_path / "study.xyz")


def moving_together(parameters: list[str]) -> tuple[lw.Study, Any]:
    """The load 3 mass + length of cases whose length goes down as the mass goes up, nearly."""
    aside = np.random.default_rng(1).normal(size=40)
    rows = [{"mass": 1.0 + 0.01 * k, "length": 2.0 - 0.02 * k + 0.05 * aside[k]} for k in range(40)]

    def load(result: lw.Result) -> float:
        return 3.0 * float(result.header.mass[0]) + 2.0 * float(result.q[0, 0, 0])

    study = lw.sweep(rod, rows, {"load": load}, **RUN)
    return study, study.plot("tornado", parameters=parameters)


@pytest.mark.parametrize("name", ["mass", "length"])
def test_a_tornado_of_one_parameter_holds_the_others(name: str) -> None:
    study, figure = moving_together([name])
    (ax,) = figure.axes
    low, high = np.percentile(study.parameters[name], [5, 95])
    slope = {"mass": 3.0, "length": 1.0}[name]
    assert [text.get_text() for text in ax.get_yticklabels()] == [name]
    assert ax.patches[0].get_width() == pytest.approx(slope * (high - low), rel=1e-9)


def test_a_surface_over_chosen_parameters_counts_all_others() -> None:
    parameters = {"rod.mass": [1.0, 2.0, 3.0], "gravity[0]": [0.0, 1.0], "gravity[2]": [-9.81, -1.62]}
    study = lw.sweep(rod(), parameters, {"load": weight}, **RUN)
    figure = study.plot("surface", parameters=["rod.mass", "gravity[0]"])
    assert "in which 1 other parameter varies" in figure.get_suptitle()


def test_a_surface_is_over_parameters_that_differ_in_finished_cases() -> None:
    """The first of them has another value in the case that failed alone."""
    rows = [{"kind": 1.0, "mass": 1.0 + k % 3, "length": 1.0 + k // 3} for k in range(9)]

    def build(kind: float, mass: float, length: float) -> lw.Model:
        return rod(mass if kind == 1.0 else -mass, length)

    study = lw.sweep(build, [*rows, {"kind": 2.0, "mass": 1.0, "length": 1.0}], {"w": weight}, **RUN)
    figure = study.plot("surface")
    assert (figure.axes[0].get_xlabel(), figure.axes[0].get_ylabel()) == ("mass", "length")
    assert "varies" not in figure.get_suptitle()
