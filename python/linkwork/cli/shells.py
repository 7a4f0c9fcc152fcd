"""Completion at the tab key: by click, for bash, zsh and fish."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable

import click
from click import shell_completion
from click.shell_completion import CompletionItem

PROGRAM, VARIABLE = "linkwork", "_LINKWORK_COMPLETE"

Completion = Callable[[click.Context, click.Parameter, str], list[CompletionItem]]


def script(command: click.Command, shell: str) -> str:
    """What the shell has to read."""
    found = shell_completion.get_completion_class(shell)
    assert found is not None
    return found(command, {}, PROGRAM, VARIABLE).source()


def complete(command: click.Command) -> int:
    """The exit code of one answer to the shell, which asks through the environment."""
    return shell_completion.shell_complete(command, {}, PROGRAM, VARIABLE, os.environ[VARIABLE])


def names_of(option: str) -> Completion | None:
    """Names that an option takes; of a list the word after the last comma is completed."""
    known = _KNOWN.get(option)
    if known is None:
        return None

    def complete_name(context: click.Context, parameter: click.Parameter, word: str) -> list[CompletionItem]:
        before, comma, begun = word.rpartition(",")
        return [CompletionItem(before + comma + name) for name in known() if name.startswith(begun)]

    return complete_name


def _integrators() -> Iterable[str]:
    from linkwork.integrators import METHODS

    return METHODS


def _formulations() -> Iterable[str]:
    from linkwork import _core

    return [info.name for info in _core.formulations()]


def _stabilizations() -> Iterable[str]:
    from linkwork import _core

    return [info.name for info in _core.stabilizations()]


def _linear_solvers() -> Iterable[str]:
    from linkwork import _core

    return ["auto", *(info.name for info in _core.linear_solvers())]


_KNOWN: dict[str, Callable[[], Iterable[str]]] = {
    "integrator": _integrators,
    "formulation": _formulations,
    "stabilization": _stabilizations,
    "linear_solver": _linear_solvers,
}
