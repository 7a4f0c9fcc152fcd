"""What a model gives back for what was added: handles by which bodies, joints and forces are named again."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Generic, Literal, TypeVar, overload

import numpy as np
from numpy.typing import NDArray

from linkwork.errors import ModelError, nearest

if TYPE_CHECKING:
    from linkwork.modeling.model import Model
    from linkwork.modeling.shapes import Shape

__all__ = ["BodiesLike", "Body", "BodyLike", "Force", "Joint", "Named", "Range", "place_of"]


@dataclass(frozen=True)
class Body:
    """A body of a model; index -1 is the ground."""

    name: str
    index: int
    model: Model = field(repr=False, compare=False)

    def shape(self, *shapes: Shape) -> Body:
        """Draw it by these shapes; they have no influence on the motion.

            model.find("rod").shape(lw.Rod((-0.4, 0, 0), (0.4, 0, 0), color="orange"))

        ModelError: what is no shape.
        """
        self.model.shape(self, *shapes)
        return self


@dataclass(frozen=True)
class Joint:
    """A joint of a model."""

    name: str
    index: int
    kind: str


@dataclass(frozen=True)
class Force:
    """A force element of a model."""

    name: str
    index: int
    kind: str


Handle = TypeVar("Handle", Body, Joint, Force)


class Range(Sequence[Handle], Generic[Handle]):
    """Handles of a group; a slice is a Range again, and a million of them take no memory."""

    __slots__ = ("_handle", "_indices")

    def __init__(self, indices: range, handle: Callable[[int], Handle]) -> None:
        self._indices = indices
        self._handle: Callable[[int], Handle] = handle

    @property
    def indices(self) -> NDArray[np.int32]:
        """Indices in the model (k,)."""
        return np.arange(self._indices.start, self._indices.stop, self._indices.step, dtype=np.int32)

    def __len__(self) -> int:
        return len(self._indices)

    @overload
    def __getitem__(self, place: int) -> Handle: ...
    @overload
    def __getitem__(self, place: slice) -> Range[Handle]: ...
    def __getitem__(self, place: int | slice) -> Handle | Range[Handle]:
        found = self._indices[place]
        return Range(found, self._handle) if isinstance(found, range) else self._handle(found)

    def __repr__(self) -> str:
        return f"<{self[0].name} ... {self[-1].name}>" if self else "<empty>"


#: A body by its handle or its name.
BodyLike = Body | str

#: Many bodies: a Range, handles, names, or indices (k,) with -1 the ground; one body stands for all.
BodiesLike = BodyLike | Range[Body] | Sequence[BodyLike | int] | NDArray[np.integer]

#: A body or a joint by its name, its index, or the handle that the model gave.
Named = str | int | Body | Joint


def place_of(what: Literal["body", "joint"], name: Named, places: Mapping[str, int]) -> int:
    """Index of a body or joint among those that there are, all by name. ModelError: none of them."""
    if isinstance(name, int | np.integer):
        if not -len(places) <= name < len(places):
            raise ModelError(f"no {what} {name}: there are {len(places)}", code="unknown_name")
        return int(name) % len(places)
    text = str(name)
    if isinstance(name, Body | Joint) and isinstance(name, Body) == (what == "body"):
        text = name.name
    if text not in places:
        raise ModelError(f"no {what} named '{text}'{nearest(text, places)}", code="unknown_name")
    return places[text]
