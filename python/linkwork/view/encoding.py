"""Arrays on their way into a page: quantized, packed into one block, deflated, in base64."""

from __future__ import annotations

import base64
import zlib
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats

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
        well. The error is at most 1/131070 of the channel's range. What is not finite becomes the least.
        """
        extremes = Extremes()
        extremes.add(values)
        channels = extremes.channels()
        self.add(name, channels.differences(values), "u2")
        channels.add_to(self, name)
        return np.reshape(channels.step / 2, np.shape(values)[1:])

    def text(self) -> str:
        """The block, deflated, in base64."""
        return base64.b64encode(zlib.compress(b"".join(self._parts), 6)).decode("ascii")


class Extremes:
    """The least and the largest value of each channel of series that come one after the other."""

    def __init__(self) -> None:
        self._low: Floats | None = None
        self._high: Floats | None = None

    def add(self, values: Floats) -> None:
        """(k, ...); what is not finite does not count."""
        channels = _channels(values)
        finite = np.isfinite(channels)
        low = np.where(finite, channels, np.inf).min(axis=1, initial=np.inf)
        high = np.where(finite, channels, -np.inf).max(axis=1, initial=-np.inf)
        self._low = low if self._low is None else np.minimum(self._low, low)
        self._high = high if self._high is None else np.maximum(self._high, high)

    def channels(self) -> Channels:
        """Of channels without a finite value all numbers are 0."""
        assert self._low is not None and self._high is not None
        low, high = (np.where(np.isfinite(end), end, 0.0) for end in (self._low, self._high))
        return Channels(low, (high - low) / STEPS)


@dataclass(frozen=True)
class Channels:
    """How numbers of each channel become whole ones: by their least and the step between two (c,)."""

    low: Floats
    step: Floats

    def differences(self, values: Floats) -> NDArray[np.uint16]:
        """(c, k) of series (k, ...): the first, then differences of each to the one before, modulo 2^16."""
        channels, low, step = _channels(values), self.low[:, None], self.step[:, None]
        finite = np.isfinite(channels)
        whole = np.round((np.where(finite, channels, low) - low) / np.where(step > 0, step, 1))
        numbers: NDArray[np.uint16] = np.clip(whole, 0, STEPS).astype(np.uint16)
        numbers[:, 1:] -= numbers[:, :-1].copy()
        return numbers

    def add_to(self, pack: Pack, name: str) -> None:
        pack.add(f"{name}.low", self.low, "f8")
        pack.add(f"{name}.step", self.step, "f8")


def _channels(values: Floats) -> Floats:
    return np.reshape(values, (len(values), -1)).T
