"""Results for other tools: a table with a column a number, for pandas and CSV, and a data set for xarray.

QUANTITIES says what there is, with shape and unit; everything else follows from it.
"""

from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from linkwork.arguments import check_new, is_iterable, one_of, optional_package
from linkwork.arrays import Floats
from linkwork.errors import OptionError
from linkwork.modeling.coordinates import known_coordinates
from linkwork.modeling.elements import KINDS
from linkwork.modeling.handles import Named
from linkwork.motion.header import VIOLATION_UNITS
from linkwork.motion.records import ForceResult
from linkwork.replacement import replacing
from linkwork.results.joint_motion import each_coordinate

if TYPE_CHECKING:
    import pandas
    import xarray

    from linkwork.results.result import Result

__all__ = ["FORCES", "QUANTITIES", "Choice", "to_csv", "to_frame", "to_xarray"]

XYZ, EULER = ("x", "y", "z"), ("e0", "e1", "e2", "e3")


@dataclass(frozen=True)
class Quantity:
    """Something recorded: of each body or joint, or of the whole."""

    of: Literal["body", "joint", "run"]
    components: tuple[str, ...]  #: of one of them; none: it is a number
    unit: str
    long_name: str
    values: Callable[[Result], Floats]  #: (k, bodies or joints, components)


class OfForces(NamedTuple):
    """What a ForceResult has, by the name of its attribute."""

    components: tuple[str, ...]
    unit: str
    long_name: str


QUANTITIES: dict[str, Quantity] = {
    "position": Quantity(
        "body", XYZ, "m", "center of mass", lambda it: it.position),
    "orientation": Quantity(
        "body", EULER, "1", "Euler parameters, from body to inertial axes", lambda it: it.orientation),
    "velocity": Quantity(
        "body", XYZ, "m/s", "of the center of mass", lambda it: it.velocity),
    "omega": Quantity(
        "body", XYZ, "rad/s", "angular velocity in body axes", lambda it: it.omega),
    "acceleration": Quantity(
        "body", XYZ, "m/s2", "of the center of mass", lambda it: it.acceleration),
    "angular_acceleration": Quantity(
        "body", XYZ, "rad/s2", "in body axes", lambda it: it.angular_acceleration),
    "reaction_force": Quantity(
        "joint", XYZ, "N", "on the second body, inertial axes", lambda it: it.reactions().force),
    "reaction_torque": Quantity(
        "joint", XYZ, "N m", "on the second body about the joint's point, inertial axes",
        lambda it: it.reactions().torque),
    "kinetic_energy": Quantity("run", (), "J", "kinetic energy", lambda it: it.kinetic_energy),
    "potential_energy": Quantity("run", (), "J", "of gravity and springs", lambda it: it.potential_energy),
    "work": Quantity("run", (), "J", "done since the start by what has no potential", lambda it: it.work),
    "energy_error": Quantity(
        "run", (), "J", "energy that the method made or lost", lambda it: it.energy_error),
    "violation": Quantity(
        "run", ("position", "velocity", "acceleration"), ", ".join(VIOLATION_UNITS),
        "largest violation of the constraints", lambda it: it.violation),
}  # fmt: skip

#: The coordinates of joints, with the unit of each; its rate has that a second.
COORDINATES = {"angle": "rad", "angle_a": "rad", "angle_b": "rad", "displacement": "m"}


FORCES: dict[str, OfForces] = {
    "force": OfForces(XYZ, "N", "of a force element on its second body, inertial axes"),
    "torque": OfForces(
        XYZ, "N m", "of a force element on its second body about its point there, inertial axes"
    ),
    "power": OfForces((), "W", "that a force element gives to the bodies"),
    "potential": OfForces((), "J", "energy stored in a force element"),
    "deflection": OfForces((), "m", "of springs beyond what they have when free"),
    "deflection_angle": OfForces((), "rad", "of springs about an axis beyond what they have when free"),
}


