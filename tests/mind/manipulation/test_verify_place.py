"""Looking where the object is after the release."""

from dataclasses import replace

import pytest
from worlds.arm_world import ArmWorld, play
from worlds.box_world import Box
from worlds.filled import filled

from uniteam.geometry import BasePose
from uniteam.interface import DiscreteAction, Instruction
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.manipulation.place.place import PlaceConfig
from uniteam.stretch import MANIPULATION_POSTURE

INSTRUCTION = Instruction("cup", "sofa", "table")
TABLE = Box((-0.5, -1.3, 0.0), (0.5, -0.6, 0.6), "table")
ON_TABLE = Box((-0.04, -0.84, 0.6), (0.04, -0.76, 0.7), "cup")
ON_FLOOR = Box((-0.3, -0.52, 0.0), (-0.22, -0.44, 0.1), "cup")
ON_BOX = Box((-0.04, -0.84, 0.8), (0.04, -0.76, 0.9), "cup")
BOX_ON_TABLE = Box((-0.15, -0.95, 0.6), (0.15, -0.65, 0.8), "box")


def placing(*improvements: str) -> PlaceConfig:
    return improved(BASELINE, improvements).place


def standing_beside(*boxes: Box) -> ArmWorld:
    world = ArmWorld((TABLE, *boxes), BasePose(0.0, 0.0, 0.0))
    world.joints = MANIPULATION_POSTURE
    return world


@pytest.mark.parametrize(
    ("boxes", "lies_at"),
    [
        ((ON_TABLE,), None),
        ((ON_FLOOR,), (-0.26, -0.48)),
        ((ON_BOX, BOX_ON_TABLE), (0.0, -0.8)),
        ((), None),
    ],
    ids=["on the receptacle", "on the floor", "on a box on the receptacle", "out of sight"],
)
def test_verify_place_sees_where_the_object_lies(boxes: tuple[Box, ...], lies_at: tuple[float, float] | None) -> None:
    lying, _ = play(standing_beside(*boxes), INSTRUCTION, placing("verify_place").verify)
    assert (lying is None) is (lies_at is None)
    if lying is not None and lies_at is not None:
        assert (lying.x, lying.y) == pytest.approx(lies_at, abs=0.06)


def test_the_baseline_takes_it_for_placed_wherever_it_lies() -> None:
    lying, actions = play(standing_beside(ON_FLOOR), INSTRUCTION, placing().verify)
    assert lying is None
    assert actions == []


def test_verify_place_waits_only_until_what_it_sees_has_been_still_for_long_enough() -> None:
    _, watched = play(standing_beside(ON_TABLE), INSTRUCTION, placing("verify_place").wait)
    _, unseen = play(standing_beside(), INSTRUCTION, placing("verify_place").wait)
    _, waited = play(standing_beside(ON_TABLE), INSTRUCTION, placing().wait)
    assert set(watched) == {DiscreteAction.EMPTY_ACTION}
    assert (len(watched), len(unseen), len(waited)) == (90, 200, 200)


def test_verify_place_takes_the_arm_out_of_the_picture_of_what_it_has_let_go() -> None:
    world = standing_beside()
    world.joints = replace(MANIPULATION_POSTURE, arm=0.3)
    _, actions = play(world, INSTRUCTION, placing("verify_place").wait)
    assert world.joints.arm == 0.0
    assert all(action is DiscreteAction.EMPTY_ACTION for action in filled(actions[:10]))
    seen = standing_beside(ON_TABLE)
    seen.joints = replace(MANIPULATION_POSTURE, arm=0.3)
    play(seen, INSTRUCTION, placing("verify_place").wait)
    assert seen.joints.arm == pytest.approx(0.3)
