"""What is not finite is traced to where it began; the run up to there is kept and can go on."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms


def two_rockets(broken_at: float, value: float = np.nan) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0))
    sound, broken = (
        model.body(name, mass=1.0, inertia=(1, 1, 1), position=(1.0, 0, 0)) for name in ("sound", "broken")
    )
    model.force(sound, force=(1.0, 0, 0), name="jet")
    model.force(broken, force=(lambda t: value if t > broken_at else 1.0, 0, 0), name="torn")
    return model


@pytest.mark.parametrize("integrator", ["rk4", "hem4", "dop853", "heun"])
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_force_that_is_not_finite_is_named_with_time_and_stage(integrator: str, value: float) -> None:
    """Broken from 0.5123 s on: the first stage beyond is in the step from 0.51 to 0.52 s."""
    with pytest.raises(lw.NotFiniteError, match="force 'torn'") as caught:
        lw.simulate(two_rockets(0.5123, value), 1.0, 1e-2, integrator, record_every=1, progress=False)
    error = caught.value
    assert error.forces == ["torn"]
    assert error.time is not None and 0.5123 < error.time <= 0.52 + 1e-12
    assert error.stage is not None and error.stage >= 2
    assert error.state is not None and error.state.t == pytest.approx(0.51)
    assert error.result is not None and error.result.t[-1] == pytest.approx(0.51)
    assert np.isfinite(error.result.q).all() and np.isfinite(error.result.acceleration).all()
    assert not error.result.finished


def test_rates_that_are_not_finite_are_none() -> None:
    system = lw.System(two_rockets(0.5, np.inf))
    y = system.initial_state()
    assert np.isfinite(system.derivative(0.4, y)).all()
    for call in (lambda: system.derivative(0.6, y), lambda: system.accelerations(0.6, y[:14], y[14:])):
        with pytest.raises(lw.NotFiniteError, match="force 'torn'"):
            call()


def test_a_run_goes_on_from_the_last_good_state() -> None:
    with pytest.raises(lw.NotFiniteError) as caught:
        lw.simulate(two_rockets(0.5123), 1.0, 1e-2, progress=False)
    whole = lw.simulate(two_rockets(10.0), 1.0, 1e-2, progress=False)
    rest = lw.simulate(two_rockets(10.0), 1.0, 1e-2, start=caught.value.state, progress=False)
    assert rest.t[0] == caught.value.state.t
    assert np.abs(rest.q[-1] - whole.q[-1]).max() <= 1e-13


@pytest.mark.parametrize("choice", [{"step": 1e-3}, {"rtol": 1e-10}])
def test_a_run_in_two_parts_is_the_run_in_one(choice: dict[str, Any]) -> None:
    model = mechanisms.bricard()
    whole = lw.simulate(model, 1.0, progress=False, **choice)
    first = lw.simulate(model, 0.5, progress=False, **choice)
    second = lw.simulate(model, 1.0, start=first.snapshot(), progress=False, **choice)
    assert second.t[0] == 0.5 and second.t[-1] == 1.0
    assert np.abs(second.q[-1] - whole.q[-1]).max() <= 1e-8


def test_what_was_written_before_the_failure_stays(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    with pytest.raises(lw.NotFiniteError) as caught:
        lw.simulate(two_rockets(0.5123), 1.0, 1e-2, record_every=1, output=path, progress=False)
    stored = lw.Result.load(path)
    assert caught.value.result is not None
    assert np.array_equal(stored.q, caught.value.result.q)
    assert len(stored) == 52 and np.isfinite(stored.v).all()


def test_a_diverging_body_is_named() -> None:
    with pytest.raises(lw.NotFiniteError, match="'top'") as caught:
        lw.simulate(mechanisms.heavy_top(), 100.0, 0.5, "euler", stabilization="none", progress=False)
    assert caught.value.state is not None and np.isfinite(caught.value.state.y).all()


def test_a_start_that_does_not_fit_is_refused() -> None:
    other = lw.simulate(mechanisms.pendulum(), 0.1, 1e-2, progress=False).snapshot()
    with pytest.raises(lw.OptionError, match="start"):
        lw.simulate(mechanisms.bricard(), 1.0, 1e-2, start=other, progress=False)
    with pytest.raises(lw.OptionError, match="start"):
        lw.simulate(mechanisms.pendulum(), 0.05, 1e-2, start=other, progress=False)
