"""Each element and attribute of a format is represented, noted or refused: the lists against the formats."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import linkwork as lw
import mujoco
import pytest
from format_descriptions import Elements, expanded, keys, mujoco_schema, read
from linkwork.importers.coverage import Coverage
from linkwork.importers.mjcf_coverage import MJCF
from linkwork.importers.sdf_coverage import SDF
from linkwork.importers.urdf_coverage import URDF

FORMATS: dict[str, tuple[Coverage, Callable[[], Elements]]] = {
    "mjcf": (MJCF, lambda: mujoco_schema(mujoco.mj_printSchema(False, False))),
    "sdf": (SDF, lambda: expanded(read("sdf_elements.txt"), "root.sdf")),
    "urdf": (URDF, lambda: expanded(read("urdf_elements.txt"), "urdf")),
}

#: What the lists have beyond the descriptions: MuJoCo does not print what it resolves before its schema
#: applies; SDF from 1.10 on; a mimic's reference as in SDF, what ROS has beyond URDF.
BEYOND = {
    "mjcf": {"body/replicate"},
    "sdf": {"joint/screw_thread_pitch", "joint/axis/mimic", "link/inertial/density", "link/inertial@auto",
            "link/inertial/auto_inertia_params/**", "link/inertial/fluid_added_mass/**",
            "joint/axis2/mimic/**", "link/plugin/**", "plugin/**"},
    "urdf": {"joint/mimic@reference", "link/sensor/**", "link/contact/**", "link/collision_checking/**"},
}  # fmt: skip


@pytest.mark.parametrize("name", FORMATS)
def test_each_element_and_attribute_stands_in_exactly_one_list(name: str) -> None:
    coverage, elements = FORMATS[name]
    assert coverage.twice == []
    assert sorted({key for key in keys(coverage, elements()) if coverage[key] is None}) == []


@pytest.mark.parametrize("name", FORMATS)
def test_the_lists_have_nothing_that_the_format_does_not_have(name: str) -> None:
    coverage, elements = FORMATS[name]
    there = set(keys(coverage, elements()))
    there |= {f"{key}/**" for key in there}
    beyond = tuple(BEYOND[name])
    assert [key for key in coverage.entries if key not in there and not key.startswith(beyond)] == []


@pytest.mark.parametrize("name", FORMATS)
def test_a_new_element_or_attribute_would_be_found(name: str) -> None:
    """The descriptions of the formats and their lists are compared for what they say, not for being there."""
    coverage, elements = FORMATS[name]
    there = dict(elements())
    root = next(path for path in there if len(path) == 1)
    there[(*root, "ladder")] = {"rungs"}
    there[root] = there[root] | {"mood"}
    assert {key for key in keys(coverage, there) if coverage[key] is None} == {
        "ladder",
        "ladder@rungs",
        "@mood",
    }


# --- what is met in files -----------------------------------------------------------------------------------

INERTIAL = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'

#: With everything that is noted by name, or by its topic.
MJCF_FILE = f"""<mujoco>
<compiler autolimits="false" angle="radian"><lengthrange mode="none"/></compiler>
<option timestep="0.01" density="1.2" magnetic="1 0 0"><flag multiccd="enable" sleep="enable"/></option>
<size nuser_body="1"/> <visual><map force="0.2"/></visual> <statistic extent="2"/>
<custom><numeric name="n" data="1 2"/></custom>
<asset><texture name="t" type="2d" builtin="flat" width="8" height="8"/></asset>
<worldbody>
 <body name="a" user="3" sleep="init"><joint name="j" range="-1 1" limited="true" frictionloss="0.2"
   margin="0.1" stiffness="3" springyield="0.4"/>{INERTIAL}<geom name="g" size="0.1"
   castshadow="false"/></body>
 <body name="b" mocap="true" pos="3 0 0"><geom size="0.1"/></body>
 <site name="s" size="0.1"/>
