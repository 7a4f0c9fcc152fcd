"""Tables of measurements, made while the site is built: errors on reference problems, times of linear
solvers.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from docutils import nodes
from linkwork import benchmark, validation
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

if TYPE_CHECKING:
    from sphinx.application import Sphinx

log = logging.getLogger(__name__)

#: Of the table of solvers: mechanisms and how many bodies, where that can be chosen.
SUBJECTS = {"chain": 200, "binary_tree": 255, "net": 264, "four_bar": 81, "bricard": None}


class Validation(SphinxDirective):
    """`{validation}`: the errors on all reference problems."""

    def run(self) -> list[nodes.Node]:
        verdicts = list(validation.validate())
        for verdict in verdicts:
            if not verdict.passed:
                log.warning(
                    "%s: an error is larger than required", verdict.problem, location=self.get_location()
                )
        head = ("problem", "error of", "is", "may be")
        rows = [row for verdict in verdicts for row in _figures(verdict)]
        sources = [f"{verdict.problem}: {verdict.source}; {verdict.method}." for verdict in verdicts]
        return [_table(head, rows), _lines(sources), _machine()]


def _figures(verdict: Any) -> Iterator[tuple[str, ...]]:
    for number, figure in enumerate(verdict.figures):
        is_, may = (f"{value:.1e} {figure.unit}".strip() for value in (figure.error, figure.required))
        yield (verdict.problem if number == 0 else "", figure.quantity, is_, may)


class Solvers(SphinxDirective):
    """`{solvers}`: one right-hand side with reactions by every linear solver."""

    def run(self) -> list[nodes.Node]:
        from linkwork import _core

        solvers = [it.name for it in _core.linear_solvers() if it.available and it.name != "dense"]
        rows = []
        for name, most in SUBJECTS.items():
            subject = benchmark.Subject.of(name, most)
            found = benchmark.compare_solvers(subject, solvers, rounds=5)
            times = {
                it.solver: it.ns_per_body["whole"]
                for it in found.solvers
                if isinstance(it, benchmark.Measured)
            }
            bodies = subject.build().body_count
            own = times["block"]
            others = [
                f"{times[solver] / own:.1f}" if solver in times else ""
                for solver in solvers
                if solver != "block"
            ]
            rows.append((f"{name}, {bodies}", f"{own * bodies / 1e3:.1f}", *others))
        head = ("mechanism, bodies", "block, us", *(solver for solver in solvers if solver != "block"))
        return [_table(head, rows), _machine()]


def _machine() -> nodes.Node:
    facts = benchmark.machine()
    version, processor = facts["versions"]["linkwork"], f"{facts['cpu']}, {facts['instruction_set']}"
    text = f"linkwork {version}, {processor}, one thread, {facts['date'][:10]}"
    return nodes.paragraph("", "", nodes.emphasis("", text))


def _lines(texts: Iterable[str]) -> nodes.Node:
    return nodes.bullet_list("", *(nodes.list_item("", nodes.paragraph("", text)) for text in texts))


def _table(head: Iterable[str], rows: Iterable[Iterable[str]]) -> nodes.Node:
    head = list(head)
    group = nodes.tgroup("", *(nodes.colspec(colwidth=1) for _ in head), cols=len(head))
    group += nodes.thead("", _row(head))
    group += nodes.tbody("", *(_row(row) for row in rows))
    return nodes.table("", group)


def _row(cells: Iterable[str]) -> nodes.Node:
    return nodes.row("", *(nodes.entry("", nodes.paragraph("", cell)) for cell in cells))


def setup(app: Sphinx) -> Mapping[str, Any]:
    app.add_directive("validation", Validation)
    app.add_directive("solvers", Solvers)
    return {"parallel_read_safe": False}
