"""What a study keeps of a run: quantities by name, functions of a Result, arrays at given times.

A name is what one writes after `result.`, and at the end what becomes of it over time:
"energy_error.max", "reaction('motor pin').force.max", "body('rod').position.z.min",
"coordinate('motor pin').value.final".
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwork.arrays import Floats
from linkwork.errors import LinkworkError, OptionError, nearest
from linkwork.fingerprints import canonical
from linkwork.modeling.coordinates import coordinate_of
from linkwork.results.forces import clock
from linkwork.results.last_state import LastState
from linkwork.results.result import Result
from linkwork.results.tables import COORDINATES
from linkwork.studies.around_events import ENERGIES, around_events, energy_of_bodies, without
from linkwork.studies.between_frames import Bends, Curve, bends_of, with_sides

__all__ = ["REDUCTIONS", "Output", "checked", "identity", "outputs_of"]

#: What one may ask a result for.
PROPERTIES = {
    "position": "m", "velocity": "m/s", "acceleration": "m/s2", "orientation": "1", "omega": "rad/s",
    "omega_inertial": "rad/s", "angular_acceleration": "rad/s2", "kinetic_energy": "J",
    "potential_energy": "J", "energy": "J", "work": "J", "energy_error": "J", "multipliers": "",
    "violation": "", "history": "",
}  # fmt: skip
METHODS = ("body", "reaction", "coordinate", "force")

#: Without a name: of all joints.
OF_ALL = ("reactions",)

#: And then what these give for.
PARTS = {"force": "N", "torque": "N m", "power": "W", "potential": "J", "deflection": "", "value": "",
         "rate": ""}  # fmt: skip

#: Vectors in space: their sizes are what reductions look at.
VECTORS = {"position", "velocity", "acceleration", "omega", "omega_inertial", "angular_acceleration",
           "force", "torque"}  # fmt: skip

COMPONENTS = ("x", "y", "z")

#: Slices that choose nothing.
ALL = (slice(None), slice(0, None), slice(None, None, 1), slice(0, None, 1))

#: Times that are one, relative to the end of the run.
SAME_TIME = 1e-9


#: Rates of what is recorded with its own.
RATES = {"position": "velocity", "velocity": "acceleration", "omega": "angular_acceleration", "value": "rate"}

#: What becomes of values over time.
REDUCTIONS: Mapping[str, tuple[str, Callable[[Curve], Floats]]] = {
    "max": ("largest", lambda curve: curve.largest()),
    "min": ("smallest", lambda curve: -curve.largest(np.negative)),
    "abs_max": ("largest absolute", lambda curve: curve.largest(np.abs)),
    "mean": ("mean over time", lambda curve: curve.mean()),
    "rms": ("root of the mean square over time", lambda curve: np.sqrt(curve.mean(np.square))),
    "range": ("largest less smallest", lambda curve: curve.largest() + curve.largest(np.negative)),
    "final": ("last", lambda curve: curve.values[-1]),
}

#: Those that count what is between frames, whether or not rates are known.
OVER_TIME = ("mean", "rms")

Step = tuple[Any, ...]


@dataclass(frozen=True)
class Output:
    """One of them. A function gets the Result; else the steps lead from it to an array."""

    label: str
    unit: str = ""
    about: str = ""
    steps: tuple[Step, ...] = ()
    function: Callable[[Result], Any] | None = None
    reduction: str = ""
    note: str = ""  #: what its values are in all cases, see linkwork.studies.notes

    @property
    def over_time(self) -> bool:
        """Whether it is an array at the times of the study."""
        return self.function is None and not self.reduction

    @property
    def followed(self) -> bool:
        """Whether it depends on the frames before, as angles over full turns do."""
        return any(step[1:2] == ("coordinate",) for step in self.steps)

    @property
    def of_whole_run(self) -> bool:
        """Whether it depends on what the motion does between the times that are asked for."""
        return self.followed or not (self.at_end or self.over_time)

    @property
    def by_user(self) -> bool:
        """Whether a function of the user's tells it, which may look at anything."""
        return self.function is not None and not self.of_state_alone

    @property
    def of_reactions(self) -> bool:
        """Whether it takes those of joints, or may do so."""
        roots = {step[1] for step in self.steps[:1]}
        return self.by_user or not roots.isdisjoint({"reaction", "reactions", "multipliers"})

    @property
    def at_end(self) -> bool:
        """Whether the last frame is enough."""
        return self.of_state_alone or (self.reduction == "final" and not self.followed)

    @property
    def of_state_alone(self) -> bool:
        """Whether it looks at q or v of the last frame, and at nothing else."""
        return self.function in (_final_q, _final_v)

    def value(self, result: Result | LastState, times: Floats | None) -> Floats:
        """OptionError: what is no number, or no frame at a time."""
        if self.of_state_alone:
            return np.array(result.recorded("q" if self.function is _final_q else "v", -1))
        assert isinstance(result, Result)
        if self.function is not None:
            return _numbers(self.label, _called(self.function, result))
        found: Floats = _followed(result, self.steps)
        if not _is_over_time(found, result):
            raise OptionError(f"output '{self.label}': is no array over time", code="outputs")
        if not self.reduction:
            return found if times is None else _at_times(self.label, result.t, found, times)
        return np.asarray(REDUCTIONS[self.reduction][1](self._curve(result, found)))

    def _curve(self, result: Result, values: Floats) -> Curve:
        bends, sizes = None, self._of_sizes(result, values)
        if self.reduction != "final":
            result, values = _around_events(result, self.steps, values)
            bends = _bends(result, self.steps, values, sizes)
        values = np.asarray(values, dtype=float)
        if bends is None and self.reduction in OVER_TIME and len(result.header.breaks):
            return Curve(
                *with_sides(result.t, values, np.asarray(result.header.breaks), clock(result)), None, sizes
            )
        return Curve(result.t, values, bends, sizes)

    def _of_sizes(self, result: Result, values: Floats) -> bool:
        """Whether it reduces vectors: indices after their name leave all components."""
        named = next(k for k in reversed(range(len(self.steps))) if self.steps[k][0] != "index")
        if self.reduction == "final" or self.steps[named][0] != "get" or self.steps[named][1] not in VECTORS:
            return False
        steps, indices = self.steps[: named + 1], self.steps[named + 1 :]
        shape = np.shape(_followed(result, steps) if indices else values)
        if len(shape) < 2 or shape[-1] != len(COMPONENTS):
            return False
        component = np.broadcast_to(range(len(COMPONENTS)), (1, *shape[1:]))
        for _, key in indices:
            component = _indexed(component, key)
        return component.shape[-1:] == shape[-1:] and bool((component == range(len(COMPONENTS))).all())

    def described(self, result: Result, values: Floats) -> str:
        """In words, for attributes of a data set; `values` are those over time."""
        if not self.reduction:
            return self.about
        size = " magnitude" if self._of_sizes(result, values) else " value"
        over = "motion, also between frames" if self._between_frames() else "recorded frames"
        return f"{REDUCTIONS[self.reduction][0]}{size} over the {over}"

    def _between_frames(self) -> bool:
        names = {step[1] for step in self.steps if step[0] == "get"}
        return self.reduction != "final" and not names.isdisjoint({*RATES, *ENERGIES})


