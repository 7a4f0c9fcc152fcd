"""What is in a file of text, no more than it may have, and no more memory than it has."""

from __future__ import annotations

import os

__all__ = ["read"]

PIECE = 2**20


def read(path: str | os.PathLike[str], most: int) -> bytes | None:
    """None: there are more than `most` bytes. OSError: it cannot be read."""
    pieces, count = [], 0
    with open(path, "rb") as file:
        while piece := file.read(min(PIECE, most + 1 - count)):
            pieces.append(piece)
            count += len(piece)
            if count > most:
                return None
    return b"".join(pieces)
