"""Commands whose errors name the nearest valid choice, and numbers that can be."""

from __future__ import annotations

import math
from typing import Any

import click

from linkwork.errors import nearest

#: Whether files that are there may be replaced.
_force = [False]


def replace_files(force: bool) -> None:
    """By what commands write from here on, or only new files."""
    _force[0] = force


def may_replace() -> bool:
    """Whether `--force` was given."""
    return _force[0]


class Number(click.types.FloatParamType):
    """A number, of which no digit is lost unseen: as in files, one that would become zero is none."""

    def convert(self, value: Any, param: click.Parameter | None, context: click.Context | None) -> float:
        number = float(super().convert(value, param, context))
        if isinstance(value, str) and number == 0:
            from linkwork.modeling.files.decimals import TOO_SMALL, Vanished, decimal

            if isinstance(decimal(value), Vanished):
                self.fail(f"{value} {TOO_SMALL}", param, context)
        return number


class Positive(Number):
    """A finite number above zero."""

    name = "number"

    def convert(self, value: Any, param: click.Parameter | None, context: click.Context | None) -> float:
        number = super().convert(value, param, context)
        if not (math.isfinite(number) and number > 0):
            self.fail(f"{value} must be a finite number, positive", param, context)
        return number


class Group(click.Group):
    """A group that answers an unknown subcommand with the nearest, a missing one with what is needed."""

    def __init__(self, *args: Any, what: str = "command", **kwargs: Any) -> None:
        kwargs.setdefault("no_args_is_help", False)
        super().__init__(*args, **kwargs)
        self.what = what
        self.command_class = Command

    def resolve_command(
        self, context: click.Context, words: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        name = words[0]
        known = self.list_commands(context)
        completing = context.resilient_parsing  # the line is not whole yet
        if name not in known and not name.startswith("-") and not completing:
            raise click.UsageError(f"no {self.what} '{name}'{nearest(name, known)}")
        return super().resolve_command(context, words)

    def parse_args(self, context: click.Context, words: list[str]) -> list[str]:
        if not words and not self.invoke_without_command and not context.resilient_parsing:
            raise click.UsageError(
                f"{context.info_name} needs a {self.what}: {', '.join(self.list_commands(context))}"
            )
        return with_nearest_option(self, context, words, super().parse_args)


class Command(click.Command):
    """A command whose unknown option is answered with the nearest."""

    def parse_args(self, context: click.Context, words: list[str]) -> list[str]:
        return with_nearest_option(self, context, words, super().parse_args)


def with_nearest_option(
    command: click.Command, context: click.Context, words: list[str], parse: Any
) -> list[str]:
    try:
        rest: list[str] = parse(context, words)
        return rest
    except click.NoSuchOption as error:
        options = [it for it in command.get_params(context) if isinstance(it, click.Option)]
        known = [name for option in options for name in option.opts]
        text = _no_option(error.option_name, known)
        if isinstance(command, Group) and not command.invoke_without_command and "nearest" not in text:
            needs = f"{context.info_name} needs that first"
            text = f"no option {error.option_name} before a {command.what}: {needs}"
        raise click.UsageError(text) from error


def _no_option(name: str, known: list[str]) -> str:
    from linkwork.options import RENAMED

    now = "--" + RENAMED.get(name.lstrip("-"), "").replace("_", "-")
    hint = f"; it is called {now} now" if now in known else nearest(name, known)
    return f"no option {name}{hint}"
