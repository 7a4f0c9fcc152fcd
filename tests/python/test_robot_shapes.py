"""Robots look as in their files; limits are stops and impossible inertias taken as they are, on request."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import linkwork as lw
import mujoco
import numpy as np
import pytest
from linkwork.importers import mesh_files
from linkwork.importers.mesh_files import simplified
from linkwork.importers.visuals import ellipsoid
from linkwork.modeling.shapes import Shape
from robot_files import accelerations, turned

#: Of a tetrahedron with edges of one along the axes, volume 1/6.
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])

INERTIA = '<inertia ixx="1" iyy="1" izz="1"/>'


def write_stl(path: Path, vertices: np.ndarray = CORNERS, triangles: np.ndarray = FACES) -> Path:
    import trimesh

    path.parent.mkdir(parents=True, exist_ok=True)
    trimesh.Trimesh(vertices, triangles, process=False).export(path)
    return path


def urdf(folder: Path, visuals: str, more: str = "") -> Path:
    """An arm that hinges about y at (0, 0, 1); its center of mass is at (0.5, 0, 0)."""
    path = folder / "robot.urdf"
    path.write_text(
        f"""<robot name="r">{more}<link name="base"/><link name="arm"><inertial><origin xyz="0.5 0 0"/>
        <mass value="2"/>{INERTIA}</inertial>{visuals}</link><joint name="hinge" type="revolute">
        <parent link="base"/><child link="arm"/><origin xyz="0 0 1"/><axis xyz="0 1 0"/>
        <limit lower="-1" upper="0.5" effort="7"/></joint></robot>"""
    )
    return path


def shapes_in_space(model: lw.Model) -> list[tuple[str, Shape, np.ndarray, np.ndarray]]:
    """Of each body: its name, a shape, where the center of the shape is, and its axes."""
    found = []
    core = model.compiled()
    for body, shapes in sorted(model.shapes.by_body().items()):
        pose = core.poses(np.array([body], np.int32))[0]
        A = lw.rotation.matrix(pose[3:])
        for shape in shapes:
            axes = A @ lw.rotation.matrix(shape.orientation)
            found.append((model.find(name_of(core, body)).name, shape, pose[:3] + A @ shape.position, axes))
    return found


def name_of(core: Any, body: int) -> str:
    return core.body_name(body) if body >= 0 else "ground"


def volume(shape: lw.Mesh) -> float:
    a, b, c = (shape.vertices[shape.triangles[:, k]] for k in range(3))
    return float(np.einsum("ki,ki->", a, np.cross(b, c)) / 6)


def visual(geometry: str, origin: str = "", color: str = "") -> str:
    return f"<visual>{origin}<geometry>{geometry}</geometry>{color}</visual>"


# --- where shapes are ---------------------------------------------------------------------------------------


def test_a_box_is_where_the_frames_of_joint_link_and_visual_put_it(tmp_path: Path) -> None:
    box = visual('<box size="1 0.2 0.1"/>', '<origin xyz="0.3 0.1 0" rpy="0.1 0.2 0.3"/>')
    (found,) = shapes_in_space(lw.import_urdf(urdf(tmp_path, box), coordinates={"hinge": 0.4}).model)
    name, shape, center, axes = found
    hinge = turned(0, 0.4, 0)
    assert name == "arm" and isinstance(shape, lw.Box)
    assert shape.size == pytest.approx([1, 0.2, 0.1])
    assert center == pytest.approx(np.array([0, 0, 1]) + hinge @ [0.3, 0.1, 0], abs=1e-14)
    assert axes == pytest.approx(hinge @ turned(0.1, 0.2, 0.3), abs=1e-14)


def test_what_is_fixed_to_a_body_or_to_the_ground_is_drawn_on_it(tmp_path: Path) -> None:
    path = urdf(tmp_path, visual('<sphere radius="0.1"/>'))
    tool = """<link name="tool"><visual><geometry><sphere radius="0.2"/></geometry></visual></link>
    <joint name="flange" type="fixed"><parent link="arm"/><child link="tool"/><origin xyz="1 0 0"/></joint>"""
    text = path.read_text().replace("</robot>", f"{tool}</robot>")
    foot = (
        '<link name="base"><visual><geometry><cylinder radius="0.3" length="1"/></geometry></visual></link>'
    )
    path.write_text(text.replace('<link name="base"/>', foot))
    found = {type(shape).__name__ + name: center for name, shape, center, _ in
             shapes_in_space(lw.import_urdf(path).model)}  # fmt: skip
    assert found["Cylinderground"] == pytest.approx([0, 0, 0])
    spheres = [(it[1].radius, *it[2]) for it in shapes_in_space(lw.import_urdf(path).model) if it[0] == "arm"]
    assert np.array(spheres) == pytest.approx(np.array([[0.1, 0, 0, 1], [0.2, 1, 0, 1]]), abs=1e-14)


#: The same arm with the same shapes in three formats.
SOLIDS = ("<box><size>0.1 0.2 0.3</size></box>", "<sphere><radius>0.1</radius></sphere>",
          "<cylinder><radius>0.1</radius><length>0.5</length></cylinder>",
          "<capsule><radius>0.1</radius><length>0.5</length></capsule>",
          "<ellipsoid><radii>0.1 0.2 0.3</radii></ellipsoid>")  # fmt: skip

GEOMS = ('type="box" size="0.05 0.1 0.15"', 'type="sphere" size="0.1"', 'type="cylinder" size="0.1 0.25"',
         'type="capsule" size="0.1 0.25"', 'type="ellipsoid" size="0.1 0.2 0.3"')  # fmt: skip


def sdf_arm(folder: Path) -> Path:
    links = "".join(
        f"<visual name='v{k}'><pose>{k} 0 0 0.1 0.2 0.3</pose><geometry>{solid}</geometry>"
        "<material><diffuse>1 0 0 1</diffuse></material></visual>" for k, solid in enumerate(SOLIDS)
    )  # fmt: skip
    path = folder / "arm.sdf"
    path.write_text(
        f"""<sdf version="1.9"><model name="r"><link name="arm"><pose>0 0 1 0 0.4 0</pose><inertial>
        <pose>0.5 0 0 0 0 0</pose><mass>2</mass></inertial>{links}</link><joint name="hinge" type="revolute">
        <parent>world</parent><child>arm</child><axis><xyz>0 1 0</xyz></axis></joint></model></sdf>"""
    )
    return path


def mjcf_arm(folder: Path, more: str = "") -> Path:
    p = " ".join(map(str, lw.rotation.from_matrix(turned(0.1, 0.2, 0.3))))
    geoms = "".join(f'<geom {geom} pos="{k} 0 0" quat="{p}" rgba="1 0 0 1"/>' for k, geom in enumerate(GEOMS))
    path = folder / "arm.xml"
    path.write_text(
        f"""<mujoco><compiler angle="radian"/>{more}<worldbody><body name="arm" pos="0 0 1" euler="0 0.4 0">
        <joint name="hinge" axis="0 1 0"/><inertial pos="0.5 0 0" mass="2" diaginertia="1 1 1"/>{geoms}
        </body></worldbody></mujoco>"""
    )
    return path


def test_sdf_and_mjcf_give_the_same_shapes_in_the_same_places(tmp_path: Path) -> None:
    ours, theirs = (
        shapes_in_space(read(path(tmp_path)).model)
        for read, path in ((lw.import_sdf, sdf_arm), (lw.import_mjcf, mjcf_arm))
    )
    assert len(ours) == len(theirs) == 7  # a capsule is a cylinder with two balls
    for (_, one, r, A), (_, other, s, B) in zip(ours, theirs, strict=True):
        assert one.color == other.color == "#ff0000"
        assert r == pytest.approx(s, abs=1e-12)
        assert pytest.approx(B, abs=1e-12) == A
        for name, value in one.dimensions().items():
            assert np.asarray(value) == pytest.approx(np.asarray(other.dimensions()[name])), name


def test_geoms_are_where_mujoco_has_them(tmp_path: Path) -> None:
    path = mjcf_arm(tmp_path)
    theirs = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(theirs)
    data.qpos[:] = 0.7
    mujoco.mj_forward(theirs, data)
    found = shapes_in_space(lw.import_mjcf(path, coordinates={"hinge": 0.7}).model)
    centers = np.array([center for _, _, center, _ in found])[[0, 1, 2, 3, 6]]
    assert centers == pytest.approx(data.geom_xpos, abs=1e-12)
    assert found[0][3].ravel() == pytest.approx(data.geom_xmat[0], abs=1e-12)


def test_a_mesh_of_mjcf_is_the_solid_of_its_file_where_mujoco_has_it(tmp_path: Path) -> None:
    """MuJoCo moves the vertices of a mesh to its center of mass and principal axes."""
    write_stl(tmp_path / "part.stl")
    path = mjcf_arm(tmp_path, '<asset><mesh name="m" file="part.stl" scale="0.1 0.2 -0.3"/></asset>')
    path.write_text(path.read_text().replace("</body>", '<geom type="mesh" mesh="m" pos="0 1 0"/></body>'))
    _, shape, center, axes = shapes_in_space(lw.import_mjcf(path).model)[-1]
    assert isinstance(shape, lw.Mesh)
    assert volume(shape) == pytest.approx(0.1 * 0.2 * 0.3 / 6, rel=1e-6)
    A = turned(0, 0.4, 0)
    expected = np.array([0, 0, 1]) + (CORNERS * [0.1, 0.2, -0.3] + [0, 1, 0]) @ A.T
    vertices = center + shape.vertices @ axes.T
    assert np.sort(vertices, axis=0) == pytest.approx(np.sort(expected, axis=0), abs=1e-6)


def test_what_mujoco_hides_is_not_drawn_and_said(tmp_path: Path) -> None:
    path = mjcf_arm(tmp_path)
    hidden = (
        '<geom size="1" group="3"/><geom size="1" rgba="1 1 1 0"/></body><geom type="plane" size="9 9 1"/>'
    )
    path.write_text(path.read_text().replace("</body>", hidden))
    imported = lw.import_mjcf(path)
    assert len(shapes_in_space(imported.model)) == 7
    said = sorted(note.message for note in imported.notes if note.topic == "visual")
    assert [text.split()[0] for text in said] == ["1"] * 3
    assert "groups" in said[0] and "planes" in said[1] and "transparent" in said[2]


def test_shapes_are_left_out_on_request(tmp_path: Path) -> None:
    for read, path in ((lw.import_sdf, sdf_arm), (lw.import_mjcf, mjcf_arm)):
        imported = read(path(tmp_path), shapes=False)
        assert not len(imported.model.shapes)
        assert ["left out" in note.message for note in imported.notes if note.topic == "visual"] == [True]


# --- colors -------------------------------------------------------------------------------------------------


def test_colors_are_those_of_the_visual_or_of_the_material_of_that_name(tmp_path: Path) -> None:
    sphere = '<sphere radius="1"/>'
    visuals = (
        visual(sphere, color='<material name="own"><color rgba="0 1 0.2 1"/></material>')
        + visual(sphere, color='<material name="steel"/>')
        + visual(sphere)
    )
    steel = '<material name="steel"><color rgba="0.4 0.4 0.6 1"/></material>'
    found = shapes_in_space(lw.import_urdf(urdf(tmp_path, visuals, steel)).model)
    assert [shape.color for _, shape, _, _ in found] == ["#00ff33", "#666699", "#b9bec6"]


# --- meshes -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("scale", [(1, 1, 1), (2, 3, 0.5), (-1, 1, 1), (-1, 2, -1)])
def test_a_scaled_or_mirrored_mesh_has_the_volume_of_its_solid(
    scale: tuple[float, ...], tmp_path: Path
) -> None:
    """Positive: its triangles are counterclockwise from outside."""
    write_stl(tmp_path / "part.stl")
    words = " ".join(map(str, scale))
    path = urdf(tmp_path, visual(f'<mesh filename="part.stl" scale="{words}"/>'))
    (found,) = shapes_in_space(lw.import_urdf(path).model)
    assert isinstance(found[1], lw.Mesh)
    assert volume(found[1]) == pytest.approx(abs(np.prod(scale)) / 6)


PLACES = [
    ("pkg/meshes/part.stl", "pkg/urdf", "package://pkg/meshes/part.stl", None),
    ("checkout/meshes/part.stl", "checkout/urdf", "package://pkg/meshes/part.stl", None),
    ("elsewhere/pkg/meshes/part.stl", "urdf", "package://pkg/meshes/part.stl", "elsewhere"),
    ("elsewhere/pkg/meshes/part.stl", "urdf", "package://pkg/meshes/part.stl", "elsewhere/pkg"),
    ("meshes/a part.stl", "urdf", "../meshes/a%20part.stl", None),
    ("meshes/part.stl", "urdf", "part.stl", "meshes"),
]


@pytest.mark.parametrize(("file", "folder", "uri", "search"), PLACES)
def test_meshes_are_found_in_packages_and_beside_the_file(
    file: str, folder: str, uri: str, search: str | None, tmp_path: Path
) -> None:
    write_stl(tmp_path / file)
    (tmp_path / folder).mkdir(exist_ok=True)
    path = urdf(tmp_path / folder, visual(f'<mesh filename="{uri}"/>'))
    search_path = [tmp_path / search] if search else []
    assert len(shapes_in_space(lw.import_urdf(path, search_path=search_path).model)) == 1


def test_packages_of_ros_are_looked_for_in_its_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_stl(tmp_path / "ws/pkg/part.stl")
    monkeypatch.setenv("ROS_PACKAGE_PATH", f"/nowhere:{tmp_path / 'ws'}")
    (tmp_path / "urdf").mkdir()
    path = urdf(tmp_path / "urdf", visual('<mesh filename="package://pkg/part.stl"/>'))
    assert len(shapes_in_space(lw.import_urdf(path).model)) == 1


BAD = [
    ('<mesh filename="no.stl"/>', "'no.stl' is not found: give its folder in search_path"),
    ('<mesh filename="https://a.b/c.stl"/>', "nothing is downloaded"),
    ('<mesh filename="part.step"/>', "'part.step' is none of .stl"),
    ('<mesh filename="bad.stl"/>', "bad.stl' has no triangles"),
    ('<mesh filename="bad.obj"/>', "bad.obj' cannot be read"),
    ('<mesh filename="part.stl" scale="1 0 1"/>', "scale 1.0 0.0 1.0 is zero"),
    ('<box size="1 -1 1"/>', "size -1.0 is not a positive number"),
    ('<sphere radius="wide"/>', "sphere radius 'wide' is not 1 finite numbers"),
    ('<sphere radius="1_0"/>', "sphere radius '1_0' is not 1 finite numbers"),
    ("<cone/>", "there is no box"),
]


@pytest.mark.parametrize(("geometry", "message"), BAD)
def test_what_cannot_be_drawn_is_noted_and_the_robot_moves_all_the_same(
    geometry: str, message: str, tmp_path: Path
) -> None:
    write_stl(tmp_path / "part.stl")
    (tmp_path / "bad.stl").write_text("solid but not really")
    (tmp_path / "bad.obj").write_text("v 0 0 0\nf 1 2 3\n")
    imported = lw.import_urdf(urdf(tmp_path, visual(geometry)))
    assert imported.model.body_count == 1 and not len(imported.model.shapes)
    (said,) = (note.message for note in imported.notes if note.topic == "visual")
    assert message in said


def test_without_trimesh_one_note_names_the_extra(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "trimesh", None)
    write = '<mesh filename="part.stl"/>'
    (tmp_path / "part.stl").write_text("solid\nendsolid")
    imported = lw.import_urdf(urdf(tmp_path, visual(write) * 3 + visual('<sphere radius="1"/>')))
    (said,) = (note.message for note in imported.notes if note.topic == "visual")
    assert "pip install 'linkwork[mesh]'" in said and "(3 times)" in said
    assert len(shapes_in_space(imported.model)) == 1


def ball(rows: int) -> tuple[np.ndarray, np.ndarray]:
    """Of radius one, of 4 rows^2 triangles about."""
    import trimesh

    found = trimesh.creation.uv_sphere(radius=1.0, count=[rows, 2 * rows])
    return np.asarray(found.vertices), np.asarray(found.faces)


def test_fewer_triangles_are_the_same_solid() -> None:
    vertices, triangles = ball(160)
    assert len(triangles) > 90_000
    fewer = lw.Mesh(*simplified(vertices, triangles, mesh_files.MOST))
    assert mesh_files.MOST / 2 < len(fewer.triangles) <= mesh_files.MOST
    assert volume(fewer) == pytest.approx(4 / 3 * np.pi, rel=0.01)
    assert np.linalg.norm(fewer.vertices, axis=1) == pytest.approx(1, abs=0.02)


def test_large_meshes_are_drawn_by_fewer_triangles_which_is_noted(tmp_path: Path) -> None:
    write_stl(tmp_path / "part.stl", *ball(80))
    imported = lw.import_urdf(urdf(tmp_path, visual('<mesh filename="part.stl"/>')))
    (found,) = shapes_in_space(imported.model)
    assert isinstance(found[1], lw.Mesh) and len(found[1].triangles) <= mesh_files.MOST
    (said,) = (note.message for note in imported.notes if note.topic == "visual")
    assert said == f"1 meshes of more than {mesh_files.MOST} triangles are drawn by fewer"


def test_an_ellipsoid_has_the_volume_of_one() -> None:
    (found,) = ellipsoid((1.0, 2.0, 3.0), None)
    assert isinstance(found, lw.Mesh)
    assert volume(found) == pytest.approx(4 / 3 * np.pi * 6, rel=0.04)
    edges = np.sort(
        np.vstack([found.triangles[:, [0, 1]], found.triangles[:, [1, 2]], found.triangles[:, [2, 0]]])
    )
    assert (np.unique(edges, axis=0, return_counts=True)[1] == 2).all()  # closed


@pytest.mark.parametrize("suffix", [".yaml", ".json"])
def test_meshes_come_back_exactly_from_model_files(suffix: str, tmp_path: Path) -> None:
    model = lw.Model()
    rng = np.random.default_rng(3)
    for name, dtype in (("single", np.float32), ("double", np.float64)):
        vertices = rng.normal(size=(500, 3)).astype(dtype)
        mesh = lw.Mesh(vertices, rng.integers(0, 500, (900, 3)), color="#123456", position=(1, 2, 3))
        model.body(name, mass=1, inertia=(1, 1, 1), shape=[mesh, lw.Mesh(CORNERS, FACES)])
    model.save(tmp_path / f"model{suffix}")
    text = (tmp_path / f"model{suffix}").read_text()
    assert text.count("f4:") == text.count("f8:") == 1 and text.count("i4:") == 2  # small ones as numbers
    loaded = lw.Model.load(tmp_path / f"model{suffix}").shapes.by_body()
    for body, shapes in model.shapes.by_body().items():
        for one, other in zip(shapes, loaded[body], strict=True):
            for name, value in one.description().items():
                assert np.array_equal(value, other.description()[name]), name


@pytest.mark.parametrize(
    ("text", "message"),
    [("f4:????", "no packed array"), ("f4:eJwDAAAAAAE=x", "no packed array"), ("q4:", "")],
)
def test_damaged_arrays_of_meshes_are_refused_with_the_line(text: str, message: str, tmp_path: Path) -> None:
    path = tmp_path / "model.yaml"
    mesh = f'{{kind: mesh, vertices: "{text}", triangles: [[0, 1, 2]]}}'
    body = "bodies:\n- {name: a, mass: 1, inertia: [1, 1, 1]}\n"
    path.write_text(f"linkwork: 1\ngravity: [0, 0, 0]\n{body}shapes:\n- {{bodies: [a], shapes: [{mesh}]}}\n")
    with pytest.raises(lw.ModelFileError, match=f":6:.*{message}"):
        lw.Model.load(path)


# --- stops --------------------------------------------------------------------------------------------------


def angle_over_time(model: lw.Model, joint: str, t_end: float = 3.0) -> tuple[np.ndarray, lw.Result]:
    result = lw.simulate(model, t_end=t_end, integrator="dopri5", rtol=1e-7)
    return result.coordinate(joint).value, result


def test_limits_are_noted_unless_stops_are_asked_for(tmp_path: Path) -> None:
    path = urdf(tmp_path, "")
    limits = [note.message for note in lw.import_urdf(path).notes if note.topic == "limits"]
    assert limits == ["limits -1 to 0.5 rad, effort 7 are not represented"]
    angle, _ = angle_over_time(lw.import_urdf(path).model, "hinge")
    assert angle.max() > 2  # it falls through


@pytest.mark.parametrize("ends", [(-1.0, 0.5), (-3.0, 0.2)])
def test_an_arm_falls_on_its_stop_and_rests_there(ends: tuple[float, float], tmp_path: Path) -> None:
    """At rest the torque of the stop is that of the weight: k d = m g s cos(upper + d)."""
    path = urdf(tmp_path, "")
    path.write_text(
        path.read_text().replace('lower="-1" upper="0.5"', f'lower="{ends[0]:g}" upper="{ends[1]:g}"')
    )
    imported = lw.import_urdf(path, limits="stops")
    said = [note.message for note in imported.notes if note.topic == "limits"]
    k = 1e4 * (1 + 2 * 0.5**2)  # of the inertia about the hinge
    assert "limits effort 7 are not represented" in said
    assert f"limits {ends[0]:g} to {ends[1]:g} rad are stops of {k:.3g} N m/rad" in said
    angle, result = angle_over_time(imported.model, "hinge", 6.0)
    rate = np.sqrt(2 * 2 * 9.81 * 0.5 * np.sin(ends[1]) / (k / 1e4))  # on arrival
    assert angle.max() < ends[1] + 1.2 * rate / 100
    depth = 2 * 9.81 * 0.5 * np.cos(ends[1]) / k
    assert angle[-1] == pytest.approx(ends[1] + depth, abs=1e-3)
    assert (np.diff(result.energy) < 1e-5).all()


def test_sliders_stop_and_mjcf_counts_from_its_reference(tmp_path: Path) -> None:
    path = tmp_path / "slide.xml"
    path.write_text(
        """<mujoco><compiler angle="radian"/><worldbody><body name="a"><joint name="s" type="slide"
        axis="0 0 1" ref="0.3" range="0.1 0.5" limited="true"/><inertial pos="0 0 0" mass="2" diaginertia="1 1
        1"/></body> </worldbody></mujoco>"""
    )
    height, _ = angle_over_time(lw.import_mjcf(path, limits="stops").model, "s")
    assert height[-1] == pytest.approx(0.1 - 9.81 / 1e4, abs=2e-3)
    assert height.min() > -0.2 - 1.2 * np.sqrt(2 * 9.81 * 0.2) / 100


