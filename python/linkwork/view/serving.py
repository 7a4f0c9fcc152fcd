"""The page by a server on this machine: it asks for the poses near the time it shows, of all frames.

What can be plotted and drawn is in the page; poses are read from the result as they are asked for, so that
neither the server nor the page ever holds all of them.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from linkwork.errors import LinkworkError
from linkwork.view.local_server import Answer, LocalServer
from linkwork.view.page import streamed_page
from linkwork.view.poses import page_origin, stream_piece

if TYPE_CHECKING:
    from linkwork.results.result import Result

__all__ = ["Server"]


class Server(LocalServer):
    """The page of a result, or of two, at `url` on this machine, with all their frames.

    Only programs of this machine reach it, and of them those that know the address: a part of it is random.
    Nothing but the page and the poses in the results is given out. A context manager; `close` ends it.
    """

    def __init__(self, results: Sequence[Result], labels: Sequence[str] = (), port: int = 0) -> None:
        """OptionError: the port is taken, the labels are no names, or a result has no frames."""
        self._origin = page_origin(results[0])
        page, self._pieces = streamed_page(results, labels, self._origin)
        self._results, self._page = list(results), page.html.encode()
        super().__init__(port)

    def answer(self, path: str) -> Answer | None:
        """The page, or a piece of the poses of a run: `poses0-7`."""
        if not path:
            return Answer(self._page)
        match = re.fullmatch(r"poses([01])-([0-9]{1,9})", path, re.ASCII)
        if match is None:
            return None
        run, number = map(int, match.groups())
        if run >= len(self._results) or number >= self._pieces[run]:
            return None
        try:
            return Answer(stream_piece(self._results[run], number, self._origin), "application/octet-stream")
        except LinkworkError as error:  # the file is gone, or is another by now
            return Answer.of_text(str(error), 410)
