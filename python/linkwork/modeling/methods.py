"""One method of Model for every registered joint and force, made from what the compiled module says about it.

One added there (one file, one line) appears here by itself, with its documentation. Type checkers read
methods.pyi; `./dev stubs` writes it.
"""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterator
from inspect import Parameter, Signature
from typing import Any

from linkwork import _core
from linkwork.modeling.elements import described

#: The arguments of each placement, with what they mean; a question mark: it can be left out.
_PLACES: dict[str, dict[str, str]] = {
    "point": {"at": "its point (3,) [m]"},
    "axis": {
        "at": "its point (3,) [m]",
        "axis": "the axis (3,), of any length",
        "x_axis?": "the frame's x axis (3,); without it a perpendicular to the axis",
    },
    "two_axes": {
        "at": "its point (3,) [m]",
        "axes": "the axis fixed in a and the axis fixed in b, perpendicular to each other: a pair of (3,)",
    },
    "two_points": {"at": "a point of a and a point of b: a pair of (3,) [m]"},
    "frame": {
        "at": "its point (3,) [m]",
        "orientation?": "the frame's Euler parameters (4,), scalar first; without it the inertial axes",
    },
    "direction": {
        "axis": "the axis (3,), of any length",
        "x_axis?": "the frame's x axis (3,); without it a perpendicular to the axis",
    },
    "two_directions": {
        "axes": "the axis fixed in a and the axis fixed in b, perpendicular to each other: a pair of (3,)",
    },
    "orientation": {
        "orientation?": "the frame's Euler parameters (4,), scalar first; without it the inertial axes",
    },
    "shafts": {
        "at": "its point (3,) [m]",
        "axes": "the axes of the shafts a and b, both the same way through the joint: a pair of (3,)",
    },
    "centers": {
        "at": "a point on the axis of a and a point on that of b: a pair of (3,) [m]",
        "axis": "the direction (3,) of both axes, of any length",
    },
    "plane": {
        "at": "a point of the plane and a point of b: a pair of (3,) [m]",
        "normal": "of the plane (3,), toward b, of any length; fixed in a",
    },
    "disc": {
        "at": "a point of the plane and the center of the disc: a pair of (3,) [m]",
        "axes": "the normal of the plane, toward the disc, and the axis of the disc: a pair of (3,)",
    },
}

#: Where the examples put an element between the ground and a body whose center is at (1, 0, 0).
_EXAMPLES = {
    "point": {"at": "(0, 0, 0)"},
    "axis": {"at": "(0, 0, 0)", "axis": "(0, 1, 0)"},
    "two_axes": {"at": "(0, 0, 0)", "axes": "((0, 1, 0), (0, 0, 1))"},
    "two_points": {"at": "((0, 0, 0), (1, 0, 0))"},
    "frame": {"at": "(0, 0, 0)"},
    "direction": {"axis": "(0, 1, 0)"},
    "two_directions": {"axes": "((0, 1, 0), (0, 0, 1))"},
    "orientation": {},
    "shafts": {"at": "(0, 0, 0)", "axes": "((1, 0, 0), (1, 0.1, 0))"},
    "centers": {"at": "((0, 0, 0), (1, 0, 0))", "axis": "(0, 1, 0)"},
    "plane": {"at": "((0, 0, -0.1), (1, 0, 0))", "normal": "(0, 0, 1)"},
    "disc": {"at": "((0, 0, -0.1), (1, 0, 0))", "axes": "((0, 0, 1), (0, 1, 0))"},
}

#: What all methods share.
_COMMON = {
    "frames": '"space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b',
    "name": "without it the kind and a number",
}

_BREAKS = "times [s] at which Python functions are not smooth, see functions.with_breaks"

_ERRORS = """\
ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name."""

#: Forces whose methods have a form of their own in Model.
_OWN = ("applied", "spring_damper", "rotational_spring_damper", "bushing")


class JointMethods:
    """The methods of Model that add a joint between bodies a and b."""


class ForceMethods:
    """The methods of Model that add a force element between bodies a and b."""


def _default(kind: _core.KindInfo, name: str) -> float | None:
    """Of a parameter; None: there is none."""
    return kind.parameters[name].usual if name in kind.parameters else None


def _arguments(kind: _core.KindInfo) -> Iterator[tuple[str, bool, str]]:
    """(name, required, meaning) of a kind's own arguments."""
    for name, meaning in _PLACES[kind.placement].items():
        yield name.rstrip("?"), not name.endswith("?"), meaning
    for name, parameter in kind.parameters.items():
        yield name, parameter.usual is None and not parameter.initial_distance, described(parameter)


def _of_time(kind: _core.KindInfo) -> bool:
    """Whether it has parameters that can be functions of time."""
    return any(not (it.constant or it.takes == "characteristic") for it in kind.parameters.values())


