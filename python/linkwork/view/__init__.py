"""The viewer: a run as one HTML file that opens anywhere, without a network.

Its JavaScript is in `src/`, built by `./dev view-bundle` into `bundle/`, which is what is shipped.
"""

from linkwork.view.page import Page, view

__all__ = ["Page", "view"]
