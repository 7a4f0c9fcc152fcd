"""Hostile values at every argument of every public function: errors of linkwork, or finite numbers."""

from __future__ import annotations

import copy
import functools
import inspect
import math
import os
import random
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
from children import Failure, guarded_files
from linkwork import functions, mechanisms, rotation

#: What no one means; made anew for each call.
HOSTILE: tuple[Callable[[], Any], ...] = (
    *(
        functools.partial(copy.copy, it)
        for it in (
            math.nan, math.inf, -math.inf, 1e308, -1e308, 1e200, 5e-324, 0, -1, 2**63, 2**80, 10**400, True,
            "x", "", "\0", "a\nb", "\ud800", "b" * 5000, None, (), b"x", object(), 1j, range(3), ...,
            np.float32(1e30), (1e308,) * 3, (0.0,) * 3, (math.nan, 0.0, 0.0), (1.0, 2.0), ("x", 0, 0),
            (None,) * 3, ((1, 0, 0), (1,)), [[[[]]]], {"x": 1}, [], {}, set(),
            np.zeros((2, 3)), np.array("x"), np.full(3, 1e308), np.array([None]), np.array([], dtype=int),
        )
    ),
    lambda: iter([1.0]), lambda: lambda *_: math.nan, lambda: lambda *_: "x", lambda: np.ma.masked,
    lw.Model, mechanisms.four_bar,
)  # fmt: skip

#: Right ones, of arguments that must be given.
RIGHT: dict[str, Any] = {
    "a": "ground", "b": "body", "body": "body", "bodies": "body", "joint": "pin", "name": "new", "t": 0.0,
    "at": (0, 0, 0), "axis": (0, 1, 0), "axes": ((0, 1, 0), (1, 0, 0)), "normal": (0, 0, 1), "angle": 0.1,
    "displacement": 0.0, "length": 1.0, "radius": 0.5, "pitch": 0.1, "teeth_a": 20, "teeth_b": 10,
    "radius_a": 0.1, "radius_b": 0.1, "stiffness": 10.0, "coefficient": 0.1, "curve": 1.0, "lower": -1.0,
    "upper": 1.0, "mass": 1.0, "inertia": (1, 1, 1), "position": (0.5, 0, 0), "kind": "revolute",
    "points": ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 1)), "coordinates": (("pin", 1.0),), "what": "bodies",
    "t_end": 0.05, "step": 1e-2, "times": (0.0, 0.01), "x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1),
    "p": (1, 0, 0, 0), "A": np.eye(3), "law": "flores", "restitution": 0.5, "value": 1.0, "rise": 1.0,
    "duration": 1.0, "amplitude": 1.0, "frequency": 1.0, "text": "sin(t)", "breaks": (0.0, 1.0),
    "coefficients": ((0.0, 1.0),), "values": (0.0, 1.0), "parameters": {"body.mass": [1.0]},
    "outputs": ["energy_error.abs_max"], "variations": {"body.mass": [1.0]}, "function": lambda *_: 0.0,
}  # fmt: skip

#: Of `simulate` and what calls it, beside the arguments that have names of their own.
OPTIONS = tuple(lw.System(mechanisms.pendulum()).options)

#: That a call may take, with what it imports [bytes].
MEMORY = 500_000_000

#: Take paths to write to, other processes, or the terminal.
LEFT_OUT = ("save", "plot", "view", "compiled", "compiled_force", "movie", "report", "to_csv", "compare")


def model() -> lw.Model:
    made = lw.Model()
    body = made.body("body", mass=1.0, inertia=(1, 1, 1), position=(0.5, 0, 0))
    made.revolute("ground", body, at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    return made


def methods(owner: Any) -> Iterator[str]:
    for name, it in inspect.getmembers(owner, callable):
        if not name.startswith("_") and name not in LEFT_OUT and not inspect.isclass(it):
            yield name


def functions_of(module: Any) -> list[Callable[..., Any]]:
    found = (getattr(module, name) for name in module.__all__ if name not in LEFT_OUT)
    return [it for it in found if inspect.isfunction(it)]


RESULT = lw.simulate(model(), 0.05, 1e-2, progress=False, record_every=1)
PLACES = (
    *[("Model", name) for name in methods(lw.Model)], *[("System", name) for name in methods(lw.System)],
    *[("Result", name) for name in methods(lw.Result)],
)  # fmt: skip
FUNCTIONS = (*functions_of(lw), *functions_of(rotation), *functions_of(functions), lw.Model, lw.System)


def prepared(rng: random.Random) -> tuple[Callable[..., Any], lw.Model]:
    """A function, and the model that it changes."""
    made = model()
    if rng.random() < 0.4:
        return rng.choice(FUNCTIONS), made
    kind, name = rng.choice(PLACES)
    return getattr({"Model": made, "System": lw.System(made), "Result": RESULT}[kind], name), made


def arguments(
    rng: random.Random, function: Callable[..., Any], made: lw.Model
) -> tuple[list[Any], dict[str, Any]]:
    """The right ones, but for one or two."""
    known = inspect.signature(function).parameters
    core, several = made.compiled(), getattr(function, "__name__", "") in ("joints", "forces")
    right = {**RIGHT, "model": made, "q": core.q0, "v": core.v0}
    if "history" in known:
        right["y"] = lw.System(made).initial_state()
    names = [name for name, it in known.items() if it.kind not in (it.VAR_POSITIONAL, it.VAR_KEYWORD)]
    given = {name: right.get(name, 1.0) for name in names if known[name].default is inspect.Parameter.empty}
    given |= {name: right[name] for name in ("at", "axis") if several}
    if "options" in known and rng.random() < 0.6:
        names.append(rng.choice(OPTIONS))
    for name in rng.sample(names, min(len(names), rng.choice([1, 1, 1, 2]))):
        given[name] = rng.choice(HOSTILE)()
    given |= {name: False for name in ("progress",) if name in known}
    first = [given.pop(name) for name, it in known.items() if it.kind == it.POSITIONAL_ONLY]
    return first, given


def call(rng: random.Random, folder: Path) -> int:
    """A hundred calls in one fork; what was called is kept where one fails."""
    now: list[Any] = []

    def make(place: Path) -> Path:
        function, made = prepared(rng)
        now[:] = function, made, *arguments(rng, function, made)
        path = place / "call.txt"
        path.write_text(f"{getattr(function, '__qualname__', function)} {now[2]!a} {now[3]!a}"[:5000])
        return path

    def read(path: Path) -> None:
        os.chdir(folder)  # where files may be written
        function, made, positional, named = now
        try:
            found = function(*positional, **named)
            if isinstance(found, lw.Model):
                made = found
            system = lw.System(made)
            rates = system.derivative(0.0, system.initial_state())
        except (lw.LinkworkError, lw.LinkworkWarning):
            return
        except Exception as error:
            raise Failure(f"{path.read_text():.300}: {type(error).__name__}: {error!s:.200}") from error
        if not np.isfinite(rates).all():
            raise Failure(f"{path.read_text():.300}: rates that are not finite")

    guarded_files(100, folder / "calls", make, read, 60, MEMORY)
    return 100
