"""`linkwork plot`, `movie` and `export`: what a result file has, for people and for other tools."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import click

from linkwork.cli import base, shells

__all__ = ["export", "movie", "plot"]


def _kinds() -> list[str]:
    from linkwork.plots.kinds import KINDS

    return [kind for kind in KINDS if kind != "forces"]  # files know no laws of forces


def _quantities() -> list[str]:
    from linkwork.results.tables import QUANTITIES

    return [*QUANTITIES, "coordinate"]  # files know no laws of forces


def _chosen(command: Any) -> Any:
    """Options that choose bodies and joints."""
    for what in ("joint", "body"):
        plural = {"joint": "joints", "body": "bodies"}[what]
        about = f"Only this {what}, by name; may be repeated."
        command = click.option(f"--{what}", plural, multiple=True, metavar="NAME", help=about)(command)
    return command


@click.command(cls=base.Command)
@click.argument("file", type=click.Path())
@click.option("--kind", default="overview", show_default=True, shell_complete=shells.words(_kinds),
              help="overview, energy, violation, positions, velocities, accelerations, coordinates, "
              "reactions, phase or step.")  # fmt: skip
@click.option("--output", "-o", type=click.Path(), metavar="PICTURE",
              help="A .png, .pdf or .svg; without it run.KIND.png beside run.h5.")  # fmt: skip
@_chosen
def plot(file: str, kind: str, output: str | None, bodies: tuple[str, ...], joints: tuple[str, ...]) -> None:
    """Draw a picture of a result file.

    \b
    linkwork plot run.h5
    linkwork plot run.h5 --kind reactions --joint 'motor pin' -o pin.pdf

    --force replaces a picture that is there.
    """
    import linkwork as lw
    from linkwork.arguments import one_of
    from linkwork.cli import output as out
    from linkwork.errors import OptionError
    from linkwork.plots import figures

    if kind == "forces":
        raise OptionError(
            "plot kind 'forces' needs the laws of forces, which no file has: in Python, of the result of a "
            'run, result.plot("forces.png", "forces")',
            code="no_model",
        )
    one_of(kind, _kinds(), "plot kind")
    target = output or str(Path(file).with_suffix(f".{kind}.png"))
    out.check_writable(target, "picture")
    figures.check_format(target)
    lw.Result.load(file).plot(target, kind, bodies=bodies, joints=joints)
    out.print_pairs([("picture", target)])


@click.command(cls=base.Command)
@click.argument("file", type=click.Path())
@click.option("--output", "-o", type=click.Path(), metavar="MOVIE",
              help="A .mp4 or .gif; without it run.mp4 beside run.h5.")  # fmt: skip
@click.option(
    "--seconds",
    type=base.Number(),
    metavar="S",
    help="That it lasts; without, as long as the motion, but between 2 and 20.",
)
@click.option("--size", type=(int, int), default=(960, 640), show_default=True, metavar="W H",
              help="Width and height in pixels, even numbers.")  # fmt: skip
@click.option("--frames-per-second", type=int, default=25, show_default=True, metavar="N",
              help="Of the movie, whatever was recorded; of a .gif at most 50.")  # fmt: skip
def movie(file: str, output: str | None, **options: Any) -> None:
    """Film the motion in a result file; no display is needed.

    \b
    linkwork movie run.h5
    linkwork movie run.h5 -o slow.gif --seconds 10

    .mp4 needs pip install 'linkwork[movie]', .gif nothing. --force replaces a movie that is there.
    """
    import linkwork as lw
    from linkwork.cli import output as out

    target = output or str(Path(file).with_suffix(".mp4"))
    out.check_writable(target, "movie")
    lw.Result.load(file).movie(target, **options)
    out.print_pairs([("movie", target)])


@click.command(cls=base.Command)
@click.argument("file", type=click.Path())
@click.option("--csv", "target", type=click.Path(), metavar="TABLE", is_flag=False, flag_value="",
              help="A table; without a name, or without --csv, run.csv beside run.h5.")  # fmt: skip
@click.option("--quantity", "quantities", multiple=True, metavar="NAME",
              shell_complete=shells.words(_quantities),
              help="Only this, such as position, reaction_force or coordinate; may be repeated.")  # fmt: skip
@_chosen
def export(file: str, target: str | None, **chosen: tuple[str, ...]) -> None:
    """Write what is in a result file as a table, a row a frame and a column a number.

    \b
    linkwork export run.h5 --csv
    linkwork export run.h5 --csv pin.csv --joint 'motor pin' --quantity reaction_force

    Columns are named like `crank.position.x [m]`; every digit is kept. --force replaces a table.
    """
    import linkwork as lw
    from linkwork.cli import output as out
    from linkwork.errors import OptionError
    from linkwork.running.progress import preparing

    target = target or str(Path(file).with_suffix(".csv"))
    out.check_writable(target, "table")
    result = lw.Result.load(file)
    if not len(result):
        raise OptionError("the result has no frames: there is nothing to export", code="empty")
    with preparing(None, f"writing {target}"):
        result.to_csv(target, **{what: names or None for what, names in chosen.items()},
                      overwrite=base.may_replace())  # fmt: skip
    with open(target, newline="", encoding="utf-8") as table:
        columns = len(next(csv.reader(table))) - 1  # beside the time
    out.print_pairs([("table", f"{target} ({len(result)} frames, {columns} columns)")])
