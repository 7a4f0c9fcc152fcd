"""What a model file may say, as pydantic models made from the registries of joints, forces and functions of
time.

A kind of joint or force has two forms in a file: *placed*, with the arguments of its method of `Model`
(`model.revolute(a, b, at=..., axis=...)`), and *attached*, with its points and axes in body coordinates,
which is how models are saved, exact to the last bit. A joint that is added to the compiled module has both at
once.
"""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cache, reduce
from operator import or_
from typing import Annotated, Any, Literal, get_origin, get_type_hints

from annotated_types import Len
from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Discriminator,
    Field,
    Tag,
    WithJsonSchema,
    create_model,
)
from pydantic_core import PydanticCustomError

from linkwork import _core, functions
from linkwork.functions.expressions import LONGEST
from linkwork.modeling.builder import ModelBuilder
from linkwork.modeling.elements import KINDS, Role, described
from linkwork.modeling.shapes import KINDS as SHAPES

__all__ = [
    "VERSION", "Attached", "Document", "Element", "Record", "document_type", "element_type",
    "json_schema",
]  # fmt: skip

#: Of the format.
VERSION = 1

#: Of a list that may be long: it ends with the first fault, or each of its entries would have one.
FIRST = Field(fail_fast=True)

Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Vector = Annotated[list[Number], Len(3, 3)]
Quaternion = Annotated[list[Number], Len(4, 4)]
Matrix = Annotated[list[Vector], Len(3, 3)]
Word = Annotated[str, Field(strict=True, min_length=1, max_length=1000)]


def _whole(value: Any) -> Any:
    """True and 1.0 are equal to 1."""
    if isinstance(value, bool | float):
        raise PydanticCustomError("literal_error", "is not {expected}", {"expected": VERSION})
    return value


FormatVersion = Annotated[Literal[1], BeforeValidator(_whole)]


def _either(one: Any, many: Any) -> Any:
    """`one`, or `many` of it: told apart by whether the list's first entry is a list."""
    nested = Discriminator(lambda value: "many" if _is_nested(value) else "one")
    return Annotated[Annotated[one, Tag("one")] | Annotated[many, Tag("many")], nested]


def _is_nested(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], list)


def _union(variants: Iterable[Any]) -> Any:
    return reduce(or_, variants)


def _list(of: Any, least: int = 0, most: int | None = None) -> Any:
    return Annotated[list[of], Len(least, most), FIRST]


def _mapping(of: Any) -> Any:
    return dict[Word, of]


def _pair(of: Any) -> Any:
    return Annotated[list[of], Len(2, 2)]


class Record(BaseModel):
    """A mapping with these keys and no others."""

    model_config = ConfigDict(extra="forbid", strict=True, protected_namespaces=())


class BodyRecord(Record):
    """A rigid body as it is at t = 0."""

    name: Word
    mass: Number = Field(ge=0, description="[kg], zero for a massless body")
    inertia: _either(Vector, Matrix) = Field(  # type: ignore[valid-type]
        description="about the center of mass, body axes [kg m2]: principal moments (3,) or rows (3, 3)"
    )
    position: Vector = Field([0.0, 0.0, 0.0], description="of the center of mass, inertial [m]")
    orientation: Quaternion = Field(
        [1.0, 0.0, 0.0, 0.0], description="unit Euler parameters, scalar first, body axes to inertial"
    )
    velocity: Vector = Field([0.0, 0.0, 0.0], description="of the center of mass, inertial [m/s]")
    omega: Vector = Field([0.0, 0.0, 0.0], description="angular velocity, body axes [rad/s]")
    inertia_as_is: bool = Field(False, description="take principal moments that no real body has")


# --- functions of time --------------------------------------------------------------------------------------


