"""A study as a page of parallel coordinates, and a server on this machine that opens the motion of a case."""

from __future__ import annotations

import html
import json
import re
import threading
from importlib import resources
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork.errors import LinkworkError, OptionError
from linkwork.studies.pictures import Column, numbers_of
from linkwork.view.local_server import Answer, LocalServer
from linkwork.view.page import Page

if TYPE_CHECKING:
    from linkwork.studies.study import Study

__all__ = ["Server", "page"]

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


class Server(LocalServer):
    """The page of a study on this machine, at `url`; a click on a case opens its motion, simulated again.

    Only programs of this machine reach it, and of them those that know the address: a part of it is random. A
    context manager; `close` ends it.
    """

    def __init__(self, study: Study, port: int = 0) -> None:
        """OptionError: the port is taken, or nothing in the study varies."""
        self.study = study
        self._page = page(study).html.encode()
        self._busy = threading.Lock()  # functions of the user's own may not stand two threads
        super().__init__(port)

    def answer(self, path: str) -> Answer | None:
        """The page, or the motion of a case: `motion/7`."""
        if not path:
            return Answer(self._page)
        match = re.fullmatch(r"motion/([0-9]{1,9})", path, re.ASCII)
        return None if match is None else self._motion(int(match[1]))

    def _motion(self, number: int) -> Answer:
        try:
            with self._busy:
                return Answer(self.study.simulate(number).view().html.encode())
        except LinkworkError as error:
            return Answer.of_text(f"case {number}: {error}", 500)