def outputs_of(given: Any) -> list[Output]:
    """From names, or labels with a name, a function of a Result, or a pair of function and unit.

    OptionError: something else, or a name that cannot be read.
    """
    if isinstance(given, str) or callable(given):
        given = [given]
    if not isinstance(given, Mapping | list | tuple) or not given:
        raise OptionError(
            f"outputs {given!r:.80}: give names of quantities, such as ['energy_error.max', 'final'], or "
            "{label: function of a Result}",
            code="outputs",
        )
    pairs = given.items() if isinstance(given, Mapping) else [(None, what) for what in given]
    found = [it for label, what in pairs for it in _made(label, what)]
    labels = [it.label for it in found]
    double = next((label for label in labels if labels.count(label) > 1), None)
    if double is not None:
        raise OptionError(f"outputs: '{double}' is given twice: give {{label: what}}", code="outputs")
    return found


def _made(label: Any, what: Any) -> Iterator[Output]:
    unit = ""
    if isinstance(what, tuple) and len(what) == 2 and callable(what[0]) and isinstance(what[1], str):
        what, unit = what
    if label is not None and (not isinstance(label, str) or not label):
        raise OptionError(f"outputs: label {label!r:.60} is no text", code="outputs")
    if callable(what):
        yield Output(
            label or str(getattr(what, "__name__", type(what).__name__)),
            unit,
            (getattr(what, "__doc__", "") or "").split("\n")[0],
            function=what,
        )
    elif isinstance(what, str) and what == "final":
        head = label or "final"
        yield Output(f"{head}.q", "m, 1", "last position and Euler parameters of each body",
                     function=_final_q)  # fmt: skip
        yield Output(f"{head}.v", "m/s, rad/s", "last velocity and angular velocity of each body",
                     function=_final_v)  # fmt: skip
    elif isinstance(what, str):
        yield _read(label or what, what)
    else:
        raise OptionError(f"outputs: {what!r:.80} is no name and no function of a Result", code="outputs")


def _final_q(result: Result) -> Floats:
    return result.recorded("q", -1)


def _final_v(result: Result) -> Floats:
    return result.recorded("v", -1)


