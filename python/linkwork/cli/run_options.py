"""The options of a run on the command line; their names are those of `linkwork.simulate`."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Literal, get_args, get_origin

import click

from linkwork.cli import base, shells
from linkwork.options import TABLE
from linkwork.options.types import described
from linkwork.running.simulation import simulate


class _Limits(click.ParamType):  # type: ignore[type-arg]  # generic in newer versions only
    """A number, or numbers by name."""

    name = "limits"

    def convert(self, value: Any, param: click.Parameter | None, context: click.Context | None) -> Any:
        try:
            if "=" not in str(value):
                return float(value)
            pairs = [word.partition("=") for word in value.split(",")]
            limits = {level.strip(): float(limit) for level, _, limit in pairs}
        except ValueError:
            self.fail(f"'{value}' is no limit; write 1e-8, or position=1e-8,velocity=1e-6", param, context)
        if len(limits) < len(pairs):
            self.fail(f"'{value}' gives one level two limits: give one of them", param, context)
        return limits


def _arguments() -> Iterator[click.Option]:
    """Of `simulate`, those that are a number, a name or yes and no, with the first sentence about each."""
    hints = {it.name: it.annotation for it in inspect.signature(simulate, eval_str=True).parameters.values()}
    descriptions = re.findall(r"^(\w+) +((?:\S.*\n)(?: .*\n)*)", inspect.getdoc(simulate) or "", re.MULTILINE)
    for name, text in descriptions:
        if name == "overwrite":  # it is --force of every command
            continue
        hint = hints.get(name)
        types = set(get_args(hint) or (hint,)) - {type(None)}
        names = [word for it in (hint, *types) if get_origin(it) is Literal for word in get_args(it)]
        kinds: tuple[type, ...] = (str,) if names else (bool, float, int)
        kind = next((kind for kind in kinds if names or {kind} == types), None)
        if kind is not None:
            listed = f": {', '.join(names)}" if names else ""
            yield _option(name, kind, " ".join(text.split()).partition(". ")[0] + listed, names)


def _option(name: str, kind: Any, text: str, names: Sequence[str] = ()) -> click.Option:
    flag = "--" + name.replace("_", "-")
    return click.Option(
        [f"{flag}/--no-{flag[2:]}" if kind is bool else flag, name],
        type={bool: None, float: base.Number()}.get(kind, kind),
        default=None,
        shell_complete=shells.words(lambda: names) if names else None,
        help=f"{text[:1].upper()}{text[1:]}.",
    )


_TYPES = {"name": str, "number": float, "whole": int, "limits": _Limits(), "switch": bool}


def _all() -> list[click.Option]:
    start = "Go on from the last frame of this result file, which is of the same mechanism, at its time"
    chosen = [_option(it.name, _TYPES[it.type], described(it), it.choices) for it in TABLE.values()]
    return [*_arguments(), *chosen, _option("start", click.Path(), start)]


def options(settings: Mapping[str, Any]) -> list[click.Option]:
    """The options; the mechanism's recommended `settings` are shown as their defaults."""
    found = _all()
    for option in found:
        if option.name in settings:
            option.help = f"{option.help}  [default: {settings[option.name]}]"
    return found


NAMES = tuple(str(option.name) for option in _all())


def outputs() -> list[click.Option]:
    """Where the results go."""
    return [
        click.Option(
            ["--output"],
            type=click.Path(),
            metavar="FILE",
            help="Write the result to this HDF5 file, while the run goes on.",
        ),
        click.Option(
            ["--plot"],
            type=click.Path(),
            metavar="FILE",
            help="Write a picture of the result (.png, .pdf, .svg).",
        ),
    ]
