"""Help, completion and log of the command line: every command explains itself by an example that is true."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import click
import pytest
from linkwork.cli import run
from linkwork.cli.commands import MechanismGroup, linkwork

PROGRAM = f"{shlex.quote(sys.executable)} -c 'from linkwork.cli import main; main()'"


def commands(
    command: click.Command, words: tuple[str, ...]
) -> Iterator[tuple[tuple[str, ...], click.Command]]:
    """All of them, with the words that lead there; of mechanisms two."""
    yield words, command
    if isinstance(command, click.Group):
        context = click.Context(command, info_name=words[-1])
        names = command.list_commands(context)
        for name in names[:2] if isinstance(command, MechanismGroup) else names:
            found = command.get_command(context, name)
            assert found is not None
            yield from commands(found, (*words, name))


ALL = dict(commands(linkwork, ("linkwork",)))


def examples(command: click.Command) -> list[str]:
    """The lines of its help that are commands, without comments and redirections."""
    lines = [line.strip() for line in (command.help or "").splitlines()]
    return [re.split(r"  +| >", line)[0] for line in lines if line.startswith("linkwork ")]


@pytest.mark.parametrize("words", ALL, ids=" ".join)
def test_help_of_every_command_has_an_example_of_it(words: tuple[str, ...]) -> None:
    found = examples(ALL[words])
    assert found
    assert any(line.startswith(" ".join(words)) for line in found)


@pytest.mark.parametrize("example", sorted({line for command in ALL.values() for line in examples(command)}))
def test_example_is_a_line_that_the_command_accepts(example: str) -> None:
    """Parsed up to the values of all options; a mistake is a click.UsageError."""
    command: click.Command = linkwork
    words = shlex.split(example)[1:]
    parent: click.Context | None = None
    while isinstance(command, click.Group):
        parent = click.Context(command, info_name="linkwork", parent=parent)
        name = words.pop(0)
        found = command.get_command(parent, name)
        assert found is not None, name
        command = found
        if isinstance(command, click.Group) and not words:
            return
    if "--help" not in words:
        command.make_context(command.name, words, parent=parent)


@pytest.mark.parametrize("words", ALL, ids=" ".join)
def test_every_option_is_explained(words: tuple[str, ...]) -> None:
    for parameter in ALL[words].params:
        assert not isinstance(parameter, click.Option) or parameter.help, parameter.name


# --- completion ---


def completed(line: str, shell: str = "bash") -> list[str]:
    """What the program answers for a line whose last word is begun."""
    words = line.split(" ")
    environment = {**os.environ, "_LINKWORK_COMPLETE": f"{shell}_complete", "COMP_WORDS": line,
                   "COMP_CWORD": str(len(words) - 1)}  # fmt: skip
    done = subprocess.run(PROGRAM, shell=True, capture_output=True, text=True, env=environment, check=True)
    assert done.stderr == ""
    return [word.split(",", 1)[1] for word in done.stdout.splitlines()]


@pytest.mark.parametrize("line", [
    "linkwork view ru", "linkwork run ru", "linkwork run four_bar --output ru", "linkwork report ru",
    "linkwork compare four_bar --html ru", "linkwork view run.h5 --with ru", "linkwork convert ru",
])  # fmt: skip
def test_where_a_file_is_wanted_the_shell_completes_files(line: str) -> None:
    environment = {**os.environ, "_LINKWORK_COMPLETE": "bash_complete", "COMP_WORDS": line,
                   "COMP_CWORD": str(line.count(" "))}  # fmt: skip
    done = subprocess.run(PROGRAM, shell=True, capture_output=True, text=True, env=environment, check=True)
    assert done.stdout == "file,ru\n"


@pytest.mark.parametrize(("line", "answer"), [
    ("linkwork va", ["validate"]),
    ("linkwork run four", ["four_bar"]),
    ("linkwork run four_bar --rt", ["--rtol"]),
    ("linkwork run four_bar --integrator dop", ["dopri5", "dop853"]),
    ("linkwork compare four_bar --integrators rk4,phem", ["rk4,phem56"]),
    ("linkwork bench s", ["scaling", "step"]),
    ("linkwork report four", ["four_bar"]),
    ("linkwork validate heavy", ["heavy_top"]),
    ("linkwork run four_bar --on-s", ["--on-singular"]),
    ("linkwork run four_bar --on-singular w", ["warn"]),
])  # fmt: skip
def test_a_word_that_is_begun_is_completed(line: str, answer: list[str]) -> None:
    assert completed(line) == answer


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_script_is_accepted_by_its_shell(shell: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["completion", shell], debug=False) == 0
    script = capsys.readouterr().out
    assert "_LINKWORK_COMPLETE" in script
    program = shutil.which(shell)
    if program is None:
        pytest.skip(f"{shell} is not installed")
    subprocess.run([program, "-n"], input=script, text=True, check=True)


def test_bash_completes_at_the_tab_key(tmp_path: Path) -> None:
    """As bash does: the function that the script registers fills COMPREPLY."""
    text = """
eval "$(linkwork completion bash)"
COMP_WORDS=(linkwork check bri) COMP_CWORD=2
$(complete -p linkwork | sed 's/.*-F \\([^ ]*\\) .*/\\1/') linkwork bri check
echo "${COMPREPLY[@]}"
"""
    done = subprocess.run(["bash", "-c", text], capture_output=True, text=True, env=with_program(tmp_path))
    assert done.stdout.split() == ["bricard"], done.stderr


def with_program(folder: Path) -> dict[str, str]:
    """The environment of a shell that finds `linkwork` in that folder."""
    program = folder / "linkwork"
    program.write_text(f'#!/bin/sh\nexec {PROGRAM} "$@"\n')
    program.chmod(0o755)
    return {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", "HOME": str(folder), "TERM": "dumb"}


@pytest.mark.skipif(shutil.which("fish") is None, reason="fish is not installed")
def test_fish_completes_at_the_tab_key(tmp_path: Path) -> None:
    text = 'linkwork completion fish | source; complete -C "linkwork check bri"'
    done = subprocess.run(["fish", "-c", text], capture_output=True, text=True, env=with_program(tmp_path))
    assert done.stdout.split("\t")[0].strip() == "bricard", done.stderr


@pytest.mark.skipif(shutil.which("zsh") is None, reason="zsh is not installed")
def test_zsh_without_a_completion_of_its_own_takes_the_script(tmp_path: Path) -> None:
    text = 'eval "$(linkwork completion zsh)"; print $_comps[linkwork]'
    done = subprocess.run(
        ["zsh", "-f", "-c", text], capture_output=True, text=True, env=with_program(tmp_path), cwd=tmp_path
    )
    assert (done.stdout, done.stderr) == ("_linkwork_completion\n", "")


# --- log ---


def test_log_has_what_was_run_and_what_went_wrong(tmp_path: Path) -> None:
    log = tmp_path / "run.log"
    for step in ("1e-3", "-1"):
        words = ["--log", str(log), "run", "pendulum", "--t-end", "0.01", "--step", step]
        subprocess.run(f"{PROGRAM} {shlex.join(words)}", shell=True, capture_output=True)
    began, ended, failed = log.read_text().splitlines()
    assert " INFO linkwork.running.simulation: pendulum: 1 body, " in began
    assert "done, 10 steps" in ended
    assert " ERROR linkwork.cli: step -1.0 s must be" in failed


def test_log_that_cannot_be_written_is_told_before_the_run(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["--log", "/nowhere/run.log", "run", "pendulum"], debug=False) == 1
    assert capsys.readouterr().err.startswith("error: log '/nowhere/run.log': cannot be written: no such")
