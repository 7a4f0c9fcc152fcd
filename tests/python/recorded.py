"""What runs are compared by: every recorded number, and the methods whose steps follow tolerances."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import linkwork as lw
import numpy as np
from linkwork.integrators import METHODS, EmbeddedPair
from linkwork.motion.header import MODEL_NAMES
from linkwork.results.writing import MODEL_ARRAYS

PAIRS = [name for name, method in METHODS.items() if isinstance(method, EmbeddedPair)]
FIELDS = ("q", "v", "vdot", "lambda", "kinetic", "potential", "work", "violation", "history")


def bits_after(result: lw.Result, t: float) -> dict[str, bytes]:
    """Of all frames after t."""
    later = result.t > t * (1 + 1e-12)
    fields = {"t": result.t, **{name: result.recorded(name) for name in FIELDS}}
    return {name: np.ascontiguousarray(field[later]).tobytes() for name, field in fields.items()}


def without(names: set[str], table: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in table.items() if name not in names}


def assert_whole_or_says_so(found: lw.Result, original: lw.Result) -> None:
    """The header is that of the original, frames and events are its first ones; all, or some are missing."""
    count = len(found)
    for name, shape in original.header.frame_shapes().items():
        if not np.prod(shape):
            continue
        np.testing.assert_array_equal(found.recorded(name), original.recorded(name)[:count], err_msg=name)
    for name in MODEL_ARRAYS:
        np.testing.assert_array_equal(getattr(found.header, name), getattr(original.header, name))
    for name in MODEL_NAMES:
        assert list(getattr(found.header, name)) == list(getattr(original.header, name))
    left_out = {"missing"} if found.statistics else {"missing", "verdict"}
    assert without(left_out, found.manifest) == without(left_out, original.manifest)
    for ours, theirs in zip(found.events, original.events, strict=False):
        assert (ours.name, ours.t) == (theirs.name, theirs.t)
        np.testing.assert_array_equal(ours.q_before, theirs.q_before)
        np.testing.assert_array_equal(ours.v_after, theirs.v_after)
    if found.missing:
        assert not found.finished
        assert found.statistics in ({}, original.statistics)
    else:
        assert found.finished and found.statistics == original.statistics
        assert (count, len(found.events)) == (len(original), len(original.events))
