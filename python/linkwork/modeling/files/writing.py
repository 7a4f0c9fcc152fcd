"""From a model to a file, exactly: floats are written with as many digits as give the same bits again."""

from __future__ import annotations

import dataclasses
import json
import os
import re
from collections import Counter
from collections.abc import Iterator, Mapping
from itertools import repeat
from pathlib import Path
from typing import Any

import numpy as np

from linkwork import _core
from linkwork.arguments import check_new, is_number
from linkwork.arrays import Floats
from linkwork.errors import FileError, ModelError, OptionError, unwritable
from linkwork.functions import Broken, Sum, Table, TimeFunction
from linkwork.modeling.builder import ModelBuilder
from linkwork.modeling.elements import KINDS, Role
from linkwork.modeling.files import packed, schema
from linkwork.modeling.files.collection import collection_paused
from linkwork.modeling.files.syntax import check_suffix, too_large
from linkwork.modeling.shapes import Shape
from linkwork.options import refused
from linkwork.replacement import replacing

_COMMENT = """\
# SI units, angles in rad. Positions and velocities are inertial; omega and the inertia refer to body axes
# through the center of mass; orientations are unit Euler parameters, scalar first, body axes to inertial.
# `linkwork schema` has all.
"""


def write(
    model: ModelBuilder, path: str | os.PathLike[str], simulation: Mapping[str, Any], overwrite: bool
) -> None:
    """ModelError: what a file cannot hold. OptionError: no run takes `simulation`. FileError: no file."""
    suffix = check_suffix(path)
    check_new(path, "model", overwrite)
    settings = {name: _setting(name, value) for name, value in simulation.items()}
    for name, why in refused(settings):
        raise OptionError(f"simulation{name and f'.{name}'}: {why}", code="option")
    with collection_paused():
        document = record_of(model, settings)
        lines = json_lines(document) if suffix == ".json" else yaml_lines(document)
        _write_whole(Path(path), lines)


def _setting(name: str, value: Any) -> Any:
    """As data what `simulate` takes as numbers and arrays of any kind. OptionError: a method of one's own."""
    if hasattr(value, "__array__"):
        value = np.asarray(value).tolist()
    if name == "integrator" and not isinstance(value, str):
        raise OptionError(
            f"simulation: integrator {getattr(value, 'name', value)!r:.80} is given as its coefficients, "
            "which a file cannot hold: give the name of one that linkwork has",
            code="integrator",
        )
    if isinstance(value, Mapping):
        return {key: _setting("", part) for key, part in value.items()}
    if isinstance(value, list | tuple):
        return [_setting("", part) for part in value]
    return value if isinstance(value, str | int) or not is_number(value) else float(value)


def record_of(model: ModelBuilder, simulation: Mapping[str, Any]) -> dict[str, Any]:
    """The document that describes the model, of plain lists, mappings and numbers.

    ModelError: a Python function in it.
    """
    for it in model._user_forces:
        what = "a function" if callable(it.law) else "a law"
        raise ModelError(
            f"'{it.name}' is {what} of the user's own, which a file cannot hold", code="not_data"
        )
    return _record(model, simulation, {})


def whole_record(model: ModelBuilder) -> tuple[dict[str, Any], dict[str, TimeFunction]]:
    """The same of any model, for one made from it in this process, with "user_forces".

    Beside it, by the names that it has for them, the functions of time that are no data.
    """
    held = {
        index: f"Python function {index}"
        for index, function in model._functions.items()
        if not is_data(function)
    }
    own = [{**it.record} for it in model._user_forces]
    record = {**_record(model, {}, held), "user_forces": own}
    return record, {name: model._functions[index] for index, name in held.items()}


def _record(model: ModelBuilder, simulation: Mapping[str, Any], held: Mapping[int, str]) -> dict[str, Any]:
    """With names for functions that are `held` elsewhere."""
    core = model.compiled()
    names = {**_function_names(model), **held}
    elements = {f"{role}s": list(_elements(model, role, names)) for role in KINDS}
    functions = {
        name: function_record(model._functions[index], f"function '{name}'")
        for index, name in names.items()
        if index not in held
    }
    parts = {
        "linkwork": schema.VERSION,
        "units": "SI",
        "name": model.name,
        "gravity": core.gravity.tolist(),
        "simulation": dict(simulation),
        "functions": functions,
        "bodies": list(_bodies(core)),
        **elements,
        "shapes": list(_shapes(model)),
        "history": list(core.initial_history),
    }
    return {key: value for key, value in parts.items() if value or key in ("linkwork", "gravity", "bodies")}


