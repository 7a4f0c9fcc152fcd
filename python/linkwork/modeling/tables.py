"""What a model consists of, in tables: for the terminal, for notebooks, as records."""

from __future__ import annotations

import html
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from linkwork import rotation
from linkwork.arguments import one_of
from linkwork.modeling.elements import KINDS, Role

if TYPE_CHECKING:
    from linkwork.modeling.builder import ModelBuilder

__all__ = ["Table", "tables"]

What = Literal["bodies", "joints", "forces"]

#: Rows that are printed; `Table.records` has all.
PRINTED = 40

#: Widest column in text.
WIDEST = 44

COLUMNS: Mapping[What, Sequence[str]] = {
    "bodies": ("name", "mass [kg]", "inertia [kg m2]", "position [m]"),
    "joints": ("name", "kind", "a", "b", "at [m]", "axis", "equations"),
    "forces": ("name", "kind", "a", "b", "at [m]", "parameters"),
}


@dataclass(frozen=True, repr=False)
class Table(Sequence[Mapping[str, str]]):
    """Rows of texts under columns, with or without names; printed, or in a notebook, the first rows."""

    title: str
    columns: Sequence[str]
    rows: Sequence[Sequence[str]]

    def __len__(self) -> int:
        return len(self.rows)

    def __getitem__(self, index: Any) -> Any:
        """A row as a mapping of columns to texts; of a slice a list of them."""
        found = self.rows[index]
        if isinstance(index, slice):
            return [dict(zip(self.columns, row, strict=True)) for row in found]
        return dict(zip(self.columns, found, strict=True))

    def __repr__(self) -> str:
        lines = [[_cut(text) for text in row] for row in (self.columns, *self.rows[:PRINTED])]
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        text = ["  ".join(map(str.ljust, row, widths)).rstrip() for row in lines]
        return "\n".join([self._head(), *text, *self._rest()])

    def _repr_html_(self) -> str:
        def row(tag: str, texts: Sequence[str]) -> str:
            return "<tr>" + "".join(f"<{tag}>{html.escape(text)}</{tag}>" for text in texts) + "</tr>"

        body = "".join(row("td", texts) for texts in self.rows[:PRINTED])
        rest = "".join(f"<p>{line}</p>" for line in self._rest())
        head = f"<thead>{row('th', self.columns)}</thead>" if any(self.columns) else ""
        return (
            f'<table style="text-align:left"><caption>{html.escape(self._head())}</caption>{head}'
            f"<tbody>{body}</tbody></table>{rest}"
        )

    def _head(self) -> str:
        return f"{self.title}: {len(self)}" if any(self.columns) else self.title

    def _rest(self) -> list[str]:
        more = len(self) - PRINTED
        return [f"... and {more} more"] if more > 0 else []


def tables(model: ModelBuilder, what: What) -> Table:
    """Of the bodies, joints or force elements of a model. OptionError: another word."""
    one_of(what, COLUMNS, "what")
    rows = _bodies(model) if what == "bodies" else _elements(model, "joint" if what == "joints" else "force")
    own = _user_forces(model) if what == "forces" else ()
    return Table(what.capitalize(), COLUMNS[what], [*rows, *own])


def _bodies(model: ModelBuilder) -> Iterator[Sequence[str]]:
    core = model.compiled()
    columns = core.mass.tolist(), core.inertia, core.q0.reshape(-1, 7)[:, :3]
    for k, (mass, J, position) in enumerate(zip(*columns, strict=True)):
        yield core.body_name(k), f"{mass:g}", _moments(J), _vector(position)


def _elements(model: ModelBuilder, role: Role) -> Iterator[Sequence[str]]:
    core = model.compiled()
    arrays, kinds = getattr(core, f"{role}_arrays")(), list(KINDS[role].values())
    rows = np.diff(core.joint_rows)
    first = np.append(arrays["first_parameter"], len(arrays["parameters"]))
    for k, (kind, bodies) in enumerate(zip(arrays["kind"].tolist(), arrays["bodies"].tolist(), strict=True)):
        info = kinds[kind]
        placed = _placed(model, bodies[0], arrays["origin"][k, 0], arrays["frame"][k, 0])
        name = getattr(core, f"{role}_name")(k)
        common = name, info.name, core.body_name(bodies[0]), core.body_name(bodies[1])
        if role == "joint":
            yield *common, _vector(placed[0]), _vector(placed[1]), str(rows[k])
        else:
            span = slice(int(first[k]), int(first[k + 1]))
            values = zip(info.parameters, arrays["parameters"][span], arrays["signals"][span], strict=True)
            yield *common, _vector(placed[0]), ", ".join(_parameter(*it) for it in values)


def _user_forces(model: ModelBuilder) -> Iterator[Sequence[str]]:
    """Those of the user's own act between the bodies of a joint, or on bodies."""
    core = model.compiled()
    for it in model._user_forces:
        kind, joint, bodies = (it.record.get(what) for what in ("kind", "joint", "bodies"))
        if joint is not None:
            a, b = core.joint_arrays()["bodies"][model._joint_named(joint, "joint_force")[0]]
            where = f"{it.record['coordinate']} of '{joint}'"
            yield it.name, str(kind), core.body_name(a), core.body_name(b), "", where
        else:
            named = (
                "all bodies" if bodies is None else ", ".join([bodies] if isinstance(bodies, str) else bodies)
            )
            yield it.name, str(kind), "", "", "", f"on {named}"


def _placed(model: ModelBuilder, body: int, origin: Any, frame: Any) -> tuple[Any, Any]:
    """Point and z axis of an element, inertial, at t = 0."""
    if body < 0:
        return origin, frame[:, 2]
    q = model.compiled().q0.reshape(-1, 7)[body]
    A = rotation.matrix(q[3:])
    return q[:3] + A @ origin, A @ frame[:, 2]


def _parameter(name: str, value: float, signal: int) -> str:
    return f"{name} {value:g}" if signal < 0 else f"{name} a function"


def _moments(J: Any) -> str:
    return _vector(np.diag(J)) if (np.diag(np.diag(J)) == J).all() else "(3, 3)"


def _vector(x: Any) -> str:
    return "(" + ", ".join(f"{0.0 if abs(part) < 1e-15 else part:.4g}" for part in x) + ")"


def _cut(text: str) -> str:
    return text if len(text) <= WIDEST else text[: WIDEST - 3] + "..."
