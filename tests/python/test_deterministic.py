"""deterministic=True: the same bits by every set of instructions, and none of what cannot promise that."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import deterministic_bits
import linkwork as lw
import numpy as np
import pytest
from linkwork import _core, mechanisms

GOLDEN = json.loads(Path(__file__).with_name("deterministic_bits.json").read_text())

#: Of glibc, numpy and OpenBLAS, and our own: what the processor has, and we do not want to be used.
HIDDEN = {
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX512F,-AVX512VL,-AVX2,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable",
    "NPY_DISABLE_CPU_FEATURES": "AVX512F AVX512_SKX AVX2 FMA3",
    "OPENBLAS_CORETYPE": "Prescott",
}

#: Looked at without all of the processor: loops, trees, drivers, contacts, massless bodies.
SOME = ("andrews", "bricard", "net", "double_wishbone")


@pytest.mark.parametrize("name", deterministic_bits.Listed)
@pytest.mark.filterwarnings("ignore")
def test_every_mechanism_has_the_bits_that_it_had(name: str) -> None:
    assert deterministic_bits.digest(name) == GOLDEN[name]


@pytest.mark.parametrize("path", ["x86-64-v2", "x86-64-v3"])
def test_bits_are_those_without_wide_registers_and_fused_multiplication(path: str) -> None:
    environment = {**os.environ, **HIDDEN, "LINKWORK_INSTRUCTION_SET": path}
    done = subprocess.run(
        [sys.executable, deterministic_bits.__file__, *SOME], env=environment, capture_output=True, text=True
    )
    assert json.loads(done.stdout) == {name: GOLDEN[name] for name in SOME}, done.stderr


@pytest.mark.parametrize("name", ["x86-64-v9", "avx2", ""])
def test_a_set_of_instructions_that_there_is_not_is_refused(name: str) -> None:
    """A misspelled one would leave the widest in use, without a word. An empty one is none."""
    command = [
        sys.executable,
        "-c",
        "from linkwork.cli import main; main()",
        "run",
        "pendulum",
        "--t-end",
        "0.01",
    ]
    environment = {**os.environ, "LINKWORK_INSTRUCTION_SET": name}
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert done.returncode == (1 if name else 0)
    said = f"LINKWORK_INSTRUCTION_SET: '{name}' is none of "
    assert (
        not name or said in done.stderr and done.stderr.startswith("error: ") and done.stderr.count("\n") == 1
    )


@pytest.mark.parametrize("solver", ["spqr", "umfpack", "cholmod", "cholmod_supernodal"])
def test_solvers_with_blas_are_refused(solver: str) -> None:
    with pytest.raises(lw.OptionError) as caught:
        lw.System(mechanisms.net(4), linear_solver=solver, formulation="penalty", deterministic=True)
    there = [it.name for it in _core.linear_solvers() if it.available]
    assert solver not in there or caught.value.code == "deterministic"


def test_the_usual_run_is_the_deterministic_one_but_for_roundoff() -> None:
    """And the choice is in its manifest."""
    model = mechanisms.net(8)
    usual, one = (
        lw.simulate(model, 0.05, 1e-3, deterministic=on, progress=False, on_inaccurate="pass")
        for on in (False, True)
    )
    np.testing.assert_allclose(one.q, usual.q, rtol=0, atol=1e-10)
    assert one.manifest["options"]["deterministic"] is True
    assert usual.manifest["options"]["deterministic"] is False


def test_what_is_no_switch_is_refused() -> None:
    with pytest.raises(lw.OptionError, match="deterministic 'yes' is not True or False"):
        lw.System(mechanisms.pendulum(), deterministic="yes")  # type: ignore[arg-type]
