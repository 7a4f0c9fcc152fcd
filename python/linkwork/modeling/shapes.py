"""What bodies look like: boxes, cylinders, spheres, rods, meshes. Shapes have no influence on the motion.

    model.body("crank", mass=1.0, inertia=(0.01, 0.02, 0.02), shape=lw.Box((1.0, 0.1, 0.1), color="#c44"))
    model.find("rod").shape(lw.Rod((-0.5, 0, 0), (0.5, 0, 0)), lw.Sphere(0.1, position=(0.5, 0, 0)))

Lengths in m, in body coordinates: axes of the body, from its center of mass. A body without a shape is drawn
from where its joints sit and from its inertia, see linkwork.view.appearance.
"""

from __future__ import annotations

import copy
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, Self

import numpy as np

from linkwork import rotation
from linkwork.arguments import array, is_iterable, is_number, optional_package
from linkwork.arrays import Floats, Indices, Number, VectorLike, read_only
from linkwork.errors import FileError, ModelError

__all__ = ["Box", "Cylinder", "Mesh", "Rod", "Shape", "Shapes", "ShapesLike", "Sphere"]

#: Euler parameters whose norm differs from 1 by no more are unit already: they stay as they are, to the last
#: bit, so that those of any shape are the same once written to a file and read.
ROUNDED = 8 * float(np.finfo(float).eps)


@dataclass(frozen=True, init=False, eq=False)
class Shape:
    """One solid, fixed in its body."""

    kind: ClassVar[str]

    position: Floats  #: of its center (3,), body coordinates [m]
    orientation: Floats  #: Euler parameters (4,), axes of the shape to axes of the body
    color: str | None  #: "#rrggbb"; None: that of the body

    def _place(self, position: VectorLike, orientation: VectorLike, color: str | None) -> None:
        p = _vector(self.kind, "orientation", orientation, 4)
        length = float(np.linalg.norm(p))
        if abs(length - 1) > 1e-6:
            raise ModelError(f"{self.kind}: orientation has norm {length:.6g}, not 1", code="shape")
        unit = p if abs(length - 1) <= ROUNDED else p / length
        self._set(position=_vector(self.kind, "position", position, 3), orientation=unit, color=_color(color))

    def _set(self, **values: Any) -> None:
        for name, value in values.items():
            object.__setattr__(self, name, read_only(value))

    def dimensions(self) -> dict[str, Any]:
        """
        The arguments that only this kind has; plain numbers and lists, or the arrays of a mesh.

            assert lw.Box((1, 2, 3)).dimensions() == {"size": [1.0, 2.0, 3.0]}
        """
        raise NotImplementedError

    def moved(self, origin: Floats, axes: Floats) -> Self:
        """The same shape, outside of a frame with that origin (3,) and axes (3, 3), in columns, which it is
        in.

            ball = lw.Sphere(0.1).moved(np.array([0, 0, 1.0]), np.eye(3))
        """
        out = copy.copy(self)  # a mesh shares its arrays
        p = rotation.from_matrix(axes @ rotation.matrix(self.orientation))
        out._set(position=origin + axes @ self.position, orientation=p)
        return out

    def description(self) -> dict[str, Any]:
        """
        All of it as `Shape.of` takes it; JSON but for the arrays of a mesh.

            assert lw.Sphere(0.1, color="red").description()["color"] == "#ff0000"
        """
        found: dict[str, Any] = {"kind": self.kind, **self.dimensions()}
        if self.kind != "rod":
            found |= {"position": self.position.tolist(), "orientation": self.orientation.tolist()}
        return found | ({"color": self.color} if self.color else {})

    @staticmethod
    def of(description: Mapping[str, Any]) -> Shape:
        """The shape that was described.

            box = lw.Shape.of({"kind": "box", "size": [1, 2, 3]})

        ModelError: no such kind, or what that kind cannot be.
        """
        arguments = dict(description)
        kind = arguments.pop("kind", None)
        if kind not in KINDS:
            raise ModelError(f"shape: kind {kind!r} is not one of {', '.join(KINDS)}", code="shape")
        try:
            shape: Shape = KINDS[kind](**arguments)
        except TypeError as error:
            raise ModelError(f"{kind}: {error}".replace("__init__() ", ""), code="shape") from error
        return shape


