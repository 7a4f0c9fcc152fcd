"""The options of a comparison on the command line; lists are words between commas."""

from __future__ import annotations

from typing import Any

import click

from linkwork.cli import base, shells


class Words(click.ParamType):  # type: ignore[type-arg]  # generic in newer versions only
    """Words between commas."""

    name = "a,b,..."

    def convert(self, value: Any, param: click.Parameter | None, context: click.Context | None) -> Any:
        words = [word.strip() for word in str(value).split(",") if word.strip()]
        return words or self.fail("names nothing; write words with commas between", param, context)


class Numbers(Words):
    """Numbers between commas."""

    name = "1e-2,5e-3,..."

    def convert(self, value: Any, param: click.Parameter | None, context: click.Context | None) -> Any:
        words = super().convert(value, param, context)
        try:
            return [float(word) for word in words]
        except ValueError:
            self.fail(f"'{value}' is not a list of numbers such as 1e-2,5e-3", param, context)


#: name of the argument of `compare`, type, help
_OPTIONS: tuple[tuple[str, type | click.ParamType[Any], str], ...] = (
    ("t_end", base.Number(), "End of the simulated time [s]."),
    ("steps", Numbers(), "Fixed steps [s]; without them from the one that is recommended."),
    ("tolerances", Numbers(), "Relative tolerances: steps that follow them (bs32, dopri5, tsit5, dop853)."),
    ("formulations", Words(), "Such as standard,penalty,penalty:1e7,augmented_lagrangian."),
    ("stabilizations", Words(), "Such as none,projection,baumgarte:5:5,'baumgarte:1/h:sqrt(2)/h'."),
    ("integrators", Words(), "Such as rk4,dopri5,phem56."),
    ("linear_solvers", Words(), "Such as block,cholmod,umfpack."),
    ("reference", click.Path(), "Result file of a known solution; without it one is computed."),
    ("reference_error", base.Number(), "Its own error, as state errors are measured, where it is known."),
    ("processes", click.IntRange(min=1), "Runs at the same time; without it one a processor."),
    ("time_limit", base.Number(), "Of one run, wall time [s]."),
    ("on_inaccurate", str, "A run that estimates to be more than 1 % off: pass, warn or stop."),
    ("resume", click.Path(), "Folder that keeps every finished run, and from which a comparison goes on."),
)

NAMES = tuple(name for name, _, _ in _OPTIONS)


def options() -> list[click.Option]:
    """The axes of the grid, and where the results go."""
    return [
        *(click.Option(["--" + name.replace("_", "-"), name], type=kind, help=text,
                       shell_complete=shells.names_of(name.removesuffix("s")))
          for name, kind, text in _OPTIONS),
        click.Option(["--error"], type=base.Positive(), default=1e-3, show_default=True,
                     help="State error for which a method is recommended; 1 is the size of the motion."),
        click.Option(["--html"], type=click.Path(), metavar="FILE",
                     help="Write a page with table and pictures."),
        click.Option(["--csv"], type=click.Path(), metavar="FILE", help="Write the table."),
        click.Option(["--plot"], type=click.Path(), metavar="FILE",
                     help="Write the error over time spent (.png, .pdf, .svg)."),
    ]  # fmt: skip
