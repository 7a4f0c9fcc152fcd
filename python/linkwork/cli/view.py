"""`linkwork view`: a result file, or a mechanism before it is simulated, as a page."""

from __future__ import annotations

import os

import click

from linkwork.cli import base, shells


@click.command(cls=base.Command)
@click.argument(
    "file", type=click.Path(), metavar="FILE|NAME", shell_complete=shells.names_of("mechanism", files=True)
)
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
    """Show the motion in a result file, or the initial pose of a mechanism.

    One HTML file that needs no network: the mechanism, a time slider, plots of what was recorded. Of a
    mechanism, by its name or from a file (.yaml, .json, .urdf, .sdf, .xml), the initial pose with joints,
    frames and names: joints that do not hold there are red.

    \b
    linkwork run four_bar --output run.h5
    linkwork view run.h5                            in the web browser
    linkwork view run.h5 --html run.html            as a file to send to others
    linkwork view run.h5 --with other.h5            two runs, one over the other
    linkwork view arm.urdf                          before anything is computed
    """
    import linkwork as lw
    from linkwork.cli import output as out
    from linkwork.mechanisms import is_file, is_model_file, named

    if page is not None:
        out.check_writable(page, "page")
    if is_model_file(file) or not (is_file(file) or os.path.exists(file)):
        if other is not None:
            raise click.UsageError("--with lays a second result file over a first, not over a mechanism")
        mechanism = named(file)
        model = mechanism.function(**{it.name: it.default for it in mechanism.parameters})
        shown = model.view(page)
    else:
        first = lw.Result.load(file)
        second = lw.Result.load(other) if other is not None else None
        shown = first.view(page, second, labels=[file, other or ""], limit=limit * 1e6)
    where = page if page is not None else str(shown.open())
    out.print_pairs([("page", f"{where} ({len(shown.html.encode()) / 1e6:.2f} MB)")])
