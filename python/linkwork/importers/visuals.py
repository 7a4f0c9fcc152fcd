"""The visual geometry of robot files as shapes of linkwork; what cannot be drawn is noted."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import numpy as np

from linkwork.arrays import Floats, Indices
from linkwork.errors import FileError, LinkworkError, ModelError
from linkwork.importers import mesh_files
from linkwork.importers.frames import Frame
from linkwork.importers.xml_text import finite
from linkwork.modeling.shapes import Cylinder, Mesh, Shape, Sphere

__all__ = ["GRAY", "Visuals", "capsule", "ellipsoid", "hex_of", "numbers"]

#: Of what has no color in the file.
GRAY = "#b9bec6"

#: Parts of a circle of latitude and of a meridian of an ellipsoid.
AROUND, ALONG = 24, 12

#: Reports a topic, a subject and a message.
Notes = Callable[[str, str, str], None]


class Visuals:
    """Shapes of the links of one file. `wanted`: False: nothing is drawn, which is noted once."""

    def __init__(self, path: str, search_path: Sequence[Path], note: Notes, wanted: bool) -> None:
        self._here = Path(path).resolve().parent
        self._search_path = search_path
        self._note, self.wanted = note, wanted
        self._left_out = 0
        self._failed: dict[str, list[str]] = {}  #: by the code of the error: its messages
        self._simplified: set[Path] = set()

    def add(self, shapes: list[Shape], who: str, make: Callable[[], Sequence[Shape]], frame: Frame) -> None:
        """What `make` makes, which is in a frame of the link, to its shapes; noted where that fails."""
        if not self.wanted:
            self._left_out += 1
            return
        try:
            shapes += [shape.moved(frame.r, frame.A) for shape in make()]
        except FileError as error:
            self._failed.setdefault(error.code, []).append(error.message)
        except LinkworkError as error:
            self._note("visual", who, f"a visual geometry is not drawn: {error.reason}")

    def mesh(self, uri: str, scale: Sequence[float], color: str | None = None, *,
             otherwise: str | None = None) -> list[Shape]:  # fmt: skip
        """A file by its URI, in one color; without, in its own, or `otherwise` where it has none.

        FileError: it cannot be drawn.
        """
        if not all(scale):
            raise ModelError(f"mesh '{uri}': scale {' '.join(map(str, scale))} is zero", code="shape")
        path = mesh_files.find(uri, self._here, self._search_path)
        x, y, z = map(float, scale)
        parts, count = mesh_files.read(path, (x, y, z))
        if count > mesh_files.MOST:
            self._simplified.add(path)
        return [Mesh(it.vertices, it.triangles, color=color or it.color or otherwise or GRAY) for it in parts]

    def finish(self) -> None:
        """Note what concerns many shapes."""
        if self._left_out:
            self._note(
                "visual", "model", f"{self._left_out} visual geometries are left out, as was asked for"
            )
        for code, messages in self._failed.items():
            different = list(dict.fromkeys(messages))
            more = f", and {len(different) - 1} other meshes" if len(different) > 1 else ""
            count = f" ({len(messages)} times)" if code == "missing_package" else ""
            self._note("visual", "model", f"is drawn without meshes: {different[0]}{more}{count}")
        if self._simplified:
            text = (
                f"{len(self._simplified)} meshes of more than {mesh_files.MOST} triangles are drawn by fewer"
            )
            self._note("visual", "model", text)


def numbers(text: str | None, count: int, what: str, default: Sequence[float] | None = None) -> list[float]:
    """`count` numbers of a shape. ModelError: there are others."""
    if (text is None or not text.strip()) and default is not None:
        return list(default)
    values = finite(text or "", count)
    if values is None:
        raise ModelError(f"{what} '{(text or '').strip()[:60]}' is not {count} finite numbers", code="shape")
    return values


def hex_of(rgba: Sequence[float] | Floats) -> str:
    """ "#rrggbb" of red, green, blue and what follows, from 0 to 1."""
    return "#" + "".join(f"{int(round(255 * min(max(float(part), 0.0), 1.0))):02x}" for part in rgba[:3])


def capsule(radius: float, length: float, color: str | None) -> list[Shape]:
    """A cylinder about z of that length with half a ball on each end."""
    balls: list[Shape] = [Sphere(radius, position=(0, 0, end * length / 2), color=color) for end in (-1, 1)]
    return [Cylinder(radius, length, color=color), *balls] if length > 0 else balls[:1]


def ellipsoid(radii: Sequence[float], color: str | None) -> list[Shape]:
    """With half axes (3,) along x, y and z."""
    if not min(radii) > 0:
        raise ModelError(
            f"ellipsoid: radii {' '.join(f'{r:g}' for r in radii)} are not positive", code="shape"
        )
    vertices, triangles = _ball()
    return [Mesh(vertices * np.asarray(radii, float), triangles, color=color)]


def _ball() -> tuple[Floats, Indices]:
    """Of radius one: rows of vertices from the south pole to the north pole."""
    latitude = np.linspace(-np.pi / 2, np.pi / 2, ALONG + 1)[1:-1, None]
    longitude = 2 * np.pi / AROUND * np.arange(AROUND)
    level, height = np.cos(latitude), np.sin(latitude) + 0 * longitude
    rows = np.stack([level * np.cos(longitude), level * np.sin(longitude), height], axis=-1)
    vertices = np.vstack([rows.reshape(-1, 3), [[0, 0, -1], [0, 0, 1]]])
    return vertices, np.array(list(_faces(len(vertices) - 2)), np.int32)


def _faces(south: int) -> Iterator[tuple[int, int, int]]:
    last = (ALONG - 2) * AROUND
    for k in range(AROUND):
        n = (k + 1) % AROUND
        yield south, n, k
        yield south + 1, last + k, last + n
        for row in range(0, last, AROUND):
            yield row + k, row + n, row + AROUND + n
            yield row + k, row + AROUND + n, row + AROUND + k
