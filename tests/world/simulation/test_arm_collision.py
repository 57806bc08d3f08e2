"""The arm against walls, furniture and objects, on a home of boxes."""

import math
from dataclasses import replace

import numpy as np
import pytest
from worlds.small_home import BALL, CATALOGUE, CUP, SINK, TABLE, TABLE_HEIGHT, instance, small_home

from uniteam.geometry import BasePose
from uniteam.interface import Joints
from uniteam.stretch import NAVIGATION_POSTURE, gripper_to_base
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Box
from uniteam.world.homes.home import Instance
from uniteam.world.physics.collision_shapes import model_vertices
from uniteam.world.physics.physics import Physics
from uniteam.world.simulation.arm_collision import ArmCollider
from uniteam.world.simulation.held_object import HeldObject, hang
from uniteam.world.simulation.robot_state import SAMPLE_TRAVEL, RobotState, samples, turned, with_joints
from uniteam.world.simulation.touches import Touches

FINGERTIPS = -0.429
"""y of the fingertips (m, base frame) with the arm retracted and the wrist straight."""
STRAIGHT = Joints(lift=0.78, arm=0.0)
EXTENDED = replace(STRAIGHT, arm=0.52)


def collider_of(*things: Instance, catalogue: Catalogue = CATALOGUE) -> ArmCollider:
    return ArmCollider(Physics(small_home(*things, library=catalogue)))


def facing_south_wall(distance: float, joints: Joints = STRAIGHT) -> RobotState:
    """Return the robot so far (m) from the face of the wall that its arm points to."""
    return RobotState(BasePose(2.0, 0.05 + distance, 0.0), joints)


def hit_on_the_way(
    collider: ArmCollider, start: RobotState, joints: Joints, held: HeldObject | None = None
) -> str | None:
    radius = 0.0 if held is None else held.radius
    return collider.touches(tuple(samples(start, with_joints(start, joints), 0.0, radius)), held).first


def held_cup() -> HeldObject:
    return hang("cup", model_vertices(CUP.shapes), np.eye(4), np.zeros(3))


def test_arm_extended_into_a_wall_collides_and_short_of_it_does_not() -> None:
    collider = collider_of()
    reach = 0.52 - FINGERTIPS
    assert hit_on_the_way(collider, facing_south_wall(reach - 0.01), EXTENDED) == "wall"
    assert hit_on_the_way(collider, facing_south_wall(reach + 0.01), EXTENDED) is None


def test_contact_counts_only_when_deeper_than_a_touch() -> None:
    collider = collider_of()
    for depth, met in ((0.004, None), (0.006, "wall")):
        assert collider.touches((facing_south_wall(-FINGERTIPS - depth),), None).first == met


def test_thin_board_that_the_gripper_swings_through_is_met() -> None:
    board = replace(TABLE, id="board", shapes=(Box((0.0, 0.0, 1.0), (0.01, 0.3, 0.6)),))
    collider = collider_of(instance("board", board, 2.15, 1.7), catalogue=Catalogue({"board": board}, frozenset()))
    start = RobotState(BasePose(2.0, 2.0, 0.0), STRAIGHT)
    end = turned(start, math.radians(90.0))
    assert collider.touches((start,), None).first is None
    assert collider.touches((end,), None).first is None
    assert collider.touches(tuple(samples(start, end, math.radians(90.0), 0.0)), None).first == "board"
    assert collider.touches(tuple(samples(start, end, math.radians(-270.0), 0.0)), None).first is None


def test_samples_are_no_further_apart_than_promised() -> None:
    start = RobotState(BasePose(1.0, 1.0, 3.0), STRAIGHT)
    end = RobotState(BasePose(1.1, 1.3, -3.0), Joints(1.0, 0.3, wrist_yaw=1.0, wrist_pitch=-1.0, wrist_roll=0.5))
    path = [start, *samples(start, end, end.base.heading - start.base.heading + 2 * math.pi, 0.0)]
    tips = np.array([(s.base.matrix() @ gripper_to_base(s.joints))[:3, 3] for s in path])
    assert np.linalg.norm(np.diff(tips, axis=0), axis=1).max() <= SAMPLE_TRAVEL
    assert path[-1] is end


def test_gripper_above_a_table_is_free_and_lowered_onto_it_collides() -> None:
    collider = collider_of(instance("table", TABLE, 2.0, 1.0))
    above = RobotState(BasePose(2.0, 1.75, 0.0), Joints(TABLE_HEIGHT, 0.2))
    assert collider.touches((above,), None).first is None
    assert hit_on_the_way(collider, above, Joints(TABLE_HEIGHT - 0.1, 0.2)) == "table"


