"""Where the models of a study come from: other values in one model, by path, or a function that builds them.

A path is the name of a body, joint or force element, a field of its record in a model file, and where that
has parts an index or a name: "crank.mass", "crank.inertia[1]", "spring.stiffness", "motor pin.at[2]",
"motor.angle.harmonic.amplitude"; "gravity" and "gravity[2]" are those of the model.
"""

from __future__ import annotations

import copy
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Protocol

import numpy as np

from linkwork import rotation
from linkwork.arguments import check_takes
from linkwork.arrays import Floats
from linkwork.errors import LinkworkError, ModelError, OptionError, nearest
from linkwork.fingerprints import canonical, digest, plain
from linkwork.functions import TimeFunction
from linkwork.modeling.editing import NAMES, OWN, ROLES, SECTIONS, built, driven, follow_all
from linkwork.modeling.elements import KINDS
from linkwork.modeling.files import whole_record
from linkwork.modeling.files.schema import BodyRecord, element_type, form_of
from linkwork.modeling.model import Model, check_model
from linkwork.modeling.moving import ATTACHED
from linkwork.modeling.user_forces import UserForce
from linkwork.studies.sampling import own_copy

__all__ = ["Built", "Changed", "Source", "source_of"]

Record = dict[str, Any]

#: Fields of bodies and of the model.
UNITS = {
    "mass": "kg", "inertia": "kg m2", "position": "m", "velocity": "m/s", "omega": "rad/s",
    "gravity": "m/s2", "at": "m", "orientation": "1", "points": "m",
}  # fmt: skip

#: Parts of fields with a unit of their own; arguments of functions of time with that of the function.
PART_UNITS = {
    ("origin",): "m", ("frame",): "1", ("harmonic", "frequency"): "rad/s", ("harmonic", "phase"): "rad",
    ("cycloidal", "start"): "s", ("cycloidal", "duration"): "s", ("piecewise_polynomial", "breaks"): "s",
}  # fmt: skip
OF_VALUE = {("harmonic", "amplitude"), ("harmonic", "offset"), ("cycloidal", "rise")}

#: Rows of coefficients of ascending powers: the first is a value of the function.
COEFFICIENTS = {("polynomial",), ("piecewise_polynomial", "coefficients")}

#: A field, and what is in it.
FIELD = re.compile(r"(\w+)((?:\[\d+\]|\.\w+)*)\Z")
STEP = re.compile(r"\[(\d+)\]|\.(\w+)")

#: Two points of a joint that are one, relative to where they are.
SAME_POINT = 1e-9


class Source(Protocol):
    """What makes the models of the cases."""

    def model(self, case: Mapping[str, Any]) -> Model:
        """Of the values of one case. ModelError and others: there is none."""

    @property
    def weights_alone(self) -> bool:
        """Whether nothing but gravity, masses and inertias differs between them, as far as is known."""

    def units(self, names: Sequence[str]) -> dict[str, str]:
        """Of parameters; empty: not known."""

    def identity(self) -> str:
        """A digest of what is varied."""


def source_of(model: Model | Callable[..., Model], columns: Mapping[str, Sequence[Any]]) -> Source:
    """OptionError: a parameter that there is not, or a value of another shape. ModelError: no model."""
    if isinstance(model, Model):
        changed = Changed.of(model, list(columns))
        for name, values in columns.items():
            changed.check(name, values)
        return changed
    if not callable(model):
        check_model(model)
    source = Built(model)
    source.check(list(columns))
    return source


@dataclass(frozen=True)
class Built:
    """A function build(**parameters) -> Model: where the topology changes, or a path does not suffice."""

    build: Callable[..., Model]

    @property
    def name(self) -> str:
        return str(getattr(self.build, "__name__", type(self.build).__name__))

    def check(self, names: Sequence[str]) -> None:
        """OptionError: it does not take these parameters."""
        check_takes(self.build, names, self.name)

    def model(self, case: Mapping[str, Any]) -> Model:
        made = self.build(**{name: own_copy(value) for name, value in case.items()})
        if not isinstance(made, Model):
            raise ModelError(f"function {self.name}: gives {made!r:.80}, no model", code="not_a_model")
        return made

    @property
    def weights_alone(self) -> bool:
        """Nobody knows what its models have in common."""
        return False

    def units(self, names: Sequence[str]) -> dict[str, str]:
        return {}

    def identity(self) -> str:
        return digest("built", self.build)


