"""Commands in processes of their own, as a terminal starts them."""

from __future__ import annotations

import signal
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager


def _heed_interrupts() -> None:
    """A terminal's programs do, wherever the tests themselves were started."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


@contextmanager
def running(words: Sequence[str]) -> Iterator[subprocess.Popen[str]]:
    """A command that is gone at the end, however the test went."""
    pipe = subprocess.PIPE
    with subprocess.Popen(words, stdout=pipe, stderr=pipe, text=True, preexec_fn=_heed_interrupts) as process:
        try:
            yield process
        finally:
            process.kill()
