"""Results in pandas, xarray, CSV and HDF5, and by `linkwork plot`, `movie` and `export`."""

from __future__ import annotations

import csv
import io
import os
import time
from pathlib import Path

import h5py
import linkwork as lw
import numpy as np
import pytest
from linkwork.cli import main
from linkwork.plots.kinds import KINDS
from linkwork.results import joint_motion, reading
from linkwork.results.tables import QUANTITIES
from linkwork.running import progress

pandas = pytest.importorskip("pandas")
xarray = pytest.importorskip("xarray")


def words(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[object, str, str]:
    """Exit code, standard output and standard error of a command."""
    with pytest.raises(SystemExit) as end:
        main(arguments)
    return end.value.code, *capsys.readouterr()


@pytest.fixture(scope="module")
def result() -> lw.Result:
    return lw.simulate(lw.mechanisms.spatial_slider_crank(), t_end=0.1, step=1e-3)


def test_a_frame_has_a_column_a_number_named_with_its_unit(result: lw.Result) -> None:
    frame = result.to_frame()
    assert frame.index.name == "t [s]" and np.array_equal(frame.index, result.t)
    crank, pin = result.body("crank"), result.reaction("bearing")
    for axis, x in enumerate("xyz"):
        assert np.array_equal(frame[f"crank.position.{x} [m]"], crank.position[:, axis])
        assert np.array_equal(frame[f"crank.omega.{x} [rad/s]"], crank.omega[:, axis])
        assert np.array_equal(frame[f"bearing.reaction_torque.{x} [N m]"], pin.torque[:, axis])
    angle = result.coordinate("bearing")
    assert np.array_equal(frame["bearing.angle [rad]"], angle.value)
    assert np.array_equal(frame["bearing.angle_rate [rad/s]"], angle.rate)
    assert np.array_equal(frame["energy_error [J]"], result.energy_error)
    assert frame.attrs["units"]["crank.velocity.x [m/s]"] == "m/s"


def test_columns_can_be_chosen_and_what_is_not_there_is_named(result: lw.Result) -> None:
    frame = result.to_frame(bodies=["crank"], quantities=["velocity"])
    assert list(frame.columns) == [f"crank.velocity.{x} [m/s]" for x in "xyz"]
    with pytest.raises(lw.OptionError, match="quantity 'velocty' does not exist; the nearest is 'velocity'"):
        result.to_frame(quantities=["velocty"])
    with pytest.raises(lw.ModelError, match="no body named 'krank'"):
        result.to_frame(bodies=["krank"])


def test_of_an_empty_list_there_is_none(result: lw.Result, tmp_path: Path) -> None:
    """As of a list that is shorter by one; what is not given is all."""
    whole, result_of_file = result.to_frame(), tmp_path / "run.h5"
    result.save(result_of_file)
    for it in (result, lw.Result.load(result_of_file)):
        assert list(it.to_frame(quantities=[]).columns) == [] and len(it.to_frame(quantities=())) == len(it)
        left = it.to_frame(bodies=[], joints=[], forces=[])
        assert list(left.columns) == [
            name for name in whole.columns if name.count(".") < 1 or "violation" in name
        ]
        assert it.to_csv(quantities=[]).splitlines()[0] == "t [s]"
        assert it.to_xarray(bodies=[])["position"].shape == (len(it), 0, 3)
        assert not it.to_xarray(joints=[], quantities=["coordinate"]).data_vars
        assert not it.to_xarray(forces=[], quantities=["force"]).data_vars


def test_csv_keeps_every_digit(result: lw.Result, tmp_path: Path) -> None:
    path = tmp_path / "run.csv"
    text = result.to_csv()
    result.to_csv(path)
    assert path.read_text(encoding="utf-8") == text
    header, *rows = csv.reader(io.StringIO(text))
    frame = result.to_frame()
    assert header == ["t [s]", *frame.columns]
    numbers = np.array(rows, dtype=float)
    assert np.array_equal(numbers[:, 1:], frame.to_numpy()) and np.array_equal(numbers[:, 0], result.t)


def test_a_data_set_has_named_axes_units_and_the_manifest(result: lw.Result) -> None:
    found = result.to_xarray()
    x = found.position.sel(body="crank", xyz="x")
    assert np.array_equal(x, result.body("crank").position[:, 0]) and x.attrs["units"] == "m"
    assert np.array_equal(found.reaction_force.sel(joint="guide"), result.reaction("guide").force)
    assert np.array_equal(found.displacement.sel(joint_with_displacement="guide")[:, ...],
                          result.coordinate("guide").value)  # fmt: skip
    assert np.array_equal(found.violation.sel(level="velocity"), result.violation[:, 1])
    assert all(found[name].attrs["units"] == it.unit for name, it in QUANTITIES.items())
    assert result.manifest["model_hash"] in found.attrs["manifest"]


def test_a_result_of_a_free_body_has_tables_too() -> None:
    """No joints, so no reactions and no coordinates."""
    model = lw.Model()
    model.body("stone", mass=1.0, inertia=(1, 1, 1))
    result = lw.simulate(model, t_end=0.1, step=0.01)
    assert result.to_frame().shape == (11, 19 + 7)
    assert result.to_xarray().sizes["joint"] == 0


@pytest.fixture(scope="module")
def sprung() -> lw.Result:
    """A load on a spring along a slide, and a pin with a spring about its axis."""
    model = lw.Model()
    load = model.body("load", mass=1.0, inertia=(0.1, 0.1, 0.1))
    model.translational("ground", load, at=(0, 0, 0), axis=(0, 0, 1), name="slide")
    model.spring_damper("ground", load, at=((0, 0, 1), (0, 0, 0)), stiffness=100.0, damping=1.0,
                        free_length=0.9, name="spring")  # fmt: skip
    wheel = model.body("wheel", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
    model.revolute("ground", wheel, at=(1, 0, 0), axis=(0, 0, 1), name="pin")
    model.rotational_spring_damper(
        "ground", wheel, axis=(0, 0, 1), stiffness=0.5, free_angle=0.3, name="twist"
    )
    return lw.simulate(model, t_end=1.0, rtol=1e-8)


def test_tables_have_what_force_elements_do(sprung: lw.Result) -> None:
    frame = sprung.to_frame()
    z, rate = sprung.coordinate("slide").value, sprung.coordinate("slide").rate
    tension = 100.0 * (1 - z - 0.9) - 1.0 * rate  # the spring hangs from z = 1
    assert frame["spring.force.z [N]"].to_numpy() == pytest.approx(tension, abs=1e-9)
    assert frame["spring.deflection [m]"].to_numpy() == pytest.approx(0.1 - z, abs=1e-12)
    turned = sprung.coordinate("pin").value
    assert frame["twist.torque.z [N m]"].to_numpy() == pytest.approx(0.5 * (0.3 - turned), abs=1e-9)
    assert frame["twist.deflection_angle [rad]"].to_numpy() == pytest.approx(turned - 0.3, abs=1e-12)
    assert "spring.deflection_angle [rad]" not in frame and "twist.deflection [m]" not in frame
    assert np.array_equal(frame["spring.power [W]"], sprung.force("spring").power)
    chosen = sprung.to_frame(forces=["twist"], quantities=["potential"])
    assert list(chosen.columns) == ["twist.potential [J]"]
    found = sprung.to_xarray()
    assert np.array_equal(found.force.sel(force_element="spring"), sprung.force("spring").force)
    assert found.deflection_angle.sel(force_with_deflection_angle="twist").dims == ("time",)
    with pytest.raises(lw.ModelError, match="no force element named 'sprung'"):
        sprung.to_csv(forces=["sprung"])


def test_tables_of_files_are_without_forces_and_say_so_where_they_are_asked(
    sprung: lw.Result, tmp_path: Path
) -> None:
    sprung.save(tmp_path / "run.h5")
    loaded = lw.Result.load(tmp_path / "run.h5")
    gone = set(sprung.to_frame().columns) - set(loaded.to_frame().columns)
    assert gone and all(name.startswith(("spring.", "twist.")) for name in gone)
    for asked in ({"forces": ["spring"]}, {"quantities": ["power"]}):
        with pytest.raises(lw.OptionError, match="a result from a file has no laws of forces"):
            loaded.to_frame(**asked)


def test_pictures_show_what_force_elements_do(sprung: lw.Result) -> None:
    upper, lower = sprung.plot(kind="forces").axes
    drawn = {line.get_label(): line.get_ydata() for line in (*upper.lines, *lower.lines)}
    assert drawn["spring"] == pytest.approx(np.abs(sprung.force("spring").force[:, 2]))
    assert drawn["twist"] == pytest.approx(np.abs(sprung.force("twist").torque[:, 2]))
    (line,) = sprung.plot(kind="forces", forces=["twist"]).axes[1].lines
    assert line.get_label() == "twist"
    with pytest.raises(lw.OptionError, match="plot 'energy' shows no forces"):
        sprung.plot(kind="energy", forces=["twist"])


def test_datasets_of_a_file_name_their_units(result: lw.Result, tmp_path: Path) -> None:
    result.save(tmp_path / "run.h5")
    with h5py.File(tmp_path / "run.h5") as file:
        assert all("units" in field.attrs for field in file["frames"].values())
        assert file["frames/reaction_force"].attrs["units"] == "N"
        assert file["model/inertia"].attrs["units"] == "kg m2"


def test_files_are_replaced_on_request_only(result: lw.Result, tmp_path: Path) -> None:
    saved, table = tmp_path / "run.h5", tmp_path / "run.csv"
    saved.write_text("precious")
    table.write_text("precious")
    for write in (
        lambda **how: result.save(saved, **how),
        lambda **how: result.to_csv(table, **how),
        lambda **how: lw.simulate(lw.mechanisms.pendulum(), 0.1, 0.01, output=saved, **how),
    ):
        with pytest.raises(lw.FileError, match="there is such a file already.*overwrite=True") as caught:
            write()
        assert caught.value.code == "exists"
    assert saved.read_text() == table.read_text() == "precious"
    result.save(saved, overwrite=True)
    assert len(lw.Result.load(saved)) == len(result)
    result.to_csv(table, overwrite=True)
    assert table.read_text().startswith("t [s],")


def test_a_suffix_of_another_kind_of_file_is_refused(result: lw.Result, tmp_path: Path) -> None:
    for write, name in (
        (result.save, "a.csv"), (result.to_csv, "a.h5"), (result.plot, "a.html"), (result.view, "a.png"),
        (result.movie, "a.png"), (result.save, "a.zarr"), (result.save, "a.npz"), (result.to_csv, "a.txt"),
    ):  # fmt: skip
        with pytest.raises(lw.FileError, match="is the suffix of a") as caught:
            write(tmp_path / name)
        assert caught.value.code == "format"
    assert list(tmp_path.iterdir()) == []


def test_a_picture_has_no_name_of_a_kind(
    result: lw.Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    drawn = {"gravity[2]": [-9.0, -8.0]}
    study = lw.sweep(lw.mechanisms.pendulum(), drawn, "energy.max", t_end=0.02, step=1e-2, processes=1)
    comparison = lw.compare(lw.mechanisms.pendulum(), 0.02, steps=[1e-2], integrators=["rk4"])
    for draw, kind in ((result.plot, "energy"), (study.plot, "tornado"), (comparison.plot, "order")):
        with pytest.raises(
            lw.FileError, match=f"picture '{kind}' is the name of a kind, which kind='{kind}' draws"
        ):
            draw(path=kind)
        with pytest.raises(lw.OptionError, match="'it.png' does not exist; a file is given as path='it.png'"):
            draw(kind="it.png")
    assert os.listdir() == []


@pytest.mark.parametrize("kind", ["positions", "velocities", "accelerations"])
def test_pictures_of_bodies_draw_what_the_result_has(result: lw.Result, kind: str) -> None:
    figure = result.plot(kind=kind, bodies=["crank"])
    recorded = [
        values for it in QUANTITIES.values() if it.of == "body" for values in it.values(result)[:, 0].T
    ]
    lines = [line for ax in figure.axes for line in ax.lines]
    assert lines and all(line.get_label().startswith("crank") for line in lines)
    for line in lines:
        assert any(np.array_equal(line.get_ydata(), values) for values in recorded)


def test_commands_write_pictures_movies_and_tables_of_a_file(
    result: lw.Result, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    result.save("run.h5")
    code, _, error = words(capsys, "plot", "run.h5", "--kind", "forces")
    assert code == 1 and "needs the laws of forces, which no file has" in error
    for kind in KINDS.keys() - {"forces"}:
        assert words(capsys, "plot", "run.h5", "--kind", kind)[0] == 0
        assert Path(f"run.{kind}.png").stat().st_size > 5000
    assert words(capsys, "movie", "run.h5", "-o", "run.gif", "--seconds", "0.2", "--size", "64", "64")[0] == 0
    assert Path("run.gif").read_bytes().startswith(b"GIF")
    assert words(capsys, "export", "run.h5", "--csv")[0] == 0
    assert Path("run.csv").read_text() == result.to_csv()
    code, _, error = words(capsys, "export", "run.h5", "--csv")
    assert code == 1 and "run.csv" in error and "--force" in error
    assert words(capsys, "export", "run.h5", "--csv", "--quantity", "work", "--force")[0] == 0
    assert Path("run.csv").read_text() == result.to_csv(quantities=["work"])


def test_columns_are_counted_whatever_they_are_called(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    model = lw.Model()
    model.body("rod, the left", mass=1.0, inertia=(1, 1, 1))
    lw.simulate(model, t_end=0.01, step=1e-3, progress=False).save(tmp_path / "run.h5")
    _, said, _ = words(capsys, "export", str(tmp_path / "run.h5"), "--quantity", "position")
    assert "3 columns" in said


def test_violations_have_the_units_of_their_levels() -> None:
    """Equations are of lengths or of directions, and so are their rates."""
    result = lw.simulate(lw.mechanisms.pendulum(), t_end=0.01, step=1e-3, progress=False)
    assert [*result.to_frame(quantities=["violation"]).columns] == [
        "violation.position [m or 1]",
        "violation.velocity [m/s or 1/s]",
        "violation.acceleration [m/s2 or 1/s2]",
    ]


@pytest.mark.parametrize("held", [joint_motion.HELD_NUMBERS, 26 * 5 * 100, 1])
def test_coordinates_of_joints_of_a_file_are_read_together(
    held: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As often as so many numbers at a time need, and not for each joint; all are what they are in memory."""
    run = lw.simulate(lw.mechanisms.chain(200), t_end=4e-3, step=1e-3, progress=False, on_inaccurate="pass")
    run.save(tmp_path / "chain.h5")
    stored = lw.Result.load(tmp_path / "chain.h5")
    monkeypatch.setattr(joint_motion, "HELD_NUMBERS", held)
    reads: list[str] = []
    read = reading.StoredField.__getitem__
    monkeypatch.setattr(
        reading.StoredField, "__getitem__", lambda self, key: (reads.append(self.name), read(self, key))[1]
    )
    table = stored.to_csv(quantities=["coordinate"])
    at_once = min(200, max(1, held // (26 * len(run))))
    assert reads.count("q") == reads.count("v") == 200 / at_once
    assert table == run.to_csv(quantities=["coordinate"])
    name = run.joint_names[-1]
    column = stored.to_frame(joints=[name], quantities=["coordinate"]).iloc[:, 0]
    np.testing.assert_array_equal(column, run.coordinate(name).value)


def test_tables_of_a_run_without_a_frame_have_their_columns() -> None:
    run = lw.simulate(lw.mechanisms.chain(200), t_end=0.0, step=1e-3, progress=False)
    none = lw.Result({name: values[:0] for name, values in run._frames.items()}, run.header, {})
    assert len(none.to_frame(quantities=["coordinate"]).columns) == 400


def test_tables_of_a_run_without_a_frame_are_those_of_one_without_their_rows() -> None:
    model = lw.Model()
    model.body("rod", mass=1.0, inertia=(0.01, 0.03, 0.03), position=(0.3, 0, 0))
    model.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    model.rotational_friction("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0), coulomb=1.0, name="brake")
    run = lw.simulate(model, t_end=0.0, step=1e-3, progress=False)
    none = lw.Result({name: values[:0] for name, values in run._frames.items()}, run.header, {})
    assert list(none.to_frame().columns) == list(run.to_frame().columns)
    assert none.to_csv() == run.to_csv().partition("\n")[0] + "\n"
    assert none.to_xarray().sizes == {**run.to_xarray().sizes, "time": 0}


def test_a_table_is_returned_or_written(result: lw.Result, tmp_path: Path) -> None:
    """As by pandas: nobody wants the text of a large table in a notebook, too."""
    written: object = result.to_csv(tmp_path / "run.csv")
    assert written is None


def test_export_of_a_file_without_frames_says_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run = lw.simulate(lw.mechanisms.four_bar(), t_end=0.0, step=1e-3, progress=False)
    fields = {name: values[:0] for name, values in run._frames.items()}
    lw.Result(fields, run.header, {}).save(tmp_path / "run.h5")
    code, _, told = words(capsys, "export", str(tmp_path / "run.h5"))
    assert code == 1 and told == "error: the result has no frames: there is nothing to export\n"


def test_export_shows_that_it_is_at_work(
    result: lw.Result,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    caplog: pytest.LogCaptureFixture,
) -> None:
    result.save(tmp_path / "run.h5")
    monkeypatch.setattr(progress, "SILENT_SECONDS", 0.0)
    monkeypatch.setattr(progress._Log, "seconds", 0.0)
    monkeypatch.setattr(progress, "WORKING_SECONDS", 0.01)
    written = lw.Result.to_csv

    def slow(*given: object, **named: object) -> str | None:
        time.sleep(0.05)
        return written(*given, **named)  # type: ignore[arg-type]

    monkeypatch.setattr(lw.Result, "to_csv", slow)
    with caplog.at_level("INFO", logger="linkwork.running.progress"):
        assert words(capsys, "export", str(tmp_path / "run.h5"))[0] == 0
    assert f"writing {tmp_path / 'run.csv'}" in caplog.text
