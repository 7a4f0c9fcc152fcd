"""What the summary of a run says of what outputs of it are, which their numbers do not tell."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from linkwork.errors import warn
from linkwork.motion.summary import excesses, impacts
from linkwork.results.last_state import LastState
from linkwork.results.result import Result
from linkwork.running.sampled_frames import listed
from linkwork.studies.outputs import Output

__all__ = ["MULTIPLIERS", "noted", "warn_of_notes"]

#: Of a motion that is kept.
MULTIPLIERS = Output("lambda", steps=(("get", "multipliers"),))


def noted(output: Output, result: Result) -> Output:
    """With what holds for it in every case that is like this one."""
    return replace(output, note=_left_open(output, result))


def warn_of_notes(result: Result | LastState, outputs: Sequence[Output]) -> None:
    """LinkworkWarning: each of the notes on a case, whose `outputs` have those on all cases already."""
    if isinstance(result, LastState):  # whose frames have nothing to show
        return
    for note in dict.fromkeys(filter(None, _notes(result, outputs))):
        warn(note)


def _notes(result: Result, outputs: Sequence[Output]) -> Iterator[str]:
    yield str(result.statistics.get("lifting_discs", ""))
    if found := excesses(result):
        yield f"violation_limit: {found}"
    if any(it.of_reactions for it in outputs):
        yield impacts(result)
    for output in outputs:
        if (note := _left_open(output, result)) != output.note:
            yield f"{output.label}: {note or 'its reactions are unique here'}"


def _left_open(output: Output, result: Result) -> str:
    """Where redundant equations leave reactions open that it takes, or that a function of the user's may."""
    if not output.of_reactions:
        return ""
    unique, names = result.header.reaction_unique, result.header.joint_names
    places = np.flatnonzero(~unique)
    if not output.by_user and output.steps[0] == ("get", "reaction"):
        given, named = output.steps[1][1:]
        joint = given[0] if given else dict(named)["name"]
        places = np.intersect1d(places, result.index("joint", joint))
    if not len(places):
        return ""
    who = listed([names[int(k)] for k in places])
    where = "where it takes reactions, those" if output.by_user else "reactions"
    return f"{where} of {who} are not unique, but shares of least norm"
