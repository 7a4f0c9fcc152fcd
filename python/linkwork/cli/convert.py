"""`linkwork convert`: a mechanism from one file to another, and what is lost on the way."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork
from linkwork import importers
from linkwork.cli import output as out
from linkwork.errors import FileError, counted
from linkwork.modeling import files
from linkwork.modeling.files.syntax import check_suffix
from linkwork.modeling.model import Model


def convert_and_show(
    source: str, target: str, as_json: bool, assemble: bool, options: dict[str, Any]
) -> None:
    """FileError: no such kind of file, or it cannot be read or written. ModelFileError: `source` is wrong.

    `assemble`: to a state at t = 0 that satisfies the joints. NotConvergedError: there is none near by.
    """
    check_suffix(target)
    out.check_writable(target, "model")
    notes: list[importers.Note] = []
    if importers.is_importable(source):
        imported = importers.read(source, **options)
        model, notes, simulation = imported.model, list(imported.notes), {}
    else:
        if Path(source).suffix.lower() not in files.SUFFIXES:
            known = ", ".join([*importers.IMPORTERS, *files.SUFFIXES])
            raise FileError(
                f"'{source}': extension '{Path(source).suffix}' is none of {known}", code="suffix"
            )
        file = files.read(source, Model)
        model, simulation = file.model, dict(file.simulation)
    if assemble:
        model = linkwork.assemble(model).model
    model.save(target, simulation=simulation, overwrite=True)
    if as_json:
        notes_as_data = [{"topic": n.topic, "subject": n.subject, "message": n.message} for n in notes]
        counts = {"bodies": model.body_count, "joints": model.joint_count, "forces": model.force_count}
        out.print_json({"source": source, "target": target, **counts, "notes": notes_as_data})
        return
    each = (model.body_count, "body"), (model.joint_count, "joint"), (model.force_count, "force")
    text = ", ".join(counted(*it) for it in each)
    out.print_pairs([("from", source), ("to", target), ("model", text)])
    if notes:
        rows = [(note.topic, note.subject, note.message) for note in notes]
        out.print_table(("topic", "what", "in the model"), rows, title="Not as in the file", left=3)
