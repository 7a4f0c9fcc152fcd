"""Reactions that a run writes to a file, by what its step has at hand, are those found anew, bit for bit."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from linkwork import mechanisms
from linkwork.integrators import METHODS
from random_mechanisms import Mechanism, examples
from random_mechanisms import mechanisms as mechanisms_of
from recorded import PAIRS

Z, Y = (0, 0, 1), (0, 1, 0)
STABILIZATIONS = ("none", "baumgarte", "sampled_baumgarte", "projection", "velocity_projection")


def assert_found_anew(output: Path, model: lw.Model, t_end: float, **choices: Any) -> lw.Result:
    """A run to a file, in which each frame is the one it is about; it has joints that hold something."""
    result = lw.simulate(model, t_end, output=output, overwrite=True, progress=False, on_inaccurate="pass",
                         **choices)  # fmt: skip
    compiled = lw.System(model).compiled()
    fields = [result.t, result.q.reshape(len(result.t), -1), result.recorded("lambda")]
    if len(compiled.initial_history):
        fields.append(result.recorded("history"))
    for name, anew in zip(("force", "torque"), compiled.reactions(*fields), strict=True):
        found = result.recorded(f"reaction_{name}")
        assert found.tobytes() == anew.tobytes(), (name, np.abs(found - anew).max())
    return result


@pytest.mark.parametrize("stabilization", STABILIZATIONS)
@pytest.mark.parametrize("choice", [{"step": 7e-3, "record_every": 3}, {"rtol": 1e-5, "record_every": 1},
                                    {"rtol": 1e-5, "times": [0.0, 0.1, 0.11, 0.3]}])  # fmt: skip
@pytest.mark.parametrize("name", ["four_bar", "bricard", "double_wishbone"])
def test_of_fixed_steps_and_of_those_that_follow_tolerances(
    name: str, choice: dict[str, Any], stabilization: str, tmp_path: Path
) -> None:
    model = getattr(mechanisms, name)()
    result = assert_found_anew(tmp_path / "run.h5", model, 0.3, stabilization=stabilization, **choice)
    assert np.abs(result.reactions().force).max() > 0


@pytest.mark.parametrize("integrator", list(METHODS))
@pytest.mark.parametrize("formulation", ["standard", "penalty", "augmented_lagrangian"])
def test_of_every_integrator_and_formulation(integrator: str, formulation: str, tmp_path: Path) -> None:
    assert_found_anew(tmp_path / "run.h5", mechanisms.four_bar(), 0.1, step=3e-3, integrator=integrator,
                      formulation=formulation, record_every=1)  # fmt: skip


def heun(system: lw.System, t: float, y: Any, h: float) -> Any:
    k = system.derivative(t, y)
    return y + h / 2 * (k + system.derivative(t + h, y + h * k))


def test_of_an_integrator_of_the_users_own(tmp_path: Path) -> None:
    assert_found_anew(tmp_path / "run.h5", mechanisms.bricard(), 0.1, step=1e-3, integrator=heun)


@pytest.mark.parametrize("choice", [{"step": 5e-3, "integrator": "ab4"}, {"rtol": 1e-6, "record_every": 1},
                                    {"rtol": 1e-6, "times": np.linspace(0.0, 1.2, 400)}])  # fmt: skip
def test_of_leaps_over_singular_poses(choice: dict[str, Any], tmp_path: Path) -> None:
    assert assert_found_anew(tmp_path / "run.h5", mechanisms.four_bar(), 1.2, **choice).singular_poses


def driven() -> lw.Model:
    """A crank by a motion with a break, on a slider that moves in time, too."""
    model = lw.Model(gravity=(0, 0, -9.81))
    model.body("slider", mass=1.0, inertia=(1, 1, 1), position=(0, 0, 0))
    model.body("crank", mass=1.0, inertia=(0.1, 0.2, 0.3), position=(0.5, 0, 0))
    model.translational("ground", "slider", at=(0, 0, 0), axis=(1, 0, 0), name="rail")
    model.displacement_driver("ground", "slider", at=(0, 0, 0), axis=(1, 0, 0),
                              displacement=lw.functions.harmonic(0.2, 5.0), name="shaker")  # fmt: skip
    model.revolute("slider", "crank", at=(0, 0, 0), axis=Y, name="pin")
    turn = lw.functions.with_breaks(lw.functions.harmonic(1.0, 7.0), [0.0312, 0.07])
    model.angle_driver("slider", "crank", at=(0, 0, 0), axis=Y, angle=turn, name="motor")
    return lw.assemble(model).model


@pytest.mark.parametrize("stabilization", STABILIZATIONS)
@pytest.mark.parametrize("choice", [{"step": 1e-3 / 3, "record_every": 7}, {"step": 1e-2},
                                    {"rtol": 1e-6, "record_every": 1},
                                    {"rtol": 1e-6, "times": [0.0, 0.0312, 0.05, 0.07, 0.1]}])  # fmt: skip
def test_of_constraints_that_depend_on_time(
    choice: dict[str, Any], stabilization: str, tmp_path: Path
) -> None:
    assert_found_anew(tmp_path / "run.h5", driven(), 0.1, stabilization=stabilization, **choice)


def hanging_ball() -> lw.Model:
    """On a rod that swings to a plane and back, by a hysteretic contact."""
    model = lw.Model(gravity=(0, 0, -9.81))
    model.body("rod", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1.0, 0, 0))
    model.revolute("ground", "rod", at=(0, 0, 0), axis=Y, name="pin")
    model.body("ball", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(2.0, 0, 0))
    model.spherical("rod", "ball", at=(1.5, 0, 0), name="eye")
    model.sphere_plane_contact("ground", "ball", at=((0, 0, -0.4), (2.0, 0, 0)), normal=Z, radius=0.1,
                               stiffness=1e4, hysteresis=0.5, name="floor")  # fmt: skip
    return model


@pytest.mark.parametrize("stabilization", STABILIZATIONS)
@pytest.mark.parametrize("choice", [{"step": 1e-3, "record_every": 5}, {"rtol": 1e-6, "record_every": 1},
                                    {"rtol": 1e-6, "times": np.linspace(0.0, 0.6, 61)}])  # fmt: skip
def test_of_contacts(choice: dict[str, Any], stabilization: str, tmp_path: Path) -> None:
    result = assert_found_anew(
        tmp_path / "run.h5", hanging_ball(), 0.6, stabilization=stabilization, **choice
    )
    assert result.recorded("history").any()


@pytest.mark.parametrize("terminal", [False, True])
@pytest.mark.parametrize("frames", [{"record_every": 1}, {"times": np.linspace(0.0, 1.0, 21)}])
def test_of_events_that_change_the_state(terminal: bool, frames: dict[str, Any], tmp_path: Path) -> None:
    def turn_back(t: float, state: Any) -> None:
        state.v[:] *= -0.5

    bottom = lw.Event(lambda t, state: state.body("bob").position[0] - 0.3, "stop", terminal=terminal,
                      change=None if terminal else turn_back)  # fmt: skip
    model = mechanisms.pendulum()
    result = assert_found_anew(tmp_path / "run.h5", model, 1.0, rtol=1e-7, events=bottom, **frames)
    assert result.events


def test_of_couplers_whose_angles_go_on_over_full_turns(tmp_path: Path) -> None:
    model = lw.Model(gravity=(0, 0, -9.81))
    for name, x in (("wheel", 0.0), ("small", 1.0)):
        model.body(name, mass=1.0, inertia=(1, 1, 0.4), position=(x, 0.1, 0))
        model.revolute("ground", name, at=(x, 0, 0), axis=Z, name=f"axle of {name}")
    model.coupler([("axle of wheel", 1.0), ("axle of small", -2.0)], name="belt")
    model.rotational_spring_damper("ground", "wheel", at=(0, 0, 0), axis=Z, torque=50.0)
    for choice in ({"step": 1e-3, "record_every": 20}, {"rtol": 1e-5, "times": np.linspace(0.0, 1.0, 60)}):
        result = assert_found_anew(tmp_path / "run.h5", model, 1.0, **choice)
        assert np.abs(result.recorded("history")).max() > 2 * np.pi


@pytest.mark.parametrize("projects", [False, True])
def test_of_several_threads(projects: bool, tmp_path: Path) -> None:
    model = mechanisms.chain(5000)
    choices: dict[str, Any] = {"stabilization": "projection"} if projects else {}
    assert_found_anew(tmp_path / "run.h5", model, 3e-3, step=1e-3, record_every=1, threads=2, **choices)


def test_of_a_run_that_goes_on(tmp_path: Path) -> None:
    choices: dict[str, Any] = {"step": 1e-2, "integrator": "abm4", "record_every": 3}
    for end in (0.1, 0.155):
        first = assert_found_anew(tmp_path / "first.h5", mechanisms.bricard(), end, **choices)
        rest = assert_found_anew(
            tmp_path / "rest.h5", mechanisms.bricard(), 0.3, start=first.snapshot(), **choices
        )
        assert rest.manifest["resumed"] is True


@examples(40)
@given(
    mechanism=mechanisms_of(most=5, forces=("spring_damper", "applied", "drag", "bushing")),
    integrator=st.sampled_from(list(METHODS)),
    stabilization=st.sampled_from([None, "projection"]),
    adaptive=st.sampled_from([None, "record_every", "times"]),
)
def test_of_random_mechanisms(
    mechanism: Mechanism, integrator: str, stabilization: str | None, adaptive: str | None,
    tmp_path_factory: pytest.TempPathFactory,
) -> None:  # fmt: skip
    choices: dict[str, Any] = {"integrator": integrator, "stabilization": stabilization}
    if adaptive and integrator in PAIRS:
        frames = {"times": [0.0, 0.003, 0.011, 0.02], "record_every": 1}
        choices.update({"rtol": 1e-5, adaptive: frames[adaptive]})
    else:
        choices.update(step=1.7e-3, record_every=2)
    output = tmp_path_factory.mktemp("random") / "run.h5"
    try:
        assert_found_anew(output, mechanism.model, 0.02, **choices)
    except lw.LinkworkError:  # too stiff for this step
        return
