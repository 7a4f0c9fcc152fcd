"""A server of pages for this machine alone."""

from __future__ import annotations

import hmac
import http.server
import logging
import secrets
import socket
import threading
from abc import ABC, abstractmethod
from contextlib import suppress
from typing import NamedTuple, Self

from linkwork.errors import OptionError

__all__ = ["Answer", "LocalServer"]

log = logging.getLogger(__name__)

#: Between two looks whether it is to end, or a signal has come [s].
LOOK = 0.1

#: A page has its script and style in itself, and may ask this server alone.
HEADERS = {
    "Cache-Control": "no-store",
    "Content-Security-Policy": "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data: blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
}


class Answer(NamedTuple):
    """What a path means."""

    body: bytes
    kind: str = "text/html; charset=utf-8"
    status: int = 200

    @classmethod
    def of_text(cls, sentence: str, status: int) -> Answer:
        return cls(sentence.encode(), "text/plain; charset=utf-8", status)


class LocalServer(ABC):
    """Gives out `answer` at `url` on this machine.

    Only programs of this machine reach it, and of them those that know the address: a part of it is random. A
    context manager; `close` ends it.
    """

    def __init__(self, port: int) -> None:
        """OptionError: the port is taken, or is none."""
        try:
            self._listener = _Listener(port, self)
        except OSError as error:
            raise _refused(port, error.strerror or str(error)) from error
        except (OverflowError, TypeError) as error:
            raise _refused(port, str(error)) from error
        own = self._listener.server_address[1]
        self._hosts = {f"127.0.0.1:{own}", f"localhost:{own}"}
        self._token = secrets.token_urlsafe(16)
        self.url = f"http://127.0.0.1:{own}/{self._token}/"
        self._thread = threading.Thread(
            target=self._listener.serve_forever, args=(LOOK,), name="linkwork pages", daemon=True
        )
        self._thread.start()

    @abstractmethod
    def answer(self, path: str) -> Answer | None:
        """To what stands behind `url`; None: there is no such page. Several threads ask at the same time."""

    def wait(self) -> None:
        """Until `close` is called, or a signal comes."""
        while self._thread.is_alive():
            self._thread.join(LOOK)

    def close(self) -> None:
        """End it, and the connections of pages that are open, which keep what they have."""
        self._listener.end()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<Server at {self.url}>"

    def _answer(self, host: str | None, path: str) -> Answer:
        if host not in self._hosts:  # another name that leads here
            return Answer.of_text("This server is of this machine alone.", 403)
        token, separator, rest = path.removeprefix("/").partition("/")
        known = separator and hmac.compare_digest(token.encode(), self._token.encode())
        found = self.answer(rest) if known else None
        return found or Answer.of_text("There is no such page.", 404)


def _refused(port: object, why: str) -> OptionError:
    return OptionError(f"port {port!r:.40}: {why}; 0 takes a free one", code="port")


class _Listener(http.server.ThreadingHTTPServer):
    """On this machine alone; knows the connections that are open, which would outlive it."""

    def __init__(self, port: int, owner: LocalServer) -> None:
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
        found = self.server.owner._answer(self.headers.get("Host"), self.path)
        try:
            self.send_response(found.status)
            for name, value in HEADERS.items():
                self.send_header(name, value)
            self.send_header("Content-Type", found.kind)
            self.send_header("Content-Length", str(len(found.body)))
            self.end_headers()
            self.wfile.write(found.body)
        except ConnectionError:  # the page does not need it any more
            self.close_connection = True

    def log_message(self, format: str, *args: object) -> None:
        log.debug(format, *args)
