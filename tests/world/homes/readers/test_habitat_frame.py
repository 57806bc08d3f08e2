"""Habitat's frames against what is known of them by hand."""

import math

import numpy as np
import pytest

from uniteam.geometry import quaternion_to_matrix
from uniteam.world.homes.readers.habitat_frame import (
    TO_WORLD,
    from_wxyz,
    from_xyzw,
    heading_as_coded,
    heading_as_written,
    is_upright,
    point_to_world,
    quaternion_of,
    rotation_to_world,
    scale_to_world,
)

QUARTER = math.sqrt(0.5)


def about_y(angle: float) -> tuple[float, float, float, float]:
    """Return the quaternion (x, y, z, w) of a turn about Habitat's y."""
    return (0.0, math.sin(angle / 2), 0.0, math.cos(angle / 2))


def test_up_stays_up_and_the_change_of_frame_is_a_rotation() -> None:
    assert np.linalg.det(TO_WORLD) == pytest.approx(1.0)
    assert point_to_world((1.0, 2.0, 3.0)) == pytest.approx([1.0, -3.0, 2.0])


def test_both_orders_of_a_quaternion_mean_the_same_turn() -> None:
    rotation = from_wxyz((QUARTER, 0.0, QUARTER, 0.0))
    assert np.allclose(rotation, from_xyzw((0.0, QUARTER, 0.0, QUARTER)))
    assert rotation @ [1.0, 0.0, 0.0] == pytest.approx([0.0, 1.0, 0.0])


def test_a_rotated_point_is_the_same_in_either_frame() -> None:
    quaternion = np.array([0.4, -0.2, 0.7, 0.1]) / np.linalg.norm([0.4, -0.2, 0.7, 0.1])
    there = quaternion_to_matrix(quaternion)
    point = np.array([0.3, -1.2, 2.0])
    assert rotation_to_world(there) @ point_to_world(point) == pytest.approx(point_to_world(there @ point))


def test_the_challenges_task_turns_the_robot_the_other_way_than_its_quaternion_does() -> None:
    turn = 0.7
    # habitat-lab: h is (0, 0, -1) turned by the quaternion, the base's rotation atan2(h_x, -h_z) about y, its front +x.
    h = quaternion_to_matrix(np.array([math.cos(turn / 2), 0.0, math.sin(turn / 2), 0.0])) @ [0.0, 0.0, -1.0]
    base = math.atan2(h[0], -h[2])
    front = point_to_world((math.cos(base), 0.0, -math.sin(base)))
    assert heading_as_coded(about_y(turn)) == pytest.approx(math.atan2(front[1], front[0]))
    assert heading_as_coded(about_y(turn)) == pytest.approx(-turn)
    assert heading_as_written(about_y(turn)) == pytest.approx(turn)


@pytest.mark.parametrize("quaternion", [(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 0, 1), (0.5, -0.5, 0.5, 0.5)])
def test_a_rotation_gives_its_quaternion_back(quaternion: tuple[float, ...]) -> None:
    rotation = quaternion_to_matrix(np.array(quaternion, dtype=np.float64))
    assert np.allclose(quaternion_to_matrix(np.array(quaternion_of(rotation))), rotation)


def test_only_a_turn_about_the_vertical_is_upright() -> None:
    assert is_upright(from_xyzw(about_y(2.0)))
    assert not is_upright(from_xyzw((QUARTER, 0.0, 0.0, QUARTER)))
    assert scale_to_world((1.0, 2.0, 3.0)).tolist() == [1.0, 3.0, 2.0]
