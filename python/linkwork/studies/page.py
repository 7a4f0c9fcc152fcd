"""A study as a page of parallel coordinates, and a server on this machine that opens the motion of a case."""

from __future__ import annotations

import html
import http.server
import json
import logging
import re
import threading
from importlib import resources
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork.errors import LinkworkError, OptionError
from linkwork.studies.pictures import Column, numbers_of
from linkwork.view.page import Page

if TYPE_CHECKING:
    from linkwork.studies.study import Study

__all__ = ["Server", "page"]

log = logging.getLogger(__name__)

#: Lines of a page; beyond them cases are left out evenly, and it says so.
LINES = 20_000

#: Axes of a page.
AXES = 40


def page(study: Study) -> Page:
    """See Study.view."""
    columns = numbers_of(study)
    if not columns or not len(study):
        raise OptionError("study: no parameter or output is a number that varies", code="outputs")
    every = -(-len(study) // LINES)
    cases = range(0, len(study), every)
    parts = [
        f"{len(study)} cases: "
        + ", ".join(
            f"{count} {name}"
            for name in ("finished", "failed", "skipped")
            if (count := (study.status == name).sum())
        )
    ]
    parts += [f"one of {every} is drawn"] if every > 1 else []
    parts += [f"the first {AXES} of {len(columns)} columns"] if len(columns) > AXES else []
    names = list(study.parameters)
    title = "Study of " + ", ".join(names[:4]) + (f" and {len(names) - 4} more" if len(names) > 4 else "")
    document = {
        "title": title, "about": "; ".join(parts), "cases": list(cases),
        "status": study.status[::every].tolist(), "verdict": study.verdict[::every].tolist(),
        "axes": [_axis(column, every) for column in columns[:AXES]],
    }  # fmt: skip
    template = resources.files("linkwork.studies").joinpath("study.html").read_text(encoding="utf-8")
    data = json.dumps(document, separators=(",", ":")).replace("<", "\\u003c")
    return Page(template.replace("{title}", html.escape(title)).replace("{study}", data))


def _axis(column: Column, every: int) -> dict[str, Any]:
    finite = column.values[np.isfinite(column.values)]
    values = [float(it) if np.isfinite(it) else None for it in column.values[::every]]
    return {
        "label": column.label,
        "least": float(finite.min()),
        "most": float(finite.max()),
        "values": values,
    }


class Server:
    """The page of a study on this machine, at `url`; a click on a case opens its motion, simulated again.

    Only programs of this machine reach it. A context manager; `close` ends it.
    """

    def __init__(self, study: Study, port: int = 0) -> None:
        """OptionError: the port is taken."""
        self.study = study
        found = page(study)
        try:
            self._server = http.server.ThreadingHTTPServer(("127.0.0.1", port), _handler(study, found))
        except (OSError, OverflowError, TypeError) as error:
            raise OptionError(f"port {port!r:.40}: {error}; 0 takes a free one", code="port") from error
        self.url = f"http://127.0.0.1:{self._server.server_address[1]}/"
        self._thread = threading.Thread(target=self._server.serve_forever, name="study", daemon=True)
        self._thread.start()

    def close(self) -> None:
        self._server.shutdown()
        self._server.server_close()

    def __enter__(self) -> Server:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<Server of a study at {self.url}>"


def _handler(study: Study, found: Page) -> type[http.server.BaseHTTPRequestHandler]:
    busy = threading.Lock()  # functions of the user's own may not stand two threads

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            match = re.fullmatch(r"/motion/(\d{1,9})", self.path)
            if self.path == "/":
                self._answer(200, found.html)
            elif match is None:
                self._answer(404, "<p>There is no such page.")
            else:
                self._motion(int(match[1]))

        def _motion(self, number: int) -> None:
            try:
                with busy:
                    text = study.simulate(number).view().html
                self._answer(200, text)
            except LinkworkError as error:
                self._answer(500, f"<p>case {number}: {html.escape(str(error))}")

        def _answer(self, status: int, text: str) -> None:
            body = text.encode()
            self.send_response(status)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, format: str, *args: Any) -> None:
            log.debug(format, *args)

    return Handler
