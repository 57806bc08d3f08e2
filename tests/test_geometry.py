"""Poses and cameras against closed forms."""

import math

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.geometry import (
    BasePose,
    PinholeCamera,
    invert_transform,
    pixels_of,
    pose_matrices,
    pose_matrix,
    quaternion_to_matrix,
    transform_points,
    wrap_angle,
    yaw_quaternion,
)
from uniteam.interface import Joints, Observation


def test_a_pose_composed_with_its_inverse_is_the_origin() -> None:
    pose = BasePose(1.5, -2.0, 2.1)
    there_and_back = pose.compose(pose.inverse())
    assert (there_and_back.x, there_and_back.y, there_and_back.heading) == pytest.approx((0, 0, 0), abs=1e-12)


def test_composing_poses_is_multiplying_their_matrices() -> None:
    outer, inner = BasePose(1.0, 2.0, 0.7), BasePose(-0.3, 0.9, -2.8)
    assert np.allclose(outer.compose(inner).matrix(), outer.matrix() @ inner.matrix())


def test_a_point_to_the_left_has_a_positive_bearing() -> None:
    assert BasePose(0, 0, math.pi / 2).bearing_to(-1, 0) == pytest.approx(math.pi / 2)


@pytest.mark.parametrize("angle", [-math.pi, math.pi, 3 * math.pi, -7.0, 0.0])
def test_a_wrapped_angle_is_the_same_angle_within_half_a_turn(angle: float) -> None:
    wrapped = wrap_angle(angle)
    assert -math.pi < wrapped <= math.pi
    assert math.cos(wrapped) == pytest.approx(math.cos(angle))
    assert math.sin(wrapped) == pytest.approx(math.sin(angle), abs=1e-12)


def test_projecting_what_was_unprojected_gives_the_pixels_back() -> None:
    camera = PinholeCamera.from_horizontal_fov(24, 32, math.radians(42))
    depth = np.linspace(0.5, 9.0, 24 * 32).reshape(32, 24).astype(np.float32)
    pixels = camera.project(camera.unproject(depth))
    expected = np.stack(np.meshgrid(np.arange(24), np.arange(32)), axis=-1)
    assert np.allclose(pixels, expected, atol=1e-3)


def test_the_edge_of_the_image_lies_at_half_the_field_of_view() -> None:
    camera = PinholeCamera.from_horizontal_fov(480, 640, math.radians(42))
    edge = camera.project(np.array([math.tan(math.radians(21)), 0.0, 1.0]))
    assert edge[0] == pytest.approx(479.5)


def test_a_yaw_quaternion_turns_x_towards_y() -> None:
    turned = quaternion_to_matrix(np.array(yaw_quaternion(math.pi / 2))) @ np.array([1.0, 0, 0])
    assert np.allclose(turned, [0, 1, 0])


def test_an_inverted_transform_takes_points_back() -> None:
    transform = pose_matrix(np.array([1.0, 2.0, 3.0]), np.array([0.5, 0.5, -0.5, 0.5]))
    points = np.array([[0.1, 0.2, 0.3], [-1.0, 4.0, 2.0]])
    assert np.allclose(transform_points(invert_transform(transform), transform_points(transform, points)), points)


def test_joints_add_and_subtract_joint_by_joint() -> None:
    assert Joints(0.5, 0.1, head_pan=-1.0) + Joints(0.1, 0.2, head_pan=0.5) == Joints(0.6, 0.1 + 0.2, head_pan=-0.5)


def test_a_frame_of_the_wrong_shape_is_refused_in_words() -> None:
    camera = PinholeCamera.from_horizontal_fov(24, 32, 0.7)
    rgb, depth = np.zeros((24, 32, 3), np.uint8), np.zeros((24, 32), np.float32)
    with pytest.raises(InvalidInputError, match=r"24x32 camera needs rgb \(32, 24, 3\)"):
        Observation(rgb, depth, camera, np.eye(4), BasePose(0, 0, 0), Joints(0, 0), False, 0)


def test_an_unknown_name_is_answered_with_the_nearest() -> None:
    assert "did you mean 'baseline'?" in str(UnknownNameError("agent", "baselin", ["baseline", "uniteam"]))


def test_many_poses_are_the_same_to_the_bit_as_one_by_one() -> None:
    rng = np.random.default_rng(0)
    poses = rng.normal(size=(50, 7))
    for pose, matrix in filled(zip(poses, pose_matrices(poses), strict=True)):
        assert np.array_equal(matrix, pose_matrix(pose[:3], pose[3:]))
    assert pose_matrices(np.empty((0, 7))).shape == (0, 4, 4)


def test_the_pixels_of_a_mask_are_those_that_numpy_finds() -> None:
    mask = np.random.default_rng(0).random((30, 50)) > 0.7
    for part in (mask, mask[3:20, 5:40], mask & False):
        assert np.array_equal(np.stack(pixels_of(part)), np.stack(np.nonzero(part)))
    every = -(-np.count_nonzero(mask) // 100)
    thinned = np.stack(pixels_of(mask, 100))
    assert 50 < thinned.shape[1] <= 100
    assert np.array_equal(thinned, np.stack(np.nonzero(mask))[:, ::every])
