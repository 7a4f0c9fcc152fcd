"""One run as the viewer takes it: what is drawn, the motion, and the quantities that can be plotted."""

from __future__ import annotations

import warnings
from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwork import rotation
from linkwork.arrays import Floats
from linkwork.errors import LinkworkWarning, OptionError
from linkwork.modeling.coordinates import known_coordinates
from linkwork.modeling.shapes import Box, Cylinder, Mesh, Rod, Shape, Sphere
from linkwork.motion.header import Header
from linkwork.motion.records import energy_error
from linkwork.motion.summary import method
from linkwork.motion.violations import told, violations
from linkwork.view.appearance import Scene, Solid, Span, scene
from linkwork.view.encoding import Pack
from linkwork.view.poses import (
    add_poses,
    continuous,
    frames_of_piece,
    frames_of_stream,
    from_origin,
    in_pieces,
    page_origin,
    pieces_of_stream,
    stream_precision,
)

if TYPE_CHECKING:
    from linkwork.results.result import Result

#: Of the frames before they are deflated [bytes].
LIMIT = 16e6

#: More frames than a screen can show apart are left out.
MOST_FRAMES = 2000

#: Events that are marked in the time line; of more the page says how many are not.
MOST_EVENTS = 200

#: Joints of which the coordinates can be plotted; where poses are in pieces, as each is read by itself.
COORDINATES, FEW_COORDINATES = 100, 20

#: Share of the limit that poses may take; the rest is for what can be plotted, of so many bodies at least.
POSES, FOLLOWED = 0.6, 6

#: Bytes of a frame: the pose of a body; what can be plotted of a body, rates (6 numbers of 4 bytes each) and
#: theirs; of a joint, force and torque, two violations (of 2 bytes), and two coordinates with their rates.
POSE_BYTES, BODY_BYTES, JOINT_BYTES = 7 * 2, 12 * 4, 6 * 4 + 2 * 2 + 4 * 4

#: Where a server gives the poses out: bodies and joints that can be plotted of a result that is larger than
#: that, which is not read as a whole [bytes].
FEW_FOLLOWED, WHOLE_READ = 100, 1e9


