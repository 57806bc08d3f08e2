"""Fingers take what they close around, and nothing else."""

from collections.abc import Iterator

import numpy as np
import pytest
from worlds.judged_scene import EPISODE
from worlds.small_home import small_home

from uniteam.geometry import BasePose
from uniteam.interface import DiscreteAction, JointDisplacement, Joints
from uniteam.stretch import FULL_OPENING, HEAD_CAMERA_HALF
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.home import Instance
from uniteam.world.physics.arm_shapes import FINGER_GAP
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.grasp_rules import arm, challenge

ARM, SNAP, DESNAP = arm(EPISODE), DiscreteAction.SNAP_OBJECT, DiscreteAction.DESNAP_OBJECT
MUG, BOWL = "cup_kl_coffee_mug", "bowl_sc_bowl_with_salad"
UNDER_A_FINGER = FULL_OPENING / 2.0 + 0.035
HANGING = JointDisplacement(Joints(0.0, 0.3, wrist_pitch=-0.07))


def lying(name: str, model: str, x: float) -> Instance:
    return Instance(name, model, load_catalogue()[model].category, True, (x, 1.0, 0.0), (1.0, 0.0, 0.0, 0.0), "west")


@pytest.fixture(scope="module")
def shared() -> Simulator:
    things = (lying("mug", MUG, 1.0), lying("other_mug", MUG, 1.5), lying("bowl", BOWL, 0.6))
    return Simulator(small_home(*things, library=load_catalogue()), HEAD_CAMERA_HALF)


@pytest.fixture
def simulator(shared: Simulator) -> Iterator[Simulator]:
    """A robot whose open gripper hangs in the air, away from everything."""
    shared.reset(BasePose(2.0, 2.5, 0.0))
    shared.apply(HANGING, ARM)
    shared.apply(DESNAP, ARM)
    yield shared


def hold_out(simulator: Simulator, name: str, aside: float = 0.0, top: float = 0.05) -> None:
    """Put an object between the fingers, aside along their closing, its top so high above the grasp centre (m)."""
    pose = np.eye(4)
    x, y, z = simulator.gripper_to_world()[:3, 3]
    model = load_catalogue()[MUG if "mug" in name else BOWL]
    pose[:3, 3] = (x + aside, y, z + top - model.size[2])
    simulator.physics.set_pose(name, pose)


def test_what_the_fingers_close_around_is_held_where_it_is(simulator: Simulator) -> None:
    hold_out(simulator, "mug", aside=0.01)
    before = simulator.object_pose("mug")
    events = simulator.apply(SNAP, ARM)
    assert events.grasped == simulator.held == "mug"
    assert events.hit is None
    np.testing.assert_allclose(simulator.object_pose("mug"), before, atol=1e-9)


@pytest.mark.parametrize(
    ("name", "aside", "top"),
    [
        ("mug", 0.036, 0.05),
        ("mug", 0.11, 0.05),
        ("mug", 0.3, 0.05),
        ("mug", 0.0, -0.017),
        ("mug", 0.0, 0.16),
        ("bowl", 0.0, 0.03),
    ],
    ids=[
        "far from the middle",
        "under a finger",
        "beside them",
        "below the tips",
        "up to the palm",
        "wider than they open",
    ],
)
def test_nothing_is_taken_that_they_do_not_close_around(
    simulator: Simulator, name: str, aside: float, top: float
) -> None:
    hold_out(simulator, name, aside, top)
    assert simulator.apply(SNAP, ARM).grasped is None


def test_nothing_is_taken_where_a_finger_meets_something_else_first(simulator: Simulator) -> None:
    hold_out(simulator, "mug", aside=-0.02)
    hold_out(simulator, "other_mug", aside=0.01)
    assert simulator.apply(SNAP, ARM).grasped is None


def test_closed_fingers_take_nothing(simulator: Simulator) -> None:
    simulator.apply(SNAP, ARM)
    hold_out(simulator, "mug")
    assert simulator.apply(SNAP, ARM).grasped is None


def test_open_fingers_touch_what_closed_ones_do_not(simulator: Simulator) -> None:
    hold_out(simulator, "other_mug", aside=UNDER_A_FINGER)
    assert simulator.apply(DiscreteAction.EMPTY_ACTION, ARM).touches.robot_obj == "other_mug"
    simulator.apply(SNAP, ARM)
    hold_out(simulator, "other_mug", aside=UNDER_A_FINGER)
    assert simulator.apply(DiscreteAction.EMPTY_ACTION, ARM).touches.robot_obj is None


def test_the_challenges_fingers_do_not_move(simulator: Simulator) -> None:
    rule = challenge(EPISODE)
    assert rule.opening == FINGER_GAP
    simulator.apply(DESNAP, rule)
    hold_out(simulator, "other_mug", aside=UNDER_A_FINGER)
    assert simulator.apply(DiscreteAction.EMPTY_ACTION, rule).touches.robot_obj is None
