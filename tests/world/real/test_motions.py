"""From actions to motions: what a robot is told, in which order, and in which words."""

import math
from dataclasses import replace

import pytest

from uniteam.interface import Action, BaseDisplacement, DiscreteAction, JointDisplacement, Joints
from uniteam.stretch import JOINT_LIMITS, MANIPULATION_POSTURE, NAVIGATION_POSTURE
from uniteam.world.real.motions import Grip, Motion, MoveJoints, Translate, Turn, first_motions, motions_of

NOW = replace(NAVIGATION_POSTURE, lift=0.6)


@pytest.mark.parametrize(
    ("action", "motions"),
    [
        (DiscreteAction.MOVE_FORWARD, (Translate(0.25),)),
        (DiscreteAction.TURN_LEFT, (Turn(math.radians(30.0)),)),
        (DiscreteAction.TURN_RIGHT, (Turn(-math.radians(30.0)),)),
        (DiscreteAction.MANIPULATION_MODE, (Turn(math.pi / 2), MoveJoints(MANIPULATION_POSTURE))),
        (DiscreteAction.NAVIGATION_MODE, (MoveJoints(NAVIGATION_POSTURE),)),
        (DiscreteAction.SNAP_OBJECT, (Grip(True),)),
        (DiscreteAction.DESNAP_OBJECT, (Grip(False),)),
        (DiscreteAction.STOP, ()),
        (DiscreteAction.EMPTY_ACTION, ()),
        (BaseDisplacement(), ()),
        (BaseDisplacement(x=0.5, heading=0.4), (Translate(0.5), Turn(0.4))),
        (BaseDisplacement(x=-0.5), (Translate(-0.5),)),
        (BaseDisplacement(x=0.09, heading=0.08), ()),
        (BaseDisplacement(x=9.0, heading=9.0), (Translate(1.0), Turn(math.pi))),
        (JointDisplacement(Joints(9.0, 0.0)), (MoveJoints(replace(NOW, lift=JOINT_LIMITS[1].lift)),)),
        (
            JointDisplacement(Joints(0.1, 0.0), BaseDisplacement(x=0.2)),
            (Translate(0.2), MoveJoints(replace(NOW, lift=0.7))),
        ),
    ],
)
def test_each_action_has_its_motions(action: Action, motions: tuple[Motion, ...]) -> None:
    assert motions_of(action, NOW) == motions


def test_every_discrete_action_is_known() -> None:
    assert all(isinstance(motions_of(action, NOW), tuple) for action in DiscreteAction)


def test_the_arm_is_extended_once_the_lift_is_up() -> None:
    lift, arm = motions_of(DiscreteAction.EXTEND_ARM, NOW)
    assert lift == MoveJoints(replace(NOW, lift=0.8))
    assert arm == MoveJoints(replace(NOW, lift=0.8, arm=JOINT_LIMITS[1].arm))


def test_sideways_is_two_turns_around_a_drive() -> None:
    first, way, last = motions_of(BaseDisplacement(y=0.3, heading=0.2), NOW)
    assert first == Turn(math.pi / 2)
    assert way == Translate(0.3)
    assert last == Turn(0.2 - math.pi / 2)


def test_a_run_begins_with_the_arm_drawn_in_before_anything_else() -> None:
    out = replace(NOW, arm=0.4)
    assert first_motions(out) == (MoveJoints(replace(out, arm=0.0)), Grip(False), MoveJoints(NAVIGATION_POSTURE))
    assert first_motions(NOW) == (Grip(False), MoveJoints(NAVIGATION_POSTURE))


@pytest.mark.parametrize(
    ("motion", "words"),
    [
        (Turn(-0.5236), "turn the base right by 30 degrees"),
        (Translate(-0.25), "drive the base 0.25 m back"),
        (Grip(True), "close the gripper"),
        (MoveJoints(NOW), "move the lift to 0.60 m, the arm to 0.00 m, the wrist to yaw, pitch and roll of 0, -86, 0 "),
    ],
)
def test_a_motion_says_what_it_is(motion: Motion, words: str) -> None:
    assert str(motion).startswith(words)
