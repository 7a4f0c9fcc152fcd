"""Other models from a model: without some of its objects, or with other values of one.

The model itself stays as it is, and so do the handles that it gave: a changed model is a new one, made from
the record that a file of the model would have. Functions of Python, which no file can hold, go with it.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwork.errors import ModelError, ModelFileError, nearest, warn
from linkwork.functions import TimeFunction, as_time_function
from linkwork.modeling.coordinates import known_coordinates
from linkwork.modeling.elements import KINDS, Role
from linkwork.modeling.files import from_changed_record, whole_record
from linkwork.modeling.files.writing import function_record, is_data
from linkwork.modeling.handles import Body, Force, Joint
from linkwork.modeling.moving import ATTACHED, moved

if TYPE_CHECKING:
    from linkwork.modeling.model import Model

__all__ = ["built", "driven", "follow_all", "replaced", "values", "without"]

#: How many names a message lists.
LISTED = 5

#: Where forces of the user's own are in a record.
OWN = "user_forces"

#: Sections of a record that have objects with names, and what one is called.
SECTIONS = {
    "bodies": "body", "joints": "joint", "forces": "force element", OWN: "force of the user's own"
}  # fmt: skip

ROLES: Mapping[str, Role] = {"joints": "joint", "forces": "force"}

#: Fields that are names.
NAMES = ("name", "kind", "a", "b", "body", "joint", "bodies", "coordinate")

#: What of a body changes without a jump of its pose.
SMOOTH = ("mass", "inertia", "velocity", "omega")

Record = dict[str, Any]

#: Functions of time that are no data, by the names that a record has for them.
Functions = dict[str, TimeFunction]


def values(model: Model, name: str | Body | Joint | Force) -> Record:
    """As `Model.values`."""
    record, held = whole_record(model)
    section, place = _found(model, record, name)
    found: Record = record[section][place]
    functions = {**record.get("functions", {}), **held}
    return {
        what: functions.get(x, x) if isinstance(x, str) and what not in NAMES else x
        for what, x in found.items()
    }


def without(model: Model, names: Sequence[str | Body | Joint | Force], attached: bool) -> Model:
    """As `Model.without`."""
    record, held = whole_record(model)
    gone = {_found(model, record, name) for name in names}
    while more := {it: why for it, why in _hanging(record, gone) if it not in gone}:
        if not attached:
            _refuse(model, record, more)
        gone |= set(more)
    _check_numbers(model, record, gone)
    for section in SECTIONS:
        kept = [it for place, it in enumerate(record.get(section, [])) if (section, place) not in gone]
        record[section] = kept
    bodies = {it["name"] for it in record["bodies"]}
    shapes = [{**it, "bodies": [body for body in it["bodies"] if body == "ground" or body in bodies]}
              for it in record.get("shapes", [])]  # fmt: skip
    record["shapes"] = [it for it in shapes if it["bodies"]]
    return _begun_anew(model, record, held)


def replaced(model: Model, name: str | Body | Joint | Force, changes: Mapping[str, Any]) -> Model:
    """As `Model.replaced`."""
    record, held = whole_record(model)
    section, place = _found(model, record, name)
    old = record[section][place]
    if section == OWN:
        return _with_own(model, record, held, place, changes)
    parameters = KINDS[ROLES[section]][old["kind"]].parameters if section in ROLES else SMOOTH
    before, axes = _where(old), ("a", "b") if old.get("kind") == "applied" else ()
    names = [what for what in NAMES if what in old and what not in axes]
    elsewhere = changes.keys() - {*names, ATTACHED, *parameters}  # what says where it is
    drivers = driven(record, [place]) if section == "joints" else {}
    if elsewhere and "kind" in changes:
        old = {what: x for what, x in old.items() if what != ATTACHED}
    elif elsewhere and ATTACHED in old and ATTACHED not in changes:
        changes = moved(model, ROLES[section], old, changes)
    record[section][place] = {**old, **{what: _plain(x, what, held) for what, x in changes.items()}}
    if changes.get("name", old["name"]) != old["name"]:
        _rename(record, section, old["name"], changes["name"])
    if drivers and (elsewhere or changes.keys() & {"a", "b", ATTACHED}):
        follow(record, _attached(model, record, held, place), drivers)
    moves = elsewhere and (ATTACHED not in old or before != _where(record[section][place]))
    anew = moves or "kind" in changes
    return _begun_anew(model, record, held) if anew else built(model, record, held)


def _with_own(model: Model, record: Record, held: Functions, place: int, changes: Mapping[str, Any]) -> Model:
    """Another force of the user's own in place of one. ModelError: a field that it has not."""
    old = record[OWN][place]
    for what in changes:
        if what not in old or what == "kind":
            known = [field for field in old if field != "kind"]
            raise ModelError(
                f"{old['kind']} '{old['name']}': has no field '{what}'{nearest(what, known)}", code="field"
            )
    plain = {what: x if what == "function" else _plain(x, what, held) for what, x in changes.items()}
    record[OWN][place] = {**old, **plain}
    return built(model, record, held)


