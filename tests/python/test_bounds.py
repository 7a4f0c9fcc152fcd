"""Parameters that no element can have are refused: numbers where it is added, functions before the run."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import functions
from linkwork.elements import KINDS, Role

#: Of every kind that bounds a parameter: what it is called with, all of it possible.
POSSIBLE: dict[str, dict[str, Any]] = {
    "distance": {"at": ((0, 0, 0), (1, 0, 0)), "length": 1.0},
    "revolute_revolute": {"at": ((0, 0, 0), (1, 0, 0)), "axis": (0, 1, 0), "length": 1.0},
    "revolute_spherical": {"at": ((0, 0, 0), (1, 0, 0)), "axis": (0, 1, 0), "length": 1.0},
    "universal_spherical": {"at": ((0, 0, 0), (1, 0, 0)), "length": 1.0},
    "rolling_disc": {
        "at": ((0, 0, 0), (0, 0, 0.5)), "axes": ((0, 0, 1), (0, 1, 0)), "radius": 0.5,
    },
    "rotational_friction": {
        "at": (0, 0, 0), "axis": (0, 1, 0), "coulomb": 1.0, "viscous": 0.1, "transition": 0.01,
    },
    "translational_friction": {
        "at": (0, 0, 0), "axis": (0, 1, 0), "coulomb": 1.0, "viscous": 0.1, "transition": 0.01,
    },
    "rotational_stop": {
        "at": (0, 0, 0), "axis": (0, 1, 0), "lower": -1.0, "upper": 1.0, "stiffness": 10.0, "damping": 1.0,
    },
    "translational_stop": {
        "at": (0, 0, 0), "axis": (0, 1, 0), "lower": -1.0, "upper": 1.0, "stiffness": 10.0, "damping": 1.0,
    },
    "drag": {"at": (0, 0, 0), "coefficient": 0.5},
    "sphere_plane_contact": {
        "at": ((0, 0, 0), (0, 0, 0.5)), "normal": (0, 0, 1), "radius": 0.5, "stiffness": 1e3, "exponent": 1.5,
        "hysteresis": 0.1, "friction": 0.1, "transition": 1e-3,
    },
    "sphere_sphere_contact": {
        "at": ((0, 0, 0), (0, 0, 0.5)), "radius_a": 0.5, "radius_b": 0.2, "stiffness": 1e3, "exponent": 1.5,
        "hysteresis": 0.1, "friction": 0.1, "transition": 1e-3,
    },
}  # fmt: skip

BOUNDED = [
    (role, name, bound) for role in KINDS for name, kind in KINDS[role].items() for bound in kind.bounds
]


def two_bodies() -> lw.Model:
    model = lw.Model()
    for name in "ab":
        model.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1))
    return model


def add(model: lw.Model, kind: str, **other: Any) -> Any:
    return getattr(model, kind)("a", "b", name="it", **POSSIBLE[kind] | other)


def test_every_bounded_kind_is_tried() -> None:
    assert {name for _, name, _ in BOUNDED} == set(POSSIBLE)
    for name in POSSIBLE:
        add(two_bodies(), name)


@pytest.mark.parametrize("role, name, bound", BOUNDED, ids=lambda x: getattr(x, "parameter", str(x)))
def test_a_number_beyond_its_bound_is_refused_by_name_and_value(role: Role, name: str, bound: Any) -> None:
    for value in [bound.least - 1, *[bound.least] * bound.above]:
        model = two_bodies()
        with pytest.raises(lw.ModelError) as found:
            add(model, name, **{bound.parameter: value})
        assert f"{name} 'it'" in str(found.value)
        assert f"{bound.parameter} = {value:g} must" in str(found.value) or "must be positive" in str(
            found.value
        )
        assert model.joint_count == model.force_count == 0  # the model is as it was
    if not bound.above:
        add(two_bodies(), name, **{bound.parameter: bound.least})


@pytest.mark.parametrize("kind", ["rotational_stop", "translational_stop"])
def test_a_stop_whose_ends_are_exchanged_is_refused(kind: str) -> None:
    with pytest.raises(lw.ModelError, match=r"'it': lower = 0.5 must not be above upper = -0.5"):
        add(two_bodies(), kind, lower=0.5, upper=-0.5)
    add(two_bodies(), kind, lower=0.5, upper=0.5)


def wheel() -> lw.Model:
    model = lw.Model()
    model.body("wheel", mass=1.0, inertia=(0.1, 0.1, 0.1))
    model.revolute("ground", "wheel", at=(0, 0, 0), axis=(0, 1, 0))
    return model


def stop(model: lw.Model, **given: Any) -> None:
    place = {"at": (0, 0, 0), "axis": (0, 1, 0), "name": "end"}
    model.rotational_stop("ground", "wheel", **place, **{"lower": -1, "upper": 1, "stiffness": 9.0} | given)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"stiffness": functions.polynomial(1.0, -1.0)}, r"'end': stiffness is -\S+ at t = 1\.\d+ s"),
        ({"lower": functions.polynomial(0, 2.0)}, r"'end': upper is 1 at t = 0\.\d+ s.* which is lower"),
        ({"damping": functions.table([0, 1, 2], [0, 1, -1])}, r"'end': damping is -\S+ at t"),
    ],
)
def test_a_function_that_passes_a_bound_is_refused_before_the_run(given: Any, message: str) -> None:
    model = wheel()
    stop(model, **given)
    with pytest.raises(lw.OptionError, match=message):
        lw.simulate(model, 2.0, 1e-2)


def test_a_function_may_touch_its_bound() -> None:
    model = wheel()
    stop(model, stiffness=functions.harmonic(1.0, 3.0, offset=1.0))
    lw.simulate(model, 2.0, 1e-2)


def test_a_python_function_that_passes_a_bound_ends_the_run_where_it_does() -> None:
    model = wheel()
    model.rotational_friction(
        "ground",
        "wheel",
        at=(0, 0, 0),
        axis=(0, 1, 0),
        coulomb=lambda t: 1.0 - t,
        transition=1.0,
        name="brake",
    )
    with pytest.raises(lw.OptionError, match=r"'brake': coulomb is -\S+ at t = 1\.\d+ s"):
        lw.simulate(model, 2.0, 1e-2)


def test_a_model_file_names_the_field(tmp_path: Path) -> None:
    model = wheel()
    stop(model)
    path = tmp_path / "wheel.yaml"
    model.save(path)
    path.write_text(path.read_text().replace("stiffness: 9.0", "stiffness: -9.0"))
    with pytest.raises(lw.ModelFileError, match=r"forces\[0\]\.stiffness: .*must be positive"):
        lw.Model.load(path)


@pytest.mark.parametrize("scale", [2.0, 1 + 1e-5, 0.0])
def test_a_start_whose_euler_parameters_are_not_unit_is_refused(scale: float) -> None:
    model = wheel()
    start = lw.simulate(model, 0.1, 1e-2).snapshot()
    q = start.q.copy()
    q[0, 3:] *= scale
    with pytest.raises(lw.OptionError, match=r"body 'wheel': its Euler parameters have norm"):
        lw.simulate(model, 0.2, 1e-2, start=start._replace(q=q))


def test_a_start_that_is_off_by_rounding_is_normalized_and_one_that_is_not_keeps_its_bits() -> None:
    model = wheel()
    model.rotational_spring_damper("ground", "wheel", axis=(0, 1, 0), stiffness=3.0, free_angle=0.3)
    whole = lw.simulate(model, 0.2, 1e-2, record_every=1)
    half = lw.simulate(model, 0.1, 1e-2, record_every=1)
    rest = lw.simulate(model, 0.2, 1e-2, record_every=1, start=half.snapshot())
    assert np.abs(rest.q[0] - half.q[-1]).max() == 0.0
    q = half.q[-1].copy()
    q[0, 3:] *= 1 + 1e-8
    from_off = lw.simulate(model, 0.2, 1e-2, record_every=1, start=half.snapshot()._replace(q=q))
    assert np.linalg.norm(from_off.q[0, 0, 3:]) == pytest.approx(1.0, abs=1e-15)
    assert np.abs(from_off.q[-1] - whole.q[-1]).max() < 1e-12
