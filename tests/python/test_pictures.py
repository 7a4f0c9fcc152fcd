"""Pictures without a browser: what covers what, where it is, how it is lit; shapes that bodies get by
themselves.
"""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork.modeling.shapes import Shape
from linkwork.view.appearance import at_least, body_color, default_shapes, scene
from linkwork.view.camera import Camera
from linkwork.view.movie import Painter
from linkwork.view.raster import Raster
from linkwork.view.surfaces import coil, surface

RED, BLUE = np.array([1.0, 0, 0]), np.array([0, 0, 1.0])


def triangle(corners: list[tuple[float, float]], near: float, color: np.ndarray) -> tuple[np.ndarray, ...]:
    return np.array([corners], float), np.full((1, 3), near), np.tile(color, (1, 3, 1))


@pytest.mark.parametrize("scale", [3.0, 20.0, 90.0])
def test_a_triangle_covers_its_area(scale: float) -> None:
    """Of every size: small ones are filled many at once."""
    raster = Raster(np.zeros((100, 100, 3)), samples=4)
    corners = [(2.2, 1.3), (2.2 + scale, 1.9), (3.1, 1.3 + 0.9 * scale)]
    raster.draw(*triangle(corners, 1.0, RED))
    a, b, c = np.array(corners)
    area = abs(np.linalg.det([b - a, c - a])) / 2
    assert raster.picture()[..., 0].sum() / 255 == pytest.approx(area, rel=0.04)


def test_the_nearest_is_seen_whatever_is_drawn_first() -> None:
    pictures = []
    for order in ((0, 1), (1, 0)):
        raster = Raster(np.ones((20, 20, 3)))
        both = [
            triangle([(1, 1), (19, 1), (1, 19)], 0.5, RED),
            triangle([(1, 1), (19, 1), (1, 19)], 0.6, BLUE),
        ]
        for k in order:
            raster.draw(*both[k])
        pictures.append(raster.picture())
    assert (pictures[0] == pictures[1]).all()
    assert (pictures[0][5, 5] == (0, 0, 255)).all() and (pictures[0][19, 19] == 255).all()


def test_colors_go_evenly_from_corner_to_corner() -> None:
    raster = Raster(np.zeros((101, 101, 3)), samples=1)
    colors = np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0]]], float)
    raster.draw(np.array([[[0.5, 0.5], [100.5, 0.5], [0.5, 100.5]]]), np.ones((1, 3)), colors)
    picture = raster.picture() / 255
    assert picture[30, 40] == pytest.approx([0.4, 0.3, 0], abs=3e-3)


def test_what_is_behind_the_eye_is_not_drawn() -> None:
    camera = Camera(np.zeros(3), np.eye(3), (100, 60))
    _, nearness = camera.seen(np.array([[0, 0, -2.0], [0, 0, 2.0]]))
    assert nearness.tolist() == [0.5, 0.0]
    raster = Raster(np.zeros((60, 100, 3)))
    raster.draw(np.array([[[0, 0], [99, 0], [0, 59.0]]]), np.array([[1, 1, 0.0]]), np.ones((1, 3, 3)))
    assert not raster.picture().any()


def test_a_ray_through_a_pixel_meets_what_is_seen_there() -> None:
    axes = lw.rotation.matrix(lw.rotation.about((1, 2, 3), 0.7))
    camera = Camera(np.array([1.0, 2, 3]), axes, (64, 48))
    point = camera.position + 7 * camera.rays()[11, 40]
    places, nearness = camera.seen(point)
    assert places == pytest.approx([40.5, 11.5]) and 1 / nearness == pytest.approx(7)


@pytest.mark.parametrize(
    "shape",
    [lw.Box((1, 2, 3)), lw.Sphere(0.7), lw.Cylinder(0.5, 2), lw.Rod((1, 0, 0), (0, 2, 1), 0.2)],
    ids=lambda shape: shape.kind,
)
def test_surfaces_enclose_the_volume_of_their_solid(shape: Shape) -> None:
    volumes = {
        "box": 6,
        "sphere": 4 / 3 * np.pi * 0.7**3,
        "cylinder": np.pi * 0.5,
        "rod": np.pi * 0.04 * 6**0.5,
    }
    corners, normals = surface(shape)
    a, b, c = (corners[:, k] for k in range(3))
    assert np.einsum("ki,ki->", a, np.cross(b, c)) / 6 == pytest.approx(volumes[shape.kind], rel=0.03)
    across = np.cross(b - a, c - a)
    whole = np.linalg.norm(across, axis=1) > 1e-12
    assert (np.einsum("ki,kci->kc", across, normals)[whole] > 0).all()  # normals look outside
    assert np.linalg.norm(normals, axis=-1) == pytest.approx(1)


def test_a_coil_is_seen_from_outside() -> None:
    corners, normals = coil()
    scaled = corners * (1, 1, 12)
    across = np.cross(scaled[:, 1] - scaled[:, 0], scaled[:, 2] - scaled[:, 0])
    whole = np.linalg.norm(across, axis=1) > 1e-9
    assert (np.einsum("ki,kci->kc", across, normals)[whole] > 0).mean() > 0.99


def test_a_picture_shows_a_ball_on_the_floor_where_the_camera_sees_it() -> None:
    model = lw.Model(name="ball")
    model.body("ball", mass=1, inertia=(1, 1, 1), shape=lw.Sphere(0.1, color="#ff0000"))
    model.body(
        "other", mass=1, inertia=(1, 1, 1), position=(1, 0.5, 0.7), shape=lw.Sphere(0.1, color="#ffffff")
    )
    result = lw.simulate(model, t_end=0.01, step=1e-3)
    painter = Painter(result, (320, 200))
    picture = painter.picture(0.0).astype(int)
    rows, columns = np.nonzero(picture[..., 0] - picture[..., 1] > 60)
    expected = painter.projected(np.zeros((1, 3)))[0]
    assert [columns.mean() + 0.5, rows.mean() + 0.5] == pytest.approx(expected, abs=1.0)
    shades = picture[rows, columns, 0]
    assert shades.min() < 0.75 * shades.max() and len(np.unique(shades)) > 20  # smooth, lit from one side
    background = np.abs(picture - (0xF4, 0xF5, 0xF7)).sum(axis=-1)
    assert ((background > 8) & (background < 160)).sum() > 300  # the lines of the floor


