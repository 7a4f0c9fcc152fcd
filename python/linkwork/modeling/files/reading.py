"""From a file to a model: syntax, then the schema, then names and mechanics; each tells all its faults at
once."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from itertools import groupby, islice
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import ValidationError

from linkwork.errors import (
    MOST_FAULTS,
    Fault,
    Faults,
    FileError,
    LinkworkError,
    ModelFileError,
    about,
    nearest,
)
from linkwork.functions import Sum, TimeFunction, constant, with_breaks
from linkwork.modeling.elements import KINDS
from linkwork.modeling.files import packed, schema
from linkwork.modeling.files.batches import Placed, add_batch, batch_key
from linkwork.modeling.files.collection import collection_paused
from linkwork.modeling.files.messages import decimal_point, faults_of_schema
from linkwork.modeling.files.syntax import Syntax, Where, field, parse
from linkwork.modeling.files.writing import normalized_from
from linkwork.modeling.shapes import Shape
from linkwork.modeling.user_forces import UserForce
from linkwork.options import refused, renamed

if TYPE_CHECKING:
    from linkwork.modeling.model import Model

#: By the names that a document has for them.
Functions = Mapping[str, TimeFunction]

#: Lists of records.
SECTIONS = ("bodies", "joints", "forces", "shapes", "history")

#: Of a place in words, in a message [characters].
LONGEST = 200

#: Records that are looked at together where one of them is wrong.
PIECE = 100

#: The most names in a record, and in another mapping than one of functions.
MOST_NAMES = 200


@dataclass(frozen=True)
class ModelFile:
    """What a file says: a model, and recommended arguments of `simulate`."""

    model: Model
    simulation: Mapping[str, Any]


def read(path: str | os.PathLike[str], kind: type[Model]) -> ModelFile:
    """As a model of this class. ModelFileError: what is wrong in the file. FileError: it cannot be read."""
    with collection_paused():
        return _checked(path, parse(path), kind)


def _checked(
    path: str | os.PathLike[str], syntax: Syntax, kind: type[Model], held: Functions = MappingProxyType({})
) -> ModelFile:
    """`held`: functions of time that the text names and no text can hold."""
    checker = _Checker(path, syntax)
    if not isinstance(syntax.data, dict):
        raise ModelFileError(path, [Fault(1, "", "a model file is a mapping: linkwork: 1, bodies: ...")])
    _check_settings(syntax.data, checker)
    document = _validated(syntax.data, checker)
    _check_names(document, checker, held)
    return ModelFile(_build(document, checker, kind, held), renamed(document.simulation))


def _validated(data: Mapping[str, Any], checker: _Checker) -> schema.Document:
    """ModelFileError: what the schema does not have."""
    kind = schema.document_type()
    _check_sizes(data, checker)
    functions = data.get("functions")
    if isinstance(functions, dict) and len(functions) > MOST_NAMES:
        _check_pieces(kind, _functions_in_pieces(functions), checker)
    checker.finish()
    try:
        return kind.model_validate(data)
    except ValidationError:  # which may be long, and ends with the first of a list
        _check_pieces(kind, _wrong_pieces(kind, data), checker)
        checker.finish()
        raise


Pieces = Iterator[tuple[dict[str, Any], int]]


def _check_pieces(kind: type[schema.Document], pieces: Pieces, checker: _Checker) -> None:
    """Until no further faults are listed."""
    for part, number in pieces:
        try:
            kind.model_validate(part)
        except ValidationError as error:
            for where, message in faults_of_schema(error, part):
                shifted = (where[0], int(where[1]) + number, *where[2:]) if number else where
                checker.add(shifted, message)
        if checker.full:
            checker.add_more()
            break


def _check_sizes(data: Mapping[str, Any], checker: _Checker) -> None:
    """Mappings with more names than any can have: each of them would be a fault."""
    for section, records in data.items():
        if section == "functions":
            continue
        listed = enumerate(records) if isinstance(records, list) else ()
        for k, record in listed:
            if isinstance(record, dict) and len(record) > MOST_NAMES:
                checker.add((section, k), f"has {len(record)} names, more than there are")
        if isinstance(records, dict) and len(records) > MOST_NAMES:
            checker.add((section,), f"has {len(records)} names, more than there are")
    if len(data) > MOST_NAMES:
        checker.add((), f"has {len(data)} names, more than there are")


def _functions_in_pieces(functions: Mapping[str, Any]) -> Pieces:
    for place in range(0, len(functions), PIECE):
        piece = dict(islice(functions.items(), place, place + PIECE))
        yield {"linkwork": schema.VERSION, "functions": piece}, 0


def _wrong_pieces(kind: type[schema.Document], data: Mapping[str, Any]) -> Pieces:
    """Documents with one record each that may be wrong, and its number; first all that is no record."""
    lists = {name: value for name, value in data.items() if isinstance(value, list) and name in SECTIONS}
    functions = data.get("functions")
    mapped = functions if isinstance(functions, dict) else {}
    rest = data.keys() - lists.keys() - ({"functions"} if mapped else set())
    yield {name: data[name] for name in data if name in rest}, 0
    head = {"linkwork": schema.VERSION}
    yield from _functions_in_pieces(mapped)
    for name, values in lists.items():
        for start in range(0, len(values), PIECE):
            piece = values[start : start + PIECE]
            try:
                kind.model_validate({**head, name: piece})
            except ValidationError:
                yield from (({**head, name: [record]}, start + k) for k, record in enumerate(piece))


def from_record(record: Mapping[str, Any], kind: type[Model], held: Functions) -> Model:
    """From a document as `whole_record` makes it, and what that has beside it."""

    def build(document: Mapping[str, Any]) -> Model:
        return _built(schema.document_type().model_validate(document), kind, _straight, held)

    return _with_own(record, build)


@dataclass
class _Record:
    """A document that came from no text."""

    data: Any

    def line(self, where: Where) -> int:
        return 0


def from_changed_record(
    record: Mapping[str, Any], kind: type[Model], held: Functions = MappingProxyType({})
) -> Model:
    """From a document that somebody changed, checked like a file, and what `whole_record` has beside it.

    ModelFileError: what is wrong in it. ModelError: in a force of the user's own.
    """
    return _with_own(record, lambda document: _checked("model", _Record(document), kind, held).model)


def _with_own(record: Mapping[str, Any], build: Callable[[Mapping[str, Any]], Model]) -> Model:
    """Built of the rest, and then the forces of the user's own."""
    own = record.get("user_forces", ())
    later = ("user_forces", "history") if own else ("user_forces",)  # which they add to
    with collection_paused():
        model = build({section: it for section, it in record.items() if section not in later})
    for it in own:
        UserForce.add(model, it)
    history = record.get("history", []) if own else []
    return _with_history(model, history) if history else model


