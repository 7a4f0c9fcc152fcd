"""C++ tests mirror the sources: the facts of a module name.cpp are in tests/cpp/test_name.cpp."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIBRARY = ROOT / "cpp" / "linkwork"
TESTS = ROOT / "tests" / "cpp"

FORMULATIONS = re.findall(
    r"^LINKWORK_FORMULATION\((\w+)\)", (LIBRARY / "formulation" / "formulations.def").read_text(), re.M
)
#: Folders of registered things: one test runs over all of them.
REGISTERED = {
    "model/joints": "joints",
    "model/forces": "forces",
    "linear/backends": "linear_solver",
}
#: Parts of one whole behind one interface, by which they are tested.
PARTS = {
    **{f"formulation/{name}": "formulation" for name in FORMULATIONS},
    "math/instruction_set": "batch",
    "math/usable_cores": "thread_pool",
    "assembly/system_algebra": "system",
    "assembly/system_compilation": "system",
    "model/coordinate_rows": "inerters",
    "integration/adaptive_events": "adaptive_simulation",
    "integration/adaptive_switches": "adaptive_simulation",
    "integration/crossing_frames": "crossing",
    "integration/crossing_leaps": "crossing",
    "integration/departure": "crossing",
    "linear/kkt": "saddle_solver",
    "linear/normal": "saddle_solver",
    "linear/schur": "saddle_solver",
    **{f"ensemble/{path.stem}": "ensemble" for path in (LIBRARY / "ensemble").glob("lane*.cpp")},
    "linear/block/dispatch": "block_solver",
    "linear/block/core_elimination": "block_solver",
    "linear/block/tree_elimination": "block_solver",
    "linear/block/kernels": "block_solver",
}
#: Nothing but clocks, whose numbers no test can know.
WITHOUT_LOGIC = {"formulation/right_hand_side_times"}
#: Tests of the whole library.
OF_ALL = {"allocation", "shared_evaluation", "threads"}


def modules() -> dict[str, str]:
    """Sources without their ending, and the test that each asks for."""
    found = {}
    for path in sorted(LIBRARY.rglob("*.cpp")):
        module = path.relative_to(LIBRARY).with_suffix("")
        registered = REGISTERED.get(str(module.parent))
        found[str(module)] = PARTS.get(str(module)) or registered or module.name
    return {module: test for module, test in found.items() if module not in WITHOUT_LOGIC}


def names_of_tests() -> set[str]:
    return {path.stem.removeprefix("test_") for path in TESTS.glob("test_*.cpp")}


def test_every_source_has_its_test() -> None:
    assert len(modules()) > 80
    missing = {
        module: f"tests/cpp/test_{test}.cpp"
        for module, test in modules().items()
        if test not in names_of_tests()
    }
    assert not missing


def test_every_test_has_its_source() -> None:
    headers = {path.stem for path in LIBRARY.rglob("*.hpp")}
    assert names_of_tests() - set(modules().values()) - headers - OF_ALL == set()


def test_exceptions_are_sources() -> None:
    assert all((LIBRARY / f"{module}.cpp").exists() for module in [*PARTS, *WITHOUT_LOGIC])
    assert not [module for module in PARTS if module.rsplit("/")[-1] in names_of_tests()]
    assert all(list((LIBRARY / folder).glob("*.cpp")) for folder in REGISTERED)