def _numbers() -> Any:
    row = Annotated[list[Number], FIRST]
    rows = Annotated[list[row], FIRST]
    levels = Discriminator(
        lambda value: ("number", "list", "rows")[isinstance(value, list) + _is_nested(value)]
    )
    return Annotated[
        Annotated[Number, Tag("number")] | Annotated[row, Tag("list")] | Annotated[rows, Tag("rows")],
        levels,
    ]


#: A number, or lists of them in each other.
Numbers = _numbers()


#: Of a mesh: rows of three numbers, or what linkwork.modeling.files.packed makes of many of them.
Rows = Annotated[
    Annotated[list[Annotated[list[Number], Len(3, 3)]], Tag("rows")]
    | Annotated[str, Field(strict=True, pattern="^(f4|f8|i4):"), Tag("text")],
    Discriminator(lambda value: "text" if isinstance(value, str) else "rows"),
]


def constructors() -> Mapping[str, Callable[..., functions.TimeFunction]]:
    """The functions of time that are data, by name: those of linkwork.functions."""
    return {
        name: value
        for name in functions.__all__
        if inspect.isfunction(value := getattr(functions, name))
        and name not in ("as_time_function", "with_breaks")
    }


def _argument_type(parameter: inspect.Parameter) -> Any:
    if parameter.kind is parameter.VAR_POSITIONAL:
        return Annotated[list[Number], Len(1), FIRST]
    if parameter.annotation in ("float", float):
        return Number
    if parameter.annotation in ("str", str):
        return Annotated[str, Field(strict=True, min_length=1, max_length=LONGEST)]
    return Numbers


#: How deep sums, and functions with breaks, can be in each other: the integral of an integral of a sum, and
#: what it starts from.
SUMS = 4


def _has_one(constructor: Callable[..., Any]) -> bool:
    """Whether a function takes one argument, or any number of one kind: it has no name in a file."""
    return len(inspect.signature(constructor).parameters) == 1


@cache
def _function_type(sums: int = SUMS) -> Any:
    """A mapping with one key, the name of a function, and its arguments; a sum has a list of functions, and
    what has breaks of its own a function."""
    variants = [Annotated[_variant(name), Tag(name)] for name in constructors()]
    if sums:
        fields: dict[str, Any] = {"sum": (_list(_function_type(sums - 1), 1), ...)}
        label = "sum" if sums == SUMS else f"sum {sums}"
        total = create_model(label, __base__=Record, __doc__="The sum of functions.", **fields)
        variants.append(Annotated[total, Tag("sum")])
        inner: dict[str, Any] = {
            "function": (_function_type(sums - 1), ...),
            "breaks": (Annotated[list[Number], Len(1), FIRST], ...),
        }
        arguments = create_model(f"{label} broken", __base__=Record, **inner)
        broken: dict[str, Any] = {"with_breaks": (arguments, ...)}
        what = "A function that is not smooth at these times [s], either."
        made = create_model(f"with_breaks {label}", __base__=Record, __doc__=what, **broken)
        variants.append(Annotated[made, Tag("with_breaks")])
    known = {*constructors(), "sum", "with_breaks"} if sums else set(constructors())

    def name_of(value: Any) -> str | None:
        names = [name for name in value if name in known] if isinstance(value, dict) else []
        return names[0] if names else None

    return Annotated[_union(variants), Discriminator(name_of)]


@cache
def _variant(name: str) -> type[Record]:
    constructor = constructors()[name]
    parameters = inspect.signature(constructor).parameters.values()
    summary = _documentation(constructor)
    fields: dict[str, Any] = {
        p.name: (_argument_type(p), ... if p.default is p.empty else p.default) for p in parameters
    }
    if _has_one(constructor):
        ((arguments, _),) = fields.values()
    else:
        arguments = create_model(f"{name} arguments", __base__=Record, __doc__=summary, **fields)
    whole: dict[str, Any] = {name: (arguments, ...)}
    made: type[Record] = create_model(name, __base__=Record, __doc__=summary, **whole)
    return made