@dataclass(frozen=True)
class _Address:
    """Where a value is in the record of a model."""

    name: str
    where: tuple[str | int, ...]  # section and place of the object; () for the model
    field: str
    inside: tuple[str | int, ...]
    unit: str


@dataclass(frozen=True)
class Changed:
    """One model with other values of what paths lead to. Bodies first: joints stay where they are on them.

    held  functions of Python, by the names that the record has for them
    own   forces of the user's own
    """

    record: Record
    addresses: Mapping[str, _Address]
    held: Mapping[str, TimeFunction] = field(default_factory=dict)
    own: Sequence[UserForce] = ()

    def __reduce__(self) -> tuple[Any, ...]:
        """Without what is found anew. ModelError: a compiled force."""
        for it in self.own:
            it.check_leaves()
        return type(self), (self.record, self.addresses, self.held, self.own)

    @classmethod
    def of(cls, model: Model, names: Sequence[str]) -> Changed:
        """OptionError: a path that leads nowhere, or two to the same value."""
        record, held = whole_record(model)
        del record[OWN]
        found = {name: _address(name, record) for name in names}
        _check_apart(list(found.values()))
        changed = cls(record, found, held, tuple(model._user_forces))
        if any(_moves(address, record) for address in found.values()):
            changed._begin_anew()
        for name in names:
            changed.value(name)
        return changed

    def model(self, case: Mapping[str, Any]) -> Model:
        record = self._copy()
        for name in self._order:
            address = self.addresses[name]
            _put(record, address, plain(case[name]), self._points.get(address.where, frozenset()))
        follow_all(record, self._drivers)
        if self.weights_alone:
            try:
                return _with_weights(self._base, record, self._bodies)
            except (LinkworkError, TypeError, ValueError):  # which is told below by the name of the object
                pass
        return self._built(record)

    def _built(self, record: Record) -> Model:
        own = {OWN: [it.record for it in self.own]} if self.own else {}
        return built(Model(name=record.get("name", "")), {**record, **own}, self.held)

    def _begin_anew(self) -> None:
        """History variables follow from the pose. OptionError: those of the model have something else to
        tell."""
        history = self.record.pop("history", [])
        usual = list(self._built(self.record).compiled().initial_history) or [0.0] * len(history)
        if usual != list(history):
            raise OptionError(
                f"parameters {', '.join(self.addresses)}: the model begins with full turns or contacts under "
                "way, which another pose would not have: give a function build(**parameters)",
                code="parameters",
            )

    @cached_property
    def _order(self) -> list[str]:
        return sorted(self.addresses, key=lambda name: self.addresses[name].where[:1] != ("bodies",))

    @cached_property
    def _points(self) -> dict[tuple[str | int, ...], frozenset[int]]:
        """By element, which components of its point `at` are given, so that its former ones tell nothing."""
        found: dict[tuple[str | int, ...], frozenset[int]] = {}
        for it in self.addresses.values():
            if it.field == "at":
                given = {int(it.inside[0])} if it.inside else range(3)
                found[it.where] = found.get(it.where, frozenset()) | frozenset(given)
        return found

    @cached_property
    def _drivers(self) -> dict[int, list[int]]:
        """Drivers of joints that all move, each with these joints, but for drivers that parameters move."""
        moved = {
            int(it.where[1])
            for it in self.addresses.values()
            if it.where[:1] == ("joints",) and it.field in ("at", ATTACHED)
        }
        return {driver: own for driver, own in driven(self.record, moved).items() if driver not in moved}

    @cached_property
    def weights_alone(self) -> bool:
        """Nothing but gravity, masses and inertias changes, which takes no new model."""
        return all(
            not it.where or (it.where[0] == "bodies" and it.field in ("mass", "inertia"))
            for it in self.addresses.values()
        )

    @cached_property
    def _bodies(self) -> list[int]:
        return sorted({int(it.where[1]) for it in self.addresses.values() if it.where})

    @cached_property
    def _base(self) -> Model:
        return self._built(self.record)

    def _copy(self) -> Record:
        """Of what is to be changed; the rest is that of every case."""
        record = {**self.record}
        for it in self.addresses.values():
            if not it.where:
                record[it.field] = copy.deepcopy(record[it.field])
                continue
            section, place = str(it.where[0]), it.where[1]
            given = self.record[section]
            if record[section] is given:
                record[section] = [*given]
            if record[section][place] is given[place]:
                record[section][place] = {**given[place]}
            one = record[section][place]
            if it.field in one:
                one[it.field] = copy.deepcopy(one[it.field])
            else:  # such as a point, which is found from more than one field
                record[section][place] = copy.deepcopy(one)
        return record

    def value(self, name: str) -> Any:
        """Of the model as it was given. OptionError: it is none that can be varied."""
        address = self.addresses[name]
        found = _get(copy.deepcopy(self.record), address)
        if not _is_numeric(found) and not (isinstance(found, str | dict) and not address.inside):
            raise OptionError(f"parameter '{name}': is no number but {found!r:.60}", code="parameters")
        return found

    def check(self, name: str, values: Sequence[Any]) -> None:
        """OptionError: values of another shape than those of the model, or that are not finite."""
        base = self.value(name)
        shape = np.shape(base) if _is_numeric(base) else ()
        if shape == () and all(type(value) is float for value in values) and np.isfinite(values).all():
            return
        for number, value in enumerate(values):
            if not _is_numeric(value) or not np.isfinite(value).all():
                raise OptionError(
                    f"parameter '{name}': {value!r:.60} of case {number} is not made of finite numbers",
                    code="parameters",
                )
            if np.shape(value) != shape:
                raise OptionError(
                    f"parameter '{name}': the value of case {number} has shape {np.shape(value)}, not {shape}"
                    + _parts_hint(name, shape),
                    code="shape",
                )

    def units(self, names: Sequence[str]) -> dict[str, str]:
        return {name: self.addresses[name].unit for name in names}

    def identity(self) -> str:
        functions = [*self.held.values(), *((it.law, it.data, plain(it.record)) for it in self.own)]
        following = [canonical(self._drivers)] if self._drivers else []  # earlier versions left some behind
        return digest(
            "changed", canonical(plain(self.record)), *([functions] if functions else []), *following
        )


