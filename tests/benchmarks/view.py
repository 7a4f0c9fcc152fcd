"""Size of pages and the time until they show, in software rendering: python tests/benchmarks/view.py

Needs Chromium. Prints a table; the figures wanted are 1.5 MB for 3 bodies and 10 s, 20 MB for 1000 bodies and
300 frames, 10 s until 10 000 bodies are seen.
"""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path

import linkwork as lw

sys.path.insert(0, str(Path(__file__).parents[1] / "python"))
import chromium


def runs() -> dict[str, lw.Result]:
    """Name and result of what is measured."""
    chain = lw.mechanisms.chain
    return {
        "3 bodies, 10 s": lw.simulate(
            lw.mechanisms.spatial_slider_crank(), t_end=10.0, step=1e-3, record_every=1
        ),
        "1000 bodies x 300 frames": lw.simulate(chain(bodies=1000), t_end=0.299, step=1e-3, record_every=1),
        "10000 bodies x 100 frames": lw.simulate(chain(bodies=10000), t_end=0.099, step=1e-3, record_every=1),
        "net, 10000 bodies": lw.simulate(lw.mechanisms.net(n=71), t_end=0.1, step=1e-2, record_every=1),
    }


def main() -> None:
    print(f"{'run':<28}{'page [MB]':>10}{'made [s]':>10}{'shown [s]':>10}{'picture [s]':>12}")
    for name, result in runs().items():
        started = time.perf_counter()
        page = result.view()
        made = time.perf_counter() - started
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
            file = Path(folder, "page.html")
            page.save(file)
            with chromium.browser(Path(folder, "profile")) as tab:
                started = time.perf_counter()
                tab.open(file)
                tab.drawn()
                shown = time.perf_counter() - started
                started = time.perf_counter()
                tab.evaluate("linkwork.player.seek(linkwork.player.end / 2)")
                Path(tempfile.gettempdir(), f"view {result.header.body_count}.png").write_bytes(
                    tab.screenshot()
                )
                picture = time.perf_counter() - started
        print(
            f"{name:<28}{len(page.html) / 1e6:>10.2f}{made:>10.2f}{shown:>10.2f}{picture:>12.2f}", flush=True
        )


if __name__ == "__main__":
    main()
