"""Adams methods as data: they remember f of past steps and start with a Runge-Kutta method."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from linkwork import _core
from linkwork.errors import OptionError
from linkwork.integrators.data import check_name, check_numbers, check_order, keep
from linkwork.integrators.growth import added_growth, damped_roots
from linkwork.integrators.order_conditions import check_multistep
from linkwork.integrators.runge_kutta import ButcherTableau


@dataclass(frozen=True)
class AdamsBashforth:
    """Explicit: y_next = y + h sum_j predictor_j f_{n-j}, the newest f first.

    OptionError: what is no number or no starter, an order that the coefficients do not have.
    """

    name: str
    order: int
    reference: str
    predictor: Sequence[float]
    starter: ButcherTableau

    def __post_init__(self) -> None:
        _check(self, predictor=self.predictor)
        check_multistep(self.name, "predictor", self.predictor, 0, self.order)

    def compiled(self) -> _core.Multistep:
        """The same method in the compiled module."""
        nothing = np.zeros(0)
        return _core.Multistep(
            self.name, self.order, np.array(self.predictor, float), nothing, self.starter.compiled()
        )

    def growth(self, alpha_h: float, beta_h: float) -> float:
        """As `ButcherTableau.growth`: the largest root of zeta^k - zeta^(k-1) - z sum_j b_j zeta^(k-1-j)."""
        return _largest_root([-z * np.array(self.predictor) for z in damped_roots(alpha_h, beta_h)])

    def sampled_growth(self, alpha_h: float, beta_h: float) -> float:
        """As `ButcherTableau.sampled_growth`."""
        return added_growth(alpha_h, beta_h)


@dataclass(frozen=True)
class AdamsBashforthMoulton:
    """Predict, evaluate, correct, evaluate (PECE):

    p = y + h sum_j predictor_j f_{n-j},   y_next = y + h (corrector_0 f(p) + sum_j corrector_{j+1} f_{n-j})

    OptionError: as for `AdamsBashforth`.
    """

    name: str
    order: int
    reference: str
    predictor: Sequence[float]
    corrector: Sequence[float]
    starter: ButcherTableau

    def __post_init__(self) -> None:
        _check(self, predictor=self.predictor, corrector=self.corrector)
        check_multistep(self.name, "predictor", self.predictor, 0, self.order - 1)
        check_multistep(self.name, "corrector", self.corrector, 1, self.order)

    def compiled(self) -> _core.Multistep:
        """The same method in the compiled module."""
        predictor, corrector = np.array(self.predictor, float), np.array(self.corrector, float)
        return _core.Multistep(self.name, self.order, predictor, corrector, self.starter.compiled())

    def growth(self, alpha_h: float, beta_h: float) -> float:
        """As `ButcherTableau.growth`, with the predicted value inserted into the corrector."""
        return _largest_root([self._past(z) for z in damped_roots(alpha_h, beta_h)])

    def sampled_growth(self, alpha_h: float, beta_h: float) -> float:
        """As `ButcherTableau.sampled_growth`."""
        return added_growth(alpha_h, beta_h)

    def _past(self, z: complex) -> np.ndarray[tuple[int], np.dtype[np.complex128]]:
        """-a_j in y_next = y + sum_j a_j y_{n-j} for f = z y / h."""
        predicted = z * np.array(self.predictor, complex)
        predicted[0] += 1
        past = np.zeros(max(len(predicted), len(self.corrector) - 1), complex)
        past[: len(predicted)] = self.corrector[0] * predicted
        past[: len(self.corrector) - 1] += self.corrector[1:]
        return -z * past


def _check(method: AdamsBashforth | AdamsBashforthMoulton, **coefficients: Sequence[float]) -> None:
    check_name(method.name)
    check_numbers(method.name, **coefficients)
    check_order(method.name, max(map(len, coefficients.values())), order=method.order)
    if not isinstance(method.starter, ButcherTableau):
        raise OptionError(
            f"integrator '{method.name}': starter {method.starter!r:.80} is no ButcherTableau", code="tableau"
        )
    for field, given in coefficients.items():
        if not len(given):
            raise OptionError(f"integrator '{method.name}': {field} is empty", code="tableau")
    keep(method, *coefficients)


def _largest_root(past: Sequence[np.ndarray[tuple[int], np.dtype[np.complex128]]]) -> float:
    """Of the polynomials zeta^k - zeta^(k-1) + past_0 zeta^(k-1) + past_1 zeta^(k-2) + ..."""
    roots = [np.roots([1, past_z[0] - 1, *past_z[1:]]) for past_z in past]
    return float(np.max(np.abs(np.concatenate(roots))))
