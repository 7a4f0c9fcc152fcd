"""A task in a process of its own: its memory is its own, and what it cannot do does no harm.

That process runs `main`: a task comes in on standard input, its answer goes to standard output.
"""

from __future__ import annotations

import pickle
import signal
import subprocess
import sys
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

from linkwork.benchmark import memory
from linkwork.errors import LinkworkError

T = TypeVar("T")

#: Between two beats of the one who waits [s].
BEAT_SECONDS = 0.5

PROGRAM = [sys.executable, "-c", f"from {__name__} import main; main()"]


@dataclass(frozen=True)
class Failure:
    """Why there is no answer; `code` as in LinkworkError."""

    reason: str
    code: str


def isolated(
    task: Callable[..., T], *arguments: Any, seconds: float, beat: Callable[[], None] = lambda: None
) -> T | Failure:
    """The answer of an importable function in a new process that has so many seconds from start to end.

    `beat` is called as it begins and now and then while it runs. An error of linkwork and a lack of memory or
    time are a Failure.
    """
    process = subprocess.Popen(PROGRAM, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    question: bytes | None = pickle.dumps((task, arguments))
    end = time.monotonic() + seconds
    beat()
    try:
        while True:
            try:
                left = max(end - time.monotonic(), 0.0)
                answer, complaint = process.communicate(question, timeout=min(BEAT_SECONDS, left))
                break
            except subprocess.TimeoutExpired:
                question = None
                beat()
            if time.monotonic() >= end:
                return Failure(f"not done after {seconds:g} s", "time")
    finally:
        if process.poll() is None:
            process.kill()
            process.wait()
    if process.returncode == 0:
        result: T | Failure = pickle.loads(answer)
        return result
    if process.returncode < 0:
        name = signal.Signals(-process.returncode).name
        return Failure(f"the process was ended by {name}", "killed")
    last = complaint.decode(errors="replace").strip().splitlines()[-1:]
    return Failure(f"the process failed: {' '.join(last)}", "failed")


def main() -> None:
    """The other process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # whoever waits for the answer heeds it
    warnings.simplefilter("ignore")
    memory.limit_to_available()
    task, arguments = pickle.load(sys.stdin.buffer)
    answer: Any
    try:
        answer = task(*arguments)
    except LinkworkError as error:
        answer = Failure(str(error), error.code)
    except MemoryError:
        answer = Failure("not enough memory", "memory")
    pickle.dump(answer, sys.stdout.buffer)
