"""The page by a server of this machine: all frames, a few at a time, and nothing else to nobody else."""

from __future__ import annotations

import http.client
import signal
import subprocess
import sys
import threading
import urllib.error
import urllib.request
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler
from pathlib import Path

import chromium
import linkwork as lw
import numpy as np
import pytest
from linkwork.cli import run
from linkwork.view import poses
from linkwork.view import run as runs
from linkwork.view.serving import Server

browser = pytest.mark.skipif(chromium.EXECUTABLE is None, reason="no Chromium: apt-get install chromium")


@pytest.fixture(scope="module")
def tab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[chromium.Page]:
    with chromium.browser(tmp_path_factory.mktemp("profile")) as page:
        yield page


@pytest.fixture(scope="module")
def swing(tmp_path_factory: pytest.TempPathFactory) -> lw.Result:
    """Some turns of a few bodies, in a file."""
    output = tmp_path_factory.mktemp("swing") / "swing.h5"
    return lw.simulate(lw.mechanisms.four_bar(2), t_end=4.0, step=1e-3, record_every=40, output=output)


@pytest.fixture
def frame_by_frame(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each frame is a piece."""
    monkeypatch.setattr(poses, "STREAMED_NUMBERS", 1)


def fetched(url: str) -> bytes:
    content: bytes = urllib.request.urlopen(url, timeout=30).read()
    return content


def status(server: Server, path: str, host: str | None = None) -> int:
    """Of the answer to a path as it is."""
    own = server.url.split("/")[2]
    connection = http.client.HTTPConnection(own, timeout=30)
    connection.request("GET", path, headers={"Host": host or own})
    found = connection.getresponse().status
    connection.close()
    return found


def opened(tab: chromium.Page, server: Server) -> None:
    tab.requests.clear()
    tab.complaints.clear()
    tab.open(server.url)
    tab.drawn()


def pose(tab: chromium.Page) -> np.ndarray:
    """(n, 7) as it is shown."""
    return np.reshape(tab.evaluate("Array.from(linkwork.runs[0].pose)"), (-1, 7))[:-1]


def seek(tab: chromium.Page, t: float) -> None:
    tab.evaluate(f"linkwork.player.seek({float(t)!r})")
    tab.wait_for("!linkwork.player.behind")


# --- the server ---


@pytest.mark.parametrize("numbers", [1, 500, 10**6])
def test_pieces_are_all_poses_of_the_result(
    swing: lw.Result, numbers: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(poses, "STREAMED_NUMBERS", numbers)
    with swing.serve() as server:
        count = poses.pieces_of_stream(swing)
        whole = b"".join(fetched(f"{server.url}poses0-{number}") for number in range(count))
        assert status(server, f"/{server.url.split('/')[3]}/poses0-{count}") == 404
    np.testing.assert_array_equal(np.frombuffer(whole, "<f4"), swing.q.astype("<f4").ravel())


def test_nothing_is_given_out_but_to_who_knows_the_address(swing: lw.Result) -> None:
    with swing.serve() as server, swing.serve() as other:
        host, token = server.url.split("/")[2:4]
        assert host.startswith("127.0.0.1:")
        assert len(token) >= 20 and token != other.url.split("/")[3]
        assert status(server, f"/{token}/") == 200
        wrong = ["/", f"/{token}", f"/{token[:-1]}/", f"/{other.url.split('/')[3]}/", "/poses0-0"]
        outside = [f"/{token}/../../etc/passwd", f"/{token}/%2e%2e/setup.py", f"/{token}/run.h5"]
        beyond = [f"/{token}/poses1-0", f"/{token}/poses0--1", f"/{token}/poses0-{'9' * 30}"]
        assert {path: status(server, path) for path in [*wrong, *outside, *beyond]} == dict.fromkeys(
            [*wrong, *outside, *beyond], 404
        )
        assert status(server, f"/{token}/", host="linkwork.example") == 403


def test_it_ends_and_says_what_a_port_may_be(swing: lw.Result) -> None:
    with swing.serve() as server:
        taken = int(server.url.split("/")[2].split(":")[1])
        for port in (taken, -1, "8000"):
            with pytest.raises(lw.OptionError, match="0 takes a free one"):
                swing.serve(port=port)  # type: ignore[arg-type]
    with pytest.raises(urllib.error.URLError):
        fetched(server.url)


def test_a_file_that_another_run_has_replaced_is_told(tmp_path: Path) -> None:
    model = lw.mechanisms.pendulum()
    result = lw.simulate(model, t_end=0.1, step=1e-2, output=tmp_path / "run.h5")
    with result.serve() as server:
        lw.simulate(model, t_end=0.2, step=1e-2, output=tmp_path / "run.h5", overwrite=True)
        with pytest.raises(urllib.error.HTTPError) as caught:
            fetched(f"{server.url}poses0-0")
    assert caught.value.code == 410
    assert "was replaced by another run" in caught.value.read().decode()


def test_of_a_large_result_a_few_bodies_can_be_plotted_and_are_the_same(
    swing: lw.Result, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is not read as a whole is read in the places of those bodies."""
    everything = runs.document(swing, "", streamed=True)
    assert everything.facts["bodies"]["plotted"] == list(range(swing.header.body_count))
    monkeypatch.setattr(runs, "WHOLE_READ", 0)
    monkeypatch.setattr(runs, "FEW_FOLLOWED", 2)
    few = runs.document(swing, "", streamed=True).facts
    assert len(few["bodies"]["plotted"]) == len(few["joints"]["plotted"]) == 2
    assert few["frames"] == {"recorded": 101, "shown": 101, "every": 1}


@pytest.mark.parametrize("few", [0, 128])
def test_recorded_of_some_is_recorded_of_all_there(
    swing: lw.Result, few: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("linkwork.results.result.FEW_PLACES", few)
    monkeypatch.setattr("linkwork.results.result.READ_NUMBERS", 200)
    for places in ([3], [4, 0, 4, -1], []):
        for every in (1, 7):
            found = swing.recorded_of("q", places, every)
            np.testing.assert_array_equal(found, swing.q[::every][:, np.array(places, int)])
    with pytest.raises(lw.OptionError, match="every"):
        swing.recorded_of("q", [0], 0)
    with pytest.raises(lw.OptionError, match="field"):
        swing.recorded_of("energy", [0])


# --- the page ---


@browser
def test_the_page_shows_every_frame_and_keeps_a_few_pieces(
    tab: chromium.Page, swing: lw.Result, frame_by_frame: None
) -> None:
    with swing.serve() as server:
        opened(tab, server)
        for frame in (0, 100, 1, 99, 50, 7, 8, 60, 0):
            seek(tab, swing.t[frame])
            np.testing.assert_allclose(pose(tab), swing.q[frame], atol=1e-6)
        for frame in range(0, 101):
            tab.evaluate(f"linkwork.player.seek({float(swing.t[frame])!r})")
            tab.wait_for("!linkwork.player.behind")
            assert tab.evaluate("linkwork.runs[0].poses.out.size") <= 64
        asked = {url.removeprefix(server.url) for url in tab.requests}
        assert {"", *(f"poses0-{frame}" for frame in range(101))} == asked
        assert all(url.startswith(server.url) for url in tab.requests)
        facts = tab.evaluate("document.querySelector('.facts').textContent")
        assert "101 frames" in facts and "read as the time comes to them" in facts
        name = swing.body_names[1]
        lines = tab.evaluate(
            f"linkwork.runs[0].lines({{id: 'position'}}, {name!r}).map((it) => Array.from(it[1]))"
        )
        np.testing.assert_allclose(np.transpose(lines), swing.body(name).position, atol=1e-4)
    assert tab.complaints == []


@browser
def test_pieces_ahead_are_there_before_the_time_comes_to_them(
    tab: chromium.Page, swing: lw.Result, frame_by_frame: None
) -> None:
    with swing.serve() as server:
        opened(tab, server)
        seek(tab, swing.t[20])
        tab.wait_for("[21, 22, 23, 24, 25, 26, 27, 28].every((it) => linkwork.runs[0].poses.out.has(it))")
        assert not tab.evaluate("linkwork.runs[0].poses.out.has(29)")


@browser
def test_what_was_asked_for_is_given_up_when_the_time_goes_elsewhere(
    tab: chromium.Page, swing: lw.Result, frame_by_frame: None
) -> None:
    with swing.serve() as server:
        opened(tab, server)
        last = float(swing.t[-1])
        tab.evaluate(
            "(() => { for (let k = 0; k < 60; k++) linkwork.player.seek(((k * 37) % 60) * "
            f"{last / 60}); linkwork.player.seek({last}) }})()"
        )
        assert tab.evaluate("linkwork.runs[0].poses.coming.size") <= 3
        tab.wait_for("!linkwork.player.behind")
        np.testing.assert_allclose(pose(tab), swing.q[-1], atol=1e-6)
        assert tab.evaluate("linkwork.runs[0].poses.error") is None


@browser
def test_a_served_motion_plays_to_its_end(tab: chromium.Page, swing: lw.Result, frame_by_frame: None) -> None:
    with swing.serve() as server:
        opened(tab, server)
        tab.evaluate("(() => { linkwork.player.speed = 20; linkwork.player.play() })()")
        tab.wait_for("!linkwork.player.playing && !linkwork.player.behind")
        np.testing.assert_allclose(pose(tab), swing.q[-1], atol=1e-6)


@browser
def test_between_frames_a_body_turns_the_short_way(tab: chromium.Page, swing: lw.Result) -> None:
    """p and -p are the same pose, and a result may have either."""
    frames = {name: swing.recorded(name).copy() for name in swing.header.frame_shapes()}
    frames["q"][1::2, :, 3:] *= -1.0
    turned = lw.Result(frames, swing.header, swing.statistics)
    between = float(swing.t[10] + swing.t[11]) / 2
    middle = (swing.q[10] + swing.q[11]) / 2
    middle[:, 3:] /= np.linalg.norm(middle[:, 3:], axis=1, keepdims=True)
    with turned.serve() as server:
        opened(tab, server)
        seek(tab, between)
        np.testing.assert_allclose(pose(tab), middle, atol=1e-6)


@browser
def test_a_server_that_has_ended_is_told(tab: chromium.Page, swing: lw.Result, frame_by_frame: None) -> None:
    with swing.serve() as server:
        opened(tab, server)
    seek_last = "linkwork.player.seek(linkwork.player.end)"
    tab.evaluate(seek_last)
    tab.wait_for("document.querySelector('.now').textContent.includes('the server of this page has ended')")


@browser
def test_a_server_that_ends_within_an_answer_is_told(
    tab: chromium.Page, swing: lw.Result, frame_by_frame: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun, header = threading.Event(), BaseHTTPRequestHandler.send_header

    def longer(self: BaseHTTPRequestHandler, name: str, value: str) -> None:
        header(self, name, str(int(value) + 1) if name == "Content-Length" else value)
        begun.set()

    with swing.serve() as server:
        opened(tab, server)
        monkeypatch.setattr(BaseHTTPRequestHandler, "send_header", longer)
        tab.evaluate("linkwork.player.seek(linkwork.player.end)")
        assert begun.wait(30)
    tab.wait_for("document.querySelector('.now').textContent.includes('the server of this page has ended')")


@browser
def test_two_runs_are_served_one_over_the_other(
    tab: chromium.Page, swing: lw.Result, frame_by_frame: None
) -> None:
    coarse = lw.simulate(
        lw.mechanisms.four_bar(2), t_end=4.0, step=4e-3, record_every=10, on_inaccurate="pass"
    )
    with swing.serve(coarse, labels=["fine", "coarse"]) as server:
        opened(tab, server)
        seek(tab, coarse.t[60])
        second = np.reshape(tab.evaluate("Array.from(linkwork.runs[1].pose)"), (-1, 7))[:-1]
        np.testing.assert_allclose(second, coarse.q[60], atol=1e-6)


@browser
def test_a_served_page_says_what_it_leaves_out(tab: chromium.Page, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(runs, "WHOLE_READ", 1e6)
    chain = lw.simulate(lw.mechanisms.chain(3000), t_end=0.02, step=5e-3, on_inaccurate="pass")
    with chain.serve() as server:
        opened(tab, server)
        said = tab.evaluate("document.querySelector('.left-out').textContent")
    assert "plots of 100 of 3000 bodies, 100 of 3000 joints" in said
    assert "drawn: 3000 as dots" in said or "as lines" in said


# --- the command ---


def test_the_command_serves_until_ctrl_c(swing: lw.Result, tmp_path: Path) -> None:
    swing.save(tmp_path / "run.h5")
    command = [sys.executable, "-c", "from linkwork.cli import main; main()", "view"]
    process = subprocess.Popen(
        [*command, tmp_path / "run.h5", "--serve", "--no-open"], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    said = dict(process.stdout.readline().split(maxsplit=1) for _ in range(3))
    assert said["frames"].startswith("all 101")
    assert b'<main id="viewer">' in fetched(said["page"].strip())
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=30) == 0


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["run.h5", "--serve", "--html", "page.html"], "choose one"),
        (["run.h5", "--serve", "--limit", "5"], "--serve shows all frames"),
        (["run.h5", "--port", "8000"], "give --serve, too"),
        (["run.h5", "--no-open"], "give --serve, too"),
        (["four_bar", "--serve"], "a mechanism has none"),
    ],
)
def test_options_of_the_command_that_contradict_each_other(
    options: list[str], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["view", *options], debug=False) == 2
    assert said in capsys.readouterr().err


@pytest.mark.parametrize(
    ("limit", "said"), [("16", ""), ("0.01", "the page has 51 of 101 frames; --serve shows all")]
)
def test_the_command_says_that_a_page_leaves_frames_out(
    limit: str, said: str, swing: lw.Result, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    swing.save(tmp_path / "run.h5")
    command = ["view", str(tmp_path / "run.h5"), "--html", str(tmp_path / "page.html"), "--limit", limit]
    assert run(command, debug=False) == 0
    assert capsys.readouterr().err == (f"note: {said}\n" if said else "")
    shown = 51 if said else 101
    assert f'"frames":{{"recorded":101,"shown":{shown},' in (tmp_path / "page.html").read_text()
