"""The page of a study in a browser: lines are cases; a click opens the motion with the bits of the run."""

from __future__ import annotations

import json
import re
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import chromium
import linkwork as lw
import numpy as np
import pytest

browser = pytest.mark.skipif(chromium.EXECUTABLE is None, reason="no Chromium: apt-get install chromium")

EVIL = "</script><img src=x onerror=alert(1)>"
RUN: dict[str, Any] = {"t_end": 0.05, "step": 5e-3, "processes": 1, "progress": False}


def light(result: lw.Result) -> float:
    mass = float(result.header.mass[0])
    if mass > 4.5:
        raise ValueError("too heavy")
    return mass


@pytest.fixture(scope="module")
def study() -> lw.Study:
    model = lw.mechanisms.pendulum()
    pairs = zip((1, 2, 3, 4, 5), (0, 3, 1, 2, 4), strict=True)
    parameters = [{"bob.mass": mass, "gravity[2]": -9.0 - more} for mass, more in pairs]
    return lw.sweep(model, parameters, {EVIL: light}, **RUN)


@pytest.fixture(scope="module")
def tab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[chromium.Page]:
    with chromium.browser(tmp_path_factory.mktemp("profile")) as page:
        yield page


def of(html: str) -> dict[str, Any]:
    found = re.search(r'<script id="study" type="application/json">(.*?)</script>', html, re.DOTALL)
    assert found is not None
    data: dict[str, Any] = json.loads(found[1])
    return data


def test_the_page_has_every_case(study: lw.Study, tmp_path: Path) -> None:
    data = of(study.view(tmp_path / "study.html").html)
    assert data["cases"] == [0, 1, 2, 3, 4] and data["status"] == [*["finished"] * 4, "failed"]
    assert [axis["label"].split("[")[0].strip() for axis in data["axes"]][-1] == EVIL
    assert data["axes"][-1]["values"] == [1.0, 2.0, 3.0, 4.0, None]
    assert EVIL not in (tmp_path / "study.html").read_text()


@browser
@pytest.mark.parametrize("width", [1280, 420])
def test_lines_axes_and_choices(tab: chromium.Page, study: lw.Study, tmp_path: Path, width: int) -> None:
    study.view(tmp_path / "study.html")
    tab.open(tmp_path / "study.html", width=width, height=800)
    assert all(url.startswith("file:") for url in tab.requests) and not tab.complaints
    assert tab.evaluate("document.querySelectorAll('svg line').length") == 3
    assert tab.evaluate("document.images.length") == 0
    tab.evaluate("brushes[0] = [1.5, 3.5]; draw()")
    assert "2 of 5 lines chosen" in tab.evaluate("document.getElementById('about').textContent")
    place = tab.evaluate("[x(0) + 1, y(0, 2)].map((it, k) => it + (k ? svg.getBoundingClientRect().top :"
                         " svg.getBoundingClientRect().left))")  # fmt: skip
    tab.click(*place)
    tab.drawn()
    said = tab.evaluate("document.getElementById('case').textContent")
    assert "case 1" in said and "study.simulate(1).view().open()" in said


def test_the_server_gives_the_page_and_motions(study: lw.Study) -> None:
    with study.serve() as server:
        assert server.url.startswith("http://127.0.0.1:")
        assert of(urllib.request.urlopen(server.url).read().decode()) == of(study.view().html)
        motion = urllib.request.urlopen(f"{server.url}motion/2").read().decode()
        runs, again = (re.search(r'id="runs"[^>]*>(.*?)</script>', it, re.DOTALL)
                       for it in (motion, study.simulate(2).view().html))  # fmt: skip
        assert runs is not None and again is not None and runs[1][:2000] == again[1][:2000]
        blocks = [re.search(r'id="block0"[^>]*>(.*?)</script>', it, re.DOTALL)[1]  # type: ignore[index]
                  for it in (motion, study.simulate(2).view().html)]  # fmt: skip
        assert blocks[0] == blocks[1]
        for path, status in (("motion/77", 500), ("motion/-1", 404), ("../etc/passwd", 404)):
            with pytest.raises(urllib.error.HTTPError) as refused:
                urllib.request.urlopen(server.url + path)
            assert refused.value.code == status
        for port in (int(server.url.split("/")[2].split(":")[1]), -1, "8000"):
            with pytest.raises(lw.OptionError, match="port"):
                study.serve(port)  # type: ignore[arg-type]
    with pytest.raises(urllib.error.URLError):
        urllib.request.urlopen(server.url, timeout=2)


def test_a_study_of_nothing_that_varies_has_no_page() -> None:
    study = lw.sweep(lw.mechanisms.pendulum(), {"gravity[2]": [-9.81]}, {"one": lambda result: 1.0}, **RUN)
    with pytest.raises(lw.OptionError, match="no parameter or output is a number that varies"):
        study.view()


def test_many_cases_are_thinned_and_it_says_so(study: lw.Study, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("linkwork.studies.page.LINES", 2)
    data = of(study.view().html)
    assert data["cases"] == [0, 3] and "one of 3 is drawn" in data["about"]
    assert np.allclose(data["axes"][0]["values"], [1.0, 4.0])


def test_nothing_is_given_out_but_to_who_knows_the_address(study: lw.Study) -> None:
    with study.serve() as server:
        host = server.url.split("/")[2]
        for path in ("", "motion/2", "wrong/", "wrong/motion/2"):
            with pytest.raises(urllib.error.HTTPError) as refused:
                urllib.request.urlopen(f"http://{host}/{path}")
            assert refused.value.code == 404
        elsewhere = urllib.request.Request(server.url, headers={"Host": "linkwork.example"})
        with pytest.raises(urllib.error.HTTPError) as refused:
            urllib.request.urlopen(elsewhere)
        assert refused.value.code == 403
