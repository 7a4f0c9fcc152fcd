"""Ctrl-C during a run: honored where nothing can be lost, and never lost itself.

Python raises KeyboardInterrupt wherever it happens to be: inside the callback of a weak reference (h5py has
many) it is swallowed, inside the writing of a chunk it leaves half of it. So during a run the key is
remembered, raises at once only while the driver computes, and otherwise when the run asks. Pressed twice, it
raises everywhere.
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType, TracebackType
from typing import Self


class Interrupts:
    """Holds SIGINT while it is entered; a handler of the user's own, and other threads, are left alone."""

    def __init__(self) -> None:
        self._pressed = False
        self._computing = False
        self._holding = False

    def __enter__(self) -> Self:
        main = threading.current_thread() is threading.main_thread()
        if main and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            signal.signal(signal.SIGINT, self._handle)
            self._holding = True
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        if self._holding:
            signal.signal(signal.SIGINT, signal.default_int_handler)
        if error is None:
            self.check()

    @contextmanager
    def computing(self) -> Iterator[None]:
        """Where an interrupt may raise: nothing is being written."""
        self.check()
        self._computing = True
        try:
            yield
        finally:
            self._computing = False

    def check(self) -> None:
        """KeyboardInterrupt, when the key was pressed."""
        if self._pressed:
            raise KeyboardInterrupt

    def _handle(self, number: int, frame: FrameType | None) -> None:
        again, self._pressed = self._pressed, True
        if self._computing or again:
            raise KeyboardInterrupt
