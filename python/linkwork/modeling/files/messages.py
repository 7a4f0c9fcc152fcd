"""What pydantic found, in words: where in the document, and what is wrong with what stands there."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from linkwork.errors import nearest
from linkwork.modeling.elements import KINDS
from linkwork.modeling.files import schema
from linkwork.modeling.files.syntax import Where
from linkwork.modeling.shapes import KINDS as SHAPES

#: Lists of so many entries, or of this field, may have more; all others have a length.
AT_LEAST = {1, "points"}


def faults_of_schema(error: ValidationError, data: Any) -> Iterator[tuple[Where, str]]:
    """(place, message) of every fault."""
    for details in error.errors(include_url=False, include_context=True):
        where = _where(details, data)
        message = _message(details, where, data)
        is_element = len(where) == 2 and str(where[0]).removesuffix("s") in KINDS
        if is_element and details["type"].startswith("union_tag") and isinstance(details["input"], dict):
            where = (*where, "kind")
        yield where, message


def _where(details: ErrorDetails, data: Any) -> tuple[str | int, ...]:
    """The place without the labels that pydantic adds for the forms of a union."""
    where: list[str | int] = []
    location = details["loc"]
    for depth, part in enumerate(location):
        last = depth == len(location) - 1
        is_entry = isinstance(data, list) and isinstance(part, int) and part < len(data)
        if is_entry or (isinstance(data, dict) and part in data):
            data = data[part]
        elif not (last and details["type"] == "missing"):
            continue
        where.append(part)
    return tuple(where)


def _message(details: ErrorDetails, where: Where, data: Any) -> str:
    kind, context, given = details["type"], details.get("ctx", {}), details["input"]
    if kind == "missing":
        return "is missing"
    if kind == "extra_forbidden":
        return f"is not known here{nearest(str(where[-1]), _known(where[:-1], data))}"
    if kind in ("union_tag_not_found", "union_tag_invalid"):
        return _unknown_form(where, given)
    if kind in ("too_short", "too_long"):
        least, most = context.get("min_length"), context.get("max_length")
        wanted = most or (f"{least} or more" if least in AT_LEAST or where[-1] in AT_LEAST else least)
        return f"has {context['actual_length']} entries, not {wanted}"
    if kind not in _WANTED:
        text = details["msg"]
        return text[:1].lower() + text[1:]
    hint = decimal_point(given) if kind == "float_type" else ""
    return f"{_shown(given)} is not {_WANTED[kind].format(**context)}{hint}"


def decimal_point(given: Any) -> str:
    """The end of a message about what is no number: "; decimals follow a point: 1.5" of "1,5"."""
    if isinstance(given, str) and re.fullmatch(r"[+-]?\d+,\d+([eE][+-]?\d+)?", given.strip()):
        return f"; decimals follow a point: {given.strip().replace(',', '.')}"
    return ""


_WANTED = {
    "float_type": "a number",
    "int_type": "a whole number",
    "bool_type": "true or false",
    "finite_number": "a finite number",
    "list_type": "a list",
    "dict_type": "a mapping",
    "model_type": "a mapping",
    "model_attributes_type": "a mapping",
    "string_type": "text",
    "literal_error": "{expected}",
    "greater_than": "above {gt:g}",
    "greater_than_equal": "{ge:g} or more",
    "string_too_short": "a name",
    "string_too_long": "text of at most {max_length} characters",
}


def _unknown_form(where: Where, given: Any) -> str:
    """Of an element or a function."""
    role = str(where[0]).removesuffix("s")
    if role == "shape":
        kind = _shown(given.get("kind")) if isinstance(given, dict) else _shown(given)
        return f"{kind} is no kind of shape; there are {', '.join(SHAPES)}"
    if len(where) != 2 or role not in KINDS:
        names = [str(it) for it in given] if isinstance(given, dict) else []
        what = _shown(names[0]) if len(names) == 1 else _shown(given)
        return f"{what} is no function of time{nearest(names[0] if names else '', schema.constructors())}"
    if not isinstance(given, dict):
        return f"{_shown(given)} is not a mapping"
    if "kind" not in given:
        return "is missing"
    kind = given["kind"]
    known_kinds = KINDS[role]  # type: ignore[index]
    return f"{_shown(kind)} is no kind of {role}{nearest(str(kind), known_kinds)}"


def _known(where: Where, data: Any) -> Sequence[str]:
    """The keys that a mapping at this place may have."""
    role = str(where[0]).removesuffix("s") if where else ""
    if not where:
        return list(schema.Document.model_fields)
    for part in where:
        data = data[part]
    if len(where) == 2 and role in KINDS:
        form = schema.form_of(data)
        if form is not None:
            return list(schema.element_type(role, *form).model_fields)
    if where[0] == "bodies" and len(where) == 2:
        return list(schema.BodyRecord.model_fields)
    if where[-1] == "attachment":
        return list(schema.AttachmentRecord.model_fields)
    return list(schema.argument_names(str(where[-1])))


def _shown(value: Any) -> str:
    """A value in a message: short."""
    if isinstance(value, dict):
        return "a mapping" if value else "an empty mapping"
    if isinstance(value, list):
        return "a list" if value else "an empty list"
    if value is None:
        return "nothing"
    text = (
        repr(value)
        if isinstance(value, str)
        else str(value).lower()
        if isinstance(value, bool)
        else str(value)
    )
    return text if len(text) <= 60 else f"{text[:57]}..."
