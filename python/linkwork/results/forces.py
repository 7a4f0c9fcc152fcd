"""What force elements do over time, from the states of a run and the laws of its model."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from linkwork import _core
from linkwork.arrays import Floats
from linkwork.errors import ModelError, OptionError, nearest, warn
from linkwork.modeling.coordinates import coordinates_of
from linkwork.modeling.elements import KINDS
from linkwork.motion.header import ForceElement
from linkwork.motion.records import ForceResult, rotate
from linkwork.results.joint_motion import ends_of

if TYPE_CHECKING:
    from linkwork.modeling.handles import Named
    from linkwork.modeling.model import Model
    from linkwork.results.result import Result

__all__ = ["clock", "force", "place"]


def force(result: Result, name: str | int, model: Model | None) -> ForceResult:
    """See Result.force."""
    if model is not None and not hasattr(model, "compiled"):
        raise ModelError(f"force: a linkwork.Model is wanted, not {model!r:.80}", code="not_a_model")
    which, law = place(result, name, model), _law(result, model)
    _warn_of_other_laws(result, which, model)
    k, n = len(result), result.header.body_count
    v, v_dot = result.v.reshape(k, 6 * n), result._field("vdot").reshape(k, 6 * n)
    state = result.q.reshape(k, 7 * n), v, v_dot
    on_force, torque, power, potential, turned = law(which, clock(result), *state, result.history)
    return ForceResult(on_force, torque, power, potential, _deflection(result, which, turned))


def _warn_of_other_laws(result: Result, which: int, model: Model | None) -> None:
    """LinkworkWarning: functions of an element do not say what they said in the run."""
    header, name = result.header, result.header.force_names[which]
    found = "" if header.unlike_run is None else header.unlike_run(which, model)
    if not found and name not in result._statistics.get("changed_laws", ()):
        return
    shown = f" ({found})" if found else ""
    warn(
        f"force of '{name}': its law is not everywhere what it was in the run{shown}, and frames have what "
        "it says now: set what it reads as it was then; what changes in a run, as by events, is lost, while "
        "accelerations, reactions, energies and work are those of the run"
    )


def clock(result: Result) -> Floats:
    """Where functions of time were evaluated for the frames (k,) [s]: of those at breaks just after them, as
    for what begins there, at the end of the run just before."""
    t_end = result.manifest.get("options", {}).get("t_end", np.inf)
    return _core.BreakPoints(list(result.header.breaks)).clock(result.t, t_end)


def place(result: Result, name: Named, model: Model | None = None) -> int:
    """Of a force element among those of the result. ModelError: none, or a law of the user's own."""
    names = list(result.header.force_names)
    if isinstance(name, int | np.integer) and -len(names) <= name < len(names):
        return int(name) % len(names)
    own = [*result.manifest.get("user_forces", ()), *(it for it, _ in (model.user_forces if model else ()))]
    if str(name) in own and str(name) not in names:
        raise ModelError(
            f"'{name}' is no force element but a law of the user's own (joint_force, user_force, "
            "compiled_force), of which nothing is recorded: call its function, that of a joint with t, value "
            "and rate of result.coordinate(joint), others with t, q and v of the result",
            code="unknown_name",
        )
    if str(name) not in names:
        raise ModelError(f"no force element named '{name}'{nearest(str(name), names)}", code="unknown_name")
    return names.index(str(name))


def _law(result: Result, model: Model | None) -> ForceElement:
    """OptionError: nobody knows the laws."""
    header = result.header
    if model is None and header.force_element is not None:
        return header.force_element
    if model is None:
        raise OptionError(
            "force: a result from a file has no laws of forces: give the model, result.force(name, model)",
            code="no_model",
        )
    _check_model(result, model)
    core = model.compiled()
    options = _core.Options()
    options.formulation = "augmented_lagrangian"  # takes redundant joints and massless bodies, too
    return _core.Dynamics(core, options).force_element


def _check_model(result: Result, model: Model) -> None:
    """OptionError: the laws of another model."""
    core, header = model.compiled(), result.header
    own = [core.force_name(k) for k in range(core.force_count)]
    if own != list(header.force_names) or core.body_count != header.body_count:
        raise OptionError(
            f"force: the model '{model.name}' has other force elements or bodies than this result",
            code="model",
        )
    recorded = result.manifest.get("model_hash")
    if recorded is not None and recorded != model.hash():
        raise OptionError(
            f"force: the model '{model.name}' is another model than that of this result: it has other "
            f"numbers, functions or another initial state (hash {model.hash():.8}, not {recorded!s:.8}); "
            "give the one that was simulated",
            code="model",
        )


def _deflection(result: Result, which: int, turned: Floats) -> Floats | None:
    """Of springs, beyond where they are free; None: of no spring, or that is a function of time. `turned`:
    the angle of a rotational one."""
    header = result.header
    names = list(KINDS["force"][header.force_kinds[which]].parameters)
    free = next((it for it in ("free_length", "free_angle", "free_displacement") if it in names), None)
    if free is None:
        return None
    rest = header.parameters("force", which)[names.index(free)]
    if np.isnan(rest):
        return None
    if free == "free_angle":
        return np.asarray(turned - rest)
    ends = next(ends_of(result, header.force_bodies[[which]]))
    origin, frame = header.force_origin[which], header.force_frame[which]
    if free == "free_displacement":
        shifted: Floats = coordinates_of("displacement", result.t, ends, origin, frame).value - rest
        return shifted
    a, b = (q[:, :3] + rotate(q[:, 3:], s) for (q, _), s in zip(ends, origin, strict=True))
    longer: Floats = np.linalg.norm(b - a, axis=1) - rest
    return longer
