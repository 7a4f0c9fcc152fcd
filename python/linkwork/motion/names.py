"""Names of bodies and elements: of a model made when they are asked for, of a file as they were read."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from operator import eq
from typing import Any, overload

__all__ = ["Names"]

#: Of them in `repr`.
SHOWN = 100


class Names(Sequence[str]):
    """What compares and adds like a list; a million names that nobody asked for take no memory."""

    def __init__(self, name: Callable[[int], str], count: int) -> None:
        self._name, self._count = name, count

    @classmethod
    def of(cls, names: Sequence[str]) -> Names:
        """Those that somebody has already."""
        return names if isinstance(names, Names) else cls(list(names).__getitem__, len(names))

    def __repr__(self) -> str:
        more = f" and {self._count - SHOWN} more" if self._count > SHOWN else ""
        return f"<{', '.join(self[:SHOWN])}{more}>"

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[str]:
        return map(self._name, range(self._count))

    @overload
    def __getitem__(self, index: int) -> str: ...
    @overload
    def __getitem__(self, index: slice) -> list[str]: ...
    def __getitem__(self, index: int | slice) -> str | list[str]:
        places = range(self._count)[index]
        return self._name(places) if isinstance(places, int) else [self._name(place) for place in places]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Names | list | tuple):
            return NotImplemented
        return self is other or (len(self) == len(other) and all(map(eq, self, other)))

    __hash__ = None  # type: ignore[assignment]  # like a list

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle: a list, which a header takes, too."""
        return list, (list(self),)

    def __add__(self, other: Any) -> list[str]:
        if not isinstance(other, Names | list | tuple):
            return NotImplemented
        return [*self, *other]

    def __radd__(self, other: Any) -> list[str]:
        if not isinstance(other, list | tuple):
            return NotImplemented
        return [*other, *self]
