"""The elements and attributes of formats as they are published: what MuJoCo prints of MJCF, the description
files of SDF (Debian has them in the package sdformat-sdf), and lists of SDF and URDF in the folder robots.

A list has a line for each element, indented below the one that it is in, with its attributes. `+ FILE`
stands for the element that another description file is about.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from xml.etree import ElementTree

from linkwork.importers.coverage import Coverage
from robot_files import ROBOTS

#: The attributes of each element, which is given by the tags that lead to it, from the root's on.
Elements = Mapping[tuple[str, ...], set[str]]


def mujoco_schema(text: str) -> Elements:
    """Of the text that MuJoCo prints: tag (how often) attributes, continued in other lines."""
    out: dict[tuple[str, ...], set[str]] = {}
    path: tuple[str, ...] = ()
    for line in text.splitlines():
        found = re.match(r"( *)(\S+) \(.\)(.*)", line)
        if found:
            path = (*path[: len(found[1]) // 3], found[2].replace("(world)", ""))
        out.setdefault(path, set()).update((found[3] if found else line).split())
    return out


# --- SDF ----------------------------------------------------------------------------------------------------

#: Of one description file: each of its elements with its attributes, and "+ FILE" for others in it.
Block = dict[tuple[str, ...], set[str]]


def sdf_blocks(folder: Path) -> dict[str, Block]:
    """Of all versions of the format together that have a root, each in a folder of its own."""
    blocks: dict[str, Block] = {}
    for file in sorted(folder.glob("1.*/*.sdf")):
        root = ElementTree.parse(file).getroot()
        if (file.parent / "root.sdf").exists() and root.get("name"):
            _add(blocks.setdefault(file.name, {}), (), root)
    return blocks


def _add(block: Block, path: tuple[str, ...], element: ElementTree.Element) -> None:
    path = (*path, element.get("name", ""))
    block.setdefault(path, set()).update(one.get("name", "") for one in element.findall("attribute"))
    block[path].update(f"+{one.get('filename')}" for one in element.findall("include"))
    for child in element.findall("element"):
        if child.get("name"):
            _add(block, path, child)


def written(blocks: Mapping[str, Block]) -> str:
    """The list of the blocks."""
    lines = []
    for name, block in sorted(blocks.items()):
        lines.append(name)
        for path in sorted(block):
            indent = "  " * len(path)
            attributes = sorted(one for one in block[path] if not one.startswith("+"))
            lines.append(indent + " ".join([path[-1], *attributes]))
            lines += [f"{indent}  + {one[1:]}" for one in sorted(block[path]) if one.startswith("+")]
    return "\n".join(lines) + "\n"


def read(name: str) -> dict[str, Block]:
    """The blocks of a list in the folder robots."""
    blocks: dict[str, Block] = {}
    path: tuple[str, ...] = ()
    for line in (ROBOTS / name).read_text().splitlines():
        depth, words = (len(line) - len(line.lstrip())) // 2, line.split()
        if not words or words[0] == "#":
            continue
        if not depth:
            block = blocks.setdefault(words[0], {})
        elif words[0] == "+":
            block[path[: depth - 1]].add(f"+{words[1]}")
        else:
            path = (*path[: depth - 1], words[0])
            block[path] = set(words[1:])
    return blocks


def expanded(blocks: Mapping[str, Block], name: str) -> Elements:
    """The elements of a block, and of those in it; a block in itself is left out."""
    out: dict[tuple[str, ...], set[str]] = {}

    def add(name: str, around: tuple[str, ...], within: tuple[str, ...]) -> None:
        for path, words in blocks.get(name, {}).items():
            attributes = {one for one in words if not one.startswith("+")}
            out.setdefault((*around, *path), set()).update(attributes)
            for file in (one[1:] for one in words if one.startswith("+")):
                if file not in (*within, name):
                    add(file, (*around, *path), (*within, name))

    add(name, (), ())
    return out


# --- lists --------------------------------------------------------------------------------------------------


def keys(coverage: Coverage, elements: Elements) -> Iterator[str]:
    """The keys of all elements and attributes in a coverage's lists."""
    for path, attributes in elements.items():
        key = ""
        for tag in path[1:]:
            key = coverage.key(key, tag)
        if key:
            yield key
        yield from (f"{key}@{attribute}" for attribute in attributes)
