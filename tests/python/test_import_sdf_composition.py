"""SDF models in models: frames and names across their borders, and files that include each other."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.cli import run
from robot_files import accelerations, topics, turned

INERTIAL = (
    "<inertial><pose>0.1 0.2 0 0 0 0</pose><mass>2</mass>"
    "<inertia><ixx>0.2</ixx><iyy>0.3</iyy><izz>0.25</izz></inertia></inertial>"
)

#: A link with a frame at its end, away from the origin of its model.
ARM = (
    '<model name="arm"><pose>0 0 7 0 0 0</pose>'
    f'<link name="rod"><pose>0.5 0.1 0 0 0.2 0.3</pose>{INERTIAL}</link>'
    '<frame name="tip" attached_to="rod"><pose>0.4 0.3 0.2 0.1 0.2 0.3</pose></frame></model>'
)


def sdf(content: str, version: str = "1.9") -> str:
    return f'<?xml version="1.0"?>\n<sdf version="{version}">\n{content}\n</sdf>\n'


def loaded(tmp_path: Path, content: str, **options: Any) -> lw.Imported:
    path = tmp_path / "robot.sdf"
    path.write_text(sdf(content))
    return lw.import_sdf(path, **options)


def frame(xyz: Any, rpy: Any = (0, 0, 0)) -> np.ndarray:
    """Homogeneous (4, 4)."""
    out = np.eye(4)
    out[:3, :3], out[:3, 3] = turned(*rpy), xyz
    return out


ROD, TIP = frame((0.5, 0.1, 0), (0, 0.2, 0.3)), frame((0.4, 0.3, 0.2), (0.1, 0.2, 0.3))
CENTER = np.array([0.1, 0.2, 0, 1])


def pose(model: lw.Model, name: str) -> np.ndarray:
    """Of a link (4, 4): its center less the one in the link."""
    q = model.compiled().q0.reshape(-1, 7)[model.find(name).index]
    out = np.eye(4)
    out[:3, :3] = lw.rotation.matrix(q[3:])
    out[:3, 3] = q[:3] - out[:3, :3] @ CENTER[:3]
    return out


def with_models(*models: str) -> str:
    base = f'<pose>1 2 3 0 0 0.4</pose><link name="base">{INERTIAL}</link>'
    return f'<model name="robot">{base}{"".join(models)}</model>'


ROBOT = frame((1, 2, 3), (0, 0, 0.4))
PLACE = "<pose {}>0.3 0.4 0.5 0.6 0.7 0.8</pose>"
STEP = frame((0.3, 0.4, 0.5), (0.6, 0.7, 0.8))
MARK = '<frame name="mark" attached_to="base"><pose>0 1 0 0 0 1</pose></frame>'

#: What places the model, and where its link is.
PLACES = [
    ("", PLACE.format(""), ROBOT @ STEP @ ROD),
    ("", PLACE.format('relative_to="mark"'), ROBOT @ frame((0, 1, 0), (0, 0, 1)) @ STEP @ ROD),
    ('placement_frame="tip"', PLACE.format(""), ROBOT @ STEP @ np.linalg.inv(ROD @ TIP) @ ROD),
]


@pytest.mark.parametrize("included", [False, True])
@pytest.mark.parametrize(("attributes", "place", "expected"), PLACES)
def test_a_model_in_a_model_is_where_its_pose_says(
    attributes: str, place: str, expected: np.ndarray, included: bool, tmp_path: Path
) -> None:
    arm = ARM.replace("<pose>0 0 7 0 0 0</pose>", place, 1).replace(
        'name="arm"', f'name="arm" {attributes}', 1
    )
    if included:
        (tmp_path / "arm.sdf").write_text(sdf(ARM))
        frame_name = "<placement_frame>tip</placement_frame>" if attributes else ""
        arm = f"<include><uri>arm.sdf</uri>{place}{frame_name}</include>"
    model = loaded(tmp_path, with_models(MARK, arm)).model
    assert pose(model, "arm::rod") == pytest.approx(expected, abs=1e-14)


def test_a_model_alone_is_placed_by_its_placement_frame(tmp_path: Path) -> None:
    arm = ARM.replace('name="arm"', 'name="arm" placement_frame="tip"', 1)
    model = loaded(tmp_path, arm).model
    assert pose(model, "rod") == pytest.approx(frame((0, 0, 7)) @ np.linalg.inv(TIP), abs=1e-14)
    with pytest.raises(lw.ModelFileError, match=r":3: pose: there is nothing that a model alone"):
        loaded(tmp_path, ARM.replace("<pose>0 0 7", '<pose relative_to="tip">0 0 7', 1))


def test_an_include_without_a_pose_has_that_of_its_file(tmp_path: Path) -> None:
    (tmp_path / "arm.sdf").write_text(sdf(ARM))
    model = loaded(tmp_path, with_models("<include><uri>arm.sdf</uri></include>")).model
    assert pose(model, "arm::rod") == pytest.approx(ROBOT @ frame((0, 0, 7)) @ ROD, abs=1e-14)


def test_a_placement_frame_of_an_include_takes_a_pose(tmp_path: Path) -> None:
    (tmp_path / "arm.sdf").write_text(sdf(ARM))
    inner = "\n<include><uri>arm.sdf</uri><placement_frame>tip</placement_frame>{}</include>"
    loaded(tmp_path, with_models(inner.format("<pose/>")))
    with pytest.raises(lw.ModelFileError, match=r":4: include: 'arm.sdf' has a placement_frame.*give <pose>"):
        loaded(tmp_path, with_models(inner.format("")))


def joined(parent: str, child: str) -> str:
    return (
        f'<joint name="hinge" type="revolute"><pose>0.1 0 0 0 0 0</pose><parent>{parent}</parent>'
        f"<child>{child}</child><axis><xyz>0 1 1</xyz></axis></joint>"
    )


@pytest.mark.parametrize(("child", "at"), [
    ("arm::rod", ROD), ("arm::tip", ROD @ TIP), ("arm", np.eye(4)), ("grip", ROD @ TIP),
])  # fmt: skip
def test_a_joint_across_a_border_is_the_same_by_hand(child: str, at: np.ndarray, tmp_path: Path) -> None:
    """Its child is a link, a frame of it, a model by its canonical link, or a frame attached to one inside;
    its pose is relative to that."""
    grip = '<frame name="grip" attached_to="arm::tip"/>'
    arm = ARM.replace("<pose>0 0 7 0 0 0</pose>", "<pose>0 0 1 0 0 0</pose>", 1)
    found = loaded(tmp_path, with_models(arm, grip, joined("world", child))).model
    inside = ROBOT @ frame((0, 0, 1))
    hinge = inside @ at @ frame((0.1, 0, 0))
    model = lw.Model(gravity=(0, 0, -9.8))
    for name, place in (("base", ROBOT), ("arm::rod", inside @ ROD)):
        model.body(name, mass=2, inertia=(0.2, 0.3, 0.25), position=(place @ CENTER)[:3],
                   orientation=lw.rotation.from_matrix(place[:3, :3]))  # fmt: skip
    model.revolute(model.ground, "arm::rod", at=hinge[:3, 3], axis=hinge[:3, :3] @ [0, 1, 1])
    assert accelerations(found) == pytest.approx(accelerations(model), rel=1e-11, abs=1e-11)


def test_models_two_deep_and_names_that_occur_in_both(tmp_path: Path) -> None:
    inner = f'<model name="m"><pose>0 0 1 0 0 0</pose><link name="base">{INERTIAL}</link>{{}}</model>'
    text = with_models(inner.format(inner.format(joined("world", "base"))), joined("base", "m::m::base"))
    imported = loaded(tmp_path, text)
    core = imported.model.compiled()
    assert [core.body_name(k) for k in range(3)] == ["base", "m::base", "m::m::base"]
    assert [core.joint_name(k) for k in range(2)] == ["hinge", "m::m::hinge"]
    assert pose(imported.model, "m::m::base") == pytest.approx(ROBOT @ frame((0, 0, 2)), abs=1e-14)


def test_a_world_of_several_models_is_one_mechanism(tmp_path: Path) -> None:
    ground = f'<model name="ground"><static>true</static><link name="l">{INERTIAL}</link></model>'
    other = ARM.replace('"arm"', '"other"').replace(">0 0 7", ' relative_to="arm::tip">0 0 7')
    imported = loaded(tmp_path, f'<world name="w"><gravity>0 0 -1</gravity>{ground}{ARM}{other}</world>')
    model = imported.model
    assert model.body_count == 2 and ("base", "link 'ground::l'") in topics(imported)
    there = frame((0, 0, 7)) @ ROD @ TIP @ frame((0, 0, 7)) @ ROD
    assert pose(model, "other::rod") == pytest.approx(there, abs=1e-14)
    assert accelerations(model)[:, 2] == pytest.approx([-1, -1])


def test_the_only_model_of_a_world_needs_no_prefix(tmp_path: Path) -> None:
    (tmp_path / "arm.sdf").write_text(sdf(ARM))
    place = "<include><uri>arm.sdf</uri><pose>1 0 0 0 0 0</pose></include>"
    model = loaded(tmp_path, f'<world name="w">{place}</world>').model
    assert pose(model, "rod") == pytest.approx(frame((1, 0, 0)) @ ROD, abs=1e-14)


# --- where files are ----------------------------------------------------------------------------------------


def folder_of_arm(folder: Path) -> Path:
    """As Gazebo has it: a folder by the model's name, whose model.config names a file for each version."""
    (folder / "arm").mkdir(parents=True)
    (folder / "arm/model.config").write_text(
        "<model><name>arm</name><sdf version='1.5'>old.sdf</sdf><sdf version='1.10'>new.sdf</sdf></model>"
    )
    (folder / "arm/new.sdf").write_text(sdf(ARM))
    (folder / "arm/old.sdf").write_text("not this one")
    return folder


