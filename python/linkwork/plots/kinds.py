"""Pictures of one aspect of a run: `result.plot("phase.png", "phase")`."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from linkwork.arrays import Floats
from linkwork.errors import ModelError, OptionError
from linkwork.modeling.coordinates import known_coordinates
from linkwork.plots import figures
from linkwork.plots.figures import BODIES, COLORS, JOINTS

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from linkwork.modeling.handles import Named
    from linkwork.results.result import Result

#: Unit of a coordinate, and of its rate.
UNITS = {"angle": ("rad", "rad/s"), "displacement": ("m", "m/s")}
UNITS |= {"angle_a": UNITS["angle"], "angle_b": UNITS["angle"]}


@dataclass(frozen=True)
class Chosen:
    """Bodies, joints and force elements by index; empty: those that tell the most."""

    bodies: Sequence[int]
    joints: Sequence[int]
    forces: Sequence[int] = ()


def plot(
    result: Result,
    path: str | os.PathLike[str] | None = None,
    kind: str = "overview",
    bodies: Sequence[Named] = (),
    joints: Sequence[Named] = (),
    forces: Sequence[str | int] = (),
) -> Figure:
    """One figure of a kind in KINDS.

    OptionError: no such kind, or it does not show what is chosen, or too much is. ModelError: no such body,
    joint or force element.
    """
    figures.check_picture(kind, path, KINDS)
    for what, names in (("bodies", bodies), ("joints", joints), ("forces", forces)):
        if not isinstance(names, Iterable) or isinstance(names, str):
            raise ModelError(f"{what} {names!r:.80} is no list of names, indices or handles", code="names")
    if not len(result):
        raise OptionError("the result has no frames: there is nothing to plot", code="empty")
    chosen = Chosen(
        [result.index("body", it) for it in bodies],
        [result.index("joint", it) for it in joints],
        [result.index("force", it) for it in forces],
    )
    _check_choice(kind, chosen)
    figure = KINDS[kind](result, chosen)
    figure.suptitle(figures.title_of(result), fontsize=11)
    return figures.written(figure, path)


def _check_choice(kind: str, chosen: Chosen) -> None:
    """OptionError: a picture of this kind does not show them, or not so many."""
    for what in ("bodies", "joints", "forces"):
        count = len(getattr(chosen, what))
        if count and what not in SHOWN[kind]:
            kinds = ", ".join(f"'{name}'" for name, shown in SHOWN.items() if what in shown)
            raise OptionError(f"plot '{kind}' shows no {what} by themselves: {kinds} do", code="choice")
        if count > figures.MOST:
            raise OptionError(
                f"plot '{kind}': {count} {what} are chosen, of which {figures.MOST} could be told apart in "
                "one picture: choose fewer, or draw several",
                code="choice",
            )
    if chosen.bodies and chosen.joints and kind in EITHER:
        raise OptionError(f"plot '{kind}' shows bodies or joints: choose one of them", code="choice")


def _energy(result: Result, chosen: Chosen) -> Figure:
    figure, (upper, lower) = _over_time(2)
    figures.plot_energies(upper, result)
    figures.plot_energy_error(lower, result)
    return figure


def _violation(result: Result, chosen: Chosen) -> Figure:
    figure, (ax,) = _over_time(1)
    figures.plot_violation(ax, result)
    return figure


def _positions(result: Result, chosen: Chosen) -> Figure:
    figure, (ax,) = _over_time(1)
    figures.plot_positions(ax, result, chosen.bodies)
    return figure


def _velocities(result: Result, chosen: Chosen) -> Figure:
    return _of_bodies(result, chosen, ("velocity", "m/s"), ("omega", "rad/s"))


def _accelerations(result: Result, chosen: Chosen) -> Figure:
    return _of_bodies(result, chosen, ("acceleration", "m/s2"), ("angular_acceleration", "rad/s2"))


def _of_bodies(result: Result, chosen: Chosen, *quantities: tuple[str, str]) -> Figure:
    """Color tells the body, line style the component; those that stay small are left out."""
    figure, axes = _over_time(len(quantities))
    bodies = chosen.bodies or figures.largest_places(figures.travel_of(result), BODIES)
    which = "" if chosen.bodies else figures.share(
        len(bodies), len(result.body_names), "bodies, those that move most"
    )  # fmt: skip
    for ax, (quantity, unit) in zip(axes, quantities, strict=True):
        rotates = quantity in ("omega", "angular_acceleration")
        figures.style(ax, f"{quantity.replace('_', ' ')}{', body axes' if rotates else ''} [{unit}]")
        values = {result.body_names[i]: getattr(result.body(i), quantity) for i in bodies}
        most = max((np.abs(value).max(initial=0.0) for value in values.values()), default=0.0)
        for color, (name, value) in zip(figures.colors(len(values)), values.items(), strict=True):
            for axis in figures.telling(np.abs(value).max(axis=0), 1e-3 * most, bool(chosen.bodies)):
                component, line = figures.COORDINATES[axis]
                label = figures.literal(f"{name}  {component}")
                ax.plot(result.t, value[:, axis], color=color, ls=line, label=label)
                error = partial(_body_error, result, name, quantity, axis)
                figures.plot_band(ax, result, value[:, axis], color, error)
        figures.legend(ax, which)
    return figure


def _body_error(result: Result, body: str, quantity: str, axis: int) -> Floats:
    found: Floats = getattr(result.error_of("body", body), quantity)[:, axis]
    return found


def _reactions(result: Result, chosen: Chosen) -> Figure:
    figure, (upper, lower) = _over_time(2)
    figures.plot_reactions(upper, result, "force", "N", chosen.joints)
    figures.plot_reactions(lower, result, "torque", "N m", chosen.joints)
    return figure


def _forces(result: Result, chosen: Chosen) -> Figure:
    """Magnitudes of what force elements do to their second bodies."""
    names = result.header.force_names
    found = {names[k]: result.force(k) for k in chosen.forces or range(len(names))}
    figure, axes = _over_time(2)
    for ax, (part, unit) in zip(axes, (("force", "N"), ("torque", "N m")), strict=True):
        figures.style(ax, f"{part} of elements [{unit}]")
        sizes = {name: np.linalg.norm(getattr(it, part), axis=-1) for name, it in found.items()}
        most = np.array([size.max(initial=0.0) for size in sizes.values()])
        places = figures.largest_places(most, len(most) if chosen.forces else JOINTS)
        shown = [list(sizes)[k] for k in places if chosen.forces or most[k] > 0.0]
        for color, name in zip(figures.colors(len(shown)), shown, strict=True):
            ax.plot(result.t, sizes[name], color=color, label=figures.literal(name))
        if not shown:
            figures.write_none(ax)
        which = f"force elements, those with the largest {part}"
        figures.legend(ax, "" if chosen.forces else figures.share(len(shown), len(sizes), which))
    return figure


def _coordinates(result: Result, chosen: Chosen) -> Figure:
    """Angles and displacements of joints; where there are none, or bodies were chosen, their positions."""
    motions = [] if chosen.bodies else _motions(result, chosen)
    shown = [which for which in UNITS if any(motion.which == which for motion in motions)]
    if not shown:
        figure, (ax,) = _over_time(1)
        figures.plot_positions(ax, result, chosen.bodies)
        return figure
    figure, axes = _over_time(len(shown))
    for ax, which in zip(axes, shown, strict=True):
        figures.style(ax, f"{which} [{UNITS[which][0]}]")
        for color, motion in _colored([it for it in motions if it.which == which]):
            ax.plot(result.t, motion.value, color=color, label=figures.literal(motion.name))
            figures.plot_band(ax, result, motion.value, color, partial(_coordinate_error, result, motion))
        figures.legend(ax, _share(result, motions, chosen))
    return figure


def _colored(motions: Sequence[_Motion]) -> Iterator[tuple[str, _Motion]]:
    return zip(figures.colors(len(motions)), motions, strict=True)


def _coordinate_error(result: Result, motion: _Motion) -> Floats:
    found: Floats = result.error_of("coordinate", motion.name, motion.which).value
    return found


def _phase(result: Result, chosen: Chosen) -> Figure:
    """Rates over coordinates, of joints or, where they have none, of the bodies that move most."""
    motions = [] if chosen.bodies else _motions(result, chosen)
    if not motions:
        return _phase_of_bodies(result, chosen)
    shown = [which for which in UNITS if any(motion.which == which for motion in motions)]
    figure = figures.new_figure(5.2 * len(shown), 4.8)
    for ax, which in zip(np.atleast_1d(figure.subplots(1, len(shown))), shown, strict=True):
        unit, rate_unit = UNITS[which]
        figures.style(ax, f"rate [{rate_unit}]")
        ax.set_xlabel(f"{which} [{unit}]")
        for color, motion in _colored([it for it in motions if it.which == which]):
            _orbit(ax, motion.value, motion.rate, color, motion.name)
        figures.legend(ax, _share(result, motions, chosen))
    return figure


def _phase_of_bodies(result: Result, chosen: Chosen) -> Figure:
    figure = figures.new_figure(12.0, 4.4)
    bodies = chosen.bodies or figures.largest_places(figures.travel_of(result), BODIES)
    for axis, ax in enumerate(figure.subplots(1, 3)):
        figures.style(ax, "velocity [m/s]")
        ax.set_xlabel(f"{'xyz'[axis]} [m]")
        for color, body in zip(figures.colors(len(bodies)), bodies, strict=True):
            motion = result.body(body)
            _orbit(ax, motion.position[:, axis], motion.velocity[:, axis], color, motion.name)
        figures.legend(ax)
    return figure


def _orbit(ax: Axes, value: Floats, rate: Floats, color: str, name: str) -> None:
    """A dot where it starts."""
    ax.plot(value, rate, color=color, lw=1.2, label=figures.literal(name))
    ax.plot(value[:1], rate[:1], color=color, marker="o", ms=4, ls="")
    ax.margins(0.04)


def _step(result: Result, chosen: Chosen) -> Figure:
    """Sizes of steps where every step was recorded, the time between frames otherwise."""
    figure, (ax,) = _over_time(1)
    every_step = int(result.statistics.get("steps", -1)) == len(result) - 1
    figures.style(ax, "step [s]" if every_step else "time between frames [s]")
    ax.step(result.t[1:], np.diff(result.t), where="pre", color=COLORS[0], lw=1.0)
    ax.set_yscale("log")
    if not every_step:
        ax.set_title("not every step was recorded: record_every=1 does so", fontsize=9, loc="left")
    return figure


KINDS: dict[str, Callable[[Result, Chosen], Figure]] = {
    "overview": lambda result, chosen: figures.plot(result, chosen.bodies, chosen.joints),
    "energy": _energy,
    "violation": _violation,
    "positions": _positions,
    "velocities": _velocities,
    "accelerations": _accelerations,
    "coordinates": _coordinates,
    "reactions": _reactions,
    "forces": _forces,
    "phase": _phase,
    "step": _step,
}

#: What of a choice each kind shows, and the kinds that show either bodies or joints.
SHOWN: dict[str, tuple[str, ...]] = {
    "overview": ("bodies", "joints"), "energy": (), "violation": (), "positions": ("bodies",),
    "velocities": ("bodies",), "accelerations": ("bodies",), "coordinates": ("bodies", "joints"),
    "reactions": ("joints",), "forces": ("forces",), "phase": ("bodies", "joints"), "step": (),
}  # fmt: skip
EITHER = ("coordinates", "phase")


@dataclass(frozen=True)
class _Motion:
    """A coordinate of a joint over time."""

    name: str
    which: str
    value: Floats
    rate: Floats


def _motions(result: Result, chosen: Chosen) -> list[_Motion]:
    """Of the joints chosen, or of the first that have coordinates."""
    kinds = result.header.joint_kinds
    free = [j for j, kind in enumerate(kinds) if known_coordinates(kind)]
    joints = chosen.joints or free[:JOINTS]
    if without := [j for j in chosen.joints if j not in free]:
        names = ", ".join(f"'{result.joint_names[j]}'" for j in without)
        raise OptionError(
            f"joint {names} turns about or slides along no single axis: choose another joint, or bodies",
            code="no_coordinate",
        )
    return [
        _Motion(result.joint_names[j], which, *result.coordinate(j, which))
        for j in joints
        for which in known_coordinates(kinds[j])
    ]


def _share(result: Result, motions: Sequence[_Motion], chosen: Chosen) -> str:
    free = sum(bool(known_coordinates(kind)) for kind in result.header.joint_kinds)
    shown = len({motion.name for motion in motions})
    return "" if chosen.joints else figures.share(shown, free, "joints with a coordinate, the first")


def _over_time(rows: int) -> tuple[Figure, Sequence[Axes]]:
    figure = figures.new_figure(8.0, 1.6 + 2.5 * rows)
    axes = np.atleast_1d(figure.subplots(rows, 1, sharex=True))
    axes[-1].set_xlabel("time [s]")
    return figure, list(axes)