def _documentation(constructor: Callable[..., Any]) -> str:
    """What a file can be told of a function of time: all but the errors and examples of Python."""
    text = (inspect.getdoc(constructor) or "").partition("\n\n    ")[0].partition("ModelError:")[0]
    return " ".join(text.split())


def argument_names(function: str) -> list[str]:
    """Of a function of time; empty where there is none of this name."""
    known = constructors()
    return list(inspect.signature(known[function]).parameters) if function in known else []


def _quantity_type() -> Any:
    """A number, the name of a function, or a function of time."""

    def form(value: Any) -> str:
        return "name" if isinstance(value, str) else "function" if isinstance(value, dict) else "number"

    return Annotated[
        Annotated[Number, Tag("number")]
        | Annotated[Word, Tag("name")]
        | Annotated[_function_type(), Tag("function")],
        Discriminator(form),
        Field(
            description="a number, the name of a function, or one such as {expression: 0.3 * sin(2 * pi * t)}"
        ),
    ]


# --- joints and forces --------------------------------------------------------------------------------------


class Element(Record):
    """A joint or force: its kind, its name, and what it acts on."""

    kind: Word
    name: Word | None = Field(None, description="without it the kind and a number")


class AttachmentRecord(Record):
    """Where an element sits on its bodies a and b, in body coordinates: the exact form of `at` and axes."""

    origin: _pair(Vector) = Field(description="its point in a and its point in b [m]")  # type: ignore[valid-type]
    frame: _pair(Matrix) = Field(  # type: ignore[valid-type]
        description="its axes in a and in b: rows of the rotation matrix whose columns are the axes x, y, z"
    )


class Attached(Element):
    """An element as it is saved."""

    a: Word = Field(description="name of a body, or ground")
    b: Word = Field(description="name of a body, or ground")
    attachment: AttachmentRecord


#: The methods of Model that are not called as their kind.
METHODS = {"applied": "force"}

#: Kinds that have no attached form.
SPECIAL = frozenset(kind.name for kind in _core.special_joint_kinds())

_BODY = Field(description="name of a body, or ground")


class CoupledRecord(Record):
    """A free coordinate of a joint that stands before."""

    joint: Word
    coordinate: Word | None = Field(None, description="not needed where the joint has only one")
    factor: Number


#: Types of the arguments that say where an element is.
_PLACES: Mapping[str, Any] = {
    "at": _either(Vector, _pair(Vector)),
    "axis": _either(Vector, _pair(Vector)),
    "x_axis": _either(Vector, _pair(Vector)),
    "normal": _either(Vector, _pair(Vector)),
    "axes": _pair(Vector),
    "orientation": _either(Quaternion, _pair(Quaternion)),
    "coordinates": _list(CoupledRecord, 1),
    "points": _list(Vector, 2),
}


def method_of(kind: str) -> Callable[..., Any]:
    """The method of Model that adds an element of this kind."""
    method: Callable[..., Any] = getattr(ModelBuilder, METHODS.get(kind, kind))
    return method


def _placed_fields(kind: Any) -> Iterator[tuple[str, Any]]:
    """(name, (type, default)) of the arguments of the kind's method."""
    method = method_of(kind.name)
    hints = get_type_hints(method) if not hasattr(method, "__signature__") else {}
    for parameter in list(inspect.signature(method).parameters.values())[1:]:
        name = parameter.name
        if name == "name":
            continue
        required = parameter.default is parameter.empty
        type_ = _field_type(kind, name, hints.get(name))
        if name in ("a", "b", "body"):
            yield name, (Word, _BODY)
        elif required:
            yield name, (type_, ...)
        else:
            yield name, (type_ if parameter.default is not None else type_ | None, _plain(parameter.default))


def _field_type(kind: Any, name: str, hint: Any) -> Any:
    if name == "frames":
        return Literal["space", "body"]
    if name in kind.parameters:
        return _parameter_type(kind.parameters[name])
    if f"{name}_x" in kind.parameters:
        return _list(_quantity_type(), 3, 3)
    if name in _PLACES:
        return _PLACES[name]
    if get_origin(hint) is Literal or hint in (str, bool, int):
        return hint
    return Numbers