# --- what bodies look like by themselves --------------------------------------------------------------------


def test_four_joints_in_a_plane_make_a_plate() -> None:
    A = lw.rotation.matrix(lw.rotation.about((1, 2, 3), 0.7))
    corners = np.array([(1, 1, 0.2), (-1, 1, 0.2), (-1, -1, 0.2), (1, -1, 0.2)]) @ A.T
    (plate,) = default_shapes(list(corners), 1.0, np.eye(3), 0.05)
    assert isinstance(plate, lw.Mesh)
    there = (plate.position + plate.vertices @ lw.rotation.matrix(plate.orientation).T) @ A
    assert np.abs(there[:, 2] - 0.2).max() == pytest.approx(0.025)  # as thick as a rod's radius
    a, b, c = (plate.vertices[plate.triangles[:, k]] for k in range(3))
    edge = 1.8 * 0.05  # with round corners around
    area = 4 + 8 * edge + 3 * edge**2
    assert np.einsum("ki,ki->", a, np.cross(b, c)) / 6 == pytest.approx(0.05 * area, rel=0.01)


def test_joints_in_space_or_on_a_line_make_no_plate() -> None:
    space = [np.array(corner, float) for corner in ((1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, -1, -1))]
    line = [np.array((x, 0.001 * x**2, 0)) for x in (-1.0, -0.3, 0.4, 1.0)]
    for points in (space, line):
        assert not any(isinstance(shape, lw.Mesh) for shape in default_shapes(points, 1.0, np.eye(3), 0.05))


@pytest.mark.parametrize("driven", [False, True])
def test_bodies_that_slide_in_each_other_are_a_cylinder_and_a_thinner_piston(driven: bool) -> None:
    """Each from its joint to where its inertia ends: a rod of length l, m l^2 / 12."""
    model = lw.Model()
    for name, mass, length, x in (("cylinder", 3.0, 1.0, 0.5), ("piston", 1.0, 0.8, 1.2)):
        across = mass * length**2 / 12
        model.body(name, mass=mass, inertia=(1e-4, across, across), position=(x, 0, 0))
    model.revolute("ground", "cylinder", at=(0, 0, 0), axis=(0, 1, 0))
    model.translational("cylinder", "piston", at=(1.6, 0, 0), axis=(1, 0, 0))
    if driven:
        model.displacement_driver("cylinder", "piston", at=(1.6, 0, 0), axis=(1, 0, 0), displacement=0.0)
    model.body("load", mass=1.0, inertia=(1, 1, 1), position=(1.6, 0, 0))
    model.spherical("piston", "load", at=(1.6, 0, 0))
    drawn = scene(lw.simulate(model, t_end=0.002, step=1e-3)).solids
    cylinder, collar = (it.shape for it in drawn if it.layer == "body" and it.body == 0)
    (piston,) = (it.shape for it in drawn if it.layer == "body" and it.body == 1)
    assert isinstance(cylinder, lw.Rod) and isinstance(piston, lw.Rod) and isinstance(collar, lw.Rod)
    assert [cylinder.start[0] + 0.5, cylinder.end[0] + 0.5] == pytest.approx([0, 1], abs=2e-3)
    assert [piston.start[0] + 1.2, piston.end[0] + 1.2] == pytest.approx([1.6, 0.8], abs=2e-3)
    assert piston.radius < 0.7 * cylinder.radius < cylinder.radius < collar.radius
    assert collar.position == pytest.approx(cylinder.end)


def test_of_many_bodies_neighbors_have_nearly_the_same_color() -> None:
    colors = np.array([list(bytes.fromhex(body_color(i, 1000)[1:])) for i in range(1000)], int)
    assert np.abs(np.diff(colors, axis=0)).max() <= 3
    assert np.abs(colors[0] - colors[-1]).max() > 60
    assert len({body_color(i, 8) for i in range(8)}) == 8


def test_a_long_chain_is_more_than_a_hairline() -> None:
    """Rods of 1/36 of a pixel are a line of some pixels, and none is left out."""
    result = lw.simulate(lw.mechanisms.chain(1000), t_end=0.01, step=1e-3, progress=False)
    picture = Painter(result, (640, 400)).picture(0.0).astype(int)
    colored = np.ptp(picture, axis=-1) > 30
    rows, columns = np.nonzero(colored)
    assert np.ptp(columns) + 1 == len(set(columns)) > 400
    assert np.median(colored.sum(axis=0)[columns.min() : columns.max()]) >= 3


@pytest.mark.parametrize(
    "shape", [lw.Box((1, 0.01, 2)), lw.Sphere(0.01), lw.Cylinder(0.01, 1), lw.Rod((0, 0, 0), (1, 0, 0), 0.01)]
)
def test_what_is_seen_from_afar_is_thick_enough_and_as_long_as_before(shape: Shape) -> None:
    corners, _ = surface(at_least(shape, 0.1))
    sides = np.ptp(corners.reshape(-1, 3), axis=0)
    before = np.ptp(surface(shape)[0].reshape(-1, 3), axis=0)
    assert sides == pytest.approx(np.maximum(before, 0.1), rel=0.02)
    assert at_least(shape, 1e-3) is shape
