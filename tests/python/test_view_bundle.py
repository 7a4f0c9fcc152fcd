"""The bundle that is shipped is built from the sources beside it, and has the licenses of what is in it."""

from __future__ import annotations

import hashlib
import json
import shutil
import subprocess
from pathlib import Path

import linkwork.view
import pytest

#: Where it is installed, and where the sources are: wheels do not have them.
VIEW = Path(linkwork.view.__file__).parent
SOURCES = Path(__file__).parents[2] / "python/linkwork/view"
BUILT = json.loads((VIEW / "bundle" / "built.json").read_text())
PRODUCTS = ("viewer.js", "viewer.css", "LICENSES.txt")


def sources() -> list[str]:
    return ["build.mjs", "package-lock.json", "package.json",
            *(f"src/{path.name}" for path in sorted((SOURCES / "src").iterdir()))]  # fmt: skip


def test_bundle_is_of_these_sources() -> None:
    digest = hashlib.sha256()
    for name in sources():
        digest.update(f"{name}\0".encode() + (SOURCES / name).read_bytes() + b"\0")
    assert digest.hexdigest() == BUILT["sources"], "sources have changed: ./dev view-bundle"


@pytest.mark.parametrize("name", PRODUCTS)
def test_bundle_is_as_it_was_built(name: str) -> None:
    assert hashlib.sha256((VIEW / "bundle" / name).read_bytes()).hexdigest() == BUILT[name]


def test_packages_are_pinned_and_their_licenses_shipped() -> None:
    packages = json.loads((SOURCES / "package.json").read_text())["dependencies"]
    licenses = (VIEW / "bundle" / "LICENSES.txt").read_text()
    for name, version in packages.items():
        assert version[0].isdigit()
        assert f"{name} {version}\n" in licenses
    assert licenses.count("Permission is hereby granted, free of charge") == len(packages)


def test_building_anew_gives_the_same(tmp_path: Path) -> None:
    """With the packages of the lock file: those that are installed already, or those that npm gets."""
    if shutil.which("npm") is None or shutil.which("node") is None:
        pytest.skip("no Node and npm here")
    for name in sources():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(SOURCES / name, tmp_path / name)
    install = ["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--prefer-offline"]
    got = subprocess.run(install, cwd=tmp_path, capture_output=True, text=True)
    if got.returncode:
        pytest.skip(f"npm cannot get the packages: {got.stderr.strip().splitlines()[-1]}")
    subprocess.run(["node", "build.mjs"], cwd=tmp_path, check=True, capture_output=True)
    for name in PRODUCTS:
        assert (tmp_path / "bundle" / name).read_bytes() == (VIEW / "bundle" / name).read_bytes(), name
