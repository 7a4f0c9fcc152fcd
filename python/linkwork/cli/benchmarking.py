"""`linkwork bench`: the words of the command line turned into measurements, and their JSON."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from linkwork import benchmark
from linkwork.cli import bench_tables
from linkwork.cli import output as out
from linkwork.errors import OptionError
from linkwork.mechanisms import MECHANISMS, named

#: Bodies of `bench rhs` where neither a size nor another mechanism is given.
CHAIN_BODIES = 1000

WORDS = {"true": True, "yes": True, "1": True, "false": False, "no": False, "0": False}


def right_hand_side(
    mechanism: str,
    bodies: int | None,
    parameters: Sequence[str],
    solvers: str,
    formulation: str,
    matrix_form: str,
    repeats: int,
    limit: float,
    threads: int,
    as_json: bool,
) -> None:
    """`linkwork bench rhs`."""
    given = _parameters(mechanism, parameters)
    if bodies is None and mechanism == "chain":
        bodies = CHAIN_BODIES
    subject = benchmark.Subject.of(mechanism, bodies, given)
    names = None if solvers == "all" else solvers.split(",")
    found = benchmark.compare_solvers(
        subject, names, formulation, matrix_form, rounds=repeats, limit=limit, threads=threads
    )
    if as_json:
        _print_json("rhs", asdict(found))
    else:
        bench_tables.show_comparison(found)


def scaling(
    mechanism: str,
    sizes: str,
    parameters: Sequence[str],
    linear_solver: str,
    formulation: str,
    repeats: int,
    limit: float,
    threads: int,
    as_json: bool,
) -> None:
    """`linkwork bench scaling`."""
    given = _parameters(mechanism, parameters)
    subjects = [benchmark.Subject.of(mechanism, bodies, given) for bodies in _whole_numbers(sizes)]
    found = benchmark.growth(
        subjects, linear_solver, formulation, rounds=repeats, limit=limit, threads=threads
    )
    if as_json:
        _print_json("scaling", asdict(found))
    else:
        bench_tables.show_growth(found)


def ensemble(mechanisms: str, repeats: int, threads: str, as_json: bool) -> None:
    """`linkwork bench ensemble`."""
    known = dict(benchmark.SUBJECTS)
    names = list(known) if mechanisms == "all" else mechanisms.split(",")
    counts = _whole_numbers(threads, "threads")
    found = benchmark.measure_lanes(
        [(name, known.get(name)) for name in names], threads=counts, rounds=repeats
    )
    if as_json:
        _print_json("ensemble", {"mechanisms": [asdict(it) for it in found]})
    else:
        bench_tables.show_lanes(found)


def large(
    models: str,
    size: str,
    links: int | None,
    methods: str,
    halvings: int,
    repeats: int,
    threads: int,
    peers: bool,
    limit: float,
    as_json: bool,
) -> None:
    """`linkwork bench large`."""
    found = benchmark.measure_large(
        () if models == "all" else models.split(","), size=size, links=links, methods=methods.split(","),
        halvings=halvings, repeats=repeats, threads=threads, peers=peers, limit=limit,
    )  # fmt: skip
    if as_json:
        named_found = [it._asdict() if isinstance(it, benchmark.Left) else asdict(it) for it in found]
        _print_json("large", {"models": named_found})
    else:
        bench_tables.show_large(found)


def step(mechanisms: str, repeats: int, runs: bool, as_json: bool) -> None:
    """`linkwork bench step`."""
    names = list(MECHANISMS) if mechanisms == "all" else mechanisms.split(",")
    subjects = [benchmark.Subject.of(name) for name in names]
    steps = benchmark.time_steps(subjects, rounds=repeats)
    long_runs = [benchmark.long_run(*run) for run in benchmark.LONG_RUNS] if runs else []
    if as_json:
        _print_json("step", {"steps": [asdict(s) for s in steps], "runs": [asdict(r) for r in long_runs]})
    else:
        bench_tables.show_steps(steps, long_runs)


def _parameters(mechanism: str, words: Sequence[str]) -> dict[str, Any]:
    """NAME=VALUE of the mechanism's parameters; the type of a value is that of the default."""
    known = named(mechanism).parameters
    defaults = {parameter.name: parameter.default for parameter in known}
    found = {}
    for word in words:
        name, equals, value = word.partition("=")
        if not equals:
            raise OptionError(f"'{word}' is not NAME=VALUE", code="parameter")
        found[name] = _converted(name, value, type(defaults.get(name, "")))
    return found


def _converted(name: str, value: str, kind: type) -> Any:
    try:
        return WORDS[value.lower()] if kind is bool else kind(value)
    except (KeyError, ValueError):
        raise OptionError(f"{name}={value}: give a value of type {kind.__name__}", code="parameter") from None


def _whole_numbers(words: str, what: str = "bodies") -> list[int]:
    try:
        return [int(word) for word in words.split(",")]
    except ValueError:
        message = f"{what} '{words}' are not whole numbers with commas between"
        raise OptionError(message, code=what) from None


def _print_json(name: str, found: dict[str, Any]) -> None:
    out.print_json({"benchmark": name, "machine": benchmark.machine(), **found})