def test_a_version_in_a_config_that_is_none_is_refused(tmp_path: Path) -> None:
    config = folder_of_arm(tmp_path) / "arm/model.config"
    config.write_text(config.read_text().replace("1.10", "latest"))
    with pytest.raises(lw.ModelFileError, match=r":3: include: .*the version 'latest', which is none"):
        loaded(tmp_path, with_models("<include><uri>model://arm</uri></include>"))


@pytest.mark.parametrize("what", ["static", "merge"])
def test_what_an_include_says_is_true_or_false(what: str, tmp_path: Path) -> None:
    folder_of_arm(tmp_path)
    texts = {"static": "<include><static>on</static>", "merge": '<include merge="on">'}
    text = with_models(f"{texts[what]}<uri>model://arm</uri></include>")
    with pytest.raises(lw.ModelFileError, match=rf":3: .*{what}: 'on' is not true, false, 1 or 0"):
        loaded(tmp_path, text)


@pytest.mark.parametrize("uri", ["model://arm", "model://arm/new.sdf", "arm", "arm/new.sdf", "FILE"])
@pytest.mark.parametrize("beside", [True, False])
def test_models_are_found_beside_the_file_or_on_the_search_path(
    uri: str, beside: bool, tmp_path: Path
) -> None:
    folder = folder_of_arm(tmp_path if beside else tmp_path / "else where")
    uri = uri.replace("FILE", (folder / "arm/new.sdf").as_uri())
    text = with_models(f"<include><uri>{uri}</uri></include>")
    robot = folder if beside else tmp_path / "robots"
    robot.mkdir(exist_ok=True)
    if not beside:
        with pytest.raises(lw.ModelFileError, match=r":3: include: .*give its folder in search_path"):
            loaded(robot, text)
    search_path = [] if beside else [folder]
    assert loaded(robot, text, search_path=search_path).model.find("arm::rod")


