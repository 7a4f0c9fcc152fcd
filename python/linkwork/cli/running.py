"""`linkwork run`: simulate, then say what happened."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from linkwork.cli import output as out
from linkwork.cli.base import may_replace
from linkwork.errors import OptionError, counted
from linkwork.integrators import METHODS, EmbeddedPair
from linkwork.motion.records import Snapshot
from linkwork.results.result import Result
from linkwork.running.time_scale import TOLERANCE, usual_end

if TYPE_CHECKING:
    from linkwork import Model
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
    from linkwork.motion import summary

    if plot is not None:
        from linkwork.plots import figures

        out.check_writable(plot, "picture")
        figures.check_format(plot)
    model = mechanism.function(**parameters)
    settings = settings_of(mechanism, options, model)
    if "start" in settings:
        settings["start"] = _last_state(settings["start"], model, settings["t_end"])
    try:
        result = lw.simulate(model, **settings, output=output, overwrite=may_replace())
    except KeyboardInterrupt as stop:
        raise type(stop)(f"interrupted{_kept(output, getattr(stop, 'result', None))}") from stop
    if plot is not None:
        result.plot(plot)
    files = {"result": output, "picture": plot}
    if as_json:
        out.print_json({
            "mechanism": name, "parameters": dict(parameters), "result": summary.numbers(result),
            "statistics": result.statistics, "manifest": result.manifest, "files": files,
        })  # fmt: skip
    else:
        out.print_pairs([*summary.lines(result), *((label, path or "") for label, path in files.items())])


def _kept(output: str | None, result: Result | None) -> str:
    """What is left of a run that was interrupted, in words."""
    if output is None or result is None:
        return ""
    if not len(result):
        return f"; '{output}' has no frame yet"
    return f"; '{output}' has {counted(len(result), 'frame')} up to t = {result.t[-1]:g} s"


def settings_of(mechanism: Mechanism, options: Mapping[str, Any], model: Model) -> dict[str, Any]:
    """The options that were given, over the recommended; what neither says is chosen, and that is told."""
    settings = {**mechanism.settings_beside(options), **options}
    chosen = []
    if "t_end" not in settings:
        settings["t_end"], why = usual_end(model)
        chosen.append(f"--t-end {settings['t_end']:g} ({why})")
    follows = "integrator" not in settings or isinstance(METHODS.get(settings["integrator"]), EmbeddedPair)
    if follows and not settings.keys() & {"step", "rtol", "atol"}:
        settings["rtol"] = TOLERANCE
        chosen.append(f"--rtol {TOLERANCE:g}")
    if chosen:
        out.note(f"chosen, as neither the file nor an option says: {', '.join(chosen)}")
    return settings


def _last_state(path: str, model: Model, t_end: float) -> Snapshot:
    """Of a result file. OptionError: it is of other bodies, has no frame, or ends too late."""
    found = Result.load(path)
    core = model.compiled()
    own = [core.body_name(body) for body in range(core.body_count)]
    if sorted(found.body_names) != sorted(own):
        raise OptionError(
            f"start '{path}': its bodies ({len(found.body_names)}) are not those of this mechanism "
            f"({len(own)}): give a result of the same mechanism with the same parameters",
            code="start",
        )
    if not len(found):
        raise OptionError(f"start '{path}': has no frame to go on from: give another result", code="start")
    last = found.snapshot()
    if last.t >= t_end:
        raise OptionError(
            f"start '{path}': its last frame is at {last.t:g} s, the end of the run at {t_end:g} s: "
            "give a later --t-end",
            code="start",
        )
    return last
