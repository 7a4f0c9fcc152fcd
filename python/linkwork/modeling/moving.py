"""Where an element is when some of what says so is given anew: the rest stays as it is.

A model knows points and axes in bodies, whatever they were made from. What is not given is found from these.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Collection, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork import _core, functions, rotation
from linkwork.arguments import one_of
from linkwork.arrays import Floats, Indices
from linkwork.modeling.elements import check_known, in_components, kind_info
from linkwork.modeling.placement import PLACEMENTS, Attachment, Poses, Subject, attach

if TYPE_CHECKING:
    from linkwork.modeling.elements import Role
    from linkwork.modeling.model import Model

__all__ = ["ATTACHED", "moved"]

#: Where an element sits, by points and axes in its bodies; whoever places it anew says so in another way.
ATTACHED = "attachment"

#: What has a name in every element.
COMMON = ("name", "a", "b", "frames", "breaks")

#: Placements whose axes follow from their points.
THROUGH_POINTS = ("two_points", "centers")

#: What is off by so little, relative to lengths, is where it was.
ROUNDING = 1e-14

#: Axes up to here are those that are taken where none are given [rad].
USUAL = 1e-9

#: The arguments of placements in body coordinates, from points (2, 3) and axes (2, 3, 3) in a and b.
KEPT: Mapping[str, Callable[[Floats, Floats], Any]] = {
    "at": lambda origin, frame: tuple(origin),
    "axis": lambda origin, frame: tuple(frame[:, :, 2]),
    "x_axis": lambda origin, frame: tuple(frame[:, :, 0]),
    "axes": lambda origin, frame: tuple(frame[:, :, 2]),
    "normal": lambda origin, frame: frame[0, :, 2],
    "orientation": lambda origin, frame: tuple(rotation.from_matrix(frame)),
}

Record = dict[str, Any]


def moved(model: Model, role: Role, old: Mapping[str, Any], changes: Mapping[str, Any]) -> Record:
    """The changes of an element's record, with points and axes in its bodies for what says where it is.

    ModelError: an argument that its kind has not, or that makes no sense there.
    """
    info, subject = kind_info(role, old["kind"]), Subject(old["kind"], old["name"], False, 1)
    words, parameters = _words(info, changes), set(info.parameters)
    vectors = {what.removesuffix("_x") for what in parameters if what.endswith("_x")}
    check_known(subject, changes, [*COMMON, *words, *info.parameters, *vectors])
    own = {what: x for what, x in changes.items() if what in parameters | vectors}
    own = functions.broken(in_components(info, subject, own), changes.get("breaks", ()), subject.who(0))
    out = {what: changes[what] for what in ("name", "a", "b") if what in changes} | own
    where = {what: changes[what] for what in words if what in changes}
    origin, frame = (np.array(old[ATTACHED][what], dtype=float) for what in ("origin", "frame"))
    if _as_force(info, changes):
        return out | _applied(subject, old, {**where, **out}, origin, frame)
    if where:
        bodies = [model._bodies.pair(it["a"], it["b"], subject) for it in (old, {**old, **out})]
        ends = [model._bodies.poses(it[0]) for it in bodies]
        origin, frame = _on_others(origin, frame, *ends)
        inside = (
            where if one_of(changes.get("frames", "space"), ("space", "body"), "frames") == "body" else ()
        )
        origin, frame = _placed(info, subject, bodies[1], model._bodies.poses, (origin, frame), where, inside)
    return out | {ATTACHED: {"origin": origin.tolist(), "frame": frame.tolist()}}


def _as_force(info: _core.KindInfo, changes: Mapping[str, Any]) -> bool:
    """Whether in the words of Model.force."""
    return info.name == "applied" and "frames" not in changes


def _words(info: _core.KindInfo, changes: Mapping[str, Any]) -> list[str]:
    """The arguments that say where an element is."""
    if _as_force(info, changes):
        return ["at", "frame", "body"]
    return list(inspect.signature(PLACEMENTS[info.placement]).parameters)[1:]


def _applied(
    subject: Subject, old: Mapping[str, Any], given: Mapping[str, Any], origin: Floats, frame: Floats
) -> Record:
    """Bodies, points and axes of an applied force, by the arguments of Model.force."""
    on_itself = old["a"] == old["b"]
    b = given.get("body", given.get("b", old["b"]))
    a = given.get("a", b if on_itself else old["a"])
    if "at" in given:
        origin[1] = subject.array(given["at"], 3, "at")[0]
    if "frame" in given:
        a = "ground" if one_of(given["frame"], ("inertial", "body"), "frame") == "inertial" else b
        frame[0] = np.eye(3)
    return {"a": a, "b": b, ATTACHED: {"origin": origin.tolist(), "frame": frame.tolist()}}


def _on_others(origin: Floats, frame: Floats, old: Poses, new: Poses) -> tuple[Floats, Floats]:
    """Points and axes in other bodies that are where they are in space at the initial pose."""
    if np.array_equal(old.r, new.r) and np.array_equal(old.A, new.A):
        return origin, frame
    return new.body_point(old.point(origin)), np.swapaxes(new.A, 1, 2) @ old.A @ frame


def _placed(
    info: _core.KindInfo,
    subject: Subject,
    bodies: Indices,
    poses: Callable[[Indices], Poses],
    old: tuple[Floats, Floats],
    where: Mapping[str, Any],
    in_bodies: Collection[str],
) -> tuple[Floats, Floats]:
    """Points and axes by what is given `where` it is, and for the rest those that there are."""
    words = inspect.signature(PLACEMENTS[info.placement]).parameters
    origin, frame = old
    kept = {what: KEPT[what](origin, frame) for what in list(words)[1:] if what not in where}
    if "axis" in where and "x_axis" in kept and _is_usual(poses(bodies[0]).A @ frame):
        del kept["x_axis"]
    found: Attachment = attach(
        PLACEMENTS[info.placement], subject, bodies, poses, {*in_bodies, *kept}, {**kept, **where}
    )
    through = info.placement in THROUGH_POINTS
    if through or "at" in where:
        size = np.abs([*poses(bodies[0]).r, *origin]).max()
        origin = _but_for_rounding(found.origin[0], origin, size)
    if through or where.keys() - {"at"}:
        frame = _but_for_rounding(found.frame[0], frame, 1.0)
    if info.placement == "centers" and "at" not in where and frame is not old[1]:
        subject.refuse(0, "at is missing: along another axis its points are not known", "missing", "at")
    return origin, frame


def _is_usual(axes: Floats) -> bool:
    """Whether x of both (2, 3, 3), in space, is that which an axis has without an `x_axis`."""
    usual = rotation.perpendicular(axes[:, :, 2])
    return bool(np.abs(axes[:, :, 0] - usual).max() <= USUAL)


def _but_for_rounding(found: Floats, old: Floats, size: float) -> Floats:
    """What is found, or what there was where it is the same."""
    return old if np.abs(found - old).max() <= ROUNDING * size else found
