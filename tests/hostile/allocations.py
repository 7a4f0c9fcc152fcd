"""One allocation that fails, anywhere in a call: MemoryError, or the right numbers.

Of those of LEAST bytes: where smaller ones fail, numpy and pybind11 lose the error or end the process.
Files of models are not tried: pydantic ends the process where it has no memory.

Runs by itself in a process with failing_malloc.c preloaded: `allocations.py SEED COUNT`; prints what failed.
"""

from __future__ import annotations

import ctypes
import os
import random
import signal
import sys
import warnings
from collections.abc import Callable

import linkwork as lw
import numpy as np
from linkwork import mechanisms

#: Beyond what the longest of the calls below allocates.
MOST = 1500

LEAST = 256

#: What Python says where numpy forgets to name the error.
LOST = ("error return without exception set", "without setting an exception")

#: Of one call [s].
PATIENCE = 60

Call = Callable[[], bytes]


def calls(rng: random.Random) -> dict[str, Call]:
    """What is tried, each with all that it needs but what it makes itself."""
    model = rng.choice([mechanisms.four_bar, mechanisms.bricard, mechanisms.bennett])()
    solver = rng.choice(["block", "klu", "eigen_ldlt", "dense", "spqr", "umfpack", "cholmod"])
    options = {"linear_solver": solver} | ({"matrix_form": "schur"} if solver != "block" else {})
    if solver in ("spqr", "umfpack"):
        options["formulation"], options["matrix_form"] = "augmented_lagrangian", "normal"
    y = lw.System(model).initial_state()

    def derivative() -> bytes:
        return bytes(lw.System(model, **options).derivative(0.0, y))  # type: ignore[arg-type]

    def run() -> bytes:
        found = lw.simulate(model, 0.01, 1e-3, progress=False, on_inaccurate="pass", record_every=1)
        return bytes(np.asarray(found.recorded("q")))

    def adaptive() -> bytes:
        found = lw.simulate(model, 0.01, rtol=1e-6, progress=False, on_inaccurate="pass", record_every=1)
        return bytes(np.asarray(found.recorded("v")))

    def hold() -> bytes:
        held = lw.assemble(model).model
        return bytes(lw.System(held, formulation="penalty").derivative(0.0, y))

    return {"derivative": derivative, "run": run, "adaptive": adaptive, "assemble": hold}


def outcome(call: Call, expected: bytes, n: int, library: ctypes.CDLL) -> int:
    """The exit code of a child in which the n-th allocation of the call fails."""
    pid = os.fork()
    if pid:
        return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
    signal.alarm(PATIENCE)
    code = 3
    try:
        library.fail_after(n, LEAST)
        found = call()
        library.fail_after(0, 0)
        code = 0 if found == expected or close(found, expected) else 2
    except MemoryError:
        code = 0
    except BaseException as error:
        library.fail_after(0, 0)
        print(f"{type(error).__name__}: {error!s:.100}", flush=True)
        code = 0 if caused_by_memory(error) else 1
    finally:
        os._exit(code)


def close(found: bytes, expected: bytes) -> bool:
    """But for the roundoff of pivots that are chosen again where there was no room for the former ones."""
    a, b = np.frombuffer(found), np.frombuffer(expected)
    return a.shape == b.shape and bool(np.allclose(a, b, rtol=1e-9, atol=1e-9 * max(1.0, abs(b).max())))


def caused_by_memory(error: BaseException | None) -> bool:
    """As where a module of Python's own could not be imported, or a file not be read."""
    while error is not None:
        words = str(error).lower()
        if isinstance(error, MemoryError) or any(it in words for it in ("memory", "alloc", *LOST)):
            return True
        error = error.__cause__ or error.__context__
    return False


def main() -> None:
    warnings.simplefilter("ignore")
    rng, count = random.Random(f"allocations {sys.argv[1]}"), int(sys.argv[2])
    library = ctypes.CDLL(None)
    for name, call in calls(rng).items():
        call()
        expected = call()  # everything is imported and kept by now
        for _ in range(count):
            n = int(MOST ** rng.random())
            code = outcome(call, expected, n, library)
            if code:
                print(f"FAILED {name}, allocation {n}: exit code {code}", flush=True)


if __name__ == "__main__":
    main()
