"""A comparison as one HTML page that asks nothing of the network: table, pictures as SVG, definitions."""

from __future__ import annotations

import io
import re
from html import escape
from typing import TYPE_CHECKING

from linkwork.comparison import text

if TYPE_CHECKING:
    from linkwork.comparison.table import Comparison

#: Captions of the pictures, by kind.
PICTURES = {
    "work_precision": "Error over time spent: the lower left is best.",
    "order": "Error over the step: the slope is the order of the method.",
    "violation": "Violation of the position constraints, each method at its smallest step.",
    "energy": "Energy that each method makes or loses, at its smallest step.",
    "error": "Growth of the state error, each method at its smallest step.",
}

#: Errors for which the page recommends a method.
RECOMMENDED = (1e-2, 1e-4, 1e-6)

STYLE = """
:root { color-scheme: light dark; --line: #8884; --faint: #8889; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 84rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; margin-bottom: 0; } h2 { font-size: 1.1rem; margin-top: 2.2rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { padding: .18rem .55rem; text-align: right; white-space: nowrap; }
th { vertical-align: bottom; font-weight: 600; border-bottom: 1px solid var(--faint); white-space: pre; }
td.text, th.text { text-align: left; }
tr.first td { border-top: 1px solid var(--line); }
tr.bad td { color: #b3261e; } @media (prefers-color-scheme: dark) { tr.bad td { color: #ff8a80; } }
figure { margin: 1.2rem 0; }
figure svg { max-width: 100%; height: auto; background: white; border-radius: 4px; }
figcaption, .quiet { color: GrayText; font-size: 13px; }
li { margin: .15rem 0; }
"""


def page(comparison: Comparison) -> str:
    """The whole document."""
    name = escape(str(comparison.manifest.get("model") or "model"))
    advice = "".join(f"<li>{escape(comparison.recommend(error))}</li>" for error in RECOMMENDED)
    notes = "".join(f"<li>{escape(note)}</li>" for note in text.notes(comparison))
    pictures = "".join(
        f"<figure>{_svg(comparison, kind)}<figcaption>{escape(caption)}</figcaption></figure>"
        for kind, caption in PICTURES.items()
    )
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>{name}: comparison of methods</title><style>{STYLE}</style></head><body>
<h1>{name}: comparison of methods</h1>
<p class="quiet">0 to {comparison.t_end:g} s, {len(comparison)} runs by linkwork; {_machine(comparison)}</p>
<h2>Which method?</h2><ul>{advice}</ul>
<h2>What was measured</h2>{table(comparison)}<ul class="quiet">{notes}</ul>
<h2>Pictures</h2>{pictures}
</body></html>
"""


#: Of the table in a notebook, whose own style would break its lines and headings.
CELL_STYLE = """
.linkwork-comparison { overflow-x: auto; }
.linkwork-comparison th, .linkwork-comparison td { padding: .18rem .55rem; }
.linkwork-comparison th, .linkwork-comparison td { text-align: right; white-space: pre; }
.linkwork-comparison th { vertical-align: bottom; }
.linkwork-comparison .text { text-align: left; }
.linkwork-comparison tr.bad td { color: #b3261e; }
"""


def cell(comparison: Comparison) -> str:
    """The table as a notebook shows it: a line for each run, as wide as it is, to be scrolled."""
    return f'<div class="linkwork-comparison"><style>{CELL_STYLE}</style>{table(comparison)}</div>'


def table(comparison: Comparison) -> str:
    """The table alone."""
    columns = text.COLUMNS
    head = "".join(f"<th{_kind(column)}>{escape(column.heading)}</th>" for column in columns)
    body = []
    for outcome, row in zip(comparison.outcomes, text.cells(comparison), strict=True):
        kinds = [*(["first"] if row[0] else []), *(["bad"] if outcome.verdict != "finished" else [])]
        reason = escape(outcome.reason or "; ".join(outcome.remarks), quote=True)
        said = "".join(
            f"<td{_kind(column)}>{escape(word)}</td>" for column, word in zip(columns, row, strict=True)
        )
        body.append(f'<tr class="{" ".join(kinds)}" title="{reason}">{said}</tr>')
    inside = f"<thead><tr>{head}</tr></thead><tbody>{''.join(body)}</tbody>"
    return f'<div class="scroll"><table>{inside}</table></div>'


def _kind(column: text.Column) -> str:
    return ' class="text"' if column.text else ""


def _svg(comparison: Comparison, kind: str) -> str:
    """Text as shapes and identifiers of its own, so that pictures on one page do not meet."""
    import matplotlib

    out = io.StringIO()
    with matplotlib.rc_context({"svg.fonttype": "path", "svg.hashsalt": kind}):
        comparison.plot(kind).savefig(out, format="svg", metadata={"Date": None, "Creator": None})
    found = re.search(r"<svg.*</svg>", out.getvalue(), re.DOTALL)
    assert found is not None
    svg = re.sub(r"<metadata>.*?</metadata>", "", found[0], flags=re.DOTALL)
    return re.sub(r'(id="|href="#|url\(#)', rf"\g<1>{kind}-", svg)


def _machine(comparison: Comparison) -> str:
    facts = comparison.manifest
    return escape(
        f"linkwork {facts['versions']['linkwork']}, {facts['cpu']}, {facts['processes']} processes at a time"
    )
