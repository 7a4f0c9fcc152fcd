"""Arrays on their way into a page: quantized, packed into one block, deflated, in base64."""

from __future__ import annotations

import base64
import zlib
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
        channels = np.reshape(values, (len(values), -1)).T
        finite = np.isfinite(channels)
        low = np.where(finite, channels, np.inf).min(axis=1, initial=np.inf)
        high = np.where(finite, channels, -np.inf).max(axis=1, initial=-np.inf)
        low, high = (np.where(np.isfinite(end), end, 0.0) for end in (low, high))
        step = (high - low) / STEPS
        whole = np.round(
            (np.where(finite, channels, low[:, None]) - low[:, None]) / np.where(step > 0, step, 1)[:, None]
        )
        numbers = np.clip(whole, 0, STEPS).astype(np.uint16)
        self.add(name, np.diff(numbers, axis=1, prepend=np.uint16(0)), "u2")  # modulo 2^16
        self.add(f"{name}.low", low, "f8")
        self.add(f"{name}.step", step, "f8")
        return np.reshape(step / 2, np.shape(values)[1:])

    def text(self) -> str:
        """The block, deflated, in base64."""
        return base64.b64encode(zlib.compress(b"".join(self._parts), 6)).decode("ascii")