class Box(Shape):
    """A box with edges (x, y, z) [m]."""

    kind = "box"
    size: Floats

    def __init__(self, size: VectorLike, *, position: VectorLike = (0, 0, 0),
                 orientation: VectorLike = (1, 0, 0, 0), color: str | None = None) -> None:  # fmt: skip
        """ModelError: an edge that is not positive."""
        edges = _vector("box", "size", size, 3)
        for edge in edges:
            _positive("box", "size", edge)
        self._set(size=edges)
        self._place(position, orientation, color)

    def dimensions(self) -> dict[str, Any]:
        return {"size": self.size.tolist()}


class Sphere(Shape):
    """A sphere of a radius [m]."""

    kind = "sphere"
    radius: float

    def __init__(self, radius: Number, *, position: VectorLike = (0, 0, 0),
                 orientation: VectorLike = (1, 0, 0, 0), color: str | None = None) -> None:  # fmt: skip
        """ModelError: a radius that is not positive."""
        self._set(radius=_positive("sphere", "radius", radius))
        self._place(position, orientation, color)

    def dimensions(self) -> dict[str, Any]:
        return {"radius": self.radius}


class Cylinder(Shape):
    """A cylinder of a radius and a length [m] along `axis` (3,), or along z of its orientation."""

    kind = "cylinder"
    radius: float
    length: float

    def __init__(self, radius: Number, length: Number, *, axis: VectorLike | None = None,
                 position: VectorLike = (0, 0, 0), orientation: VectorLike = (1, 0, 0, 0),
                 color: str | None = None) -> None:  # fmt: skip
        """ModelError: a radius or length that is not positive, an axis without direction."""
        self._set(
            radius=_positive("cylinder", "radius", radius), length=_positive("cylinder", "length", length)
        )
        if axis is not None:
            orientation = _along(_vector("cylinder", "axis", axis, 3), "cylinder: axis")
        self._place(position, orientation, color)

    def dimensions(self) -> dict[str, Any]:
        return {"radius": self.radius, "length": self.length}


class Rod(Shape):
    """A round bar from `start` to `end` (3,) [m]; its radius is 1/25 of the length unless given."""

    kind = "rod"
    start: Floats
    end: Floats
    radius: float

    def __init__(
        self, start: VectorLike, end: VectorLike, radius: Number | None = None, *, color: str | None = None
    ) -> None:
        """ModelError: a rod without length, a radius that is not positive."""
        a, b = _vector("rod", "start", start, 3), _vector("rod", "end", end, 3)
        length = float(np.linalg.norm(b - a))
        self._set(start=a, end=b)
        self._place((a + b) / 2, _along(b - a, "rod: start and end coincide, so that its axis"), color)
        self._set(radius=_positive("rod", "radius", length / 25 if radius is None else radius))

    def moved(self, origin: Floats, axes: Floats) -> Rod:
        return Rod(origin + axes @ self.start, origin + axes @ self.end, self.radius, color=self.color)

    def dimensions(self) -> dict[str, Any]:
        return {"start": self.start.tolist(), "end": self.end.tolist(), "radius": self.radius}


class Mesh(Shape):
    """A surface of triangles, from arrays or from a file: `Mesh.load("link.stl")`."""

    kind = "mesh"
    vertices: Floats  #: (n, 3) [m]
    triangles: Indices  #: (m, 3) places in `vertices`, counterclockwise from outside

    def __init__(self, vertices: VectorLike, triangles: VectorLike, *, position: VectorLike = (0, 0, 0),
                 orientation: VectorLike = (1, 0, 0, 0), color: str | None = None) -> None:  # fmt: skip
        """ModelError: arrays of other shapes, or triangles of vertices that there are not."""
        points, corners = np.array(vertices, float), np.array(triangles, np.int32)
        if points.ndim != 2 or points.shape[1] != 3 or not np.isfinite(points).all():
            raise ModelError(f"mesh: vertices of shape {points.shape} are not finite (n, 3)", code="shape")
        if corners.ndim != 2 or corners.shape[1] != 3 or not len(corners):
            raise ModelError(f"mesh: triangles of shape {corners.shape} are not (m, 3)", code="shape")
        if corners.min() < 0 or corners.max() >= len(points):
            raise ModelError(
                f"mesh: a triangle names a vertex beyond the {len(points)} there are", code="shape"
            )
        self._set(vertices=points, triangles=corners)
        self._place(position, orientation, color)

    @classmethod
    def load(cls, path: str | os.PathLike[str], *, scale: Number = 1.0, position: VectorLike = (0, 0, 0),
             orientation: VectorLike = (1, 0, 0, 0), color: str | None = None) -> Mesh:  # fmt: skip
        """An STL or OBJ file; `scale` 1e-3 for one in mm.

            model.find("rod").shape(lw.Mesh.load("link.stl", scale=1e-3))

        FileError: missing, or not such a file.
        """
        if Path(path).suffix.lower() not in (".stl", ".obj"):
            raise FileError(
                f"mesh '{path}': is neither .stl nor .obj: convert it to one of them", code="format"
            )
        if not Path(path).is_file():
            raise FileError(f"mesh '{path}': no such file", code="not_found")
        trimesh = optional_package("trimesh", "mesh", f"mesh '{path}'", FileError)
        try:
            found: Any = trimesh.load(Path(path), force="mesh", process=True)
            vertices, faces = np.asarray(found.vertices, float), np.asarray(found.faces)
        except Exception as error:  # whatever a reader of damaged files may raise
            raise FileError(f"mesh '{path}': cannot be read: {error}", code="not_readable") from error
        if not len(faces):
            raise FileError(f"mesh '{path}': has no triangles: is it damaged?", code="not_readable")
        return cls(vertices * _positive("mesh", "scale", scale), faces, position=position,
                   orientation=orientation, color=color)  # fmt: skip

    def dimensions(self) -> dict[str, Any]:
        return {"vertices": self.vertices, "triangles": self.triangles}


