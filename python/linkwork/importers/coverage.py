"""What becomes of each element and attribute of a format: it is represented, noted or refused.

The lists of a format are a module of their own (mjcf_coverage, sdf_coverage, urdf_coverage), in lines such as

    body                    the element
    body: pos quat          the element and attributes of it
    body @ gravcomp         only attributes of it
    link > gravity pose     elements in it
    visual/**               the element and all that is in it

Elements are named by what they are in, without the root. What stands in none of the lists is noted by name
when it is met in a file.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from linkwork.importers.xml_text import Node

__all__ = ["Coverage", "Entry", "Met", "Noted", "Refused", "report"]


@dataclass(frozen=True)
class Entry:
    """The list that an element or attribute stands in, with the topic or reason of that list."""

    kind: str  #: represented, noted or refused
    topic: str = ""
    text: str = ""
    by_name: bool = False


#: What stands in no list.
UNKNOWN = Entry("noted", "element", "is not represented: it is not known here")

#: What is in an element again that is in it once.
AGAIN = Entry("noted", "element", "is there again: the first is taken")

#: What has no text in the format.
TEXT = Entry("noted", "element", "has text, which is not taken")


@dataclass(frozen=True)
class Noted:
    """Not in the model, or in another way, which is said once a file."""

    topic: str
    text: str  #: what follows the names of what was met
    items: str
    #: The importer itself says so, of each thing that it concerns, and only where it concerns one.
    by_name: bool = False


@dataclass(frozen=True)
class Refused:
    """A file with it is refused."""

    reason: str
    items: str
    by_name: bool = False  #: by the importer itself


@dataclass(frozen=True)
class Met:
    """An element or attribute in a file."""

    node: Node
    attribute: str  #: empty: the element
    key: str
    entry: Entry | None  #: None: it stands in no list

    @property
    def label(self) -> str:
        return f"<{self.node.tag}> {self.attribute}".strip()


class Coverage:
    """The three lists of a format.

    same     elements that mean the same in another place: their key there
    inside   elements whose children are those of another one
    several  represented elements of which another element may have several; of others the first is taken, and
             the rest noted; None: all of them
    texts    elements without others inside may have a text; False: values are attributes, none has
    """

    def __init__(
        self,
        represented: str,
        noted: Sequence[Noted] = (),
        refused: Sequence[Refused] = (),
        same: Mapping[str, str] | None = None,
        inside: Mapping[str, str] | None = None,
        several: str | None = None,
        texts: bool = True,
    ) -> None:
        self._several = None if several is None else several.split()
        self._same, self._inside = same or {}, inside or {}
        self.entries: dict[str, Entry] = {}
        self.twice: list[str] = []  #: what stands in two lists, or twice in one
        self._add(represented, Entry("represented"))
        for note in noted:
            self._add(note.items, Entry("noted", note.topic, note.text, note.by_name))
        for refusal in refused:
            self._add(refusal.items, Entry("refused", "", refusal.reason, refusal.by_name))
        self._texts = texts
        places = [*self.entries, *self._same]
        self._around = {key.partition("@")[0].rpartition("/")[0] for key in places}  # the root is empty

    def _add(self, items: str, entry: Entry) -> None:
        for key in _keys(items):
            if key in self.entries or any(whole in self.entries for whole in _wholes(key)):
                self.twice.append(key)
            self.entries[key] = entry

    def __getitem__(self, key: str) -> Entry | None:
        """Of an element, such as body/joint, or an attribute, such as body/joint@damping."""
        found = self.entries.get(key)
        return found or next((self.entries[whole] for whole in _wholes(key) if whole in self.entries), None)

    def key(self, parent: str, tag: str) -> str:
        """Of an element in the element of another key; the root's is empty."""
        around = self._inside.get(parent, parent)
        key = f"{around}/{tag}" if around else tag
        return self._same.get(key, key)

    def survey(self, root: Node) -> Iterator[Met]:
        """All in a file, in its order; of what is listed as a whole only the outermost element."""
        waiting = [Met(root, "", "", Entry("represented"))]
        while waiting:  # elements may be deeper in each other than calls
            met = waiting.pop()
            if met.key:
                yield met
            if met.entry not in (None, AGAIN) and f"{met.key}/**" not in self.entries:
                yield from self._at(met.node, met.key)
                waiting += reversed(list(self._below(met.node, met.key)))

    def _at(self, node: Node, key: str) -> Iterator[Met]:
        """The text and the attributes of an element."""
        if node.text.strip() and (key in self._around or not self._texts):
            yield Met(node, "", key, TEXT)
        for attribute in node.attributes:
            if not attribute.startswith("xmlns"):
                yield Met(node, attribute, f"{key}@{attribute}", self[f"{key}@{attribute}"])

    def _below(self, node: Node, key: str) -> Iterator[Met]:
        """The elements in an element."""
        seen: set[str] = set()
        for child in node.children:
            inner = self.key(key, child.tag)
            again = inner in seen and self._is_single(inner)
            seen.add(inner)
            yield Met(child, "", inner, AGAIN if again else self[inner])

    def _is_single(self, key: str) -> bool:
        entry = self[key]
        represented = entry is not None and entry.kind == "represented"
        return represented and self._several is not None and key not in self._several


def report(
    met: Iterable[Met], note: Callable[[str, str, str], None], refuse: Callable[[Node, str, str], None]
) -> None:
    """Notes and refusals: one for each topic; of "element", and of what is in no list, one for each name."""
    topics: dict[tuple[str, str], Counter[str]] = {}
    names: dict[tuple[str, str], list[int]] = {}
    for one in met:
        entry = one.entry or UNKNOWN
        if entry.by_name or entry.kind == "represented":
            continue
        if entry.kind == "refused":
            refuse(one.node, _who(one), entry.text)
        elif entry.topic == "element":
            names.setdefault((one.label, entry.text), []).append(one.node.line)
        else:
            topics.setdefault((entry.topic, entry.text), Counter())[one.label] += 1
    for (topic, text), labels in topics.items():
        listed = ", ".join(f"{label} ({n})" if n > 1 else label for label, n in labels.items())
        note(topic, "model", f"{listed}: {text}")
    for (label, text), lines in names.items():
        more = f" and {len(lines) - 1} other places" if len(lines) > 1 else ""
        note("element", label, f"in line {lines[0]}{more} {text}")


def _who(met: Met) -> str:
    name = met.node.attributes.get("name")
    return f"{met.label} '{name}'" if name and not met.attribute else met.label


def _keys(items: str) -> Iterator[str]:
    """Of the lines of a list, as at the top of this file."""
    for line in filter(None, map(str.strip, items.splitlines())):
        for sign in (":", "@", ">"):
            path, found, names = line.partition(sign)
            if found:
                path = path.strip()
                if sign == ":":
                    yield path
                yield from (f"{path}{'/' if sign == '>' else '@'}{name}" for name in names.split())
                break
        else:
            yield line


def _wholes(key: str) -> Iterator[str]:
    """The keys of what, listed as a whole, it would be in."""
    whole = key.endswith("/**")
    path = key.partition("@")[0].removesuffix("/**").split("/")
    yield from ("/".join(path[:n]) + "/**" for n in range(len(path) - whole, 0, -1))
