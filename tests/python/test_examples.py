"""Every public function and method shows in its docstring how it is called, and what it shows runs."""

from __future__ import annotations

import ast
import inspect
import shutil
import warnings
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import functions, integrators, mechanisms, rotation

ROBOTS = Path(__file__).parent / "robots"


def public() -> Iterator[tuple[str, Callable[..., Any]]]:
    """Functions of linkwork and of its modules, methods of its classes."""
    for name in lw.__all__:
        value = getattr(lw, name)
        if inspect.isfunction(value):
            yield name, value
        elif inspect.isclass(value) and not issubclass(value, BaseException):
            for method in dir(value) if value is lw.Model else vars(value):
                found = inspect.getattr_static(value, method)
                found = found.__func__ if isinstance(found, classmethod | staticmethod) else found
                if inspect.isfunction(found) and not method.startswith("_"):
                    yield f"{name}.{method}", found
    for module in (functions, integrators, mechanisms, rotation):
        short = module.__name__.removeprefix("linkwork.")
        for name in getattr(module, "__all__", [name for name in vars(module) if not name.startswith("_")]):
            value = getattr(module, name)
            if inspect.isfunction(value) and value.__module__.startswith("linkwork"):
                yield f"{short}.{name}", value


def examples(function: Callable[..., Any]) -> list[str]:
    """The indented blocks of a docstring that call it."""
    blocks = (inspect.getdoc(function) or "").split("\n\n")
    code = [block for block in blocks if all(line.startswith("    ") for line in block.splitlines())]
    programs = ["\n".join(line[4:] for line in block.splitlines()) for block in code]
    return [program for program in programs if f"{function.__name__}(" in program]


PUBLIC = dict(public())


def test_every_public_name_has_an_example() -> None:
    assert [name for name, function in PUBLIC.items() if not examples(function)] == []


@pytest.mark.parametrize("name", PUBLIC)
def test_example_runs(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MPLBACKEND", "Agg")
    monkeypatch.chdir(tmp_path)
    for example in examples(PUBLIC[name]):
        words = {node.id for node in ast.walk(ast.parse(example)) if isinstance(node, ast.Name)}
        with warnings.catch_warnings():
            if name == "Imported.warn":  # what it is for
                warnings.simplefilter("ignore", lw.LinkworkWarning)
            exec(example, {"lw": lw, "np": np} | what_there_is(name, example, words))


# --- what examples begin with ---


def crank() -> lw.Model:
    """A slider-crank and a loose wheel, with names that examples use."""
    model = lw.Model(gravity=(0, 0, -9.81), name="slider-crank")
    model.body("crank", mass=1.0, inertia=(0.01, 0.02, 0.02), position=(0, 0, 0.15))
    model.body("rod", mass=1.0, inertia=(0.01, 0.05, 0.05), position=(0.4, 0, 0.15))
    model.body("piston", mass=2.0, inertia=(0.01, 0.01, 0.01), position=(0.8, 0, 0))
    model.body("wheel", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0, 1, 0))
    model.revolute("ground", "crank", at=(0, 0, 0), axis=(0, 1, 0), name="motor pin")
    model.spherical("crank", "rod", at=(0, 0, 0.3), name="pin")
    model.universal("rod", "piston", at=(0.8, 0, 0), axes=((0, 1, 0), (0, 0, 1)))
    model.translational("ground", "piston", at=(0.8, 0, 0), axis=(1, 0, 0))
    model.revolute("ground", "wheel", at=(0, 1, 0), axis=(0, 1, 0), name="wheel pin")
    model.spring_damper("ground", "piston", at=((1.2, 0, 0), (0.8, 0, 0)), stiffness=500.0,
                        free_length=0.3, name="spring")  # fmt: skip
    return model


def driven() -> lw.Model:
    model = crank()
    model.drive("motor pin", velocity=2.0, name="motor")
    model.drive("wheel pin", velocity=1.0)
    return model