@dataclass(frozen=True)
class Choice:
    """Which part of a result: names of bodies, joints, forces and quantities; all where none are given.

    Beside those of QUANTITIES and FORCES there is "coordinate": angles and displacements of joints, with
    their rates. Files have no laws of forces: these are not among all of theirs.
    """

    bodies: Sequence[Named] | None = None
    joints: Sequence[Named] | None = None
    quantities: Sequence[str] | None = None
    forces: Sequence[str | int] | None = None

    def names(self, result: Result) -> list[str]:
        """OptionError: no such quantity."""
        known = [*QUANTITIES, "coordinate", *FORCES]
        if self.quantities is not None:
            _check_list("quantities", self.quantities)
            return [one_of(name, known, "quantity") for name in self.quantities]
        without = () if self.forces is not None or result.header.force_element is not None else FORCES
        return [name for name in known if name not in without]

    def of_forces(self, result: Result) -> dict[str, ForceResult]:
        """ModelError: no such force element. OptionError: a file, which has no laws."""
        names = result.header.force_names
        chosen: Sequence[int] = range(len(names))
        if self.forces is not None:
            _check_list("forces", self.forces)
            chosen = [result.index("force", it) for it in self.forces]
        return {names[k]: result.force(k) for k in chosen}

    def places(self, result: Result, of: Literal["body", "joint"]) -> list[int]:
        """ModelError: no such body or joint."""
        names = self.bodies if of == "body" else self.joints
        if names is None:
            return list(range(len(result.body_names if of == "body" else result.joint_names)))
        _check_list("bodies" if of == "body" else "joints", names)
        return [result.index(of, name) for name in names]


def _check_list(what: str, names: object) -> None:
    """OptionError: one name, or none at all, where a list of them is wanted."""
    if isinstance(names, str) or not is_iterable(names):
        raise OptionError(f"{what} {names!r:.80} is no list of names", code="names")


class Column(NamedTuple):
    """A number over time: `crank.position.x`."""

    name: str
    unit: str
    values: Floats  # (k,)

    @property
    def label(self) -> str:
        return f"{self.name} [{self.unit}]"


def columns(result: Result, choice: Choice) -> Iterator[Column]:
    """Without the time."""
    names = choice.names(result)
    forces = choice.of_forces(result) if FORCES.keys() & names else {}
    for name in names:
        if name == "coordinate":
            yield from _coordinates(result, choice)
            continue
        if name in FORCES:
            yield from _forces(result, name, forces)
            continue
        it = QUANTITIES[name]
        values, parts = it.values(result), [f".{component}" for component in it.components] or [""]
        if it.of == "run":
            units = VIOLATION_UNITS if name == "violation" else (it.unit,)
            for k, part in enumerate(parts):
                yield Column(name + part, units[k], values.reshape(len(result), len(parts))[:, k])
            continue
        owners = result.body_names if it.of == "body" else result.joint_names
        for place in choice.places(result, it.of):
            for k, part in enumerate(parts):
                yield Column(f"{owners[place]}.{name}{part}", it.unit, values[:, place, k])


def _coordinates(result: Result, choice: Choice) -> Iterator[Column]:
    kinds, joints = result.header.joint_kinds, choice.places(result, "joint")
    chosen = [(place, which) for place in joints for which in known_coordinates(kinds[place])]
    for (place, which), found in zip(chosen, each_coordinate(result, chosen), strict=True):
        name = f"{result.joint_names[place]}.{which}"
        yield Column(name, COORDINATES[which], found.value)
        yield Column(f"{name}_rate", f"{COORDINATES[which]}/s", found.rate)


def _forces(result: Result, quantity: str, forces: Mapping[str, ForceResult]) -> Iterator[Column]:
    it = FORCES[quantity]
    parts = [f".{component}" for component in it.components] or [""]
    for name, found in forces.items():
        values = _of_force(result, name, found, quantity)
        if values is not None:
            for k, part in enumerate(parts):
                yield Column(
                    f"{name}.{quantity}{part}", it.unit, values.reshape(len(result), len(parts))[:, k]
                )


def _of_force(result: Result, name: str, found: ForceResult, quantity: str) -> Floats | None:
    """None: it has none."""
    if not quantity.startswith("deflection"):
        values: Floats = getattr(found, quantity)
        return values
    kind = result.header.force_kinds[list(result.header.force_names).index(name)]
    about_an_axis = "free_angle" in KINDS["force"][kind].parameters
    return found.deflection if about_an_axis == (quantity == "deflection_angle") else None


def to_frame(result: Result, choice: Choice) -> pandas.DataFrame:
    """See Result.to_frame."""
    package = optional_package("pandas", "pandas", "to_frame", instead="to_csv needs nothing")
    found = list(columns(result, choice))
    frame: pandas.DataFrame = package.DataFrame(
        {it.label: it.values for it in found}, index=package.Index(result.t, name="t [s]")
    )
    frame.attrs.update(model=str(result.manifest.get("model", "")), units={it.label: it.unit for it in found})
    return frame


