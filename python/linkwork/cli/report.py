"""`linkwork report`: one page about a mechanism or a result file."""

from __future__ import annotations

from pathlib import Path

import click

import linkwork as lw
from linkwork.cli import base, shells
from linkwork.errors import nearest


@click.command(cls=base.Command)
@click.argument("subject", metavar="NAME|FILE", shell_complete=shells.names_of("mechanism", files=True))
@click.option(
    "--output", "-o", required=True, type=click.Path(), metavar="PAGE",
    help="Write the page there, such as report.html.",
)  # fmt: skip
@click.option("--t-end", type=base.Number(), metavar="S", help="End of the run of a mechanism [s].")
@click.option("--step", type=base.Number(), metavar="S", help="Its step [s].")
def report(subject: str, output: str, t_end: float | None, step: float | None) -> None:
    """Write a report: model, method, diagnostics, plots, viewer.

    One HTML file that needs no network, about a mechanism, run as it recommends, or about a result file.

    \b
    linkwork report four_bar -o report.html
    linkwork report run.h5 -o report.html
    """
    from linkwork.cli import output as out
    from linkwork.view.report import report as page_of

    out.check_writable(output, "page")
    page = page_of(_result(subject, {"t_end": t_end, "step": step}))
    page.save(output)
    out.print_pairs([("page", f"{output} ({len(page.html.encode()) / 1e6:.2f} MB)")])


def _result(subject: str, options: dict[str, float | None]) -> lw.Result:
    """Read, or simulated. UsageError: neither a mechanism nor a file, or options that a file cannot take."""
    from linkwork.cli.running import settings_of

    given = {name: value for name, value in options.items() if value is not None}
    if subject in lw.mechanisms.MECHANISMS or lw.mechanisms.is_model_file(subject):
        mechanism = lw.mechanisms.named(subject)
        model = mechanism.function()
        return lw.simulate(model, **settings_of(mechanism, given, model))
    if not Path(subject).exists():
        raise click.UsageError(
            f"'{subject}' is no file and no mechanism{nearest(subject, lw.mechanisms.MECHANISMS)}"
        )
    if given:
        names = " and ".join(f"--{name.replace('_', '-')}" for name in given)
        raise click.UsageError(f"{names} cannot be given: '{subject}' is a result file, its run is done")
    return lw.Result.load(subject)
