"""Settings of all Python tests."""

import os

from hypothesis import settings

# A slow machine is no failure of the code; in CI the examples are the same every time.
settings.register_profile("linkwork", deadline=None, derandomize="CI" in os.environ, print_blob=True)
settings.load_profile("linkwork")
