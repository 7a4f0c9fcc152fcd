"""Shapes of bodies: what they accept, that files keep them, and what is drawn where none was given."""

from __future__ import annotations

from pathlib import Path

import linkwork as lw
import numpy as np
import pytest
from linkwork import rotation
from linkwork.errors import FileError, ModelError
from linkwork.modeling.shapes import Shape
from linkwork.view.appearance import Solid, default_shapes, scene

TETRAHEDRON = """solid t
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 0 1 0
vertex 1 0 0
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 0 1
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 0 0 1
vertex 0 1 0
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 1 0 0
vertex 0 1 0
vertex 0 0 1
endloop
endfacet
endsolid t
"""


def equal(a: Shape, b: Shape) -> bool:
    one, other = a.description(), b.description()
    return one.keys() == other.keys() and all(np.array_equal(one[key], other[key]) for key in one)


# --- descriptions ---


@pytest.mark.parametrize(
    "shape",
    [
        lw.Box((1, 2, 3), position=(0, 0, 1), color="red"),
        lw.Sphere(0.5),
        lw.Cylinder(0.5, 2.0, axis=(1, 1, 0)),
        lw.Rod((0, 0, 0), (0, 0, 2)),
        lw.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], orientation=rotation.about((0, 0, 1), 0.3)),
    ],
)
def test_description_gives_the_same_shape(shape: Shape) -> None:
    assert equal(Shape.of(shape.description()), shape)


def test_cylinder_lies_along_its_axis() -> None:
    cylinder = lw.Cylinder(0.5, 2.0, axis=(1, 1, 0))
    np.testing.assert_allclose(
        rotation.matrix(cylinder.orientation)[:, 2], np.array([1, 1, 0]) / np.sqrt(2), atol=1e-15
    )


def test_rod_lies_between_its_ends() -> None:
    rod = lw.Rod((1, 0, 0), (1, 2, 0))
    np.testing.assert_allclose(rod.position, [1, 1, 0])
    np.testing.assert_allclose(rotation.matrix(rod.orientation)[:, 2], [0, 1, 0], atol=1e-15)
    assert rod.radius == pytest.approx(2 / 25)


@pytest.mark.parametrize(
    ("make", "named"),
    [
        (lambda: lw.Box((1, -2, 3)), "size -2"),
        (lambda: lw.Box((1, 2)), "3 finite numbers"),
        (lambda: lw.Sphere(0), "radius 0"),
        (lambda: lw.Sphere(float("nan")), "radius nan"),
        (lambda: lw.Cylinder(1, 1, axis=(0, 0, 0)), "no direction"),
        (lambda: lw.Rod((1, 1, 1), (1, 1, 1)), "coincide"),
        (lambda: lw.Sphere(1, orientation=(1, 1, 0, 0)), "norm 1.41421"),
        (lambda: lw.Sphere(1, color="reddish"), "'reddish'"),
        (lambda: lw.Mesh([[0, 0, 0]], [[0, 0, 1]]), "beyond the 1"),
        (lambda: Shape.of({"kind": "cone"}), "'cone'"),
        (lambda: Shape.of({"kind": "box", "edge": 1}), "edge"),
        (lambda: lw.Model().body("b", mass=1, inertia=(1, 1, 1), shape="box"), "'b'"),
    ],
)
def test_what_no_shape_can_be_is_refused_by_value(make: object, named: str) -> None:
    with pytest.raises(ModelError, match=named):
        make()  # type: ignore[operator]


def test_a_refused_shape_leaves_the_model_as_it_was() -> None:
    model = lw.Model()
    with pytest.raises(ModelError):
        model.body("b", mass=1, inertia=(1, 1, 1), shape=[3])  # type: ignore[list-item]
    assert model.body_count == 0


# --- meshes ---


