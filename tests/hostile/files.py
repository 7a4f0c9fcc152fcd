"""Files that are not what was written: results, model files of all formats, folders of studies.

Each is a part of `run.py`: it returns how many trials it was.
"""

from __future__ import annotations

import functools
import json
import random
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

import linkwork as lw
import mutation
from children import Failure, guarded_files
from linkwork import mechanisms
from linkwork.comparison.store import Store as ComparisonStore
from linkwork.results import writing

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "python"))

from recorded import assert_whole_or_says_so

SMALL = ("pendulum", "four_bar", "bricard", "heavy_top", "bennett", "spatial_slider_crank")

#: Where a part of an HDF5 file begins.
MARKS = (b"GCOL", b"HEAP", b"TREE", b"SNOD", b"OHDR", b"FRHP", b"\x89HDF")


def written(rng: random.Random, path: Path) -> lw.Result:
    """A result in a file, in small pieces or large ones, as a run writes it or at once; and in memory."""
    usual, writing.CHUNK_BYTES = writing.CHUNK_BYTES, rng.choice([(256, 4096), writing.CHUNK_BYTES])
    model = getattr(mechanisms, rng.choice(SMALL))()
    choices = rng.choice([{"step": 1e-3}, {"rtol": 1e-6}, {"step": 1e-3, "verify": True}])
    output = path if rng.random() < 0.5 else None
    try:
        result = lw.simulate(
            model, 0.1, record_every=1, progress=False, on_inaccurate="pass", output=output, **choices
        )
        if output is None:
            result.save(path)
            return result
        return in_memory(result)
    finally:
        writing.CHUNK_BYTES = usual


def in_memory(result: lw.Result) -> lw.Result:
    fields = {name: result.recorded(name) for name in result.header.frame_shapes()}
    return lw.Result(fields, result.header, result.statistics, events=result.events)


def damage(rng: random.Random, folder: Path) -> int:
    """A result with other bits, without a part or its end, forty times: what is whole, or a FileError."""
    whole = folder / "whole.h5"
    original = written(rng, whole)
    content = whole.read_bytes()
    marks = [k for mark in MARKS for k in occurrences(content, mark)]

    def make(place: Path) -> Path:
        path = place / "damaged.h5"
        path.write_bytes(damaged(rng, content, marks))
        return path

    def read(path: Path) -> None:
        try:
            found = lw.Result.load(path)
            assert_whole_or_says_so(found, original)
            if rng.random() < 0.1 and len(found):  # as `linkwork repair` does
                found.save(path.with_suffix(".repaired.h5"), overwrite=True)
                assert_whole_or_says_so(lw.Result.load(path.with_suffix(".repaired.h5")), original)
        except lw.FileError:
            return

    guarded_files(40, folder / "damaged", make, read)
    return 40


def damaged(rng: random.Random, whole: bytes, marks: list[int]) -> bytes:
    content = bytearray(whole)
    if rng.random() < 0.4:  # a block, most often where HDF5 keeps its own
        size, other = rng.choice([8, 16, 64, 256, 1024, 4096]), rng.choice(marks)
        at = rng.choice(marks) + 8 * rng.randrange(-40, 400)
        at = max(0, min(len(content) - size, at if rng.random() < 0.7 else rng.randrange(len(content))))
        piece = bytes(whole[other : other + size].ljust(size, b"\0"))
        content[at : at + size] = rng.choice([bytes(size), b"\xff" * size, rng.randbytes(size), piece])
        return bytes(content)
    for _ in range(rng.choice([1, 1, 4])):
        near = max(0, rng.choice(marks) + rng.randrange(-64, 512))
        place = min(len(content) - 1, near) if rng.random() < 0.3 else rng.randrange(len(content))
        content[place] ^= 1 << rng.randrange(8)
    if rng.random() < 0.3:
        del content[rng.randrange(len(content)) :]
    return bytes(content)


def occurrences(content: bytes, mark: bytes) -> Iterator[int]:
    at = content.find(mark)
    while at >= 0:
        yield at
        at = content.find(mark, at + 1)


def model_file(rng: random.Random, folder: Path) -> int:
    """Mutated files of all five formats, two hundred: read, or refused in words."""
    mutation.read_all()
    guarded_files(200, folder / "mutated", lambda place: mutation.mutated(rng, place), mutation.read_and_run)
    return 200


# --- folders ----------------------------------------------------------------------------------------------


def kept(root: Path) -> dict[str, str]:
    """What the folder of a comparison or a study gives for what is asked for here, by name. FileError."""
    if root.name == "comparison":
        identity = {"model_hash": mechanisms.pendulum().hash(), "t_end": 0.1, "reference": None}
        store = ComparisonStore(root, identity)
        found = {key: json.dumps(asdict(it)) for key, it in store.found().items()}
        reference = store.reference()
        return found | ({} if reference is None else {"reference": repr(reference)})
    study = lw.sweep(mechanisms.pendulum(), **STUDY, directory=root, gather=True)
    return {str(k): repr(study.outputs["x"][k]) for k in range(len(study)) if study.status[k] == "finished"}


STUDY: dict[str, Any] = {
    "parameters": {"bob.mass": [1.0, 2.0, 3.0]}, "outputs": {"x": "energy_error.abs_max"}, "t_end": 0.1,
    "step": 1e-2, "progress": False,
}  # fmt: skip


@functools.cache
def contents(name: str) -> dict[str, bytes]:
    """The files of a folder in which a comparison, or a study, was kept."""
    with tempfile.TemporaryDirectory() as place:
        root = Path(place) / name
        if name == "comparison":
            lw.compare("pendulum", 0.1, steps=[2e-2, 1e-2], integrators=["rk4"], processes=1, progress=False,
                       resume=root)  # fmt: skip
        else:
            lw.sweep(mechanisms.pendulum(), **STUDY, processes=1, directory=root)
        return {str(it.relative_to(root)): it.read_bytes() for it in root.rglob("*") if it.is_file()}


def stores(rng: random.Random, folder: Path) -> int:
    """Damaged folders of comparisons and studies, twenty: what was kept, or less of it, or a FileError."""
    root = folder / rng.choice(["comparison", "study"])
    files = contents(root.name)

    def write(_: Path) -> Path:
        for name, content in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_bytes(content)
        return root

    def make(place: Path) -> Path:
        name, written = rng.choice(list(files)), write(place)
        (written / name).write_bytes(spoiled(rng, files[name]))
        return written / name

    whole = kept(write(folder))

    def read(_: Path) -> None:
        try:
            found = kept(root)
        except lw.FileError:
            return
        if not found.items() <= whole.items():
            raise Failure(f"{found}, not {whole}")

    guarded_files(20, root, make, read)
    return 20


#: Is in none of these files.
WRONG = (b"", b"[]", b"null", b"1", b'"x"', b"[" * 100_000, b"\xff\xfe", b"{}", b'{"identity": [1]}')


def spoiled(rng: random.Random, content: bytes) -> bytes:
    """Other bits, another piece of text, or a part only."""
    changed = bytearray(content)
    action = rng.randrange(4)
    if action == 0:
        changed[rng.randrange(len(changed))] ^= 1 << rng.randrange(8)
    elif action == 1:
        del changed[rng.randrange(len(changed)) :]
    elif action == 2:
        mutation.mutate_bytes(rng, changed)
    else:
        changed[:] = rng.choice(WRONG)
    return bytes(changed)