def test_stops_are_at_the_turn_where_the_joint_is(tmp_path: Path) -> None:
    """A joint with a range of three turns that starts in its second."""
    path = urdf(tmp_path, "")
    path.write_text(path.read_text().replace('lower="-1" upper="0.5"', 'lower="-9" upper="9"'))
    model = lw.import_urdf(path, limits="stops", coordinates={"hinge": 8.7}, gravity=(0, 0, 0),
                           velocities={"hinge": 1.0}).model  # fmt: skip
    angle, _ = angle_over_time(model, "hinge", 1.0)
    turned_by = angle - angle[0]
    assert 0.3 < turned_by.max() < 0.3 + 0.012
    assert turned_by[-1] < 0.3  # it came back


def test_what_starts_beyond_its_stop_is_said(tmp_path: Path) -> None:
    imported = lw.import_urdf(urdf(tmp_path, ""), limits="stops", coordinates={"hinge": 0.75})
    assert any("it starts 0.25 beyond" in note.message for note in imported.notes)


def test_sdf_has_stops_too(tmp_path: Path) -> None:
    path = sdf_arm(tmp_path)
    text = path.read_text().replace("</xyz>", "</xyz><limit><lower>-1</lower><upper>0.5</upper></limit>")
    path.write_text(text)
    angle, _ = angle_over_time(lw.import_sdf(path, limits="stops").model, "hinge")
    assert angle[-1] == pytest.approx(0.5, abs=2e-3)


