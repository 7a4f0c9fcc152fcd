"""Whether a process that has lived longer, or is elsewhere, would run what is meant here.

Functions go to other processes by name, and are there what they were when their module was imported: a worker
that began before a file was edited would compute with the former one, and its numbers be kept as those of the
new one. So each process says before the first case what it would run, and nothing is run that is another.
"""

from __future__ import annotations

import collections
import os
import socket
import sys
import uuid
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from linkwork.errors import LinkworkError
from linkwork.fingerprints import digest
from linkwork.running.manifest import platform_facts
from linkwork.studies.cases import Answer, Case, Runner
from linkwork.studies.outputs import Output
from linkwork.studies.variants import Built, Source

__all__ = ["Refusal", "Sent", "contents"]

#: Of this process and those forked from it.
_BORN = uuid.uuid4().hex

#: Studies that this process has agreed to run: nothing is imported anew within one.
_AGREED: collections.deque[str] = collections.deque(maxlen=32)

#: Options without functions go along as they are.
_DATA = (str, int, float, type(None))


@dataclass(frozen=True)
class Refusal:
    """What a process gives back that would run something else, and where it has it from."""

    where: str
    versions: Mapping[str, str]
    others: Mapping[str, str]


@dataclass(frozen=True)
class Sent:
    """A runner on its way to other processes. `here`: what it runs in this one, see `contents`."""

    runner: Runner
    here: Mapping[str, str]
    study: str = field(default_factory=lambda: uuid.uuid4().hex)
    home: tuple[str, int] = field(default_factory=lambda: (_BORN, os.getpid()))

    def __call__(self, cases: Sequence[Case]) -> Answer | Refusal:
        if self.home != (_BORN, os.getpid()) and self.study not in _AGREED:
            if refusal := self._refusal():
                return refusal
            _AGREED.append(self.study)
        return self.runner(cases)

    def _refusal(self) -> Refusal | None:
        runner = self.runner
        there = contents(runner.source, runner.outputs, runner.options)
        others = {name for name, it in self.here.items() if there.get(name) != it and name != "Python"}
        if not others:
            return None
        told = _functions(runner.source, runner.outputs, runner.options)
        files = {name: _file_of(told.get(name)) for name in sorted(others)}
        versions = {name: there[name] for name in ("linkwork", "Python")}
        return Refusal(f"process {os.getpid()} of {socket.gethostname()}", versions, files)

    def error(self, refusal: Refusal) -> LinkworkError:
        """That a study ends with: what differs, and what to do."""
        name = "linkwork" if "linkwork" in refusal.others else "Python"
        mine, its = self.here[name], refusal.versions[name]
        if mine != its:
            told = f"runs {name} {its}, and this process {mine}: give both the same"
        else:
            listed = [name + (f" (of {file})" if file else "") for name, file in refusal.others.items()]
            told = f"has another {', another '.join(listed)}: its code, or data that it reads, is not as here"
        return LinkworkError(
            f"executor: the worker, {refusal.where}, {told}. Restart the workers, which then import what is "
            "there now, and run the study again; nothing was computed with the other one",
            code="executor",
        )


def contents(source: Source, outputs: Sequence[Output], options: Mapping[str, Any]) -> dict[str, str]:
    """By name: digests of the functions that cases call, and versions. The rest of a study goes along."""
    versions = {"linkwork": str(platform_facts()["versions"]["linkwork"]),
                "Python": ".".join(map(str, sys.version_info[:2]))}  # fmt: skip
    return versions | {name: digest(it) for name, it in _functions(source, outputs, options).items()}


def _functions(source: Source, outputs: Sequence[Output], options: Mapping[str, Any]) -> dict[str, Any]:
    found = {f"function {source.name}": source.build} if isinstance(source, Built) else {}
    told = {f"function of the output '{it.label}'": it.function for it in outputs if it.function is not None}
    given = {f"option '{name}'": it for name, it in options.items() if not isinstance(it, _DATA)}
    return {**found, **told, **given}


def _file_of(value: Any) -> str:
    """Of the module of a function; empty: of none that is known."""
    module = getattr(value, "__module__", None) or type(value).__module__
    return str(getattr(sys.modules.get(module), "__file__", None) or "")