def _called(function: Callable[[Result], Any], result: Result) -> Any:
    """OptionError: it writes where the outputs after it read."""
    try:
        return function(result)
    except ValueError as error:
        if "read-only" not in str(error):
            raise
        raise OptionError(
            "its function writes into an array of the result, which is read-only: let it take a .copy()",
            code="outputs",
        ) from error


def _numbers(label: str, found: Any) -> Floats:
    """NaN where it is masked."""
    try:
        values = np.ma.asarray(found)
        if values.dtype.kind not in "biuf":  # NumPy would take None for NaN
            raise TypeError
        return np.array(np.ma.filled(values.astype(float), np.nan), dtype=float)
    except (TypeError, ValueError) as error:
        raise OptionError(
            f"output '{label}': its function gives {found!r:.60}, no number or array of numbers",
            code="outputs",
        ) from error


# --- names ---


def _read(label: str, text: str) -> Output:
    try:
        steps = list(_steps(ast.parse(text.strip(), mode="eval").body))
    except (SyntaxError, ValueError, TypeError) as error:
        raise OptionError(
            f"output '{text}': is no name of a quantity, such as \"reaction('pin').force.max\"",
            code="outputs",
        ) from error
    root = steps[0][1]
    known = [*PROPERTIES, *METHODS, *OF_ALL]
    if root not in known:
        raise OptionError(
            f"output '{text}': a result has no quantity '{root}'{nearest(root, [*known, 'final'])}",
            code="outputs",
        )
    if root in METHODS and (len(steps) < 2 or steps[1][0] != "call"):
        raise OptionError(f"output '{text}': {root} needs a name: {root}('...')", code="outputs")
    if root in OF_ALL and (len(steps) < 2 or steps[1] != ("call", (), ())):
        raise OptionError(f"output '{text}': is written {root}()", code="outputs")
    reduction = steps.pop()[1] if steps[-1][0] == "get" and steps[-1][1] in REDUCTIONS else ""
    early = next((step[1] for step in steps if step[0] == "get" and step[1] in REDUCTIONS), None)
    if early:
        raise OptionError(
            f"output '{text}': '{early}' is what becomes of values over time: it comes last, and once, as in "
            "\"body('rod').position.z.min\"",
            code="outputs",
        )
    return Output(label, about=text, steps=tuple(steps), reduction=reduction)


def _steps(node: ast.AST) -> Iterator[Step]:
    """From the inside out: ("get", name), ("call", arguments, keywords), ("index", key)."""
    if isinstance(node, ast.Name):
        yield "get", node.id
    elif isinstance(node, ast.Attribute):
        yield from _steps(node.value)
        yield "get", node.attr
    elif isinstance(node, ast.Call):
        yield from _steps(node.func)
        words = tuple((str(word.arg), ast.literal_eval(word.value)) for word in node.keywords)
        yield "call", tuple(map(ast.literal_eval, node.args)), words
    elif isinstance(node, ast.Subscript):
        yield from _steps(node.value)
        yield "index", _key(node.slice)
    else:
        raise ValueError


def _key(node: ast.expr) -> Any:
    if isinstance(node, ast.Tuple):
        return tuple(map(_key, node.elts))
    if isinstance(node, ast.Slice):
        ends = (node.lower, node.upper, node.step)
        return slice(*(None if end is None else ast.literal_eval(end) for end in ends))
    return ast.literal_eval(node)


def _followed(result: Result, steps: Sequence[Step]) -> Any:
    found: Any = result
    for step in steps:
        if step[0] == "index":
            found = _indexed(np.asarray(found), step[1])
        elif step[0] == "call":
            found = found(*step[1], **dict(step[2]))
        elif isinstance(found, np.ndarray) and step[1] in COMPONENTS and found.shape[-1:] == (3,):
            found = found[..., COMPONENTS.index(step[1])]
        else:
            found = _part(found, step[1])
    return found


def _around_events(result: Result, steps: Sequence[Step], values: Floats) -> tuple[Result, Floats]:
    """With the states at those events and strikes of drivers that tell the values."""
    if not (result.events or result._strikes):
        return result, values
    around, places = around_events(result)
    found = _followed(around, steps)
    told = np.isfinite(found[places]).reshape(len(places), -1).all(axis=1)
    untold = places[~told]
    return without(around, untold), np.delete(found, untold, axis=0)


def _bends(result: Result, steps: Sequence[Step], values: Floats, sizes: bool) -> Bends | None:
    """Of the values between the frames; None: their rate is not recorded."""
    names = [step[1] for step in steps if step[0] == "get"]
    name = next((it for it in names if it in RATES), None)
    if len(result) < 2 or not (name or names[-1] in ENERGIES):
        return None
    if name is None:
        return _bends_of_energy(result, names[-1])

    def rates(of: str) -> Any:
        return _followed(result, [("get", of) if step == ("get", name) else step for step in steps])

    second = rates(RATES[RATES[name]]) if RATES[name] in RATES else None
    return bends_of(result.t, values, rates(RATES[name]), second, sizes=sizes)