def test_object_is_met_where_it_has_fallen_to() -> None:
    physics = Physics(small_home(instance("ball", BALL, 1.0, 1.0, 0.3)))
    collider = ArmCollider(physics)
    path = (RobotState(BasePose(1.0, 1.42, 0.0), Joints(0.225, 0.0)),)
    assert collider.touches(path, None).first == "ball"
    physics.settle()
    assert collider.touches(path, None).first is None
    low = RobotState(BasePose(1.0, 1.42, 0.0), Joints(0.0, 0.0, wrist_pitch=-0.3))
    assert collider.touches((low,), None).first == "ball"


def test_gripper_lowered_to_the_ground_meets_the_floor() -> None:
    start = RobotState(BasePose(2.0, 2.0, 0.0), replace(NAVIGATION_POSTURE, lift=0.3))
    assert hit_on_the_way(collider_of(), start, replace(NAVIGATION_POSTURE, lift=0.0)) == "floor"


def test_held_object_collides_where_the_gripper_alone_does_not() -> None:
    collider = collider_of(instance("table", TABLE, 2.0, 1.0), instance("cup", CUP, 3.0, 3.0))
    low = RobotState(BasePose(2.0, 1.75, 0.0), Joints(TABLE_HEIGHT - 0.05, 0.2))
    assert collider.touches((low,), None).first is None
    assert collider.touches((low,), held_cup()).first == "table"


def test_what_is_met_is_told_by_the_three_kinds_of_the_challenge() -> None:
    ball = instance("ball", BALL, 1.98, 1.34, 0.75)
    collider = collider_of(instance("table", TABLE, 2.0, 1.0), instance("cup", CUP, 3.0, 3.0), ball)
    above = RobotState(BasePose(2.0, 1.75, 0.0), Joints(TABLE_HEIGHT - 0.05, 0.2))
    into_the_table = with_joints(above, Joints(TABLE_HEIGHT - 0.15, 0.2))
    assert collider.touches((above,), None) == Touches(robot_obj="ball")
    assert collider.touches((into_the_table,), None) == Touches(robot_scene="table", robot_obj="ball")
    assert collider.touches((above, into_the_table), held_cup()) == Touches("table", "table", "ball")


def test_a_small_object_in_the_way_of_the_held_one_counts_as_the_held_object_s() -> None:
    collider = collider_of(instance("cup", CUP, 3.0, 3.0), instance("ball", BALL, 1.98, 1.59, 0.73))
    here = RobotState(BasePose(2.0, 2.0, 0.0), STRAIGHT)
    assert collider.touches((here,), held_cup()) == Touches(obj_scene="ball")


def test_held_object_is_no_part_of_the_scene_until_it_has_left_the_fingers() -> None:
    collider = collider_of(instance("cup", CUP, 2.0 - 0.021, 2.0 - 0.409, 0.84))
    here = RobotState(BasePose(2.0, 2.0, 0.0), STRAIGHT)
    assert collider.touches((here,), held_cup()).first is None
    assert collider.touches((here,), None).first is None
    higher = replace(STRAIGHT, lift=0.95)
    assert hit_on_the_way(collider, here, higher) is None
    assert hit_on_the_way(collider, with_joints(here, higher), STRAIGHT) == "cup"


def test_folded_arm_never_collides_where_the_base_fits() -> None:
    collider = collider_of(instance("sink", SINK, 2.0, 2.0))
    beside = [
        RobotState(BasePose(2.0 + 0.605, 2.0, heading), NAVIGATION_POSTURE) for heading in np.linspace(-3.1, 3.1, 24)
    ]
    assert collider.touches(beside, None).first is None


@pytest.mark.parametrize("yaw", [0.0, 0.6, math.pi / 2, 2.5])
def test_held_object_hangs_level_from_its_top_with_its_long_side_along_the_base(yaw: float) -> None:
    c, s = math.cos(yaw), math.sin(yaw)
    lying = np.array([[c, -s, 0, 1.0], [s, c, 0, -0.5], [0, 0, 1, 0.8], [0, 0, 0, 1]])
    vertices = model_vertices((Box((0.0, 0.0, 0.05), (0.1, 0.3, 0.1)),))
    gripper = gripper_to_base(Joints(0.9, 0.3, wrist_yaw=0.5, wrist_pitch=-1.2))
    to_base = hang("box", vertices, lying, gripper[:3, 3]).to_base(gripper)
    points = vertices @ to_base[:3, :3].T + to_base[:3, 3]
    np.testing.assert_allclose(points.max(axis=0) - points.min(axis=0), [0.3, 0.1, 0.1], atol=1e-6)
    np.testing.assert_allclose(points.max(axis=0) + points.min(axis=0), 2 * gripper[:3, 3] - [0, 0, 0.1], atol=1e-6)