def _with_weights(model: Model, record: Record, bodies: Sequence[int]) -> Model:
    """LinkworkError: no body has such a mass or inertia."""
    masses, inertias = [], []
    for body in bodies:
        found = record["bodies"][body]
        moments = np.array(found["inertia"], dtype=float)
        masses.append(float(found["mass"]))
        inertias.append(np.diag(moments) if moments.ndim == 1 else moments)
    core = model.compiled()
    return model._with_core(core.with_weights(record.get("gravity", core.gravity), bodies, masses, inertias))


def _moves(address: _Address, record: Record) -> bool:
    """Whether it says where something is, and so what history variables begin with."""
    if not address.where or address.where[0] == "bodies":
        return address.field in ("position", "orientation")
    it = _object_of(record, address)
    return address.field not in KINDS[ROLES[str(address.where[0])]][it["kind"]].parameters


def _parts_hint(name: str, shape: tuple[int, ...]) -> str:
    return f"; one part is '{name}{'[0]' * len(shape)}'" if shape else ""


def _check_apart(found: Sequence[_Address]) -> None:
    """OptionError: two paths to one value, of which one would win."""
    for k, one in enumerate(found):
        for other in found[:k]:
            if one.where == other.where and _overlap(one, other):
                raise OptionError(
                    f"parameters '{other.name}' and '{one.name}' are the same value: give one of them",
                    code="parameters",
                )


def _overlap(one: _Address, other: _Address) -> bool:
    """Of one object. Any part of `at` moves the points in both bodies, in which axes are turned."""
    paths = [(it.field, *it.inside) for it in (one, other)]
    if (one.field == "at") != (other.field == "at"):
        paths = [(ATTACHED, "origin") if path[0] == "at" else path for path in paths]
    shorter = min(map(len, paths))
    return paths[0][:shorter] == paths[1][:shorter]


def _address(name: str, record: Record) -> _Address:
    if not isinstance(name, str):
        raise OptionError(
            f"parameter {name!r:.80} is no path such as 'crank.mass' or 'gravity[2]'", code="parameters"
        )
    where, rest = ((), name) if re.fullmatch(r"gravity(\[.*)?", name) else _object(name, record)
    found = FIELD.match(rest)
    fields = {"gravity": "m/s2"} if not where else _fields(record, where)
    if found is None or found[1] not in fields:
        word = rest if found is None else found[1]
        raise OptionError(
            f"parameter '{name}': {_called(record, where)} has no '{word}'{nearest(word, fields)}",
            code="parameters",
        )
    inside = tuple(int(index) if index else word for index, word in STEP.findall(found[2]))
    curve = inside and _is_characteristic(record, where, found[1])
    return _Address(name, where, found[1], inside, "" if curve else _unit(fields[found[1]], inside))