def _bends_of_energy(result: Result, name: str) -> Bends | None:
    """T' = v . M v_dot of bodies, V' = -m g . v. None: something else has energy of this kind, too."""
    if energy_of_bodies(result, name) is None:
        return None
    mass, v = result.header.mass, result.velocity
    if name == "kinetic_energy":
        L = np.einsum("nij,knj->kni", result.header.inertia, result.omega)
        rates = np.einsum("kni,n,kni->k", result.acceleration, mass, v)
        rates += np.einsum("kni,kni->k", result.angular_acceleration, L)
    else:
        rates = -np.einsum("kni,n,i->k", v, mass, result.header.gravity)
    return bends_of(result.t, getattr(result, name), rates)


def _indexed(values: NDArray[Any], key: Any) -> NDArray[Any]:
    """OptionError: it chooses among the frames, of which every run has others."""
    first, *rest = (key if isinstance(key, tuple) else (key,)) or (Ellipsis,)
    taken = sum(it is not None for it in rest)
    if not (first is Ellipsis and taken < values.ndim) and first not in ALL:
        raise OptionError(
            "an index chooses among the frames, of which every run may have others: choose components alone, "
            "as [:, 0] does, and times by times=[...], or add one of "
            f"{', '.join('.' + name for name in REDUCTIONS)}",
            code="outputs",
        )
    return np.asarray(values[key])


def _is_over_time(found: Any, result: Result) -> bool:
    return isinstance(found, np.ndarray) and found.ndim > 0 and len(found) == len(result)


def _part(holder: Any, name: str) -> Any:
    """OptionError: it has none of this name."""
    known = dict.fromkeys((*PROPERTIES, *METHODS, *OF_ALL, *PARTS))
    if isinstance(holder, np.ndarray):
        known = dict.fromkeys((*REDUCTIONS, *(COMPONENTS if holder.shape[-1:] == (3,) else ())))
    elif name in known and hasattr(holder, name):
        return getattr(holder, name)
    there = [it for it in known if isinstance(holder, np.ndarray) or hasattr(holder, it)]
    raise OptionError(f"no part '{name}'{nearest(name, there)}", code="outputs")


def checked(output: Output, result: Result, times: Floats | None) -> Output:
    """With its unit and its description, from a result of one frame.

    OptionError: an output that does not exist, or that is no number where no times are given.
    """
    if output.function is not None:
        return output
    try:
        values = _followed(result, output.steps)
    except (LinkworkError, IndexError, TypeError, ValueError) as error:
        raise OptionError(f"output '{output.label}': {error}", code="outputs") from error
    if not _is_over_time(values, result):
        raise OptionError(
            f"output '{output.label}': is no array over time; name a part of it, and what becomes of it: "
            f"{', '.join(REDUCTIONS)}",
            code="outputs",
        )
    if output.over_time and times is None:
        raise OptionError(
            f"output '{output.label}': is an array over time: give times=[...], or add one of "
            f"{', '.join('.' + name for name in REDUCTIONS)}",
            code="outputs",
        )
    unit = _unit(output.steps, result)
    return Output(output.label, unit, output.described(result, values), output.steps, None, output.reduction)


def _unit(steps: Sequence[Step], result: Result) -> str:
    names = [step[1] for step in steps if step[0] == "get" and step[1] not in COMPONENTS]
    if names[0] == "coordinate":
        given = {**dict(zip(("name", "which"), steps[1][1], strict=False)), **dict(steps[1][2])}
        joint = result.index("joint", given["name"])
        kind, name = result.header.joint_kinds[joint], result.joint_names[joint]
        unit = COORDINATES[coordinate_of(kind, name, given.get("which"))]
        return f"{unit}/s" if names[-1] == "rate" else unit
    return {**PROPERTIES, **PARTS}.get(names[-1], "")


def _at_times(label: str, t: Floats, values: Floats, times: Floats) -> Floats:
    """Rows at the times; NaN beyond the end of a run that an event ended. OptionError: no frame there."""
    at = np.abs(t[None, :] - times[:, None]).argmin(axis=1)
    tolerance = SAME_TIME * max(abs(float(t[-1])), float(np.abs(times).max()))
    over = times > t[-1] + tolerance
    off = ~over & (np.abs(t[at] - times) > tolerance)
    if off.any():
        raise OptionError(
            f"output '{label}': the run has no frame at t = {times[off][0]:.9g} s", code="times"
        )
    found = values[at].astype(float)
    found[over] = np.nan
    return np.asarray(found)


def identity(outputs: Sequence[Output]) -> list[str]:
    """What decides on their values."""
    return [canonical([it.label, it.steps, it.function, it.reduction]) for it in outputs]
