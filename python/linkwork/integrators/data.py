"""The data of methods as they are given: what is no name, order or list of coefficients is refused."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from linkwork.arguments import is_number, is_text, whole
from linkwork.errors import OptionError

#: Of coefficients as tables have them, relative.
ROUNDING = 1e-9


def check_name(name: Any) -> None:
    """OptionError: it is no text."""
    if not is_text(name):
        raise OptionError(f"integrator: name {name!r:.80} is no text", code="tableau")


def check_numbers(name: str, **fields: Any) -> None:
    """OptionError: a field is no list of finite numbers."""
    for field, given in fields.items():
        _check_list(name, field, given)
        for value in given:
            if not is_number(value):
                raise OptionError(
                    f"integrator '{name}': {value!r:.80} in {field} is not a finite number", code="tableau"
                )


def check_rows(name: str, **fields: Any) -> None:
    """OptionError: a field is no list of lists of finite numbers."""
    for field, given in fields.items():
        _check_list(name, field, given)
        check_numbers(name, **{f"{field}[{row}]": numbers for row, numbers in enumerate(given)})


def check_nodes(name: str, A: Sequence[Sequence[float]], c: Sequence[float], lead: str = "") -> None:
    """OptionError: a stage is at another time than its state is.

    c_i = sum_j A_ij: else functions of time are read at other times than the motion, with the order of no
    tableau but on autonomous systems.
    """
    for i, (row, node) in enumerate(zip(A, c, strict=True)):
        total = math.fsum(row)
        if abs(total - node) > ROUNDING * max(1.0, *(abs(part) for part in (node, *row))):
            raise OptionError(
                f"integrator '{name}': {lead}c[{i}] is {float(node):.9g}, but the numbers in row {i} of "
                f"{lead}A add up to {total:.9g}: these must be the same",
                code="tableau",
            )


def check_order(name: str, most: int, **fields: Any) -> None:
    """OptionError: an order is no whole number from 1 to `most`, the highest with so many coefficients."""
    for field, given in fields.items():
        order = whole(given, 1, f"integrator '{name}': {field}")
        if order > most:
            raise OptionError(
                f"integrator '{name}': {field} {order} is above {most}, the highest of so few coefficients",
                code="tableau",
            )


def keep(method: Any, *names: str) -> None:
    """Tuples for lists of the caller's, who may change them: the method would be another, unchecked."""
    for name in names:
        rows = (it if is_number(it) else tuple(it) for it in getattr(method, name))
        object.__setattr__(method, name, tuple(rows))


def _check_list(name: str, field: str, given: Any) -> None:
    several = isinstance(given, Sequence) or (isinstance(given, np.ndarray) and given.ndim > 0)
    if not several or isinstance(given, str | bytes):
        raise OptionError(f"integrator '{name}': {field} {given!r:.80} is no list", code="tableau")
