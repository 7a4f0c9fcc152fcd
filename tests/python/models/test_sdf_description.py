"""The list of SDF's elements in the folder robots is that of the files of an installed libsdformat."""

from __future__ import annotations

from pathlib import Path

import pytest
from format_descriptions import expanded, keys, read, sdf_blocks
from linkwork.importers.sdf_coverage import SDF

pytestmark = pytest.mark.models

FOLDERS = sorted(Path("/usr/share").glob("sdformat*"))


@pytest.mark.skipif(not FOLDERS, reason="no package sdformat-sdf here")
@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_installed_descriptions_have_nothing_that_is_in_no_list(folder: Path) -> None:
    elements = expanded(sdf_blocks(folder), "root.sdf")
    assert len(elements) > 1000
    assert sorted({key for key in keys(SDF, elements) if SDF[key] is None}) == []


@pytest.mark.skipif(not Path("/usr/share/sdformat12").is_dir(), reason="no libsdformat 12 here")
def test_the_list_is_that_of_libsdformat_12() -> None:
    assert read("sdf_elements.txt") == sdf_blocks(Path("/usr/share/sdformat12"))
