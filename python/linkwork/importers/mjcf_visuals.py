"""The geoms of a compiled MuJoCo model as shapes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork.errors import LinkworkError
from linkwork.importers.frames import from_quaternion
from linkwork.importers.mesh_files import MOST, simplified
from linkwork.importers.visuals import Notes, capsule, ellipsoid, hex_of
from linkwork.modeling.shapes import Box, Cylinder, Mesh, Shape, Sphere

if TYPE_CHECKING:
    import mujoco

__all__ = ["shapes_of"]

#: Geoms of this group on are hidden in MuJoCo's viewer: usually they are for collisions.
HIDDEN = 3

#: What MuJoCo gives a geom that says nothing.
UNSAID = (0.5, 0.5, 0.5, 1.0)

#: Thickness of a plane, in its size.
THIN = 1e-3


def shapes_of(model: mujoco.MjModel, note: Notes) -> dict[int, list[Shape]]:
    """The shapes of each body, by its index, in its frame; what is not drawn is noted."""
    geoms = _Geoms(model)
    found: dict[int, list[Shape]] = {}
    left_out: dict[str, int] = {}
    for k in range(model.ngeom):
        reason = geoms.hidden(k)
        try:
            shapes = [] if reason else geoms.shapes(k)
        except LinkworkError as error:
            note("visual", f"geom {k}", f"is not drawn: {error.reason}")
            continue
        if reason:
            left_out[reason] = left_out.get(reason, 0) + 1
        frame = from_quaternion(model.geom_pos[k], model.geom_quat[k])
        found.setdefault(int(model.geom_bodyid[k]), []).extend(
            shape.moved(frame.r, frame.A) for shape in shapes
        )
    for reason, count in left_out.items():
        note("visual", "model", f"{count} geoms {reason} are not drawn")
    if geoms.simplified:
        note("visual", "model", f"{geoms.simplified} meshes of more than {MOST} triangles are drawn by fewer")
    return found


class _Geoms:
    def __init__(self, model: mujoco.MjModel) -> None:
        import mujoco

        self._model, self._kinds = model, mujoco.mjtGeom
        self._meshes: dict[int, tuple[Any, Any]] = {}
        self.simplified = 0

    def hidden(self, k: int) -> str:
        """Why a geom is not drawn; "" if it is."""
        model = self._model
        if model.geom_group[k] >= HIDDEN:
            return f"of the groups from {HIDDEN} on, which MuJoCo hides,"
        if self._rgba(k)[3] == 0:
            return "that are transparent"
        if model.geom_type[k] == self._kinds.mjGEOM_PLANE and model.geom_bodyid[k] == 0:
            return "that are planes of the world"
        if model.geom_type[k] == self._kinds.mjGEOM_HFIELD:
            return "that are height fields"
        return ""

    def shapes(self, k: int) -> Sequence[Shape]:
        """In the frame of the geom."""
        model, kinds = self._model, self._kinds
        x, y, z = model.geom_size[k].tolist()
        color = self._color(k)
        made: dict[int, Callable[[], Sequence[Shape]]] = {
            kinds.mjGEOM_PLANE: lambda: [_plate(x, y, color)],
            kinds.mjGEOM_SPHERE: lambda: [Sphere(x, color=color)],
            kinds.mjGEOM_CAPSULE: lambda: capsule(x, 2 * y, color),
            kinds.mjGEOM_ELLIPSOID: lambda: ellipsoid((x, y, z), color),
            kinds.mjGEOM_CYLINDER: lambda: [Cylinder(x, 2 * y, color=color)],
            kinds.mjGEOM_BOX: lambda: [Box((2 * x, 2 * y, 2 * z), color=color)],
        }
        make = made.get(int(model.geom_type[k]))
        return make() if make else [Mesh(*self._mesh(int(model.geom_dataid[k])), color=color)]

    def _mesh(self, mesh: int) -> tuple[Any, Any]:
        """Vertices and triangles, the same arrays for all geoms of a mesh."""
        if mesh not in self._meshes:
            model = self._model
            vertices = model.mesh_vert[model.mesh_vertadr[mesh] :][: model.mesh_vertnum[mesh]].astype(float)
            triangles = model.mesh_face[model.mesh_faceadr[mesh] :][: model.mesh_facenum[mesh]]
            self.simplified += len(triangles) > MOST
            fewer = simplified(vertices, triangles, MOST if len(triangles) > MOST else np.inf)
            self._meshes[mesh] = fewer[0].astype(np.float32).astype(float), fewer[1]
        return self._meshes[mesh]

    def _rgba(self, k: int) -> tuple[float, ...]:
        """Of the geom, or of its material where it says nothing, with the mean of a texture."""
        model = self._model
        own, material = tuple(model.geom_rgba[k].tolist()), int(model.geom_matid[k])
        if material < 0 or not np.allclose(own, UNSAID):
            return own
        return tuple((model.mat_rgba[material] * self._texture(material)).tolist())

    def _texture(self, material: int) -> Any:
        """The mean color (4,) of a material's texture, or ones."""
        model = self._model
        found = [int(k) for k in np.ravel(model.mat_texid[material]) if k >= 0]
        if not found:
            return np.ones(4)
        k = found[0]
        channels = int(model.tex_nchannel[k])
        size = int(model.tex_height[k]) * int(model.tex_width[k]) * channels
        pixels = model.tex_data[model.tex_adr[k] :][:size].reshape(-1, channels)
        mean = pixels.mean(axis=0) / 255
        return np.append(mean[:3] if channels >= 3 else np.repeat(mean[:1], 3), 1.0)

    def _color(self, k: int) -> str:
        return hex_of(self._rgba(k))


def _plate(x: float, y: float, color: str) -> Shape:
    """Half sizes; zero stands for infinite. Its upper side is in the plane."""
    x, y = (size or 1.0 for size in (x, y))
    thick = THIN * max(x, y)
    return Box((2 * x, 2 * y, thick), position=(0, 0, -thick / 2), color=color)
