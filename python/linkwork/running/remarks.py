"""What is said of one of many runs: its warnings, and why it failed."""

from __future__ import annotations

import threading
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

from linkwork.errors import LinkworkError
from linkwork.results.result import Result

__all__ = ["facts_of", "message_of", "remarked"]

#: Characters of a message that are kept.
LONGEST = 2000


def facts_of(error: BaseException) -> dict[str, Any]:
    """Class, code, message, and the simulated time that was reached [s], if it is known."""
    found: dict[str, Any] = {
        "type": type(error).__name__,
        "code": "",
        "message": message_of(error) or type(error).__name__,
        "reached": None,
    }
    reached, result = None, getattr(error, "result", None)
    if isinstance(error, LinkworkError):
        found["code"], reached = error.code, error.time
    if reached is None and isinstance(result, Result) and len(result):
        reached = float(result.t[-1])
    found["reached"] = None if reached is None else float(reached)
    return found


def message_of(error: BaseException | str) -> str:
    """In one line, which every file can hold; the name of its class where it cannot be asked. Empty: it has
    nothing to say."""
    try:
        text = str(error)
    except Exception:
        return type(error).__name__
    line = " ".join(text.split()).encode(errors="replace").decode()
    return line if len(line) <= LONGEST else f"{line[:LONGEST]} ... ({len(line)} characters)"


@contextmanager
def remarked() -> Iterator[list[str]]:
    """Warnings of this thread go to the list, each once, as they come."""
    texts: list[str] = []
    with _LISTENING:
        before = _HEARD.set(texts)
        try:
            yield texts
        finally:
            _HEARD.reset(before)


#: Where the warnings of a thread go; None: where they would go.
_HEARD: ContextVar[list[str] | None] = ContextVar("heard", default=None)


class _Listening:
    """Threads share what becomes of warnings: it is changed while any of them listens."""

    def __init__(self) -> None:
        self._lock, self._count = threading.Lock(), 0

    def __enter__(self) -> None:
        with self._lock:
            self._count += 1
            if self._count > 1:
                return
            self._usual = warnings.showwarning
            self._changed = warnings.catch_warnings()
            self._changed.__enter__()
            warnings.simplefilter("always")
            warnings.showwarning = self._hear

    def __exit__(self, *_: object) -> None:
        with self._lock:
            self._count -= 1
            if not self._count:
                self._changed.__exit__(None, None, None)

    def _hear(self, message: Warning | str, *where: Any, **named: Any) -> None:
        heard = _HEARD.get()
        if heard is None:
            self._usual(message, *where, **named)
        elif (text := message_of(message)) not in heard:
            heard.append(text)


_LISTENING = _Listening()