def _bodies(core: _core.Model) -> Iterator[dict[str, Any]]:
    """Each body; the state only where it is not that of a body at rest in the origin."""
    count = core.body_count
    q, v, J = core.q0.reshape(count, 7), core.v0.reshape(count, 6), core.inertia
    diagonal = (J * np.eye(3) == J).all(axis=(1, 2)) & ~np.signbit(J).any(axis=(1, 2))
    moments = np.diagonal(J, axis1=1, axis2=2).tolist()
    state = {
        "position": q[:, :3],
        "orientation": normalized_from(q[:, 3:]),
        "velocity": v[:, :3],
        "omega": v[:, 3:],
    }
    usual = {what: schema.BodyRecord.model_fields[what].default for what in state}
    # -0.0 is not 0.0: it is written
    given = {what: ((x != usual[what]) | np.signbit(x)).any(axis=1).tolist() for what, x in state.items()}
    columns = {what: x.tolist() for what, x in state.items()}
    as_is = set(core.inertia_as_is)
    for k, mass in enumerate(core.mass.tolist()):
        record = {
            "name": core.body_name(k),
            "mass": mass,
            "inertia": moments[k] if diagonal[k] else J[k].tolist(),
        }
        record |= {what: columns[what][k] for what in columns if given[what][k]}
        yield record | ({"inertia_as_is": True} if k in as_is else {})


def _shapes(model: ModelBuilder) -> Iterator[dict[str, Any]]:
    """Each run of bodies with the same shapes."""
    for bodies, shapes in model.shapes:
        names = [model.compiled().body_name(body) for body in bodies]
        yield {"bodies": names, "shapes": [_shape_record(shape) for shape in shapes]}


def _shape_record(shape: Shape) -> dict[str, Any]:
    return {what: _plain(x) for what, x in shape.description().items()}


def _plain(value: Any) -> Any:
    """Lists of an array, or one text where they would be long."""
    if not isinstance(value, np.ndarray):
        return value
    return packed.pack(value) if value.ndim == 2 and len(value) >= packed.LEAST else value.tolist()


# The model normalizes the Euler parameters that it is given, which changes a few of those that are unit
# already in the last bit. For these another p is looked for near by, from which normalization gives exactly
# the p of the model.
def normalized_from(p: Floats) -> Floats:
    out = p.copy()
    wrong = np.arange(len(p))
    for attempt in range(1000):
        wrong = wrong[(_normalized(out[wrong]) != p[wrong]).any(axis=1)]
        if not len(wrong):
            return out
        step = attempt // 2 + 1  # up and down: at powers of two only the finer side may have one
        out[wrong] = p[wrong] * (1 + (1e-9 if attempt % 2 else -1e-9) * step)
    raise AssertionError("no Euler parameters give those of the model")


def _normalized(p: Floats) -> Floats:
    """As the compiled model does it."""
    core, count = _core.Model(np.zeros(3)), len(p)
    still = np.zeros((count, 3))
    if count:
        core.add_bodies("body", np.ones(count), np.tile(np.eye(3), (count, 1, 1)), still, p, still, still)
    return core.q0.reshape(count, 7)[:, 3:]


def _elements(model: ModelBuilder, role: Role, names: Mapping[int, str]) -> Iterator[dict[str, Any]]:
    """Each joint or force in its attached form; special joints have none."""
    core = model.compiled()
    arrays = getattr(core, f"{role}_arrays")()
    name_of = getattr(core, f"{role}_name")
    kinds = list(KINDS[role].values())
    origin, frame = arrays["origin"].tolist(), arrays["frame"].tolist()
    values, signals = arrays["parameters"].tolist(), arrays["signals"].tolist()
    each = zip(
        arrays["kind"].tolist(), arrays["bodies"].tolist(), arrays["first_parameter"].tolist(), strict=True
    )
    for k, (kind, (a, b), first) in enumerate(each):
        info, name = kinds[kind], name_of(k)
        record: dict[str, Any] = {"kind": info.name, "name": name}
        if info.placement != "coordinates":
            record |= {"a": core.body_name(a), "b": core.body_name(b)}
        if role == "joint" and k in model._special:
            record |= model._special[k].arguments()
        else:
            record["attachment"] = {"origin": origin[k], "frame": frame[k]}
        for place, what in enumerate(info.parameters, first):
            signal = signals[place]
            if signal < 0:
                record[what] = values[place]
            elif signal in names:
                record[what] = names[signal]
            else:
                who = f"{info.name} '{name}': {what}"
                record[what] = function_record(model._functions[signal], who)
        yield record


def _function_names(model: ModelBuilder) -> dict[int, str]:
    """Names for the functions that more than one element has."""
    core = model.compiled()
    signals = [getattr(core, f"{role}_arrays")()["signals"] for role in KINDS]
    uses = Counter(index for array in signals for index in array[array >= 0].tolist())
    shared = sorted(index for index, count in uses.items() if count > 1)
    return dict(zip(shared, (f"function {k}" for k in range(1, len(shared) + 1)), strict=True))