class _Checker:
    """Collects faults, each with the line of its place in the file."""

    def __init__(self, path: str | os.PathLike[str], syntax: Syntax) -> None:
        self._path, self._syntax = path, syntax
        self._faults, self._more = Faults(), False
        self._wrong: set[tuple[str | int, ...]] = set()

    def add(self, where: Where, message: str) -> None:
        self._wrong.add(tuple(where[:2]))
        line = 1 if self.full else self.line(where)  # those that are counted have none
        self._faults.add(Fault(line, field(where)[:LONGEST], message))

    def add_more(self) -> None:
        """Nobody looked further."""
        self._more = True

    @property
    def full(self) -> bool:
        return self._faults.full

    @property
    def any(self) -> bool:
        return self._faults.count > 0

    def knows(self, where: Where) -> bool:
        """Whether there is a fault in this record."""
        return tuple(where[:2]) in self._wrong

    def line(self, where: Where) -> int:
        """Of the value, or of the nearest around it that is there."""
        try:
            return self._syntax.line(where)
        except (KeyError, IndexError):
            return self.line(where[:-1]) if where else 1

    def finish(self) -> None:
        """ModelFileError: there are faults."""
        found = self._faults.all()
        if self._more:
            last = max(fault.line for fault in found)
            found = [
                *found[:MOST_FAULTS],
                Fault(last, "", f"these are the first {MOST_FAULTS} faults; there may be more"),
            ]
        if found:
            raise ModelFileError(self._path, found)