# --- inertias -----------------------------------------------------------------------------------------------

IMPOSSIBLE = '<inertia ixx="1" iyy="1" izz="3"/>'


def test_an_impossible_inertia_is_taken_as_it_is_on_request(tmp_path: Path) -> None:
    """theta_ddot = m g s / (J_yy + m s^2) about the hinge, with the moment of the file."""
    path = urdf(tmp_path, "")
    path.write_text(path.read_text().replace(INERTIA, '<inertia ixx="1" iyy="3" izz="1"/>'))
    with pytest.raises(lw.ModelFileError, match="repair_inertia.*inertia_as_is"):
        lw.import_urdf(path)
    imported = lw.import_urdf(path, inertia_as_is=True)
    assert accelerations(imported.model)[0, 4] == pytest.approx(2 * 9.81 * 0.5 / (3 + 0.5), rel=1e-12)
    (said,) = (note.message for note in imported.notes if note.topic == "inertia")
    assert said == "principal moments (1, 1, 3) kg m2 are those of no real body: taken as they are"
    imported.model.save(tmp_path / "arm.yaml")
    loaded = lw.Model.load(tmp_path / "arm.yaml")
    assert loaded.hash() == imported.model.hash()
    assert accelerations(lw.Model.load(tmp_path / "arm.yaml").replaced("arm", mass=1.0))[
        0, 4
    ] == pytest.approx(9.81 * 0.5 / (3 + 0.25), rel=1e-12)


def test_repaired_and_as_it_is_contradict_each_other(tmp_path: Path) -> None:
    with pytest.raises(lw.OptionError, match="give one of them"):
        lw.import_urdf(urdf(tmp_path, ""), repair_inertia=True, inertia_as_is=True)


def test_a_model_takes_an_impossible_inertia_only_where_that_is_said() -> None:
    model = lw.Model()
    with pytest.raises(lw.ModelError, match="triangle inequality"):
        model.body("a", mass=1, inertia=(1, 1, 3))
    model.body("a", mass=1, inertia=(1, 1, 3), inertia_as_is=True)
    with pytest.raises(lw.ModelError, match="is negative"):
        model.body("b", mass=1, inertia=(1, 1, -1), inertia_as_is=True)
