"""One element of every kind in a generic pose: two turned bodies off the origin, all arguments given."""

from __future__ import annotations

from typing import Any

import linkwork as lw
import numpy as np
from linkwork import _core

P, Q = (0.3, -0.2, 0.5), (1.1, 0.4, -0.3)
AXIS, ACROSS = (1.0, 2.0, 2.0), (2.0, 1.0, -2.0)
TURNED = lw.rotation.about((1, 2, 3), 1.0)

#: The arguments of each placement, those that can be left out among them.
PLACES: dict[str, dict[str, Any]] = {
    "point": {"at": P},
    "axis": {"at": P, "axis": AXIS, "x_axis": ACROSS},
    "two_axes": {"at": P, "axes": (AXIS, ACROSS)},
    "two_points": {"at": (P, Q)},
    "frame": {"at": P, "orientation": TURNED},
    "direction": {"axis": AXIS, "x_axis": ACROSS},
    "two_directions": {"axes": (AXIS, ACROSS)},
    "orientation": {"orientation": TURNED},
    "shafts": {"at": P, "axes": (AXIS, (1.0, 2.0, 2.5))},
    "centers": {"at": (P, Q), "axis": AXIS},
    "plane": {"at": (P, Q), "normal": AXIS},
    "disc": {"at": (P, Q), "axes": (AXIS, ACROSS)},
}

#: Of kinds whose own method has other arguments than their placement and their parameters.
VECTORS = {"applied": ("force", "torque"),
           "bushing": ("stiffness", "rotational_stiffness", "damping", "rotational_damping")}  # fmt: skip


def bodies(count: int = 1) -> lw.Model:
    """Pairs of bodies a 0, b 0, a 1, ..., turned, off the origin and on the move."""
    random, model = np.random.default_rng(count), lw.Model(gravity=(0.3, -1.0, -9.0))
    for k in range(count):
        for end in "ab":
            p = random.normal(size=4)
            state = {what: random.normal(size=3) for what in ("position", "velocity", "omega")}
            model.body(
                f"{end} {k}", mass=1.5, inertia=(0.2, 0.3, 0.4), orientation=p / np.linalg.norm(p), **state
            )
    return model


def arguments(kind: _core.KindInfo) -> dict[str, Any]:
    """Of the kind's own method: all that it takes."""
    if kind.name in VECTORS:
        own: dict[str, Any] = {
            what: (1.0 + k, 2.0, 3.5 - k) for k, what in enumerate(VECTORS[kind.name])
        }  # fmt: skip
    else:
        own = {what: it.example for what, it in kind.parameters.items()}
    return ({"at": P, "frame": "body"} if kind.name == "applied" else PLACES[kind.placement]) | own


def added(model: lw.Model, kind: _core.KindInfo, name: str, k: int = 0, **given: Any) -> None:
    """By the kind's own method, to the pair of bodies k."""
    if kind.name == "applied":
        model.force(f"b {k}", name=name, **given)
    else:
        getattr(model, kind.name)(f"a {k}", f"b {k}", name=name, **given)
