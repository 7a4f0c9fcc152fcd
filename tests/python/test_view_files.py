"""What leaves a result for people: pages, reports, movies and pictures; their data, sizes and errors."""

from __future__ import annotations

import base64
import json
import re
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import imageio_ffmpeg
import linkwork as lw
import numpy as np
import pytest
from drawn_words import HOSTILE, words_of
from linkwork.arrays import Floats
from linkwork.cli import run
from linkwork.errors import FileError, ModelError, OptionError
from linkwork.view.encoding import STEPS, Pack
from linkwork.view.poses import page_origin, stream_piece
from linkwork.view.run import Choice, document
from PIL import Image


@pytest.fixture(scope="module")
def four_bar() -> lw.Result:
    return lw.simulate(lw.mechanisms.four_bar(), t_end=1.0, step=1e-3, record_every=1)


@pytest.fixture(scope="module")
def adaptive() -> lw.Result:
    return lw.simulate(lw.mechanisms.spatial_slider_crank(), t_end=0.5, rtol=1e-6, record_every=1)


# --- encoding ---


def decoded(pack: Pack, name: str) -> np.ndarray:
    """As the page does it."""
    block = zlib.decompress(base64.b64decode(pack.text()))

    def array(key: str) -> np.ndarray:
        where = pack.directory[key]
        kind = {"u2": np.uint16, "f8": np.float64}[where["type"]]
        return np.frombuffer(block, kind, int(np.prod(where["shape"])), where["offset"]).reshape(
            where["shape"]
        )

    whole = np.cumsum(array(name), axis=1, dtype=np.uint16)
    return (array(f"{name}.low")[:, None] + array(f"{name}.step")[:, None] * whole).T


def test_quantized_series_are_within_half_a_step() -> None:
    rng = np.random.default_rng(0)
    values = rng.standard_normal((200, 5)).cumsum(axis=0) * [1e-9, 1, 1e9, 0, 1] + [0, 5, 0, 7, -3]
    pack = Pack()
    error = pack.add_quantized("x", values)
    found = decoded(pack, "x")
    np.testing.assert_allclose(error, np.ptp(values, axis=0) / STEPS / 2)
    assert (np.abs(found - values) <= 1.001 * error + 1e-15 * np.abs(values)).all()
    np.testing.assert_array_equal(found[:, 3], 7)


def singles(found: dict[str, Any], block: str, name: str) -> np.ndarray:
    """As the page does it: channel by channel (c, k)."""
    where = found["arrays"][name]
    raw = zlib.decompress(base64.b64decode(block))
    planes = np.frombuffer(raw, np.uint8, int(np.prod(where["shape"])), where["offset"])
    patterns = (planes.reshape(where["shape"]).astype(np.uint32) << np.arange(0, 32, 8)[:, None, None]).sum(0)
    return np.cumsum(patterns, axis=1, dtype=np.uint32).view(np.float32)


def test_series_keep_seven_digits_of_every_number_and_what_is_not_finite() -> None:
    rng = np.random.default_rng(0)
    values = rng.standard_normal((200, 5)).cumsum(axis=0) * [1e-9, 1, 1e9, 0, 1] + [0, 5, 0, 7, -3]
    values[50] = [1e30, -1e30, 1e38, np.nan, -np.inf]
    pack = Pack()
    pack.add_singles("x", values)
    found = singles({"arrays": pack.directory}, pack.text(), "x").T
    np.testing.assert_array_equal(found, values.astype(np.float32))


def test_poses_that_are_not_finite_are_refused() -> None:
    with pytest.raises(OptionError, match="poses that are not finite"):
        Pack().add_quantized("q", np.array([[1.0], [np.nan]]))


def test_a_knock_leaves_the_other_numbers_of_its_curve_as_they_are() -> None:
    """A ball hangs at rest, m g = 9.81 N in its pin, and gets a blow of 43 kN."""
    model = lw.Model()
    ball = model.body("ball", mass=1.0, inertia=(0.01, 0.01, 0.01), position=(0, 0, -0.5))
    model.spherical("ground", ball, at=(0, 0, 0), name="pin")
    blow = lw.functions.expression("1e5*exp(-((t-1)/0.002)**2)*sin((t-1)/0.002)")
    model.force(ball, force=(0, 0, blow), at=(0, 0, -0.5))
    result = lw.simulate(model, t_end=1.1, step=1e-3, progress=False, on_inaccurate="pass")
    assert np.abs(result.reaction("pin").force).max() > 2e4
    found, block, _ = document(result, "")
    np.testing.assert_allclose(singles(found, block, "force")[2, :100], 9.81, rtol=1e-6)


