"""A study on disk: each case once, whoever ran it, whatever was interrupted.

directory/study.json          what is studied; seed, versions, machine of who began it
directory/cases/<hash>.jsonl  the cases of one task: a line for the task with a digest of the others, and one
                              a case with its key, values, status and outputs

Files are written beside, brought to the disk and renamed: they are whole or not there, also on file systems
of a network, and nobody locks anything. A file's name follows from its cases: two who run the same write the
same file. Of a case that is in several, one counts: one that finished, where another try of it failed.
"""

from __future__ import annotations

import errno
import json
import os
import re
import uuid
import zlib
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from linkwork import arguments
from linkwork.errors import FileError, cause, unwritable, warn
from linkwork.fingerprints import digest, plain
from linkwork.studies.cases import Answer, Run
from linkwork.studies.collected import Collected

__all__ = ["Store", "stored_identity", "write_whole"]

#: Of the format.
VERSION = 1

#: What reading JSON raises that is not what was written.
DAMAGE = (ValueError, KeyError, TypeError, RecursionError)

#: What reading says of a name that is none of a file: a link to nowhere or to itself, a folder.
NO_FILE = (errno.ENOENT, errno.ELOOP, errno.EISDIR, errno.ENOTDIR)


class Store:
    """A directory with the cases of one study. FileError: it cannot be written, belongs to another, or is not
    there though it is not to be a `new` one.
    """

    def __init__(
        self, directory: Any, identity: Mapping[str, Any], about: Mapping[str, Any], *, new: bool = True
    ) -> None:
        self.directory = arguments.path(directory, "directory", folder=True)
        if not new and not (self.directory / "study.json").is_file():
            raise FileError(
                f"directory '{self.directory}': there is no study to gather; check the path, or run its "
                "shards first",
                code="not_found",
            )
        self._cases = self.directory / "cases"
        try:
            self._claim(dict(identity), dict(about))
            self._cases.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise unwritable("directory", self.directory, error) from error

    def example(self) -> Mapping[str, Any]:
        """Key and values of a case and the hash of its model, of who began the study; nothing where they are
        gone, or that case had no model then."""
        stored = json.loads((self.directory / "study.json").read_text(encoding="utf-8"))
        found = stored.get("example")
        return (
            found
            if isinstance(found, dict) and {"key", "values"} <= found.keys() and found.get("model")
            else {}
        )

    def keep(self, answer: Answer) -> None:
        """FileError: the disk is full, say; what was kept before stays readable."""
        lines = [json.dumps({**vars(run), "values": plain(run.values)}) for run in answer.runs]
        body = "\n".join(lines) + "\n"
        head = {"linkwork_cases": VERSION, "cases": len(lines), "digest": zlib.crc32(body.encode()),
                "machine": dict(answer.machine)}  # fmt: skip
        name = digest([run.key for run in answer.runs])
        try:
            write_whole(self._cases / f"{name}.jsonl", json.dumps(head) + "\n" + body)
        except OSError as error:
            raise unwritable("directory", self.directory, error) from error

    def find(self, to: Collected) -> list[Mapping[str, Any]]:
        """Adds the cases that are there and wanted; the machines that ran them."""
        machines: list[Mapping[str, Any]] = []
        for machine, run in self._all():
            if to.wants(run):
                to.add(run)
                if machine not in machines:
                    machines.append(machine)
        return machines

    def _all(self) -> Iterator[tuple[Mapping[str, Any], Run]]:
        """LinkworkWarning: a damaged file, whose cases count as not there."""
        try:
            files = sorted(self._cases.glob("*.jsonl"))
            for file in files:
                machine, runs = _read(file)
                yield from ((machine, run) for run in runs)
        except OSError as error:
            raise FileError(f"directory '{self.directory}': {cause(error)}", code="not_readable") from error

    def _claim(self, identity: dict[str, Any], about: dict[str, Any]) -> None:
        path = self.directory / "study.json"
        try:
            stored = dict(json.loads(path.read_text(encoding="utf-8"))["identity"])
        except FileNotFoundError:
            self._refuse_strangers()
            self.directory.mkdir(parents=True, exist_ok=True)
            write_whole(path, json.dumps({"linkwork_study": VERSION, "identity": identity, **about},
                                         indent=2, default=str) + "\n")  # fmt: skip
            return
        except DAMAGE as error:
            raise FileError(
                f"directory '{self.directory}': its study.json is none of a study; give another directory",
                code="other_study",
            ) from error
        for name, value in identity.items():
            if stored.get(name) != value:
                other = "other" if name.endswith("s") else "another"
                raise FileError(
                    f"directory '{self.directory}': holds a study with {other} {name}"
                    f"{_difference(stored.get(name), value)}; give another directory, or remove this one",
                    code="other_study",
                )

    def _refuse_strangers(self) -> None:
        ours = re.compile(r"cases|(\.?study\.json.*)")  # of another who begins it at this moment
        if self.directory.is_dir() and not all(ours.fullmatch(it.name) for it in self.directory.iterdir()):
            raise FileError(
                f"directory '{self.directory}': holds something else than a study; give a new one",
                code="other_study",
            )


def stored_identity(directory: Any) -> Mapping[str, Any] | None:
    """Of the study that is there; None: there is none that can be read."""
    path = arguments.path(directory, "directory", folder=True) / "study.json"
    try:
        found: Mapping[str, Any] = json.loads(path.read_text(encoding="utf-8"))["identity"]
    except (OSError, *DAMAGE):
        return None
    return found


def _difference(stored: Any, value: Any) -> str:
    if isinstance(stored, dict) and isinstance(value, dict):
        names = sorted(name for name in stored.keys() | value.keys() if stored.get(name) != value.get(name))
        pairs = [f"{name} {_readable(stored, name)}, not {_readable(value, name)}" for name in names]
        return ": " + "; ".join(pairs)
    short = all(len(str(it)) <= 60 for it in (stored, value)) and not str(value).isalnum()
    return f": {stored!r}, not {value!r}" if short or isinstance(value, int | float) else ""


def _readable(options: Mapping[str, Any], name: str) -> str:
    """A value as it was given, of the text that counts; numbers are in hexadecimal there."""
    if name not in options:
        return "none"
    text = str(options[name])
    try:
        return f"{float.fromhex(text):g}" if "0x" in text else text[:60]
    except ValueError:
        return text[:60]


def _read(file: Path) -> tuple[Mapping[str, Any], Sequence[Run]]:
    try:
        head, _, body = file.read_text(encoding="utf-8").partition("\n")
        about = json.loads(head)
        if about["linkwork_cases"] != VERSION or about["digest"] != zlib.crc32(body.encode()):
            raise ValueError("digest")
        return about["machine"], [Run(**json.loads(line)) for line in body.splitlines()]
    except (*DAMAGE, OSError) as error:
        if isinstance(error, OSError) and error.errno not in NO_FILE:
            raise  # as of a server that does not answer
        warn(f"file '{file}': is damaged: its cases count as not there")
        return {}, []


def write_whole(path: Path, text: str) -> None:
    """Under its name only when it is on the disk. OSError."""
    beside = path.with_name(f".{path.name}.{uuid.uuid4().hex}")
    try:
        with open(beside, "w", encoding="utf-8") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.replace(beside, path)
    except OSError:
        beside.unlink(missing_ok=True)
        raise