</worldbody>
<contact><pair geom1="g" geom2="g2"/></contact>
<equality><joint joint1="j" polycoef="0 0 1 0 0" solref="0.01 1"/></equality>
<actuator><motor joint="j" name="m" ctrlrange="-1 1" ctrllimited="true"/></actuator>
<sensor><jointpos joint="j"/></sensor>
<keyframe><key name="k" qpos="0.5"/></keyframe>
</mujoco>""".replace('<geom size="0.1"/></body>', '<geom name="g2" size="0.1"/></body>')

TORQUED = "<dynamics><damping>1</damping></dynamics><limit><effort>3</effort></limit>"

SDF_FILE = f"""<sdf version="1.9"><world name="w"><physics name="p" type="ode"/><gravity>0 0 -1</gravity>
<wind/><model name="m"><plugin name="p" filename="f"/>
<link name="a"><kinematic>true</kinematic><velocity_decay/>
<visual name="v"><cast_shadows>0</cast_shadows><geometry><heightmap/></geometry></visual><collision name="c"/>
<inertial><mass>2</mass><mass>3</mass><fluid_added_mass/></inertial><sensor name="s" type="imu"/></link>
<link name="b"/>
<joint name="j" type="universal"><parent>a</parent><child>b</child><physics/>
<sensor name="t" type="force_torque"/><axis><xyz>1 0 0</xyz>{TORQUED}</axis>
<axis2><xyz>0 1 0</xyz>{TORQUED}</axis2></joint>
<joint name="k" type="revolute"><parent>world</parent><child>a</child><axis><xyz>1 0 0</xyz>
<initial_position>1</initial_position>{TORQUED}</axis><axis2><xyz>0 1 0</xyz>{TORQUED}</axis2></joint>
</model></world><light name="l" type="point"/></sdf>"""

URDF_FILE = """<robot name="r" version="1.0"><material name="red"><texture filename="t.png"/></material>
<gazebo reference="a"/>
<transmission name="t"/><link name="a"><visual/><collision/><contact/></link>
<link name="b"><inertial><mass value="1"/><inertia ixx="1"
iyy="1" izz="1"/></inertial><inertial><mass value="5"/></inertial></link>
<joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
<limit effort="3" velocity="2"/><calibration rising="0"/><safety_controller k_velocity="1"/>
</joint></robot>"""

FILES = {"model.xml": (lw.import_mjcf, MJCF_FILE, MJCF), "model.sdf": (lw.import_sdf, SDF_FILE, SDF),
         "model.urdf": (lw.import_urdf, URDF_FILE, URDF)}  # fmt: skip


@pytest.mark.parametrize("name", FILES)
def test_every_topic_of_the_lists_is_noted(name: str, tmp_path: Path) -> None:
    """Those that the importers themselves must note by name, too."""
    read_file, text, coverage = FILES[name]
    path = tmp_path / name
    path.write_text(text)
    topics = {entry.topic for entry in coverage.entries.values() if entry.kind == "noted"}
    found = {note.topic for note in read_file(path).notes}
    assert topics - found == set()


def test_what_is_noted_is_named(tmp_path: Path) -> None:
    path = tmp_path / "model.xml"
    path.write_text(MJCF_FILE)
    said = "\n".join(map(str, lw.import_mjcf(path).notes))
    for words in ("<option> timestep", "<flag> multiccd", "<body> user", "<body> mocap",
                  "<joint> springyield",
                  "<geom> castshadow", "<keyframe>",
                  "<sensor>", "<custom>", "<option> magnetic", "<lengthrange>",
                  "body 'a': and what it carries start asleep", "actuator 'm'", "limits -1 to 1",
                  "contact of 1 pairs"):  # fmt: skip
        assert words in said, words
    path = tmp_path / "model.sdf"
    path.write_text(SDF_FILE)
    said = "\n".join(map(str, lw.import_sdf(path).notes))
    for words in ("<mass>: in line 5 is there again", "<kinematic>", "<velocity_decay>", "<wind>", "<light>",
                  "<initial_position>", "the dynamics of its axis2", "limits effort 3"):  # fmt: skip
        assert words in said, words


UNKNOWN = [
    ("model.urdf", '<link name="a">', '<link name="a" colour="red"><wheel/><wheel/>',
     {"<link> colour", "<wheel>"}),
    ("model.sdf", '<link name="a">', '<link name="a" colour="red"><wheel/>', {"<link> colour", "<wheel>"}),
]  # fmt: skip


@pytest.mark.parametrize(("name", "part", "by", "labels"), UNKNOWN)
def test_what_no_list_has_is_noted_by_name(
    name: str, part: str, by: str, labels: set[str], tmp_path: Path
) -> None:
    """MuJoCo itself refuses what it does not know."""
    read_file, text, _ = FILES[name]
    path = tmp_path / name
    path.write_text(text.replace(part, by, 1))
    notes = [note for note in read_file(path).notes if "not known here" in note.message]
    assert {note.subject for note in notes} == labels


TEXTS = [
    ("model.urdf", '<link name="a">', '<link name="a"> 1 <visual> 2 </visual>', {"<link>", "<visual>"}),
    ("model.urdf", "<robot", "<!-- no text --><robot", set()),
    ("model.sdf", '<link name="a">', '<link name="a"> 1 <visual name="v">2</visual>', {"<link>", "<visual>"}),
    ("model.xml", "<worldbody>", "<worldbody> 1 <site>2</site>", {"<worldbody>", "<site>"}),
]


@pytest.mark.parametrize(("name", "part", "by", "labels"), TEXTS)
def test_text_where_a_format_has_none_is_noted(
    name: str, part: str, by: str, labels: set[str], tmp_path: Path
) -> None:
    read_file, text, _ = FILES[name]
    path = tmp_path / name
    path.write_text(text.replace(part, by, 1))
    notes = [note for note in read_file(path).notes if "has text, which is not taken" in note.message]
    assert {note.subject for note in notes} == labels


def test_what_included_and_attached_files_have_is_noted(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts/more.xml").write_text('<mujoco><include file="light.xml"/></mujoco>')
    (tmp_path / "parts/light.xml").write_text('<mujoco><worldbody><light pos="0 0 1"/></worldbody></mujoco>')
    arm = f'<mujoco><worldbody><body name="arm"><camera name="eye"/>{INERTIAL}</body></worldbody></mujoco>'
    (tmp_path / "arm.xml").write_text(arm)
    path = tmp_path / "model.xml"
    attach = '<attach model="arm" body="arm" prefix="x"/>'
    path.write_text('<mujoco><include file="parts/more.xml"/>\n<asset><model name="arm" file="arm.xml"/>'
                    f'</asset><worldbody><body name="a"><joint/>{INERTIAL}{attach}</body>'
                    "</worldbody></mujoco>")  # fmt: skip
    notes = {note.topic: note.message for note in lw.import_mjcf(path).notes}
    assert notes["appearance"].startswith("<light>, <camera>:")


REFUSED = [
    (
        "<mass>2</mass>",
        "<mass>2</mass><pose relative_to='b'>1 0 0 0 0 0</pose>",
        "it is in the frame of the link",
    ),
    ("<inertial>", "<inertial auto='true'>", "auto inertia is not taken"),
    ("<wind/>", "<population name='p'/>", "population.*write its models out"),
]


@pytest.mark.parametrize(("part", "by", "message"), REFUSED)
def test_what_would_be_another_model_is_refused(part: str, by: str, message: str, tmp_path: Path) -> None:
    path = tmp_path / "model.sdf"
    assert part in SDF_FILE
    path.write_text(SDF_FILE.replace(part, by, 1))
    with pytest.raises(lw.ModelFileError, match=message):
        lw.import_sdf(path)


def test_forces_of_plugins_and_deformable_bodies_are_refused() -> None:
    for key in ("body/plugin", "tendon/spatial", "body/flexcomp/edge@damping", "deformable/flex"):
        entry = MJCF[key]
        assert entry is not None and entry.kind == "refused"