#: Far off along x and y [m].
FAR = np.array([2.0**20, 2.0**20, 0.0])


def cranks_at(place: Floats) -> lw.Result:
    """A crank with a rod, a spring and a box on the ground."""
    model = lw.Model()

    def at(x: float, z: float = 0.0) -> Floats:
        return place + np.array([x, 0.0, z])

    model.shape("ground", lw.Box((0.4, 0.4, 0.1), position=at(0, -0.5)))
    for name, x in (("crank", 0.25), ("rod", 0.75)):
        model.body(name, mass=1.0, inertia=(1e-3, 0.1, 0.1), position=at(x),
                   shape=lw.Box((0.5, 0.02, 0.02)))  # fmt: skip
    model.revolute("ground", "crank", at=at(0), axis=(0, 1, 0), name="pin")
    model.revolute("crank", "rod", at=at(0.5), axis=(0, 1, 0), name="knee")
    model.spring_damper("ground", "rod", at=(at(1, 1), at(1)), stiffness=20.0, damping=0.0, free_length=0.5,
                        name="spring")  # fmt: skip
    return lw.simulate(model, t_end=0.5, rtol=1e-9, times=np.linspace(0, 0.5, 11))


@pytest.mark.parametrize("streamed", [False, True])
def test_pages_of_mechanisms_that_are_far_off_show_what_they_would_at_the_origin(streamed: bool) -> None:
    """Pictures are drawn in single precision: at 1e6 m that has steps of 6 cm."""
    near, far = (document(cranks_at(place), "", streamed=streamed) for place in (0 * FAR, FAR))
    origin = np.array(far.facts["origin"])
    shift = origin - FAR
    assert near.facts["origin"] == [0, 0, 0] and np.abs(shift).max() < 1
    assert np.array(far.facts["extent"]) + shift == pytest.approx(np.array(near.facts["extent"]), abs=1e-6)
    assert far.facts["precision"] < 1e-4
    compared = 0
    for name, where in near.facts["arrays"].items():
        if name.endswith((".place", ".ends")) or name == "joints.origin":
            one, other = (
                np.frombuffer(zlib.decompress(base64.b64decode(it.block)), np.float32,
                              int(np.prod(where["shape"])), it.facts["arrays"][name]["offset"])
                for it in (near, far)
            )  # fmt: skip
            assert np.abs(one - other).max() < np.abs(shift).max() + 1e-5
            compared += 1
    assert compared > 3


def test_a_server_gives_out_poses_from_the_origin_of_its_page() -> None:
    far = cranks_at(FAR)
    origin = page_origin(far)
    piece = np.frombuffer(stream_piece(far, 0, origin), "<f4").reshape(11, 2, 7)
    assert piece[..., :3] + origin == pytest.approx(far.position, abs=1e-6)


