"""Time to save and load a model of many bodies: python tests/benchmarks/model_files.py [BODIES] [SUFFIX]"""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path

import linkwork as lw


def main(bodies: int = 100_000, suffix: str = ".json") -> None:
    model = lw.mechanisms.chain(bodies)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"chain{suffix}")
        for name, action in (
            ("save", lambda: model.save(path, overwrite=True)),
            ("load", lambda: lw.Model.load(path)),
        ):
            wall, cpu = time.perf_counter(), time.process_time()
            action()
            wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
            size = path.stat().st_size / 1e6
            print(f"{name} {bodies:,} bodies: {wall:.2f} s ({cpu:.2f} s of CPU), {size:.1f} MB")


if __name__ == "__main__":
    main(*(convert(word) for convert, word in zip((int, str), sys.argv[1:], strict=False)))
