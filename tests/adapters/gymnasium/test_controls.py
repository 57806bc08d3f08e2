"""What a policy gives is read by column: steps, thresholds, and what goes before what."""

import math

import numpy as np
import pytest

from uniteam.adapters.gymnasium.controls import (
    ARM,
    BASE,
    EVERY_ACTION,
    FOUR_MOVES,
    GRIP,
    MANIPULATION_MODE,
    NAVIGATION_MODE,
    STOP,
    Columns,
)
from uniteam.errors import InvalidActionError
from uniteam.interface import Action, BaseDisplacement, DiscreteAction, JointDisplacement, Joints
from uniteam.stretch import MANIPULATION_POSTURE, NAVIGATION_POSTURE

COLUMNS = Columns((*BASE, *ARM, "head_tilt", GRIP, MANIPULATION_MODE, NAVIGATION_MODE, STOP))


def read(joints: Joints = NAVIGATION_POSTURE, is_holding: bool = False, **asked: float) -> Action:
    return COLUMNS.read([asked.get(name, 0.0) for name in COLUMNS.names], joints, is_holding)


def test_a_positive_selector_drives_and_another_turns() -> None:
    assert read(forward=0.8, turn=0.5, selector=0.1) == BaseDisplacement(x=0.2)
    assert read(forward=0.8, turn=0.5, selector=-0.1) == BaseDisplacement(heading=math.radians(15.0))
    assert read(forward=-1.0, selector=1.0) == BaseDisplacement(x=-0.25)


def test_what_is_beyond_one_is_cut() -> None:
    assert read(forward=7.0, selector=9.0) == BaseDisplacement(x=0.25)


def test_a_joint_moves_by_a_tenth_and_not_by_less_than_a_fiftieth() -> None:
    assert read(lift=-1.0, arm=0.5, wrist_yaw=0.19) == JointDisplacement(Joints(lift=-0.1, arm=0.05))
    assert isinstance(read(wrist_yaw=0.2), JointDisplacement)


def test_base_and_joints_move_in_one_step() -> None:
    moved = read(forward=1.0, selector=1.0, head_tilt=1.0)
    assert moved == JointDisplacement(Joints(0.0, 0.0, head_tilt=0.1), BaseDisplacement(x=0.25))


def test_to_stop_goes_before_everything() -> None:
    assert read(stop=0.01, grip=1.0, manipulation_mode=1.0) is DiscreteAction.STOP
    assert read(stop=0.0) == BaseDisplacement()


def test_the_gripper_takes_when_it_is_empty_and_lets_go_when_it_is_not() -> None:
    assert read(grip=0.8, manipulation_mode=1.0) is DiscreteAction.SNAP_OBJECT
    assert read(grip=0.79) == BaseDisplacement()
    assert read(grip=-0.8) == BaseDisplacement()
    assert read(is_holding=True, grip=-0.8) is DiscreteAction.DESNAP_OBJECT
    assert read(is_holding=True, grip=1.0) == BaseDisplacement()


def test_a_mode_is_taken_once_and_locks_the_base() -> None:
    assert read(manipulation_mode=0.81) is DiscreteAction.MANIPULATION_MODE
    assert read(manipulation_mode=0.8) == BaseDisplacement()
    at_arm = read(MANIPULATION_POSTURE, manipulation_mode=1.0, forward=1.0, selector=1.0, arm=1.0)
    assert at_arm == JointDisplacement(Joints(0.0, arm=0.1))
    assert read(MANIPULATION_POSTURE, navigation_mode=1.0) is DiscreteAction.NAVIGATION_MODE


@pytest.mark.parametrize("given", [[0.0], [math.nan] * len(COLUMNS.names), "stop", None, np.zeros((1, 13))])
def test_what_is_no_vector_of_these_columns_is_refused(given: object) -> None:
    with pytest.raises(InvalidActionError, match=f"an action must be {len(COLUMNS.names)} "):
        COLUMNS.read(given, NAVIGATION_POSTURE, False)


def test_a_choice_is_one_of_its_actions() -> None:
    assert EVERY_ACTION.read(np.int64(1), NAVIGATION_POSTURE, False) is DiscreteAction.MOVE_FORWARD
    assert FOUR_MOVES.read(2, NAVIGATION_POSTURE, False) == BaseDisplacement(heading=math.radians(10.0))
    with pytest.raises(InvalidActionError, match="from 0 to 3, got 4"):
        FOUR_MOVES.read(4, NAVIGATION_POSTURE, False)
