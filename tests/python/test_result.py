"""The quantities of a Result: definitions, frames, names; and its picture."""

from __future__ import annotations

import copy
import pickle
from dataclasses import replace
from pathlib import Path

import linkwork as lw
import numpy as np
import pytest
import synthetic
from linkwork import Result, rotation
from linkwork.errors import FileError, LinkworkError
from linkwork.motion import records
from linkwork.motion.records import rotate
from matplotlib import image

X, Y, Z = np.eye(3)
BELOW = np.array([0.1, 0.2, -0.3])


def make_result(bodies: int = 3, joints: int = 4, count: int = 100) -> Result:
    header = synthetic.header(bodies, joints)
    return Result(synthetic.frames(header, 0, count), header, {"steps": 7})


# --- rotation ---


def test_a_quarter_turn_about_z_takes_x_to_y() -> None:
    np.testing.assert_allclose(rotate(rotation.about(Z, np.pi / 2), X), Y, atol=1e-15)


def test_rotate_is_the_rotation_matrix_times_the_vector() -> None:
    rng = np.random.default_rng(1)
    p, u = rng.standard_normal((50, 4)), rng.standard_normal((50, 3))
    p /= np.linalg.norm(p, axis=1, keepdims=True)
    np.testing.assert_allclose(rotate(p, u), np.einsum("kij,kj->ki", rotation.matrix(p), u), atol=1e-14)


# --- definitions ---


def test_shapes_are_frames_by_bodies_by_components() -> None:
    result = make_result(bodies=3, joints=4, count=10)
    shapes = {
        "t": (10,),
        "q": (10, 3, 7),
        "v": (10, 3, 6),
        "position": (10, 3, 3),
        "orientation": (10, 3, 4),
        "velocity": (10, 3, 3),
        "omega": (10, 3, 3),
        "omega_inertial": (10, 3, 3),
        "acceleration": (10, 3, 3),
        "angular_acceleration": (10, 3, 3),
        "multipliers": (10, 20),
        "kinetic_energy": (10,),
        "potential_energy": (10,),
        "energy": (10,),
        "work": (10,),
        "energy_error": (10,),
        "violation": (10, 3),
    }
    assert {name: getattr(result, name).shape for name in shapes} == shapes
    assert result.reactions().force.shape == result.reactions().torque.shape == (10, 4, 3)
    assert result.reaction("pin 2").force.shape == (10, 3)


def test_energy_error_is_energy_gained_beyond_work() -> None:
    result = make_result()
    gained = (
        result.kinetic_energy
        + result.potential_energy
        - result.kinetic_energy[0]
        - result.potential_energy[0]
    )
    np.testing.assert_array_equal(result.energy_error, gained - result.work)


def test_body_by_name_and_by_index_are_columns_of_the_whole() -> None:
    result = make_result()
    for body in (result.body("link 1 µ"), result.body(1), result.body(-2)):
        assert body.name == "link 1 µ"
        for name in (
            "position",
            "orientation",
            "velocity",
            "omega",
            "omega_inertial",
            "acceleration",
            "angular_acceleration",
        ):
            np.testing.assert_array_equal(getattr(body, name), getattr(result, name)[:, 1], err_msg=name)


@pytest.mark.parametrize(
    "ask, message",
    [
        (lambda result: result.body("link 1"), "no body named 'link 1'; the nearest is 'link 1 µ'"),
        (lambda result: result.body(3), "no body 3: there are 3"),
        (lambda result: result.reaction("pni 2"), "no joint named 'pni 2'; the nearest is 'pin 2'"),
        (
            lambda result: result.reaction("pin 2", frame="body"),
            "frame 'body' does not exist; choose from 'inertial', 'joint'",
        ),
    ],
)
def test_unknown_name_is_answered_with_the_nearest(ask: object, message: str) -> None:
    with pytest.raises(LinkworkError) as caught:
        ask(make_result())  # type: ignore[operator]
    assert str(caught.value) == message


def test_handles_of_the_model_stand_for_names() -> None:
    model = lw.Model()
    body = model.body("rod", mass=1.0, inertia=(1, 1, 1), position=(0.5, 0, 0))
    pin = model.revolute(model.ground, body, at=(0, 0, 0), axis=(0, 1, 0))
    low = lw.Event(lambda t, state: state.body(body).position[2] + 0.1, terminal=True)
    result = lw.simulate(model, 1.0, rtol=1e-8, events=low, progress=False)
    assert result.body(body).position[-1, 2] == pytest.approx(-0.1)
    np.testing.assert_array_equal(result.reaction(pin).force, result.reaction(0).force)
    np.testing.assert_array_equal(result.coordinate(pin).value, result.coordinate(pin.name).value)
    with pytest.raises(lw.ModelError, match="no body named 'Joint"):
        result.body(pin)


