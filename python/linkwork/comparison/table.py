"""What a comparison found: a table, its orders, a recommendation, files and pictures."""

from __future__ import annotations

import csv
import io
import json
import math
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn, overload

from linkwork.arguments import check_new, check_suffix, optional_package
from linkwork.comparison.order import OrderStudy
from linkwork.comparison.reference import Reference
from linkwork.comparison.runs import ERRORS, Outcome
from linkwork.errors import OptionError, nearest
from linkwork.replacement import replacing

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

__all__ = ["ERRORS", "ORDERS", "Comparison"]

#: The observed orders of a cell: between it and the next larger step of the same method.
ORDERS = {error: error.replace("error", "order") for error in ERRORS}

#: An error less than so many times that of the reference says nothing about the order.
ABOVE_REFERENCE = 3.0

#: By which the cheapest can be chosen.
COSTS = {"seconds": "s", "evaluations": "evaluations", "factorizations": "factorizations"}


@dataclass(frozen=True)
class Comparison:
    """Cells in the order of the grid: each method from its largest step to its smallest.

    `print(comparison)` shows the table; `linkwork.accuracy.measures` defines the errors.
    """

    outcomes: Sequence[Outcome]
    reference: Reference
    t_end: float
    manifest: Mapping[str, Any]  #: versions, machine, name and hash of the model
    studies: Sequence[OrderStudy] = ()

    def __len__(self) -> int:
        return len(self.outcomes)

    def __iter__(self) -> Iterator[Outcome]:
        return iter(self.outcomes)

    @property
    def methods(self) -> dict[str, list[Outcome]]:
        """The cells of each method, by `Outcome.method`."""
        found: dict[str, list[Outcome]] = {}
        for outcome in self.outcomes:
            found.setdefault(outcome.method, []).append(outcome)
        return found

    def rows(self) -> list[dict[str, Any]]:
        """
        The table: the figures of each cell, and its observed orders.

            fewest = min(comparison.rows(), key=lambda row: row["evaluations"])
        """
        orders, noise = self._orders(), self._noise()
        asymptotic = self.orders()
        return [
            {
                **it.figures(),
                **orders[place],
                "asymptotic_order": asymptotic[it.label] if it.step else None,
                "cost": self.cost(it),
                "noise": noise[place],
            }
            for place, it in enumerate(self.outcomes)
        ]

    def orders(self, error: str = "pose_error") -> dict[str, float | None]:
        """The order of each method as steps go to zero, by label; None where nothing shows it.

            for label, order in comparison.orders("velocity_error").items():
                print(label, order)

        Observed early in the motion and with smaller steps than those of the table, see
        linkwork.comparison.order. OptionError: no such error.
        """
        _check_name(error, ERRORS, "error")
        found: dict[str, float | None] = dict.fromkeys(it.label for it in self.outcomes)
        return found | {study.label: study.order(error) for study in self.studies}

    @property
    def work(self) -> NoReturn:
        """AttributeError: the former name of `cost`."""
        raise AttributeError("'work' is called 'cost' now: ask for that")

    def cost(self, outcome: Outcome) -> float | None:
        """Time that a cell takes [s]: its evaluations by the least time of one in any cell of its method.

            seconds = [comparison.cost(outcome) for outcome in comparison.outcomes]

        The wall time of a short run says as much about the moment as about the method; evaluations are
        counted, and the more steps of a method there are, the more of them.
        """
        cells = [it for it in self.methods[outcome.method] if it.evaluations and it.seconds is not None]
        if not cells or not outcome.evaluations:
            return outcome.seconds
        return outcome.evaluations * min(float(it.seconds or 0.0) / (it.evaluations or 1) for it in cells)

    def known_error(self, outcome: Outcome, error: str) -> float | None:
        """
        No smaller than that of the reference, which cannot tell smaller ones apart.

            error = comparison.known_error(comparison.outcomes[0], "pose_error")
        """
        value = getattr(outcome, error)
        own = (self.reference.error or {}).get(error, 0.0)
        return None if value is None else max(float(value), 0.0 if math.isnan(own) else own)

    def is_noise(self, outcome: Outcome, error: str) -> bool:
        """
        Whether the error is within ABOVE_REFERENCE times the reference's own: no order follows from it.

            noise = [it.label for it in comparison.outcomes if comparison.is_noise(it, "pose_error")]
        """
        value = getattr(outcome, error)
        return value is not None and self.reference.error is not None and value <= self._floor(error)

    def recommend(self, error: float = 1e-3, of: str = "state_error", by: str = "seconds") -> str:
        """One sentence: the cheapest of these cells whose error is no larger, from the measured table.

            print(comparison.recommend(error=1e-3, by="evaluations"))

        of  "state_error", "pose_error", "velocity_error" or "reaction_error"
        by  "seconds" (see `cost`), "evaluations" or "factorizations"

        Errors below that of the reference count as equal to it. OptionError: a name that does not exist.
        """
        _check_name(of, ERRORS, "of")
        _check_name(by, COSTS, "by")
        what = of.replace("_", " ")
        measured = [it for it in self.outcomes if it.status == "finished" and getattr(it, of) is not None]
        if not measured:
            return f"No cell has a {what}: {self._why_none(of)}."
        meeting = [it for it in measured if (self.known_error(it, of) or 0.0) <= error]
        if not meeting:
            return self._none_meets(measured, error, of, by)
        best = min(meeting, key=lambda it: (self._cost(it, by), self.known_error(it, of)))
        spent = self._cost(best, by)
        cost = f"{spent:.3g} s" if by == "seconds" else f"{int(spent):,} {COSTS[by]}"
        doubt = "" if self.reference.error else ", if the reference is that good: its own error is not stated"
        if self.reference.error is not None and self.reference.error[of] > error / ABOVE_REFERENCE:
            doubt = f", though the reference itself is only known to {self.reference.error[of]:.1g}"
        return (f"The cheapest of {len(meeting)} cells that meet a {what} of {error:.2g} is {best.label} "
                f"with {_with(best)}: {self.known_error(best, of):.2g} in {cost}{doubt}.")  # fmt: skip

    def _none_meets(self, measured: Sequence[Outcome], error: float, of: str, by: str) -> str:
        """The best of all, or of those that the reference cannot tell apart the cheapest."""
        noise = [it for it in measured if self.is_noise(it, of)]
        best = min(noise, key=lambda it: self._cost(it, by)) if noise else min(
            measured, key=lambda it: (self.known_error(it, of), self._cost(it, by))
        )  # fmt: skip
        what, own = of.replace("_", " "), (self.reference.error or {}).get(of, 0.0)
        if own > error and self.is_noise(best, of):
            return (
                f"No cell can be shown to meet a {what} of {error:.2g}: the reference itself is only known "
                f"to {own:.1g}, which {best.label} with {_with(best)} meets."
            )
        return (
            f"No cell meets a {what} of {error:.2g}: the smallest is {self.known_error(best, of):.2g}, by "
            f"{best.label} with {_with(best)}; try smaller steps."
        )

    def _cost(self, outcome: Outcome, by: str) -> float:
        return float((self.cost(outcome) if by == "seconds" else getattr(outcome, by)) or 0.0)

    # --- as text, table, files ---

    def __str__(self) -> str:
        from linkwork.comparison import text

        return text.whole(self)

    def __repr__(self) -> str:
        done = sum(it.status == "finished" for it in self.outcomes)
        return (
            f"<Comparison of {self.manifest.get('model') or 'model'}: {done} of {len(self)} cells finished>"
        )

    def _repr_html_(self) -> str:
        from linkwork.comparison import page

        return page.cell(self)

    def to_frame(self) -> pandas.DataFrame:
        """The table as a pandas.DataFrame.

            comparison.to_frame().sort_values("evaluations")

        OptionError: pandas is not installed; `rows` needs nothing.
        """
        package = optional_package("pandas", "pandas", "to_frame", instead="rows() needs nothing")
        found: pandas.DataFrame = package.DataFrame(self._flat_rows())
        return found

    @overload
    def to_csv(self, path: None = None, *, overwrite: bool = False) -> str: ...

    @overload
    def to_csv(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None: ...

    def to_csv(self, path: str | os.PathLike[str] | None = None, *, overwrite: bool = False) -> str | None:
        """
        The table as CSV: to `path`, or returned where none is given.

            comparison.to_csv("methods.csv")

        overwrite  whether it may replace a file

        FileError: there is a file, it has another suffix, or cannot be written.
        """
        target = None if path is None else check_new(path, "table", overwrite)
        out = io.StringIO()
        rows = self._flat_rows()
        writer = csv.DictWriter(out, list(rows[0]) if rows else [], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
        return _written(out.getvalue(), target)

    @overload
    def to_json(self, path: None = None, *, overwrite: bool = False) -> str: ...

    @overload
    def to_json(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None: ...

    def to_json(self, path: str | os.PathLike[str] | None = None, *, overwrite: bool = False) -> str | None:
        """
        Everything, the curves over time too, as JSON: to `path`, or returned where none is given.

            comparison.to_json("methods.json")

        overwrite  whether it may replace a file

        FileError: there is a file, it has another suffix, or cannot be written.
        """
        target = None if path is None else check_new(path, "comparison", overwrite)
        document = {**self.document(), "cells": [
            {**row, "curves": it.curves and asdict(it.curves)}
            for row, it in zip(self.rows(), self.outcomes, strict=True)
        ]}  # fmt: skip
        return _written(json.dumps(_plain(document), indent=1, allow_nan=False) + "\n", target)

    @overload
    def to_html(self, path: None = None) -> str: ...

    @overload
    def to_html(self, path: str | os.PathLike[str]) -> None: ...

    def to_html(self, path: str | os.PathLike[str] | None = None) -> str | None:
        """
        A page that needs nothing but a browser: table, pictures, definitions; to `path`, or returned where
        none is given.

            comparison.to_html("methods.html")

        FileError: `path` has another suffix, or cannot be written. A page that is there is replaced.
        """
        from linkwork.comparison import page

        return _written(page.page(self), None if path is None else check_suffix(path, "page"))

    def plot(self, kind: str = "work_precision", path: str | os.PathLike[str] | None = None) -> Figure:
        """A picture, also written to `path`: "work_precision", "order", "violation", "energy" or "error".

            comparison.plot("work_precision", "methods.png")

        OptionError: no such kind. FileError: `path` cannot be written, or is the name of a kind. A picture
        that is there is replaced.
        """
        from linkwork.comparison import plots

        return plots.plot(self, kind, path)

    def document(self) -> dict[str, Any]:
        """
        The table and what it rests on, as data.

            cells = comparison.document()["cells"]
        """
        return {
            "model": self.manifest.get("model"),
            "t_end": self.t_end,
            "reference": {
                "description": self.reference.description,
                "error": self.reference.error,
                "scales": self.reference.scales.numbers(),
                "steps": self.reference.steps,
                "seconds": self.reference.seconds,
                "unique_joints": list(self.reference.unique_joints),
                "joints": self.reference.joint_count,
            },
            "cells": self.rows(),
            "order_studies": [asdict(study) for study in self.studies],
            "manifest": dict(self.manifest),
        }

    # --- how it works ---

    def _orders(self) -> list[dict[str, float | None]]:
        found: list[dict[str, float | None]] = [dict.fromkeys(ORDERS.values()) for _ in self.outcomes]
        places = {id(it): place for place, it in enumerate(self.outcomes)}
        for cells in self.methods.values():
            for coarse, fine in pairwise(_stepped(cells)):
                found[places[id(fine)]] = {
                    name: self._order(coarse, fine, error) for error, name in ORDERS.items()
                }
        return found

    def _noise(self) -> list[list[str]]:
        """The errors of each cell from which no order follows: noise, also what smaller steps make of it."""
        found: list[list[str]] = [[e for e in ERRORS if self.is_noise(it, e)] for it in self.outcomes]
        places = {id(it): place for place, it in enumerate(self.outcomes)}
        for cells in self.methods.values():
            for coarse, fine in pairwise(_stepped(cells)):
                before, own = found[places[id(coarse)]], found[places[id(fine)]]
                own += [error for error in before if error not in own]
        return found

    def _order(self, coarse: Outcome, fine: Outcome, error: str) -> float | None:
        """log(e_coarse / e_fine) / log(h_coarse / h_fine); None where the reference hides it."""
        of_coarse, of_fine = getattr(coarse, error), getattr(fine, error)
        floor = self._floor(error)
        if (
            not of_coarse
            or not of_fine
            or of_fine <= floor
            or of_coarse >= 1
            or not coarse.step
            or not fine.step
        ):
            return None
        return math.log(of_coarse / of_fine) / math.log(coarse.step / fine.step)

    def _floor(self, error: str) -> float:
        """Below it an error is noise."""
        return ABOVE_REFERENCE * (self.reference.error[error] if self.reference.error else 0.0)

    def _flat_rows(self) -> list[dict[str, Any]]:
        rows = []
        for row in self.rows():
            options = {f"{name}": value for name, value in row.pop("options").items()}
            remarks = "; ".join(row.pop("remarks"))
            noise = "; ".join(row.pop("noise"))
            rows.append({**row, "noise": noise, "remarks": remarks, "options": json.dumps(options)})
        return rows

    def _why_none(self, of: str) -> str:
        if of == "reaction_error" and not self.reference.unique_joints:
            return "no joint of the mechanism has a reaction that follows from its motion"
        verdicts = sorted({it.status for it in self.outcomes})
        return f"all are {' or '.join(verdicts)}" if verdicts else "there are none"


def _stepped(cells: Sequence[Outcome]) -> list[Outcome]:
    """Those with a fixed step, coarse to fine, that finished."""
    return sorted((it for it in cells if it.step and it.status == "finished"), key=lambda it: -(it.step or 0))


def _with(it: Outcome) -> str:
    return f"steps of {it.step:g} s" if it.step is not None else f"rtol {it.rtol:g}"


def _check_name(name: str, known: Any, what: str) -> None:
    if name not in known:
        raise OptionError(f"{what} '{name}' does not exist{nearest(name, known)}", code="unknown_option")


def _plain(value: Any) -> Any:
    """For JSON, which has no NaN."""
    if isinstance(value, dict):
        return {name: _plain(item) for name, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def _written(text: str, path: Path | None) -> str | None:
    """To a file, if one is named; else it is returned."""
    if path is None:
        return text
    with replacing(path, "output") as beside:
        beside.write_text(text, encoding="utf-8")
    return None
