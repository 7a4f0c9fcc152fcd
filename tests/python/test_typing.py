"""What users write is clean for type checkers: README's tutorial, and a script of every method of Model."""

from __future__ import annotations

import inspect
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import linkwork as lw
import pytest

ROOT = Path(__file__).parents[2]
SCRIPT = Path(__file__).parent / "typed/every_method.py"

#: Takes the address of a compiled function, see its own tests.
ELSEWHERE = {"compiled_force"}


@pytest.fixture(scope="module")
def scripts(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """The files that are checked, outside of the project and its settings."""
    folder = tmp_path_factory.mktemp("typed")
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), flags=re.DOTALL)
    (folder / "tutorial.py").write_text("\n".join(blocks))
    (folder / "every_method.py").write_text(SCRIPT.read_text())
    return [str(folder / name) for name in ("tutorial.py", "every_method.py")]


def test_the_script_calls_every_method_of_a_model_and_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    public = [name for name in dir(lw.Model) if not name.startswith("_")]
    text = SCRIPT.read_text()
    is_method = {name: inspect.isroutine(inspect.getattr_static(lw.Model, name)) for name in public}
    missing = [
        name for name in public
        if not re.search(rf"\.{name}\(" if is_method[name] else rf"model\.{name}\b", text)
    ]  # fmt: skip
    assert set(missing) == ELSEWHERE
    monkeypatch.chdir(tmp_path)
    exec(compile(text, str(SCRIPT), "exec"), {})


#: What no type checker may take.
WRONG = ('model.body("a", mass="heavy", inertia=(1, 1, 1))', "model.revolute(1.5, 2.5, at=0, axis=0)",
         'model.spherical("a", "b")', "model.table('wheels')")  # fmt: skip


def test_mypy_in_strict_mode_complains_of_what_is_wrong_and_of_nothing_else(
    scripts: list[str], tmp_path: Path
) -> None:
    mypy = pytest.importorskip("mypy.api")
    wrong = tmp_path / "wrong.py"
    wrong.write_text("\n".join(["import linkwork as lw", "model = lw.Model()", *WRONG]))
    cache = Path(tempfile.gettempdir()) / "linkwork-mypy-cache"
    told, failed, _ = mypy.run(["--strict", "--config-file=", f"--cache-dir={cache}", *scripts, str(wrong)])
    assert failed == ""
    lines = [line for line in told.splitlines() if ": error:" in line]
    places = {tuple(line.split(":")[:2]) for line in lines}
    assert {(Path(file).name, int(line)) for file, line in places} == {("wrong.py", 3 + k) for k in range(4)}


def test_pyright_has_nothing_to_say(scripts: list[str], tmp_path: Path) -> None:
    pytest.importorskip("pyright")
    pyright = [sys.executable, "-m", "pyright"]
    try:
        there = subprocess.run([*pyright, "--version"], capture_output=True, text=True, timeout=120)
    except subprocess.TimeoutExpired:
        pytest.skip("pyright cannot be had here")
    if there.returncode:
        pytest.skip(f"pyright cannot be had here: {there.stderr.strip()[-200:]}")
    command = [*pyright, "--pythonpath", sys.executable, *scripts]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0 and "0 errors" in done.stdout, done.stdout