def test_energy_error_of_a_run_that_goes_on_begins_with_zero() -> None:
    """Its work was counted from the start of the run before."""
    model = lw.Model()
    rod = model.body("rod", mass=1.0, inertia=(1e-3, 0.1, 0.1), position=(0.5, 0, 0))
    model.revolute("ground", rod, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    model.rotational_spring_damper("ground", rod, at=(0, 0, 0), axis=(0, 1, 0), stiffness=0.0, damping=0.5)
    first = lw.simulate(model, t_end=0.5, step=1e-3, progress=False)
    onward = lw.simulate(model, t_end=1.0, step=1e-3, start=first.snapshot(), progress=False)
    assert onward.work[0] < -0.1
    for streamed in (False, True):
        found, block, _ = document(onward, "", streamed=streamed)
        where = found["arrays"]["energy"]
        raw = zlib.decompress(base64.b64decode(block))
        energies = np.frombuffer(raw, np.float32, int(np.prod(where["shape"])), where["offset"])
        error = energies.reshape(where["shape"])[4]
        np.testing.assert_allclose(error, onward.energy_error, atol=1e-12)


def test_runs_of_different_mechanisms_are_told_of(four_bar: lw.Result, adaptive: lw.Result) -> None:
    with pytest.warns(
        lw.LinkworkWarning, match="different mechanisms, 'four_bar' and 'spatial_slider_crank'"
    ):
        four_bar.view(other=adaptive)


def test_events_beyond_those_that_are_marked_are_counted() -> None:
    model = lw.Model()
    model.body("ball", mass=1.0, inertia=(1, 1, 1))
    sign = lw.Event(lambda t, state: float(np.sin(2 * np.pi * 110 * t)), "passes zero")
    result = lw.simulate(model, t_end=1.0, step=2e-3, rtol=1e-6, events=[sign], progress=False)
    found = document(result, "")[0]
    assert len(result.events) > 201
    assert (len(found["events"]), found["unmarked"]) == (200, len(result.events) - 200)


def test_poses_are_sent_without_jumps_of_sign() -> None:
    """A body that turns twice: its Euler parameters pass through all signs, and stay continuous."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("top", mass=1, inertia=(1, 1, 1), omega=(0, 0, 4 * np.pi))
    result = lw.simulate(model, t_end=1.0, step=1e-2)
    flipped = result.q.copy()
    flipped[::2, :, 3:] *= -1
    from linkwork.view.poses import continuous

    smooth = continuous(flipped)[..., 3:]
    assert np.abs(np.diff(smooth, axis=0)).max() < 0.1
    np.testing.assert_allclose(np.abs(smooth), np.abs(result.orientation))


# --- limits ---


def test_frames_are_thinned_to_the_limit_and_keep_first_and_last(four_bar: lw.Result) -> None:
    limit = 20_000
    found, block, _ = document(four_bar, "", limit)
    raw = zlib.decompress(base64.b64decode(block))
    shown = found["frames"]["shown"]
    assert found["frames"]["recorded"] == len(four_bar) > 2 * shown > 4
    where = found["arrays"]["t"]
    t = np.frombuffer(raw, np.float64, shown, where["offset"])
    assert (t[0], t[-1]) == (four_bar.t[0], four_bar.t[-1])
    assert np.isin(t, four_bar.t).all()
    sizes = {"u1": 1, "u2": 2}
    series = [it for it in found["arrays"].values() if it["shape"][-1] == shown and it["type"] in sizes]
    assert sum(sizes[it["type"]] * int(np.prod(it["shape"])) for it in series) <= limit


def test_what_moves_most_is_kept_where_not_all_fits() -> None:
    result = lw.simulate(lw.mechanisms.chain(bodies=50), t_end=0.5, step=1e-2)
    choice = Choice.of(result, 60_000)
    travel = np.ptp(result.position, axis=0).max(axis=1)
    assert 0 < len(choice.bodies) < 50
    assert travel[choice.bodies].min() >= np.delete(travel, choice.bodies).max() * 0.99


def test_a_limit_for_less_than_two_frames_is_refused(four_bar: lw.Result) -> None:
    with pytest.raises(OptionError, match="give 168 or more"):
        four_bar.view(limit=50)


def test_viewing_leaves_the_result_as_it_was(four_bar: lw.Result) -> None:
    before = four_bar.q.copy()
    four_bar.view()
    np.testing.assert_array_equal(four_bar.q, before)


# --- pages ---


def test_page_of_three_bodies_and_ten_seconds_is_small() -> None:
    result = lw.simulate(lw.mechanisms.spatial_slider_crank(), t_end=10.0, step=1e-3, record_every=1)
    assert len(result.view().html) < 1.5e6


def test_page_of_a_file_is_that_of_the_run(four_bar: lw.Result, tmp_path: Path) -> None:
    four_bar.save(tmp_path / "run.h5")
    stored = lw.Result.load(tmp_path / "run.h5")
    assert document(stored, "")[1] == document(four_bar, "")[1]


def test_notebook_shows_the_page_in_a_frame(four_bar: lw.Result) -> None:
    shown = four_bar.view()._repr_html_()
    assert shown.startswith("<iframe")
    assert shown.count("<") == 1 + shown.count("</iframe>")  # all of the page is escaped


def test_commands_write_pages(
    four_bar: lw.Result, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    four_bar.save(tmp_path / "run.h5")
    file, page = str(tmp_path / "run.h5"), str(tmp_path / "page.html")
    commands = (
        ["view", file, "--html", page],
        ["view", file, "--with", file, "--html", page],
        ["report", file, "-o", page],
        ["report", "pendulum", "--t-end", "0.1", "-o", page],
    )
    for words in commands:
        Path(page).unlink(missing_ok=True)
        assert (run(words, debug=True), capsys.readouterr().err) == (0, ""), words
        assert Path(page).read_text().startswith("<!doctype html>")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["view", "no.h5", "--html", "p.html"], "no such file"),
        (["report", "four_bat", "-o", "p.html"], "the nearest is 'four_bar'"),
        (["report", "four_bar", "-o", "no/p.html"], "no directory"),
    ],
)
def test_commands_name_what_is_wrong(
    words: list[str], message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    assert run(words, debug=False) != 0
    assert message in capsys.readouterr().err
    assert not (tmp_path / "p.html").exists()


# --- reports ---


def cells(page: str, label: str) -> list[str]:
    """The cells of a row of a table after the first."""
    row = re.search(rf"<tr><td>{re.escape(label)}</td>(.*?)</tr>", page)
    assert row is not None, label
    return re.findall(r"<td>(.*?)</td>", row[1])


def test_report_says_what_the_model_is(four_bar: lw.Result) -> None:
    """Of a planar four-bar in space: 20 equations, of which 3 follow from the others, and one freedom."""
    page = four_bar.report().html
    assert cells(page, "mobility") == ["1"]
    assert cells(page, "constraints") == ["20 equations of rank 17"]
    assert cells(page, "beam 0")[0] == "1"
    assert cells(page, "left 0")[1:3] == ["post 0 - beam 0", "5"]
    assert "not unique" in cells(page, "left 0")[-1]
    assert page.count("<img ") == 5  # fixed steps have no picture of their size
    assert json.loads(
        re.search(r"<pre>(.*?)</pre>", page, re.DOTALL)[1].replace("&quot;", '"')
    ) == json.loads(json.dumps(four_bar.manifest))


# --- pictures ---


@pytest.fixture(scope="module", params=HOSTILE)
def oddly_named(request: pytest.FixtureRequest) -> lw.Result:
    model = lw.Model(name=request.param)
    arm = model.body(request.param, mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0.5, 0, 0))
    model.revolute("ground", arm, at=(0, 0, 0), axis=(0, 1, 0), name=request.param)
    return lw.simulate(model, t_end=0.1, step=1e-2, progress=False)


def test_names_are_drawn_letter_by_letter(oddly_named: lw.Result, tmp_path: Path) -> None:
    """No formula is made of them, and none is left out of a legend."""
    name = oddly_named.body_names[0]
    of_bodies = {f"{name}  x", f"{name}  z"}
    for kind, expected in {
        "overview": of_bodies | {name}, "positions": of_bodies, "velocities": of_bodies,
        "accelerations": of_bodies, "coordinates": {name}, "reactions": {name}, "phase": {name},
    }.items():  # fmt: skip
        words = words_of(oddly_named.plot(kind=kind), tmp_path)
        assert words >= expected, kind
        assert any(word.startswith(f"{name}, ") for word in words), f"title of {kind}"


def test_a_report_takes_any_name(oddly_named: lw.Result, tmp_path: Path) -> None:
    oddly_named.report(tmp_path / "report.html")
    assert (tmp_path / "report.html").stat().st_size > 100_000


def test_names_of_an_initial_pose_are_drawn_letter_by_letter(tmp_path: Path) -> None:
    model = lw.Model(name="$x$")
    for place, name in enumerate(HOSTILE):
        model.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1), position=(place, 0, 0))
    assert words_of(model.plot(), tmp_path) >= {*HOSTILE, "$x$: initial pose"}


def lines(figure: object) -> dict[str, np.ndarray]:
    """The lines of all axes by their labels."""
    return {
        str(line.get_label()): np.column_stack(line.get_data())
        for ax in figure.axes  # type: ignore[attr-defined]
        for line in ax.lines
    }


def test_step_history_has_every_step_taken(adaptive: lw.Result) -> None:
    figure = adaptive.plot(kind="step")
    (line,) = figure.axes[0].lines
    np.testing.assert_allclose(line.get_ydata(), np.diff(adaptive.t))
    assert figure.axes[0].get_ylabel() == "step [s]"
    assert "time between frames" in lw.simulate(
        lw.mechanisms.pendulum(), t_end=1, step=1e-4
    ).plot(kind="step").axes[0].get_ylabel()  # fmt: skip


def test_phase_portrait_is_rate_over_coordinate(adaptive: lw.Result) -> None:
    found = lines(adaptive.plot(kind="phase", joints=["guide"]))
    expected = np.column_stack(adaptive.coordinate("guide"))
    np.testing.assert_array_equal(found["guide"], expected)


def test_reactions_that_are_not_unique_are_dashed_and_marked(
    four_bar: lw.Result, adaptive: lw.Result
) -> None:
    ax = four_bar.plot(kind="reactions", joints=["pin 0"]).axes[0]
    assert [(line.get_label(), line.get_linestyle()) for line in ax.lines] == [("pin 0 (not unique)", "--")]
    np.testing.assert_allclose(
        ax.lines[0].get_ydata(), np.linalg.norm(four_bar.reaction("pin 0").force, axis=1)
    )
    unique = adaptive.plot(kind="reactions").axes[0].lines
    assert {line.get_linestyle() for line in unique} == {"-"}


@pytest.mark.parametrize(
    ("plot", "error", "message"),
    [
        (lambda r: r.plot(kind="phases"), OptionError, "nearest is 'phase'"),
        (lambda r: r.plot(kind="reactions", joints=["pon 0"]), ModelError, "nearest is 'pin 0'"),
        (lambda r: r.plot("x.nonsense", "energy"), FileError, "nonsense"),
        (lambda r: r.movie("x.avi"), FileError, "a movie is written to .mp4 or .gif"),
        (lambda r: r.movie("no/x.gif"), FileError, "no such file or directory"),
        (lambda r: r.movie("x.gif", size=(31, 100)), OptionError, "even sizes"),
        (lambda r: r.movie("x.gif", seconds=-1), OptionError, "positive times"),
    ],
)
def test_impossible_pictures_are_refused(
    four_bar: lw.Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    plot: Callable[[lw.Result], object], error: type[Exception], message: str,
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    with pytest.raises(error, match=message):
        plot(four_bar)


def test_a_report_of_fixed_steps_has_no_picture_of_their_size() -> None:
    model = lw.mechanisms.pendulum()
    pages = [
        lw.simulate(model, t_end=0.5, **choice).report().html for choice in ({"step": 1e-3}, {"rtol": 1e-6})
    ]
    assert ["Step size" in page for page in pages] == [False, True]


@pytest.fixture(scope="module")
def chain() -> lw.Result:
    return lw.simulate(lw.mechanisms.chain(bodies=21), t_end=0.1, step=1e-2, progress=False)


@pytest.mark.parametrize(
    "kind", ["positions", "velocities", "accelerations", "phase", "reactions", "overview"]
)
def test_all_that_is_chosen_is_drawn_each_in_its_color(chain: lw.Result, kind: str) -> None:
    what = "joints" if kind == "reactions" else "bodies"
    names = list(chain.joint_names if what == "joints" else chain.body_names)[:20]
    figure = chain.plot(kind=kind, **{what: names})
    ax = figure.axes[2 if kind == "overview" else 0]
    named = [line for line in ax.lines if not str(line.get_label()).startswith("_")]
    assert {str(line.get_label()).partition("  ")[0] for line in named} == set(names)
    assert len({line.get_color() for line in named}) == 20


@pytest.mark.parametrize("kind", ["positions", "velocities"])
def test_a_chosen_body_at_rest_is_drawn(kind: str) -> None:
    model = lw.Model(gravity=(0, 0, 0))
    model.body("still", mass=1.0, inertia=(1, 1, 1))
    model.body("flying", mass=1.0, inertia=(1, 1, 1), velocity=(1, 0, 0))
    result = lw.simulate(model, t_end=0.1, step=1e-2, progress=False)
    (ax, *_) = result.plot(kind=kind, bodies=["still", "flying"]).axes
    assert [line.get_label() for line in ax.lines] == ["still  x", "flying  x"]


def test_an_overview_shows_the_bodies_and_joints_that_are_chosen(adaptive: lw.Result) -> None:
    axes = adaptive.plot(bodies=["crank"], joints=["guide"]).axes
    labels = [{str(line.get_label()).partition("  ")[0] for line in ax.lines} for ax in axes]
    assert [labels[k] for k in (2, 4, 5)] == [{"crank"}, {"guide"}, {"guide"}]


@pytest.mark.parametrize(
    ("choice", "message"),
    [
        ({"kind": "reactions", "bodies": [0]}, "'reactions' shows no bodies by themselves: 'overview', "),
        ({"kind": "velocities", "joints": [0]}, "'velocities' shows no joints by themselves"),
        ({"kind": "energy", "joints": [0]}, "'energy' shows no joints"),
        ({"kind": "phase", "joints": [0], "bodies": [0]}, "bodies or joints: choose one of them"),
        ({"kind": "positions", "bodies": range(21)}, "21 bodies are chosen, of which 20"),
    ],
)
def test_choices_that_a_picture_cannot_show_are_refused(
    chain: lw.Result, choice: dict[str, Any], message: str
) -> None:
    with pytest.raises(OptionError, match=message):
        chain.plot(**choice)


def test_a_joint_without_a_coordinate_is_refused_also_beside_others(adaptive: lw.Result) -> None:
    kinds = dict(zip(adaptive.joint_names, adaptive.header.joint_kinds, strict=True))
    (ball,) = (name for name, kind in kinds.items() if kind == "spherical")
    with pytest.raises(OptionError, match=f"joint '{ball}' turns about or slides along no single axis"):
        adaptive.plot(kind="coordinates", joints=["guide", ball])


# --- movies ---


def test_movie_shows_the_body_where_it_is(tmp_path: Path) -> None:
    """A red ball on a straight way: in perspective, the cross ratio of four equal steps stays 4/3."""
    model = lw.Model(gravity=(0, 0, 0))
    model.body("ball", mass=1, inertia=(1, 1, 1), velocity=(1, 0, 0), shape=lw.Sphere(0.1, color="#ff0000"))
    result = lw.simulate(model, t_end=2.0, step=1e-2)
    result.movie(tmp_path / "m.gif", seconds=1.0, frames_per_second=5, size=(320, 200))
    places = []
    with Image.open(tmp_path / "m.gif") as film:
        assert film.n_frames == 5
        assert film.size == (320, 200)
        for k in range(5):
            film.seek(k)
            seen = np.asarray(film.convert("RGB")).astype(int)
            rows, columns = np.nonzero(seen[..., 0] - seen[..., 1] > 60)
            places.append((columns.mean(), rows.mean()))
    along, across = np.linalg.svd(np.array(places) - np.mean(places, axis=0))[2]
    x, aside = (np.array(places) @ axis for axis in (along, across))
    assert np.abs(np.diff(x)).min() > 25
    assert np.ptp(aside) < 1.0
    for a, b, c, d in (x[:4], x[1:]):
        assert (c - a) * (d - b) / ((c - b) * (d - a)) == pytest.approx(4 / 3, abs=0.03)


def test_movie_is_an_mp4_of_that_length(adaptive: lw.Result, tmp_path: Path) -> None:
    adaptive.movie(tmp_path / "m.mp4", seconds=1.0, frames_per_second=10, size=(320, 200))
    frames, seconds = imageio_ffmpeg.count_frames_and_secs(str(tmp_path / "m.mp4"))
    assert (frames, seconds) == (10, pytest.approx(1.0))


@pytest.mark.parametrize("rate", [12, 30, 50])
def test_a_gif_plays_as_fast_as_asked(adaptive: lw.Result, tmp_path: Path, rate: int) -> None:
    """Its pictures last whole hundredths of a second; together they last what was asked."""
    adaptive.movie(tmp_path / "m.gif", seconds=1.0, frames_per_second=rate, size=(64, 48))
    with Image.open(tmp_path / "m.gif") as film:
        durations = []
        for k in range(film.n_frames):
            film.seek(k)
            durations.append(film.info["duration"])
    assert sum(durations) == 1000


def test_a_gif_of_more_frames_per_second_than_browsers_show_is_refused(
    adaptive: lw.Result, tmp_path: Path
) -> None:
    with pytest.raises(OptionError, match=r"a \.gif shows at most 50 frames per second, not 60"):
        adaptive.movie(tmp_path / "m.gif", frames_per_second=60)
