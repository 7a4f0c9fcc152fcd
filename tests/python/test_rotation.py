"""Euler parameters in Python."""

from __future__ import annotations

import linkwork as lw
import numpy as np
import pytest
from linkwork import rotation
from linkwork.arrays import Floats


def random_parameters(count: int) -> Floats:
    p = np.random.default_rng(7).normal(size=(count, 4))
    return p / np.linalg.norm(p, axis=1, keepdims=True)


def test_a_matrix_is_a_rotation() -> None:
    A = rotation.matrix(random_parameters(100))
    assert np.abs(np.swapaxes(A, 1, 2) @ A - np.eye(3)).max() < 1e-14
    assert np.abs(np.linalg.det(A) - 1).max() < 1e-14


def test_parameters_come_back_from_the_matrix_up_to_their_sign() -> None:
    p = random_parameters(100)
    assert np.abs(np.abs(np.sum(p * rotation.from_matrix(rotation.matrix(p)), axis=1)) - 1).max() < 1e-15


@pytest.mark.parametrize("axis", np.eye(3).tolist())
def test_half_turns_come_back_from_the_matrix(axis: list[float]) -> None:
    assert np.abs(rotation.from_matrix(rotation.matrix((0.0, *axis))) - (0.0, *axis)).max() < 1e-15


def test_a_quarter_turn_about_z_takes_x_to_y() -> None:
    assert rotation.matrix(rotation.about((0, 0, 3), np.pi / 2))[:, 0] == pytest.approx((0, 1, 0), abs=1e-15)


def test_axes_of_a_body_point_where_they_should() -> None:
    A = rotation.matrix(rotation.from_axes(x=(0, 3, 4), y=(1, 1, 1)))
    assert A[:, 0] == pytest.approx((0, 0.6, 0.8), abs=1e-15)
    assert A[:, 1] @ (1, 1, 1) > 0
    assert A[:, 2] @ (1, 1, 1) == pytest.approx(0, abs=1e-15)


def test_perpendiculars_are_unit_and_perpendicular() -> None:
    z = np.concatenate([np.eye(3), random_parameters(100)[:, :3]])
    x = rotation.perpendicular(z)
    assert np.abs(np.linalg.norm(x, axis=1) - 1).max() < 1e-15
    assert np.abs(np.sum(x * z, axis=1)).max() < 1e-15


#: Of an inertia about the center of mass; NumPy gives them any sign.
PRINCIPAL_AXES = np.linalg.eigh([[0.03, 0.004, 0.002], [0.004, 0.05, -0.003], [0.002, -0.003, 0.06]])[1]


@pytest.mark.parametrize("Q", [np.diag([1.0, 1, -1]), -np.eye(3), np.eye(3)[[1, 0, 2]], PRINCIPAL_AXES])
def test_reflections_are_no_rotations(Q: Floats) -> None:
    reflection = Q if np.linalg.det(Q) < 0 else -Q
    with pytest.raises(lw.ModelError, match="is a reflection"):
        rotation.from_matrix(reflection)
    with pytest.raises(lw.ModelError, match="is a reflection"):
        rotation.from_matrix([np.eye(3), reflection])
    assert rotation.matrix(rotation.from_matrix(-reflection)) == pytest.approx(-reflection, abs=1e-14)


def test_what_is_no_rotation_is_refused() -> None:
    for A in (np.full((3, 3), np.nan), np.diag([1, 1, 1.01])):
        with pytest.raises(lw.ModelError, match="no rotation matrix"):
            rotation.from_matrix(A)
    for p in ((2, 0, 0, 0), (0, 0, 0, 0), (0.9, 0.1, 0, 0)):
        with pytest.raises(lw.ModelError, match="no unit quaternion"):
            rotation.matrix(p)
    with pytest.raises(lw.ModelError, match="a .* is no unit vector"):
        rotation.between((3, 0, 0), (0, 1, 0))
    with pytest.raises(lw.ModelError, match="opposite to each other"):
        rotation.between((0, 0, 1), (0, 0, -1))
