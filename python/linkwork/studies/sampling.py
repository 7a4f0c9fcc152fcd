"""The cases of a study: grids, tables, and points of SciPy's samplers and distributions."""

from __future__ import annotations

import copy
import itertools
import math
import warnings
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from linkwork.arguments import one_of, whole
from linkwork.arrays import Floats
from linkwork.errors import OptionError, warn
from linkwork.fingerprints import plain
from linkwork.studies.distributions import is_distribution, quantile, words

__all__ = ["SAMPLERS", "Cases", "cases_of", "own_copy"]

#: By name: points in the unit cube. They are scrambled, and need a seed.
SAMPLERS: Mapping[str, str] = {"sobol": "Sobol", "halton": "Halton", "latin_hypercube": "LatinHypercube"}

#: What `sampler` may be, beside an engine of scipy.stats.qmc.
NAMES = ("grid", "table", "random", *SAMPLERS)

#: More cases than a store holds.
MOST = 10**7


@dataclass(frozen=True)
class Cases:
    """Values of the parameters (k,), each a number, a list of numbers, or what a function takes, as it was
    given."""

    columns: Mapping[str, Sequence[Any]]
    how: str  # they were made
    drawn: Mapping[str, Any] = field(default_factory=dict)  # from what, in words; empty where nothing was

    def __len__(self) -> int:
        return len(next(iter(self.columns.values())))

    def as_floats(self) -> Cases:
        """The same, of numbers alone: 1 and 1.0 are one case."""
        columns = {name: [np.asarray(value, dtype=float).tolist() for value in values]
                   for name, values in self.columns.items()}  # fmt: skip
        return Cases(columns, self.how, self.drawn)

    def case(self, number: int) -> dict[str, Any]:
        return {name: values[number] for name, values in self.columns.items()}


def cases_of(parameters: Any, sampler: Any, count: int | None, seed: int | None) -> Cases:
    """OptionError: no cases, columns of other lengths, a distribution without seed, ..."""
    if seed is not None:
        whole(seed, 0, "seed")
    columns = _columns(parameters)
    kind = _kind(parameters, columns, sampler)
    for name, given in (("cases", count), ("seed", seed)):
        if kind in ("grid", "table") and given is not None:
            raise OptionError(
                f"{name} {given!r:.40}: nothing is drawn of a {kind}; {name}= is for samplers: give "
                "sampler='random', say, with bounds, or distributions of scipy.stats, which have ppf or icdf",
                code=name,
            )
    if kind == "grid":
        return _grid({name: _values(name, given, single=True) for name, given in columns.items()})
    if kind == "table":
        return _table({name: _values(name, given, single=False) for name, given in columns.items()})
    if count is None:
        raise OptionError(f"cases is missing: sampler '{kind}' needs their number", code="cases")
    count = whole(count, 1, "cases")
    if count > MOST:
        raise OptionError(f"cases {count} are more than {MOST:.0e}", code="cases")
    return _sampled(columns, sampler, kind, count, seed)


def _columns(parameters: Any) -> dict[str, Any]:
    """By name: a mapping, a table of pandas, rows as mappings, or an array with names of its fields."""
    if isinstance(parameters, Mapping):
        found = dict(parameters)
    elif hasattr(parameters, "columns") and hasattr(parameters, "to_dict"):
        _check_once(list(parameters.columns))
        found = {name: parameters[name].tolist() for name in parameters.columns}
    elif isinstance(parameters, np.ndarray) and parameters.dtype.names:
        found = {name: parameters[name] for name in parameters.dtype.names}
    elif isinstance(parameters, Sequence) and all(isinstance(row, Mapping) for row in parameters):
        found = _of_rows(parameters)
    else:
        raise OptionError(
            f"parameters {parameters!r:.80} is no mapping of names to values, no list of such mappings, no "
            "table of pandas and no array with named fields",
            code="parameters",
        )
    if not found:
        raise OptionError("parameters: there are none, so there is no case", code="parameters")
    wrong = next((name for name in found if not isinstance(name, str)), None)
    if wrong is not None:
        raise OptionError(f"parameter {wrong!r:.80}: its name is no text", code="parameters")
    return found


def _check_once(names: Sequence[Any]) -> None:
    """OptionError: two columns of a table have one name."""
    double = next((name for name in names if names.count(name) > 1), None)
    if double is not None:
        raise OptionError(f"parameter '{double}': two columns of the table have this name", code="parameters")


