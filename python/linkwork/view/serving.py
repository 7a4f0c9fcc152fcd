"""The page by a server on this machine: it asks for the poses near the time it shows, of all frames.

What can be plotted and drawn is in the page; poses are read from the result as they are asked for, so that
neither the server nor the page ever holds all of them.
"""

from __future__ import annotations

import hmac
import http.server
import logging
import re
import secrets
import socket
import threading
from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

from linkwork.errors import LinkworkError, OptionError
from linkwork.view.page import streamed_page
from linkwork.view.poses import stream_piece

if TYPE_CHECKING:
    from linkwork.results.result import Result

__all__ = ["Server"]

log = logging.getLogger(__name__)

#: Between two looks whether it is to end, or a signal has come [s].
LOOK = 0.1

#: The page has its script and style in itself, and may ask this server alone.
HEADERS = {
    "Cache-Control": "no-store",
    "Content-Security-Policy": "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data: blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
}


class Server:
    """The page of a result, or of two, at `url` on this machine, with all their frames.

    Only programs of this machine reach it, and of them those that know the address: a part of it is random.
    Nothing but the page and the poses in the results is given out. A context manager; `close` ends it.
    """

    def __init__(self, results: Sequence[Result], labels: Sequence[str] = (), port: int = 0) -> None:
        """OptionError: the port is taken, the labels are no names, or a result has no frames."""
        page, self._pieces = streamed_page(results, labels)
        self._results, self._page = list(results), page.html.encode()
        try:
            self._listener = _Listener(port, self)
        except (OSError, OverflowError, TypeError) as error:
            raise OptionError(f"port {port!r:.40}: {error}; 0 takes a free one", code="port") from error
        own = self._listener.server_address[1]
        self.hosts = {f"127.0.0.1:{own}", f"localhost:{own}"}
        self._token = secrets.token_urlsafe(16)
        self.url = f"http://127.0.0.1:{own}/{self._token}/"
        self._thread = threading.Thread(
            target=self._listener.serve_forever, args=(LOOK,), name="view", daemon=True
        )
        self._thread.start()

    def wait(self) -> None:
        """Until `close` is called, or a signal comes."""
        while self._thread.is_alive():
            self._thread.join(LOOK)

    def close(self) -> None:
        """End it, and the connections of pages that are open, which keep what they have."""
        self._listener.end()

    def __enter__(self) -> Server:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<Server of a result at {self.url}>"

    def content(self, path: str) -> tuple[str, bytes] | None:
        """Type and bytes of what a path means; None: nothing."""
        match = re.fullmatch(r"/([\w-]{1,64})/(?:poses([01])-([0-9]{1,9}))?", path, re.ASCII)
        if match is None or not hmac.compare_digest(match[1], self._token):
            return None
        if match[2] is None:
            return "text/html; charset=utf-8", self._page
        run, number = int(match[2]), int(match[3])
        if run >= len(self._results) or number >= self._pieces[run]:
            return None
        return "application/octet-stream", stream_piece(self._results[run], number)


class _Listener(http.server.ThreadingHTTPServer):
    """On this machine alone; knows the connections that are open, which would outlive it."""

    def __init__(self, port: int, owner: Server) -> None:
        self.owner = owner
        self.connections: set[socket.socket] = set()
        super().__init__(("127.0.0.1", port), _Handler)

    def end(self) -> None:
        self.shutdown()
        self.server_close()
        for connection in list(self.connections):
            with suppress(OSError):
                connection.shutdown(socket.SHUT_RDWR)


class _Handler(http.server.BaseHTTPRequestHandler):
    """Answers the questions of one connection."""

    server: _Listener
    protocol_version = "HTTP/1.1"  # connections stay: a motion that plays asks some times a second
    server_version, sys_version = "linkwork", ""

    def setup(self) -> None:
        super().setup()
        self.server.connections.add(self.connection)

    def finish(self) -> None:
        self.server.connections.discard(self.connection)
        super().finish()

    def do_GET(self) -> None:
        if self.headers.get("Host") not in self.server.owner.hosts:  # another name that leads here
            self._answer(403, *_text("This server is of this machine alone."))
            return
        try:
            found = self.server.owner.content(self.path)
        except LinkworkError as error:  # the file is gone, or is another by now
            self._answer(410, *_text(str(error)))
            return
        self._answer(*((404, *_text("There is no such page.")) if found is None else (200, *found)))

    def _answer(self, status: int, kind: str, body: bytes) -> None:
        try:
            self.send_response(status)
            for name, value in HEADERS.items():
                self.send_header(name, value)
            self.send_header("Content-Type", kind)
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)
        except ConnectionError:  # the page does not need it any more
            self.close_connection = True

    def log_message(self, format: str, *args: object) -> None:
        log.debug(format, *args)


def _text(sentence: str) -> tuple[str, bytes]:
    return "text/plain; charset=utf-8", sentence.encode()