def _check_settings(data: Mapping[str, Any], checker: _Checker) -> None:
    """What no run takes: names, values, or all of them together."""
    settings = data.get("simulation")
    if not isinstance(settings, dict):
        return
    for name, why in refused(settings):
        checker.add(("simulation", *([name] if name else [])), why)


def _check_names(document: schema.Document, checker: _Checker, held: Functions) -> None:
    """Names are unique; bodies and functions that are named are there."""
    if not document.name.isprintable():
        checker.add(("name",), f"name {document.name!r:.80} is not printable text")
    bodies = _unique("bodies", document.bodies, checker, {"ground": "is the name of the ground"})
    for role in KINDS:
        records = getattr(document, f"{role}s")
        _unique(f"{role}s", records, checker, {})
        for k, record in enumerate(records):
            for side in ("a", "b", "body"):
                body = getattr(record, side, None)
                if isinstance(body, str):
                    _check_body(body, (f"{role}s", k, side), bodies, checker)
            for what, name in _named_functions(record):
                if name not in document.functions and name not in held and not checker.full:
                    checker.add((f"{role}s", k, what), _no_function(name, document.functions))
    _check_joints(document.joints, checker)
    for k, shapes in enumerate(document.shapes):
        for j, name in enumerate(shapes.bodies):
            _check_body(name, ("shapes", k, "bodies", j), bodies, checker)


def _check_joints(joints: Sequence[Any], checker: _Checker) -> None:
    """Joints that others name stand before them; those without a name get theirs when they are added."""
    before: set[str] = set()
    unnamed = False
    for k, record in enumerate(joints):
        for j, term in enumerate(getattr(record, "coordinates", ())):
            if term.factor == 0:
                checker.add(("joints", k, "coordinates", j, "factor"), "must not be zero")
        for where, name in _named_joints(record):
            if name not in before and not unnamed and not checker.full:
                checker.add(("joints", k, *where), f"no joint named '{name}' before{nearest(name, before)}")
        unnamed = unnamed or record.name is None
        before.add(record.name)


def _named_joints(record: Any) -> Iterator[tuple[Where, str]]:
    """Joints that a record of a joint names, each with its place there."""
    if record.kind == schema.DRIVE:
        yield ("joint",), record.joint
    for j, term in enumerate(getattr(record, "coordinates", ())):
        yield ("coordinates", j, "joint"), term.joint


def _no_function(name: str, functions: Iterable[str]) -> str:
    hint = decimal_point(name) or nearest(name, functions)
    if re.search(r"[-+*/().]", name):
        hint = f"; a formula of t is written {{expression: {json.dumps(name)}}}"
    return f"{name!r} is neither a number nor in functions{hint}"


def _check_body(name: str, where: Where, bodies: dict[str, str], checker: _Checker) -> None:
    if name != "ground" and name not in bodies and not checker.full:
        checker.add(where, f"no body named '{name}'{nearest(name, islice(bodies, 10_000))}")


def _unique(section: str, records: Sequence[Any], checker: _Checker, taken: dict[str, str]) -> dict[str, str]:
    """The names of a section, with why each is taken."""
    for k, record in enumerate(records):
        if record.name is None:
            continue
        if not record.name.isprintable():
            checker.add((section, k, "name"), f"name {record.name!r} is not printable text")
        if record.name in taken and not checker.full:
            why = (
                taken[record.name] or f"is the name of {_first(section, records, record.name, checker)}, too"
            )
            checker.add((section, k, "name"), f"'{record.name}' {why}; choose another name")
        taken.setdefault(record.name, "")
    return taken


