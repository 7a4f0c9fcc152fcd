"""Pages of very many bodies: what is seen of each, frames in pieces, and what the page says it leaves out."""

from __future__ import annotations

import base64
import zlib
from collections.abc import Iterator
from pathlib import Path

import chromium
import linkwork as lw
import numpy as np
import pytest
from linkwork.view import poses
from linkwork.view.run import document

browser = pytest.mark.skipif(chromium.EXECUTABLE is None, reason="no Chromium: apt-get install chromium")

BODIES = 6001


@pytest.fixture(scope="module")
def tab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[chromium.Page]:
    with chromium.browser(tmp_path_factory.mktemp("profile")) as page:
        yield page


@pytest.fixture(scope="module")
def chain() -> lw.Result:
    return lw.simulate(lw.mechanisms.chain(BODIES), t_end=0.05, step=5e-3, on_inaccurate="pass")


@pytest.fixture(scope="module")
def swing() -> lw.Result:
    """Some turns of a few bodies."""
    return lw.simulate(lw.mechanisms.four_bar(2), t_end=4.0, step=1e-3, record_every=80)


def opened(tab: chromium.Page, result: lw.Result, folder: Path) -> None:
    tab.requests.clear()
    tab.complaints.clear()
    result.view(folder / "page.html", limit=16e6)
    tab.open(folder / "page.html")
    tab.drawn()


def frames_of(monkeypatch: pytest.MonkeyPatch, result: lw.Result, each: int) -> None:
    """Pieces of so many frames."""
    monkeypatch.setattr(poses, "MOST_NUMBERS", each * 7 * result.header.body_count)