def wheels() -> lw.Model:
    """What elements that couple others want; their examples add bodies of their own."""
    model = lw.Model()
    for pin in ("motor pin", "wheel pin"):
        wheel = model.body(mass=1, inertia=(1, 1, 1))
        model.revolute("ground", wheel, at=(0, 0, 0), axis=(0, 1, 0), name=pin)
    return model


def sprung() -> lw.Model:
    """A pendulum that hangs nearly at rest."""
    model = lw.Model(gravity=(0, 0, -9.81), name="pendulum")
    model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(0.1, 0, -0.99))
    model.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0), name="pin")
    model.spring_damper("ground", "rod", at=((0, 0, 1), (0.1, 0, -0.99)), stiffness=1.0, name="spring")
    return model


def pendulum(length: float, mass: float) -> lw.Model:
    model = lw.Model()
    model.body("rod", mass=mass, inertia=(0.1, 0.1, 0.1), position=(length, 0, 0))
    model.revolute("ground", "rod", at=(0, 0, 0), axis=(0, 1, 0))
    return model


def motion(model: lw.Model) -> lw.Result:
    return lw.simulate(model, t_end=0.1, step=1e-3, progress=False)


@cache
def comparison() -> lw.Comparison:
    steps, methods = [4e-3, 2e-3], ["rk4", "euler"]
    return lw.compare(crank(), 0.04, steps=steps, integrators=methods, processes=1, progress=False)


@cache
def found() -> lw.Sensitivity:
    height = {"height": lambda result: result.position[-1, 0, 2]}
    return lw.sensitivity(pendulum, {"length": 1.0, "mass": 2.0}, height, t_end=0.1, step=1e-3)


@cache
def study() -> lw.Study:
    height = {"height": "body('rod').position.z.min"}
    masses = {"rod.mass": [1, 2, 3, 4], "crank.mass": [1, 2, 3, 4]}
    return lw.sweep(crank(), masses, height, t_end=0.05, step=1e-3, processes=1, progress=False)


MADE: dict[str, Callable[[], Any]] = {
    "result": lambda: motion(crank()),
    "build": lambda: pendulum,
    "comparison": comparison,
    "found": found,
    "study": study,
    "ensemble": lambda: lw.Ensemble(crank(), {"rod.mass": [1, 2, 3]}),
    "many": lambda: lw.simulate_many(crank(), {"rod.mass": [1, 2, 3]}, 0.05, step=1e-3, progress=False),
    "rest": lambda: lw.equilibrium(sprung()),
    "vibration": lambda: lw.linearize(lw.equilibrium(sprung()).model),
    "needed": lambda: lw.inverse_dynamics(driven(), np.linspace(0, 1, 11)),
}

#: Models of examples that need others than `crank`.
MODELS = {
    "kinematics": driven,
    "inverse_dynamics": driven,
    "equilibrium": sprung,
    "linearize": sprung,
    "Model.replaced": sprung,
}

ARM_MJCF = """<mujoco><worldbody><body name="upper"><joint name="shoulder" axis="0 1 0"/><geom size="0.1"/>
<body name="lower" pos="0.5 0 0"><joint name="elbow" axis="0 1 0"/><geom size="0.1"/></body></body>
</worldbody></mujoco>"""

TRIANGLE = """solid link
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid link
"""


def write_files(model: lw.Model) -> None:
    """What examples read."""
    shutil.copy(ROBOTS / "arm.urdf", "arm.urdf")
    shutil.copy(ROBOTS / "four_bar.sdf", "arm.sdf")
    Path("models").mkdir()
    Path("arm.xml").write_text(ARM_MJCF)
    Path("link.stl").write_text(TRIANGLE)
    model.save("crank.yaml")


def what_there_is(name: str, example: str, words: set[str]) -> dict[str, Any]:
    """Values of the names that an example begins with."""
    write_files(crank())
    model = MODELS.get(name, wheels if "= model.body(" in example else crank)()
    if name == "Model.save":
        Path("crank.yaml").unlink()
    if name == "Result.load":
        motion(model).save("motion.h5")
    return {"model": model} | {word: make() for word, make in MADE.items() if word in words}
