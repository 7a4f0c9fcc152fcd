"""For tests of robots from files of other programs."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType, ModuleType
from typing import Any

import linkwork as lw
import numpy as np
import pytest

ROBOTS = Path(__file__).parent / "robots"


def accelerations(model: lw.Model) -> np.ndarray:
    """v_dot of each body at t = 0 (n, 6)."""
    core = model.compiled()
    return lw.System(model).accelerations(0.0, core.q0, core.v0)[0].reshape(-1, 6)


def about(axis: tuple[float, float, float], angle: float) -> np.ndarray:
    """Rotation matrix."""
    return lw.rotation.matrix(lw.rotation.about(axis, angle))


def turned(roll: float, pitch: float, yaw: float) -> np.ndarray:
    """A = A_z(yaw) A_y(pitch) A_x(roll)"""
    return about((0, 0, 1), yaw) @ about((0, 1, 0), pitch) @ about((1, 0, 0), roll)


def topics(imported: lw.Imported) -> list[tuple[str, str]]:
    """What the notes are about, sorted."""
    return sorted((note.topic, note.subject) for note in imported.notes)


def check_takes_time_as_it_is_long(read: Callable[[int], object], module: ModuleType) -> None:
    """For each element more as many lines of code of the module run in a long file as in a short one."""

    def lines(count: int) -> int:
        found = 0

        def watch(frame: FrameType, event: str, _: Any) -> Any:
            nonlocal found
            if frame.f_code.co_filename != module.__file__:
                return None
            found += event == "line"
            return watch

        before = sys.gettrace()
        sys.settrace(watch)
        try:
            read(count)
        finally:
            sys.settrace(before)
        return found

    short, middle, long = lines(20), lines(40), lines(60)
    assert 0 < long - middle == middle - short


def check_refused(
    read: Callable[[Path], lw.Imported], path: Path, text: str, part: str, by: str, message: str
) -> None:
    """A good file is refused with this message when one part of it is replaced."""
    path.write_text(text)
    read(path)
    assert part in text
    path.write_text(text.replace(part, by, 1))
    with pytest.raises(lw.ModelFileError, match=message):
        read(path)
