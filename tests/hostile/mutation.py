"""Mutated files of all formats: by bytes, and by the parts that they are made of."""

from __future__ import annotations

import copy
import functools
import json
import random
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import yaml
from children import Failure
from linkwork import mechanisms

#: What no one means, in place of what somebody did.
VALUES: tuple[Any, ...] = (
    None, True, 0, -1, 1e308, -1e-320, 10**40, 2**63, "", "x", "ground", "1 0 0", "nan", "inf", "0 0 0", [],
    {}, [[]], [0, 0, 0], [1, 1], "\u202e", "a" * 2000, "../x", "file:///dev/zero", float("nan"), float("inf"),
)  # fmt: skip

#: That mean something in one of the formats.
PIECES = (
    b"[", b"{", b"]", b": ", b"\n", b"1e999", b'"', b"\0", b"- ", b"<", b"/>", b"&a;", b"<!--", b"]]>",
    b"\xff", b"*a", b"!!x ", b"? ", b"---\n", b"\t",
)  # fmt: skip

URDF = """<robot name="r"><link name="base"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0"
iyy="1" iyz="0" izz="1"/></inertial><visual><geometry><box size="1 1
1"/></geometry></visual></link><link name="arm"><inertial> <origin xyz="0.5 0 0" rpy="0 0.1 0"/><mass
value="2"/><inertia ixx=".1" ixy="0" ixz="0" iyy=".2" iyz="0" izz=".2"/> </inertial></link><link
name="tip"><inertial><mass value=".1"/><inertia ixx=".1" ixy="0" ixz="0" iyy=".1" iyz="0"
izz=".1"/></inertial></link><joint name="a" type="revolute"><parent link="base"/><child
link="arm"/><origin xyz="0 0 1" rpy="0 0 0"/><axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="1"
velocity="1"/><dynamics damping=".1" friction="0"/></joint><joint name="b" type="prismatic"><parent
link="arm"/><child link="tip"/><axis xyz="1 0 0"/><limit effort="1" velocity="1"/><mimic joint="a"
multiplier="2"/></joint></robot>"""

SDF = """<sdf version="1.9"><world name="w"><gravity>0 0 -9.8</gravity><model name="m"><link
name="a"><pose>0 0 1 0 0 0
</pose><inertial><mass>1</mass><inertia><ixx>.1</ixx><iyy>.1</iyy><izz>.1</izz></inertia></inertial></link>
<link name="b"><pose relative_to="a">1 0 0 0 0.1
0</pose><inertial><mass>1</mass></inertial></link><frame name="f" attached_to="b"><pose>0 0 1 0 0
0</pose></frame><joint name="j" type="revolute"><parent>a</parent><child>b</child> <axis><xyz
expressed_in="f">0 1 0</xyz><dynamics><damping>.1</damping></dynamics></axis></joint><joint name="k"
type="fixed"><parent>world</parent><child>a</child></joint></model></world></sdf>"""

MJCF = """<mujoco><compiler angle="radian"/><option gravity="0 0 -9.8"/><default><geom
density="500"/><default class="d"> <joint damping=".1"/></default></default><worldbody><body name="a"
pos="0 0 1"><joint name="j" type="hinge" axis="0 1 0"/><geom name="g" type="capsule" fromto="0 0 0 1 0
0" size=".05"/><body name="b" pos="1 0 0" childclass="d"><joint name="k" type="slide" axis="1 0 0"
stiffness="10"/><inertial pos="0 0 0" mass="1" diaginertia=".1 .1 .1"/><site name="s" pos="0 0
.1"/></body></body></worldbody><equality><connect body1="b" anchor="0 0 0"/></equality><tendon><fixed
name="t"><joint joint="j" coef="1"/></fixed></tendon></mujoco>"""

#: Of other formats; and files of all of them, with every kind of joint, force and function that there is.
SUFFIXES = (".yaml", ".json", ".urdf", ".sdf", ".xml")
TEXTS = {".urdf": [URDF], ".sdf": [SDF], ".xml": [MJCF]}
OTHERS = Path(__file__).resolve().parents[1] / "python"
FOLDERS = ("first_release", "robots")

MODELS = (
    "four_bar", "stewart_platform", "double_wishbone", "planetary_gear", "pendulum", "rolling_disc",
    "flyball_governor", "heavy_top", "tracked_chain",
)  # fmt: skip

#: None of it is much longer: what is tried is what can be wrong, not how much [bytes].
LONGEST = 60_000


def importer(path: Path) -> lw.Model:
    read: Callable[..., Any] = {".urdf": lw.import_urdf, ".sdf": lw.import_sdf, ".xml": lw.import_mjcf}[
        path.suffix
    ]
    return read(path).model  # type: ignore[no-any-return]


@functools.cache
def texts(suffix: str) -> tuple[str, ...]:
    """What is mutated, of one format."""
    others = [path for name in FOLDERS for path in sorted((OTHERS / name).glob(f"*{suffix}"))]
    found = [*TEXTS.get(suffix, ()), *(path.read_text() for path in others)]
    if suffix not in TEXTS:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"model{suffix}"
            for name in MODELS:
                getattr(mechanisms, name)().save(path, overwrite=True)
                found.append(path.read_text())
    return tuple(text for text in found if len(text) <= LONGEST)


