"""`run NAME`, `check NAME` and the like: a mechanism's record turned into a command."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from linkwork.cli import base, compare_options, run_options

if TYPE_CHECKING:
    from linkwork.mechanisms import Mechanism

JSON = click.Option(["--json", "as_json"], is_flag=True, help="Print one JSON document.")


def run_command(name: str, mechanism: Mechanism) -> click.Command:
    def run(**values: Any) -> None:
        from linkwork.cli.running import simulate_and_show

        simulate_and_show(name, mechanism, parameters=_taken(values, mechanism), **_grouped(values))

    options = [
        *_parameter_options(mechanism),
        *run_options.options(mechanism.settings),
        *run_options.outputs(),
        JSON,
    ]
    return _command(name, mechanism, options, run, "linkwork run {name} --t-end 0.5 --plot {name}.png")


def check_command(name: str, mechanism: Mechanism) -> click.Command:
    def check(as_json: bool, **values: Any) -> None:
        from linkwork.cli.checking import check_and_show

        check_and_show(name, mechanism, _taken(values, mechanism), as_json)

    options = [*_parameter_options(mechanism), JSON]
    return _command(name, mechanism, options, check, "linkwork check {name} --json")


def compare_command(name: str, mechanism: Mechanism) -> click.Command:
    def compare(**values: Any) -> None:
        from linkwork.cli.comparing import compare_and_show

        parameters = _taken(values, mechanism)
        rest = {what: value for what, value in values.items() if what not in parameters}
        compare_and_show(name, mechanism, parameters=parameters, **rest)

    options = [*_parameter_options(mechanism), *compare_options.options(), JSON]
    return _command(
        name, mechanism, options, compare, "linkwork compare {name} --t-end 0.5 --html {name}.html"
    )


def equilibrium_command(name: str, mechanism: Mechanism) -> click.Command:
    def equilibrium(**values: Any) -> None:
        from linkwork.cli.analyzing import equilibrium_and_show

        equilibrium_and_show(name, mechanism, **_split(values, mechanism))

    nearest = click.Option(["--nearest"], is_flag=True, help="The nearest one of any kind, not downhill.")
    options = [*_parameter_options(mechanism), nearest, JSON]
    return _command(name, mechanism, options, equilibrium, "linkwork equilibrium {name} --json")


def linearize_command(name: str, mechanism: Mechanism) -> click.Command:
    def linearize(**values: Any) -> None:
        from linkwork.cli.analyzing import linearize_and_show

        linearize_and_show(name, mechanism, **_split(values, mechanism))

    options = [
        *_parameter_options(mechanism),
        click.Option(["--modes"], type=click.IntRange(1),
                     help="How many; without it all of a small model, 10 of a large one."),
        click.Option(["--near"], type=base.Number(), default=0.0, show_default=True,
                     help="Frequency that the modes are nearest to [rad/s]."),
        click.Option(["--as-is"], is_flag=True, help="About the initial state, not the equilibrium."),
        JSON,
    ]  # fmt: skip
    return _command(name, mechanism, options, linearize, "linkwork linearize {name} --modes 4")


def kinematics_command(name: str, mechanism: Mechanism) -> click.Command:
    def kinematics(**values: Any) -> None:
        from linkwork.cli.analyzing import kinematics_and_show

        kinematics_and_show(name, mechanism, **_split(values, mechanism))

    positive = base.Positive()
    options = [
        *_parameter_options(mechanism),
        click.Option(["--drive"], type=Speed(), multiple=True,
                     help="Drive this joint from its initial pose on at a speed [rad/s or m/s]; repeatable."),
        click.Option(["--t-end"], type=positive, default=1.0, show_default=True, help="End [s]."),
        click.Option(["--step"], type=positive, default=0.01, show_default=True, help="Between frames [s]."),
        *run_options.outputs(),
        JSON,
    ]  # fmt: skip
    example = "linkwork kinematics {name} --drive JOINT=2 --t-end 0.5"
    return _command(name, mechanism, options, kinematics, example)


class Speed(click.ParamType):  # type: ignore[type-arg]  # generic in newer versions only
    """A joint and its speed."""

    name = "JOINT=SPEED"

    def convert(self, value: Any, param: click.Parameter | None, context: click.Context | None) -> Any:
        joint, _, speed = str(value).rpartition("=")
        try:
            return joint, float(speed)
        except ValueError:
            self.fail(f"'{value}' is no joint with a speed; write 'pin 0=2'", param, context)


def _split(values: dict[str, Any], mechanism: Mechanism) -> dict[str, Any]:
    """The parameters of the mechanism in one, the rest as it is."""
    parameters = _taken(values, mechanism)
    rest = {what: value for what, value in values.items() if what not in parameters}
    return {"parameters": parameters, **rest}


def _command(
    name: str, mechanism: Mechanism, options: Sequence[click.Parameter], callback: Any, example: str
) -> click.Command:
    help_text = f"{mechanism.description}\n\n\b\n{example.format(name=name)}"
    return base.Command(name, params=list(options), callback=callback, help=help_text)


def _parameter_options(mechanism: Mechanism) -> list[click.Option]:
    """An option for every parameter of the mechanism's function: its type is the type of its default.

    A yes or no is a flag.
    """
    return [
        click.Option(
            ["--" + parameter.name.replace("_", "-"), parameter.name],
            type=type(parameter.default),
            is_flag=isinstance(parameter.default, bool),
            default=parameter.default,
            show_default=True,
            help=parameter.description,
        )
        for parameter in mechanism.parameters
    ]


def _taken(values: dict[str, Any], mechanism: Mechanism) -> dict[str, Any]:
    return {parameter.name: values[parameter.name] for parameter in mechanism.parameters}


def _grouped(values: dict[str, Any]) -> dict[str, Any]:
    """What `simulate_and_show` takes: the options of the run that were given, and where the results go."""
    options = {name: values[name] for name in run_options.NAMES if values[name] is not None}
    return {"options": options, **{name: values[name] for name in ("output", "plot", "as_json")}}