def _unit(unit: str, inside: tuple[str | int, ...]) -> str:
    """Of a part of a field that has this unit; of further coefficients none is told."""
    while inside[:1] == ("sum",):
        inside = inside[2:]
    words = tuple(step for step in inside if isinstance(step, str))
    value = not words or words in OF_VALUE or (words in COEFFICIENTS and inside[-1] == 0)
    return unit if value else PART_UNITS.get(words, "")


def _is_characteristic(record: Record, where: tuple[Any, ...], field: str) -> bool:
    """Whether a field is a function of a coordinate, of which parts have units of their own."""
    if not where or where[0] == "bodies":
        return False
    parameters = KINDS[ROLES[where[0]]][record[where[0]][where[1]]["kind"]].parameters
    return field in parameters and parameters[field].takes == "characteristic"


def _object(name: str, record: Record) -> tuple[tuple[str, int], str]:
    """Section and place of what a path begins with, the longest name that has such a field, and its rest."""
    found = [
        (len(it["name"]), section, place)
        for section in SECTIONS
        for place, it in enumerate(record.get(section, []))
        if name.startswith(it["name"] + ".")
    ]
    fitting = [it for it in found if _first(name[it[0] + 1 :]) in _fields(record, it[1:])]
    longest = [it for it in found if it[0] == max(fitting or found)[0] and (it in fitting or not fitting)]
    if len(longest) > 1:
        raise _of_several(name, record, longest, bool(fitting))
    if not longest:
        _refuse_whole(name, record)
        known = [it["name"] for section in SECTIONS for it in record.get(section, [])[:1000]]
        raise OptionError(
            f"parameter '{name}': no body, joint or force element "
            f"'{name.rpartition('.')[0] or name}'{nearest(name.rpartition('.')[0] or name, known)}",
            code="parameters",
        )
    size, section, place = longest[0]
    return (section, place), name[size + 1 :]


def _first(rest: str) -> str:
    """The field that the rest of a path begins with."""
    return re.split(r"[.\[]", rest, maxsplit=1)[0]


def _of_several(
    name: str, record: Record, found: Sequence[tuple[int, str, int]], each_has: bool
) -> OptionError:
    """A path of a name that a body and a joint share, say, where both have the field, or none does."""
    size = found[0][0]
    kinds, word = [SECTIONS[section] for _, section, _ in found], _first(name[size + 1 :])
    told = f"parameter '{name}': '{name[:size]}' is " + " and ".join(f"a {kind}" for kind in kinds)
    if each_has:
        return OptionError(f"{told}, which have a '{word}' each: name them apart", code="parameters")
    known = [field for it in found for field in _fields(record, it[1:])]
    return OptionError(f"{told}, and none has a '{word}'{nearest(word, known)}", code="parameters")


def _refuse_whole(name: str, record: Record) -> None:
    """OptionError: the name of an object without a field."""
    for section, kind in SECTIONS.items():
        for place, it in enumerate(record.get(section, [])):
            if it["name"] == name:
                fields = [f"'{name}.{field}'" for field in _fields(record, (section, place))]
                raise OptionError(
                    f"parameter '{name}': is a whole {kind}: name one of its values: {', '.join(fields)}",
                    code="parameters",
                )


def _called(record: Record, where: tuple[Any, ...]) -> str:
    if not where:
        return "the model"
    return f"{SECTIONS[where[0]]} '{record[where[0]][where[1]]['name']}'"


def _fields(record: Record, where: tuple[Any, ...]) -> dict[str, str]:
    """What can be varied of an object, with units."""
    it = record[where[0]][where[1]]
    if where[0] == "bodies":
        return {name: UNITS[name] for name in BodyRecord.model_fields if name in UNITS}
    parameters = KINDS[ROLES[where[0]]][it["kind"]].parameters
    fields = [name for name in _type_of(where, it) if name not in (*NAMES, "frames")]
    placed = {"at": UNITS["at"], ATTACHED: ""} if ATTACHED in it else {}
    return {**{name: parameters[name].unit if name in parameters else UNITS.get(name, "")
               for name in fields}, **placed}  # fmt: skip


