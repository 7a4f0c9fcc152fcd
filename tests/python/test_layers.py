"""The layers of the C++ library: a file includes its own layer and those to its left, nothing else."""

import re
from collections.abc import Iterator
from pathlib import Path

LAYERS = [
    "math", "model", "assembly", "linear", "constraints", "formulation", "integration", "ensemble",
    "bindings",
]  # fmt: skip
CPP = Path(__file__).resolve().parents[2] / "cpp"
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]')


def source_files() -> list[Path]:
    return sorted(path for path in CPP.rglob("*") if path.suffix in {".hpp", ".cpp", ".def"})


def layer_name(path: Path) -> str:
    """cpp/linkwork/<layer>/... or cpp/bindings/..."""
    parts = path.relative_to(CPP).parts
    return parts[1] if parts[0] == "linkwork" else parts[0]


def own_includes(file: Path) -> Iterator[tuple[int, Path]]:
    """(line, included file) of every include that means a file of ours: from cpp/, or from beside `file`."""
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), start=1):
        if found := INCLUDE.match(line):
            candidates = ((folder / found[1]).resolve() for folder in (file.parent, CPP))
            yield from ((number, path) for path in candidates if path.is_file() and path.is_relative_to(CPP))


def test_every_source_file_stands_in_a_layer() -> None:
    assert source_files()
    assert [str(file) for file in source_files() if layer_name(file) not in LAYERS] == []


def test_no_include_points_to_a_layer_on_the_right() -> None:
    upward = [
        f"{file.relative_to(CPP.parent)}:{number}: {layer_name(file)} includes {target.relative_to(CPP)}"
        for file in source_files()
        for number, target in own_includes(file)
        if LAYERS.index(layer_name(target)) > LAYERS.index(layer_name(file))
    ]
    assert not upward, "\n" + "\n".join(upward)
