"""Good files with a few random changes: each gives a model, or is refused with the lines of its faults."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Sequence
from pathlib import Path

import linkwork as lw
import pytest
from hypothesis import given
from hypothesis import strategies as st
from linkwork import importers
from linkwork.modeling.files.yaml_text import YamlText
from random_mechanisms import examples
from robot_files import ROBOTS
from test_import_sdf_composition import ARM, MARK, joined, sdf, with_models
from test_malformed_files import YAML

MIMIC = '<mimic joint="shoulder" multiplier="2" offset="0.1"/>'

DRIVEN = """\
linkwork: 1
functions: {swing: {table: {t: [0, 1, 2], values: [0.1, 0.2, 0.7]}}}
bodies:
  - {name: a, mass: 1, inertia: [1, 1, 1]}
  - {name: b, mass: 1, inertia: [1, 1, 1], position: [1, 0, 0]}
joints:
  - {kind: cylindrical, name: p, a: ground, b: a, at: [0, 0, 0], axis: [0, 1, 0]}
  - {kind: revolute, name: q, a: ground, b: b, at: [1, 0, 0], axis: [0, 1, 0]}
  - {kind: coupler, coordinates: [{joint: p, coordinate: angle, factor: 2}, {joint: q, factor: -1}]}
  - {kind: drive, joint: p, coordinate: angle, position: {expression: 0.3 * sin(2 * pi * t)**2}}
  - {kind: drive, joint: p, coordinate: displacement, velocity: swing}
  - {kind: point_on_curve, a: ground, b: b, points: [[0, 0, 0], [1, 0, 0], [2, 1, 0]], at: [1, 0, 0]}
"""

FILES: dict[str, bytes] = {
    "model.yaml": YAML.encode(),
    "driven.yaml": DRIVEN.encode(),
    "model.json": json.dumps(YamlText(YAML).data, indent=1).encode(),
    "arm.urdf": (ROBOTS / "arm.urdf").read_bytes().replace(b"<dynamics", MIMIC.encode() + b"\n<dynamics"),
    "loop.sdf": (ROBOTS / "four_bar.sdf").read_bytes(),
    "nested.sdf": sdf(with_models(MARK, ARM, joined("world", "arm::tip"))).replace("><", ">\n<").encode(),
    "loop.xml": (ROBOTS / "slider_crank.xml").read_bytes(),
}

#: What a part of a file becomes.
TOKENS = (
    *(b"", b"-1", b"0", b"-0.0", b"1e400", b"1e308", b"1e-320", b"nan", b"9" * 400, b"null", b"true"),
    *(b"[]", b"{}", b"- ", b": ", b"*a", b"&a ", b"!!python/object ", b"<", b">", b"&", b'"', b"'"),
    *(b"x", b"ground", b"world", b"__model__", b"::"),
    *(b"\t", b"\r", b"\n", b"\x00", b"\xff", b"\xe2\x80\xa8"),
)

#: A change: its kind, where (0 to 1, twice), and the token.
Edit = tuple[str, float, float, bytes]


def words(content: bytes) -> list[tuple[int, int]]:
    """Where numbers and names are."""
    return [found.span() for found in re.finditer(rb"[\w.+-]+", content)] or [(0, 0)]


def replace_word(content: bytes, at: float, other: float, token: bytes) -> bytes:
    start, end = words(content)[int(at * (len(words(content)) - 1))]
    return content[:start] + token + content[end:]


def copy_word(content: bytes, at: float, other: float, token: bytes) -> bytes:
    places = words(content)
    start, end = places[int(other * (len(places) - 1))]
    return replace_word(content, at, other, content[start:end])


def insert(content: bytes, at: float, other: float, token: bytes) -> bytes:
    place = int(at * len(content))
    return content[:place] + token + content[place:]


def delete(content: bytes, at: float, other: float, token: bytes) -> bytes:
    place = int(at * len(content))
    return content[:place] + content[place + 1 + int(20 * other) :]


def cut(content: bytes, at: float, other: float, token: bytes) -> bytes:
    return content[: int(at * len(content))]


def delete_line(content: bytes, at: float, other: float, token: bytes) -> bytes:
    lines = content.split(b"\n")
    del lines[int(at * (len(lines) - 1))]
    return b"\n".join(lines)


def copy_line(content: bytes, at: float, other: float, token: bytes) -> bytes:
    lines = content.split(b"\n")
    lines.insert(int(other * len(lines)), lines[int(at * (len(lines) - 1))])
    return b"\n".join(lines)


EDITS: dict[str, Callable[[bytes, float, float, bytes], bytes]] = {
    edit.__name__: edit
    for edit in (replace_word, copy_word, insert, delete, cut, delete_line, copy_line)
}  # fmt: skip

PLACES = st.floats(0, 1)
CHANGES = st.lists(
    st.tuples(st.sampled_from(sorted(EDITS)), PLACES, PLACES, st.sampled_from(TOKENS)), min_size=1, max_size=4
)


def mutated(content: bytes, changes: Sequence[Edit]) -> bytes:
    for kind, at, other, token in changes:
        content = EDITS[kind](content, at, other, token)
    return content


def read(path: Path) -> lw.Model:
    return importers.read(path).model if importers.is_importable(path) else lw.Model.load(path)


@pytest.mark.parametrize("name", FILES)
def test_the_files_that_are_changed_are_good(name: str, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_bytes(FILES[name])
    assert read(path).joint_count


@pytest.mark.parametrize("name", FILES)
@examples(300)
@given(changes=CHANGES)
def test_changed_files_give_a_model_or_their_faults(
    name: str, changes: list[Edit], tmp_path_factory: pytest.TempPathFactory
) -> None:
    path = tmp_path_factory.getbasetemp() / f"changed {name}"
    content = mutated(FILES[name], changes)
    path.write_bytes(content)
    try:
        read(path)
    except lw.ModelFileError as error:
        lines = 1 + content.count(b"\n") + content.count(b"\r")
        assert all(1 <= fault.line <= lines and fault.message for fault in error.faults), error
        assert all(line.startswith(f"{path}:") for line in str(error).splitlines()), error
