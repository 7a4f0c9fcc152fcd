"""Parameters that no element can have are refused: numbers where it is added, functions before the run."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork import functions
from linkwork.modeling.elements import KINDS, Role

#: Arguments of each placement.
PLACES: dict[str, dict[str, Any]] = {
    "point": {"at": (0, 0, 0)},
    "axis": {"at": (0, 0, 0), "axis": (0, 1, 0)},
    "two_points": {"at": ((0, 0, 0), (1, 0, 0))},
    "centers": {"at": ((0, 0, 0), (1, 0, 0)), "axis": (0, 1, 0)},
    "disc": {"at": ((0, 0, 0), (0, 0, 0.5)), "axes": ((0, 0, 1), (0, 1, 0))},
    "plane": {"at": ((0, 0, 0), (0, 0, 0.5)), "normal": (0, 0, 1)},
    "direction": {"axis": (0, 1, 0)},
}

BOUNDED = [
    (role, name, parameter)
    for role in KINDS
    for name, kind in KINDS[role].items()
    for parameter in kind.parameters.values()
    if parameter.least is not None
]


def two_bodies() -> lw.Model:
    model = lw.Model()
    for name in "ab":
        model.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1))
    return model


def add(model: lw.Model, kind: str, **other: Any) -> Any:
    info = KINDS["joint"].get(kind) or KINDS["force"][kind]
    given = {name: it.example for name, it in info.parameters.items()}
    return getattr(model, kind)("a", "b", name="it", **PLACES[info.placement] | given | other)


@pytest.mark.parametrize("kind", sorted({kind for _, kind, _ in BOUNDED}))
def test_every_bounded_kind_can_be_added(kind: str) -> None:
    add(two_bodies(), kind)


@pytest.mark.parametrize("role, name, bound", BOUNDED, ids=lambda x: getattr(x, "name", str(x)))
def test_a_number_beyond_its_bound_is_refused_by_name_and_value(role: Role, name: str, bound: Any) -> None:
    for value in [bound.least - 1, *[bound.least] * bound.above]:
        model = two_bodies()
        with pytest.raises(lw.ModelError) as found:
            add(model, name, **{bound.name: value})
        assert f"{name} 'it'" in str(found.value)
        assert f"{bound.name} = {value:g} must" in str(found.value) or "must be positive" in str(found.value)
        assert found.value.field == bound.name
        assert model.joint_count == model.force_count == 0  # the model is as it was
    if not bound.above:
        add(two_bodies(), name, **{bound.name: bound.least})


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
