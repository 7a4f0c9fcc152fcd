"""Warnings of elements that a motion took to where they are others than they are meant to be."""

from __future__ import annotations

from linkwork.results.result import Result
from linkwork.running.folded_joints import warn_of_folded_joints
from linkwork.running.lifting_discs import note_lifting_discs
from linkwork.running.tilted_axes import warn_of_tilted_axes
from linkwork.running.turned_bushings import warn_of_turned_bushings

__all__ = ["warn_of_what_frames_show"]

#: Each gives a LinkworkWarning, or a note in the summary, as far as the frames of a result tell, also of one
#: that failed.
LOOKS = (warn_of_tilted_axes, warn_of_folded_joints, warn_of_turned_bushings, note_lifting_discs)


def warn_of_what_frames_show(result: Result) -> None:
    """LinkworkWarning: of elements that are not what they are meant to be in some of the frames."""
    for look in LOOKS:
        look(result)
