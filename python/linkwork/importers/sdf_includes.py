"""The files that an SDF file includes: found in its folder and in a search path, and nowhere else."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import NoReturn
from urllib.parse import unquote, urlsplit

from linkwork.arguments import path as path_of
from linkwork.errors import FileError
from linkwork.importers.xml_text import Node, Reader

#: The most includes in all: of files that include the next one twice each, there are soon too many.
MOST = 10_000

#: The version of files that give none.
NEWEST = (1, 11)

#: The first and the last version that are known. What came before had other elements, of other meanings.
OLDEST, LATEST = (1, 2), (1, 12)

#: Models in models, in one file or by includes.
DEPTH = 50


@dataclass(frozen=True)
class Source:
    """A file, its version, and the files that led to it."""

    reader: Reader
    version: tuple[int, int]
    chain: tuple[Path, ...]


@dataclass
class Library:
    """Finds and reads files, each once."""

    folders: Sequence[Path]  #: of the search path
    root: Path  #: folder of the first file
    readers: dict[Path, Reader] = field(default_factory=dict)
    models: int = 0

    @classmethod
    def of(cls, path: str | os.PathLike[str], search_path: Sequence[Path]) -> tuple[Library, Source]:
        """With the first file. FileError: it cannot be read. ModelFileError: it is no SDF."""
        file = path_of(path, "<sdf> file").resolve()
        library = cls(search_path, file.parent)
        library.readers[file] = _reader(path)
        return library, library._source(file, ())

    def _source(self, path: Path, chain: tuple[Path, ...]) -> Source:
        if path not in self.readers:
            self.readers[path] = _reader(path)
        reader = self.readers[path]
        return Source(reader, version(reader.root) or NEWEST, (*chain, path))

    def finish(self) -> None:
        """ModelFileError: there are faults, of the first file that has some."""
        for reader in self.readers.values():
            reader.finish()

    def include(self, node: Node, source: Source) -> tuple[Source, Node] | None:
        """The file and the model that an <include> means; a fault where there is none."""
        uri = node.word("uri") or ""
        self.models += 1
        try:
            if source.reader.boolean(node, node.attributes.get("merge"), "include merge"):
                raise _refused(
                    "is to be merged, which is not taken: leave merge out; names get a prefix then"
                )
            if node.one("placement_frame") is not None and node.one("pose") is None:
                raise _refused("has a placement_frame, which takes a pose: give <pose>")
            if self.models > MOST:
                raise _refused(f"is one of more than {MOST} includes")
            return self._included(uri, source)
        except FileError as error:
            source.reader.add(node, "include", f"'{uri}' {error.message}" if uri else "uri is missing")
            return None

    def _included(self, uri: str, source: Source) -> tuple[Source, Node]:
        path = self._found(uri, source.chain[-1].parent)
        if path in source.chain:
            ring = [*source.chain[source.chain.index(path) :], path]
            raise _refused(f"includes itself: {' -> '.join(file.name for file in ring)}")
        found = self._source(path, source.chain)
        models = list(found.reader.root.all("model"))
        if len(models) != 1:
            raise _refused(f"has {len(models)} models; one is taken")
        return found, models[0]

    def _found(self, uri: str, here: Path) -> Path:
        """The file of a URI: model://name/..., file://..., or a path."""
        try:
            parts = urlsplit(uri)
        except ValueError as error:
            raise _refused(f"is no URI: {error}") from None
        if parts.scheme not in ("", "model", "file"):
            raise _refused("is not here: nothing is downloaded; give a file or model://")
        relative = unquote(parts.netloc + parts.path)
        if not relative.strip("/"):
            raise _refused("names no file")
        folders = [*self.folders, self.root] if parts.scheme == "model" else [here, *self.folders]
        tried = [folder / relative for folder in folders]
        path = next((path for path in tried if os.path.exists(path)), None)
        if path is None:
            places = ", ".join(f"'{folder}'" for folder in dict.fromkeys(folders))
            raise _refused(f"is in none of {places}: give its folder in search_path")
        path = path.resolve()
        if not any(path.is_relative_to(folder) for folder in (self.root, *self.folders)):
            raise _refused(f"is outside of '{self.root}': give its folder in search_path")
        return _model_file(path) if path.is_dir() else path


def _reader(path: str | os.PathLike[str]) -> Reader:
    reader = Reader(path, "sdf")
    found, field = version(reader.root), "sdf version"
    if found is None:
        reader.add(reader.root, field, f"'{_said(reader.root)}' is no version, such as 1.9")
    elif found < OLDEST:
        text = f"{_said(reader.root)} is not taken, which has other elements: convert the file by `gz sdf -p`"
        reader.add(reader.root, field, text)
        reader.finish()
    return reader


def _refused(reason: str) -> FileError:
    return FileError(reason, code="include")


def _no_version(node: Node) -> NoReturn:
    raise _refused(f"has a model.config with the version '{_said(node)}', which is none, such as 1.9")


def _model_file(folder: Path) -> Path:
    """The SDF file of the newest version that model.config names, or model.sdf."""
    config = folder / "model.config"
    name = "model.sdf"
    if config.is_file():
        files = [node for node in Reader(config, "model").root.all("sdf") if node.text.strip()]
        versions = {node: version(node) or _no_version(node) for node in files}
        if files:
            name = max(files, key=versions.__getitem__).text.strip()
    path = (folder / PurePosixPath(name)).resolve()
    if not path.is_relative_to(folder):
        raise _refused(f"leads outside of its folder, to '{name}'")
    if not os.path.isfile(path):
        raise _refused(f"has no file '{name}'")
    return path


def version(node: Node) -> tuple[int, int] | None:
    """Of the format; the newest where none is given, None where it is no version."""
    text = _said(node)
    if not text:
        return NEWEST
    found = re.fullmatch(r"([0-9]+)\.([0-9]+)", text)
    return (int(found[1]), int(found[2])) if found else None


def _said(node: Node) -> str:
    return node.attributes.get("version", "").strip()[:60]
