"""Which object the gripper takes, by the challenge's rule and by the honest one."""

import pytest
from worlds.judged_scene import EPISODE

from uniteam.errors import UnknownNameError
from uniteam.world.simulation.graspable import Graspable
from uniteam.world.task.grasp_rules import challenge, grasp_rule_named, honest


def thing(
    name: str, distance: float = 0.5, category: str = "cup", in_view: bool = True, in_centre: bool = True
) -> Graspable:
    return Graspable(name, category, distance, in_view, in_centre)


CHALLENGE, HONEST = challenge(EPISODE).choose, honest(EPISODE).choose
"""The episode asks for the class `cup`, and its one candidate is named `cup`."""


def test_the_challenge_takes_the_candidate_though_something_else_is_nearer_and_pointed_at() -> None:
    things = (thing("cup", 0.7, in_centre=False), thing("other_cup", 0.1), thing("ball", 0.1, "ball"))
    assert CHALLENGE(things) == "cup"


def test_the_challenge_takes_a_hidden_candidate_if_something_of_its_class_is_in_view() -> None:
    hidden = thing("cup", in_view=False, in_centre=False)
    assert CHALLENGE((hidden, thing("other_cup", 3.0))) == "cup"
    assert CHALLENGE((hidden, thing("ball", 0.3, "ball"))) is None
    assert CHALLENGE((hidden,)) is None


def test_the_honest_gripper_takes_the_nearest_thing_that_it_is_pointed_at_whatever_it_is() -> None:
    things = (thing("cup", 0.5), thing("ball", 0.4, "ball"), thing("other_cup", 0.1, in_centre=False))
    assert HONEST(things) == "ball"
    assert HONEST((thing("other_cup", 0.1, in_centre=False),)) is None


@pytest.mark.parametrize("rule", [CHALLENGE, HONEST])
def test_nothing_is_taken_from_beyond_the_range(rule: object) -> None:
    assert callable(rule)
    assert rule((thing("cup", 0.79),)) == "cup"
    assert rule((thing("cup", 0.81),)) is None
    assert rule(()) is None


def test_an_unknown_rule_is_answered_with_the_nearest() -> None:
    assert grasp_rule_named("honest") is honest
    with pytest.raises(UnknownNameError, match="honest"):
        grasp_rule_named("honst")
