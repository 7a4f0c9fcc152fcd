"""Ctrl-C during a run, or a request to end: honored where nothing can be lost, and never lost itself.

Python raises KeyboardInterrupt wherever it happens to be: inside the callback of a weak reference (h5py has
many) it is swallowed, inside the writing of a chunk it leaves half of it. So during a run the key is
remembered, raises at once only while the driver computes, and otherwise when the run asks. Pressed twice, it
raises everywhere. Studies and comparisons wait for their runs in the same way.
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from types import FrameType, TracebackType
from typing import Any, Self, TypeVar

T = TypeVar("T")


class Terminated(KeyboardInterrupt):
    """SIGTERM, as a scheduler or a shutting down machine sends it, ends a run like ctrl-C."""


def terminate(number: int, frame: FrameType | None) -> None:
    """What a program of ours does at SIGTERM, see `honor_termination`."""
    raise Terminated


def honor_termination() -> None:
    """SIGTERM ends this process like ctrl-C from here on, whatever it does."""
    if threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGTERM, terminate)


#: What Python or a program of ours does by itself: only that is replaced while a run goes on.
BY_ITSELF: dict[signal.Signals, tuple[Any, ...]] = {
    signal.SIGINT: (signal.default_int_handler,),
    signal.SIGTERM: (signal.SIG_DFL, terminate),
}


class Interrupts:
    """Holds both signals while it is entered; handlers of the user's own and other threads are left alone.

    Within others, as of a study in whose process its runs are carried out, the inner ones hold them.
    """

    def __init__(self) -> None:
        self._pressed: type[KeyboardInterrupt] | None = None
        self._computing = False
        self._held: dict[signal.Signals, Any] = {}

    def __enter__(self) -> Self:
        if threading.current_thread() is threading.main_thread():
            before = {number: signal.getsignal(number) for number in BY_ITSELF}
            self._held = {
                number: it
                for number, it in before.items()
                if it in BY_ITSELF[number] or _interrupts_of(it) is not None
            }
            for number in self._held:
                signal.signal(number, self._handle)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        for number, usual in self._held.items():
            signal.signal(number, usual)
            if (outer := _interrupts_of(usual)) is not None:
                outer._pressed = outer._pressed or self._pressed
        if error is None:
            self.check()

    @contextmanager
    def computing(self) -> Iterator[None]:
        """Where an interrupt may raise: nothing is being written."""
        before = self._computing
        self._computing = True
        try:
            self.check()
            yield
        finally:
            self._computing = before

    def each(self, found: Iterable[T]) -> Iterator[T]:
        """What is found: looking for it may be interrupted, what becomes of it not."""
        items = iter(found)
        while True:
            with self.computing():
                try:
                    item = next(items)
                except StopIteration:
                    return
            yield item

    def check(self) -> None:
        """KeyboardInterrupt, when the key was pressed; Terminated."""
        if self._pressed is not None:
            raise self._pressed

    def _handle(self, number: int, frame: FrameType | None) -> None:
        again, self._pressed = self._pressed, Terminated if number == signal.SIGTERM else KeyboardInterrupt
        if self._computing or again:
            raise self._pressed


def _interrupts_of(handler: Any) -> Interrupts | None:
    """Those that handle a signal with it."""
    owner = getattr(handler, "__self__", None)
    return owner if isinstance(owner, Interrupts) else None
