"""README.md is true: its Python runs, its commands run, its tables name what there is."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import linkwork as lw
import pytest
from linkwork import _core
from linkwork.cli import run
from linkwork.integrators import METHODS

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text()


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", README, flags=re.DOTALL)


def test_python_runs_from_top_to_bottom(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    exec("\n".join(blocks("python")), {})
    assert lw.Result.load("motion.h5").t[-1] == pytest.approx(2.0)
    assert Path("motion.html").stat().st_size > 100_000


def test_commands_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    commands = [line for block in blocks("sh") for line in block.splitlines() if line.startswith("linkwork ")]
    assert len(commands) >= 4
    for command in commands:
        code = run(shlex.split(command, comments=True)[1:], debug=False)
        assert (code, capsys.readouterr().err) == (0, ""), command


def test_tables_name_every_choice_there_is() -> None:
    tables = set(re.findall(r"`([a-z_0-9]+)`", README)) | set(re.findall(r'="([a-z_0-9]+)"', README))
    for choices in (
        METHODS,
        *([c.name for c in f()] for f in (_core.formulations, _core.stabilizations, _core.linear_solvers)),
    ):
        assert set(choices) <= tables


def test_joint_of_the_readme_is_as_short_as_it_says() -> None:
    ((path, lines),) = re.findall(r"`(cpp/[^`]*\.cpp)` \((\d+) lines\)", README)
    assert (ROOT / path).read_text().count("\n") == int(lines)


def test_picture_exists_and_is_small() -> None:
    pictures = re.findall(r"!\[.*?\]\((.*?)\)", README)
    assert pictures
    for picture in pictures:
        most = 1_500_000 if picture.endswith(".gif") else 300_000
        assert 10_000 < (ROOT / picture).stat().st_size < most, picture


def test_readme_is_under_150_lines() -> None:
    assert README.count("\n") < 150
