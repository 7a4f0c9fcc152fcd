"""Studies in files (.yaml, .yml, .json), for the command line and for arrays of jobs.

linkwork_study: 1
model: crank.yaml                 # beside this file, or the name of a mechanism
t_end: 2.0
simulation: {step: 1e-3}          # arguments of simulate
parameters:
  crank.mass: [1.0, 3.0]          # values; with a sampler bounds, or a distribution of scipy.stats:
  motor pin.at[2]: {norm: {loc: 0.0, scale: 1e-4}}
sampler: sobol
cases: 64
seed: 1
outputs: ["final", "reaction('motor pin').force.max"]   # or {label: name}
directory: variants               # without it that of this file's name
follow_errors: true               # as they grow, of all cases; else of some, see sweep
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from pydantic import Field, ValidationError

from linkwork.arguments import is_number
from linkwork.errors import Fault, Faults, ModelFileError, OptionError, nearest
from linkwork.mechanisms import MECHANISMS, is_file, named
from linkwork.modeling.files.messages import faults_of_schema
from linkwork.modeling.files.schema import FormatVersion, Number, Record, Word
from linkwork.modeling.files.syntax import Syntax, Where, field, parse

__all__ = ["VERSION", "read_study"]

#: Of the format.
VERSION = 1


#: Arguments of `sweep` that are no option of a run, and so not under `simulation`.
OF_STUDIES = {
    **dict.fromkeys(("model", "parameters", "outputs", "t_end", "times", "sampler", "cases", "seed",
                     "directory", "follow_errors"), "of the study: write it outside"),
    **dict.fromkeys(("shard", "gather", "retry", "processes", "case_seconds"),
                    "of the command: give it there"),
    **dict.fromkeys(("executor", "progress"), "of linkwork.sweep in Python"),
}  # fmt: skip


class _Document(Record):
    linkwork_study: FormatVersion
    model: Word
    t_end: Number = Field(gt=0)
    parameters: dict[Word, Any]
    outputs: Any
    simulation: dict[Word, Any] = Field({})
    times: list[Number] | None = None
    sampler: Word | None = None
    cases: int | None = Field(None, ge=1)
    seed: int | None = Field(None, ge=0)
    directory: Word | None = None
    follow_errors: bool = False


def read_study(path: str | os.PathLike[str]) -> dict[str, Any]:
    """The arguments of `sweep`. FileError: it cannot be read. ModelFileError: what is wrong, with its line.

    OptionError: no such mechanism.
    """
    syntax = parse(path, "study file")
    document = _checked(path, syntax)
    folder = Path(path).absolute().parent
    given = document.model_dump(exclude={"linkwork_study", "model", "simulation", "parameters"},
                                exclude_none=True)  # fmt: skip
    beside = document.model not in MECHANISMS and is_file(document.model)
    mechanism = named(str(folder / document.model) if beside else document.model)
    settings = mechanism.settings_beside(document.simulation)
    settings.pop("t_end", None)
    return {
        **settings,
        **document.simulation,
        **given,
        "model": mechanism.function(),
        "parameters": {name: _parameter(name, value) for name, value in document.parameters.items()},
        "directory": folder / (document.directory or Path(path).stem),
    }


def _checked(path: str | os.PathLike[str], syntax: Syntax) -> _Document:
    """ModelFileError: all that is wrong in it."""
    data, faults = syntax.data, Faults()
    if not isinstance(data, dict):
        raise ModelFileError(path, [Fault(1, "", "a study is a mapping: linkwork_study: 1, model: ...")])
    known = list(_Document.model_fields)
    for name in data.keys() - set(known):
        faults.add(Fault(_line(syntax, (name,)), name, f"is not known here{nearest(name, known)}"))
    if "outputs" in data and data["outputs"] in (None, [], {}):
        message = "there are none: write names of quantities, such as [energy_error.max, final]"
        faults.add(Fault(_line(syntax, ("outputs",)), "outputs", message))
    settings = data.get("simulation")
    for name in settings if isinstance(settings, dict) else ():
        if name in OF_STUDIES:
            place: Where = ("simulation", name)
            message = f"is none of simulate, but {OF_STUDIES[name]}"
            faults.add(Fault(_line(syntax, place), field(place), message))
    try:
        document = _Document.model_validate({name: it for name, it in data.items() if name in known})
    except ValidationError as error:
        for where, message in faults_of_schema(error, data):
            faults.add(Fault(_line(syntax, where), field(where), message))
    if faults.count:
        raise ModelFileError(path, faults.all())
    return document


def _line(syntax: Syntax, where: Where) -> int:
    """Of the value, or of the nearest around it that is there."""
    try:
        return syntax.line(where)
    except (KeyError, IndexError):
        return _line(syntax, where[:-1]) if where else 1


def _parameter(name: str, value: Any) -> Any:
    """Values as they are; {norm: {loc: 0, scale: 1}} is a distribution. OptionError: it is none."""
    if not isinstance(value, Mapping):
        return value
    from scipy import stats

    known = [
        it for it in dir(stats) if isinstance(getattr(stats, it), stats.rv_continuous | stats.rv_discrete)
    ]
    if len(value) != 1 or not isinstance(next(iter(value.values())), Mapping):
        raise OptionError(
            f"parameter '{name}': a distribution is written {{norm: {{loc: 0.0, scale: 1.0}}}}",
            code="parameters",
        )
    ((kind, numbers),) = value.items()
    if kind not in known:
        raise OptionError(
            f"parameter '{name}': scipy.stats has no distribution '{kind}'{nearest(kind, known)}",
            code="parameters",
        )
    family = getattr(stats, kind)
    needed = [] if family.shapes is None else family.shapes.split(", ")
    _check_numbers(f"parameter '{name}': {kind}", numbers, needed,
                   ["loc"] if isinstance(family, stats.rv_discrete) else ["loc", "scale"])  # fmt: skip
    try:
        return family(**numbers)
    except (TypeError, ValueError) as error:
        raise OptionError(f"parameter '{name}': {kind}: {error}", code="parameters") from error


def _check_numbers(
    who: str, numbers: Mapping[str, Any], needed: Sequence[str], others: Sequence[str]
) -> None:
    """OptionError: a number of a distribution that it does not have, that is missing, or none."""
    known = [*needed, *others]
    for what, number in numbers.items():
        if what not in known:
            raise OptionError(f"{who} has no number '{what}'{nearest(what, known)}", code="parameters")
        if not is_number(number):
            raise OptionError(f"{who}: {what} {number!r:.80} is not a finite number", code="parameters")
    for what in needed:
        if what not in numbers:
            raise OptionError(f"{who} needs a number '{what}'", code="parameters")
