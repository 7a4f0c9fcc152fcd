"""`linkwork demo`: one spatial mechanism by the four methods of Flores (2015), chapter 12, side by side."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork.cli import output as out
from linkwork.errors import FileError, cause

if TYPE_CHECKING:
    from linkwork.results.result import Result

MECHANISM = "spatial_slider_crank"

#: The reference has this many times smaller steps, and a method of order 5.
FINER = 4


@dataclass(frozen=True)
class Method:
    """One column of the table: a name on up to two lines, the equations in the book, the options."""

    name: str
    equations: str
    options: dict[str, Any]

    @property
    def label(self) -> str:
        return self.name.replace("\n", " ").strip()


#: The book's parameters: Baumgarte's gains [1/s]; penalty factor, damping ratio and frequency [rad/s].
GAINS = {"baumgarte_alpha": 5.0, "baumgarte_beta": 5.0}
PENALTY = {"penalty": 1e7, "damping_ratio": 1.0, "frequency": 10.0}

METHODS = (
    Method("Lagrange\nmultipliers", "12.3", {"formulation": "standard", "stabilization": "none"}),
    Method("\nBaumgarte", "12.8", {"formulation": "standard", "stabilization": "baumgarte", **GAINS}),
    Method("\npenalty", "12.14", {"formulation": "penalty", **PENALTY}),
    Method("augmented\nLagrangian", "12.16-18", {"formulation": "augmented_lagrangian", **PENALTY}),
    Method("sampled\nBaumgarte", "default", {}),
)


@dataclass(frozen=True)
class Outcome:
    """What one method made of the mechanism."""

    method: Method
    result: Result
    reaction_difference: float
    seconds: float

    def numbers(self) -> dict[str, Any]:
        violation = self.result.violation.max(axis=0)
        statistics = self.result.statistics
        return {
            "max_position_violation": float(violation[0]),
            "max_velocity_violation": float(violation[1]),
            "max_energy_error": float(np.abs(self.result.energy_error).max()),
            "reaction_difference": self.reaction_difference,
            "evaluations": statistics["evaluations"],
            "factorizations": statistics["factorizations"],
            "iterations": statistics["iterations"],
            "seconds": self.seconds,
        }


ROWS = (
    ("max_position_violation", "position violation", "{:.1e}"),
    ("max_velocity_violation", "velocity violation", "{:.1e}"),
    ("max_energy_error", "energy error [J]", "{:.1e}"),
    ("reaction_difference", "reaction difference", "{:.1e}"),
    ("evaluations", "evaluations", "{:,}"),
    ("factorizations", "factorizations", "{:,}"),
    ("iterations", "iterations", "{:,}"),
    ("seconds", "time [s]", "{:.3f}"),
)


def show(output_dir: str, as_json: bool) -> None:
    """Run every method, print the table, write the default method's result and the picture."""
    from linkwork.mechanisms import MECHANISMS
    from linkwork.plots import figures

    files = {
        "result": Path(output_dir) / "linkwork-demo.h5",
        "picture": Path(output_dir) / "linkwork-demo.png",
    }
    _make_directory(output_dir)
    for what, file in files.items():
        out.check_writable(file, what)

    settings = dict(MECHANISMS[MECHANISM].settings)
    step, t_end = settings.pop("step"), settings.pop("t_end")
    outcomes = run_methods(t_end, step, settings)

    outcomes[-1].result.save(files["result"], overwrite=True)
    title = f"{MECHANISM}, {outcomes[-1].result.manifest['options']['integrator']}, step {step:g} s"
    figures.plot_methods({o.method.label: o.result for o in outcomes}, files["picture"], title)
    if as_json:
        out.print_json(_document(t_end, step, outcomes, files))
    else:
        _print(t_end, step, outcomes, files)


def run_methods(t_end: float, step: float, settings: dict[str, Any]) -> list[Outcome]:
    """Every method on the mechanism, and how far its reactions are from those of the reference."""
    import linkwork as lw
    from linkwork.mechanisms import MECHANISMS

    model = MECHANISMS[MECHANISM].function()
    every = max(1, round(t_end / step / 1000))
    reference = lw.simulate(model, t_end, step / FINER, integrator="dopri5", record_every=FINER * every)
    outcomes = []
    for method in METHODS:
        start = time.perf_counter()
        result = lw.simulate(model, t_end, step, record_every=every, **{**settings, **method.options})
        seconds = time.perf_counter() - start
        outcomes.append(Outcome(method, result, _reaction_difference(result, reference), seconds))
    return outcomes


def _reaction_difference(result: Result, reference: Result) -> float:
    """Largest difference of any joint's force at any time, relative to the largest force of the reference."""
    force, exact = result.reactions().force, reference.reactions().force
    return float(np.linalg.norm(force - exact, axis=-1).max() / np.linalg.norm(exact, axis=-1).max())


def _document(t_end: float, step: float, outcomes: list[Outcome], files: dict[str, Path]) -> dict[str, Any]:
    methods = [
        {"name": o.method.label, "equations": o.method.equations, "options": o.method.options, **o.numbers()}
        for o in outcomes
    ]
    reference = {"integrator": "dopri5", "step": step / FINER}
    return {"mechanism": MECHANISM, "t_end": t_end, "step": step, "reference": reference, "methods": methods,
            "files": files}  # fmt: skip


def _print(t_end: float, step: float, outcomes: list[Outcome], files: dict[str, Path]) -> None:
    result = outcomes[-1].result
    integrator = result.manifest["options"]["integrator"]
    print(
        f"{MECHANISM} ({len(result.body_names)} bodies, {len(result.joint_names)} joints), {t_end:g} s by "
        f"{integrator} with steps of {step:g} s\n"
    )
    columns = ("", *(f"{o.method.name}\n({o.method.equations})" for o in outcomes))
    table = [o.numbers() for o in outcomes]
    rows = [(label, *(form.format(numbers[key]) for numbers in table)) for key, label, form in ROWS]
    out.print_table(columns, rows)
    print(
        "\nEquation numbers and parameters are those of Flores (2015), chapter 12: gains\n"
        "of 5 1/s; penalty 1e7, damping ratio 1, frequency 10 rad/s. Violations and\n"
        "energy errors are the largest over time. Reaction difference: the largest error\n"
        "of any joint's force, relative to the largest force, against a reference run\n"
        f"(the default method with dopri5 and steps of {step / FINER:g} s).\n"
    )
    out.print_pairs([(label, str(path)) for label, path in files.items()])


def _make_directory(path: str) -> None:
    try:
        Path(path).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(
            f"output directory '{path}': cannot be made: {cause(error)}", code="not_writable"
        ) from error
