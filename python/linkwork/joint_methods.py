"""One method of Model for every registered joint, made from what the compiled module says about the joint.

A joint added there (one file, one line) appears here by itself, with its documentation. Type checkers read
joint_methods.pyi; `python -m linkwork.joint_methods --stub` prints it anew.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from inspect import Parameter, Signature
from typing import Any

from linkwork import _core

#: The arguments of each placement, with what they mean; a question mark: it can be left out.
_PLACES: dict[str, dict[str, str]] = {
    "point": {"at": "the joint's point (3,) [m]"},
    "axis": {
        "at": "the joint's point (3,) [m]",
        "axis": "the joint's axis (3,), of any length",
        "x_axis?": "the joint frame's x axis (3,); without it a perpendicular to the axis",
    },
    "two_axes": {
        "at": "the joint's point (3,) [m]",
        "axes": "the axis fixed in a and the axis fixed in b, perpendicular to each other: a pair of (3,)",
    },
    "two_points": {"at": "a point of a and a point of b: a pair of (3,) [m]"},
    "frame": {
        "at": "the joint's point (3,) [m]",
        "orientation?": "the joint frame's Euler parameters (4,), scalar first; without it the inertial axes",
    },
    "direction": {
        "axis": "the joint's axis (3,), of any length",
        "x_axis?": "the joint frame's x axis (3,); without it a perpendicular to the axis",
    },
    "two_directions": {
        "axes": "the axis fixed in a and the axis fixed in b, perpendicular to each other: a pair of (3,)",
    },
    "orientation": {
        "orientation?": "the joint frame's Euler parameters (4,), scalar first; without it the inertial axes",
    },
    "shafts": {
        "at": "the joint's point (3,) [m]",
        "axes": "the axes of the shafts a and b, both the same way through the joint: a pair of (3,)",
    },
    "centers": {
        "at": "a point on the axis of a and a point on that of b: a pair of (3,) [m]",
        "axis": "the direction (3,) of both axes, of any length",
    },
    "disc": {
        "at": "a point of the plane and the center of the disc: a pair of (3,) [m]",
        "axes": "the normal of the plane, toward the disc, and the axis of the disc: a pair of (3,)",
    },
}

#: What all methods share.
_COMMON = {
    "frames": '"space": points and axes are inertial, at the initial pose; "body": pairs, in a and in b',
    "name": "of the joint; without it the kind and a number",
}

_ERRORS = """\
ModelError: a point or axis that makes no sense, a body joined to itself, an unknown body, a taken name."""


class JointMethods:
    """The methods of Model that add a joint between bodies a and b."""


def _arguments(kind: _core.KindInfo) -> Iterator[tuple[str, bool, str]]:
    """(name, required, meaning) of a kind's own arguments."""
    for name, meaning in _PLACES[kind.placement].items():
        yield name.rstrip("?"), not name.endswith("?"), meaning
    for name in kind.parameters:
        if name == "length":
            yield name, False, "a number or a function of time [m]; without it the initial distance"
        elif name in kind.constants:
            yield name, True, "a whole number" if name in kind.whole_numbers else "a number"
        else:
            yield name, True, "a number or a function of time"


def _signature(kind: _core.KindInfo) -> Signature:
    keyword, nothing = Parameter.KEYWORD_ONLY, Parameter.empty
    parameters = [Parameter(name, Parameter.POSITIONAL_OR_KEYWORD) for name in ("self", "a", "b")]
    for name, required, _ in _arguments(kind):
        parameters.append(Parameter(name, keyword, default=nothing if required else None))
    parameters += [Parameter("frames", keyword, default="space"), Parameter("name", keyword, default=None)]
    return Signature(parameters)


def _documentation(kind: _core.KindInfo) -> str:
    meanings = {name: meaning for name, _, meaning in _arguments(kind)} | _COMMON
    arguments = "\n".join(f"{name:<{max(map(len, meanings))}}  {text}" for name, text in meanings.items())
    equations = f"{kind.rows} equation{'s' if kind.rows > 1 else ''}: {', '.join(kind.equations)}."
    if kind.velocity_rows:
        equations += f" The last {kind.velocity_rows} of velocities only (non-holonomic)."
    return f"{kind.documentation}\n\n{equations}\n\n{arguments}\n\n{_ERRORS}"


def _method(kind: _core.KindInfo) -> Callable[..., Any]:
    signature = _signature(kind)

    def add(*given: Any, **named: Any) -> Any:
        bound = signature.bind(*given, **named)
        bound.apply_defaults()
        values = dict(bound.arguments)
        model, a, b, frames, name = (values.pop(key) for key in ("self", "a", "b", "frames", "name"))
        return model._add_joint(kind.name, a, b, frames, name, values)

    add.__name__ = add.__qualname__ = kind.name
    add.__doc__ = _documentation(kind)
    add.__signature__ = signature  # type: ignore[attr-defined]
    return add


for _kind in _core.joint_kinds():
    setattr(JointMethods, _kind.name, _method(_kind))


def stub() -> str:
    """The text of joint_methods.pyi."""
    return _STUB_HEAD + "\n".join(_stub_method(kind) for kind in _core.joint_kinds())


_STUB_HEAD = '''\
"""Printed by `python -m linkwork.joint_methods --stub`."""

from numpy.typing import ArrayLike

from linkwork.functions import TimeFunctionLike
from linkwork.handles import BodyLike, Joint
from linkwork.placement import Frames

def stub() -> str: ...

class JointMethods:
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
        type_ = "TimeFunctionLike" if name in kind.parameters and name not in kind.constants else "ArrayLike"
        optional = "" if required else " | None = None"
        lines.append(f"        {name}: {type_}{optional},")
    lines += ['        frames: Frames = "space",', "        name: str | None = None,", "    ) -> Joint:"]
    return "\n".join([*lines, f'        """{kind.documentation}"""', ""])


if __name__ == "__main__":
    if sys.argv[1:] != ["--stub"]:
        sys.exit("usage: python -m linkwork.joint_methods --stub")
    print(stub(), end="")
