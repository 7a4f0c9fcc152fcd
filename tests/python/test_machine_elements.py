"""Springs, contacts, gears and discs as they are drawn: where the result says, and of the size it says."""

from __future__ import annotations

from pathlib import Path

import h5py
import linkwork as lw
import numpy as np
import pytest
import synthetic
from linkwork.modeling.shapes import Mesh, Rod, Sphere
from linkwork.view import machine_elements, meshes
from linkwork.view.appearance import Solid, scene


@pytest.fixture(scope="module")
def contact() -> lw.Result:
    """A ball thrown along a plane that is tilted, on a spring."""
    model = lw.Model()
    ball = model.body("ball", mass=1, inertia=(0.1, 0.1, 0.1), position=(0, 0, 1), velocity=(1, 0.5, 0))
    model.sphere_plane_contact(
        "ground", ball, at=((0, 0, 0), (0, 0, 1)), normal=(0.2, 0, 1), radius=0.1, stiffness=1e5,
        exponent=1.5, hysteresis=0.5, friction=0.1, transition=0.01, name="floor",
    )  # fmt: skip
    model.spring_damper("ground", ball, at=((0, 0, 2), (0, 0, 1)), stiffness=5, damping=0.1, name="rope")
    return lw.simulate(model, t_end=0.5, step=1e-3)


def test_file_has_the_force_elements_and_their_numbers(contact: lw.Result, tmp_path: Path) -> None:
    contact.save(tmp_path / "run.h5")
    header = lw.Result.load(tmp_path / "run.h5").header
    assert list(header.force_names) == ["floor", "rope"]
    assert list(header.force_kinds) == ["sphere_plane_contact", "spring_damper"]
    found = list(machine_elements.elements(header, "force"))
    assert found[0].numbers["radius"] == 0.1
    assert found[1].numbers == {"stiffness": 5, "damping": 0.1, "free_length": 1, "force": 0}
    np.testing.assert_array_equal(found[1].origin, [(0, 0, 2), (0, 0, 0)])


def test_numbers_that_are_functions_are_not_known() -> None:
    model = lw.Model()
    body = model.body("body", mass=1, inertia=(1, 1, 1), position=(0, 0, -1))
    model.spring_damper("ground", body, at=((0, 0, 0), (0, 0, -1)), stiffness=1, force=np.sin)
    (spring,) = machine_elements.elements(lw.simulate(model, t_end=0.01, step=0.01).header, "force")
    assert np.isnan(spring.numbers["force"])


def test_file_without_force_elements_is_drawn_without_them(contact: lw.Result, tmp_path: Path) -> None:
    """As files of earlier versions are."""
    contact.save(tmp_path / "run.h5")
    with h5py.File(tmp_path / "run.h5", "a") as file:
        synthetic.strip_digests(file)
        for name in [name for name in file["model"] if name.startswith("force") or "parameter" in name]:
            del file["model"][name]
    drawn = scene(lw.Result.load(tmp_path / "run.h5"))
    assert not drawn.spans
    assert {it.layer for it in drawn.solids} == {"body"}


def test_plane_lies_under_all_the_way_of_the_ball(contact: lw.Result) -> None:
    (plate,) = (it for it in scene(contact).solids if it.body < 0)
    A = lw.rotation.matrix(plate.shape.orientation)
    np.testing.assert_allclose(A[:, 2], np.array([0.2, 0, 1]) / np.hypot(0.2, 1), atol=1e-12)
    edges = np.array(plate.shape.dimensions()["size"])
    top = plate.shape.position + A[:, 2] * edges[2] / 2
    assert abs(top @ A[:, 2]) < 1e-12  # the plane goes through the origin
    seen = (contact.position[:, 0] - plate.shape.position) @ A[:, :2]
    assert (np.abs(seen) <= edges[:2] / 2 - 0.1).all()


def test_ball_of_a_contact_has_its_radius_and_is_clear(contact: lw.Result) -> None:
    (ball,) = (it for it in scene(contact).solids if it.clear)
    assert isinstance(ball.shape, Sphere)
    assert ball.shape.radius == 0.1


@pytest.mark.parametrize(("numbers", "forms"), [
    ({"stiffness": 1.0}, ["coil"]),
    ({"damping": 1.0, "stiffness": 0.0}, ["damper"]),
    ({"stiffness": 1.0, "damping": 1.0}, ["coil", "damper"]),
    ({"stiffness": 0.0, "force": np.sin}, ["damper"]),
])  # fmt: skip
def test_spring_is_a_coil_and_damper_or_actuator_a_cylinder(numbers: dict, forms: list[str]) -> None:
    model = lw.Model()
    body = model.body("body", mass=1, inertia=(1, 1, 1), position=(0, 0, -1))
    model.spring_damper("ground", body, at=((0, 0, 0), (0, 0, -1)), **numbers)
    assert [it.form for it in scene(lw.simulate(model, t_end=0.01, step=0.01)).spans] == forms


@pytest.mark.parametrize(
    "kind", [kind.name for kind in lw._core.joint_kinds() if "distance" in kind.equations]
)
def test_joint_that_holds_a_distance_is_a_bar(kind: str) -> None:
    model = lw.Model()
    body = model.body("body", mass=1, inertia=(1, 1, 1), position=(0, 0, -1))
    axis = {"axis": (0, 1, 0)} if kind.startswith("revolute") else {}
    getattr(model, kind)("ground", body, at=((0, 0, 0), (0, 0, -1)), **axis)
    (bar,) = scene(lw.simulate(model, t_end=0.01, step=0.01)).spans
    assert bar.form == "bar"
    np.testing.assert_allclose(bar.ends, [(0, 0, 0), (0, 0, 0)], atol=1e-12)


# --- gears ---


