"""Settings of all Python tests."""

import gc
import os
import re
import signal

import pytest
from hypothesis import settings

# A slow machine is no failure of the code; in CI the examples are the same every time.
settings.register_profile("linkwork", deadline=None, derandomize="CI" in os.environ, print_blob=True)
settings.load_profile("linkwork")

# Started in the background, these programs ignore interrupts, which some tests are about.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Random mechanisms have elements about an axis between bodies that tilt against it."""
    ignored = pytest.mark.filterwarnings("ignore:.*depends on the choice of x axes")
    drawn: dict[str, bool] = {}
    for item in items:
        path = str(item.path)
        if path not in drawn:
            text = item.path.read_text(encoding="utf-8")
            drawn[path] = bool(re.search(r"(random|light)_mechanisms|first_release", text))
        if drawn[path]:
            item.add_marker(ignored)


def pytest_collection_finish() -> None:
    """Ten thousand tests are no garbage: not to be looked through again and again."""
    gc.collect()
    gc.freeze()
