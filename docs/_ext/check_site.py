"""The built site leads nowhere that is not, and asks nothing of a network: python check_site.py FOLDER

Every address in every page is looked up among the files and their anchors; nothing is loaded from
elsewhere. Where there is a Chromium, pages of each part are opened in it, and what it asks for is noted.
"""

from __future__ import annotations

import re
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

#: Attributes that a browser follows by itself.
LOADED = {
    "script": "src",
    "img": "src",
    "iframe": "src",
    "link": "href",
    "source": "src",
    "video": "src",
    "object": "data",
}

#: Of <link>, what is loaded.
KINDS = ("stylesheet", "icon", "preload", "shortcut icon", "modulepreload")

#: Pages that are opened in a browser, at least.
OPENED = ("index.html", "guide/joints.html", "theory/stabilization.html", "gallery/index.html",
          "reference/made/model.html",
          "search.html")  # fmt: skip


class Reader(HTMLParser):
    """The addresses and the anchors of a page."""

    def __init__(self) -> None:
        super().__init__()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.anchors: set[str] = set()

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        values = {name: value or "" for name, value in attributes}
        self.anchors |= {values[name] for name in ("id", "name") if name in values}
        if tag == "a" and "href" in values:
            self.links.append(values["href"])
        address = values.get(LOADED.get(tag, ""), "")
        if address and not (tag == "link" and values.get("rel") not in KINDS):
            self.loaded.append(address)


@cache
def read(page: Path) -> Reader:
    reader = Reader()
    reader.feed(page.read_text(encoding="utf-8"))
    return reader


def faults(site: Path) -> Iterator[str]:
    """One line for each address that leads nowhere or is loaded from elsewhere."""
    for page in sorted(site.rglob("*.html")):
        if page.parent.name in (
            "_made",
            "_static",
        ):  # viewers are tested where they are made; themes have templates
            continue
        reader, where = read(page), page.relative_to(site)
        for address in reader.loaded:
            if urlsplit(address).scheme in ("http", "https") or address.startswith("//"):
                yield f"{where}: loads {address}"
        for address in {*reader.links, *reader.loaded}:
            if not leads_somewhere(site, page, address):
                yield f"{where}: {address} leads nowhere"
    for sheet in site.rglob("*.css"):
        for address in re.findall(
            r"(?:url\(|@import )[\"']?(https?://[^)\"']+)", sheet.read_text(encoding="utf-8")
        ):
            yield f"{sheet.relative_to(site)}: loads {address}"


def leads_somewhere(site: Path, page: Path, address: str) -> bool:
    parts = urlsplit(address)
    if parts.scheme or address.startswith("//"):
        return True
    target = (page.parent / unquote(parts.path)).resolve() if parts.path else page
    target = target / "index.html" if target.is_dir() else target
    if not target.is_file() or not target.is_relative_to(site):
        return False
    anchor = unquote(parts.fragment)
    return (
        not anchor
        or target.suffix != ".html"
        or target.parent.name == "_made"
        or anchor in read(target).anchors
    )


def requested(site: Path) -> Iterator[str]:
    """What pages ask for beside files."""
    sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "python"))
    import chromium

    if chromium.EXECUTABLE is None:
        print("no Chromium here: what pages request was not looked at")
        return
    with tempfile.TemporaryDirectory() as profile, chromium.browser(Path(profile)) as tab:
        for domain in ("Page", "Runtime", "Network", "Log"):
            tab.call(f"{domain}.enable")
        for name in OPENED:
            tab.call("Page.navigate", url=(site / name).as_uri())
            tab.wait_for("document.readyState === 'complete'")
            tab.evaluate("new Promise((done) => setTimeout(done, 500))")
            width = tab.evaluate("document.documentElement.scrollWidth - window.innerWidth")
            if width > 0:
                yield f"{name}: is wider than the window by {width} pixels"
        yield from unsearchable(site, tab)
        yield from (
            f"a page requests {address}" for address in tab.requests if not address.startswith("file:")
        )
        yield from (f"a page complains: {complaint[:300]}" for complaint in tab.complaints)


def unsearchable(site: Path, tab: Any) -> Iterator[str]:
    """The search finds, from disk, what is there."""
    tab.call("Page.navigate", url=f"{(site / 'search.html').as_uri()}?q=nilpotent")
    try:
        tab.wait_for("document.querySelectorAll('#search-results li').length > 0")
    except AssertionError:
        yield "search.html: does not find 'nilpotent'"


def main() -> None:
    site = Path(sys.argv[1]).resolve()
    found = [*faults(site), *requested(site)]
    print(*found, sep="\n")
    pages = sum(1 for _ in site.rglob("*.html"))
    sys.exit(f"{len(found)} faults in {pages} pages" if found else 0)


if __name__ == "__main__":
    main()