def _signature(kind: _core.KindInfo) -> Signature:
    keyword, nothing = Parameter.KEYWORD_ONLY, Parameter.empty
    bodies = {"self": nothing, "a": "BodyLike", "b": "BodyLike"}
    parameters = [
        Parameter(name, Parameter.POSITIONAL_OR_KEYWORD, annotation=it) for name, it in bodies.items()
    ]
    for name, required, _ in _arguments(kind):
        default = nothing if required else _default(kind, name)
        optional = "" if required or default is not None else " | None"
        type_ = _type_of(kind, name) + optional
        parameters.append(Parameter(name, keyword, default=default, annotation=type_))
    if _of_time(kind):
        parameters.append(Parameter("breaks", keyword, default=(), annotation="ArrayLike"))
    parameters.append(Parameter("frames", keyword, default="space", annotation="Frames"))
    parameters.append(Parameter("name", keyword, default=None, annotation="str | None"))
    return Signature(parameters, return_annotation=_returned(kind))


def _type_of(kind: _core.KindInfo, name: str) -> str:
    """Of an argument, as in the stubs."""
    parameter = kind.parameters.get(name)
    return "VectorLike" if parameter is None else "Number" if parameter.constant else "TimeFunctionLike"


def _returned(kind: _core.KindInfo) -> str:
    return "Joint" if kind.rows else "Force"


def _example(kind: _core.KindInfo) -> str:
    """Two lines that add one."""
    values = dict(_EXAMPLES[kind.placement])
    for name, parameter in kind.parameters.items():
        if parameter.usual is None and not parameter.initial_distance:
            law = "lambda x: 10.0 * x" if parameter.takes == "characteristic" else f"{parameter.example:g}"
            values[name] = law
    given = "".join(f", {name}={value}" for name, value in values.items())
    body = 'body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))'
    return f'    {body}\n    model.{kind.name}("ground", body{given})'


def _documentation(kind: _core.KindInfo) -> str:
    breaks = {"breaks": _BREAKS} if _of_time(kind) else {}
    meanings = {name: meaning for name, _, meaning in _arguments(kind)} | breaks | _COMMON
    arguments = "\n".join(f"{name:<{max(map(len, meanings))}}  {text}" for name, text in meanings.items())
    parts = [kind.documentation, _example(kind), arguments, _ERRORS]
    if kind.rows:
        equations = f"{kind.rows} equation{'s' if kind.rows > 1 else ''}: {', '.join(kind.equations)}."
        if kind.velocity_rows:
            equations += f" The last {kind.velocity_rows} of velocities only (non-holonomic)."
        parts.insert(1, equations)
    return "\n\n".join(parts)


def _method(kind: _core.KindInfo) -> Callable[..., Any]:
    signature = _signature(kind)

    def add(*given: Any, **named: Any) -> Any:
        try:
            bound = signature.bind(*given, **named)
        except TypeError as error:
            raise TypeError(f"{kind.name}(): {error}") from None
        bound.apply_defaults()
        values = dict(bound.arguments)
        model, a, b, frames, name = (values.pop(key) for key in ("self", "a", "b", "frames", "name"))
        hand_over = model._add_joint if kind.rows else model._add_force
        return hand_over(kind.name, a, b, frames, name, values)

    add.__name__ = add.__qualname__ = kind.name
    add.__doc__ = _documentation(kind)
    add.__annotations__ = {}
    add.__signature__ = signature  # type: ignore[attr-defined]
    return add


def _forces() -> list[_core.KindInfo]:
    return [kind for kind in _core.force_kinds() if kind.name not in _OWN]


for _kind in _core.joint_kinds():
    setattr(JointMethods, _kind.name, _method(_kind))
for _kind in _forces():
    setattr(ForceMethods, _kind.name, _method(_kind))


def stub() -> str:
    """The text of methods.pyi."""
    joints = "\n".join(_stub_method(kind) for kind in _core.joint_kinds())
    forces = "\n".join(_stub_method(kind) for kind in _forces())
    return f"{_STUB_HEAD}class JointMethods:\n{joints}\nclass ForceMethods:\n{forces}"


_STUB_HEAD = '''\
"""Written by `./dev stubs`."""

from numpy.typing import ArrayLike

from linkwork.arrays import Number, VectorLike
from linkwork.functions import TimeFunctionLike
from linkwork.modeling.handles import BodyLike, Force, Joint
from linkwork.modeling.placement import Frames

def stub() -> str: ...

'''


def _stub_method(kind: _core.KindInfo) -> str:
    lines = [
        f"    def {kind.name}(",
        "        self,",
        "        a: BodyLike,",
        "        b: BodyLike,",
        "        *,",
    ]
    for name, required, _ in _arguments(kind):
        type_ = _type_of(kind, name)
        default = _default(kind, name)
        optional = "" if required else " | None = None" if default is None else f" = {default!r}"
        lines.append(f"        {name}: {type_}{optional},")
    if _of_time(kind):
        lines.append("        breaks: ArrayLike = (),")
    lines += [
        '        frames: Frames = "space",',
        "        name: str | None = None,",
        f"    ) -> {_returned(kind)}:",
    ]
    text = textwrap.indent(_documentation(kind), " " * 8).lstrip()
    return "\n".join([*lines, f'        """{text}\n        """', ""])