@pytest.mark.parametrize("kind", ["stl", "obj"])
def test_mesh_from_a_file_has_the_volume_of_its_solid(tmp_path: Path, kind: str) -> None:
    """A tetrahedron with edges of 1: volume 1/6, by the divergence theorem; in mm when scaled."""
    path = tmp_path / f"part.{kind}"
    corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    path.write_text(TETRAHEDRON if kind == "stl" else f"{corners}f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
    mesh = lw.Mesh.load(path, scale=1e-3)
    assert mesh.vertices.shape == (4, 3)
    a, b, c = (mesh.vertices[mesh.triangles[:, k]] for k in range(3))
    volume = np.einsum("ij,ij->", a, np.cross(b, c)) / 6
    assert volume == pytest.approx(1e-9 / 6)


def test_mesh_files_that_are_missing_damaged_or_of_another_kind_are_named(tmp_path: Path) -> None:
    (tmp_path / "bad.stl").write_text("solid nothing\nendsolid nothing\n")
    for name, message in (
        ("no.stl", "no such file"),
        ("bad.stl", "bad.stl"),
        ("part.step", "neither .stl nor .obj"),
    ):
        with pytest.raises(FileError, match=message):
            lw.Mesh.load(tmp_path / name)


# --- models and files ---


def shaped_model() -> lw.Model:
    mesh = lw.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    model = lw.Model()
    model.body("a", mass=1, inertia=(1, 1, 1), shape=mesh)
    model.bodies("b", mass=1, inertia=(1, 1, 1), position=np.eye(3), shape=[lw.Sphere(0.1), mesh])
    model.find("b[1]").shape(lw.Box((1, 2, 3), color="#123456"))
    model.ground.shape(lw.Cylinder(1, 2))
    return model


def test_shapes_come_back_from_a_file(tmp_path: Path) -> None:
    model = shaped_model()
    lw.simulate(model, t_end=0.1, step=0.01).save(tmp_path / "run.h5")
    expected, found = model.shapes.by_body(), lw.Result.load(tmp_path / "run.h5").header.shapes.by_body()
    assert found.keys() == expected.keys() == {-1, 0, 1, 2, 3}
    assert all(equal(a, b) for body in expected for a, b in zip(expected[body], found[body], strict=True))
    assert found[2][0].color == "#123456"
    assert found[1][1].vertices is found[3][1].vertices  # type: ignore[attr-defined]


def test_shapes_are_kept_from_another_initial_state_and_change_no_hash() -> None:
    model = shaped_model()
    q, v = model.compiled().q0, model.compiled().v0
    assert model.with_initial_state(q, v).shapes.by_body() == model.shapes.by_body()
    bare = lw.Model()
    bare.body("a", mass=1, inertia=(1, 1, 1))
    bare.bodies("b", mass=1, inertia=(1, 1, 1), position=np.eye(3))
    assert bare.hash() == model.hash()


# --- defaults ---


def drawn(model: lw.Model, layer: str) -> list[Solid]:
    result = lw.simulate(model, t_end=0.01, step=1e-3)
    return [solid for solid in scene(result).solids if solid.layer == layer]


def test_link_is_a_rod_between_its_joints() -> None:
    (rod,) = default_shapes([np.array([-0.5, 0, 0]), np.array([0.7, 0, 0])], 1.0, np.eye(3), 0.02)
    assert isinstance(rod, lw.Rod)
    np.testing.assert_allclose([rod.start, rod.end], [[-0.5, 0, 0], [0.7, 0, 0]])


@pytest.mark.parametrize("edges", [(1.0, 2.0, 3.0), (0.2, 0.1, 2.0)])
def test_free_body_is_the_box_of_its_inertia(edges: tuple[float, float, float]) -> None:
    x, y, z = edges
    inertia = 6.0 / 12 * np.diag([y**2 + z**2, x**2 + z**2, x**2 + y**2])
    A = rotation.matrix(rotation.about((1, 2, 3), 0.7))
    (box,) = default_shapes([], 6.0, A @ inertia @ A.T, 1e-3)
    assert isinstance(box, lw.Box)
    np.testing.assert_allclose(sorted(box.size), sorted(edges))
    longest = rotation.matrix(box.orientation)[:, np.argmax(box.size)]
    assert abs(longest @ A[:, int(np.argmax(edges))]) == pytest.approx(1)


def test_symmetric_free_body_is_the_cylinder_of_its_inertia() -> None:
    m, R, L = 2.0, 0.3, 1.5
    J = m * (3 * R**2 + L**2) / 12
    (cylinder,) = default_shapes([], m, np.diag([J, m * R**2 / 2, J]), 1e-3)
    assert isinstance(cylinder, lw.Cylinder)
    assert (cylinder.radius, cylinder.length) == pytest.approx((R, L))
    assert abs(rotation.matrix(cylinder.orientation)[1, 2]) == pytest.approx(1)


def test_rod_pendulum_reaches_to_its_free_end() -> None:
    """A uniform rod of 1 m, hinged at one end: drawn from the hinge to twice the center of mass."""
    model = lw.Model()
    rod = model.body("rod", mass=1.0, inertia=(1e-5, 1 / 12, 1 / 12), position=(0.5, 0, 0))
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, 1, 0))
    (solid,) = drawn(model, "body")
    assert isinstance(solid.shape, lw.Rod)
    np.testing.assert_allclose([solid.shape.start, solid.shape.end], [[-0.5, 0, 0], [0.5, 0, 0]], atol=1e-3)


@pytest.mark.parametrize(
    ("kind", "where", "symbol"),
    [
        ("spherical", {"at": (0, 0, 0)}, lw.Sphere),
        ("revolute", {"at": (0, 0, 0), "axis": (0, 1, 0)}, lw.Cylinder),
        ("cylindrical", {"at": (0, 0, 0), "axis": (0, 1, 0)}, lw.Cylinder),
        ("translational", {"at": (0, 0, 0), "axis": (0, 1, 0)}, lw.Box),
        ("fixed", {"at": (0, 0, 0)}, lw.Box),
    ],
)
def test_joints_are_drawn_by_what_they_hold(kind: str, where: dict[str, object], symbol: type[Shape]) -> None:
    model = lw.Model()
    body = model.body("b", mass=1.0, inertia=(1, 1, 1), position=(1, 0, 0))
    getattr(model, kind)(model.ground, body, **where)
    (solid,) = drawn(model, "joint")
    assert isinstance(solid.shape, symbol)
    if kind in ("revolute", "cylindrical"):
        axis = rotation.matrix(solid.shape.orientation)[:, 2]
        np.testing.assert_allclose(np.abs(axis), [0, 1, 0], atol=1e-12)


def test_every_kind_of_joint_is_read_without_complaint() -> None:
    from linkwork.modeling.elements import KINDS
    from linkwork.motion.violations import Holds

    assert {Holds.of(kind).placed for kind in KINDS["joint"]} == {True, False}
    assert all(Holds.of(kind).turning for kind in ("revolute", "cylindrical", "screw", "planar"))
    assert all(Holds.of(kind).sliding for kind in ("translational", "cylindrical"))
    assert not any((Holds.of(kind).turning or Holds.of(kind).sliding) for kind in ("spherical", "fixed"))
    assert Holds.of("of a later version").placed
