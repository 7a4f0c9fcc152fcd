"""Functions of Python that apply forces to members of an ensemble: lane by lane, or to all at once."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from ensembles import alone, bits
from linkwork import mechanisms
from linkwork.studies.variants import Changed

pytestmark = pytest.mark.filterwarnings("ignore")

STEPS = pytest.mark.parametrize("steps", [{"step": 1e-3}, {"rtol": 1e-6}])


def drag(v: Any) -> Any:
    """Of each element of v (..., 6) by itself."""
    return -0.3 * np.abs(v) * v * np.array([1.0, 1.0, 1.0, 0.01, 0.01, 0.01])


def wind(t: Any, q: Any, v: Any) -> Any:
    return drag(v) + np.sin(3.0 * np.asarray(t))[..., None, None] * [0.2, 0.0, 0.1, 0.0, 0.0, 0.0]


def bricard(pull: float, force: Callable[..., Any] = wind, **options: Any) -> lw.Model:
    """In so many times the gravity of the earth."""
    model = Changed.of(mechanisms.bricard(), ["gravity"]).model({"gravity": [0.0, -9.81 * pull, 0.0]})
    model.user_force(force, **{"vectorized": True, "name": "wind", **options})
    return model


def many(models: list[lw.Model], t_end: float = 0.1, **options: Any) -> lw.EnsembleResult:
    return lw.simulate_many(models, None, t_end, **{"progress": False, **options})


@STEPS
def test_a_force_on_all_lanes_at_once_is_that_on_each(steps: dict[str, float]) -> None:
    pulls = np.linspace(0.5, 1.5, 11)
    found = many([bricard(it) for it in pulls], **steps)
    plain = many([bricard(it, vectorized=False) for it in pulls], **steps)
    assert found.alone == {} and plain.alone == {}
    for k in (0, 5, 10):
        single = alone(bricard(pulls[k]), 0.1, **steps)
        assert bits(found.member(k)) == bits(single) == bits(plain.member(k))
        assert single.verdict is not None and found.accuracy[k] == single.verdict.error
    assert not np.array_equal(found.member(0).q, alone(bricard(0.5, lambda t, q, v: 0.0 * v), 0.1, **steps).q)


def test_it_is_asked_once_for_all_lanes() -> None:
    sizes: list[int] = []
    same: list[bool] = []

    def counted(t: Any, q: Any, v: Any) -> Any:
        sizes.append(len(t))
        same.append(np.shape(t) == q.shape[:1] == v.shape[:1])
        return wind(t, q, v)

    models = [bricard(0.5 + 0.1 * k, counted) for k in range(8)]
    found = lw.simulate_many(models, None, 0.05, 1e-3, outputs=["final"], on_singular="pass", progress=False)
    assert found.alone == {}
    assert all(same)
    assert max(sizes) == lw._core.lane_count()
    lanes = lw._core.lane_count()
    assert sum(size for size in sizes if size == lanes) >= 8 * 200  # of 50 steps of four stages


def test_bodies_methods_and_several_forces() -> None:
    class Field:
        strength = 0.4

        def one(self, t: Any, q: Any, v: Any) -> Any:
            assert q.shape[1:] == (7,) and v.shape == (len(t), 6)
            return self.strength * drag(v)

        def two(self, t: Any, q: Any, v: Any) -> Any:
            assert q.shape[1:] == (2, 7)
            return self.strength * drag(v)

    field = Field()

    def build(k: int) -> lw.Model:
        model = bricard(0.5 + 0.1 * k)
        body = [model.find(f"rod {b}") for b in (1, 2, 4)]
        model.user_force(field.one, body[0], vectorized=True)
        if k % 2:
            model.user_force(field.two, [body[2], body[1]], vectorized=True)
        model.user_force(lambda t, q, v: (1.0 + k) * drag(v), body[2])
        return model

    found = many([build(k) for k in range(9)], step=1e-3)
    assert found.alone == {}
    for k in (0, 1, 8):
        assert bits(found.member(k)) == bits(alone(build(k), 0.1, 1e-3))


@STEPS
def test_a_force_that_depends_on_the_others_is_taken_by_itself(steps: dict[str, float]) -> None:
    """It would make motions that depend on who runs beside whom."""
    mixed = lambda t, q, v: drag(v) * (1.0 + 1e-12 * len(t))  # noqa: E731
    models = [bricard(0.5 + 0.1 * k, mixed) for k in range(8)]
    found = many(models, 0.02, **steps)
    assert set(found.alone) == set(range(8)) and "'wind'" in found.alone[0]
    assert bits(found.member(3)) == bits(alone(models[3], 0.02, **steps))


@STEPS
def test_a_force_that_mixes_late_and_for_a_while_only_is_taken_by_itself(steps: dict[str, float]) -> None:
    """By all members, also by those that ended before it did."""

    def gust(t: Any, q: Any, v: Any) -> Any:
        force = np.zeros_like(v)
        share = np.where((t > 0.066) & (t < 0.1), 1.0, 0.0)[:, None]
        force[..., 0] = -3.0 * share * v[..., 0] * np.abs(v[..., 0]).mean()
        return force

    pulls = np.linspace(0.5, 1.5, 19)
    found = many([bricard(it, gust) for it in pulls], 0.11, threads=1, **steps)
    assert set(found.alone) == set(range(19)) and "beside" in found.alone[0]
    for k in (0, 9, 18):
        assert bits(found.member(k)) == bits(alone(bricard(pulls[k], gust), 0.11, **steps))


@STEPS
def test_a_force_that_fails_for_one_disturbs_no_other(steps: dict[str, float]) -> None:
    def burst(t: Any, q: Any, v: Any) -> Any:
        if np.abs(v).max() > 1.0:
            raise ValueError("too fast")
        return drag(v)

    models = [bricard(it, burst) for it in (0.1, 0.2, 20.0, 0.3)]
    found = many(models, **steps)
    assert found.status.tolist() == ["finished", "finished", "failed", "finished"]
    assert "too fast" in found.errors[2]["message"]
    for k in (0, 1, 3):
        assert k not in found.alone
        assert bits(found.member(k)) == bits(alone(models[k], 0.1, **steps))


@pytest.mark.parametrize(
    ("force", "said"),
    [
        (lambda t, q, v: v[0], r"wind.*\(5, 6\).*\(1, 5, 6\)"),
        (lambda t, q, v: None, r"wind.*None.*\(k, n, 6\)"),
        (lambda t, q, v: "much", "wind"),
    ],
)
def test_what_is_no_force_of_all_is_refused_by_name(force: Any, said: str) -> None:
    with pytest.raises(lw.ModelError, match=said):
        alone(bricard(1.0, force), 0.01, 1e-3)
    found = many([bricard(1.0, force), mechanisms.bricard()], 0.01, step=1e-3)
    assert found.status.tolist() == ["failed", "finished"]


def test_vectorized_is_true_or_false() -> None:
    with pytest.raises(lw.ModelError, match="vectorized is 1"):
        bricard(1.0, vectorized=1)
