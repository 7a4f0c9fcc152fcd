"""violation_limit and on_violation: what drifts too far is recorded, projected, or ends the run."""

from __future__ import annotations

from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import mechanisms

LIMITS = {"position": 1e-7, "velocity": 1e-6}


def drifting(**options: Any) -> lw.Result:
    """Without stabilization violations grow."""
    return lw.simulate(
        mechanisms.spatial_slider_crank(), 3.0, 5e-3, stabilization="none", record_every=1, progress=False,
        on_inaccurate="pass", **options,
    )  # fmt: skip


def test_a_limit_that_is_passed_is_recorded_with_time_and_joint_and_changes_nothing() -> None:
    free, limited = drifting(), drifting(violation_limit=LIMITS)
    assert np.array_equal(free.q, limited.q)
    for place, (level, limit) in enumerate(LIMITS.items()):
        beyond = free.violation[:, place] > limit
        assert beyond.any()
        rising = np.flatnonzero(beyond & ~np.concatenate([[False], beyond[:-1]]))
        found = [it for it in limited.violations if it.level == level]
        assert [it.t for it in found] == pytest.approx(free.t[rising].tolist(), abs=1e-12)
        assert max(it.largest for it in found) == pytest.approx(free.violation[:, place].max(), rel=1e-12)
        assert all(it.joint in free.joint_names for it in found)
    assert "passed" in limited.summary()
    assert free.violations == ()


@pytest.mark.parametrize("choice", [{"step": 5e-3}, {"rtol": 1e-4, "record_every": 1}])
def test_projection_beyond_the_limit_holds_it_with_few_projections(choice: dict[str, Any]) -> None:
    result = lw.simulate(
        mechanisms.spatial_slider_crank(), 3.0, stabilization="none", progress=False, on_inaccurate="pass",
        violation_limit=LIMITS, on_violation="project", **choice,
    )  # fmt: skip
    assert result.violation[:, 0].max() <= LIMITS["position"]
    assert result.violation[:, 1].max() <= LIMITS["velocity"]
    assert 0 < result.statistics["projections"] < result.statistics["steps"]


def test_a_run_that_is_to_stop_beyond_the_limit_names_joint_level_and_time() -> None:
    began = drifting(violation_limit=LIMITS).violations[0]
    with pytest.raises(lw.ViolationError, match=f"violated in {began.level} .*limit") as caught:
        drifting(violation_limit=LIMITS, on_violation="stop")
    assert caught.value.time == pytest.approx(began.t)
    assert caught.value.joints
    assert caught.value.result is not None and caught.value.result.t[-1] < began.t


def test_accelerations_have_a_limit_too() -> None:
    quiet = drifting(violation_limit={"acceleration": 1e-6})
    assert quiet.violations == ()
    assert drifting(violation_limit={"acceleration": 1e-18}).violations[0].level == "acceleration"


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"violation_limit": -1.0}, "positive"),
        ({"violation_limit": {"positions": 1.0}}, "'position'"),
        ({"violation_limit": 1e-6, "on_violation": "projct"}, "'project'"),
        ({"on_violation": "stop"}, "needs a violation_limit"),
        ({"violation_limit": {"acceleration": 1e-6}, "on_violation": "project"}, "accelerations alone"),
    ],
)
def test_what_makes_no_sense_is_refused(options: dict[str, Any], message: str) -> None:
    with pytest.raises(lw.OptionError, match=message):
        drifting(**options)
