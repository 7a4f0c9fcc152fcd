"""Whether a process that has lived longer, or is elsewhere, would run what is meant here.

Functions go to other processes by name, and are there what they were when their module was imported: a worker
that began before a file was edited would compute with the former one, and its numbers be kept as those of the
new one. So each process says before the first case what it would run, and nothing is run that is another.

Objects go as copies. The samples of a controller that a function build reads as a variable of its module go
into the copy that came with the event, and the law reads another: so it is compared whether both have one.
"""

from __future__ import annotations

import collections
import functools
import os
import socket
import sys
import uuid
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import FunctionType, MethodType
from typing import Any

from linkwork.blas_threads import one_blas_thread
from linkwork.errors import LinkworkError
from linkwork.fingerprints import digest
from linkwork.modeling.model import Model
from linkwork.running import callbacks
from linkwork.running.kept import CONSTANT, Kept, is_opaque
from linkwork.running.leaving_no_memory import called
from linkwork.running.manifest import platform_facts
from linkwork.studies.cases import Answer, Case, Runner
from linkwork.studies.outputs import Output
from linkwork.studies.variants import Built, Source

__all__ = ["Here", "Refusal", "Sent", "contents", "joined"]

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
    apart: Sequence[str] = ()


@dataclass(frozen=True)
class Here:
    """What this process runs: digests, see `contents`, and functions of a run that have objects with the laws
    of the model in common, see `joined`."""

    contents: Mapping[str, str] = field(default_factory=dict)
    joined: Sequence[str] = ()


@dataclass(frozen=True)
class Sent:
    """A runner on its way to other processes."""

    runner: Runner
    here: Here
    study: str = field(default_factory=lambda: uuid.uuid4().hex)
    home: tuple[str, int] = field(default_factory=lambda: (_BORN, os.getpid()))

    def __call__(self, cases: Sequence[Case]) -> Answer | Refusal:
        if self.home != (_BORN, os.getpid()) and self.study not in _AGREED:
            if refusal := self._refusal() or self._torn(cases):
                return refusal
            _AGREED.append(self.study)
        with one_blas_thread():  # others of the executor are beside it
            return self.runner(cases)

    def _refusal(self) -> Refusal | None:
        runner = self.runner
        there = contents(runner.source, runner.outputs, runner.options)
        mine = self.here.contents
        others = {name for name, it in mine.items() if there.get(name) != it and name != "Python"}
        if not others:
            return None
        told = _functions(runner.source, runner.outputs, runner.options)
        files = {name: _file_of(told.get(name)) for name in sorted(others)}
        versions = {name: there[name] for name in ("linkwork", "Python")}
        return Refusal(_where(), versions, files)

    def _torn(self, cases: Sequence[Case]) -> Refusal | None:
        """Functions that have a copy here of what the laws of the model read."""
        if not self.here.joined:
            return None
        for case in cases:
            try:
                model = self.runner.source.model(case.values)
            except Exception:  # that of this case, which says so
                continue
            there = joined(model, self.runner.options, torn=True)
            if apart := [name for name in self.here.joined if name in there]:
                return Refusal(_where(), {}, {}, apart)
            break
        return None

    def error(self, refusal: Refusal) -> LinkworkError:
        """That a study ends with: what differs, and what to do."""
        if refusal.apart:
            names = ", ".join(refusal.apart)
            return LinkworkError(
                f"executor: in the worker, {refusal.where}, {names} has a copy of what laws of the model "
                "read, so that it changes what they never see: let both be functions of a module, which go "
                "by name, or give a model in place of the function that builds it",
                code="executor",
            )
        name = "linkwork" if "linkwork" in refusal.others else "Python"
        mine, its = self.here.contents[name], refusal.versions[name]
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


def joined(model: Model, options: Mapping[str, Any], *, torn: bool = False) -> list[str]:
    """Functions of a run with these options, as of events, that have an object in common with the laws of
    the model: one is bound to it, the other reaches it. `torn`: that have only one of its kind instead."""
    laws = callbacks.of_model(model)
    others = {name: it for name, it in called(model, options).items() if name not in laws}
    reached, bound = Kept(laws.values()), [root for it in laws.values() for root in _roots(it)]

    def holds(kept: Kept, roots: Sequence[Any]) -> bool:
        there = any(map(kept.has, roots))
        return any(kept.has_kind(type(it)) for it in roots) and not there if torn else there

    return [name for name, it in others.items() if holds(reached, _roots(it)) or holds(Kept([it]), bound)]


def _roots(function: Any) -> list[Any]:
    """What a function is bound to, that goes to other processes as a copy."""
    if isinstance(function, functools.partial):
        found = [*_roots(function.func), *function.args, *function.keywords.values()]
        return [it for it in found if not isinstance(it, CONSTANT)]
    if isinstance(function, MethodType):
        return [function.__self__]
    return [] if isinstance(function, FunctionType | type) or is_opaque(function) else [function]


def _where() -> str:
    return f"process {os.getpid()} of {socket.gethostname()}"


def _functions(source: Source, outputs: Sequence[Output], options: Mapping[str, Any]) -> dict[str, Any]:
    found = {f"function {source.name}": source.build} if isinstance(source, Built) else {}
    told = {f"function of the output '{it.label}'": it.function for it in outputs if it.function is not None}
    given = {f"option '{name}'": it for name, it in options.items() if not isinstance(it, _DATA)}
    return {**found, **told, **given}


def _file_of(value: Any) -> str:
    """Of the module of a function; empty: of none that is known."""
    module = getattr(value, "__module__", None) or type(value).__module__
    return str(getattr(sys.modules.get(module), "__file__", None) or "")
