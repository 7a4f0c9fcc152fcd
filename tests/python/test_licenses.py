"""What a build links and offers: all of SuiteSparse, what of it is not under the GPL, or nothing."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import linkwork as lw
import numpy as np
import pytest
from linkwork import _core

ROOT = Path(__file__).parents[2]
#: Linear solvers by the library that has them and that is under the GPL.
OF_GPL = {"umfpack": "libumfpack", "spqr": "libspqr", "cholmod_supernodal": "libcholmod"}
FREE = {"block", "eigen_ldlt", "dense"}
AVAILABLE = {info.name for info in _core.linear_solvers() if info.available}
MISSING = [info.name for info in _core.linear_solvers() if not info.available]


def loaded() -> set[str]:
    """Libraries of SuiteSparse that importing the module loads into a process."""
    code = "import linkwork._core as core; print(open('/proc/self/maps').read())"
    maps = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    return {Path(line.split()[-1]).name.split(".")[0] for line in maps.splitlines() if ".so" in line}


@pytest.mark.skipif(not Path("/proc/self/maps").exists(), reason="needs /proc")
def test_the_module_loads_the_libraries_of_what_it_offers_and_no_others() -> None:
    libraries = loaded()
    for solver, library in OF_GPL.items():
        assert (library in libraries) == (solver in AVAILABLE), solver
    assert ("libcholmod" in libraries) == ("cholmod" in AVAILABLE)
    assert ("libklu" in libraries) == ("klu" in AVAILABLE)
    if "klu" not in AVAILABLE:
        assert not any(
            name.startswith(("libamd", "libcolamd", "libsuitesparse", "libblas")) for name in libraries
        )
    assert AVAILABLE >= FREE


def test_parts_under_the_gpl_come_together() -> None:
    assert AVAILABLE & OF_GPL.keys() in (set(), set(OF_GPL))


@pytest.mark.parametrize("solver", MISSING)
def test_what_is_not_in_this_build_is_refused_with_the_reason_and_what_there_is(solver: str) -> None:
    with pytest.raises(lw.OptionError, match=f"'{solver}' is not in this build.*(GPL|SuiteSparse)") as caught:
        lw.System(lw.mechanisms.four_bar(), linear_solver=solver)
    assert caught.value.code == "linear_solver_not_built"
    assert all(name in str(caught.value).split("choose from:")[1] for name in FREE)


@pytest.mark.parametrize(
    ("formulation", "matrix_form"),
    [
        (info.name, form)
        for info in _core.formulations()
        for form in ("auto", *info.matrix_forms)
        if form != "normal"
    ],
)
def test_auto_chooses_among_what_there_is(formulation: str, matrix_form: str) -> None:
    for model in (lw.mechanisms.pendulum(), lw.mechanisms.chain(200)):
        chosen = lw.System(model, formulation=formulation, matrix_form=matrix_form).options
        assert chosen["linear_solver"] in AVAILABLE


def test_ranks_and_redundant_equations_need_nothing_under_the_gpl() -> None:
    """A row of four-bars: three equations of each loop repeat the others."""
    model = lw.mechanisms.four_bar(200)
    found, state = lw.System(model).compiled().rank(), model.compiled()
    assert (found.rows - found.rank, found.degrees_of_freedom) == (3 * 200, 1)
    ours, _ = lw.System(model).accelerations(0.0, state.q0, state.v0)
    other, _ = lw.System(model, linear_solver="eigen_ldlt").accelerations(0.0, state.q0, state.v0)
    assert np.abs(ours - other).max() <= 1e-9 * np.abs(other).max()


@pytest.mark.skipif(not (shutil.which("cmake") and shutil.which("ninja")), reason="needs CMake and Ninja")
@pytest.mark.parametrize(("with_gpl", "with_suitesparse"), [(False, True), (True, True), (True, False)])
def test_a_build_without_gpl_parts_links_none(with_gpl: bool, with_suitesparse: bool, tmp_path: Path) -> None:
    """The command that links a program with the library, as CMake would run it."""
    given = {"GPL": with_gpl, "SUITESPARSE": with_suitesparse}
    options = [f"-DLINKWORK_WITH_{name}={'ON' if on else 'OFF'}" for name, on in given.items()]
    options.append("-DLINKWORK_BUILD_PYTHON=OFF")
    configure = ["cmake", "-G", "Ninja", "-S", ROOT, "-B", tmp_path, "-DLINKWORK_BUILD_TESTS=ON", *options]
    subprocess.run(configure, capture_output=True, check=True)
    rules = (tmp_path / "build.ninja").read_text()
    linked = " ".join(line for line in rules.splitlines() if line.lstrip().startswith("LINK_LIBRARIES ="))
    for library in ("umfpack", "spqr", "cholmod"):
        assert (library in linked) == (with_gpl and with_suitesparse), library
    for library in ("klu", "btf", "suitesparseconfig"):
        assert (library in linked) == with_suitesparse, library
