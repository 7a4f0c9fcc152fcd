"""What a run says of how it was made, and that it makes it again."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest


@pytest.mark.parametrize(
    "choices",
    [
        {"step": np.float32(1e-3), "record_every": np.int64(7), "stabilization": "baumgarte"},
        {"step": 1e-3, "integrator": lw.integrators.METHODS["heun"], "violation_limit": {"velocity": 1.0}},
        {"rtol": 1e-7, "breaks": (0.013, np.float64(0.021))},
        {"rtol": 1e-7, "integrator": "tsit5", "step": 0.01, "times": np.linspace(0, 0.05, 7)},
    ],
)
def test_what_a_file_says_was_given_makes_the_same_frames_again(
    choices: dict[str, Any], tmp_path: Path
) -> None:
    model, path = lw.mechanisms.spatial_slider_crank(), tmp_path / "run.h5"
    first = lw.simulate(model, 0.05, verify=True, **choices)
    first.save(path)
    for manifest in (first.manifest, lw.Result.load(path).manifest):
        again = lw.simulate(model, **manifest["options_given"])
        for name in ("t", "q", "v", "acceleration", "violation"):
            assert np.array_equal(getattr(again, name), getattr(first, name)), name
        assert again.manifest["options"] == first.manifest["options"]
        assert again.manifest["options_given"] == first.manifest["options_given"]


def test_a_motion_by_kinematics_says_what_was_given() -> None:
    model = lw.mechanisms.four_bar()
    model.drive("pin 0", velocity=1.0)
    first = lw.kinematics(model, np.linspace(0, 0.3, 4))
    again = lw.kinematics(model, **first.manifest["options_given"])
    assert np.array_equal(again.q, first.q) and np.array_equal(again.t, first.t)


def test_a_member_in_lanes_says_how_to_make_its_bits_alone() -> None:
    model = lw.mechanisms.spatial_slider_crank()
    for choices in ({"step": 1e-3}, {"rtol": 1e-6}):
        member = lw.simulate_many(model, {"crank.mass": [0.12, 0.24]}, 0.05, **choices).member(0)  # type: ignore[arg-type]
        assert member.manifest["lane"]
        assert np.array_equal(lw.simulate(model, **member.manifest["options_given"]).q, member.q)


def test_what_no_file_can_hold_is_never_taken_for_something_else() -> None:
    """Such as a function rk4 of the user's own for the method of that name."""

    def rk4(system: lw.System, t: float, y: Any, h: float) -> Any:
        return y + h * system.derivative(t, y)

    model = lw.mechanisms.pendulum()
    own = lw.simulate(model, 0.01, 1e-3, rk4, on_inaccurate="pass")
    stop = lw.Event(lambda t, state: t - 0.004, terminal=True, name="stop")
    ended = lw.simulate(model, 0.01, rtol=1e-6, events=stop)
    begun = lw.simulate(model, 0.02, 1e-3, start=lw.simulate(model, 0.01, 1e-3).snapshot(-1))
    for result, named in ((own, "rk4, a function"), (ended, "stop"), (begun, "the state at 0.01 s")):
        with pytest.raises(lw.OptionError, match=named):
            lw.simulate(model, **result.manifest["options_given"])
    again = lw.simulate(model, **{**ended.manifest["options_given"], "events": stop})
    assert np.array_equal(again.q, ended.q)
