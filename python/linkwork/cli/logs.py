"""`--log FILE`: what happens, a line each."""

from __future__ import annotations

import logging
import sys

from linkwork.errors import FileError, unwritable

FORMAT = "%(asctime)s %(levelname)s %(name)s: %(message)s"


class _LogFile(logging.FileHandler):
    """Of what could not be written the first is remembered; no run ends for it."""

    def __init__(self, path: str) -> None:
        super().__init__(path, encoding="utf-8")
        self.path = path
        self.failure: FileError | None = None

    def remember(self, error: OSError) -> None:
        self.failure = self.failure or unwritable("log", self.path, error)

    def handleError(self, record: logging.LogRecord) -> None:
        error = sys.exc_info()[1]
        if isinstance(error, OSError):
            self.remember(error)
        else:
            super().handleError(record)


def write_to(path: str) -> None:
    """Append records of linkwork from level INFO on. FileError: the file cannot be written."""
    from linkwork.arguments import refuse_dash

    refuse_dash(path, "log")
    try:
        handler = _LogFile(path)
    except OSError as error:
        raise unwritable("log", path, error) from error
    handler.setFormatter(logging.Formatter(FORMAT))
    logger = logging.getLogger("linkwork")
    logger.addHandler(handler)
    logger.setLevel(logging.INFO)


def close() -> FileError | None:
    """What was wrong with the log of this command, which is closed."""
    logger = logging.getLogger("linkwork")
    failure = None
    for handler in [it for it in logger.handlers if isinstance(it, _LogFile)]:
        logger.removeHandler(handler)
        try:
            handler.close()
        except OSError as error:
            handler.remember(error)
        failure = failure or handler.failure
    return failure