def to_csv(
    result: Result, path: str | os.PathLike[str] | None, choice: Choice, overwrite: bool
) -> str | None:
    """See Result.to_csv."""
    target = None if path is None else check_new(path, "table", overwrite)
    found = list(columns(result, choice))
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["t [s]", *(it.label for it in found)])
    table = np.column_stack([result.t, *(it.values for it in found)])
    writer.writerows([repr(number) for number in row] for row in table.tolist())
    if target is None:
        return out.getvalue()
    with replacing(target, "table") as beside:
        beside.write_text(out.getvalue(), encoding="utf-8")
    return None


def to_xarray(result: Result, choice: Choice) -> xarray.Dataset:
    """See Result.to_xarray."""
    package = optional_package("xarray", "xarray", "to_xarray")
    places: dict[str, list[int]] = {
        "body": choice.places(result, "body"), "joint": choice.places(result, "joint"),
    }  # fmt: skip
    variables = {}
    names = choice.names(result)
    forces = choice.of_forces(result) if FORCES.keys() & names else {}
    for name in names:
        if name == "coordinate":
            variables.update(_coordinate_variables(result, choice))
            continue
        if name in FORCES:
            variables.update(_force_variables(result, name, forces))
            continue
        it = QUANTITIES[name]
        values = it.values(result) if it.of == "run" else it.values(result)[:, places[it.of]]
        axes = {XYZ: ("xyz",), EULER: ("euler",), (): ()}.get(it.components, ("level",))
        dims = ("time", *(() if it.of == "run" else (it.of,)), *axes)
        variables[name] = (dims, values, {"units": it.unit, "long_name": it.long_name})
    coordinates: dict[str, Any] = {
        "time": ("time", result.t, {"units": "s"}), "xyz": list(XYZ), "euler": list(EULER),
        "level": ["position", "velocity", "acceleration"],
        "body": [result.body_names[k] for k in places["body"]],
        "joint": [result.joint_names[k] for k in places["joint"]],
    }  # fmt: skip
    coordinates |= {
        dims[1]: about.pop("owners") for dims, _, about in variables.values() if "owners" in about
    }
    used = {dim for dims, *_ in variables.values() for dim in dims}
    attributes = {
        "model": str(result.manifest.get("model", "")), "manifest": json.dumps(result.manifest, default=str),
    }  # fmt: skip
    kept = {name: it for name, it in coordinates.items() if name in used | {"time"}}
    found: xarray.Dataset = package.Dataset(variables, kept, attributes)
    return found.copy(deep=True)  # to write in, other than what the result gives out


def _coordinate_variables(result: Result, choice: Choice) -> dict[str, Any]:
    """`angle`, `angle_rate`, ... over the joints that have it, which the attribute `owners` names."""
    found: dict[str, Any] = {}
    for which, unit in COORDINATES.items():
        kinds = result.header.joint_kinds
        of = [k for k in choice.places(result, "joint") if which in known_coordinates(kinds[k])]
        if not of:
            continue
        motions = list(each_coordinate(result, [(k, which) for k in of]))
        names, dims = [result.joint_names[k] for k in of], ("time", f"joint_with_{which}")
        for suffix, values, units in (
            ("", [it.value for it in motions], unit), ("_rate", [it.rate for it in motions], f"{unit}/s"),
        ):  # fmt: skip
            about = {"units": units, "long_name": f"{which} of joints", "owners": names}
            found[which + suffix] = (dims, np.stack(values, axis=1), about)
    return found


def _force_variables(result: Result, quantity: str, forces: Mapping[str, ForceResult]) -> dict[str, Any]:
    """Over the force elements, or those that have it."""
    it = FORCES[quantity]
    found = {name: _of_force(result, name, force, quantity) for name, force in forces.items()}
    known = {name: values for name, values in found.items() if values is not None}
    if not known:
        return {}
    over = f"force_with_{quantity}" if quantity.startswith("deflection") else "force_element"
    dims = ("time", over, *(("xyz",) if it.components else ()))
    about = {"units": it.unit, "long_name": it.long_name, "owners": list(known)}
    return {quantity: (dims, np.stack(list(known.values()), axis=1), about)}
