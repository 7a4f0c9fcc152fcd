# ruff: noqa: UP031, braces are those of JSON
"""Files of 150 kB that are made to take memory: none takes more than forty times its size."""

from __future__ import annotations

import tracemalloc
from pathlib import Path

import linkwork as lw
import pytest

SIZE = 150_000

FILES = {
    "numbers.json": '{"linkwork": 1, "bodies": [%s 1]}' % ("1," * (SIZE // 2)),
    "objects.json": '{"linkwork": 1, "bodies": [%s {}]}' % ("{}," * (SIZE // 3)),
    "lists.json": '{"linkwork": 1, "joints": [%s []]}' % ("[]," * (SIZE // 3)),
    "repeated.json": '{"linkwork": 1, %s "z": 1}' % "".join(f'"a{k}":1,"a{k}":2,' for k in range(SIZE // 20)),
    "unknown.json": '{"linkwork": 1, "bodies": [{%s "z": 1}]}'
    % "".join(f'"a{k}":1,' for k in range(SIZE // 10)),
    "functions.json": '{"linkwork": 1, "functions": {%s "z": 1}}'
    % "".join(f'"a{k}":"x",' for k in range(SIZE // 12)),
    "text.json": '{"linkwork": 1, "bodies": [{"name": "%s"}]}' % ("x" * SIZE),
    "lists.yaml": "linkwork: 1\nbodies: [%s []]" % ("[]," * (SIZE // 3)),
    "lines.yaml": "linkwork: 1\nbodies:\n" + "- a\n" * (SIZE // 4),
    "repeated.yaml": "linkwork: 1\n" + "a: 1\n" * (SIZE // 5),
    "elements.urdf": "<robot name='a'>%s</robot>" % ("<a/>" * (SIZE // 4)),
    "text.urdf": "<robot name='a'>%s</robot>" % ("x&amp;\n" * (SIZE // 7)),
    "attributes.urdf": "<robot name='a'><a %s/></robot>" % "".join(f'b{k}="1" ' for k in range(SIZE // 10)),
    "links.urdf": "<robot name='a'>%s</robot>" % ("<link name='l'/>" * (SIZE // 16)),
    "elements.sdf": "<sdf version='1.6'>%s</sdf>" % ("<a/>" * (SIZE // 4)),
}


@pytest.mark.parametrize("name", FILES)
def test_a_file_takes_no_more_than_forty_times_its_size(name: str, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_text(FILES[name])
    read = {".urdf": lw.import_urdf, ".sdf": lw.import_sdf}.get(path.suffix, lw.Model.load)
    tracemalloc.start()
    try:
        with pytest.raises(lw.ModelFileError) as caught:
            read(path)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak <= 40 * path.stat().st_size + 50e6
    assert len(caught.value.faults) <= 22 and len(str(caught.value)) < 20_000
