"""The XML of an MJCF file with what it includes and attaches, which MuJoCo reads by itself."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from linkwork.errors import LinkworkError
from linkwork.importers.xml_text import Node, Reader

__all__ = ["roots"]

#: Levels of files in files.
DEPTH = 50


def roots(reader: Reader, unread: Callable[[Node, str], None]) -> list[Node]:
    """The root of the file, with the elements of included files in place of each <include>, and the roots of
    the models that are attached. All that other files hold has the line of what leads to them.

    `unread` is called with the element and the reason where another file cannot be read here.
    """
    files = _Files(Path(reader.path).resolve().parent, unread)
    main = files.expanded(reader.root, files.folder, None, 0)
    return [main, *files.attached]


class _Files:
    def __init__(self, folder: Path, unread: Callable[[Node, str], None]) -> None:
        self.folder, self._unread = folder, unread
        self.attached: list[Node] = []

    def expanded(self, node: Node, folder: Path, line: int | None, depth: int) -> Node:
        """With what is included; `line` instead of the node's own, in another file than the first."""
        out = _copied(node, line)
        copied = [(node, out)]  # elements may be deeper in each other than calls
        for old, new in copied:  # which grows meanwhile
            new.children = children = list[Node]()
            for child in old.children:
                if child.tag == "include":
                    children += self._read(child, folder, line, depth)
                    continue
                children.append(_copied(child, line))
                copied.append((child, children[-1]))
                if (old.tag, child.tag) == ("asset", "model"):
                    root = Node("mujoco", {}, children[-1].line)
                    root.children = self._read(child, folder, line, depth)
                    self.attached.append(root)
        return out

    def _read(self, node: Node, folder: Path, line: int | None, depth: int) -> Sequence[Node]:
        """What is in the file of an element: it is beside the file that names it, or beside the first one."""
        name = node.attributes.get("file", "")
        paths = [path for path in (folder / name, self.folder / name) if path.is_file()]
        try:
            if not paths or depth >= DEPTH:
                raise LinkworkError("is not found" if depth < DEPTH else "is one of too many in each other")
            reader = Reader(paths[0], None)
        except LinkworkError as error:
            self._unread(node, error.message)
            return []
        at = node.line if line is None else line
        return self.expanded(reader.root, paths[0].parent, at, depth + 1).children


def _copied(node: Node, line: int | None) -> Node:
    """Without what is in it; `line` as for _Files.expanded."""
    out = Node(node.tag, node.attributes, node.line if line is None else line)
    out.text = node.text
    return out
