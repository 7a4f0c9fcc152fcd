"""`--log FILE`: what happens, a line each."""

from __future__ import annotations

import logging

from linkwork.errors import unwritable

FORMAT = "%(asctime)s %(levelname)s %(name)s: %(message)s"


def write_to(path: str) -> None:
    """Append records of linkwork from level INFO on. FileError: the file cannot be written."""
    try:
        handler = logging.FileHandler(path, encoding="utf-8")
    except OSError as error:
        raise unwritable("log", path, error) from error
    handler.setFormatter(logging.Formatter(FORMAT))
    logger = logging.getLogger("linkwork")
    logger.addHandler(handler)
    logger.setLevel(logging.INFO)
