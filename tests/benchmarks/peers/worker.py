"""One peer with one mechanism, in a process of its own: see comparison.py.

python worker.py PEER MECHANISM RESULTS SECONDS GIGABYTES LIMIT [OPERATION-TO-SKIP ...]

Appends a line of JSON to the file RESULTS when an operation begins, and another with what was found. One that
takes longer than LIMIT [s] in all ends the process, by SIGALRM.
"""

from __future__ import annotations

import importlib
import json
import resource
import signal
import sys
import time
from collections.abc import Mapping
from pathlib import Path

from mechanism import Mechanism
from operation import Builder, OutOfReach


def main() -> None:
    peer, file, results, seconds, gigabytes, limit, *skipped = sys.argv[1:]
    most = int(float(gigabytes) * 2**30)
    resource.setrlimit(resource.RLIMIT_AS, (most, most))
    operations = importlib.import_module(f"{peer}_peer").OPERATIONS
    mechanism = Mechanism.load(Path(file))
    with open(results, "a", buffering=1) as lines:
        for name in [name for name in operations if name not in skipped]:
            print(json.dumps({"operation": name}), file=lines)
            signal.alarm(int(limit))
            begun = time.perf_counter()
            try:
                found = measure(operations[name], mechanism, float(seconds))
            except MemoryError:
                found = {"failure": f"needs more than {gigabytes} GiB"}
            signal.alarm(0)
            print(json.dumps({"operation": name, "spent": time.perf_counter() - begun, **found}), file=lines)


def measure(build: Builder, mechanism: Mechanism, seconds: float) -> Mapping[str, object]:
    """What was found, or why not: no `seconds`, and no `failure` where there was nothing to measure."""
    try:
        operation = build(mechanism)
        if operation is None:
            return {}
        return {
            "seconds": operation.seconds(seconds),
            "counterpart": operation.counterpart,
            "deviation": operation.deviation,
            "tolerance": operation.tolerance,
            "note": operation.note,
        }
    except (OutOfReach, RuntimeError, ValueError) as error:
        return {"failure": str(error)}


if __name__ == "__main__":
    main()
