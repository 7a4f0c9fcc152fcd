"""The pose in which a model begins, to be looked at before anything is computed.

It needs no consistent joints: what violates them is drawn in red, with what it violates them by.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import numpy as np

from linkwork import _core, arguments
from linkwork.arrays import Floats
from linkwork.errors import ModelError
from linkwork.motion.header import Header
from linkwork.motion.violations import told, violations
from linkwork.results.result import Result
from linkwork.view import view
from linkwork.view.page import Page
from linkwork.view.run import LIMIT

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from linkwork.modeling.model import Model

#: Residuals that are more than rounding, relative to what is placed.
TOLERANCE = 1e-9

#: How many joints are marked.
MARKED = 100


def initial_pose(model: Model) -> Result:
    """One frame, t = 0: positions and velocities as they were given, nothing else. ModelError: no bodies."""
    core = model.compiled()
    if not core.body_count:
        raise ModelError(f"model '{model.name}': has no bodies: there is nothing to view", code="empty")
    manifest = {"model": model.name or "model", "still": True, "loose": _loose(core)}
    header = Header.of(core, None, manifest, shapes=model.shapes, curves=model.curves)
    frames = {name: np.zeros((1, *shape)) for name, shape in header.frame_shapes().items()}
    frames["q"], frames["v"] = core.q0.reshape(1, -1, 7), core.v0.reshape(1, -1, 6)
    result = Result(frames, header, {})
    header.manifest["loose"].update(_apart(result, header.manifest["loose"]))
    return result


def view_model(model: Model, path: str | os.PathLike[str] | None = None, limit: float = LIMIT) -> Page:
    """As `Model.view`."""
    page = view([initial_pose(model)], limit=limit)
    if path is not None:
        page.save(arguments.path(path, "page"))
    return page


def plot_model(model: Model, path: str | os.PathLike[str] | None = None) -> Figure:
    """As `Model.plot`."""
    from linkwork.view import still

    return still.plot(initial_pose(model), None if path is None else arguments.path(path, "picture"))


def _loose(core: _core.Model) -> dict[int, str]:
    """Joints that the pose violates, most first, with the largest residual of their equations."""
    if not core.joint_count:
        return {}
    assembler = _core.Assembler(core, np.zeros(0), [])
    found = np.abs(assembler.residuals(core.q0, core.v0)[0])
    relative = found / assembler.row_lengths(core.q0)
    starts = core.joint_rows[:-1]
    value, part = (np.maximum.reduceat(x, starts) for x in (found, relative))
    worst = np.argsort(-part, kind="stable")[:MARKED]
    return {int(joint): f"off by {value[joint]:.3g}" for joint in worst if part[joint] > TOLERANCE}


def _apart(result: Result, joints: dict[int, str]) -> dict[int, str]:
    """The same in lengths and angles, where points and axes tell."""
    apart, askew = violations(result, np.array(list(joints), dtype=np.intp))
    texts: dict[int, str] = {}
    known = told(result.header)
    for joint, gap, angle in zip(joints, apart[-1], askew[-1], strict=True):
        words = [f"{_length(gap)} apart"] if gap > 0 else []
        words += [f"{np.degrees(angle):.3g} deg askew"] if angle > TOLERANCE else []
        if words and known[joint]:
            texts[joint] = ", ".join(words)
    return texts


def _length(gap: Floats) -> str:
    return f"{gap:.3g} m" if gap >= 0.1 else f"{1e3 * gap:.3g} mm"
