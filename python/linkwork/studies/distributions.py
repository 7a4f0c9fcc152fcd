"""What a sampler draws from: bounds, and distributions of scipy.stats, of its former and its newer kind."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwork.arguments import is_number
from linkwork.arrays import Floats
from linkwork.errors import OptionError
from linkwork.fingerprints import digest, plain

__all__ = ["is_distribution", "quantile", "words"]

#: What is wanted, as messages say it.
WANTED = "pair (low, high) and no distribution of scipy.stats, such as norm(loc=1.0, scale=0.01)"

#: Whole numbers below are exact.
LARGEST = 2.0**53

#: Characters of an array or an object in words.
LONG = 4000


def is_distribution(given: Any) -> bool:
    """Something with quantiles, `ppf`, or `icdf` of the newer ones of SciPy, even if it lacks its numbers."""
    return any(callable(getattr(given, name, None)) for name in ("ppf", "icdf"))


def quantile(name: str, given: Any) -> Callable[[Floats], NDArray[Any]]:
    """From the unit interval to values. OptionError: neither bounds nor a distribution."""
    if is_distribution(given):
        return _of_distribution(name, given)
    bounds = given.tolist() if isinstance(given, np.ndarray) else given
    if not (isinstance(bounds, tuple | list) and len(bounds) == 2 and all(map(is_number, bounds))):
        raise OptionError(
            f"parameter '{name}': {given!r:.60} is no {WANTED}, which a sampler needs", code="parameters"
        )
    low, high = map(float, bounds)
    if not low < high:
        what = f"reversed: give ({high:g}, {low:g})" if low > high else "equal: there is nothing between them"
        raise OptionError(f"parameter '{name}': its bounds ({low:g}, {high:g}) are {what}", code="parameters")
    return lambda u: low + (high - low) * u


def _of_distribution(name: str, given: Any) -> Callable[[Floats], NDArray[Any]]:
    """OptionError: it has no numbers yet, wrong ones, or several."""
    inverse = given.ppf if callable(getattr(given, "ppf", None)) else given.icdf
    family = str(getattr(given, "name", getattr(given, "__name__", type(given).__name__)))
    if isinstance(given, type) or _is_family(given):
        raise OptionError(
            f"parameter '{name}': {family} is a distribution without its numbers: give them, as in "
            f"{'Normal(mu=1.0, sigma=0.01)' if isinstance(given, type) else 'norm(loc=1.0, scale=0.01)'}",
            code="parameters",
        )
    try:
        with np.errstate(all="ignore"):  # what is wrong is told below
            middle = np.asarray(inverse(0.5), dtype=float)
    except Exception as error:  # of the user's own, too
        raise OptionError(
            f"parameter '{name}': its distribution {family} has no quantiles ({error})", code="parameters"
        ) from error
    if middle.ndim > 0:
        raise OptionError(
            f"parameter '{name}': its distribution is of {middle.size} numbers: give each its own",
            code="parameters",
        )
    if not np.isfinite(middle):
        raise OptionError(f"parameter '{name}': its distribution is none: check its numbers",
                          code="parameters")  # fmt: skip
    whole = _is_whole(given, float(middle))
    return lambda u: _as_whole(inverse(u)) if whole else np.asarray(inverse(u), dtype=float)


def _is_whole(given: Any, middle: float) -> bool:
    """Whether it is discrete, and not of fractions: shifted by one, or of values of the user's own."""
    from scipy import stats

    dist = getattr(given, "dist", given)  # of a frozen one
    discrete = isinstance(dist, stats.rv_discrete) or any(
        kind.__name__ == "DiscreteDistribution" for kind in type(given).__mro__
    )
    values = np.asarray(getattr(dist, "xk", 0.0), dtype=float)
    return discrete and middle.is_integer() and bool((values == np.rint(values)).all())


def _as_whole(values: Any) -> NDArray[Any]:
    """As integers, but for those that are beyond."""
    found = np.asarray(values, dtype=float)
    return found.astype(int) if (np.abs(found) < LARGEST).all() else found


def _is_family(given: Any) -> bool:
    """Whether it is one of SciPy's that is yet to be called with its numbers, as stats.norm."""
    from scipy import stats

    former = isinstance(given, stats.rv_continuous | stats.rv_discrete)
    return former and getattr(stats, str(given.name), None) is given


def words(given: Any) -> str:
    """So that it can be written again: what a distribution is called with; else what it is, and a digest."""
    if not is_distribution(given):
        low, high = map(float, given)
        return f"({low!r}, {high!r})"
    if hasattr(given, "dist"):  # frozen
        numbers = [*map(_number, given.args), *(f"{name}={_number(it)}" for name, it in given.kwds.items())]
        return f"{given.dist.name}({', '.join(numbers)})"
    held = getattr(given, "_histogram", None)
    if held is not None:
        return f"rv_histogram({plain(held)!r:.{LONG}}, density={getattr(given, '_density', None)})"
    text = repr(given)
    return f"{type(given).__name__} {digest(given)}" if " at 0x" in text else text[:LONG]


def _number(value: Any) -> str:
    return repr(plain(np.asarray(value)))[:LONG]