@dataclass(frozen=True)
class Choice:
    """What of a run goes into the page."""

    every: int  #: frames are every so manyth, and the last
    bodies: NDArray[np.intp]  #: of which velocities can be plotted, and positions where poses are in pieces
    joints: NDArray[np.intp]  #: of which reactions can be plotted and drawn
    coordinates: int  #: of the first so many of them also coordinates
    travel: Floats | None = None  #: of all bodies (n,) [m]; only where a server gives the poses out

    @classmethod
    def streamed(cls, result: Result, limit: float) -> Choice:
        """All frames, whose poses a server gives out; within `limit` [bytes] what can be plotted."""
        count, n, joints = len(result), result.header.body_count, result.header.joint_count
        share = min(1.0, limit / max(1, count * ((BODY_BYTES + POSE_BYTES) * n + JOINT_BYTES * joints)))
        bodies, loaded = max(int(share * n), min(FOLLOWED, n)), int(share * joints)
        if 8.0 * count * (19 * n + 6 * joints) > WHOLE_READ:
            bodies, loaded = min(bodies, FEW_FOLLOWED), min(loaded, FEW_FOLLOWED)
        travel = _travel(result)
        return cls(1, _most(travel, bodies), _most(_load(result), loaded), FEW_COORDINATES, travel)

    @classmethod
    def of(cls, result: Result, limit: float) -> Choice:
        """Within `limit` [bytes]. OptionError: not even two frames fit."""
        count, n, joints = len(result), result.header.body_count, result.header.joint_count
        if 2 * POSE_BYTES * n > limit:
            raise OptionError(
                f"limit {limit:.3g} bytes is too small for two frames of {n} bodies: give {56 * n} or more",
                code="limit",
            )
        every = every_frame(result, limit)
        frames = -(-count // every) + 1
        left = limit - POSE_BYTES * n * frames
        pieces = in_pieces(frames, n)
        tracks, least = (POSE_BYTES, min(FOLLOWED, n)) if pieces else (0, 0)
        share = min(1.0, left / max(1, frames * ((BODY_BYTES + tracks) * n + JOINT_BYTES * joints)))
        bodies = max(int(share * n), least)
        loaded = _most(_load(result), int(share * joints))
        return cls(every, _most(_travel(result), bodies), loaded, FEW_COORDINATES if pieces else COORDINATES)


def every_frame(result: Result, limit: float) -> int:
    """A page of `limit` [bytes] has every so manyth frame."""
    poses = POSES * limit / max(POSE_BYTES * result.header.body_count, 1)
    most = min(MOST_FRAMES, max(2, int(poses)))
    return max(1, -(-(len(result) - 1) // (most - 1)))


class Document(NamedTuple):
    """A run in a page."""

    facts: dict[str, Any]  #: what the viewer reads as JSON
    block: str  #: of arrays
    pieces: list[str]  #: blocks of poses; none where they are among the arrays


def document(
    result: Result,
    label: str,
    limit: float = LIMIT,
    *,
    streamed: bool = False,
    origin: Floats | None = None,
) -> Document:  # Long: 35 lines are the facts.
    """What goes into a page of a result; `streamed`: a server gives the poses of all frames out; `origin` of
    the page (3,) [m], or its own.

    OptionError: a result without frames, a limit that is too small.
    """
    if not len(result):
        raise OptionError("the result has no frames: there is nothing to view", code="empty")
    header = result.header
    choice, pack = (Choice.streamed if streamed else Choice.of)(result, limit), Pack()
    drawn = scene(result)
    origin = page_origin(result) if origin is None else origin
    low, high = (end - origin for end in _extent(result, drawn))
    pieces, precision = _add_frames(pack, result, choice, origin)
    coordinates = _add_coordinates(pack, result, choice)
    pack.add("joints.bodies", header.joint_bodies, "i4")
    on_ground = (header.joint_bodies < 0)[..., None]
    pack.add("joints.origin", header.joint_origin - np.where(on_ground, origin, 0.0), "f4")
    manifest = result.manifest
    facts = {
        "label": label,
        "model": manifest.get("model") or "model",
        "method": _method(result),
        "finished": result.finished,
        "still": bool(manifest.get("still")),
        "loose": [[int(joint), text] for joint, text in manifest.get("loose", {}).items()],
        "frames": {"recorded": len(result), "shown": pack.directory["t"]["shape"][0], "every": choice.every},
        "precision": stream_precision(low, high) if streamed else precision,
        "gravity": np.asarray(header.gravity, float).tolist(),
        "origin": origin.tolist(),
        "extent": [low.tolist(), high.tolist()],
        "bodies": {"names": list(header.body_names), "plotted": choice.bodies.tolist()},
        "joints": _joint_facts(header, choice),
        "coordinates": coordinates,
        "masses": np.asarray(header.mass, float).tolist(),
        "lever": lever(header),
        "forces": {"names": list(header.force_names), "kinds": list(header.force_kinds)},
        "solids": _add_solids(pack, drawn.solids, origin),
        "spans": _add_spans(pack, drawn.spans, origin),
        "events": [{"t": it.t, "name": it.name} for it in result.events[:MOST_EVENTS]]
        + [{"t": it.t, "name": "singular pose"} for it in result.singular_poses],
        "unmarked": max(0, len(result.events) - MOST_EVENTS),
        "arrays": pack.directory,
        "pieces": _piece_facts(result, len(pieces), streamed),
    }
    return Document(facts, pack.text(), pieces)


def _piece_facts(result: Result, count: int, streamed: bool) -> dict[str, Any] | None:
    """How the poses are divided; None: they are one array."""
    bodies = result.header.body_count
    if streamed:
        return {"count": pieces_of_stream(result), "frames": frames_of_stream(bodies), "streamed": True}
    return {"count": count, "frames": frames_of_piece(bodies), "streamed": False} if count else None


def _joint_facts(header: Header, choice: Choice) -> dict[str, Any]:
    return {
        "names": list(header.joint_names),
        "kinds": list(header.joint_kinds),
        "unique": np.asarray(header.reaction_unique, int).tolist(),
        "plotted": choice.joints.tolist(),
        "held": list(map(int, told(header))),
    }


def _method(result: Result) -> str:
    """The choices of the run, and how accurate it is."""
    words = ", ".join(method(result.manifest.get("options", {}), short=True)).replace("_", " ")
    return f"{words}; {result.verdict.sentence}" if result.verdict else words


# --- frames ------------------------------------------------------------------------------------------------


def _thinned(result: Result, name: str, every: int) -> Floats:
    """Every so manyth frame of a field, and the last."""
    values = result.recorded(name, np.s_[::every])
    if (len(result) - 1) % every == 0:
        return values
    return np.concatenate([values, result.recorded(name, np.s_[-1:])])


def _thinned_of(result: Result, name: str, places: NDArray[np.intp], every: int) -> Floats:
    """The same of some bodies or joints."""
    values = result.recorded_of(name, places, every)
    if (len(result) - 1) % every == 0:
        return values
    return np.concatenate([values, result.recorded(name, np.s_[-1:])[:, places]])


def _add_frames(pack: Pack, result: Result, choice: Choice, origin: Floats) -> tuple[list[str], float]:
    """Times, poses, and the series that can be plotted. See `add_poses`."""
    every = choice.every
    pack.add("t", _thinned(result, "t", every), "f8")
    poses = _add_poses(pack, result, choice, origin)
    for name in ("v", "vdot"):
        pack.add_singles(name, _thinned_of(result, name, choice.bodies, every))
    for part in ("force", "torque"):
        pack.add_singles(part, _thinned_of(result, f"reaction_{part}", choice.joints, every))
    kinetic, potential, work = (_thinned(result, name, every) for name in ("kinetic", "potential", "work"))
    scalars = (kinetic, potential, kinetic + potential, work, energy_error(kinetic + potential, work))
    pack.add("energy", np.stack(scalars), "f4")
    pack.add("violation", _thinned(result, "violation", every).T, "f4")
    for name, values in zip(("gap", "askew"), joint_violations(result, choice), strict=True):
        pack.add_quantized(name, np.log10(np.maximum(values, 1e-17)))
    return poses


def _add_poses(pack: Pack, result: Result, choice: Choice, origin: Floats) -> tuple[list[str], float]:
    """As `add_poses`; where a server gives them out the tracks of some bodies, and how far all of them go."""
    if choice.travel is not None:
        pack.add("travel", choice.travel, "f4")
        track = from_origin(_thinned_of(result, "q", choice.bodies, 1), origin)
        pack.add_quantized("track", continuous(track))
        return [], 0.0
    shown = [*range(0, len(result), choice.every)]
    last = [len(result) - 1] * (shown[-1] != len(result) - 1)
    return add_poses(pack, result, shown + last, choice.bodies, origin)


def _add_coordinates(pack: Pack, result: Result, choice: Choice) -> list[str]:
    """Free coordinates of joints and their rates over full turns, from all frames; their names."""
    header, names, columns = result.header, [], []
    for joint in choice.joints[: choice.coordinates].tolist() if len(result) > 1 else []:
        known = known_coordinates(header.joint_kinds[joint])
        for which in known:
            with warnings.catch_warnings():  # frames too far apart: a plot of them is as doubtful as they are
                warnings.simplefilter("ignore", LinkworkWarning)
                found = result.coordinate(joint, which)
            name = header.joint_names[joint]
            names.append(name if len(known) == 1 else f"{name}: {which.replace('_', ' ')}")
            columns.append(np.stack([found.value, found.rate], axis=-1))
    series = np.stack(columns, axis=1) if columns else np.zeros((len(result), 0, 2))
    every = choice.every
    thinned = (
        series[::every] if (len(result) - 1) % every == 0 else np.concatenate([series[::every], series[-1:]])
    )
    for place, what in enumerate(("coordinate", "rate")):
        pack.add_singles(what, thinned[..., place])
    return names


def joint_violations(result: Result, choice: Choice) -> tuple[Floats, Floats]:
    """Of the chosen joints in the chosen frames: points apart (k, j) [m], axes askew (k, j) [rad]."""
    apart, askew = violations(result, choice.joints, choice.every)
    if (len(result) - 1) % choice.every:
        last = violations(result, choice.joints, len(result) - 1)
        apart, askew = (
            np.concatenate([one, end[-1:]]) for one, end in zip((apart, askew), last, strict=True)
        )
    return apart, askew


def lever(header: Header) -> float:
    """By which an angle at a joint becomes a length: the longest from a center of mass to a joint [m]."""
    arms = np.linalg.norm(header.joint_origin, axis=-1)[header.joint_bodies >= 0]
    return float(arms.max(initial=0.0)) or 1.0


def _travel(result: Result) -> Floats:
    """Longest side of the box that each center of mass moves in (n,) [m], from a sample of frames."""
    travel: Floats = np.ptp(result.sampled_positions(max(1, len(result) // 50)), axis=0)
    return np.asarray(travel.max(axis=-1, initial=0.0))


def _load(result: Result) -> Floats:
    """The largest force of each joint (J,) [N], from a sample of frames."""
    force = result.sampled_reactions(max(1, len(result) // 50)).force
    return np.asarray(np.linalg.norm(force, axis=-1).max(axis=0, initial=0.0))


def _most(values: Floats, count: int) -> NDArray[np.intp]:
    """Places of the `count` largest, in order."""
    return np.sort(np.argsort(-values, kind="stable")[:count])


def _extent(result: Result, drawn: Scene) -> tuple[Floats, Floats]:
    """A box (low, high) around all that is seen, from a sample of frames [m]."""
    n = result.header.body_count
    low, high = np.full((n + 1, 3), np.inf), np.full((n + 1, 3), -np.inf)  # by body, the ground last
    around = _of_each(_corners)
    corners = [(it.body, corner) for it in drawn.solids for corner in around(it.shape)]
    corners += [pair for it in drawn.spans for pair in zip(it.bodies, it.ends, strict=True)]
    if corners:
        bodies, points = np.array([body for body, _ in corners]), np.array([corner for _, corner in corners])
        np.minimum.at(low, bodies, points)
        np.maximum.at(high, bodies, points)
    missing = ~np.isfinite(low)
    low, high = np.where(missing, 0.0, low), np.where(missing, 0.0, high)
    ends = [low[-1], high[-1]] if any(body < 0 for body, _ in corners) else []
    middle, half = (low[:n] + high[:n]) / 2, (high[:n] - low[:n]) / 2
    for frame in range(0, len(result) if n else 0, max(1, len(result) // 40)):
        q = result.recorded("q", frame)  # one at a time: those of many bodies would take a GB
        A = rotation.matrix(q[:, 3:])
        center = q[:, :3] + np.einsum("iab,ib->ia", A, middle)
        reach = np.einsum("iab,ib->ia", np.abs(A), half)
        ends += [(center - reach).min(axis=0), (center + reach).max(axis=0)]
    if not ends:
        return -np.ones(3), np.ones(3)
    return np.min(ends, axis=0), np.max(ends, axis=0)


def _of_each(function: Callable[[Shape], Any]) -> Callable[[Shape], Any]:
    """Called once for a shape that many bodies share."""
    found: dict[int, tuple[Shape, Any]] = {}  # with the shape, or another could get its identity

    def once(shape: Shape) -> Any:
        if id(shape) not in found:
            found[id(shape)] = shape, function(shape)
        return found[id(shape)][1]

    return once


def _corners(shape: Shape) -> Floats:
    """Two corners of a box around a shape, in body axes (2, 3)."""
    if isinstance(shape, Rod):
        return np.stack([shape.start, shape.end])
    axes = rotation.matrix(shape.orientation)
    if isinstance(shape, Mesh):
        points = shape.position + shape.vertices @ axes.T
        return np.stack([points.min(axis=0), points.max(axis=0)])
    half = np.abs(axes) @ (np.array(_place(shape)[7:]) / 2)
    return np.stack([shape.position - half, shape.position + half])


# --- what is drawn -----------------------------------------------------------------------------------------


def _add_solids(pack: Pack, drawn: list[Solid], origin: Floats) -> list[dict[str, Any]]:
    """Groups of one geometry and layer; each instance is a body, an index, a color, a place and a size."""
    groups: dict[tuple[str, str, int, bool], list[Solid]] = defaultdict(list)
    for solid in drawn:
        mesh = id(solid.shape.vertices) if isinstance(solid.shape, Mesh) else 0
        groups[solid.layer, _geometry(solid.shape), mesh, solid.clear].append(solid)
    found = []
    place = _of_each(_place)
    for number, ((layer, geometry, _, clear), several) in enumerate(groups.items()):
        key = f"solids{number}"
        bodies, places = np.array([it.body for it in several]), np.array([place(it.shape) for it in several])
        places[:, :3] -= np.where(bodies[:, None] < 0, origin, 0.0)
        pack.add(f"{key}.body", bodies, "i4")
        pack.add(f"{key}.index", np.array([it.index for it in several]), "i4")
        pack.add(f"{key}.place", places, "f4")
        pack.add(f"{key}.color", _colors(several), "u1")
        if isinstance(mesh_shape := several[0].shape, Mesh):
            pack.add(f"{key}.vertices", mesh_shape.vertices, "f4")
            pack.add(f"{key}.triangles", mesh_shape.triangles, "i4")
        found.append({"key": key, "layer": layer, "geometry": geometry, "clear": clear})
    return found


def _geometry(shape: Shape) -> str:
    return "cylinder" if isinstance(shape, Rod) else shape.kind


def _place(shape: Shape) -> list[float]:
    """Position, Euler parameters, and the size of what has edges or diameters of one (10,)."""
    match shape:
        case Box():
            size = shape.size.tolist()
        case Sphere():
            size = [2 * shape.radius] * 3
        case Cylinder():
            size = [2 * shape.radius, 2 * shape.radius, shape.length]
        case Rod():
            size = [2 * shape.radius, 2 * shape.radius, float(np.linalg.norm(shape.end - shape.start))]
        case _:
            size = [1.0, 1.0, 1.0]
    return [*shape.position, *shape.orientation, *size]


def _add_spans(pack: Pack, drawn: list[Span], origin: Floats) -> list[dict[str, Any]]:
    """Groups of one form and layer; each instance is an index, two bodies with a point, a radius, a color."""
    groups: dict[tuple[str, str], list[Span]] = defaultdict(list)
    for span in drawn:
        groups[span.layer, span.form].append(span)
    found = []
    for number, ((layer, form), several) in enumerate(groups.items()):
        key = f"spans{number}"
        pack.add(f"{key}.index", np.array([it.index for it in several]), "i4")
        bodies, ends = np.array([it.bodies for it in several]), np.array([it.ends for it in several])
        pack.add(f"{key}.bodies", bodies, "i4")
        pack.add(f"{key}.ends", ends - np.where(bodies[..., None] < 0, origin, 0.0), "f4")
        pack.add(f"{key}.radius", np.array([it.radius for it in several]), "f4")
        pack.add(f"{key}.color", _colors(several), "u1")
        found.append({"key": key, "layer": layer, "form": form})
    return found


def _colors(drawn: Sequence[Solid | Span]) -> NDArray[np.uint8]:
    return np.array([list(bytes.fromhex(it.color[1:])) for it in drawn], np.uint8)
