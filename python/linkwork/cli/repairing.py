"""`linkwork repair`: what is whole of a result file, to a new one."""

from __future__ import annotations

from pathlib import Path

from linkwork.cli import output as out
from linkwork.errors import FileError
from linkwork.results.result import Result


def repair_and_show(source: str, target: str | None, as_json: bool) -> None:
    """FileError: no frame of `source` is whole, or `target` exists or cannot be written."""
    new = Path(target) if target is not None else Path(source).with_suffix(".repaired.h5")
    result = Result._read(source)  # no warning of what this is about to tell
    needed = bool(result.missing) or "digests" in result.manifest
    if needed:
        _check(source, new, result)
        result.save(new)
    if as_json:
        written = str(new) if needed else None
        end = float(result.t[-1]) if len(result) else None
        counts = {"frames": len(result), "t_end": end, "finished": result.finished}
        out.print_json({"source": source, "target": written, **counts, "missing": list(result.missing)})
        return
    end_text = f"{len(result)} frames" + (f" to t = {result.t[-1]:g} s" if len(result) else "")
    missing = "\n".join(result.missing) or "nothing"
    to = str(new) if needed else "no new file: this one is whole"
    out.print_pairs([("from", source), ("to", to), ("whole", end_text), ("missing", missing)])


def _check(source: str, new: Path, result: Result) -> None:
    if not len(result):
        raise FileError(
            f"result '{source}': no frame is whole; copy it again, or run again", code="no_frames"
        )
    if new.exists():
        raise FileError(
            f"output '{new}': exists already; remove it, or choose another by --output", code="exists"
        )
    out.check_writable(new)
