"""The bodies of a model in Python: how they are found again, and where they are at t = 0."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork import _core, rotation
from linkwork.arguments import is_iterable, is_text
from linkwork.arrays import Floats, Indices
from linkwork.errors import nearest
from linkwork.modeling.handles import Body, Range
from linkwork.modeling.placement import Poses, Subject

if TYPE_CHECKING:
    from linkwork.modeling.model import Model

#: Names among which the nearest is looked for.
NAMES_SEARCHED = 10_000


class Bodies:
    """Handles, names, indices and initial poses of the bodies of one model; the ground has index -1."""

    def __init__(self, model: Model, core: _core.Model) -> None:
        self._model, self._core = model, core
        self.ground = Body("ground", -1, model)

    def add(self, names: str | list[str], mass: Floats, inertia: Floats, as_is: Sequence[bool] = (),
            **state: Floats) -> Range[Body]:  # fmt: skip
        """Hand k bodies to the compiled model, which checks them; every array has a leading k.

        `as_is`: for each whether its inertia may be that of no real body; empty: none.
        """
        first = self._core.add_bodies(names, mass, inertia, **state, inertia_as_is=list(as_is))
        return Range(range(first, first + len(mass)), self.handle)

    def handle(self, index: int) -> Body:
        return self.ground if index < 0 else Body(self._core.body_name(index), index, self._model)

    def poses(self, bodies: Indices) -> Poses:
        """At t = 0."""
        q = self._core.poses(bodies)
        return Poses(q[:, :3], rotation.matrix(q[:, 3:]))

    def index(self, body: Any, subject: Subject) -> int:
        """Of a body given by handle or name. ModelError: of another model, unknown, or no body at all."""
        if isinstance(body, Body):
            if body.model is not self._model:
                subject.refuse(0, f"body '{body.name}' belongs to another model", "unknown_body")
            return body.index
        if not isinstance(body, str):
            subject.refuse(0, f"{body!r} is not a body: give its handle or its name", "unknown_body")
        known = body != "ground" and is_text(body)
        index = int(self._core.find_body(body)) if known else -1
        if index < 0 and body != "ground":
            searched = range(min(self._core.body_count, NAMES_SEARCHED))
            names = ["ground", *map(self._core.body_name, searched)]
            subject.refuse(0, f"no body named '{body}'{nearest(body, names)}", "unknown_name")
        return index

    def pair(self, a: Any, b: Any, subject: Subject) -> Indices:
        """The two bodies of one element (1, 2)."""
        return np.array([[self.index(a, subject), self.index(b, subject)]], np.int32)

    def pairs(self, a: Any, b: Any, subject: Subject) -> Indices:
        """The bodies of a group of elements (k, 2); one body stands for all."""
        first, second = self.indices(a, subject), self.indices(b, subject)
        if len(first) != len(second) and 1 not in (len(first), len(second)):
            subject.refuse(0, f"joins {len(first)} bodies to {len(second)}", "shape")
        return np.stack(np.broadcast_arrays(first, second), axis=1)

    def indices(self, bodies: Any, subject: Subject) -> Indices:
        """Of one or many bodies, by handles, names or indices (k,); the ground is -1. Errors as `index`."""
        if isinstance(bodies, np.ndarray) and bodies.dtype.kind in "iu" and bodies.ndim == 1:
            outside = (bodies < -1) | (bodies >= self._core.body_count)
            if outside.any():
                subject.refuse(0, f"body index {bodies[outside][0]} does not exist", "unknown_body")
            return bodies.astype(np.int32)
        if isinstance(bodies, Range) and len(bodies):
            self.index(bodies[0], subject)
            return bodies.indices
        many = [bodies] if isinstance(bodies, Body | str) else bodies
        if not is_iterable(many):
            subject.refuse(0, f"{many!r:.80} are no bodies: give handles or names", "unknown_body")
        return np.array([self._one_of_many(body, subject) for body in many], np.int32)

    def _one_of_many(self, body: Any, subject: Subject) -> int:
        """Of a handle or a name; in a list, of an index as well."""
        if not isinstance(body, int | np.integer) or isinstance(body, bool):
            return self.index(body, subject)
        if not -1 <= body < self._core.body_count:
            subject.refuse(0, f"body index {body} does not exist", "unknown_body")
        return int(body)
