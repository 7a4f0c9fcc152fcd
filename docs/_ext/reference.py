"""The reference: made from docstrings, the compiled module's tables, the commands' help and the schema of
model files.

Nothing in it is written a second time. `PAGES` says on which page a name stands; tests/python/test_docs.py
sees to it that every public name stands on one.
"""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import linkwork
from house_docstrings import inline
from linkwork import _core
from linkwork.integrators import METHODS
from linkwork.mechanisms import MECHANISMS
from linkwork.options import TABLE
from linkwork.options.types import described

if TYPE_CHECKING:
    from sphinx.application import Sphinx

MADE = "reference/made"


@dataclass(frozen=True)
class Page:
    """A page of names: title, first words, and what stands on it, headings among the names."""

    title: str
    intro: str
    names: tuple[str, ...]


#: Names are of `linkwork`; one that begins with # is a heading; `Class.method` is one method.
PAGES = {
    "model": Page(
        "Model",
        "A mechanism under construction. Joints and forces have pages of their own.",
        (
            "# The model",
            "Model",
            "Model.ground",
            "Model.gravity",
            "Model.load",
            "Model.save",
            "Model.with_initial_state",
            "Model.describe",
            "Model.hash",
            "# Bodies",
            "Model.body",
            "Model.bodies",
            "Model.find",
            "Model.indices",
            "# Looking at it",
            "Model.view",
            "Model.plot",
            "Model.table",
            "linkwork.modeling.tables.Table",
            "# Changing it",
            "Model.values",
            "Model.replaced",
            "Model.without",
            "Model.with_gravity",
            "# Drawing",
            "Model.shape",
            "Box",
            "Cylinder",
            "Sphere",
            "Rod",
            "Mesh",
            "Shape",
            "# Counts and contents",
            "Model.body_count",
            "Model.joint_count",
            "Model.force_count",
            "Model.user_force_count",
            "Model.row_count",
            "Model.signals",
            "Model.drivers",
            "Model.user_forces",
            "Model.shapes",
            "Model.curves",
            "Model.compiled",
            "# Handles",
            "Body",
            "Joint",
            "Force",
            "linkwork.modeling.handles.Range",
            "linkwork.modeling.shapes.Shapes",
        ),
    ),
    "simulate": Page(
        "Running",
        "One run, from a model to its motion, and what can happen in it.",
        (
            "simulate",
            "# Events",
            "Event",
            "State",
            "Occurrence",
            "linkwork.running.events.BodyState",
            "# Going on",
            "Snapshot",
            "# Progress",
            "ProgressInfo",
        ),
    ),
    "result": Page(
        "Results",
        "The motion that a run found, as arrays over time.",
        (
            "Result",
            "linkwork.view.page.Page",
            "# Records",
            "BodyResult",
            "Reaction",
            "linkwork.modeling.coordinates.JointCoordinate",
            "linkwork.motion.records.ForceResult",
            "SingularPose",
            "linkwork.motion.records.Excess",
            "# Accuracy",
            "Verdict",
            "StepEstimate",
        ),
    ),
    "analyses": Page(
        "Analyses",
        "What can be found without simulating, or by simulating many times.",
        (
            "# Consistent initial conditions",
            "assemble",
            "Assembly",
            "JointResidual",
            "# Prescribed motion",
            "kinematics",
            "inverse_dynamics",
            "InverseDynamics",
            "Drive",
            "# Equilibrium and vibration",
            "equilibrium",
            "Equilibrium",
            "linearize",
            "Linearization",
            "# Parameters",
            "sensitivity",
            "Sensitivity",
        ),
    ),
    "comparison": Page(
        "Comparison",
        "One model by many methods, with the error of each.",
        (
            "compare",
            "Comparison",
            "# Records",
            "linkwork.comparison.runs.Outcome",
            "linkwork.comparison.reference.Reference",
            "linkwork.comparison.order.OrderStudy",
        ),
    ),
    "studies": Page(
        "Studies",
        "One mechanism in many variants.",
        ("sweep", "Study", "linkwork.studies.page.Server", "linkwork.studies.pictures.Swing"),
    ),
    "ensembles": Page(
        "Ensembles",
        "Many mechanisms of one structure at once, in the lanes of the processor.",
        ("simulate_many", "Ensemble", "EnsembleResult"),
    ),
    "system": Page(
        "Equations of motion",
        "The right-hand side itself, for integrators and codes of your own.",
        ("System", "linkwork.equations.system.Evaluation"),
    ),
    "importers": Page(
        "Robots",
        "Models from the files of other programs.",
        ("import_urdf", "import_sdf", "import_mjcf", "Imported", "linkwork.importers.Note"),
    ),
    "functions": Page(
        "Functions of time",
        inspect.getdoc(linkwork.functions) or "",
        (
            "functions.constant",
            "functions.polynomial",
            "functions.harmonic",
            "functions.cycloidal",
            "functions.table",
            "functions.piecewise_polynomial",
            "functions.expression",
            "functions.with_breaks",
            "functions.as_time_function",
            "functions.TimeFunction",
        ),
    ),
    "rotation": Page(
        "Rotations",
        inspect.getdoc(linkwork.rotation) or "",
        (
            "rotation.matrix",
            "rotation.about",
            "rotation.from_matrix",
            "rotation.from_axes",
            "rotation.perpendicular",
            "rotation.between",
        ),
    ),
    "errors": Page(
        "Errors",
        "What goes wrong is data: a class, a code, one line for people, and the numbers behind it.",
        (
            "LinkworkError",
            "ModelError",
            "OptionError",
            "SingularSystemError",
            "NotConvergedError",
            "NotFiniteError",
            "StepSizeError",
            "ViolationError",
            "AccuracyError",
            "BusyError",
            "FileError",
            "ModelFileError",
            "Fault",
            "LinkworkWarning",
        ),
    ),
}

