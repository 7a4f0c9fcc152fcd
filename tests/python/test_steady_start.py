"""Small motions about a rotor that a run has brought to steady motion, as near as its digits are."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest

SPIN = 50.0  # [rad/s]
Z = (0.0, 0.0, 1.0)


def rotor(*, driven: bool = True, friction: float = 0.0) -> lw.Model:
    model = lw.Model(gravity=(0, 0, 0), name="rig")
    model.body("house", mass=5.0, inertia=(0.2, 0.2, 0.2))
    model.body("rotor", mass=2.0, inertia=(0.05, 0.05, 0.08), omega=(0.0, 0.0, SPIN))
    model.bushing(
        model.ground, "house", at=(0, 0, 0), stiffness=(1e4, 2e4, 3e4), rotational_stiffness=(300, 300, 500),
        rotational_damping=(1, 1, 1),
    )  # fmt: skip
    model.revolute("house", "rotor", at=(0, 0, 0), axis=Z, name="shaft")
    if driven:
        model.drive("shaft", velocity=SPIN, name="motor")
    if friction:
        model.rotational_spring_damper("house", "rotor", axis=Z, damping=friction)
    return model


@pytest.mark.parametrize("options", [{"step": 1e-3}, {"step": 1e-4}, {"rtol": 1e-10}])
def test_a_driven_rotor_vibrates_about_the_end_of_a_run_as_about_its_beginning(options: dict) -> None:
    model = rotor()
    after = lw.linearize(model, start=lw.simulate(model, t_end=0.3, **options).snapshot()).eigenvalues
    assert after == pytest.approx(lw.linearize(model).eigenvalues, abs=1e-5)
    # I theta'' + (c - i J Omega) theta' + k theta = 0 of theta = theta_x + i theta_y
    whirl = np.roots([0.25, 1.0 - 1j * 0.08 * SPIN, 300.0])
    for s in whirl.real + 1j * np.abs(whirl.imag):
        assert np.abs(after - s).min() < 1e-5


@pytest.mark.parametrize("friction", [1e-3, 1e-8])
def test_a_rotor_that_slows_down_is_refused_however_slowly(friction: float) -> None:
    with pytest.raises(lw.ModelError, match="accelerates: body"):
        lw.linearize(rotor(driven=False, friction=friction))
