"""The rooms of the Python package: a module imports its own room and those before it, and there is no cycle.

Imports inside functions count like those at the top of a file. So do imports for type checkers, except of
the classes that everything speaks of; between modules of one room they may go both ways.
"""

import ast
from collections.abc import Iterator
from graphlib import TopologicalSorter
from pathlib import Path
from typing import NamedTuple

import linkwork as lw

#: Modules and packages in python/linkwork; "linkwork" itself, the public names, stands before the commands.
ROOMS = [
    "_core", "former", "arrays", "blas_threads", "memory", "errors", "replacement", "fingerprints",
    "arguments", "rotation", "functions", "integrators", "options", "modeling", "equations", "motion",
    "constraints", "accuracy", "plots", "view", "results", "running", "analyses", "importers",
    "mechanisms", "comparison", "studies", "ensemble", "validation", "benchmark", "linkwork", "cli",
    "__main__",
]  # fmt: skip

#: What everything speaks of: an earlier room may import these for type checkers.
SPOKEN_OF = {"Model", "Result", "Snapshot"}

#: What one asks a model for, though it is made from it: modules that an earlier one opens when it is asked.
DOORS = {
    ("linkwork.modeling.model", f"linkwork.{target}") for target in ("results.initial_pose", "view.page")
}

PYTHON = Path(__file__).resolve().parents[2] / "python"
MODULES = {
    ".".join(path.relative_to(PYTHON).with_suffix("").parts).removesuffix(".__init__"): path
    for path in sorted((PYTHON / "linkwork").rglob("*.py"))
}


class Import(NamedTuple):
    module: str
    line: int
    target: str  # a module
    name: str  # of what is imported from it
    typing: bool  # for type checkers only

    def __str__(self) -> str:
        file = MODULES[self.module].relative_to(PYTHON)
        return f"{file}:{self.line}: {self.name or 'import'} of {self.target}"


def room_name(module: str) -> str:
    """linkwork.<room>..."""
    return [*module.split("."), "linkwork"][1]


def imports_of(module: str) -> list[Import]:
    return list(_imports(module, ast.parse(MODULES[module].read_text(encoding="utf-8")), False))


def _imports(module: str, node: ast.AST, typing: bool) -> Iterator[Import]:
    for part in ast.iter_child_nodes(node):
        if isinstance(part, ast.Import):
            for it in part.names:
                if it.name.split(".")[0] == "linkwork":
                    yield Import(module, part.lineno, it.name, "", typing)
        elif isinstance(part, ast.ImportFrom):
            assert part.level == 0 and part.module is not None, f"{module}:{part.lineno}: a relative import"
            for it in part.names if part.module.split(".")[0] == "linkwork" else ():
                yield Import(module, part.lineno, _home(part.module, it.name), it.name, typing)
        else:
            checked = isinstance(part, ast.If) and ast.unparse(part.test) == "TYPE_CHECKING"
            yield from _imports(module, part, typing or checked)


def _home(module: str, name: str) -> str:
    """The module that is meant: one of a package, or that of a public name."""
    if (inside := f"{module}.{name}") in MODULES or name == "_core":
        return inside
    return lw._HOME.get(name, module) if module == "linkwork" else module


def test_every_module_stands_in_a_room() -> None:
    assert {room_name(module) for module in MODULES} == set(ROOMS) - {"_core"}


def test_no_import_points_to_a_later_room() -> None:
    upward = [
        str(it)
        for module in MODULES
        for it in imports_of(module)
        if ROOMS.index(room_name(it.target)) > ROOMS.index(room_name(module))
        if not (it.typing and it.name in SPOKEN_OF) and (it.module, it.target) not in DOORS
    ]
    assert not upward, "\n" + "\n".join(upward)


def test_no_modules_import_each_other() -> None:
    """CycleError names them."""
    graph = {
        module: {it.target for it in imports_of(module) if not it.typing} - {module} for module in MODULES
    }
    assert len(list(TopologicalSorter(graph).static_order())) >= len(MODULES)


def test_type_checkers_know_the_public_names_from_where_they_are() -> None:
    stub = ast.parse(MODULES["linkwork"].with_suffix(".pyi").read_text(encoding="utf-8"))
    found = {it.asname or it.name: part.module for part in stub.body if isinstance(part, ast.ImportFrom)
             for it in part.names}  # fmt: skip
    modules = dict.fromkeys(lw._MODULES, "linkwork")
    assert found == lw._HOME | modules
    assert sorted([*found, "__version__"]) == lw.__all__