KINDS: dict[str, type[Any]] = {kind.kind: kind for kind in (Box, Cylinder, Sphere, Rod, Mesh)}

#: One shape or several.
ShapesLike = Shape | Sequence[Shape]


class Shapes:
    """Which bodies have shapes of their own: ranges of body indices (-1: ground), a later one prevails."""

    def __init__(self, groups: Iterable[tuple[range, tuple[Shape, ...]]] = ()) -> None:
        self._groups = list(groups)

    @staticmethod
    def checked(shapes: ShapesLike) -> tuple[Shape, ...]:
        """One or several as a tuple. ModelError: what is no shape."""
        several = tuple(shapes) if is_iterable(shapes) else (shapes,)
        for shape in several:
            if not isinstance(shape, Shape):
                raise ModelError(f"shape {shape!r} is no Box, Cylinder, Sphere, Rod or Mesh", code="shape")
        return several

    def set(self, bodies: range | Indices, shapes: tuple[Shape, ...]) -> None:
        """Without shapes nothing changes."""
        runs = [bodies] if isinstance(bodies, range) else _runs(bodies)
        self._groups += [(run, shapes) for run in runs if len(run) and shapes]

    def copy(self) -> Shapes:
        return Shapes(self._groups)

    def by_body(self) -> dict[int, tuple[Shape, ...]]:
        """The shapes of each body that has some."""
        return {body: shapes for bodies, shapes in self for body in bodies}

    def __iter__(self) -> Iterator[tuple[range, tuple[Shape, ...]]]:
        return iter(self._groups)

    def __len__(self) -> int:
        return len(self._groups)


def _runs(bodies: Indices) -> list[range]:
    """Indices as runs of neighbors."""
    breaks = np.flatnonzero(np.diff(bodies) != 1) + 1
    return [range(int(part[0]), int(part[-1]) + 1) for part in np.split(bodies, breaks) if len(part)]


def _vector(kind: str, what: str, value: VectorLike, size: int) -> Floats:
    vector = array(value, f"{kind}: {what}", ModelError).copy()
    if vector.shape != (size,) or not np.isfinite(vector).all():
        raise ModelError(f"{kind}: {what} {value!r} is not {size} finite numbers", code="shape")
    return vector


def _positive(kind: str, what: str, value: Any) -> float:
    if not is_number(value) or not value > 0:
        shown = value.item() if isinstance(value, np.number) else value
        raise ModelError(f"{kind}: {what} {shown!r:.80} is not a positive number", code="shape")
    return float(value)


def _along(axis: Floats, what: str) -> Floats:
    """Euler parameters (4,) of axes with z along `axis`."""
    length = np.linalg.norm(axis)
    if not length:
        raise ModelError(f"{what} has no direction", code="shape")
    x = rotation.perpendicular(axis)
    return rotation.from_axes(x, np.cross(axis / length, x))


def _color(color: str | None) -> str | None:
    """ "#rrggbb" of that or of a name that matplotlib knows."""
    if color is None or (isinstance(color, str) and re.fullmatch(r"#[0-9a-f]{6}", color)):
        return color
    from matplotlib.colors import to_hex

    try:
        return to_hex(color)
    except (ValueError, TypeError) as error:
        raise ModelError(
            f"color {color!r} is neither '#rrggbb' nor a name such as 'red'", code="color"
        ) from error