def _first(section: str, records: Sequence[Any], name: str, checker: _Checker) -> str:
    k = next(k for k, record in enumerate(records) if record.name == name)
    line = checker.line((section, k, "name"))
    return f"{section}[{k}]" + (f" in line {line}" if line else "")


def _named_functions(record: schema.Element) -> Iterator[tuple[str, str]]:
    """Parameters that are the name of a function."""
    for what in schema.quantities_of(type(record)):
        value = getattr(record, what)
        for name in value if isinstance(value, list) else (value,):
            if isinstance(name, str):
                yield what, name


# --- from records to a model --------------------------------------------------------------------------------


def _build(document: schema.Document, checker: _Checker, kind: type[Model], held: Functions) -> Model:
    """The model; where names are wrong, or the compiled model refuses something, all of it is told."""
    refused_for: LinkworkError | None = None
    if not checker.any:
        try:
            return _built(document, kind, _straight, held)
        except LinkworkError as error:
            refused_for = error
    try:
        _built(
            document.model_copy(update={"name": ""}), kind, _OneByOne(document, checker), held, batches=False
        )
    except LinkworkError:  # of history variables, which are others where elements are left out
        if not checker.any:
            raise
    checker.finish()
    raise FileError(str(refused_for), code=refused_for.code if refused_for else "") from refused_for


class _OneByOne:
    """Adds what can be added, and notes why the rest cannot; what needs something that is not there is left
    out, as nothing is known of it."""

    def __init__(self, document: schema.Document, checker: _Checker) -> None:
        self._document, self._checker = document, checker
        self._missing: set[str | None] = set()  # joints; None: one that has no name in the file

    def __call__(
        self, where: Where, add: Callable[[], None], instead: Callable[[], None] | None = None
    ) -> None:
        if self._checker.full:
            return
        known = len(where) == 2 and self._checker.knows(where)
        if not known and not self._hangs(where):
            try:
                add()
                return
            except LinkworkError as refusal:
                self._checker.add(*_place(self._document, where, refusal))
        if where[0] == "joints":
            self._missing.add(self._document.joints[int(where[1])].name)
        if instead is not None:
            with suppress(LinkworkError):  # of a name that is taken
                instead()

    def _hangs(self, where: Where) -> bool:
        """On a joint that is missing."""
        if where[0] != "joints" or not self._missing:
            return False
        named = [name for _, name in _named_joints(self._document.joints[int(where[1])])]
        return bool(named) and (None in self._missing or not self._missing.isdisjoint(named))


def _straight(where: Where, add: Callable[[], None], instead: Callable[[], None] | None = None) -> None:
    add()


#: attempt(where, add, instead): `add` is called; where it is refused and only faults are wanted, `instead`
#: stands in, so that what refers to it can be checked, too.
Attempt = Callable[..., None]


def _built(
    document: schema.Document, kind: type[Model], attempt: Attempt, held: Functions, batches: bool = True
) -> Model:
    model = kind._blank(document.gravity, document.name)
    functions: dict[str, TimeFunction] = {**held}

    def define(name: str, function: Any) -> Callable[[], None]:
        return lambda: functions.update({name: function()})

    for name, record in document.functions.items():
        make = partial(function_of, record)
        attempt(("functions", name), define(name, make), define(name, partial(constant, 1.0)))
    _add_bodies(model, document.bodies, attempt, batches)
    for role in KINDS:
        records = getattr(document, f"{role}s")
        numbered = enumerate(Placed(role, record, functions, function_of) for record in records)
        if not batches:
            for k, element in numbered:
                attempt((f"{role}s", k), partial(add_batch, model, [element]))
            continue
        for _, batch in groupby(numbered, key=lambda pair: batch_key(*pair)):
            add_batch(model, [element for _, element in batch])
    for k, shapes in enumerate(document.shapes):
        for j, shape in enumerate(shapes.shapes):
            attempt(("shapes", k, "shapes", j), partial(_shape_of, shape))
        attempt(("shapes", k), partial(_add_shapes, model, shapes))
    return _with_history(model, document.history) if document.history else model