def test_pieces_have_the_numbers_of_one_array(swing: lw.Result, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = document(swing, "")
    frames_of(monkeypatch, swing, 7)
    found = document(swing, "")
    assert whole.pieces == [] and whole.facts["pieces"] is None
    assert found.facts["pieces"] == {"count": 8, "frames": 7, "streamed": False}
    assert found.facts["frames"] == whole.facts["frames"] == {"recorded": 51, "shown": 51, "every": 1}
    width = 7 * swing.header.body_count

    def numbers(text: str, offset: int, frames: int) -> np.ndarray:
        raw = zlib.decompress(base64.b64decode(text))
        differences = np.frombuffer(raw, np.uint16, width * frames, offset).reshape(width, frames)
        return np.cumsum(differences, axis=1, dtype=np.uint16)

    expected = numbers(whole.block, whole.facts["arrays"]["q"]["offset"], 51)
    pieces = [numbers(piece, 0, 2 if k == 7 else 7) for k, piece in enumerate(found.pieces)]
    np.testing.assert_array_equal(np.concatenate(pieces, axis=1), expected)


@browser
def test_frames_in_pieces_are_shown_where_the_result_says(
    tab: chromium.Page, swing: lw.Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Forth and back, to more pieces than are out at once; positions that are plotted are those, too."""
    frames_of(monkeypatch, swing, 7)
    opened(tab, swing, tmp_path)
    for frame in (0, 50, 6, 7, 30, 15, 44, 0):
        tab.evaluate(f"linkwork.player.seek({float(swing.t[frame])!r})")
        tab.wait_for("!linkwork.player.behind")
        pose = np.reshape(tab.evaluate("Array.from(linkwork.runs[0].pose)"), (-1, 7))[:-1]
        np.testing.assert_allclose(pose[:, :3], swing.position[frame], atol=1e-4)
        assert tab.evaluate("linkwork.runs[0].poses.out.size") <= 4
    name = swing.body_names[1]
    lines = tab.evaluate(
        f"linkwork.runs[0].lines({{id: 'position'}}, {name!r}).map((it) => Array.from(it[1]))"
    )
    np.testing.assert_allclose(np.transpose(lines), swing.body(name).position, atol=1e-4)
    assert tab.requests == [(tmp_path / "page.html").as_uri()]
    assert tab.complaints == []


@browser
def test_a_motion_in_pieces_plays_to_its_end(
    tab: chromium.Page, swing: lw.Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    frames_of(monkeypatch, swing, 3)
    opened(tab, swing, tmp_path)
    tab.evaluate("(() => { linkwork.player.speed = 20; linkwork.player.play() })()")
    tab.wait_for("!linkwork.player.playing && !linkwork.player.behind")
    pose = np.reshape(tab.evaluate("Array.from(linkwork.runs[0].pose)"), (-1, 7))[:-1]
    np.testing.assert_allclose(pose[:, :3], swing.position[-1], atol=1e-4)


@browser
def test_a_piece_that_cannot_be_read_is_told(
    tab: chromium.Page, swing: lw.Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    frames_of(monkeypatch, swing, 7)
    opened(tab, swing, tmp_path)
    tab.evaluate("document.getElementById('poses0-6').textContent = 'no piece'")
    tab.evaluate("linkwork.player.seek(linkwork.player.end - 0.4)")
    tab.wait_for("document.querySelector('.now').textContent.includes('frames cannot be read')")


@browser
def test_of_very_many_bodies_each_is_drawn_as_what_one_sees_of_it(
    tab: chromium.Page, chain: lw.Result, tmp_path: Path
) -> None:
    """Far away all are dots; near one of them a few shapes, and the rest is out of the picture."""
    opened(tab, chain, tmp_path)
    seen = "linkwork.world.figures[0].seen"
    assert tab.evaluate(seen) == {"shapes": 0, "boxes": 0, "lines": 0, "smaller": BODIES, "outside": 0}
    assert tab.evaluate("linkwork.world.renderer.info.render.triangles") < 1000
    assert "drawn: 6001 as dots" in tab.evaluate("document.querySelector('.left-out').textContent")
    tab.evaluate("(() => { linkwork.world.select('body', 3000); linkwork.world.look('picked') })()")
    tab.drawn()
    found = tab.evaluate(seen)
    assert 3 < found["shapes"] < 50
    assert sum(found.values()) == BODIES
    assert found["outside"] > BODIES - 100
    expected = tab.evaluate("linkwork.world.projected(...linkwork.runs[0].pose.subarray(21000, 21003))")
    canvas = "linkwork.world.renderer.domElement"
    center = tab.evaluate(f"[{canvas}.clientWidth / 2, {canvas}.clientHeight / 2]")
    np.testing.assert_allclose(expected, center, atol=1)
    assert tab.evaluate(f"linkwork.world.under({expected[0]}, {expected[1]}).name") == "link[3000]"
    assert tab.complaints == []


@browser
def test_what_is_drawn_as_a_dot_can_be_picked(tab: chromium.Page, chain: lw.Result, tmp_path: Path) -> None:
    opened(tab, chain, tmp_path)
    x, y = tab.evaluate("linkwork.world.projected(...linkwork.runs[0].pose.subarray(14000, 14003))")
    name = tab.evaluate(f"linkwork.world.under({x}, {y}).name")
    assert abs(int(name.removeprefix("link[").removesuffix("]")) - 2000) < 20
    assert tab.evaluate(f"linkwork.world.under({x}, {y - 50})") is None


@browser
def test_names_beyond_what_fits_are_counted(tab: chromium.Page, chain: lw.Result, tmp_path: Path) -> None:
    opened(tab, chain, tmp_path)
    tab.evaluate(
        "(() => { const s = document.querySelector('.names-of'); s.value = 'bodies';"
        " s.dispatchEvent(new Event('change')) })()"
    )
    tab.drawn()
    shown = tab.evaluate("[...document.querySelectorAll('.names span')].filter((it) => !it.hidden).length")
    assert 40 <= shown <= 80
    assert f"{shown} of {BODIES} names" in tab.evaluate("document.querySelector('.left-out').textContent")


@browser
def test_a_small_mechanism_leaves_nothing_out(tab: chromium.Page, swing: lw.Result, tmp_path: Path) -> None:
    opened(tab, swing, tmp_path)
    assert tab.evaluate("document.querySelector('.left-out').textContent") == ""
    assert tab.evaluate("linkwork.world.crowded") is False