def driven(record: Record, leaving: Collection[int]) -> dict[int, list[int]]:
    """Places of the drivers of coordinates that only the joints at those places have, of the same bodies,
    point and axes; with each these joints."""
    joints = record.get("joints", [])
    owners: dict[str, list[int]] = {}
    for place, it in enumerate(joints):
        if not it["kind"].endswith("_driver"):
            owners.setdefault(_where(it), []).append(place)
    found = {}
    for place, it in enumerate(joints):
        if not it["kind"].endswith("_driver"):
            continue
        own = [k for k in owners.get(_where(it), ()) if it["kind"] in _drivers_of(joints[k]["kind"])]
        if own and all(k in leaving for k in own):
            found[place] = own
    return found


def _drivers_of(kind: str) -> list[str]:
    return [f"{coordinate}_driver" for coordinate in known_coordinates(kind)]


def _where(it: Record) -> str:
    return repr((it.get("a"), it.get("b"), it.get(ATTACHED)))


def follow(record: Record, joint: Record, drivers: Collection[int]) -> None:
    """The drivers of a joint go to where it is now."""
    for place in drivers:
        record["joints"][place] = {
            **record["joints"][place], **{what: joint[what] for what in ("a", "b", ATTACHED)}
        }  # fmt: skip


def follow_all(record: Record, drivers: Mapping[int, Sequence[int]]) -> None:
    """Each driver goes to where its joints are now. ModelError: they are not in one place any more."""
    for place, own in drivers.items():
        joints = [record["joints"][k] for k in own]
        if len({_where(it) for it in joints}) > 1:
            names = " and ".join(f"'{it['name']}'" for it in joints)
            driver = record["joints"][place]
            raise ModelError(
                f"{driver['kind']} '{driver['name']}': drives a coordinate of {names}, which go to different "
                "places: move it, too",
                code="attached",
            )
        follow(record, joints[0], [place])


def _attached(model: Model, record: Record, held: Functions, place: int) -> Record:
    """A joint in its bodies, wherever the record says that it is."""
    parts = {what: record[what] for what in ("linkwork", "gravity", "functions", "bodies") if what in record}
    alone, _ = whole_record(built(model, {**parts, "joints": [record["joints"][place]]}, held))
    found: Record = alone["joints"][0]
    return found


def _check_numbers(model: Model, record: Record, gone: set[tuple[str, int]]) -> None:
    """ModelError: a law of the user's own that stays counts the bodies, of which some go."""
    if not any(section == "bodies" for section, _ in gone):
        return
    for place, it in enumerate(model._user_forces):
        if it.counts_bodies and (OWN, place) not in gone:
            raise ModelError(
                f"model '{model.name}': '{it.name}' gets all bodies by number, and these would change: name "
                "it, too, and add it to the new model",
                code="attached",
            )


def _begun_anew(model: Model, record: Record, held: Functions) -> Model:
    """With history variables of its own. LinkworkWarning: those of the model had something to tell."""
    history = record.pop("history", [])
    if history:
        begun, functions = whole_record(model)
        del begun["history"]
        if built(model, begun, functions).compiled().initial_history != history:
            warn(f"model '{model.name}': full turns and contacts under way begin anew in the changed model")
    return built(model, record, held)


def _plain(value: Any, what: str, held: Functions) -> Any:
    """As a file has it; what no file can is `held`, by a name."""
    if callable(value) or (isinstance(value, tuple) and value and all(map(callable, value))):
        value = as_time_function(value, what)
    if isinstance(value, TimeFunction):
        if is_data(value):
            return function_record(value, what)
        name = f"new Python function {len(held)}"
        held[name] = value
        return name
    if isinstance(value, Body | Joint):
        return value.name
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    return [_plain(part, what, held) for part in value] if isinstance(value, tuple | list) else value


