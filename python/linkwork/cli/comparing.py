"""`linkwork compare`: many methods on one mechanism, then the table."""

from __future__ import annotations

import json
import math
import os
import shutil
import sys
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from linkwork.cli import compare_options
from linkwork.cli import output as out

if TYPE_CHECKING:
    from linkwork.comparison import Comparison
    from linkwork.mechanisms import Mechanism


def compare_and_show(
    name: str,
    mechanism: Mechanism,
    parameters: Mapping[str, Any],
    error: float,
    html: str | None,
    csv: str | None,
    plot: str | None,
    as_json: bool,
    **values: Any,
) -> None:
    """Compare with the mechanism's recommended end and steps where none were given."""
    from linkwork.comparison import compare

    files = {"page": html, "table": csv, "picture": plot}
    for what, path in files.items():
        if path is not None:
            out.check_writable(path, what)
    if plot is not None:
        from linkwork.plots import figures

        figures.check_format(plot)
    given = _given(values, mechanism.settings)
    try:
        comparison = compare(mechanism.function(**parameters), **given)
    except KeyboardInterrupt as stop:
        kept = f"; '{given['resume']}' has the runs so far" if "resume" in given else ""
        raise type(stop)(f"interrupted{kept}") from stop
    if html is not None:
        comparison.to_html(html)
    if csv is not None:
        comparison.to_csv(csv, overwrite=True)
    if plot is not None:
        comparison.plot(path=plot)
    if as_json:
        document = json.loads(comparison.to_json())
        out.print_json({"mechanism": name, "parameters": dict(parameters), **document, "files": files,
                        "recommendation": comparison.recommend(error)})  # fmt: skip
    else:
        _print(comparison, error)
        out.print_pairs([(label, path or "") for label, path in files.items()])


def _given(values: Mapping[str, Any], settings: Mapping[str, Any]) -> dict[str, Any]:
    """The arguments of `compare` that were given, with the mechanism's end and steps where none were."""
    from linkwork.comparison.comparing import usual_steps

    given = {key: values[key] for key in compare_options.NAMES if values[key] is not None}
    if "t_end" in settings:
        given.setdefault("t_end", settings["t_end"])
    if "tolerances" not in given and "step" in settings:
        given.setdefault("steps", usual_steps(settings["step"], given.get("t_end", math.inf)))
    return given


def _print(comparison: Comparison, error: float) -> None:
    from linkwork.comparison import text

    width = shutil.get_terminal_size().columns if sys.stdout.isatty() or "COLUMNS" in os.environ else None
    print(text.table(comparison, width))
    print("\n" + "\n".join(text.notes(comparison)))
    print("\n" + comparison.recommend(error))
