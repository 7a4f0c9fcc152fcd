"""A comparison on disk while it goes on, so that one that was interrupted continues where it was.

folder/comparison.json   what is compared: the model's hash, t_end, the reference asked for
folder/reference.npz     the reference solution, replaced only when a new one is complete
folder/cells.jsonl       one finished cell a line, brought to the disk at once
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np

from linkwork.accuracy.measures import Sampled, Scales
from linkwork.comparison.choices import Cell
from linkwork.comparison.order import OrderStudy, Study
from linkwork.comparison.reference import Reference
from linkwork.comparison.runs import Outcome
from linkwork.errors import FileError, unwritable

__all__ = ["Store"]


class Store:
    """A folder with the finished cells of one comparison.

    FileError: it cannot be written, or holds a comparison of something else.
    """

    def __init__(self, folder: str | os.PathLike[str], identity: Mapping[str, Any]) -> None:
        self.folder = Path(folder)
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            self._claim(dict(identity))
        except OSError as error:
            raise self._unwritable(error) from error

    def reference(self) -> Reference | None:
        """As stored; None where there is none, or half of one."""
        try:
            with np.load(self.folder / "reference.npz", allow_pickle=False) as arrays:
                facts = json.loads(str(arrays["facts"]))
                motion = Sampled(*(arrays[name] for name in ("t", "q", "v", "force", "torque")))
        except (OSError, ValueError, KeyError, EOFError, BadZipFile):
            return None
        return Reference(**{**facts, "motion": motion, "scales": Scales(**facts["scales"])})

    def keep_reference(self, reference: Reference) -> None:
        facts = {name: value for name, value in vars(reference).items() if name not in ("motion", "scales")}
        text = json.dumps({**facts, "scales": asdict(reference.scales)})
        beside = self.folder / "reference.part.npz"
        try:
            np.savez(beside, facts=np.array(text), **vars(reference.motion))
            os.replace(beside, self.folder / "reference.npz")
        except OSError as error:
            raise self._unwritable(error) from error

    def found(self) -> dict[str, Outcome | OrderStudy]:
        """By the key of their cell or study; a line that was cut off with the process does not count."""
        found: dict[str, Outcome | OrderStudy] = {}
        try:
            lines = (self.folder / "cells.jsonl").read_text().splitlines()
        except FileNotFoundError:
            return {}
        for line in lines:
            try:
                record = json.loads(line)
                kept = record["found"]
                found[record["key"]] = OrderStudy(**kept) if "floors" in kept else Outcome.from_figures(kept)
            except (ValueError, KeyError, TypeError):
                continue
        return found

    def keep(self, item: Cell | Study, found: Outcome | OrderStudy) -> None:
        """FileError: the disk is full, say; what was kept before stays readable."""
        line = json.dumps({"key": item.key, "found": asdict(found)})
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
            stored = json.loads(path.read_text())
        except (FileNotFoundError, ValueError):
            path.write_text(json.dumps(identity, indent=2) + "\n")
            return
        for name, value in identity.items():
            if stored.get(name) != value:
                raise FileError(
                    f"folder '{self.folder}': holds a comparison with {name} {stored.get(name)!r}, not "
                    f"{value!r}; give another folder, or remove this one",
                    code="other_comparison",
                )

    def _unwritable(self, error: OSError) -> FileError:
        return unwritable("folder", self.folder, error)