#: Members of these stand where they are listed.
ALONE = ("Model",)

#: Methods of Model on the pages of joints and forces that no list of kinds has.
MORE_JOINTS = ("coupler", "point_on_curve")
FORCE_METHODS = ("force", "joint_force", "user_force", "compiled_force")


def joint_methods() -> list[str]:
    return [kind.name for kind in _core.joint_kinds()] + list(MORE_JOINTS)


def force_methods() -> list[str]:
    return [kind.name for kind in _core.force_kinds() if kind.name != "applied"]


# --- pages of names ---------------------------------------------------------------------------------------


def heading(text: str, line: str = "=") -> list[str]:
    return [text, line * len(text), ""]


def names_page(page: Page) -> Iterator[str]:
    yield from heading(page.title)
    yield from _paragraphs(page.intro)
    for name in page.names:
        yield from heading(name[2:], "-") if name.startswith("# ") else entry(name)


def _paragraphs(text: str) -> Iterator[str]:
    from house_docstrings import converted

    yield from converted(text.splitlines(), "module")


def entry(name: str) -> list[str]:
    """An autodoc directive."""
    full = name if name.startswith("linkwork.") else f"linkwork.{name}"
    value = resolved(full)
    kind, options = "function", []
    if inspect.isclass(value):
        kind = "exception" if issubclass(value, BaseException) else "class"
        options = [] if name in ALONE else ["   :members:"]
        if not (name in ALONE or name.startswith("linkwork.")):
            options.append("   :inherited-members: Exception, UserWarning, tuple")
    elif name.count(".") and inspect.isclass(resolved(full.rsplit(".", 1)[0])):
        owner = resolved(full.rsplit(".", 1)[0])
        is_property = isinstance(inspect.getattr_static(owner, name.rsplit(".", 1)[1]), property)
        kind = "property" if is_property else "method"
    return [f".. auto{kind}:: {full}", *options, ""]


def resolved(full: str) -> Any:
    from importlib import import_module

    words = full.split(".")
    for count in range(len(words), 0, -1):
        try:
            value: Any = import_module(".".join(words[:count]))
        except ImportError:
            continue
        for word in words[count:]:
            value = getattr(value, word)
        return value
    raise LookupError(full)


def joints_page() -> Iterator[str]:
    yield from heading("Joints")
    yield "Each is a method of :class:`linkwork.Model`; :doc:`/guide/joints` shows all of them."
    yield ""
    for name in joint_methods():
        yield from [*heading(name.replace("_", " "), "-"), f".. automethod:: linkwork.Model.{name}", ""]
    yield from [*heading("Drivers", "-"), ".. automethod:: linkwork.Model.drive", ""]
    yield from [*heading("Many at once", "-"), ".. automethod:: linkwork.Model.joints", ""]