def _plain(default: Any) -> Any:
    return list(default) if isinstance(default, tuple) else default


def _parameter_fields(kind: Any) -> Iterator[tuple[str, Any]]:
    """(name, (type, default)) of the parameters, which an attached element has by their own names."""
    for name, parameter in kind.parameters.items():
        type_ = _parameter_type(parameter)
        if parameter.initial_distance:
            yield name, (type_ | None, None)
        else:
            yield name, (type_, ... if parameter.usual is None else parameter.usual)


def _parameter_type(parameter: _core.ParameterInfo) -> Any:
    """Bounds are told; numbers beyond them are refused by the model."""
    text = described(parameter)
    if not parameter.constant:
        return Annotated[_quantity_type(), Field(description=text)]
    key = "exclusiveMinimum" if parameter.above else "minimum"
    extra: Any = None if parameter.least is None else {key: parameter.least}
    return Annotated[Number, Field(description=text, json_schema_extra=extra)]


#: A driver of a joint that stands before, by Model.drive; it is saved as the angle_driver or such that it is.
DRIVE = "drive"

#: What a driver can prescribe.
MOTIONS = ("position", "velocity", "acceleration")


def _drive_type() -> type[Element]:
    quantity: Any = (_quantity_type() | None, None)
    fields: dict[str, Any] = {
        "kind": (Literal["drive"], ...),
        "joint": (Word, ...),
        "coordinate": (Word | None, Field(None, description="not needed where the joint has only one")),
        **dict.fromkeys(MOTIONS, quantity),
    }
    documentation = " ".join((inspect.getdoc(ModelBuilder.drive) or "").partition("ModelError:")[0].split())
    return create_model("drive", __base__=Element, __doc__=documentation, **fields)


@cache
def quantities_of(type_: type[Element]) -> tuple[str, ...]:
    """The fields of an element that are numbers or functions of time."""
    kind = type_.model_fields["kind"].annotation.__args__[0]  # type: ignore[union-attr]
    if kind == DRIVE:
        return MOTIONS
    info = KINDS["joint"].get(kind) or KINDS["force"][kind]
    names = set(info.parameters) | {name.removesuffix("_x") for name in info.parameters}
    return tuple(name for name in type_.model_fields if name in names)


@cache
def element_type(role: Role, kind: str, attached: bool) -> type[Element]:
    """The record of one kind in one of its two forms."""
    if kind == DRIVE:
        return _drive_type()
    info = KINDS[role][kind]
    fields = dict(_parameter_fields(info) if attached else _placed_fields(info))
    name = f"{kind} {role}, attached" if attached else f"{kind} {role}"
    made: type[Element] = create_model(
        name,
        __base__=Attached if attached else Element,
        __doc__=info.documentation,
        kind=(Literal[kind], ...),
        **fields,
    )
    return made


def form_of(value: Any) -> tuple[str, bool] | None:
    """Kind, and whether attached, of an element of a file."""
    kind = value.get("kind") if isinstance(value, dict) else getattr(value, "kind", None)
    attached = "attachment" in value if isinstance(value, dict) else isinstance(value, Attached)
    return (kind, attached and kind not in (*SPECIAL, DRIVE)) if isinstance(kind, str) else None


def _elements_type(role: Role) -> Any:
    known = [*KINDS[role], DRIVE] if role == "joint" else list(KINDS[role])

    def tag(value: Any) -> str | None:
        form = form_of(value)
        return None if form is None or form[0] not in known else f"{form[0]} {form[1]}"

    variants = [
        Annotated[element_type(role, kind, attached), Tag(f"{kind} {attached}")]
        for kind in known
        for attached in (False, True)
        if kind not in (*SPECIAL, DRIVE) or not attached
        if attached or hasattr(ModelBuilder, METHODS.get(kind, kind))
    ]
    return Annotated[_union(variants), Discriminator(tag)]


