"""The tree of commands. A mechanism is a subcommand of `run` and `check` with options of its own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click
from click.shell_completion import CompletionItem

from linkwork.cli import base, shells
from linkwork.cli.bench_commands import bench
from linkwork.cli.exporting import export, movie, plot
from linkwork.cli.report import report
from linkwork.cli.sweeping import sweep
from linkwork.cli.view import view

if TYPE_CHECKING:
    from linkwork.mechanisms import Mechanism

SETTINGS = {"help_option_names": ["-h", "--help"], "max_content_width": 110}


@click.group(context_settings=SETTINGS, cls=base.Group, invoke_without_command=True)
@click.version_option(package_name="linkwork", message="%(prog)s %(version)s")
@click.option(
    "--log", type=click.Path(), metavar="FILE", help="Append what happens to this file; before the command."
)
@click.pass_context
def linkwork(context: click.Context, log: str | None) -> None:
    """Simulate spatial mechanisms and compare the methods that solve their equations.

    \b
    linkwork demo                          one mechanism by the four methods, in one table
    linkwork run four_bar --plot run.png   simulate a mechanism
    linkwork run chain --help              the options of one mechanism
    linkwork compare four_bar --t-end 2    a mechanism by many methods, with the error of each
    linkwork validate                      published problems, and our error against each

    --force, anywhere, replaces files that are there; --debug shows the Python traceback of an error.
    `linkwork completion --help` tells how the shell completes commands and mechanisms.

    Exit codes: 0 done, 1 the model, the options or the run failed, 2 the command line is wrong, 130
    interrupted, 143 asked to end. With --json errors are JSON, too: {"error": {"code": ..., ...}}.
    """
    if log is not None:
        from linkwork.cli.logs import write_to

        write_to(log)
    if context.invoked_subcommand is None:
        click.echo(context.get_help())


class MechanismGroup(base.Group):
    """One subcommand for every registered mechanism, and for every file that has one."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, subcommand_metavar="NAME|FILE [OPTIONS]", **kwargs)

    def list_commands(self, context: click.Context) -> list[str]:
        from linkwork.mechanisms import MECHANISMS

        return list(MECHANISMS)

    def resolve_command(
        self, context: click.Context, words: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        from linkwork.mechanisms import is_file

        if is_file(words[0]) and not words[0].startswith("-"):
            return words[0], self.get_command(context, words[0]), words[1:]
        return super().resolve_command(context, words)

    def get_command(self, context: click.Context, name: str) -> click.Command | None:
        from linkwork.cli import mechanism_commands
        from linkwork.mechanisms import MECHANISMS, is_file, named

        make = {
            "run": mechanism_commands.run_command,
            "check": mechanism_commands.check_command,
            "compare": mechanism_commands.compare_command,
            "equilibrium": mechanism_commands.equilibrium_command,
            "kinematics": mechanism_commands.kinematics_command,
            "linearize": mechanism_commands.linearize_command,
        }[self.name or ""]
        return make(name, named(name)) if name in MECHANISMS or is_file(name) else None

    def shell_complete(self, context: click.Context, incomplete: str) -> list[CompletionItem]:
        """Names, or files where none begins like that."""
        return super().shell_complete(context, incomplete) or [CompletionItem(incomplete, type="file")]

    def format_commands(self, context: click.Context, formatter: click.HelpFormatter) -> None:
        from linkwork.mechanisms import MECHANISMS

        with formatter.section("Mechanisms"):
            formatter.write_dl([(name, _short(mechanism)) for name, mechanism in MECHANISMS.items()])
        if self.name == "run":
            from linkwork.cli import run_options

            found = [*run_options.options({}), *run_options.outputs()]
            records = [record for option in found if (record := option.get_help_record(context))]
            with formatter.section("Options of every run, after the name"):
                formatter.write_dl(records)


@linkwork.group(cls=MechanismGroup, what="mechanism")
def run() -> None:
    """Simulate a mechanism, by its name or from a file (.yaml, .json, .urdf, .sdf, .xml).

    \b
    linkwork run four_bar --t-end 2 --output run.h5 --plot run.png

    `linkwork run NAME --help` shows its parameters and the options of the run.
    """


@linkwork.group(cls=MechanismGroup, what="mechanism")
def check() -> None:
    """Examine a mechanism before it is simulated, by its name or from a file (.yaml, .json, .urdf, ...).

    \b
    linkwork check bricard

    Degrees of freedom, rank of the constraints, redundant joints, initial residuals, inertias.
    """


@linkwork.group(cls=MechanismGroup, what="mechanism")
def compare() -> None:
    """Simulate a mechanism by many methods and measure the error of each.

    \b
    linkwork compare spatial_slider_crank --t-end 2 --steps 1e-2,5e-3,2.5e-3 --html c.html

    Against a reference solution whose own error is estimated: poses, velocities, reactions, violation,
    energy, effort, order. `linkwork compare NAME --help` shows the axes of the grid.
    """


@linkwork.group(cls=MechanismGroup, what="mechanism")
def equilibrium() -> None:
    """Find where a mechanism stays at rest, and whether it returns there.

    \b
    linkwork equilibrium chain --bodies 5

    Poses, reactions, and the motion that is held least; from the initial pose, downhill.
    """


@linkwork.group(cls=MechanismGroup, what="mechanism")
def linearize() -> None:
    """Frequencies, damping and shapes of small vibrations.

    \b
    linkwork linearize chain --bodies 1000 --modes 5

    About the equilibrium that is found from the initial pose, or about the initial state with --as-is.
    """


@linkwork.group(cls=MechanismGroup, what="mechanism")
def kinematics() -> None:
    """The motion that drivers prescribe, and the forces and torques that they need for it.

    \b
    linkwork kinematics four_bar --drive 'pin 0=2' --t-end 2

    For mechanisms whose freedoms are all fixed by drivers: those of a model from a file
    (`linkwork kinematics crank.yaml --plot crank.png`), or --drive. Dead points are told.
    """


linkwork.add_command(bench)


@linkwork.command()
@click.argument("problems", nargs=-1, metavar="[PROBLEM]...", shell_complete=shells.names_of("problem"))
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
@click.pass_context
def validate(context: click.Context, problems: tuple[str, ...], as_json: bool) -> None:
    """Solve the reference problems and print the error of each.

    \b
    linkwork validate
    linkwork validate andrews heavy_top --json

    Published benchmarks and closed forms, computed without linkwork; the exit code is 1 where an error is
    larger than required.
    """
    from linkwork.cli.validating import validate_and_show

    if not validate_and_show(problems, as_json):
        context.exit(1)


linkwork.add_command(sweep)
linkwork.add_command(view)
linkwork.add_command(report)
linkwork.add_command(plot)
linkwork.add_command(movie)
linkwork.add_command(export)


@linkwork.command("list")
@click.argument("what", default="mechanisms", type=click.Choice(["mechanisms", "joints", "forces"]))
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def list_known(what: str, as_json: bool) -> None:
    """List the mechanisms and their parameters, or the kinds of joints or forces with units and bounds.

    \b
    linkwork list --json
    linkwork list joints
    """
    from linkwork.cli import listing

    if what == "mechanisms":
        listing.show_mechanisms(as_json)
    else:
        listing.show_kinds("joint" if what == "joints" else "force", as_json)


@linkwork.command()
@click.option(
    "--output-dir",
    default=".",
    show_default=True,
    type=click.Path(),
    metavar="DIR",
    help="Where the result and the picture go.",
)
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def demo(output_dir: str, as_json: bool) -> None:
    """Simulate one mechanism by every method, side by side.

    \b
    linkwork demo --output-dir demo

    A spatial slider-crank by the four methods of Flores (2015), chapter 12, in one table: violation, energy,
    reactions, effort. Writes linkwork-demo.h5 and linkwork-demo.png; --force replaces those that are there.
    """
    from linkwork.cli.demonstration import show

    show(output_dir, as_json)


@linkwork.command()
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
def completion(shell: str) -> None:
    """Print what makes a shell complete commands, mechanisms and options at the tab key.

    \b
    linkwork completion bash >> ~/.bashrc
    linkwork completion zsh >> ~/.zshrc
    linkwork completion fish > ~/.config/fish/completions/linkwork.fish
    """
    from linkwork.cli.shells import script

    click.echo(script(linkwork, shell))


@linkwork.command()
def schema() -> None:
    """Print the JSON schema of model files, which YAML files follow, too.

    \b
    linkwork schema > linkwork.schema.json
    """
    from linkwork.cli.output import print_json
    from linkwork.modeling import files

    print_json(files.json_schema())


@linkwork.command()
@click.argument("source", type=click.Path(), metavar="IN")
@click.argument("target", type=click.Path(), metavar="OUT")
@click.option(
    "--floating/--fixed", default=None, help="Links that nothing carries move freely, or are the ground."
)
@click.option("--keep-massless", is_flag=True, help="Take moving links without inertia as massless bodies.")
@click.option(
    "--repair-inertia", is_flag=True, help="Give links that no real body can be the nearest that one can."
)
@click.option(
    "--inertia-as-is", is_flag=True, help="Take inertias that no real body has as they are in the file."
)
@click.option(
    "--limits",
    type=click.Choice(["note", "stops"]),
    default="note",
    show_default=True,
    help="Ends of joints are only listed, or become end stops.",
)
@click.option("--shapes/--no-shapes", default=True, help="Links look as in the file, or have default shapes.")
@click.option(
    "--couple/--no-couple",
    default=True,
    help="Joints that follow others (mimic, gearboxes) do so, or are free.",
)
@click.option("--merge-fixed", is_flag=True, help="Make one body of links that are fixed to each other.")
@click.option(
    "--align-axes",
    type=base.Number(),
    metavar="ANGLE",
    help="Axes parallel or perpendicular to within it [rad] are made so; without it those of closed loops.",
)
@click.option(
    "--assemble",
    is_flag=True,
    help="Move the bodies at t = 0 by the least that satisfies joints and drivers.",
)
@click.option(
    "--search-path",
    multiple=True,
    metavar="FOLDER",
    help="URDF, SDF: where meshes and included models are; may be repeated.",
)
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def convert(source: str, target: str, as_json: bool, assemble: bool, **options: Any) -> None:
    """Write the mechanism of one file to another: from URDF, SDF, MJCF, YAML or JSON to YAML or JSON.

    \b
    linkwork convert panda.urdf panda.yaml

    What OUT does not have of IN is listed. The options but --assemble are for URDF, SDF and MJCF.
    """
    from linkwork.cli.convert import convert_and_show

    convert_and_show(source, target, as_json, assemble, options)


@linkwork.command(cls=base.Command)
@click.argument("source", type=click.Path(), metavar="FILE")
@click.option(
    "--output",
    "target",
    type=click.Path(),
    metavar="FILE",
    help="The new file; without it run.repaired.h5 beside run.h5. An existing one is not replaced.",
)
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def repair(source: str, target: str | None, as_json: bool) -> None:
    """Write what is whole of a damaged result file, or of that of an interrupted run, to a new one.

    \b
    linkwork repair run.h5
    linkwork repair run.h5 --output whole.h5 --json

    The frames before the first that is not as it was written; what is missing is listed, and the new file
    knows it, too. Of a file in which nothing is missing none is written.
    """
    from linkwork.cli.repairing import repair_and_show

    repair_and_show(source, target, as_json)


def _short(mechanism: Mechanism) -> str:
    return str(mechanism.description).split(". ")[0].rstrip(".")