def _of_rows(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    names = list(rows[0]) if rows else []
    for number, row in enumerate(rows):
        if set(row) != set(names):
            odd = sorted(map(str, set(row) ^ set(names)))
            raise OptionError(
                f"parameters: case {number} and case 0 differ in '{odd[0]}': give it in all or in none",
                code="parameters",
            )
    return {name: [row[name] for row in rows] for name in names}


def _kind(parameters: Any, columns: Mapping[str, Any], sampler: Any) -> str:
    if sampler is not None and not isinstance(sampler, str):
        return "engine"
    drawn = [name for name, given in columns.items() if is_distribution(given)]
    if sampler is None and drawn:
        _check_all_drawn(columns, drawn[0])
        return "random"
    if sampler is None:
        return "grid" if isinstance(parameters, Mapping) else "table"
    kind = one_of(sampler, NAMES, "sampler")
    if drawn and kind in ("grid", "table"):
        raise OptionError(
            f"parameter '{drawn[0]}': is a distribution, which a {kind} cannot have", code="sampler"
        )
    return kind


def _check_all_drawn(columns: Mapping[str, Any], drawn: str) -> None:
    """OptionError: values that without a sampler are those of a grid, and may be meant as bounds."""
    name = next((name for name, given in columns.items() if not is_distribution(given)), None)
    if name is not None:
        raise OptionError(
            f"parameter '{name}': without a sampler {columns[name]!r:.60} are values of a grid, and "
            f"'{drawn}' is drawn: give sampler='random', say, with bounds (low, high), or a distribution "
            "here, too, such as scipy.stats.uniform(low, high - low)",
            code="parameters",
        )


def _values(name: str, given: Any, *, single: bool) -> list[Any]:
    """OptionError: none. A single value is a list of one where `single`."""
    alone = np.ndim(given) == 0 if isinstance(given, np.ndarray) else not isinstance(given, Iterable)
    if alone or isinstance(given, str | bytes | Mapping):
        if not single:
            raise OptionError(f"parameter '{name}': {given!r:.60} is no list of values", code="parameters")
        given = [given]
    found = [own_copy(value) for value in given]
    if not found:
        raise OptionError(f"parameter '{name}': has no values, so there is no case", code="parameters")
    return found


def own_copy(value: Any) -> Any:
    """Of the same type, so that nobody else changes it: of lists, mappings and arrays; else it is itself."""
    if isinstance(value, np.ndarray):
        return copy.copy(value)  # in the same order
    if type(value) is dict:
        return {name: own_copy(part) for name, part in value.items()}
    return type(value)(map(own_copy, value)) if type(value) in (list, tuple, set) else value


def _grid(columns: Mapping[str, list[Any]]) -> Cases:
    """Full factorial; the last parameter changes first."""
    count = math.prod(map(len, columns.values()))
    if count > MOST:
        raise OptionError(f"parameters: a grid of {count} cases is more than {MOST:.0e}", code="cases")
    rows = list(itertools.product(*columns.values()))
    return Cases({name: [row[k] for row in rows] for k, name in enumerate(columns)}, "grid")


def _table(columns: Mapping[str, list[Any]]) -> Cases:
    first = next(iter(columns))
    for name, values in columns.items():
        if len(values) != len(columns[first]):
            raise OptionError(
                f"parameter '{name}': has {len(values)} values, '{first}' {len(columns[first])}; a table has "
                "equally many of all",
                code="parameters",
            )
    return Cases(columns, "table")


# --- samplers ---


def _sampled(columns: Mapping[str, Any], sampler: Any, kind: str, count: int, seed: int | None) -> Cases:
    quantiles = {name: quantile(name, given) for name, given in columns.items()}
    about: dict[str, Any] = {"seed": seed}
    if kind == "engine":
        if seed is not None:
            raise OptionError(
                f"seed {seed}: an engine of scipy.stats.qmc has its own; leave seed out", code="seed"
            )
        points, kind = _of_engine(sampler, len(columns), count)
        about = _engine_words(sampler)
    else:
        _check_seed(columns, kind, seed)
        assert seed is not None
        points = _random(columns, count, seed) if kind == "random" else _scrambled(columns, kind, count, seed)
    # the ends of the unit interval are quantiles at infinity
    inside = np.clip(points, 2.0**-54, 1 - 2.0**-53)
    return Cases(
        {name: inverse(inside[:, k]).tolist() for k, (name, inverse) in enumerate(quantiles.items())}, kind,
        {"sampler": kind, **about, "cases": count,
         "parameters": {name: words(given) for name, given in columns.items()}},
    )  # fmt: skip


def _check_seed(columns: Mapping[str, Any], kind: str, seed: int | None) -> None:
    """OptionError: there is none."""
    drawn = next((name for name in columns if is_distribution(columns[name])), "")
    if seed is None:
        what = f"parameter '{drawn}': is a distribution" if drawn else f"sampler '{kind}' is random"
        raise OptionError(f"{what}: give a seed, a whole number, so that it can be repeated", code="seed")


def _random(columns: Mapping[str, Any], count: int, seed: int) -> Floats:
    """(count, p): the first points are those of fewer cases, and of a parameter those without the others."""
    streams = [np.random.SeedSequence([seed, *name.encode()]) for name in columns]
    return np.stack([np.random.Generator(np.random.PCG64(it)).random(count) for it in streams], axis=1)


def _scrambled(columns: Mapping[str, Any], kind: str, count: int, seed: int) -> Floats:
    from scipy.stats import qmc

    engine = getattr(qmc, SAMPLERS[kind])(d=len(columns), seed=seed)
    return _points(engine, count)


def _points(engine: Any, count: int) -> Floats:
    """(count, p). LinkworkWarning: what SciPy has to say about their number."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        points: Floats = engine.random(count)
    if len(points) < count:
        warn(f"cases {count}: {type(engine).__name__} gives {len(points)} only, and so many are run")
    for text in dict.fromkeys(" ".join(str(it.message).split()) for it in told):
        warn(f"cases {count}: {text}")
    return points


def _of_engine(engine: Any, dimensions: int, count: int) -> tuple[Floats, str]:
    """From its beginning, whatever was drawn from it before. OptionError: none, one without seed, or one that
    was drawn from and does not find back.
    """
    from scipy.stats import qmc

    if not isinstance(engine, qmc.QMCEngine):
        raise OptionError(
            f"sampler {engine!r:.80} is none of {', '.join(NAMES)}, and no engine of scipy.stats.qmc",
            code="sampler",
        )
    if engine.d != dimensions:
        raise OptionError(
            f"sampler: has {engine.d} dimensions, and there are {dimensions} parameters", code="sampler"
        )
    if not _is_repeatable(engine):
        raise OptionError(
            f"sampler {type(engine).__name__}: has no seed of at most 64 bits: give it one, so that it "
            "can be repeated",
            code="seed",
        )
    return _points(_from_beginning(engine, count), count), type(engine).__name__


def _from_beginning(engine: Any, count: int) -> Any:
    """A copy: the engine stays as it is. OptionError: it was drawn from, and `reset` does not lead back, as
    of those that are optimized by random swaps: these go on with the numbers of a generator that stays.
    """
    found = copy.deepcopy(engine)
    if getattr(engine, "optimization_method", None) is None:
        return found.reset()
    if not engine.num_generated:
        return found
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # told when they are drawn
        first, second = (found.reset().random(count) for _ in range(2))
    if not np.array_equal(first, second):
        raise OptionError(
            f"sampler {type(engine).__name__}: was drawn from before, and its optimization does not begin "
            "anew: make a new one with the same seed",
            code="sampler",
        )
    return found.reset()


def _engine_words(engine: Any) -> dict[str, Any]:
    """What it was made with, as far as it tells: numbers, names of methods, the state that it begins at."""
    found: dict[str, Any] = {}
    for name, it in sorted(vars(engine).items()):
        method = getattr(it, "func", getattr(it, "__func__", None))
        if method is not None:
            found[name] = getattr(method, "__name__", str(method))
        elif not name.startswith("_") and isinstance(it, bool | int | float | str):
            found[name] = it
    found.pop("num_generated", None)
    generator = getattr(getattr(engine, "rng_seed", None), "bit_generator", None)
    entropy = getattr(getattr(generator, "seed_seq", None), "entropy", None)
    state = {name: plain(it) for name, it in getattr(generator, "state", {}).items()}
    return {"seed": entropy, "engine": found, "generator": state}


def _is_repeatable(engine: Any) -> bool:
    """Without a seed SciPy takes one of 128 bits from the system."""
    from scipy.stats import qmc

    if isinstance(engine, qmc.Sobol | qmc.Halton) and not engine.scramble:
        return True
    generator = getattr(getattr(engine, "rng_seed", None), "bit_generator", None)
    entropy = getattr(getattr(generator, "seed_seq", None), "entropy", None)
    return isinstance(entropy, int) and entropy < 2**64