def _with_history(model: Model, history: Sequence[float]) -> Model:
    """The same model, to the last bit, with history variables at its initial state."""
    core, count = model.compiled(), model.body_count
    q = np.array(core.q0).reshape(count, 7)
    q[:, 3:] = normalized_from(q[:, 3:])
    return model.with_initial_state(q, core.v0, history)


def _shape_of(record: schema.Record) -> Shape:
    """ModelError: what no shape can be."""
    given = record.model_dump(exclude_unset=True)
    arrays = [what for what in ("vertices", "triangles") if isinstance(given.get(what), str)]
    return Shape.of(given | {what: packed.unpack(given[what], f"mesh: {what}") for what in arrays})


def _add_shapes(model: Model, record: schema.ShapesRecord) -> None:
    model.shape(record.bodies, *map(_shape_of, record.shapes))


def _add_bodies(
    model: Model,
    records: Sequence[schema.BodyRecord],
    attempt: Attempt,
    batches: bool,
) -> None:
    if batches:
        _add_batch_of_bodies(model, records)
        return
    for k, record in enumerate(records):
        stand_in = schema.BodyRecord(  # type: ignore[call-arg]
            name=record.name, mass=1.0, inertia=[1.0, 1.0, 1.0], position=record.position
        )
        attempt(("bodies", k), *(partial(_add_batch_of_bodies, model, [body]) for body in (record, stand_in)))


def _add_batch_of_bodies(model: Model, records: Sequence[schema.BodyRecord]) -> None:
    if not records:
        return
    inertia = [body.inertia for body in records]
    diagonal = np.array([not isinstance(J[0], list) for J in inertia])
    tensors = np.zeros((len(records), 3, 3))
    if diagonal.any():
        moments = np.array([J for J in inertia if not isinstance(J[0], list)], dtype=float)
        tensors[diagonal] = moments[:, :, None] * np.eye(3)
    if not diagonal.all():
        tensors[~diagonal] = np.array([J for J in inertia if isinstance(J[0], list)], dtype=float)
    state = {
        what: np.array([getattr(body, what) for body in records], dtype=float)
        for what in ("position", "orientation", "velocity", "omega")
    }
    mass = np.array([body.mass for body in records], dtype=float)
    as_is = [body.inertia_as_is for body in records]
    model.compiled().add_bodies([body.name for body in records], mass, tensors, **state, inertia_as_is=as_is)


def function_of(record: Any) -> TimeFunction:
    """The function of time that a record describes. ModelError: what its constructor refuses."""
    (name,) = type(record).model_fields
    arguments = getattr(record, name)
    with about(name):
        if name == "sum":
            return Sum(tuple(map(function_of, arguments)))
        if name == "with_breaks":
            return with_breaks(function_of(arguments.function), arguments.breaks)
        constructor = schema.constructors()[name]
        if isinstance(arguments, schema.Record):
            return constructor(**{what: getattr(arguments, what) for what in type(arguments).model_fields})
        return constructor(*arguments) if isinstance(arguments, list) else constructor(arguments)


def _place(document: schema.Document, where: Where, error: LinkworkError) -> tuple[Where, str]:
    """The field that a refusal is about, and the reason."""
    section, key, *inner = where
    record = getattr(document, str(section))[key]
    if inner or not error.field or getattr(record, error.field, None) is None:  # inner: a shape
        return where, error.reason
    return (*where, error.field), error.reason.removeprefix(error.field).lstrip(":= ")
