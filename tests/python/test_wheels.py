"""How wheels are made: for which Pythons and machines, with which licenses, without SuiteSparse."""

from __future__ import annotations

import platform as platform_module
import re
import shutil
import subprocess
import sys
import tomllib
from importlib import metadata
from pathlib import Path

import pytest
from linkwork import _core

ROOT = Path(__file__).parents[2]
PYTHONS = ("cp311", "cp312", "cp313", "cp314")


def identifiers(platform: str, *archs: str) -> set[str]:
    """Of the wheels that cibuildwheel would build."""
    cibuildwheel = Path(sys.executable).with_name("cibuildwheel")
    command = [cibuildwheel, "--print-build-identifiers", "--platform", platform]
    options = [word for arch in archs for word in ("--archs", arch)]
    done = subprocess.run([*command, *options, ROOT], capture_output=True, text=True, check=True)
    return set(done.stdout.split())


needs_cibuildwheel = pytest.mark.skipif(
    not Path(sys.executable).with_name("cibuildwheel").exists(), reason="needs cibuildwheel"
)


@needs_cibuildwheel
@pytest.mark.parametrize(
    ("platform", "machines"),
    [("linux", ("manylinux_x86_64", "manylinux_aarch64")), ("macos", ("macosx_arm64",))],
)
def test_wheels_are_for_these_pythons_and_machines(platform: str, machines: tuple[str, ...]) -> None:
    expected = {f"{python}-{machine}" for python in PYTHONS for machine in machines}
    assert identifiers(platform) == expected


def test_wheels_are_built_for_the_pythons_that_the_project_says() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    assert project["project"]["requires-python"] == ">=3.11"
    settings = project["tool"]["cibuildwheel"]
    assert settings["build"].split() == [f"{python}-*" for python in PYTHONS]
    assert settings["config-settings"] == {"cmake.define.LINKWORK_WITH_SUITESPARSE": "OFF"}


def test_licenses_of_what_is_compiled_in_are_shipped() -> None:
    shipped = {Path(file).name for file in metadata.files("linkwork") or () if "licenses" in str(file)}
    assert shipped >= {"LICENSE", *(path.name for path in (ROOT / "licenses").iterdir())}
    overview = (ROOT / "licenses" / "THIRD-PARTY.txt").read_text()
    for name in shipped - {"LICENSE", "THIRD-PARTY.txt"}:
        assert name in overview, name


@pytest.mark.skipif(not shutil.which("nm"), reason="needs nm")
def test_the_module_asks_for_no_newer_c_library_than_its_wheel_says() -> None:
    """manylinux_2_34: symbols of the C library up to 2.34."""
    import linkwork._core

    command = ["nm", "--dynamic", "--undefined-only", linkwork._core.__file__]
    symbols = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    versions = {tuple(map(int, word.partition("@GLIBC_")[2].split("."))) for word in symbols.split()
                if "@GLIBC_" in word}  # fmt: skip
    assert versions and max(versions) <= (2, 34)


@pytest.mark.skipif(
    platform_module.libc_ver() != ("glibc", "2.36"), reason="another toolchain than wheels are tried with"
)
def test_the_module_asks_for_no_newer_libraries_than_wheels_promise() -> None:
    """manylinux_2_34 has glibc 2.34 and the C++ library of GCC 11."""
    module = Path(_core.__file__).read_bytes()
    for name, newest in (("GLIBC_2", 34), ("GLIBCXX_3.4", 29)):
        versions = re.findall(rb"\0" + re.escape(name.encode()) + rb"\.(\d+)\0", module)
        assert versions and max(map(int, versions)) <= newest, name