# --- shapes -------------------------------------------------------------------------------------------------


class ShapesRecord(Record):
    """What bodies look like; it has no influence on the motion."""

    bodies: Annotated[list[Word], Len(1), FIRST] = Field(description="names of bodies, or ground")
    shapes: Annotated[list[Any], FIRST]


@cache
def _shapes_type() -> type[ShapesRecord]:
    """With every kind of linkwork.modeling.shapes."""
    variants = [Annotated[_shape_type(kind), Tag(kind)] for kind in SHAPES]

    def kind_of(value: Any) -> str | None:
        kind = value.get("kind") if isinstance(value, dict) else getattr(value, "kind", None)
        return kind if isinstance(kind, str) and kind in SHAPES else None

    each: Any = Annotated[_union(variants), Discriminator(kind_of)]
    fields: dict[str, Any] = {"shapes": (_list(each, 1), ...)}
    return create_model("shapes of bodies", __base__=ShapesRecord, __doc__=ShapesRecord.__doc__, **fields)


def _shape_type(kind: str) -> type[Record]:
    """The arguments of the shape's class, by name."""
    fields: dict[str, Any] = {"kind": (Literal[kind], ...)}
    for parameter in inspect.signature(SHAPES[kind]).parameters.values():
        type_ = Word if "str" in str(parameter.annotation) else Numbers
        if parameter.name in ("vertices", "triangles"):
            type_ = Rows
        default = ... if parameter.default is parameter.empty else _plain(parameter.default)
        fields[parameter.name] = (type_ if default is not None else type_ | None, default)
    return create_model(f"{kind} shape", __base__=Record, __doc__=SHAPES[kind].__doc__, **fields)


# --- the whole ----------------------------------------------------------------------------------------------

#: What a run takes is looked at as a run does it; what editors are told.
Setting = Annotated[
    Any,
    WithJsonSchema({"anyOf": [{"type": it} for it in ("boolean", "number", "string", "object", "array")]}),
]


class Document(Record):
    """A mechanism. SI units: m, kg, s, N, rad. Positions and velocities are inertial unless it is said."""

    linkwork: FormatVersion = Field(description="version of the format")
    units: Literal["SI"] = Field("SI", description="of everything in the file; there is no other choice")
    name: str = ""
    gravity: Vector = Field([0.0, 0.0, -9.81], description="acceleration, inertial [m/s2]")
    simulation: dict[str, Setting] = Field({}, description="recommended arguments of linkwork.simulate")
    functions: dict[Word, Any] = Field(
        {}, description="functions of time by name, for use by several elements"
    )
    bodies: Annotated[list[BodyRecord], FIRST] = []
    joints: Annotated[list[Any], FIRST] = []
    forces: Annotated[list[Any], FIRST] = []
    shapes: Annotated[list[Any], FIRST] = Field(
        [], description="what bodies look like; without influence on the motion"
    )
    history: Annotated[list[float], FIRST] = Field(
        [],
        description="history variables of couplers and forces at the initial time, such as full turns [rad]",
    )


@cache
def document_type() -> type[Document]:
    """The record of a whole file, with every registered kind."""
    fields: dict[str, Any] = {f"{role}s": (_list(_elements_type(role)), []) for role in KINDS}
    description = Document.model_fields["functions"].description
    shapes = Document.model_fields["shapes"].description
    fields["shapes"] = (_list(_shapes_type()), Field([], description=shapes))
    fields["functions"] = (_mapping(_function_type()), Field({}, description=description))
    made: type[Document] = create_model(
        "linkwork model", __base__=Document, __doc__=Document.__doc__, **fields
    )
    return made


def json_schema() -> dict[str, Any]:
    """The JSON schema (draft 2020-12) of model files; YAML files follow it as well."""
    schema = document_type().model_json_schema()
    out = {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}
    json.dumps(out)
    return out