def forces_page() -> Iterator[str]:
    yield from heading("Forces")
    yield "Each is a method of :class:`linkwork.Model`; :doc:`/guide/forces` shows them at work."
    yield ""
    for name in FORCE_METHODS[:1] + tuple(force_methods()) + FORCE_METHODS[1:]:
        yield from [*heading(name.replace("_", " "), "-"), f".. automethod:: linkwork.Model.{name}", ""]
    yield from [*heading("Restitution", "-"), *entry("contact_hysteresis")]
    yield from [*heading("Many at once", "-"), ".. automethod:: linkwork.Model.forces", ""]


# --- tables -----------------------------------------------------------------------------------------------


def table(head: Iterable[str], rows: Iterable[Iterable[str]], widths: str = "auto") -> Iterator[str]:
    yield from [".. list-table::", "   :header-rows: 1", f"   :widths: {widths}", "   :class: wide", ""]
    for row in (head, *rows):
        for number, cell in enumerate(row):
            yield f"   {'* - ' if number == 0 else '  - '}{cell}"
    yield ""


def code(name: str) -> str:
    return f"``{name}``"


def options_page() -> Iterator[str]:
    yield from heading("Options")
    yield "Choices of a run that are data: arguments of :func:`linkwork.simulate`, :class:`linkwork.System`"
    yield "and :func:`linkwork.compare`, options of the commands, fields of model files. What a choice"
    yield "cannot do is refused."
    yield ""
    rows = ((code(name), inline(described(option))) for name, option in TABLE.items())
    yield from table(("option", "what it is"), rows, "25 75")
    for title, kinds in (("Formulations", _core.formulations()), ("Stabilizations", _core.stabilizations()),
                         ("Linear solvers", _core.linear_solvers())):  # fmt: skip
        yield from heading(title, "-")
        rows = ([code(kind.name), inline(kind.documentation), _forms(kind)] for kind in kinds)
        yield from table(("name", "what it is", "matrices"), rows, "25 55 20")


def _forms(kind: Any) -> str:
    return ", ".join(code(name) for name in getattr(kind, "matrix_forms", ()))


def integrators_page() -> Iterator[str]:
    yield from heading("Integrators")
    yield from _paragraphs(inspect.getdoc(linkwork.integrators) or "")
    rows = (
        [code(name), str(it.order), type(it).__name__, inline(it.reference)] for name, it in METHODS.items()
    )
    yield from table(("name", "order", "kind", "reference"), rows, "20 10 25 45")
    for name in ("ButcherTableau", "EmbeddedPair", "AdamsBashforth", "AdamsBashforthMoulton", "HalfExplicit",
                 "SemiImplicitEuler", "named"):  # fmt: skip
        yield from entry(f"integrators.{name}")


def mechanisms_page() -> Iterator[str]:
    yield from heading("Mechanisms")
    yield from _paragraphs(inspect.getdoc(linkwork.mechanisms) or "")
    for name, mechanism in MECHANISMS.items():
        yield from heading(name.replace("_", " "), "-")
        yield from [f".. autofunction:: linkwork.mechanisms.{name}", ""]
        settings = ", ".join(f"{key}={value!r}" for key, value in mechanism.settings.items())
        yield from [f"Recommended: ``{settings}``.", ""]
    yield from heading("What they are made of", "-")
    listed = set(MECHANISMS) | {"MECHANISMS"}
    for name in linkwork.mechanisms.__all__:
        if name not in listed:
            yield from entry(f"mechanisms.{name}")


def modules_page() -> Iterator[str]:
    """Of validation and benchmarks, which have few names."""
    from linkwork import benchmark, validation

    yield from heading("Validation and benchmarks")
    for module in (validation, benchmark):
        yield from heading(module.__name__, "-")
        yield from _paragraphs(inspect.getdoc(module) or "")
        for name in module.__all__:
            value = getattr(module, name)
            if inspect.isclass(value) or inspect.isfunction(value):
                yield from entry(f"{module.__name__}.{name}")


# --- commands ---------------------------------------------------------------------------------------------


def cli_page() -> Iterator[str]:
    from linkwork.cli.commands import linkwork as program

    yield from heading("Command line")
    yield from _paragraphs(inspect.getdoc(linkwork.cli) or "")
    yield from help_of(program, "linkwork")
    for name, command in program.commands.items():
        yield from heading(f"linkwork {name}", "-")
        yield from help_of(command, f"linkwork {name}", mechanisms=name == "run")
        if isinstance(command, click.Group):
            for inner in list(command.list_commands(click.Context(command)))[
                : 1 if name != "bench" else None
            ]:
                inner = "four_bar" if name != "bench" else inner
                found = command.get_command(click.Context(command), inner)
                assert found is not None
                yield from [f"``linkwork {name} {inner} --help``:", ""]
                yield from help_of(found, f"linkwork {name} {inner}")


