"""The options of a run on the command line; their names are those of `linkwork.simulate`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import click

from linkwork.cli import shells


class _Limits(click.ParamType):  # type: ignore[type-arg]  # generic in newer versions only
    """A number, or numbers by name."""

    name = "limits"

    def convert(self, value: Any, param: click.Parameter | None, context: click.Context | None) -> Any:
        try:
            if "=" not in str(value):
                return float(value)
            pairs = (word.partition("=") for word in value.split(","))
            return {level.strip(): float(limit) for level, _, limit in pairs}
        except ValueError:
            self.fail(f"'{value}' is no limit; write 1e-8, or position=1e-8,velocity=1e-6", param, context)


#: name of the argument of `simulate`, type, help
_OPTIONS: tuple[tuple[str, type | click.ParamType[Any], str], ...] = (
    ("t_end", float, "End of the simulated time [s]."),
    ("step", float, "Step of the integrator [s]; with --rtol or --atol the largest."),
    ("rtol", float, "Relative tolerance: steps that follow it (bs32, dopri5, tsit5, dop853)."),
    ("atol", float, "Absolute tolerance [m, rad, m/s, rad/s]; without it rtol / 1000."),
    ("integrator", str, "rk4, dopri5, ab4, ...: any of `linkwork.integrators.METHODS`."),
    ("formulation", str, "standard, penalty or augmented_lagrangian."),
    ("system", str, "Linear system of the standard method: kkt, schur or auto."),
    (
        "stabilization",
        str,
        "none, baumgarte, sampled_baumgarte, projection, position_projection or velocity_projection.",
    ),
    ("linear_solver", str, "cholmod, umfpack, klu, spqr, eigen_ldlt, dense or auto."),
    ("penalty", float, "Penalty factor; without it scaled to the mechanism."),
    ("baumgarte_alpha", float, "Gain of the velocity violation [1/s]."),
    ("baumgarte_beta", float, "Gain of the position violation [1/s]."),
    ("damping_ratio", float, "Damping ratio mu of (12.14)."),
    ("frequency", float, "Frequency omega of (12.14) [rad/s]."),
    ("tolerance", float, "At which the augmented Lagrangian iteration stops."),
    ("max_iterations", int, "Cap of the augmented Lagrangian iteration."),
    ("on_singular", str, "At a singular pose: pass, warn or stop."),
    (
        "violation_limit",
        _Limits(),
        "Of positions, or by level: position=1e-8,velocity=1e-6,acceleration=1e-9.",
    ),
    ("on_violation", str, "Beyond --violation-limit: record, project or stop."),
    ("on_inaccurate", str, "Estimated to be more than 1 % off: pass, warn or stop."),
    ("verify", bool, "A second run at half the step or a tenth of the tolerances: error bands in the plots."),
    (
        "start",
        click.Path(),
        "Go on from the last frame of this result file, which is of the same mechanism, at its time.",
    ),
    ("record_every", int, "Steps between recorded frames; without it about 1000 frames."),
)

NAMES = tuple(name for name, _, _ in _OPTIONS)


def options(settings: Mapping[str, Any]) -> list[click.Option]:
    """The options; the mechanism's recommended `settings` are shown as their defaults."""
    return [
        click.Option(
            ["--" + name.replace("_", "-"), name],
            type=None if kind is bool else kind,
            is_flag=kind is bool,
            default=None,
            shell_complete=shells.names_of(name),
            help=text + (f"  [default: {settings[name]}]" if name in settings else ""),
        )
        for name, kind, text in _OPTIONS
    ]


def outputs() -> list[click.Option]:
    """Where the results go."""
    return [
        click.Option(
            ["--output"],
            type=click.Path(),
            metavar="FILE",
            help="Write the result to this HDF5 file, while the run goes on.",
        ),
        click.Option(
            ["--plot"],
            type=click.Path(),
            metavar="FILE",
            help="Write a picture of the result (.png, .pdf, .svg).",
        ),
    ]
