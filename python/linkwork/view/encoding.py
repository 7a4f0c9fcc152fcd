"""Arrays on their way into a page: in few bytes, packed into one block, deflated, in base64."""

from __future__ import annotations

import base64
import zlib
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.errors import OptionError

#: Steps between the least and the largest value of a channel.
STEPS = 2**16 - 1

#: Names of types in the page.
TYPES = {"f8": np.float64, "f4": np.float32, "i4": np.int32, "u2": np.uint16, "u1": np.uint8}


class Pack:
    """Arrays by name in one block of bytes; `directory` says where each of them is."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []
        self._size = 0
        self.directory: dict[str, Any] = {}

    def add(self, name: str, array: NDArray[Any], kind: str) -> None:
        """As it is, in the type `kind` of TYPES, little endian."""
        data = np.ascontiguousarray(array, dtype=np.dtype(TYPES[kind]).newbyteorder("<")).tobytes()
        self.directory[name] = {"type": kind, "shape": list(np.shape(array)), "offset": self._size}
        self._parts += [data, bytes(-len(data) % 8)]
        self._size += len(data) + -len(data) % 8

    def add_quantized(self, name: str, values: Floats) -> Floats:
        """Time series (k, ...) in 16 bits each, between the least and largest value; the error of each (...).

        Stored channel by channel, each number as the difference to the one before: smooth motion deflates
        well. The error is at most 1/131070 of the channel's range: for poses, which stay near each other, and
        not for what may have a knock in it. OptionError: a number that is not finite.
        """
        extremes = Extremes()
        extremes.add(values)
        channels = extremes.channels()
        self.add(name, channels.differences(values), "u2")
        channels.add_to(self, name)
        return np.reshape(channels.step / 2, np.shape(values)[1:])

    def add_singles(self, name: str, values: Floats) -> None:
        """Time series (k, ...) in 32 bits each, about 7 digits of every number: (4, c, k) bytes.

        Of each channel the patterns of bits, as differences of whole numbers modulo 2^32, the lowest byte of
        all first, then the next: of smooth motion the high ones are nearly constant, and deflate well.
        """
        with np.errstate(over="ignore"):  # beyond 3e38 they are infinite, as they are on the screen
            patterns = np.array(_channels(values), "<f4", order="C").view("<u4")
        patterns[:, 1:] -= patterns[:, :-1].copy()
        planes = np.stack([(patterns >> 8 * plane).astype(np.uint8) for plane in range(4)])
        self.add(name, planes, "u1")

    def text(self) -> str:
        """The block, deflated, in base64."""
        return base64.b64encode(zlib.compress(b"".join(self._parts), 6)).decode("ascii")


class Extremes:
    """The least and the largest value of each channel of series that come one after the other."""

    def __init__(self) -> None:
        self._low: Floats | None = None
        self._high: Floats | None = None

    def add(self, values: Floats) -> None:
        """(k, ...). OptionError: a number that is not finite."""
        channels = _channels(values)
        if not np.isfinite(channels).all():
            raise OptionError("the result has poses that are not finite: they cannot be shown", code="poses")
        low, high = channels.min(axis=1, initial=np.inf), channels.max(axis=1, initial=-np.inf)
        self._low = low if self._low is None else np.minimum(self._low, low)
        self._high = high if self._high is None else np.maximum(self._high, high)

    def channels(self) -> Channels:
        assert self._low is not None and self._high is not None
        return Channels(self._low, (self._high - self._low) / STEPS)


@dataclass(frozen=True)
class Channels:
    """How numbers of each channel become whole ones: by their least and the step between two (c,)."""

    low: Floats
    step: Floats

    def differences(self, values: Floats) -> NDArray[np.uint16]:
        """(c, k) of series (k, ...): the first, then differences of each to the one before, modulo 2^16."""
        channels, low, step = _channels(values), self.low[:, None], self.step[:, None]
        whole = np.round((channels - low) / np.where(step > 0, step, 1))
        numbers: NDArray[np.uint16] = np.clip(whole, 0, STEPS).astype(np.uint16)
        numbers[:, 1:] -= numbers[:, :-1].copy()
        return numbers

    def add_to(self, pack: Pack, name: str) -> None:
        pack.add(f"{name}.low", self.low, "f8")
        pack.add(f"{name}.step", self.step, "f8")


def _channels(values: Floats) -> Floats:
    return np.reshape(values, (len(values), -1)).T