@functools.cache
def packed_tree(suffix: str, number: int) -> str:
    """Of one of the `texts`, as JSON, from which it is made quickly."""
    text = texts(suffix)[number]
    return json.dumps(json.loads(text) if suffix == ".json" else yaml.safe_load(text))


@functools.cache
def read_all() -> None:
    """What is kept, and imported, before the first file is mutated."""
    with tempfile.TemporaryDirectory() as folder:
        for suffix in SUFFIXES:
            for number, text in enumerate(texts(suffix)):
                path = Path(folder) / f"whole{suffix}"
                path.write_text(text)
                read_and_run(path)
                if suffix not in TEXTS:
                    packed_tree(suffix, number)


# --- trees ------------------------------------------------------------------------------------------------


def places(tree: Any) -> list[tuple[Any, Any]]:
    """Every (container, key) below."""
    found: list[tuple[Any, Any]] = []
    todo = [tree]
    while todo:
        it = todo.pop()
        keys = list(it) if isinstance(it, dict) else list(range(len(it)))
        found += [(it, key) for key in keys]
        todo += [it[key] for key in keys if isinstance(it[key], dict | list)]
    return found


def mutate_tree(rng: random.Random, tree: Any) -> None:
    for _ in range(rng.choice([1, 1, 2, 6])):
        found = places(tree)
        if not found:
            return
        (container, key), (other, name) = rng.choice(found), rng.choice(found)
        action = rng.randrange(5)
        if action == 0:
            container[key] = copy.deepcopy(rng.choice(VALUES))
        elif action == 1:
            del container[key]
        elif action == 2:
            container[key] = json.loads(json.dumps(other[name]))
        elif action == 3 and isinstance(container, list):
            container.insert(key, json.loads(json.dumps(container[key])))
        elif isinstance(container, dict):
            container[rng.choice(["x", "name", "kind", "", "body", str(key) + "s"])] = container.pop(key)


def mutate_xml(rng: random.Random, root: ET.Element) -> None:
    for _ in range(rng.choice([1, 1, 2, 6])):
        parents = [it for it in root.iter() if len(it)]
        everything = list(root.iter())
        one = rng.choice(everything)
        action = rng.randrange(6)
        if action == 0 and one.attrib:
            one.set(rng.choice(list(one.attrib)), str(rng.choice(VALUES)).replace("\0", ""))
        elif action == 1 and one.attrib:
            del one.attrib[rng.choice(list(one.attrib))]
        elif action == 2 and parents:
            parent = rng.choice(parents)
            parent.remove(rng.choice(list(parent)))
        elif action == 3 and parents:
            parent, given = rng.choice(parents), rng.choice(everything)
            parent.insert(rng.randrange(len(parent) + 1), ET.fromstring(ET.tostring(given)))
        elif action == 4:
            one.tag = rng.choice(everything).tag
        else:
            one.text = str(rng.choice(VALUES))


def mutate_bytes(rng: random.Random, content: bytearray) -> None:
    for _ in range(rng.choice([1, 2, 20])):
        place = rng.randrange(len(content) + 1)
        action = rng.randrange(4)
        if action == 0 and place < len(content):
            content[place] = rng.randrange(256)
        elif action == 1:
            del content[place : place + rng.randrange(1, 40)]
        elif action == 2:
            content[place:place] = rng.choice(PIECES)
        else:
            piece = content[place : place + rng.randrange(1, 200)]
            content[place:place] = piece * rng.choice([1, 2, 50])


# --- what is done with them -------------------------------------------------------------------------------


def mutated(rng: random.Random, folder: Path) -> Path:
    """A file that is not what it was."""
    suffix = rng.choice(SUFFIXES)
    path, number = folder / f"mutated{suffix}", rng.randrange(len(texts(suffix)))
    text = texts(suffix)[number]
    if rng.random() < 0.5:
        content = bytearray(text.encode())
        mutate_bytes(rng, content)
        path.write_bytes(content)
    elif suffix in TEXTS:
        root = ET.fromstring(text)
        mutate_xml(rng, root)
        path.write_bytes(ET.tostring(root))
    else:
        tree = json.loads(packed_tree(suffix, number))
        mutate_tree(rng, tree)
        path.write_text(json.dumps(tree) if suffix == ".json" else as_yaml(tree))
    return path


def as_yaml(tree: Any) -> str:
    dumper = getattr(yaml, "CSafeDumper", yaml.SafeDumper)
    return yaml.dump(tree, Dumper=dumper, allow_unicode=True)  # type: ignore[no-any-return]


def read_and_run(path: Path) -> None:
    """Is read, or refused in words; what is read is computed, or refused in words, and nothing else."""
    try:
        model = lw.Model.load(path) if path.suffix in (".yaml", ".json") else importer(path)
    except lw.FileError as error:
        if len(getattr(error, "faults", ())) > 23 or len(str(error)) > 30_000:
            raise Failure(f"{len(str(error))} characters of faults") from error
        return
    except lw.LinkworkError:
        return
    try:
        system = lw.System(model)
        rates = system.derivative(0.0, system.initial_state())
    except lw.LinkworkError:
        return
    if not np.isfinite(rates).all():
        raise Failure("rates that are not finite")
