"""What a skill is: moves that are answered with views; a learned policy is one too."""

import math
from dataclasses import replace

from worlds.arm_world import ArmWorld, play
from worlds.box_world import Box

from uniteam.geometry import BasePose
from uniteam.interface import Action, BaseDisplacement, Instruction
from uniteam.mind.manipulation.pick.pick import BASELINE_PICK, PickResult, object_points, pick
from uniteam.mind.skills.skill import Move, Skill
from uniteam.mind.skills.view import View

INSTRUCTION = Instruction("cup", "table", "bed")


def network(view: View) -> Action | None:
    """Stand in for a trained network: turn left until the object is in view."""
    return None if len(object_points(view)) else BaseDisplacement(heading=math.radians(20.0))


def learned_search(view: View) -> Skill[View]:
    """Search for the object as a network that maps views to actions wants it."""
    while (action := network(view)) is not None:
        view = yield Move(action, "The network wants it so.")
    return view


def test_a_learned_policy_is_a_skill_and_takes_its_place_in_a_pick() -> None:
    table = Box((0.1, 0.4, 0.0), (0.9, 0.9, 0.7), "table")
    world = ArmWorld((table, Box((0.46, 0.46, 0.7), (0.54, 0.54, 0.8), "cup")), BasePose(0.0, 0.0, 0.0))
    config = replace(BASELINE_PICK, look_around=learned_search)
    result, actions = play(world, INSTRUCTION, lambda view: pick(view, config))
    assert isinstance(result, PickResult)
    assert world.held is not None
    assert BaseDisplacement(heading=math.radians(20.0)) in actions
