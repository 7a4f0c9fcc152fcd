"""A report of a run: one HTML file with model, method, diagnostics, plots, viewer and manifest."""

from __future__ import annotations

import base64
import io
import json
from collections import Counter
from collections.abc import Iterable, Sequence
from html import escape
from importlib import resources
from string import Template
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork.errors import OptionError
from linkwork.motion import summary
from linkwork.plots import kinds
from linkwork.view.page import Page, view

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from linkwork.results.result import Result

#: Rows of a table; the rest is counted.
ROWS = 100

#: What is plotted, and under which heading.
PLOTS = {
    "energy": "Energy",
    "violation": "Violation of the constraints",
    "coordinates": "Coordinates",
    "reactions": "Reactions",
    "phase": "Phase portrait",
    "step": "Step size",
}


def report(result: Result, limit: float = 16e6) -> Page:
    """`limit` of the recorded numbers in the viewer [bytes]. OptionError: the result has no frames."""
    if not len(result):
        raise OptionError("the result has no frames: there is nothing to report", code="empty")
    manifest = result.manifest
    versions = manifest.get("versions", {})
    made = [f"linkwork {versions['linkwork']}" if "linkwork" in versions else "", manifest.get("started", "")]
    sections = {
        "Model": _model(result),
        "Method": _table(("", ""), _method(manifest)),
        "Diagnostics": _table(("", ""), summary.lines(result)[1:]) + _warnings(result),
        "Motion": view([result], limit=limit).frame(620),
        "Plots": _plots(result),
        "Manifest": _details("What is needed to run it again", json.dumps(manifest, indent=2, default=str)),
    }
    return Page(
        _template().substitute(
            title=escape(str(manifest.get("model") or "model").replace("_", " ")),
            subtitle=escape(", ".join(filter(None, made))),
            sections="\n".join(
                f"<section><h2>{name}</h2>\n{content}</section>" for name, content in sections.items()
            ),
        )
    )


# --- sections ----------------------------------------------------------------------------------------------


def _model(result: Result) -> str:
    header = result.header
    rank = header.row_count - len(header.redundant_rows)
    facts = [
        ("bodies", str(header.body_count)),
        ("joints", _counted(header.joint_kinds)),
        ("constraints", f"{header.row_count} equations of rank {rank}"),
        ("mobility", str(6 * header.body_count - rank)),
        ("redundant", _redundant(result)),
        ("gravity", f"({', '.join(f'{g:g}' for g in header.gravity)}) m/s²"),
        ("mass", f"{header.mass.sum():.6g} kg"),
    ]
    joints = _table(
        ("joint", "kind", "bodies", "equations", "redundant", "reaction"),
        (_joint(result, j) for j in range(min(header.joint_count, ROWS))),
        header.joint_count,
    )
    bodies = _table(
        ("body", "mass [kg]", "principal moments [kg m²]", "initial position [m]"),
        (_body(result, i) for i in range(min(header.body_count, ROWS))),
        header.body_count,
    )
    return f"{_table(('', ''), facts)}<h3>Bodies</h3>{bodies}<h3>Joints</h3>{joints}"


def _body(result: Result, i: int) -> tuple[str, ...]:
    header = result.header
    moments = np.linalg.eigvalsh(header.inertia[i])
    position = header.q0.reshape(-1, 7)[i, :3]
    return (header.body_names[i], f"{header.mass[i]:.6g}", _numbers(moments), _numbers(position))


def _joint(result: Result, j: int) -> tuple[str, ...]:
    header = result.header
    names = ["ground" if body < 0 else header.body_names[body] for body in header.joint_bodies[j]]
    first, last = header.joint_rows[j], header.joint_rows[j + 1]
    redundant = int(np.sum((header.redundant_rows >= first) & (header.redundant_rows < last)))
    unique = "follows from the motion" if header.reaction_unique[j] else "not unique: a share of least norm"
    kind = header.joint_kinds[j].replace("_", " ")
    return (header.joint_names[j], kind, " - ".join(names), str(last - first), str(redundant or ""), unique)


def _redundant(result: Result) -> str:
    header = result.header
    joints = np.unique(np.searchsorted(header.joint_rows, header.redundant_rows, side="right") - 1)
    if not len(joints):
        return "none"
    names = ", ".join(header.joint_names[j] for j in joints[:8]) + (", ..." if len(joints) > 8 else "")
    return f"{len(header.redundant_rows)} equations, in {names}: the others imply them"


def _method(manifest: dict[str, Any]) -> list[tuple[str, str]]:
    options = manifest.get("options", {})
    return [
        (name.replace("_", " "), f"{value:g}" if isinstance(value, float) else str(value))
        for name, value in options.items()
        if value is not None
    ]


def _warnings(result: Result) -> str:
    """What a reader has to know before believing the numbers."""
    found = []
    if not result.finished:
        found.append("The run did not finish: what is here ends where it stopped.")
    verdict = result.verdict
    if verdict is not None and verdict.level != "good":
        found.append(f"The run is {verdict.level}: {escape(verdict.sentence)}.")
    if not result.unique_reactions.all():
        count = int(np.sum(~result.unique_reactions))
        found.append(
            f"Reactions of {count} of {len(result.unique_reactions)} joints do not follow from the motion, "
            "as constraints are redundant: they are shares of least norm, and elastic bodies would share "
            "their loads otherwise."
        )
    if result.singular_poses:
        found.append("The run passed singular poses: the motion could have gone on in several ways there.")
    return "".join(f'<p class="warning">{text}</p>' for text in found)


def _plots(result: Result) -> str:
    figures = [
        f'<figure><figcaption>{heading}</figcaption><img alt="{heading}" src="{_png(figure)}"></figure>'
        for kind, heading in PLOTS.items()
        if (kind != "step" or result.manifest.get("options", {}).get("rtol"))  # fixed steps are one number
        and (figure := kinds.plot(result, kind=kind))
    ]
    return f'<div class="plots">{"".join(figures)}</div>'


def _template() -> Template:
    return Template(resources.files("linkwork.view").joinpath("report.html").read_text(encoding="utf-8"))


# --- pieces of HTML ----------------------------------------------------------------------------------------


def _table(columns: Sequence[str], rows: Iterable[Sequence[str]], total: int = 0) -> str:
    """Rows as text; a row with nothing to say is left out."""
    shown = [row for row in rows if any(row[1:])]
    head = "".join(f"<th>{escape(column)}</th>" for column in columns)
    lines = [f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in shown]
    more = f'<p class="muted">and {total - len(shown)} more</p>' if total > len(shown) else ""
    header = f"<thead><tr>{head}</tr></thead>" if any(columns) else ""
    return f'<div class="wide"><table>{header}<tbody>{"".join(lines)}</tbody></table></div>{more}'


def _details(title: str, text: str) -> str:
    return f"<details><summary>{escape(title)}</summary><pre>{escape(text)}</pre></details>"


def _png(figure: Figure) -> str:
    """As a data address."""
    figure.suptitle("")
    with io.BytesIO() as file:
        figure.savefig(file, format="png", dpi=100)
        return f"data:image/png;base64,{base64.b64encode(file.getvalue()).decode('ascii')}"


def _counted(kinds: Sequence[str]) -> str:
    counts = Counter(kinds)
    listed = ", ".join(f"{count} {kind.replace('_', ' ')}" for kind, count in sorted(counts.items()))
    return f"{len(kinds)}{': ' if listed else ''}{listed}"


def _numbers(values: Any) -> str:
    return ", ".join(f"{value + 0.0:.4g}" for value in values)
