"""`linkwork view`: a result file, or a mechanism before it is simulated, as a page."""

from __future__ import annotations

import os
import sys
import webbrowser
from typing import TYPE_CHECKING

import click

from linkwork.cli import base, shells
from linkwork.running.interrupts import Terminated

if TYPE_CHECKING:
    from linkwork.results.result import Result
    from linkwork.view import Page


#: Of recorded data in a page [MB].
LIMIT = 16.0


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
    "--limit", type=base.Positive(), metavar="MB",
    help=f"Most recorded data in the page; frames beyond are left out evenly.  [default: {LIMIT:g}]",
)  # fmt: skip
@click.option("--serve", is_flag=True, help="Show all frames, by a server on this machine that ctrl-C ends.")
@click.option(
    "--port", type=click.IntRange(0, 65535), metavar="PORT", help="Of the server.  [default: a free one]"
)
@click.option("--open/--no-open", "opens", default=True, help="Whether the server opens a browser.")
def view(
    file: str, page: str | None, other: str | None, limit: float | None, serve: bool, port: int | None,
    opens: bool,
) -> None:  # fmt: skip
    """Show the motion in a result file, or the initial pose of a mechanism.

    One HTML file that needs no network: the mechanism, a time slider, plots of what was recorded. Of a
    mechanism, by its name or from a file (.yaml, .json, .urdf, .sdf, .xml), the initial pose with joints,
    frames and names: joints that do not hold there are red.

    \b
    linkwork run four_bar --output run.h5
    linkwork view run.h5                            in the web browser
    linkwork view run.h5 --html run.html            as a file to send to others
    linkwork view run.h5 --with other.h5            two runs, one over the other
    linkwork view run.h5 --serve                    all frames of a large run, as they are needed
    linkwork view arm.urdf                          before anything is computed
    """
    import linkwork as lw
    from linkwork.cli import output as out
    from linkwork.mechanisms import is_file, is_model_file

    _check_served(serve, page, limit, port, opens)
    if page is not None:
        out.check_writable(page, "page")
    if is_model_file(file) or not (is_file(file) or os.path.exists(file)):
        if other is not None:
            raise click.UsageError("--with lays a second result file over a first, not over a mechanism")
        if serve:
            raise click.UsageError("--serve gives out the frames of a result file; a mechanism has none")
        shown = _pose(file, page)
    else:
        first = lw.Result.load(file)
        second = lw.Result.load(other) if other is not None else None
        labels = [file] if other is None else [file, other]
        if serve:
            _serve(first, second, labels, port or 0, opens)
            return
        most = (LIMIT if limit is None else limit) * 1e6
        shown = first.view(page, second, labels=labels, limit=most)
        _say_left_out(first, most / (1 if second is None else 2))
    where = page if page is not None else str(shown.open())
    out.print_pairs([("page", f"{where} ({len(shown.html.encode()) / 1e6:.2f} MB)")])


def _say_left_out(result: Result, limit: float) -> None:
    """Of frames, of which a page of `limit` [bytes] may not have all."""
    from linkwork.cli import output as out
    from linkwork.view.run import every_frame

    if (every := every_frame(result, limit)) > 1:
        shown = -(-(len(result) - 1) // every) + 1
        out.note(f"the page has {shown} of {len(result)} frames; --serve shows all")


def _pose(name: str, page: str | None) -> Page:
    """The initial pose of a mechanism with its default parameters."""
    from linkwork.mechanisms import named

    mechanism = named(name)
    return mechanism.function(**{it.name: it.default for it in mechanism.parameters}).view(page)


def _check_served(serve: bool, page: str | None, limit: float | None, port: int | None, opens: bool) -> None:
    """UsageError: options that contradict each other."""
    if serve and page is not None:
        raise click.UsageError("--serve shows a page that needs its server, --html writes one: choose one")
    if serve and limit is not None:
        raise click.UsageError("--limit is of a page; --serve shows all frames: leave one of them out")
    if not serve and (port is not None or not opens):
        raise click.UsageError("--port and --no-open are for the server: give --serve, too")


def _serve(first: Result, second: Result | None, labels: list[str], port: int, opens: bool) -> None:
    """Until ctrl-C, which is how it ends."""
    from linkwork.cli import output as out

    with first.serve(second, labels=labels, port=port) as server:
        frames = max(len(first), len(second) if second is not None else 0)
        try:
            out.print_pairs([("page", server.url), ("frames", f"all {frames}, read as they are asked for"),
                             ("end", "ctrl-C")])  # fmt: skip
            sys.stdout.flush()  # before the end, also into a pipe
            if opens:
                webbrowser.open(server.url)
            server.wait()
        except KeyboardInterrupt as stop:
            if isinstance(stop, Terminated):
                raise
