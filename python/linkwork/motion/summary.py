"""A result in a few lines of plain text, and as the numbers behind them."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork.errors import counted
from linkwork.options import LEVELS

if TYPE_CHECKING:
    from linkwork.results.result import Result

#: Singular poses and joints listed.
LISTED = 4


def numbers(result: Result) -> dict[str, Any]:
    """The figures by which runs are compared; SI units. None where there is nothing to measure."""
    violation = result.violation.max(axis=0) if len(result) else [None] * 3
    energy = result.energy
    return {
        "bodies": len(result.body_names),
        "joints": len(result.joint_names),
        "constraints": result.header.row_count,
        "frames": len(result),
        "t_end": float(result.t[-1]) if len(result) else None,
        "max_violation": dict(zip(LEVELS, map(_number, violation), strict=True)),
        "energy_start": _number(energy[0]) if len(result) else None,
        "constraint_rank": result.header.row_count - len(result.redundant_rows),
        "unique_reactions": int(result.unique_reactions.sum()),
        "max_energy_error": _number(np.abs(result.energy_error).max()) if len(result) else None,
        "events": [{"name": it.name, "t": it.t} for it in result.events],
        "breaks": int(result.statistics.get("breaks", 0)),
        "impacts": int(result.statistics.get("impacts", 0)),
        "steps_with_breaks": int(result.statistics.get("steps_with_breaks", 0)),
        "violations": int(result.statistics.get("violations", 0)),
        "projections": int(result.statistics.get("projections", 0)),
        "singular_poses": int(result.statistics.get("singular_poses", 0)),
        "finished": result.finished,
        "damaged": result.damaged,
        "status": result.status,
        "verdict": _verdict(result),
    }


def text(result: Result) -> str:
    """One line for the model, the method, the violation, the energy and the effort."""
    return "\n".join(f"{label:<10}{content}" for label, content in lines(result) if content)


def lines(result: Result) -> list[tuple[str, str]]:
    """The summary as pairs of a label and what it says."""
    found, manifest = numbers(result), result.manifest
    model = manifest.get("model") or "model"
    names = {"bodies": "body", "joints": "joint", "constraints": "constraint"}
    counts = ", ".join(counted(found[name], one) for name, one in names.items())
    end = f"{result.t[0]:.6g} to {found['t_end']:.6g} s" if found["frames"] else "nothing"
    frames = counted(found["frames"], "frame")
    violation = ", ".join(f"{level} {_figure(value)}" for level, value in found["max_violation"].items())
    return [
        ("model", f"{model}: {counts}"),
        ("method", ", ".join(method(manifest.get("options", {})))),
        ("recorded", f"{end}, {frames}{_ending(result)}"),
        ("missing", "; ".join(result.missing) if result.damaged else ""),
        ("verdict", verdict_text(result)),
        ("violation", f"largest {violation}"),
        ("energy", f"{_figure(found['energy_start'])} J at the start, error at most "
                   f"{_figure(found['max_energy_error'])} J"),
        ("reactions", _reactions(found)),
        ("events", _events(result)),
        ("breaks", _breaks(result)),
        ("impacts", impacts(result)),
        ("discs", str(result.statistics.get("lifting_discs", ""))),
        ("singular", _singular(result)),
        ("redundant", _row_changes(result)),
        ("limits", excesses(result)),
        ("effort", _effort(result.statistics)),
    ]  # fmt: skip


def method(options: dict[str, Any], *, short: bool = False) -> list[str]:
    """The choices of a run in words; `short`: without what is of less interest."""
    words = [str(options[key]) for key in ("formulation", "stabilization", "integrator") if options.get(key)]
    if options.get("step"):
        words.append(f"step {options['step']:g} s")
    if options.get("rtol"):
        words.append(f"rtol {options['rtol']:g}")
    if options.get("rtol") and not short:
        words.append(f"atol {options['atol']:g}")
    if options.get("linear_solver") and not short:
        words.append(f"solver {options['linear_solver']}")
    return words


def _ending(result: Result) -> str:
    """Unless the run finished, and all of it is there."""
    if result.damaged:
        return "; the file was damaged"
    return "" if result.finished else ", not finished"


def _reactions(found: dict[str, Any]) -> str:
    """Only where redundant constraints leave some open."""
    left_open = found["joints"] - found["unique_reactions"]
    if not left_open:
        return ""
    rank = f"rank {found['constraint_rank']} of {found['constraints']}"
    return f"not unique in {left_open} of {found['joints']} joints ({rank}): shares of least norm"


def _events(result: Result) -> str:
    counts = Counter(it.name for it in result.events)
    return ", ".join(f"{name} {count} times" if count > 1 else name for name, count in counts.items())


def _breaks(result: Result) -> str:
    """Only of fixed steps, which go over times at which something jumps."""
    count = int(result.statistics.get("steps_with_breaks", 0))
    if not count:
        return ""
    steps = "1 step contains" if count == 1 else f"{count} steps contain"
    return f"{steps} break points, where the method loses its order; rtol makes steps that end there"


def impacts(result: Result) -> str:
    """Where drivers have struck the bodies."""
    count = int(result.statistics.get("impacts", 0))
    if not count:
        return ""
    noted = result.manifest.get("breaks", {}).get("impacts", ())
    times = [f"{t:.4g}" for t in sorted({it["t"] for it in noted})[: min(count, LISTED)]]
    when = f" at {', '.join(times)}{', ...' if count > LISTED else ''} s" if times else ""
    first = f", first as {noted[0]['of']} jumps" if noted else ""
    return f"bodies struck {counted(count, 'time')}{when}{first}; reactions are without the impulses"


def _singular(result: Result) -> str:
    """When the first singular poses came, and in which joints."""
    count, poses = int(result.statistics.get("singular_poses", 0)), result.singular_poses
    if not count or not poses:
        return ""
    times = ", ".join(f"{it.t:.4g}" for it in poses[:LISTED]) + (", ..." if count > LISTED else "")
    names = ", ".join(f"'{name}'" for name in poses[0].joints[:LISTED])
    more = ", ..." if len(poses[0].joints) > LISTED else ""
    return f"{count} {'pose' if count == 1 else 'poses'} passed at {times} s, first in {names}{more}"


def _row_changes(result: Result) -> str:
    """Where other equations became redundant in the course of the motion, or contradicted the others."""
    count, found = int(result.statistics.get("row_changes", 0)), result.statistics.get("contradiction")
    changes = [it for it in result.statistics.get("singularity_crossings", ()) if it["rows_changed"]]
    words = []
    if count and changes:
        names = ", ".join(f"'{name}'" for name in changes[0]["joints"][:LISTED])
        times = "once" if count == 1 else f"{count} times"
        words.append(f"other equations chosen {times}, first at {changes[0]['t']:.4g} s for those of {names}")
    if found:
        names = ", ".join(f"'{name}'" for name in found["joints"][:LISTED])
        words.append(f"{names} contradict each other by {found['largest']:.2g} from {found['t']:.4g} s on")
    return "; ".join(words)


def excesses(result: Result) -> str:
    """Where a violation_limit was passed."""
    found = result.statistics.get("excesses", ())
    if not found:
        return ""
    first, count = found[0], int(result.statistics["violations"])
    worst = f"first {first['level']} at {first['t']:.4g} s, {first['largest']:.2g} in '{first['joint']}'"
    projections = int(result.statistics["projections"])
    done = f"; projected {projections} times" if projections else ""
    return f"passed {count} times, {worst}{done}"


def verdict_text(result: Result) -> str:
    """The sentence, and the numbers behind it."""
    verdict = result.verdict
    if verdict is None:
        return ""
    if verdict.state is None:
        return verdict.sentence
    found = {"local error": verdict.local_error, "reactions": verdict.reactions, "energy": verdict.energy,
             "violation": verdict.violation}  # fmt: skip
    numbers = ", ".join(f"{name} {value:.0e}{'/s' if name == 'local error' else ''}".replace("e-0", "e-")
                        for name, value in found.items() if value is not None)  # fmt: skip
    told = f"; {verdict.left_out}" if verdict.left_out else ""
    return f"{verdict.sentence} ({numbers}; {len(verdict.steps)} of {verdict.steps_total:,} steps{told})"


def _verdict(result: Result) -> dict[str, Any] | None:
    """The numbers, without those of single steps."""
    verdict = result.verdict
    if verdict is None:
        return None
    return {name: value for name, value in verdict.numbers().items() if name != "steps"}


def _effort(statistics: dict[str, Any]) -> str:
    keys = ("steps", "rejected_steps", "evaluations", "factorizations", "iterations")
    counts = [f"{statistics[key]:,} {key.replace('_', ' ')}" for key in keys if statistics.get(key)]
    seconds = statistics.get("seconds")
    return ", ".join(counts) + (f" in {seconds:.3g} s" if isinstance(seconds, int | float) else "")


def _number(value: Any) -> float | None:
    return None if value is None else float(value)


def _figure(value: float | None) -> str:
    return "-" if value is None else f"{value:.3g}"
