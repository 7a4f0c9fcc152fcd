# ruff: noqa: UP031, braces are those of JSON
"""Files of 150 kB that are made to take memory: none takes more than forty times its size."""

from __future__ import annotations

import cProfile
import pstats
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


def link(name: str) -> str:
    return (
        f"<link name='{name}'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial></link>"
    )


def chain(count: int, kind: str) -> str:
    """Of URDF; from its end to its beginning, which is the worst order to read it in."""
    joints = [
        f"<joint name='j{k}' type='{kind}'><parent link='l{k}'/><child link='l{k + 1}'/></joint>"
        for k in reversed(range(count))
    ]
    return f"<robot name='a'>{''.join(link(f'l{k}') for k in range(count + 1))}{''.join(joints)}</robot>"


def bodies(count: int) -> str:
    """Of MJCF."""
    body = "<body name='b%d'><joint type='hinge'/><geom type='sphere' size='1'/></body>"
    return f"<mujoco><worldbody>{''.join(body % k for k in range(count))}</worldbody></mujoco>"


GROWING = {
    "fixed.urdf": lambda count: chain(count, "fixed"),
    "moving.urdf": lambda count: chain(count, "continuous"),
    "bodies.xml": bodies,
}


@pytest.mark.parametrize("name", GROWING)
def test_four_times_the_file_takes_four_times_the_work(name: str, tmp_path: Path) -> None:
    path = tmp_path / name
    read = lw.import_mjcf if path.suffix == ".xml" else lw.import_urdf

    def calls(count: int) -> int:
        path.write_text(GROWING[name](count))
        profile = cProfile.Profile()
        profile.runcall(read, path)
        return pstats.Stats(profile).total_calls  # type: ignore[attr-defined, no-any-return]

    calls(5)  # what is imported at the first time
    assert calls(240) < 4.4 * calls(60)
