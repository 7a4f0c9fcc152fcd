"""The share of their weight that MuJoCo takes from bodies, by itself or by the actuators of joints."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from linkwork.importers.mjcf_dynamics import is_disabled

if TYPE_CHECKING:
    import mujoco

__all__ = ["GravityCompensation"]


# MuJoCo lifts the center of mass of a body by -c m g: a passive force, Q_j at each joint j on the way to the
# world. At joints with `actuatorgravcomp` Q_j is a force of actuators: not there without actuation, and
# limited together with the other forces of actuators. A lift here acts at all joints.
class GravityCompensation:
    """Of the bodies of a compiled model. Without a positive share in the model MuJoCo heeds none."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._model = model
        passive = not (is_disabled(model, "spring") and is_disabled(model, "damper"))
        self._acts = bool(model.ngravcomp) and passive
        self._by_actuators = bool(model.jnt_actgravcomp.any())  #: at some joints
        self._actuated = model.nu > 0 and not is_disabled(model, "actuation")

    def share(self, body: int) -> float:
        """What is taken from the weight of a body, of 1."""
        share = float(self._model.body_gravcomp[body]) if self._acts else 0.0
        lost = self._lost(body) if share else []
        return 0.0 if lost and len(lost) == len(self._joints(body)) else share

    def notes(self, name: Callable[[str, int], str]) -> Iterator[tuple[str, str]]:
        """Subjects and messages: where more is compensated here. `name`: of a kind and an index."""
        limited: dict[int, None] = {}
        for body in range(1, self._model.nbody) if self._by_actuators else ():
            if not self.share(body):
                continue
            if lost := self._lost(body):
                joints = ", ".join(f"'{name('joint', k)}'" for k in lost)
                text = f"its weight is compensated at {joints}, too, where MuJoCo lacks actuation for that"
                yield f"body '{name('body', body)}'", text
            limited |= dict.fromkeys(self._limited(body))
        for k in limited:
            lower, upper = self._model.jnt_actfrcrange[k]
            text = f"its actuatorfrcrange {lower:g} to {upper:g} does not limit gravity compensation"
            yield f"joint '{name('joint', k)}'", text

    def _joints(self, body: int) -> list[int]:
        """On the way to the world."""
        model, out = self._model, list[int]()
        while body:
            first = int(model.body_jntadr[body])
            out += range(first, first + int(model.body_jntnum[body]))
            body = int(model.body_parentid[body])
        return out

    def _lost(self, body: int) -> list[int]:
        """Joints at which its weight would be compensated by actuation, which there is not."""
        if self._actuated or not self._by_actuators:
            return []
        return [k for k in self._joints(body) if self._model.jnt_actgravcomp[k]]

    def _limited(self, body: int) -> list[int]:
        model = self._model
        if not self._actuated:
            return []
        return [k for k in self._joints(body) if model.jnt_actgravcomp[k] and model.jnt_actfrclimited[k]]
