"""`linkwork view`: a result file as a page."""

from __future__ import annotations

import click

from linkwork.cli import base


@click.command(cls=base.Command)
@click.argument("file", type=click.Path())
@click.option(
    "--html",
    "page",
    type=click.Path(),
    metavar="PAGE",
    help="Write the page there instead of opening a browser.",
)
@click.option("--with", "other", type=click.Path(), metavar="FILE", help="A second run, laid over the first.")
@click.option(
    "--limit", type=click.FloatRange(min=0, min_open=True), default=16.0, show_default=True, metavar="MB",
    help="Most recorded data in the page; frames beyond are left out evenly.",
)  # fmt: skip
def view(file: str, page: str | None, other: str | None, limit: float) -> None:
    """Show the motion in a result file.

    One HTML file that needs no network: the mechanism, a time slider, plots of what was recorded.

    \b
    linkwork run four_bar --output run.h5
    linkwork view run.h5                            in the web browser
    linkwork view run.h5 --html run.html            as a file to send to others
    linkwork view run.h5 --with other.h5            two runs, one over the other
    """
    import linkwork as lw
    from linkwork.cli import output as out

    if page is not None:
        out.check_writable(page, "page")
    first = lw.Result.load(file)
    second = lw.Result.load(other) if other is not None else None
    shown = first.view(page, second, labels=[file, other or ""], limit=limit * 1e6)
    where = page if page is not None else str(shown.open())
    out.print_pairs([("page", f"{where} ({len(shown.html.encode()) / 1e6:.2f} MB)")])
