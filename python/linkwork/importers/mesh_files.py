"""The meshes of robot files: found by their URIs, read by trimesh, with few enough triangles to be drawn."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from linkwork.arguments import optional_package
from linkwork.arrays import Floats, Indices
from linkwork.errors import FileError

__all__ = ["MOST", "Part", "find", "read", "simplified"]

#: Kinds of files that are read.
SUFFIXES = (".stl", ".dae", ".obj", ".ply", ".off", ".glb", ".gltf")

#: Triangles of one file that are drawn; more are made fewer.
MOST = 8000

#: Cells of the grid of `simplified` grow by this factor until the triangles are few enough.
COARSER = 1.15


@dataclass(frozen=True)
class Part:
    """Triangles of one color: vertices (n, 3) [m], triangles (m, 3), "#rrggbb" or None."""

    vertices: Floats
    triangles: Indices
    color: str | None


def find(uri: str, here: Path, search_path: Sequence[Path]) -> Path:
    """The file that a URI means: package://name/..., model://name/..., file://..., or a path.

    A package is a folder of that name: in one of the search path or of ROS_PACKAGE_PATH, or around the
    robot's file, whose folder is `here`; a path is relative to that folder or one of the search path.
    FileError: there is none (code not_found), or it is of a kind that is not read (format).
    """
    scheme, _, rest = uri.rpartition("://")
    relative = unquote(rest)
    if scheme not in ("", "file", "package", "model"):
        raise FileError(f"'{uri}' is not here: nothing is downloaded", code="not_found")
    if Path(relative).suffix.lower() not in SUFFIXES:
        raise FileError(f"'{uri}' is none of {', '.join(SUFFIXES)}", code="format")
    for path in _places(scheme, relative, here, search_path):
        if path.is_file():
            return path.resolve()
    raise FileError(f"'{uri}' is not found: give its folder in search_path", code="not_found")


def _places(scheme: str, relative: str, here: Path, search_path: Sequence[Path]) -> Iterator[Path]:
    if scheme in ("", "file"):
        yield here / relative
        yield from (folder / relative for folder in search_path)
        return
    name, _, inside = relative.lstrip("/").partition("/")
    ros = [Path(folder) for folder in os.environ.get("ROS_PACKAGE_PATH", "").split(os.pathsep) if folder]
    for folder in (*search_path, *ros):
        yield folder / name / inside
        if folder.name == name:
            yield folder / inside
    around = [here, *here.parents]
    yield from (folder / name / inside for folder in around)
    yield from (folder / inside for folder in around)  # where the package's folder has another name


def read(path: Path, scale: tuple[float, float, float]) -> tuple[tuple[Part, ...], int]:
    """The parts of a file and how many triangles it has; at most MOST of them are in the parts.

    A factor for each axis; a negative one mirrors. FileError: no trimesh (code missing_package), or a file
    that cannot be read (not_readable).
    """
    optional_package("trimesh", "mesh", "a mesh", FileError)
    if path.suffix.lower() == ".dae":
        optional_package("collada", "mesh", "a .dae mesh", FileError)
    status = path.stat()
    return _read(str(path), scale, (status.st_mtime_ns, status.st_size))


@lru_cache(maxsize=1024)
def _read(path: str, scale: tuple[float, float, float], _: tuple[int, int]) -> tuple[tuple[Part, ...], int]:
    """Once for each state of a file: robots have many alike, and studies read them again and again."""
    import trimesh

    try:
        found: Any = trimesh.load(path, process=False)
        parts = list(_parts(found, _unit(found) * np.array(scale)))
    except Exception as error:  # whatever a reader of damaged files may raise
        reason = str(error) or type(error).__name__
        raise FileError(f"'{path}' cannot be read: {reason}", code="not_readable") from error
    total = sum(len(part.triangles) for part in parts)
    if not total:
        raise FileError(f"'{path}' has no triangles", code="not_readable")
    few = [_few(part, MOST * len(part.triangles) / total if total > MOST else np.inf) for part in parts]
    return tuple(part for part in few if len(part.triangles)), total


def _unit(found: Any) -> float:
    """Of a length in the file [m]: Collada says it, other kinds of files do not."""
    words = str((getattr(found, "metadata", None) or {}).get("units", "")).split(" * ")
    return float(words[0]) if len(words) == 2 and words[1] == "meters" else 1.0


def _parts(found: Any, scale: Floats) -> Iterator[Part]:
    import trimesh

    if isinstance(found, trimesh.Trimesh):
        nodes = [(np.eye(4), found)]
    else:
        placed = (found.graph[node] for node in found.graph.nodes_geometry)
        nodes = [(np.asarray(pose), found.geometry[name]) for pose, name in placed]
    for pose, mesh in nodes:
        if not isinstance(mesh, trimesh.Trimesh) or not len(mesh.faces):
            continue  # points and lines
        vertices = (np.asarray(mesh.vertices, float) @ pose[:3, :3].T + pose[:3, 3]) * scale
        triangles = np.asarray(mesh.faces, np.int32)
        inside_out = np.linalg.det(pose[:3, :3]) * np.prod(scale) < 0
        finite = np.isfinite(vertices[triangles]).all(axis=(1, 2))
        triangles = (triangles[:, ::-1] if inside_out else triangles)[finite]
        yield Part(np.where(np.isfinite(vertices), vertices, 0.0), triangles, _color(mesh))


def _color(mesh: Any) -> str | None:
    """Of its material, the mean one of a texture; None where the file has none."""
    visual = mesh.visual
    if not visual.defined:
        return None
    kind = getattr(visual, "kind", None)
    if kind == "texture":
        material = visual.material
        image = getattr(material, "image", None) or getattr(material, "baseColorTexture", None)
        colors = visual.to_color().vertex_colors if image is not None else material.main_color
    elif kind in ("vertex", "face"):
        colors = visual.vertex_colors if kind == "vertex" else visual.face_colors
    else:
        return None
    mean = np.asarray(colors, float).reshape(-1, 4).mean(axis=0)
    return "#" + "".join(f"{int(round(part)):02x}" for part in mean[:3])


# --- fewer triangles ----------------------------------------------------------------------------------------


def _few(part: Part, most: float) -> Part:
    vertices, triangles = simplified(part.vertices, part.triangles, most)
    return Part(vertices.astype(np.float32).astype(float), triangles, part.color)


def simplified(vertices: Floats, triangles: Indices, most: float) -> tuple[Floats, Indices]:
    """At most so many triangles: the vertices in each cell of a grid become one, where their mean is.

    Cells are as wide as makes two triangles a cell of the surface, and wider until there are few enough.
    Equal vertices are one in any case.
    """
    vertices, triangles = _merged(vertices, triangles, vertices)
    corners = vertices[triangles]
    area = (
        np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()
        / 2
    )
    width = float(np.sqrt(2 * area / max(most, 1.0))) if np.isfinite(most) else 0.0
    out = vertices, triangles
    while len(out[1]) > most and width > 0:
        out = _merged(vertices, triangles, np.floor(vertices / width))
        width *= COARSER
    return out


def _merged(vertices: Floats, triangles: Indices, keys: Floats) -> tuple[Floats, Indices]:
    """Vertices with equal keys (n, 3) become their mean; triangles that then have no area, or twice, go."""
    _, place, count = np.unique(keys, axis=0, return_inverse=True, return_counts=True)
    place = place.reshape(-1)
    means = (
        np.stack([np.bincount(place, vertices[:, k], len(count)) for k in range(3)], axis=1) / count[:, None]
    )
    corners = place[triangles]
    whole = (corners != np.roll(corners, 1, axis=1)).all(axis=1)
    corners = corners[whole]
    first = np.sort(np.unique(np.sort(corners, axis=1), axis=0, return_index=True)[1])
    used, corners = np.unique(corners[first], return_inverse=True)
    return means[used], corners.reshape(-1, 3).astype(np.int32)