def _found(model: Model, record: Record, name: object) -> tuple[str, int]:
    """Section and place of the object with a name. ModelError: there is none, or several."""
    text = name.name if isinstance(name, Body | Joint | Force) else name
    if not isinstance(text, str):
        raise ModelError(f"{text!r:.80} is no name of a body, joint or force", code="unknown_name")
    if isinstance(name, Body) and name.model is not model:
        raise ModelError(f"body '{text}' belongs to another model", code="unknown_body")
    wanted = {Body: "bodies", Joint: "joints", Force: "forces"}.get(type(name))
    places = [
        (section, place)
        for section in ([wanted] if wanted else SECTIONS)
        for place, it in enumerate(record.get(section, []))
        if it["name"] == text
    ]
    if len(places) == 1:
        return places[0]
    if places:
        kinds = " and ".join(f"a {SECTIONS[section]}" for section, _ in places)
        raise ModelError(f"model '{model.name}': '{text}' is {kinds}: give its handle", code="several")
    known = [it["name"] for section in SECTIONS for it in record.get(section, [])[:10_000]]
    raise ModelError(
        f"model '{model.name}': nothing is named {text!r:.80}{nearest(str(text), known)}", code="unknown_name"
    )


def _hanging(record: Record, gone: set[tuple[str, int]]) -> Iterator[tuple[tuple[str, int], str]]:
    """Joints and forces that need what is gone, each with its name."""
    bodies = {record["bodies"][place]["name"] for section, place in gone if section == "bodies"}
    joints = {record["joints"][place]["name"] for section, place in gone if section == "joints"}
    drivers = driven(record, {place for section, place in gone if section == "joints"})
    for section in ("joints", "forces", OWN):
        for place, it in enumerate(record.get(section, [])):
            named = {term["joint"] for term in it.get("coordinates", ())} | {it.get("joint")}
            on = {it.get("a"), it.get("b"), it.get("body"), *np.atleast_1d(it.get("bodies") or [])}
            if bodies & on or joints & named or (section == "joints" and place in drivers):
                yield (section, place), it["name"]


def _refuse(model: Model, record: Record, hanging: Mapping[tuple[str, int], str]) -> None:
    """ModelError: what is to go is held by something that stays."""
    names = [f"'{name}'" for name in hanging.values()]
    more = f" and {len(names) - LISTED} more" if len(names) > LISTED else ""
    raise ModelError(
        f"model '{model.name}': {', '.join(names[:LISTED])}{more} would hang on nothing: name "
        "them, too, or say attached=True",
        code="attached",
    )


def _rename(record: Record, section: str, old: str, new: str) -> None:
    """In everything that names it."""
    fields = ("a", "b", "body") if section == "bodies" else ("joint",) if section == "joints" else ()
    for it in (it for part in ("joints", "forces", OWN) for it in record.get(part, [])):
        it.update({what: new for what in fields if it.get(what) == old})
        for term in it.get("coordinates", ()) if section == "joints" else ():
            term["joint"] = new if term["joint"] == old else term["joint"]
    if section == "bodies":
        for it in (it for part in ("shapes", OWN) for it in record.get(part, []) if it.get("bodies")):
            if isinstance(it["bodies"], str):
                it["bodies"] = new if it["bodies"] == old else it["bodies"]
                continue
            it["bodies"] = [new if body == old else body for body in it["bodies"]]


def built(model: Model, record: Record, held: Mapping[str, TimeFunction] = MappingProxyType({})) -> Model:
    """A model from a record that was changed, and the functions that it names.

    ModelError: a value that its object cannot have, or a field that it has not.
    """
    try:
        made = from_changed_record(record, type(model), held)
    except ModelFileError as error:
        fault = error.faults[0]
        place = re.match(r"(\w+)\[(\d+)\]\.?(.*)", fault.field)
        if place is None or place[1] not in SECTIONS:
            raise ModelError(f"model '{model.name}': {fault}", code="value") from error
        who = f"{SECTIONS[place[1]]} '{record[place[1]][int(place[2])]['name']}'"
        what = f"{place[3]}: " if place[3] and not fault.message.startswith(place[3]) else ""
        raise ModelError(f"{who}: {what}{fault.message}", code="value", field=place[3]) from error
    vars(made).update(model._added())
    return made