def test_summary_names_method_violation_and_effort() -> None:
    text = make_result().summary()
    assert "synthetic: 3 bodies, 4 joints, 20 constraints" in text
    assert "standard, rk4, step 0.001 s" in text
    assert "0 to 0.99 s, 100 frames" in text
    assert "\x1b" not in text


# --- reactions of a real mechanism ---


def hanging_rod(angle: float = 0.0) -> lw.Model:
    """A 2 kg rod of 1 m on a pin about y, at rest, turned by `angle` from hanging straight down."""
    model = lw.Model(gravity=(0, 0, -9.81))
    center = 0.5 * np.array([np.sin(angle), 0, -np.cos(angle)])
    rod = model.body(
        "rod", mass=2.0, inertia=(1 / 6, 1 / 6, 1e-3), position=center, orientation=rotation.about(Y, -angle)
    )
    model.revolute(model.ground, rod, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    return model


def test_pin_carries_the_weight_of_a_hanging_rod() -> None:
    result = lw.simulate(hanging_rod(), t_end=0.1, step=1e-2)
    force, torque = result.reaction("pin")
    np.testing.assert_allclose(force, np.broadcast_to([0, 0, 2 * 9.81], force.shape), rtol=0, atol=1e-12)
    np.testing.assert_allclose(torque, 0, atol=1e-12)


def test_pin_force_accelerates_the_center_of_a_swinging_rod() -> None:
    result = lw.simulate(hanging_rod(angle=1.0), t_end=1.0, step=1e-3)
    force = 2.0 * (result.body("rod").acceleration + 9.81 * Z)
    np.testing.assert_allclose(result.reaction("pin").force, force, atol=1e-10)


def rod_with_ball(angle: float) -> lw.Model:
    """The rod, and a ball on a cross joint at its end, pulled by a winch that a Python function drives."""
    model = hanging_rod(angle)
    rod_end = np.array([np.sin(angle), 0, -np.cos(angle)])
    ball = model.body("ball", mass=0.5, inertia=(0.01, 0.02, 0.03), position=rod_end + BELOW)
    model.universal(model.find("rod"), ball, at=rod_end, axes=((0, 1, 0), (0, 0, 1)), name="cross")
    start = float(np.linalg.norm(rod_end + BELOW - [2, 0, 0]))
    length = (lambda t: start + 0.1 * t**2, lambda t: 0.2 * t, lambda t: 0.2)
    model.distance(model.ground, ball, at=((2, 0, 0), rod_end + BELOW), length=length, name="winch")
    return model


def test_joint_frame_turns_reactions_without_changing_their_size() -> None:
    result = lw.simulate(rod_with_ball(1.0), t_end=0.2, step=1e-3)
    for name in ("pin", "cross", "winch"):
        inertial, joint, axes = (
            result.reaction(name),
            result.reaction(name, frame="joint"),
            result.joint_axes(name),
        )
        for part in ("force", "torque"):
            turned_back = np.einsum("kij,kj->ki", axes, getattr(joint, part))
            np.testing.assert_allclose(turned_back, getattr(inertial, part), atol=1e-11)
    along_y = np.broadcast_to(Y, (len(result), 3))
    np.testing.assert_allclose(np.abs(result.joint_axes("pin")[:, :, 2]), along_y, atol=1e-14)
    np.testing.assert_allclose(result.reaction("pin", frame="joint").torque[:, 2], 0, atol=1e-10)


def test_points_of_a_joint_are_where_the_bodies_meet() -> None:
    result = lw.simulate(rod_with_ball(1.0), t_end=0.2, step=1e-3)
    cross = result.joint_points("cross")
    np.testing.assert_allclose(cross[:, 0], cross[:, 1], atol=1e-7)
    np.testing.assert_allclose(cross[:, 0], 2 * result.body("rod").position, atol=1e-7)
    on_ground, on_ball = result.joint_points("winch").swapaxes(0, 1)
    length = np.linalg.norm(on_ball - on_ground, axis=1)
    np.testing.assert_allclose(length, length[0] + 0.1 * result.t**2, atol=1e-7)


def test_loaded_result_has_the_reactions_of_a_winch_driven_by_a_python_function(tmp_path: Path) -> None:
    result = lw.simulate(rod_with_ball(1.0), t_end=0.2, step=1e-3)
    result.save(tmp_path / "run.h5")
    loaded = Result.load(tmp_path / "run.h5")
    for name in ("pin", "cross", "winch"):
        for frame in ("inertial", "joint"):
            for fresh, stored in zip(result.reaction(name, frame), loaded.reaction(name, frame), strict=True):
                np.testing.assert_array_equal(stored, fresh)
    assert np.abs(loaded.reaction("winch").force).max() > 0.1


def test_result_that_went_to_another_process_has_everything() -> None:
    result = lw.simulate(rod_with_ball(1.0), t_end=0.2, step=1e-3)
    there = pickle.loads(pickle.dumps(result))
    np.testing.assert_array_equal(there.q, result.q)
    np.testing.assert_array_equal(there.reaction("winch").force, result.reaction("winch").force)
    assert (there.manifest, there.statistics) == (result.manifest, result.statistics)
    assert list(there.joint_names) == list(result.joint_names)


def test_result_written_during_the_run_equals_the_one_in_memory(tmp_path: Path) -> None:
    run = {"t_end": 0.5, "step": 1e-3}
    memory = lw.simulate(hanging_rod(1.0), **run)
    stored = lw.simulate(hanging_rod(1.0), **run, output=tmp_path / "run.h5")
    for name in ("t", "q", "v", "acceleration", "multipliers", "energy", "work", "violation"):
        np.testing.assert_array_equal(getattr(stored, name), getattr(memory, name), err_msg=name)
    np.testing.assert_array_equal(stored.reaction("pin").force, memory.reaction("pin").force)
    assert stored.manifest["model_hash"] == memory.manifest["model_hash"]


# --- pictures ---


@pytest.mark.parametrize("bodies, joints", [(1, 0), (3, 4), (1000, 1000)])
def test_plot_shows_few_telling_lines_for_any_number_of_bodies(
    tmp_path: Path, bodies: int, joints: int
) -> None:
    figure = make_result(bodies, joints).plot(tmp_path / "run.png")
    assert max(len(ax.lines) for ax in figure.axes) <= 9
    legends = [legend.get_title().get_text() for ax in figure.axes if (legend := ax.get_legend())]
    assert any("3 of 1000 bodies" in text for text in legends) == (bodies == 1000)
    picture = image.imread(tmp_path / "run.png")
    assert picture.shape[0] > 800 and np.ptp(picture[..., :3]) == 1.0


def test_plot_leaves_pyplot_alone() -> None:
    from matplotlib import pyplot

    make_result().plot()
    assert not pyplot.get_fignums()


def test_picture_that_cannot_be_written_is_a_file_error(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"run.png': cannot be written: no such file or directory"):
        make_result().plot(tmp_path / "nowhere" / "run.png")
    with pytest.raises(FileError, match=r"run.xyz': no format 'xyz'; choose from "):
        make_result().plot(tmp_path / "run.xyz")


def test_a_reaction_is_about_the_joints_point_on_the_second_body() -> None:
    """A block slides; its weight acts in its center: tau = -(P - r) x F, with P 0.3 m ahead of r, always."""
    model = lw.Model()
    block = model.body("block", mass=2.0, inertia=(1, 1, 1), velocity=(1, 0, 0))
    model.translational("ground", block, at=(0.3, 0, 0), axis=(1, 0, 0), name="guide")
    result = lw.simulate(model, t_end=1.0, step=1e-2)
    reaction, points = result.reaction("guide"), result.joint_points("guide")
    assert points[:, 1, 0] - points[:, 0, 0] == pytest.approx(result.t)  # they are apart
    arm = points[:, 1] - result.body("block").position
    assert reaction.force == pytest.approx(np.tile([0, 0, 2 * 9.81], (len(result), 1)))
    assert reaction.torque == pytest.approx(-np.cross(arm, reaction.force))
    assert reaction.torque[-1] == pytest.approx([0, 0.3 * 2 * 9.81, 0])


def test_one_of_a_kind_is_told_as_one() -> None:
    model = lw.Model(name="top")
    model.spherical("ground", model.body(mass=1.0, inertia=(1, 1, 1)), at=(0, 0, 0))
    result = lw.simulate(model, t_end=0.01, step=1e-2, record_every=1)
    assert model.describe().startswith("top: 1 body, 1 spherical; 3 constraint equations; ")
    assert repr(result) == "<Result: 1 body, 1 joint, 2 frames to t = 0.01 s>"
    assert "top: 1 body, 1 joint, 3 constraints" in result.summary()
    assert repr(result.header) == "<Header: 1 body, 1 joint, 3 equations>"


def test_what_does_not_change_is_not_read_again_for_each_run(monkeypatch: pytest.MonkeyPatch) -> None:
    """Metadata of the package, which take as long as a short run."""
    manifest = lw.simulate(lw.mechanisms.pendulum(), t_end=0.01, step=1e-2).manifest
    monkeypatch.setattr("importlib.metadata.version", lambda name: pytest.fail(f"read {name} again"))
    again = lw.simulate(lw.mechanisms.pendulum(), t_end=0.01, step=1e-2).manifest
    assert again["versions"] == manifest["versions"] and again["versions"]["linkwork"]


# --- what is given out ---


def swinging() -> lw.Result:
    return lw.simulate(lw.mechanisms.rod_pendulum(), t_end=0.1, step=1e-2)


def test_what_a_result_gives_out_cannot_make_it_another_one(tmp_path: Path) -> None:
    """In place, as NumPy is written: a time in milliseconds, a height above the lowest point."""
    result, file = swinging(), tmp_path / "motion.h5"
    swinging().save(file)
    pin = result.joint_names[0]
    for it in (result, Result.load(file), pickle.loads(pickle.dumps(result)), copy.deepcopy(result)):
        given = [it.t, it.q, it.v, it.multipliers, it.position, it.omega, it.acceleration, it.work,
                 it.violation, it.history, it.kinetic_energy, it.recorded("q", -1),
                 *it.reactions(), *it.reaction(pin), it.body(0).position, it.body(0).omega, it.joint_axes(0),
                 it.header.mass, it.header.joint_origin]  # fmt: skip
        for values in given:
            with pytest.raises(ValueError, match="read-only"):
                values *= 1e3
        it.statistics["verdict"]["error"] = it.manifest["options"]["t_end"] = 1e3
        assert it.verdict == result.verdict and it.manifest["options"]["t_end"] == 0.1
        assert np.array_equal(it.q, swinging().q) and it.t[-1] == 0.1


def test_what_is_made_for_the_one_who_asks_is_his() -> None:
    result = swinging()
    state, q = result.snapshot(), result.q.copy()
    state.q[0, 1] += 0.1
    energy, points = result.energy, result.joint_points(0)
    energy -= energy[0]
    points += 1.0
    assert np.array_equal(result.q, q)
    y = lw.System(lw.mechanisms.rod_pendulum()).initial_state()
    start = lw.Snapshot.of(0.0, y)
    x = start.q[0, 0]
    y += 1.0
    assert start.q[0, 0] == x


@pytest.mark.parametrize("y", [None, [1.0, 2.0], np.zeros((2, 13)), []])
def test_a_snapshot_is_made_of_the_coordinates_and_velocities_of_bodies(y: object) -> None:
    with pytest.raises(lw.OptionError, match=r"Snapshot\.of: y .*"):
        lw.Snapshot.of(0.0, y)  # type: ignore[arg-type]


def test_tables_can_be_written_in_and_leave_the_result_as_it_is() -> None:
    pytest.importorskip("xarray")
    pytest.importorskip("pandas")
    result = swinging()
    data, frame = result.to_xarray(), result.to_frame()
    data["kinetic_energy"] *= 2
    data["position"].values[:] = 0
    frame["energy_error [J]" if "energy_error [J]" in frame else frame.columns[0]] *= 2
    frame.iloc[:] = 0.0
    assert np.array_equal(result.q, swinging().q)
    assert np.array_equal(result.kinetic_energy, swinging().kinetic_energy)


def test_a_shape_is_the_one_that_was_checked() -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    mesh = lw.Mesh(corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    corners *= 2
    assert mesh.vertices.max() == 1.0
    for values in (mesh.vertices, lw.Box((1, 2, 3)).size):
        with pytest.raises(ValueError, match="read-only"):
            values *= 2


def test_what_analyses_found_cannot_be_written_over() -> None:
    """Reactions of an equilibrium follow from its multipliers, residuals of an assembly from its arrays."""
    rest = lw.equilibrium(lw.mechanisms.chain(2))
    vibration, assembly = lw.linearize(rest.model), lw.assemble(lw.mechanisms.four_bar())
    found = lw.sensitivity(lambda k: lw.mechanisms.chain(2), {"k": 1.0},
                           {"r": lambda result: result.position[-1, 0]}, t_end=0.02, step=1e-2)  # fmt: skip
    for values in (rest.multipliers, rest.moved, vibration.eigenvalues, vibration.shapes, assembly.moved,
                   assembly.position_after, found.values["r"], found.derivatives["r"]["k"]):  # fmt: skip
        with pytest.raises(ValueError, match="read-only"):
            values[...] = 1.0
    for matrix in (vibration.M, vibration.C, vibration.K, vibration.D):
        with pytest.raises(ValueError, match="read-only"):
            matrix *= 2


def falling() -> lw.Result:
    """A rod that swings down and passes a height on its way."""
    event = lw.Event(lambda t, state: state.body("rod").position[2] + 0.45, "low")
    model = hanging_rod(angle=0.6)
    model.spring_damper(
        "ground", "rod", at=((1, 0, 0), (0, 0, 0)), stiffness=3, free_length=0.1, name="spring"
    )
    return lw.simulate(model, t_end=0.5, rtol=1e-6, atol=1e-8, events=[event])


def test_what_two_equal_runs_give_is_equal(tmp_path: Path) -> None:
    one, two = falling(), falling()
    assert one.events and list(one.events) == list(two.events)
    assert one.snapshot() == two.snapshot() and one.snapshot(1) != two.snapshot(2)
    assert one.force("spring") == two.force("spring")
    joint, other = one.joint_names[0], one.snapshot()._replace(history=(1.0,))
    assert one.snapshot() != other and other == other._replace(history=np.ones(1))
    for run in (two, pickle.loads(pickle.dumps(one))):
        assert one.body("rod") == run.body("rod")
        assert one.reaction(joint) == run.reaction(joint) and one.reactions() == run.reactions()
        assert one.coordinate(joint) == run.coordinate(joint) and one.header == run.header
    assert one.reaction(joint) != lw.Reaction(one.reaction(joint).force, one.reaction(joint).torque + 1)
    assert one.reaction(joint) == tuple(one.reaction(joint)) and one.body("rod") != one.reaction(joint)
    one.save(tmp_path / "run.h5")
    assert lw.Result.load(tmp_path / "run.h5").events == one.events


def test_headers_of_equal_runs_are_equal_whenever_they_were_made() -> None:
    header = falling().header
    later = replace(header, manifest={**header.manifest, "started": "2030-01-01T00:00:00+00:00"})
    assert later == header and later.manifest["started"] != header.manifest["started"]
    assert replace(header, manifest={**header.manifest, "model": "another"}) != header


def test_records_without_a_number_are_equal_where_both_have_none() -> None:
    none = lw.Reaction(np.array([[np.nan, 0.0, 1.0]]), np.zeros((1, 3)))
    assert none == copy.deepcopy(none) and none != lw.Reaction(np.zeros((1, 3)), none.torque)
    assert none != lw.Reaction(np.zeros((2, 3)), none.torque)


def test_all_records_with_arrays_are_compared_by_value() -> None:
    """As == of NumPy's arrays is none, named tuples and dataclasses need one of their own."""
    known = {name: getattr(lw, name) for name in lw.__all__}
    known |= {name: getattr(records, name) for name in records.__all__}
    for name, kind in known.items():
        if not isinstance(kind, type) or kind.__eq__ is object.__eq__:
            continue
        hints = " ".join(map(str, getattr(kind, "__annotations__", {}).values()))
        if "Floats" in hints or "NDArray" in hints:
            assert kind.__eq__.__module__ == "linkwork.arrays", name


def test_names_are_of_one_kind_in_memory_and_from_a_file(tmp_path: Path) -> None:
    held = falling()
    held.save(tmp_path / "run.h5")
    stored = lw.Result.load(tmp_path / "run.h5")
    for run, other in ((held, stored), (stored, held)):
        assert run.body_names == other.body_names and run.joint_names == other.joint_names
        assert run.body_names == ["rod"] == run.body_names and ["rod"] == run.body_names != ["bar"]
        more = ["a"]
        assert run.body_names + more == ["rod", "a"] and more + run.body_names == ["a", "rod"]
        assert run.body_names + other.body_names == ["rod", "rod"] and run.body_names != "rod"
        assert repr(run.body_names) == repr(other.body_names)
