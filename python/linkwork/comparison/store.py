"""A comparison on disk while it goes on, so that one that was interrupted continues where it was.

folder/comparison.json   what is compared: the model's hash, t_end, the reference asked for
folder/reference.npz     the reference solution, replaced only when a new one is complete
folder/cells.jsonl       one finished cell a line with its digest, brought to the disk at once
"""

from __future__ import annotations

import json
import os
import zlib
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any

import numpy as np

from linkwork.accuracy.measures import Sampled, Scales
from linkwork.comparison.choices import Cell
from linkwork.comparison.order import OrderStudy, Study
from linkwork.comparison.reference import Reference
from linkwork.comparison.runs import Outcome
from linkwork.errors import FileError, cause, unwritable

__all__ = ["Store"]

#: What a line raises that is not what was written.
DAMAGE = (ValueError, LookupError, TypeError, AttributeError, RecursionError)


class Store:
    """A folder with the finished cells of one comparison.

    FileError: it cannot be written or read, or holds a comparison of something else, or of nobody knows what.
    """

    def __init__(self, folder: str | os.PathLike[str], identity: Mapping[str, Any]) -> None:
        self.folder = Path(folder)
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            self._claim(dict(identity))
        except OSError as error:
            raise self._unwritable(error) from error

    def reference(self) -> Reference | None:
        """As stored; None where there is none, or a damaged one."""
        try:
            with np.load(self.folder / "reference.npz", allow_pickle=False) as arrays:
                facts = json.loads(str(arrays["facts"]))
                motion = Sampled(*(arrays[name] for name in ("t", "q", "v", "force", "torque")))
                scales = Scales(*(arrays[f"scales.{it.name}"] for it in fields(Scales)))
            return Reference(**{**facts, "motion": motion, "scales": scales})
        except Exception:  # NumPy and zipfile raise whatever they come upon
            return None

    def keep_reference(self, reference: Reference) -> None:
        facts = {name: value for name, value in vars(reference).items() if name not in ("motion", "scales")}
        scales = {f"scales.{name}": values for name, values in vars(reference.scales).items()}
        beside = self.folder / "reference.part.npz"
        try:
            np.savez(beside, facts=np.array(json.dumps(facts)), **vars(reference.motion), **scales)
            os.replace(beside, self.folder / "reference.npz")
        except OSError as error:
            raise self._unwritable(error) from error

    def found(self) -> dict[str, Outcome | OrderStudy]:
        """By the key of their cell or study; a line that is damaged, or cut off, does not count."""
        found: dict[str, Outcome | OrderStudy] = {}
        try:
            lines = (self.folder / "cells.jsonl").read_bytes().splitlines()
        except FileNotFoundError:
            return {}
        except OSError as error:
            raise FileError(f"folder '{self.folder}': {cause(error)}", code="not_readable") from error
        for line in lines:
            with suppress(*DAMAGE):
                record = json.loads(line)
                if "digest" not in record or record.pop("digest") == _digest(record):
                    kept = record["found"]
                    found[record["key"]] = (
                        OrderStudy(**kept) if "floors" in kept else Outcome.from_figures(kept)
                    )
        return found

    def keep(self, item: Cell | Study, found: Outcome | OrderStudy) -> None:
        """FileError: the disk is full, say; what was kept before stays readable."""
        record = {"key": item.key, "found": asdict(found)}
        line = json.dumps({**record, "digest": _digest(record)})
        try:
            with open(self.folder / "cells.jsonl", "a", encoding="utf-8") as file:
                file.write(("" if self._whole_lines() else "\n") + line + "\n")
                file.flush()
                os.fsync(file.fileno())
        except OSError as error:
            raise self._unwritable(error) from error

    def _whole_lines(self) -> bool:
        """False after a line that was cut off."""
        try:
            with open(self.folder / "cells.jsonl", "rb") as file:
                if file.seek(0, os.SEEK_END) == 0:
                    return True
                file.seek(-1, os.SEEK_END)
                return file.read() == b"\n"
        except FileNotFoundError:
            return True

    def _claim(self, identity: dict[str, Any]) -> None:
        path = self.folder / "comparison.json"
        try:
            stored = json.loads(path.read_bytes())
        except FileNotFoundError:
            if any((self.folder / name).exists() for name in ("cells.jsonl", "reference.npz")):
                raise self._unknown("is not there, beside cells that are") from None
            beside = path.with_suffix(".part.json")
            beside.write_text(json.dumps(identity, indent=2) + "\n")
            os.replace(beside, path)
            return
        except (ValueError, RecursionError):
            stored = None
        if not isinstance(stored, dict):
            raise self._unknown("is none of a comparison")
        for name, value in identity.items():
            if stored.get(name) != value:
                raise FileError(
                    f"folder '{self.folder}': holds a comparison with {name} {stored.get(name)!r}, not "
                    f"{value!r}; give another folder, or remove this one",
                    code="other_comparison",
                )

    def _unwritable(self, error: OSError) -> FileError:
        return unwritable("folder", self.folder, error)

    def _unknown(self, why: str) -> FileError:
        return FileError(
            f"folder '{self.folder}': its comparison.json {why}; give another folder, or remove this one",
            code="other_comparison",
        )


def _digest(record: Mapping[str, Any]) -> int:
    return zlib.crc32(json.dumps(record).encode())
