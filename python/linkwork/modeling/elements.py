"""Joints and force elements on their way to the compiled model: from arguments to checked arrays."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from linkwork import _core
from linkwork.arguments import UNREADABLE, one_of, reals
from linkwork.arrays import Floats, Indices
from linkwork.errors import OptionError, about, nearest
from linkwork.functions import TimeFunction, as_time_function, infinite_derivative
from linkwork.modeling.placement import PLACEMENTS, Attachment, Poses, Subject, attach

Role = Literal["joint", "force"]

#: What a parameter can be: values (k,), or one function of time for all.
Parameter = Floats | TimeFunction

KINDS: Mapping[Role, Mapping[str, _core.KindInfo]] = {
    "joint": {kind.name: kind for kind in (*_core.joint_kinds(), *_core.special_joint_kinds())},
    "force": {kind.name: kind for kind in _core.force_kinds()},
}


@dataclass(frozen=True)
class Elements:
    """k elements of one kind between the bodies (k, 2)."""

    info: _core.KindInfo
    subject: Subject
    bodies: Indices
    place: Attachment
    parameters: Mapping[str, Parameter]

    def add_to(self, core: _core.Model) -> dict[int, TimeFunction]:
        """Hand over to the compiled model; gives back its functions by their indices there.

        ModelError: what that refuses, such as a body joined to itself.
        """
        functions: dict[int, TimeFunction] = {}
        values = np.zeros((self.subject.count, len(self.info.parameters)))
        signals = np.full(values.shape, -1, np.int32)
        for column, what in enumerate(self.info.parameters):
            parameter = self.parameters[what]
            if isinstance(parameter, TimeFunction):
                function = parameter.compiled()
                if self.info.parameters[what].takes == "characteristic":
                    function = _core.TimeFunction.characteristic(function, self._meaning(what))
                index = core.add_signal(function)
                signals[:, column], functions[index] = index, parameter
            else:
                values[:, column] = parameter
        add = core.add_joints if self.info.name in KINDS["joint"] else core.add_forces
        add(
            self.info.name,
            self.subject.names,
            self.bodies,
            self.place.origin,
            self.place.frame,
            values,
            signals,
        )
        return functions

    def _meaning(self, what: str) -> str:
        """Of a characteristic: whose it is, and what over what."""
        law, _, _ = self.info.parameters[what].meaning.partition(",")
        more = f" and {self.subject.count - 1} more" if self.subject.count > 1 else ""
        return f"{self.subject.who(0)}{more}: {what}, {law},"

    def signals(self, *takes: str) -> list[tuple[str, TimeFunction]]:
        """The functions of time, each with what it drives; `takes`: of parameters that take these alone."""
        return self._given(takes or ("function", "differentiable"))

    def characteristics(self) -> list[tuple[str, TimeFunction]]:
        """The functions of coordinates, each with what it is."""
        return self._given(("characteristic",))

    def _given(self, takes: Sequence[str]) -> list[tuple[str, TimeFunction]]:
        return [
            (f"{self.subject.who(0)}: {what}", parameter)
            for what, parameter in self.parameters.items()
            if isinstance(parameter, TimeFunction) and self.info.parameters[what].takes in takes
        ]


def kind_info(role: Role, name: str) -> _core.KindInfo:
    """OptionError: there is no such kind."""
    return KINDS[role][one_of(name, KINDS[role], f"{role} kind", "unknown_kind")]


def placed(
    info: _core.KindInfo,
    subject: Subject,
    bodies: Indices,
    poses: Callable[[Indices], Poses],
    in_bodies: bool,
    arguments: Mapping[str, Any],
) -> Elements:
    """Elements from the arguments of their placement, in space or `in_bodies`, and their parameters."""
    if info.placement not in PLACEMENTS:
        message = f"{info.name} joints are added one by one, by linkwork.Model.{info.name}"
        raise OptionError(message, code="one_by_one")
    where = {what: value for what, value in arguments.items() if what not in info.parameters}
    _check_names(info, subject, where)
    place = attach(PLACEMENTS[info.placement], subject, bodies, poses, where if in_bodies else (), where)
    return with_parameters(info, subject, bodies, place, arguments)


def _check_names(info: _core.KindInfo, subject: Subject, where: Mapping[str, Any]) -> None:
    """ModelError: an argument that there is not, or one that is missing."""
    arguments = list(inspect.signature(PLACEMENTS[info.placement]).parameters.values())[1:]
    known = [it.name for it in arguments] + list(info.parameters)
    check_known(subject, where, known)
    for it in arguments:
        if it.default is it.empty and it.name not in where:
            subject.refuse(0, f"{it.name} is missing", "missing", it.name)


def check_known(subject: Subject, names: Iterable[str], known: Collection[str]) -> None:
    """ModelError: an argument that there is not."""
    for name in names:
        if name not in known:
            subject.refuse(0, f"'{name}' is none of its arguments{nearest(name, known)}", "argument", name)


def in_components(info: _core.KindInfo, subject: Subject, arguments: Mapping[str, Any]) -> dict[str, Any]:
    """With stiffness_x, ... for a vector `stiffness`, where the kind has such. ModelError: both are given."""
    out: dict[str, Any] = {}
    for what, value in arguments.items():
        vector = f"{what}_x" in info.parameters
        parts = subject.components(value, what) if vector else {what: value}
        if twice := (parts.keys() & arguments.keys()) - {what}:
            subject.refuse(0, f"{what} and {min(twice)} are both given: give one of them", "argument", what)
        out |= parts
    return out


def with_parameters(
    info: _core.KindInfo, subject: Subject, bodies: Indices, place: Attachment, given: Mapping[str, Any]
) -> Elements:
    """Elements at a place that is known."""
    parameters = {
        what: _parameter(subject, it, given.get(what), place) for what, it in info.parameters.items()
    }
    if "length" in parameters:
        _check_length(subject, place, parameters["length"])
    return Elements(info, subject, bodies, place, parameters)


def described(parameter: _core.ParameterInfo) -> str:
    """What it is, its unit, what it may be, and its default."""
    unit = f" [{parameter.unit}]" if parameter.unit else ""
    number = "a whole number" if parameter.takes == "whole_number" else "a number"
    if parameter.takes == "characteristic":
        number = "a characteristic, or a number for a linear one"
    elif not parameter.constant:
        number += " or a function of time"
    elif parameter.least is None:
        number += ", not zero"
    words = [f"{parameter.meaning}{unit}", number]
    if parameter.least is not None:
        words.append(f"{'above' if parameter.above else 'at least'} {parameter.least:g}")
    if parameter.not_above:
        words.append(f"not above {parameter.not_above}")
    if parameter.initial_distance:
        words.append("by default the initial distance")
    return ", ".join(words) + (f"; {parameter.usual:g}" if parameter.usual is not None else "")


def _parameter(subject: Subject, info: _core.ParameterInfo, given: Any, place: Attachment) -> Parameter:
    what = info.name
    if given is None and info.initial_distance:
        return place.distance
    if given is None:
        given = info.usual
    if given is None:
        subject.refuse(0, f"{what} is missing", "missing", what)
    if subject.group and not isinstance(given, TimeFunction) and not callable(given):
        try:
            if np.shape(given) == (subject.count,):
                return reals(given, texts=True)
        except UNREADABLE:
            subject.refuse(0, f"{what} {given!r:.80} is not made of numbers", "not_a_number", what)
    with about(what, subject.who(0)):
        parameter = as_time_function(given, f"{subject.who(0)}: {what}")
    if not isinstance(parameter, TimeFunction):
        return np.full(subject.count, parameter)
    if info.takes == "differentiable" and not parameter.has_derivatives:
        remedy = "a tuple of functions (f, df, ddf), or one of linkwork.functions such as table(t, values)"
        subject.refuse(0, f"{what} enters with its time derivatives: give {remedy}", "derivatives", what)
    if info.takes == "differentiable" and (why := infinite_derivative(parameter)):
        subject.refuse(0, f"{what}: {why}", "derivatives", what)
    return parameter


def _check_length(subject: Subject, place: Attachment, length: Parameter) -> None:
    """A distance of zero has no direction, so the joint would lose its equation."""
    start = np.full(subject.count, length.evaluate(0.0)[0]) if isinstance(length, TimeFunction) else length
    subject.check(start > 0, lambda k: f"length {start[k]:.6g} m must be positive", "length", "length")
    subject.check(place.distance > 0, lambda k: "its two points coincide at the initial pose", "length", "at")
