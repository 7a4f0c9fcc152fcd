"""Elements of a file on their way into a model: one call for all that follow each other and are alike."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from linkwork import _core
from linkwork.errors import about
from linkwork.functions import TimeFunction
from linkwork.modeling.builder import ModelBuilder
from linkwork.modeling.elements import KINDS, Role, placed, with_parameters
from linkwork.modeling.files import schema
from linkwork.modeling.placement import PLACEMENTS, Attachment, Place, Subject


class Placed:
    """An element of a file, with what its functions are."""

    def __init__(
        self,
        role: Role,
        record: schema.Element,
        functions: Mapping[str, TimeFunction],
        make: Callable[[Any], TimeFunction],
    ) -> None:
        self.role, self.record = role, record
        self._functions, self._make = functions, make

    @property
    def info(self) -> _core.KindInfo:
        return KINDS[self.role][self.record.kind]

    def quantity(self, value: Any, field: str) -> Any:
        """A number, or the function of time that a field says."""
        if isinstance(value, str):
            return self._functions[value]
        if isinstance(value, list):
            return [self.quantity(part, field) for part in value]
        if not isinstance(value, schema.Record):
            return value
        with about(field):
            return self._make(value)

    def arguments(self) -> dict[str, Any]:
        """Of the kind's method, by name; the functions made."""
        values = {
            name: getattr(self.record, name) for name in type(self.record).model_fields if name != "kind"
        }
        for name, value in values.items():
            if name == "coordinates":
                values[name] = [_term(record) for record in value]
        own = schema.quantities_of(type(self.record))
        return {name: self.quantity(value, name) if name in own else value for name, value in values.items()}


def _term(record: schema.CoupledRecord) -> tuple[Any, ...]:
    """As Model.coupler takes it."""
    which = () if record.coordinate is None else (record.coordinate,)
    return (record.joint, *which, record.factor)


def batch_key(number: int, element: Placed) -> Hashable:
    """Equal for elements that can be added in one call: of one kind and form, with the same functions."""
    record = element.record
    if record.name is None or record.kind == schema.DRIVE:
        return number
    attached = isinstance(record, schema.Attached)
    shape = _shape(type(record), element.info, attached)
    if shape is None:
        return number
    values = [getattr(record, name) for name in shape.parameters]
    if any(isinstance(value, schema.Record) for value in values):
        return number
    given = tuple(value if isinstance(value, str) else value is None for value in values)
    if attached:
        return type(record), given
    place = [getattr(record, name) for name in shape.place]
    if any(value is None for name, value in zip(shape.place, place, strict=True) if name in shape.required):
        return number
    return type(record), given, record.frames, tuple(value is None for value in place)  # type: ignore[attr-defined]


@dataclass(frozen=True)
class _Shape:
    """The fields of a type of element, sorted."""

    parameters: tuple[str, ...]
    place: tuple[str, ...]
    required: tuple[str, ...]


_SHAPES: dict[type, _Shape | None] = {}


def _shape(type_: type[schema.Element], info: _core.KindInfo, attached: bool) -> _Shape | None:
    """None where the kind's method has arguments of its own."""
    if type_ not in _SHAPES:
        fields = set(type_.model_fields) - {"kind", "name", "a", "b", "frames", "attachment"}
        place: dict[str, inspect.Parameter] = {}
        if not attached and info.placement in PLACEMENTS:
            place = dict(list(inspect.signature(PLACEMENTS[info.placement]).parameters.items())[1:])
        required = tuple(name for name, p in place.items() if p.default is p.empty)
        known = fields == set(info.parameters) | set(place)
        _SHAPES[type_] = _Shape(tuple(info.parameters), tuple(place), required) if known else None
    return _SHAPES[type_]


def add_batch(model: ModelBuilder, elements: Sequence[Placed]) -> None:
    """ModelError: what the model refuses."""
    first = elements[0]
    if isinstance(first.record, schema.Attached):
        _add(model, elements, first.info, _attached)
    elif len(elements) > 1:
        _add(model, elements, first.info, _in_place)
    else:
        schema.method_of(first.record.kind)(model, **first.arguments())


def _add(
    model: ModelBuilder, elements: Sequence[Placed], info: _core.KindInfo, how: Callable[..., Any]
) -> None:
    records = [element.record for element in elements]
    index = model.compiled().find_body
    bodies = np.array([[index(record.a), index(record.b)] for record in records], np.int32)  # type: ignore[attr-defined]
    names = [model._named(record.name, record.kind, model._counts[record.kind]) for record in records]
    subject = Subject(info.name, names[0], True, len(names), names)
    poses = model._bodies.poses
    parameters = {name: _column(elements, name) for name in info.parameters}
    where = how(records, Place(subject, poses(bodies[:, 0]), poses(bodies[:, 1]), ()))
    if isinstance(where, Attachment):
        model._add(with_parameters(info, subject, bodies, where, parameters))
    else:
        in_bodies = records[0].frames == "body"  # type: ignore[attr-defined]
        model._add(placed(info, subject, bodies, poses, in_bodies, {**where, **parameters}))


def _column(elements: Sequence[Placed], name: str) -> Any:
    """The values of one parameter (k,), the function that all have, or None."""
    values = [getattr(element.record, name) for element in elements]
    if isinstance(values[0], float | int):
        return np.array(values, dtype=float)
    return elements[0].quantity(values[0], name)


def _attached(records: Sequence[Any], place: Place) -> Attachment:
    origin = np.array([record.attachment.origin for record in records], dtype=float)
    frame = np.array([record.attachment.frame for record in records], dtype=float)
    return Attachment(origin, frame, place.distance(origin[:, 0], origin[:, 1]))


def _in_place(records: Sequence[Any], place: Place) -> dict[str, Any]:
    """Arguments of the placement, each with a leading k; pairs stay pairs."""
    info = (KINDS["joint"] | KINDS["force"])[records[0].kind]  # type: ignore[operator]
    names = list(inspect.signature(PLACEMENTS[info.placement]).parameters)[1:]
    columns = {name: [getattr(record, name) for record in records] for name in names}
    return {name: _stacked(values) for name, values in columns.items() if values[0] is not None}


def _stacked(values: list[Any]) -> Any:
    if isinstance(values[0][0], list):
        return tuple(np.array(side, dtype=float) for side in zip(*values, strict=True))
    return np.array(values, dtype=float)