def function_record(function: TimeFunction, who: str, levels: int = schema.SUMS) -> dict[str, Any]:
    """A function of time as a mapping. ModelError: it is no data, or deeper than `levels`."""
    if isinstance(function, Sum | Broken) and not levels:
        raise ModelError(
            f"{who} has sums and functions with breaks more than {schema.SUMS} levels deep in each other, "
            "which a file does not take: give one sum of all terms, and all breaks together",
            code="too_deep",
        )
    if isinstance(function, Table):
        breaks, rows = function.breaks.tolist(), function.coefficients.tolist()
        return {"piecewise_polynomial": {"breaks": breaks, "coefficients": rows}}
    if isinstance(function, Sum):
        return {"sum": [function_record(term, who, levels - 1) for term in function.terms]}
    if isinstance(function, Broken):
        inner = function_record(function.function, who, levels - 1)
        return {"with_breaks": {"function": inner, "breaks": list(function.times)}}
    if not is_data(function):
        raise ModelError(
            f"{who} is a Python function, which a file cannot hold: give it as one of linkwork.functions, "
            "such as table(t, values) of its samples",
            code="not_data",
        )
    name = _constructor(function)
    fields = dataclasses.fields(function)  # type: ignore[arg-type]
    values = {field.name: getattr(function, field.name) for field in fields}
    plain = {
        what: np.asarray(x).tolist() if isinstance(x, tuple | np.ndarray) else x for what, x in values.items()
    }
    return {name: plain if len(plain) > 1 else next(iter(plain.values()))}


def is_data(function: TimeFunction) -> bool:
    """Whether a file can hold it."""
    if isinstance(function, Sum):
        return all(map(is_data, function.terms))
    if isinstance(function, Broken):
        return is_data(function.function)
    known = dataclasses.is_dataclass(function) and _constructor(function) in schema.constructors()
    return isinstance(function, Table) or known


def _constructor(function: TimeFunction) -> str:
    """Of linkwork.functions, by the name of its class."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", type(function).__name__).lower()


# --- text ---------------------------------------------------------------------------------------------------


def json_lines(document: Mapping[str, Any]) -> Iterator[str]:
    """One line for every body, joint and force."""
    lead = "{"
    for key, value in document.items():
        yield f"{lead}\n  {json.dumps(key)}: "
        lead = ","
        if isinstance(value, list) and value and isinstance(value[0], dict):
            yield from (
                f"{start}    {json.dumps(item)}" for start, item in zip(_starts(), value, strict=False)
            )
            yield "\n  ]"
        else:
            yield json.dumps(value)
    yield "\n}\n"


def _starts() -> Iterator[str]:
    yield "[\n"
    yield from repeat(",\n")


def yaml_lines(document: Mapping[str, Any]) -> Iterator[str]:
    """Bodies and elements as blocks, what is in them on one line each."""
    yield _COMMENT
    for key, value in document.items():
        if isinstance(value, list) and value and isinstance(value[0], dict):
            yield f"\n{key}:\n"
            for item in value:
                lead = "  - "
                for name, part in item.items():
                    yield f"{lead}{name}: {_flow(part)}\n"
                    lead = "    "
        elif isinstance(value, dict) and value:
            yield f"\n{key}:\n"
            yield from (f"  {_flow(name)}: {_flow(part)}\n" for name, part in value.items())
        else:
            yield f"{key}: {_flow(value)}\n"


def _flow(value: Any) -> str:
    """A value on one line. JSON is YAML; only what YAML takes for not printable must be escaped its way."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_flow(key)}: {_flow(part)}" for key, part in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_flow, value)) + "]"
    if isinstance(value, str):
        return _word(value)
    return json.dumps(value)


#: Text that stands for itself in YAML, in quotes or not: nothing that is read as a number, null or true.
_SIMPLE = re.compile(r"(?!(?:null|true|false|yes|no|on|off|y|n)$)[a-z][a-z_]*(?: [a-z0-9_]+)*", re.IGNORECASE)


def _word(text: str) -> str:
    if _SIMPLE.fullmatch(text):
        return text
    escaped = json.dumps(text, ensure_ascii=False)
    return '"' + "".join(c if c.isprintable() else f"\\U{ord(c):08x}" for c in escaped[1:-1]) + '"'


def _write_whole(path: Path, lines: Iterator[str]) -> None:
    """All or nothing: a file that is there stays as it is until the new one is complete.

    FileError: it cannot be written, or would be too large to be read again.
    """
    try:
        with replacing(path, "model file") as beside:
            with open(beside, "w", encoding="utf-8") as file:
                file.writelines(lines)
            if why := too_large(path, beside.stat().st_size):
                raise FileError(f"model file '{path}': {why}", code="too_large")
    except UnicodeEncodeError as error:
        no_text = ValueError("a name is no valid text; rename what has it")
        raise unwritable("model file", path, no_text) from error
