"""Rewards and the ends of gazing and picking, term by term."""

import math
from collections.abc import Callable

import numpy as np
import pytest
from worlds.gym_scene import stand
from worlds.judged_scene import EPISODE, ON_THE_TABLE

from uniteam.adapters.gymnasium.open_home import OpenHome
from uniteam.adapters.gymnasium.task import Task
from uniteam.adapters.gymnasium.tasks.grasp import GAZE, PICK, GraspReferee, Penalties, take_what_is_gazed_at
from uniteam.interface import DiscreteAction, JointDisplacement, Joints
from uniteam.world.simulation.graspable import TAKE_NOTHING
from uniteam.world.simulation.step_events import NOTHING, StepEvents
from uniteam.world.simulation.touches import Touches

SLACK = -0.005
SNAP, TURN = DiscreteAction.SNAP_OBJECT, DiscreteAction.TURN_LEFT
Look = Callable[[float], str | None]


@pytest.fixture
def referee(room: OpenHome) -> GraspReferee:
    stand(room, 2.0, 2.0, 0.0)
    return GraspReferee(room, EPISODE, TAKE_NOTHING, Penalties(blocked=1.0))


def test_a_metre_that_the_gripper_comes_nearer_is_worth_two(room: OpenHome, referee: GraspReferee) -> None:
    def distance() -> float:
        return float(np.linalg.norm(room.simulator.gripper_to_world()[:3, 3] - (0.5, 0.5, 0.0)))

    before = distance()
    room.simulator.apply(JointDisplacement(Joints(lift=-0.1, arm=0.1)), TAKE_NOTHING)
    expected = SLACK + 2.0 * (before - distance())
    assert abs(expected - SLACK) > 0.05
    assert referee.judge(TURN, NOTHING).reward == pytest.approx(expected, abs=1.1e-3)


def test_a_blocked_base_costs_one(referee: GraspReferee) -> None:
    verdict = referee.judge(TURN, StepEvents(blocked=True))
    assert (verdict.reward, verdict.is_over) == (pytest.approx(SLACK - 1.0), False)


def test_the_right_object_is_worth_two_and_the_success_ten(referee: GraspReferee) -> None:
    verdict = referee.judge(SNAP, StepEvents(grasped="cup"))
    assert (verdict.reward, verdict.is_over, verdict.is_success) == (pytest.approx(SLACK + 12.0), True, True)
    assert referee.measures()["has_right_object"] is True


@pytest.mark.parametrize("wrong", ["ball", "other_cup"])
def test_a_wrong_object_costs_a_half_and_ends_the_episode(referee: GraspReferee, wrong: str) -> None:
    verdict = referee.judge(SNAP, StepEvents(grasped=wrong))
    assert (verdict.reward, verdict.is_over, verdict.is_success) == (pytest.approx(SLACK - 0.5), True, False)


def test_a_snap_that_takes_nothing_ends_nothing(referee: GraspReferee) -> None:
    assert referee.judge(SNAP, NOTHING).is_over is False


def test_a_touch_costs_six_and_ends_where_it_costs(room: OpenHome, referee: GraspReferee) -> None:
    touched = StepEvents(touches=Touches(robot_scene="table"))
    assert referee.judge(TURN, touched) == referee.judge(TURN, NOTHING)
    picking = GraspReferee(room, EPISODE, TAKE_NOTHING, Penalties(blocked=1.0, touch=6.0))
    verdict = picking.judge(TURN, touched)
    assert (verdict.reward, verdict.is_over) == (pytest.approx(SLACK - 6.0), True)
    small = StepEvents(touches=Touches(robot_obj="ball"))
    assert picking.judge(TURN, small).is_over is False


@pytest.fixture
def look(room: OpenHome) -> Look:
    """Put the cup on the table, stand so far (m) from it with the cup at the middle of the picture, and gaze."""

    def at(distance: float) -> str | None:
        pose = np.eye(4)
        pose[:3, 3] = (ON_THE_TABLE[0], 1.3, ON_THE_TABLE[2])
        room.simulator.physics.set_pose("cup", pose)
        room.simulator.physics.settle(["cup"])
        stand(room, 2.0, 1.3 + distance, -math.pi / 2)
        camera = room.simulator.camera_to_world()[:3, 3]
        down = math.atan2(camera[2] - 0.80, camera[1] - 1.3)
        tilt = -down - room.simulator.joints.head_tilt
        room.simulator.apply(JointDisplacement(Joints(0.0, 0.0, head_tilt=tilt)), TAKE_NOTHING)
        return take_what_is_gazed_at(room).choose(())

    return at


def test_what_is_at_the_middle_of_the_picture_and_near_is_gazed_at(look: Look) -> None:
    assert look(0.75) == "cup"


def test_what_is_farther_than_eight_tenths_of_a_metre_from_the_base_is_not(look: Look) -> None:
    assert look(0.9) is None


def test_what_is_not_at_the_middle_is_not(room: OpenHome, look: Look) -> None:
    assert look(0.75) == "cup"
    room.simulator.apply(DiscreteAction.TURN_LEFT, TAKE_NOTHING)
    assert take_what_is_gazed_at(room).choose(()) is None


@pytest.mark.parametrize("task", [GAZE, PICK])
def test_it_begins_at_a_view_point_of_the_object_and_faces_it_nearly(room: OpenHome, task: Task) -> None:
    errors = []
    for seed in range(40):
        task.begin(room, EPISODE, np.random.default_rng(seed))
        base = room.simulator.base
        assert (base.x, base.y) in EPISODE.objects[0].view_points
        errors.append(base.bearing_to(0.5, 0.5))
    assert math.radians(10.0) < np.std(errors) < math.radians(20.0)
    assert room.simulator.held is None
