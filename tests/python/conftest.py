"""Settings of all Python tests."""

import os
import signal

from hypothesis import settings

# A slow machine is no failure of the code; in CI the examples are the same every time.
settings.register_profile("linkwork", deadline=None, derandomize="CI" in os.environ, print_blob=True)
settings.load_profile("linkwork")

# Started in the background, these programs ignore interrupts, which some tests are about.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