def gear_pair(teeth: tuple[int, int], centers: tuple[float, float]) -> lw.Result:
    model = lw.Model(gravity=(0, 0, 0))
    for name, x in zip("ab", centers, strict=True):
        model.body(name, mass=1, inertia=(1, 1, 1), position=(x, 0, 0), omega=(0, 0, 0))
        model.revolute("ground", name, at=(x, 0, 0), axis=(0, 0, 1))
    model.gear("a", "b", at=((centers[0], 0, 0), (centers[1], 0, 0)), axis=(0, 0, 1),
               teeth_a=teeth[0], teeth_b=teeth[1])  # fmt: skip
    return lw.simulate(model, t_end=0.01, step=0.01)


def wheels(result: lw.Result) -> list[Solid]:
    return sorted((it for it in scene(result).solids if isinstance(it.shape, Mesh)), key=lambda it: it.body)


@pytest.mark.parametrize(("teeth", "centers"), [
    ((20, 30), (0.0, 0.5)), ((21, 32), (0.5, 0.0)), ((20, -60), (0.2, 0.0)), ((-60, 20), (0.0, 0.2)),
    ((21, -61), (0.0, 0.2)),
])  # fmt: skip
def test_wheels_touch_on_their_pitch_circles_with_a_tooth_in_a_gap(
    teeth: tuple[int, int], centers: tuple[float, float]
) -> None:
    """Along the circle of a through the point of mesh, no corner of one wheel is inside the other."""
    pair = wheels(gear_pair(teeth, centers))
    radii = [0.5 * abs(count / sum(teeth)) if abs(centers[1] - centers[0]) == 0.5
             else 0.2 * abs(count / sum(teeth)) for count in teeth]  # fmt: skip
    corners = []
    for it, x in zip(pair, centers, strict=True):
        points = it.shape.position + it.shape.vertices @ lw.rotation.matrix(it.shape.orientation).T
        corners.append(points[:, :2] + (x, 0))
    apart = centers[1] - centers[0]
    side = np.sign(apart) if min(teeth) > 0 else np.sign(apart) * (-1 if abs(teeth[0]) < abs(teeth[1]) else 1)
    mesh = centers[0] + side * radii[0]
    assert mesh == pytest.approx(centers[1] + (-side if min(teeth) > 0 else side) * radii[1])
    module = 2 * radii[0] / abs(teeth[0])
    for points, x, radius, count in zip(corners, centers, radii, teeth, strict=True):
        beyond = (np.hypot(points[:, 0] - x, points[:, 1]) - radius) * np.sign(count)
        tips = points[beyond > 0.5 * module]
        tips = tips[np.hypot(tips[:, 0] - mesh, tips[:, 1]) < 1.2 * module] - (mesh, 0)
        on_the_line = np.abs(tips[:, 1]).min(initial=np.inf) < 0.25 * np.pi * module
        assert on_the_line == (points is corners[0])  # a tooth of a, a gap of b


@pytest.mark.parametrize("surface", [meshes.wheel(20), meshes.wheel(-20), meshes.spiral()])
def test_surfaces_are_closed_and_seen_from_outside(surface: meshes.Surface) -> None:
    vertices, triangles = surface
    edges = np.concatenate([triangles[:, [a, b]] for a, b in ((0, 1), (1, 2), (2, 0))])
    forth, back = ({tuple(edge) for edge in some.tolist()} for some in (edges, edges[:, ::-1]))
    assert len(forth) == len(edges)
    assert forth == back
    a, b, c = np.moveaxis(vertices[triangles], 1, 0)
    assert np.einsum("kc,kc->", a, np.cross(b, c)) / 6 > 0.01


def test_rolling_disc_has_its_radius_and_a_plane() -> None:
    result = lw.simulate(lw.mechanisms.rolling_disc(), t_end=0.5, step=1e-3)
    (disc,) = (it for it in scene(result).solids if it.layer == "body")
    (joint,) = machine_elements.elements(result.header, "joint")
    assert disc.shape.dimensions()["radius"] == joint.numbers["radius"]
    assert any(it.body < 0 for it in scene(result).solids)


@pytest.mark.parametrize("name", ["double_wishbone", "planetary_gear", "strandbeest_leg", "stewart_platform"])
def test_mechanisms_are_drawn_whatever_they_are_made_of(name: str) -> None:
    """Every body is seen, and nothing is not finite."""
    mechanism = lw.mechanisms.MECHANISMS[name]
    result = lw.simulate(mechanism.function(), t_end=0.01, step=1e-3)
    drawn = scene(result)
    assert {it.body for it in drawn.solids} >= set(range(result.header.body_count))
    for it in drawn.solids:
        assert np.isfinite(it.shape.position).all()
        assert np.isfinite(it.shape.orientation).all()


def test_curve_of_a_joint_is_drawn_through_its_points_also_from_a_file(tmp_path: Path) -> None:
    angle = np.linspace(0, 2 * np.pi, 13)[:-1]
    points = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    model = lw.Model(gravity=(0, 0, 0))
    bead = model.body("bead", mass=1, inertia=(0.01, 0.01, 0.01), position=points[2])
    model.point_on_curve("ground", bead, points=points, at=points[2], closed=True)
    lw.simulate(model, t_end=0.1, step=0.01).save(tmp_path / "run.h5")
    drawn = scene(lw.Result.load(tmp_path / "run.h5")).solids
    rods = [it.shape for it in drawn if isinstance(it.shape, Rod)]
    assert len(rods) == 96
    ends = np.array([rod.start for rod in rods])
    np.testing.assert_allclose(ends[::8], points, atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(ends, axis=1), 1, atol=2e-3)  # of the spline
    np.testing.assert_array_equal(ends[1:], [rod.end for rod in rods[:-1]])