def test_a_folder_to_be_searched_is_an_option_of_convert(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = folder_of_arm(tmp_path / "models")
    source = tmp_path / "robot.sdf"
    source.write_text(sdf(with_models("<include><uri>model://arm</uri></include>")))
    target = tmp_path / "robot.yaml"
    assert run(["convert", str(source), str(target)], debug=False) == 1
    assert "search_path" in capsys.readouterr().err
    assert run(["convert", str(source), str(target), "--search-path", str(folder)], debug=False) == 0
    assert lw.Model.load(target).find("arm::rod")
    with pytest.raises(lw.OptionError, match="search_path"):  # MuJoCo looks for files itself
        lw.import_mjcf(Path(__file__).parent / "robots/slider_crank.xml", search_path=[folder])  # type: ignore[call-arg]


def test_files_that_include_each_other_in_a_ring_are_refused(tmp_path: Path) -> None:
    for name, other in (("a", "b"), ("b", "c"), ("c", "a")):
        text = f'<model name="{name}"><link name="l"/>\n<include><uri>{other}.sdf</uri></include></model>'
        (tmp_path / f"{name}.sdf").write_text(sdf(text))
    with pytest.raises(
        lw.ModelFileError,
        match=r"c.sdf:4: include: 'a.sdf' includes itself: a.sdf -> b.sdf -> c",
    ):
        lw.import_sdf(tmp_path / "a.sdf")


def test_files_that_include_the_next_twice_are_refused_before_they_fill_the_memory(tmp_path: Path) -> None:
    for k in range(40):
        twice = f"<include><uri>{k + 1}.sdf</uri><name>{{}}</name></include>"
        text = f'<model name="m"><link name="l"/>{twice.format("a")}{twice.format("b")}</model>'
        (tmp_path / f"{k}.sdf").write_text(sdf(text))
    (tmp_path / "40.sdf").write_text(sdf('<model name="m"><link name="l"/></model>'))
    with pytest.raises(lw.ModelFileError, match="one of more than"):
        lw.import_sdf(tmp_path / "0.sdf")


def test_a_fault_in_an_included_file_is_told_with_its_place_there(tmp_path: Path) -> None:
    (tmp_path / "arm.sdf").write_text(sdf(ARM.replace("<mass>2", "<mass>two")))
    with pytest.raises(lw.ModelFileError, match=r"arm.sdf:3: link 'arm::rod' mass: 'two' is not a finite"):
        loaded(tmp_path, with_models("<include><uri>arm.sdf</uri></include>"))
    (tmp_path / "arm.sdf").write_text(sdf(ARM.replace("<ixx>0.2", "<ixx>9")))
    with pytest.raises(lw.ModelFileError, match=r"robot.sdf:4: link 'arm::rod': .*triangle"):
        loaded(tmp_path, with_models("\n<include><uri>arm.sdf</uri></include>"))


def posed(name: str, relative_to: str) -> str:
    return f'<model name="{name}"><pose relative_to="{relative_to}"/><link name="x"/></model>'


LINK = '<link name="l"/>'

WRONG = [
    ("<include/>", r":4: include: uri is missing"),
    ("<include><uri>https://fuel.gazebosim.org/x</uri></include>", r":4: include: .*nothing is downloaded"),
    ("<include><uri>none.sdf</uri></include>", r":4: include: 'none.sdf' is in none of"),
    ("<include><uri>../outside.sdf</uri></include>", r":4: include: .* is outside of"),
    ("<include><uri>/etc/passwd</uri></include>", r":4: include: '/etc/passwd' is outside of"),
    ("<include><uri>file:///etc/passwd</uri></include>", r":4: include: .* is outside of"),
    ("<include><uri>leaving</uri></include>", r":4: include: .* leads outside of its folder"),
    ("<include><uri>link.sdf</uri></include>", r":4: include: .* is outside of"),
    ("<include><uri>empty</uri></include>", r":4: include: 'empty' has no file 'model.sdf'"),
    ("<include><uri>no.sdf</uri></include>", r":4: include: 'no.sdf' .*is no XML"),
    ("<include><uri>two.sdf</uri></include>", r":4: include: 'two.sdf' has 2 models"),
    ("<include><uri>inside/robot.sdf</uri></include>", r":4: include: .*includes itself: robot.sdf -> r"),
    ("<include><uri>\x7f%00</uri></include>", r":4: include: .* is in none of"),
    ("<include><uri>http://[</uri></include>", r":4: include: .* is no URI"),
    ('<include merge="true"><uri>two.sdf</uri></include>', r":4: include: .*to be merged"),
    ('<model name="m"/><model name="m"/>', r":4: model 'm': is given twice"),
    ('<model name="l"/>', r":4: model 'l': is the name of a link, too"),
    ("<model/>", r":4: model: name is missing"),
    ('<model name="m" placement_frame="x"/>', r":4: pose: no frame 'x'"),
    (posed("m", "m::x"), r":4: model 'm' pose: is relative to itself: m -> m"),
    (posed("m", "x") + posed("x", "m::x"), r":4: model 'm' pose: is relative to itself: m -> x -> m"),
    ('<model name="m">' + posed("x", "l") + "</model>", r":4: pose: no frame 'l'"),
    ('<model name="m">' + posed("x", "world") + "</model>", r":4: pose: no frame 'world'"),
    (joined("m::x", "l"), r":4: joint 'hinge' parent: no link 'm::x'"),
    (joined("l", "world"), r":4: joint 'hinge' child: no link 'world'"),
    ('<frame name="f" attached_to="g"/><frame name="g" attached_to="f"/>' + joined("f", "l"),
     r":4: frame 'f' pose: is attached to itself: f -> g -> f"),
    ('<model name="m">' * 60 + "</model>" * 60, r"nested more than 50 deep"),
    ('<model name="m">' * 5000 + "</model>" * 5000, r"nested more than 50 deep"),
    ('<model name="m">' * 20000 + "</model>" * 20000, r"elements are nested more than 10000 deep"),
]  # fmt: skip


@pytest.mark.parametrize(("part", "message"), WRONG)
def test_wrong_compositions_are_refused_with_line_and_name(part: str, message: str, tmp_path: Path) -> None:
    folder = tmp_path / "models"
    for inner in ("leaving", "empty", "inside"):
        (folder / inner).mkdir(parents=True)
    (folder / "leaving/model.config").write_text("<model><sdf>../../outside.sdf</sdf></model>")
    (folder / "inside/robot.sdf").symlink_to(folder / "robot.sdf")
    for file in (tmp_path / "outside.sdf", folder / "ok.sdf"):
        file.write_text(sdf(ARM))
    (folder / "link.sdf").symlink_to(tmp_path / "outside.sdf")
    (folder / "no.sdf").write_text("none")
    (folder / "two.sdf").write_text(sdf(ARM + ARM))
    with pytest.raises(lw.ModelFileError, match=message):
        loaded(folder, f'<model name="robot">{LINK}\n{part}</model>')
    assert loaded(folder, f'<model name="robot">{LINK}\n<include><uri>ok.sdf</uri></include></model>')


def test_a_chain_of_thousands_of_frames_is_followed(tmp_path: Path) -> None:
    count = 3000
    frames = "".join(
        f'<frame name="f{k}" attached_to="f{k + 1}"><pose>0 0 0.001 0 0 0</pose></frame>'
        for k in range(count)
    )
    link = (
        f'<link name="last"><pose relative_to="f0"/>{INERTIAL}</link><link name="f{count}">{INERTIAL}</link>'
    )
    model = loaded(tmp_path, f'<model name="m">{link}{frames}{joined("f1", "last")}</model>').model
    assert pose(model, "last")[2, 3] == pytest.approx(3.0, abs=1e-12)
