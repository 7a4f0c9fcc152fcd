"""What linkwork works without: where it is missing, one message names the extra that brings it."""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import metadata
from pathlib import Path

import linkwork as lw
import pytest
from linkwork.arguments import optional_package

ROBOT = Path(__file__).parent / "robots" / "slider_crank.xml"


def short_run() -> lw.Result:
    return lw.simulate(lw.mechanisms.pendulum(), t_end=0.02, step=0.01)


def mesh(folder: Path) -> object:
    path = folder / "part.stl"
    path.write_text("solid part\nendsolid part\n")
    return lw.Mesh.load(path)


USES: dict[str, tuple[str, Callable[[Path], object]]] = {
    "pandas": ("pandas", lambda folder: short_run().to_frame()),
    "xarray": ("xarray", lambda folder: short_run().to_xarray()),
    "imageio_ffmpeg": ("movie", lambda folder: short_run().movie(folder / "a.mp4")),
    "mujoco": ("mjcf", lambda folder: lw.import_mjcf(ROBOT)),
    "trimesh": ("mesh", mesh),
}


@pytest.mark.parametrize("package", USES)
def test_a_package_that_is_missing_is_named_with_its_extra(
    package: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    extra, use = USES[package]
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(
        lw.LinkworkError, match=rf"needs the package {package}, .*'linkwork\[{extra}\]'"
    ) as caught:
        use(tmp_path)
    assert caught.value.code == "missing_package"
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("package", USES)
def test_the_extra_that_is_named_brings_the_package(package: str) -> None:
    extra = USES[package][0]
    brought = [
        it for it in metadata.requires("linkwork") or () if f'extra == "{extra}"' in it.replace("'", '"')
    ]
    assert any(it.replace("-", "_").startswith(package) for it in brought), brought


def test_a_package_that_is_broken_is_not_called_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "broken_package.py").write_text("import no_such_library")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(lw.OptionError, match=r"cannot be imported \(No module named 'no_such_library'\)"):
        optional_package("broken_package", "mesh", "this")
