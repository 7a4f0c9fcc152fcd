"""What a choice cannot do is refused with the reason, never ignored."""

from __future__ import annotations

import ast
import math
from pathlib import Path
from typing import Any

import h5py
import linkwork as lw
import pytest
import synthetic
from linkwork import _core
from linkwork.integrators import METHODS

#: Options that are refused, and what the message must have.
REFUSED: dict[str, tuple[dict[str, Any], list[str]]] = {
    "unknown formulation": ({"formulation": "standart"}, ["'standart'", "'standard'"]),
    "unknown stabilization": ({"stabilization": "baumgart"}, ["'baumgart'", "'baumgarte'"]),
    "unknown linear solver": ({"linear_solver": "umpfack"}, ["'umpfack'", "'umfpack'"]),
    "unknown matrix form": ({"matrix_form": "shur"}, ["'shur'", "'schur'"]),
    "unknown option": ({"formulaton": "standard"}, ["'formulaton'", "'formulation'"]),
    "penalty without a penalty": ({"penalty": 1e7}, ["penalty", "'standard'", "'augmented_lagrangian'"]),
    "frequency without a penalty": ({"frequency": 10.0}, ["frequency", "'standard'", "'penalty'"]),
    "iterations without iteration": (
        {"formulation": "penalty", "max_iterations": 3},
        ["max_iterations", "'penalty'", "'augmented_lagrangian'"],
    ),
    "tolerance without iteration": (
        {"tolerance": 1e-9},
        ["tolerance", "'standard'", "'augmented_lag"],
    ),
    "negative penalty": ({"formulation": "penalty", "penalty": -3.0}, ["penalty", "-3.0"]),
    "NaN penalty": ({"formulation": "penalty", "penalty": math.nan}, ["penalty", "nan"]),
    "no iterations": ({"formulation": "augmented_lagrangian", "max_iterations": 0}, ["max_iterations", "0"]),
    "gains of no stabilization": (
        {"stabilization": "none", "baumgarte_alpha": 1.0, "baumgarte_beta": 1.0},
        ["baumgarte_alpha", "'none'"],
    ),
    "one gain of two": ({"baumgarte_beta": 1.0}, ["baumgarte_beta", "baumgarte_alpha"]),
    "damping with another stabilization": (
        {"formulation": "penalty", "damping_ratio": 1.0, "stabilization": "sampled_baumgarte"},
        ["damping_ratio", "'baumgarte'", "'sampled_baumgarte'"],
    ),
    "two pairs of gains": (
        {"formulation": "penalty", "frequency": 10.0, "baumgarte_alpha": 1.0, "baumgarte_beta": 1.0},
        ["frequency", "baumgarte_alpha"],
    ),
    "a solver that cannot factorize the system": (
        {"matrix_form": "kkt", "linear_solver": "eigen_ldlt"},
        ["'eigen_ldlt'", "kkt", "'schur'"],
    ),
    "a system that the formulation does not have": (
        {"formulation": "penalty", "matrix_form": "schur"},
        ["'schur'", "'penalty'"],
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_an_option_that_cannot_be_honored_is_refused_with_the_reason(case: str) -> None:
    options, fragments = REFUSED[case]
    with pytest.raises(lw.OptionError) as caught:
        lw.System(lw.mechanisms.pendulum(), **options)
    message = str(caught.value)
    assert [fragment for fragment in fragments if fragment not in message] == [], message


@pytest.mark.parametrize("formulation", [info.name for info in _core.formulations()])
@pytest.mark.parametrize("matrix_form", ["auto", "kkt", "schur"])
@pytest.mark.parametrize("linear_solver", ["auto", *(info.name for info in _core.linear_solvers())])
def test_a_choice_of_methods_is_honored_or_refused(
    formulation: str, matrix_form: str, linear_solver: str
) -> None:
    info = {f.name: f for f in _core.formulations()}[formulation]
    solvable = {s.name: s.matrix_forms if s.available else [] for s in _core.linear_solvers()} | {
        "auto": info.matrix_forms
    }
    possible = [s for s in info.matrix_forms if matrix_form in ("auto", s) and s in solvable[linear_solver]]
    choice = {"formulation": formulation, "matrix_form": matrix_form, "linear_solver": linear_solver}
    if not possible:
        with pytest.raises(lw.OptionError):
            lw.System(lw.mechanisms.chain(3), **choice)
        return
    chosen = lw.System(lw.mechanisms.chain(3), **choice).options
    assert chosen["matrix_form"] in possible
    assert chosen["linear_solver"] == linear_solver or linear_solver == "auto"


def test_damping_ratio_and_frequency_are_gains_of_baumgarte() -> None:
    options = lw.System(
        lw.mechanisms.pendulum(), formulation="penalty", damping_ratio=0.5, frequency=20.0
    ).options
    assert options["stabilization"] == "baumgarte"
    assert (options["baumgarte_alpha"], options["baumgarte_beta"]) == (10.0, 20.0)


def test_the_textbook_damping_ratio_is_one() -> None:
    options = lw.System(lw.mechanisms.pendulum(), formulation="penalty", frequency=10.0).options
    assert (options["baumgarte_alpha"], options["baumgarte_beta"]) == (10.0, 10.0)


def test_none_stands_for_the_default() -> None:
    given = lw.System(lw.mechanisms.pendulum(), penalty=None, linear_solver="auto").options
    assert given == lw.System(lw.mechanisms.pendulum()).options


# --- the table of options -----------------------------------------------------------------------------------

#: Those that some methods have only, each with a value that is none's default.
SPECIAL = {option.name: option for option in _core.options() if option.methods}


def option_of(name: str) -> str:
    """The first that a message names where pairs are given."""
    return "baumgarte_alpha" if name == "baumgarte_beta" else name


def value_of(option: _core.OptionInfo) -> float:
    return 7 if option.type == "whole" else 0.5


@pytest.mark.parametrize("formulation", [info.name for info in _core.formulations()])
@pytest.mark.parametrize("stabilization", [info.name for info in _core.stabilizations()])
@pytest.mark.parametrize("name", SPECIAL)
def test_a_method_has_an_option_or_refuses_it(name: str, formulation: str, stabilization: str) -> None:
    """The gains of (12.14) are those of Baumgarte, so that of the stabilizations they need this one."""
    option = SPECIAL[name]
    choice = {"formulation": formulation, "stabilization": stabilization, name: value_of(option)}
    if name.startswith("baumgarte"):
        choice |= {"baumgarte_alpha": 0.5, "baumgarte_beta": 0.5}
    gain = name in ("damping_ratio", "frequency")
    if {formulation, stabilization} & set(option.methods) and (not gain or stabilization == "baumgarte"):
        chosen = lw.System(lw.mechanisms.pendulum(), **choice).options
        assert gain or chosen[name] == value_of(option)
        return
    with pytest.raises(
        lw.OptionError, match=rf"^{option_of(name)}.* use (formulation|stabilization) '"
    ) as caught:
        lw.System(lw.mechanisms.pendulum(), **choice)
    assert caught.value.code == "conflict"
    assert gain or [method for method in option.methods if f"'{method}'" not in str(caught.value)] == []


def test_what_a_run_chose_can_be_asked_for_again() -> None:
    for formulation in _core.formulations():
        chosen = lw.System(lw.mechanisms.four_bar(), formulation=formulation.name).options
        assert lw.System(lw.mechanisms.four_bar(), **chosen).options == chosen


def test_type_checkers_know_every_option_and_every_name() -> None:
    tree = ast.parse((Path(lw.__file__).parent / "options" / "types.pyi").read_text())
    (fields,) = (node for node in tree.body if isinstance(node, ast.ClassDef))
    types = {it.target.id: ast.unparse(it.annotation) for it in fields.body if isinstance(it, ast.AnnAssign)}
    assert list(types) == [option.name for option in _core.options()]
    for option in _core.options():
        assert all(f"'{name}'" in types[option.name] for name in option.choices), option.name
    (names,) = (
        ast.unparse(node.value) for node in tree.body
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "IntegratorName"
    )  # fmt: skip
    assert ast.literal_eval(names.removeprefix("Literal")) == list(METHODS)


# --- former names -------------------------------------------------------------------------------------------


def test_code_is_told_of_the_name_of_today() -> None:
    with pytest.raises(lw.OptionError, match="'system' is called 'matrix_form' now"):
        lw.System(lw.mechanisms.pendulum(), system="kkt")  # type: ignore[call-arg]
    with pytest.raises(lw.OptionError, match="'system' is called 'matrix_form' now"):
        lw.compare(lw.mechanisms.pendulum(), 0.1, steps=1e-2, system="kkt", progress=False)


def test_files_are_read_with_the_former_name(tmp_path: Path) -> None:
    model, run = tmp_path / "model.yaml", tmp_path / "run.h5"
    lw.mechanisms.pendulum().save(model)
    model.write_text(model.read_text() + "\nsimulation: {t_end: 0.01, step: 0.001, system: schur}\n")
    assert lw.mechanisms.named(str(model)).settings["matrix_form"] == "schur"
    lw.simulate(lw.mechanisms.pendulum(), 0.01, 1e-3, matrix_form="schur", output=run, progress=False)
    with h5py.File(run, "r+") as file:
        synthetic.strip_digests(file)
        file.attrs["manifest"] = file.attrs["manifest"].replace("matrix_form", "system")
    manifest = lw.Result.load(run).manifest
    assert manifest["options"]["matrix_form"] == manifest["options_given"]["matrix_form"] == "schur"
