"""Order conditions: whether coefficients have the order that is declared, by which errors are estimated.

A Runge-Kutta method has order p where for each rooted tree t of at most p nodes (Hairer, Norsett and Wanner
I, theorem II.2.13)

    b^T Phi(t) = 1 / gamma(t),   Phi([t_1, ..., t_m]) = A Phi(t_1) * ... * A Phi(t_m),
    gamma([t_1, ..., t_m]) = |t| gamma(t_1) ... gamma(t_m),   |t| nodes,   Phi of one node 1, gamma 1.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator, Sequence

import numpy as np

from linkwork.arrays import Floats
from linkwork.errors import OptionError
from linkwork.integrators.data import ROUNDING

__all__ = ["check_dense_order", "check_error_order", "check_multistep", "check_runge_kutta"]

#: Subtrees of the root, in an order of their own.
Tree = tuple["Tree", ...]


@functools.cache
def trees(nodes: int) -> tuple[Tree, ...]:
    """All rooted trees of so many nodes."""
    return tuple(_forests(nodes - 1, nodes - 1, 0))


def _forests(nodes: int, largest: int, first: int) -> Iterator[Tree]:
    """Multisets of trees with so many nodes together, large ones first: none larger than `largest`, and of
    that size none before `first`."""
    if not nodes:
        yield ()
    for size in range(min(nodes, largest), 0, -1):
        known = trees(size)
        for place in range(first if size == largest else 0, len(known)):
            for rest in _forests(nodes - size, size, place):
                yield (known[place], *rest)


@functools.cache
def _nodes(tree: Tree) -> int:
    return 1 + sum(map(_nodes, tree))


@functools.cache
def density(tree: Tree) -> int:
    """gamma."""
    return _nodes(tree) * math.prod(map(density, tree))


def _weights(A: Floats, order: int) -> Iterator[tuple[int, float, Floats]]:
    """|t|, 1 / gamma(t) and Phi(t) (s,) of all trees of at most `order` nodes."""
    known: dict[Tree, Floats] = {}
    for nodes in range(1, order + 1):
        for tree in trees(nodes):
            parts = (A @ known[part] for part in tree)
            known[tree] = functools.reduce(np.multiply, parts, np.ones(len(A)))
            yield nodes, 1 / density(tree), known[tree]


def check_runge_kutta(name: str, A: Floats, b: Floats, order: int) -> None:
    """OptionError: coefficients A (s, s) and b (s,) of a lower order."""
    for nodes, wanted, Phi in _weights(A, order):
        _check(name, "order", order, nodes, b * Phi, wanted)


def check_error_order(name: str, A: Floats, error: Floats, order: int) -> None:
    """OptionError: an estimate h error^T k that is not of order h^(order + 1)."""
    for nodes, _, Phi in _weights(A, order):
        _check(name, "error_order", order, nodes, error * Phi, 0.0)


def check_dense_order(name: str, A: Floats, interpolant: Floats, order: int) -> None:
    """OptionError: weights sum_k interpolant_ik theta^(k+1) of a lower order somewhere in the step.

    They are to give theta^|t| / gamma(t).
    """
    powers = np.arange(1, interpolant.shape[1] + 1)
    for nodes, wanted, Phi in _weights(A, order):
        _check(name, "dense_order", order, nodes, interpolant.T * Phi, np.where(powers == nodes, wanted, 0.0))


def check_multistep(name: str, field: str, weights: Sequence[float], newest: int, order: int) -> None:
    """OptionError: weights of f at t + newest h, and a step before each, that integrate powers wrongly.

    sum_j weights_j x_j^(k-1) = 1 / k for k = 1, ..., order; x_j = newest - j.
    """
    places = newest - np.arange(len(weights), dtype=float)
    for k in range(1, order + 1):
        _check(name, f"order of {field}", order, k, np.asarray(weights, float) * places ** (k - 1), 1 / k)


def _check(name: str, what: str, order: int, nodes: int, terms: Floats, wanted: Floats | float) -> None:
    """Of one sum (s,), or of several (k, s)."""
    found, size = np.atleast_1d(terms.sum(axis=-1)), np.abs(terms).sum(axis=-1)
    wrong = np.abs(found - wanted) > ROUNDING * np.maximum(1.0, size)
    if wrong.any():
        k, right = int(np.argmax(wrong)), np.broadcast_to(wanted, found.shape)
        raise OptionError(
            f"integrator '{name}': the coefficients have {what} {nodes - 1}, not {order}: a condition of "
            f"order {nodes} gives {found[k]:.9g} instead of {right[k]:.9g}",
            code="tableau",
        )
