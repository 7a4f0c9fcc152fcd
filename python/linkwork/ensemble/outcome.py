"""What an ensemble found: the motions of all members as arrays, or outputs of each."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from linkwork.arguments import optional_package
from linkwork.arrays import Floats, ReadOnly, by_value
from linkwork.errors import OptionError, counted
from linkwork.results.result import Result
from linkwork.studies.datasets import dimensions, without_groups
from linkwork.studies.followed import summary
from linkwork.studies.told import lines

if TYPE_CHECKING:
    import xarray

__all__ = ["EnsembleResult"]

#: Reasons that a summary lists.
LISTED = 3

#: Arrays over time that are kept: their dimensions after lane and time, and unit. A variable with the name of
#: a dimension of its own would be a coordinate to xarray, and no mean over members would have it.
TRAJECTORIES = {
    "q": (("body", "q_component"), "m, 1"), "v": (("body", "v_component"), "m/s, rad/s"),
    "vdot": (("body", "v_component"), "m/s2, rad/s2"), "lambda": (("row",), "N, N m"), "energy": ((), "J"),
}  # fmt: skip

#: Of q and v, and so of their rates, in a data set.
COMPONENTS = {
    "q_component": ("x", "y", "z", "e0", "e1", "e2", "e3"),
    "v_component": ("x", "y", "z", "omega_x", "omega_y", "omega_z"),
}

#: Coordinates that a data set has of every ensemble, and dimensions that it has of motions.
OWN = ("member", "status", "accuracy", "unstable", "alone", "error", "remarks", "time")
DIMENSIONS = ("body", "row", *COMPONENTS)


@by_value
@dataclass(frozen=True, repr=False)
class EnsembleResult(ReadOnly):
    """n members, of which k frames or the outputs that were asked for are kept.

    parameters    by name: values (n, ...)
    status        (n,) "finished" or "failed", of an ensemble that was interrupted "skipped", too
    errors        by member: type, code, message of what failed, and `reached`, the simulated time [s]
    alone         by member: why it was simulated by itself and not in a lane
    remarks       by member: warnings, and what its summary says of what is kept
    accuracy      (n,) estimated relative errors, those of their verdicts; NaN in members that failed
    unstable      (n,) by how much errors of steps grow where motion is unstable or chaotic, 1 where that is
                  not much more than in regular motion; NaN in members of which it is not known, as their
                  errors were not followed (`follow_errors`), or not to the end, see Verdict.growth
    t             (k,) times of the frames [s] of the member that has most; empty where outputs were asked for
    trajectories  without outputs "q" (n, k, bodies, 7), "v" and "vdot" (n, k, bodies, 6), "lambda"
                  (n, k, rows), "energy" (n, k) [J]: NaN in members that failed, and after the end of one that
                  an event ended; empty where members have frames at times of their own, see `member`
    outputs       by label: (n, ...); NaN in members that failed
    units         of parameters and outputs that are known
    times         (j,) [s] of outputs that are arrays over time
    manifest      what was run; "lanes": how many members in lanes; "follow_errors": whether those of all were
                  followed
    notes         by output, without outputs of "lambda": what it is in all members but those whose remarks
                  say otherwise, such as a reaction that redundant equations leave open

    A member has the bits that `simulate(model, ..., deterministic=True)` gives, whatever runs beside it, and
    its verdict, but for how errors grow where they were not followed.
    """

    parameters: Mapping[str, NDArray[Any]]
    status: NDArray[np.str_]
    errors: Mapping[int, Mapping[str, Any]]
    alone: Mapping[int, str]
    remarks: Mapping[int, str]
    accuracy: Floats
    unstable: Floats
    t: Floats
    trajectories: Mapping[str, Floats]
    outputs: Mapping[str, Floats]
    units: Mapping[str, str]
    times: Floats | None
    manifest: Mapping[str, Any]
    notes: Mapping[str, str] = field(default_factory=dict)
    over_time: frozenset[str] = frozenset()  #: outputs that are arrays over `times`
    results: Mapping[int, Result] = field(default_factory=dict, compare=False)  #: of members, without outputs

    def __len__(self) -> int:
        return len(self.status)

    def __repr__(self) -> str:
        counts = Counter(self.status.tolist())
        parts = [f"{counts[name]} {name}" for name in ("finished", "failed", "skipped") if counts[name]]
        parts.append(f"{self.manifest['lanes']} in lanes")
        why = Counter(text.split(" (at t = ")[0] for text in self.alone.values()).most_common(LISTED)
        alone = [f"  {count} by itself: {text}" for text, count in why]
        told = [*lines(self.errors, self.remarks, self.notes, counted(len(self), "member"))]
        every = bool(self.manifest["follow_errors"])
        if others := summary(self.unstable, self.status, "members", every=every):
            told.append(f"  {others}")
        return "\n".join([f"<EnsembleResult: {len(self)} members: {', '.join(parts)}>", *alone, *told])

    @property
    def q(self) -> Floats:
        """Positions and Euler parameters (n, k, bodies, 7). OptionError: outputs were asked for instead."""
        return self._trajectory("q")

    @property
    def v(self) -> Floats:
        """Velocities and angular velocities, body-fixed (n, k, bodies, 6) [m/s, rad/s]."""
        return self._trajectory("v")

    def _trajectory(self, name: str) -> Floats:
        if self.results and name not in self.trajectories:
            raise OptionError(
                f"{name}: members have frames at times of their own, or other bodies: ask for member(k), or "
                "for outputs with times",
                code="times",
            )
        if not self.trajectories:
            raise OptionError(f"{name}: outputs were kept instead of motions", code="outputs")
        return self.trajectories[name]

    def member(self, number: int) -> Result:
        """The motion of one that finished.

            many.member(1).plot()

        OptionError: there is none, or outputs were kept instead.
        """
        k = whole_number(number, len(self))
        if k not in self.results:
            skipped = self.status[k] == "skipped"
            usual = "the ensemble was interrupted" if skipped else "outputs were kept instead of motions"
            why = self.errors.get(k, {}).get("message", usual)
            raise OptionError(f"member {number}: has no motion: {why}", code="member")
        return self.results[k]

    def to_xarray(self) -> xarray.Dataset:
        """A data set of xarray over "member" and "time": parameters, status and why as coordinates, motions
        or outputs as variables, units and notes ("comment") as attributes, the manifest as text. Names have
        "_" for "/", by which files would put them into groups; the attribute `name` has what it was.

            many.to_xarray().q.mean("member").sel(q_component="z")

        OptionError: xarray is not installed, or members have frames at times of their own.
        """
        package = optional_package("xarray", "xarray", "to_xarray", instead="the arrays need nothing")
        if self.results:
            self._trajectory("q")
        coordinates: dict[str, Any] = {"member": np.arange(len(self)), "status": ("member", self.status)}
        coordinates["accuracy"] = "member", self.accuracy
        coordinates["unstable"] = "member", self.unstable
        coordinates |= {name: ("member", np.array(texts, dtype=object)) for name, texts in self._texts()}
        for name, values in self.parameters.items():
            coordinates[name] = self._variable(name, values)
        times = self.t if self.trajectories else self.times
        if times is not None and len(times):
            coordinates["time"] = "time", times, {"units": "s"}
        variables = {name: self._variable(name, values) for name, values in self.outputs.items()}
        for name, values in self.trajectories.items():
            dims, unit = TRAJECTORIES[name]
            variables[name] = ("member", "time", *dims), values, {"units": unit, **self._comment(name)}
            coordinates |= {dim: list(COMPONENTS[dim]) for dim in dims if dim in COMPONENTS}
        attributes = {"manifest": json.dumps(self.manifest, default=str)}
        return without_groups(package.Dataset(variables, coordinates, attributes).copy(deep=True))

    def _variable(self, name: str, values: NDArray[Any]) -> tuple[Any, Any, dict[str, str]]:
        dims = dimensions(name, values.ndim - 1, {*self.parameters, *self.outputs})
        if name in self.over_time:
            dims[0] = "time"
        units = {"units": self.units[name]} if self.units.get(name) else {}
        return ("member", *dims), values, {**units, **self._comment(name)}

    def _texts(self) -> Iterator[tuple[str, list[str]]]:
        """Of each member why it ran alone, why it failed, and what is remarked."""
        n = range(len(self))
        yield "alone", [self.alone.get(k, "") for k in n]
        yield "error", [self.errors.get(k, {}).get("message", "") for k in n]
        yield "remarks", [self.remarks.get(k, "") for k in n]

    def _comment(self, name: str) -> dict[str, str]:
        return {"comment": self.notes[name]} if name in self.notes else {}


def whole_number(number: Any, count: int) -> int:
    """OptionError: there is no such member."""
    whole = isinstance(number, int | np.integer) and not isinstance(number, bool)
    if not whole or not -count <= number < count:
        raise OptionError(f"member {number!r:.40} is none of the {count} of this ensemble", code="member")
    return int(number) % count