def _type_of(where: tuple[Any, ...], it: Record) -> Mapping[str, Any]:
    """The fields of an object's record, by name."""
    if where[0] == "bodies":
        return BodyRecord.model_fields
    form = form_of(it)
    assert form is not None
    return element_type(ROLES[where[0]], *form).model_fields


def _is_numeric(value: Any) -> bool:
    try:
        found = np.asarray(value)
    except ValueError:
        return False
    return found.dtype.kind in "iuf" and found.size > 0


def _get(record: Record, address: _Address) -> Any:
    """OptionError: an index or a name that there is not."""
    holder, key = _holder(record, address)
    return holder[key]


def _put(record: Record, address: _Address, value: Any, told: Collection[int]) -> None:
    """`told`: components of the point of its element that are given."""
    holder, key = _holder(record, address, told)
    holder[key] = float(value) if isinstance(value, int) else value
    if address.field == "at":
        it = _object_of(record, address)
        _attach(record, it, np.array(it["at"], dtype=float))


def _object_of(record: Record, address: _Address) -> Record:
    """The record of a body, joint or force element; that of the model."""
    it: Any = record
    for step in address.where:
        it = it[step]
    found: Record = it
    return found


def _holder(record: Record, address: _Address, told: Collection[int] = ()) -> tuple[Any, Any]:
    """The list or mapping that has the value, and its key there; fields that were left out are filled in."""
    it: Any = _object_of(record, address)
    if address.where:
        if address.field == "at":
            it["at"] = _at(record, it, address, told).tolist()
        elif address.field not in it:
            it[address.field] = copy.deepcopy(_type_of(address.where, it)[address.field].default)
        named = it[address.field]
        if isinstance(named, str) and named in record.get("functions", {}):
            it[address.field] = copy.deepcopy(record["functions"][named])
    key: Any = address.field
    for step in address.inside:
        it, key = it[key], step
        good = (isinstance(step, int) and isinstance(it, list) and step < len(it)) or (
            isinstance(step, str) and isinstance(it, dict) and step in it
        )
        if not good:
            known = list(it) if isinstance(it, dict) else []
            size = f"; indices are 0 to {len(it) - 1}" if isinstance(it, list) else ""
            raise OptionError(
                f"parameter '{address.name}': {address.field} has no part {step!r}"
                f"{size or nearest(str(step), known)}",
                code="parameters",
            )
    return it, key


def _pose(record: Record, body: str) -> tuple[Floats, Floats]:
    """Position and rotation matrix of a body, or of the ground."""
    if body == "ground":
        return np.zeros(3), np.eye(3)
    it = next(it for it in record["bodies"] if it["name"] == body)
    p = np.array(it.get("orientation", [1.0, 0.0, 0.0, 0.0]))
    return np.array(it.get("position", [0.0, 0.0, 0.0])), rotation.matrix(p / np.linalg.norm(p))


def _at(record: Record, it: Record, address: _Address, told: Collection[int]) -> Floats:
    """The point of an element (3,), inertial. OptionError: it has two, but for components that are `told`."""
    own = {"a": 0, "b": 1} if ATTACHED in it else {}
    given = {side: it[ATTACHED]["origin"][k] for side, k in own.items()} or {"b": it["at"]}
    poses = {side: _pose(record, it[side]) for side in given}
    points = [poses[side][0] + poses[side][1] @ np.array(s) for side, s in given.items()]
    size = max(1.0, *(float(np.abs(point).max()) for point in points))
    apart = np.ptp(points, axis=0)
    apart[list(told)] = 0.0
    if apart.max() > SAME_POINT * size:
        raise OptionError(
            f"parameter '{address.name}': '{it['name']}' has a point on each of its bodies: "
            f"'{it['name']}.attachment.origin[0]' and [1], in body coordinates",
            code="parameters",
        )
    return np.asarray(points[0])


def _attach(record: Record, it: Record, at: Floats) -> None:
    """Both bodies to the point `at`, inertial; the axes stay. Of a curve only the body that is on it."""
    local = {side: (A.T @ (at - r)).tolist() for side in ("a", "b") for r, A in [_pose(record, it[side])]}
    if ATTACHED in it:
        del it["at"]
        it[ATTACHED]["origin"] = [local["a"], local["b"]]
    else:
        it["at"] = local["b"]
