"""Warnings of elements that a motion took to where they are others than they are meant to be."""

from __future__ import annotations

from linkwork.modeling.model import Model
from linkwork.results.result import Result
from linkwork.running.folded_joints import CONSTANT_VELOCITY, warn_of_folded_joints
from linkwork.running.lifting_discs import DISCS, note_lifting_discs
from linkwork.running.sampled_frames import kinds_in
from linkwork.running.tilted_axes import may_tilt, warn_of_tilted_axes
from linkwork.running.turned_bushings import BUSHINGS, warn_of_turned_bushings

__all__ = ["may_show_in_frames", "warn_of_what_frames_show"]

#: Each gives a LinkworkWarning, or a note in the summary, as far as the frames of a result tell, also of one
#: that failed.
LOOKS = (warn_of_tilted_axes, warn_of_folded_joints, warn_of_turned_bushings, note_lifting_discs)


def may_show_in_frames(model: Model) -> bool:
    """Whether there is a motion of it in which one of the LOOKS finds something."""
    core = model.compiled()
    return not kinds_in(core).isdisjoint(CONSTANT_VELOCITY | BUSHINGS | DISCS) or may_tilt(core)


def warn_of_what_frames_show(result: Result) -> None:
    """LinkworkWarning: of elements that are not what they are meant to be in some of the frames."""
    for look in LOOKS:
        look(result)