def help_of(command: click.Command, words: str, mechanisms: bool = True) -> list[str]:
    """As it is printed; the list of mechanisms, which several commands have, once."""
    context = click.Context(
        command,
        info_name=words,
        terminal_width=92,
        max_content_width=92,
        help_option_names=["-h", "--help"],
    )
    text = command.get_help(context)
    text = text if mechanisms else text.partition("\nMechanisms:")[0]
    return [".. code-block:: text", "", *(f"   {line}" for line in text.splitlines()), ""]


# --- the schema -------------------------------------------------------------------------------------------


def schema_page() -> Iterator[str]:
    from linkwork.modeling.files import json_schema

    schema = json_schema()
    yield from heading("Model files")
    yield "What a file may have, from its schema, which ``linkwork schema`` prints. :doc:`/guide/model-files`"
    yield "tells how to write one."
    yield ""
    yield from _properties(schema)
    yield "Where an element sits can also be said exactly, by ``attachment`` (an AttachmentRecord) in place"
    yield "of points and axes: ``Model.save`` writes that where nothing else gives the same bits."
    yield ""
    for name, record in sorted(schema["$defs"].items()):
        if name.endswith(EXACT):
            continue
        yield from [f".. _schema-{name}:", "", *heading(name, "-")]
        yield from [inline(record.get("description", "")), ""]
        yield from _properties(record)
        if not record.get("properties"):
            facts = {key: it for key, it in record.items() if key not in ("description", "title")}
            yield from [f"``{json.dumps(facts)[:400]}``", ""]


#: Ending of the records of elements whose place is said exactly.
EXACT = "__attached"

#: So many kinds of records are named in a table.
FEW = 5


def _properties(record: Mapping[str, Any]) -> Iterator[str]:
    needed = set(record.get("required", ()))
    rows = [
        (
            code(name),
            _type(field) + (", needed" if name in needed else ""),
            inline(" ".join(field.get("description", "").split())),
        )
        for name, field in record.get("properties", {}).items()
    ]
    if rows:
        yield from table(("field", "type", "meaning"), rows, "20 30 50")


def _type(field: Mapping[str, Any]) -> str:
    if "$ref" in field:
        name = field["$ref"].rsplit("/", 1)[1]
        return f":ref:`{name} <schema-{name}>`"
    if "items" in field and isinstance(field["items"], dict):
        return f"list of {_type(field['items'])}"
    if "enum" in field or "const" in field:
        return " or ".join(code(str(it)) for it in field.get("enum", [field.get("const")]))
    choices = field.get("anyOf") or field.get("oneOf")
    if choices:
        words = dict.fromkeys(_type(it) for it in choices if not it.get("$ref", "").endswith(EXACT))
        return " or ".join(words) if len(words) <= FEW else f"one of the {len(words)} kinds below"
    return str(field.get("type", "any"))


#: Pages that are no lists of names.
MADE_PAGES: dict[str, Callable[[], Iterator[str]]] = {
    "joints": joints_page,
    "forces": forces_page,
    "options": options_page,
    "integrators": integrators_page,
    "mechanisms": mechanisms_page,
    "modules": modules_page,
    "cli": cli_page,
    "schema": schema_page,
}


def texts() -> dict[str, str]:
    """Of all pages."""
    pages: dict[str, Iterable[str]] = {name: names_page(page) for name, page in PAGES.items()}
    pages |= {name: make() for name, make in MADE_PAGES.items()}
    return {name: "\n".join(lines) + "\n" for name, lines in pages.items()}


def write(app: Sphinx) -> None:
    """What has not changed stays untouched, so that it is not read again."""
    folder = Path(app.srcdir) / MADE
    folder.mkdir(exist_ok=True)
    for name, text in texts().items():
        file = folder / f"{name}.rst"
        if not file.exists() or file.read_text() != text:
            file.write_text(text)


def setup(app: Sphinx) -> Mapping[str, Any]:
    app.connect("builder-inited", write, priority=100)
    return {"parallel_read_safe": True}
