"""`linkwork run`: simulate, then say what happened."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from linkwork.cli import output as out
from linkwork.errors import OptionError

if TYPE_CHECKING:
    from linkwork.mechanisms import Mechanism


def simulate_and_show(
    name: str,
    mechanism: Mechanism,
    parameters: Mapping[str, Any],
    options: Mapping[str, Any],
    output: str | None,
    plot: str | None,
    as_json: bool,
) -> None:
    """Run with the mechanism's recommended settings where no option was given."""
    import linkwork as lw
    from linkwork import summary

    if plot is not None:
        from linkwork import plotting

        out.check_writable(plot)
        plotting.check_format(plot)
    model = mechanism.function(**parameters)
    try:
        result = lw.simulate(model, **_settings(mechanism, options), output=output)
    except KeyboardInterrupt as stop:
        raise KeyboardInterrupt(
            f"interrupted; '{output}' has the frames so far" if output else "interrupted"
        ) from stop
    if plot is not None:
        result.plot(plot)
    files = {"result": output, "picture": plot}
    if as_json:
        out.print_json(
            {
                "mechanism": name,
                "parameters": dict(parameters),
                "result": summary.numbers(result),
                "statistics": result.statistics,
                "manifest": result.manifest,
                "files": files,
            }
        )
    else:
        out.print_pairs([*summary.lines(result), *((label, path or "") for label, path in files.items())])


def _settings(mechanism: Mechanism, options: Mapping[str, Any]) -> dict[str, Any]:
    """The options that were given, over the recommended. OptionError: nothing says when the run ends."""
    settings = {**_recommended(mechanism, options), **options}
    if "t_end" not in settings:
        raise OptionError(
            "t_end is missing: give --t-end, or `simulation: {t_end: ...}` in the file", code="t_end"
        )
    return settings


def _recommended(mechanism: Mechanism, options: Mapping[str, Any]) -> dict[str, Any]:
    """The mechanism's settings; a recommended step is no limit for steps that follow tolerances."""
    adaptive = "rtol" in options or "atol" in options
    return {name: value for name, value in mechanism.settings.items() if not (adaptive and name == "step")}
