"""Completion at the tab key: by click, for bash, zsh and fish."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable

import click
from click import shell_completion
from click.shell_completion import CompletionItem

PROGRAM, VARIABLE = "linkwork", "_LINKWORK_COMPLETE"

#: Where zsh has not begun its completion yet.
ZSH_BEGINS = "(( $+functions[compdef] )) || { autoload -Uz compinit && compinit }\n"

Completion = Callable[[click.Context, click.Parameter, str], list[CompletionItem]]


def script(command: click.Command, shell: str) -> str:
    """What the shell has to read."""
    found = shell_completion.get_completion_class(shell)
    assert found is not None
    text: str = found(command, {}, PROGRAM, VARIABLE).source()
    return text.replace("#compdef linkwork\n", f"#compdef linkwork\n{ZSH_BEGINS}") if shell == "zsh" else text


def complete(command: click.Command) -> int:
    """The exit code of one answer to the shell, which asks through the environment."""
    return shell_completion.shell_complete(command, {}, PROGRAM, VARIABLE, os.environ[VARIABLE])


def names_of(option: str, *, files: bool = False) -> Completion | None:
    """Names that an option takes, or (`files`) a file; of a list the word after the last comma."""
    known = _KNOWN.get(option)
    return None if known is None else words(known, files=files)


def words(known: Callable[[], Iterable[str]], *, files: bool = False) -> Completion:
    """Those that are known."""

    def complete_name(context: click.Context, parameter: click.Parameter, word: str) -> list[CompletionItem]:
        before, comma, begun = word.rpartition(",")
        found = [CompletionItem(before + comma + name) for name in known() if name.startswith(begun)]
        return found or ([CompletionItem(word, type="file")] if files else [])

    return complete_name


def _integrators() -> Iterable[str]:
    from linkwork.integrators import METHODS

    return METHODS


def _mechanisms() -> Iterable[str]:
    from linkwork.mechanisms import MECHANISMS

    return MECHANISMS


def _problems() -> Iterable[str]:
    from linkwork.validation import PROBLEMS

    return PROBLEMS


def _choices(option: str) -> Callable[[], Iterable[str]]:
    def known() -> Iterable[str]:
        from linkwork.options import names

        return names()[option]

    return known


_KNOWN: dict[str, Callable[[], Iterable[str]]] = {
    "integrator": _integrators,
    **{axis: _choices(axis) for axis in ("formulation", "stabilization", "linear_solver")},
    "mechanism": _mechanisms,
    "problem": _problems,
}
