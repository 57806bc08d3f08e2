"""What the agent makes of attempts that failed: other places to stand at, and targets to give up."""

import numpy as np
from worlds.box_world import Box, observe
from worlds.driving import EXACT_MAP

from uniteam.geometry import BasePose
from uniteam.interface import Instruction
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.navigation.goals.exploration import any_goal_receptacle
from uniteam.mind.navigation.goals.failed_attempts import Miss, Misses
from uniteam.mind.perception.vocabulary import role_scores

BED = Box((1.5, -0.5, 0.0), (2.5, 0.5, 0.5), "bed")
WALL = Box((1.25, -2.0, 0.0), (1.35, 0.6, 2.5))
HERE = BasePose(0.0, 0.0, 0.0)


def map_of(*boxes: Box) -> BirdsEyeMap:
    """Return the map after looking around from a metre to the left of the bed and from the start."""
    bird_map = BirdsEyeMap(EXACT_MAP)
    for base in (HERE, BasePose(1.0, 1.6, -0.8), BasePose(2.0, 1.6, -1.6)):
        observation = observe(boxes, base)
        assert observation.truth is not None
        bird_map.update(observation, observation.truth, role_scores(Instruction("cup", "table", "bed")))
    return bird_map


def stands_within(bird_map: BirdsEyeMap, goal: Goal, x: float, y: float, radius: float) -> int:
    points = bird_map.to_points(np.argwhere(goal.cells))
    return int(np.count_nonzero(np.hypot(points[:, 0] - x, points[:, 1] - y) < radius))


def test_without_a_miss_the_choice_is_left_alone() -> None:
    assert Misses().avoided_by(any_goal_receptacle) is any_goal_receptacle


def test_after_a_miss_the_robot_stands_elsewhere_and_faces_the_same_thing() -> None:
    bird_map = map_of(BED)
    misses = Misses()
    misses.add(Miss(BasePose(1.1, 0.0, 0.0), (1.6, 0.0)))
    goal = misses.avoided_by(any_goal_receptacle)(bird_map, HERE)
    assert goal is not None and goal.face is not None and goal.distance == 0.0
    assert stands_within(bird_map, goal, 1.1, 0.0, 0.25) == 0
    assert stands_within(bird_map, goal, 1.2, 0.5, 0.1) > 0
    assert goal.face.any()


def test_what_was_missed_three_times_is_given_up_until_all_is_forgotten() -> None:
    bird_map = map_of(BED)
    misses = Misses(same_target=2.0)
    for y in (-0.4, 0.0, 0.4):
        misses.add(Miss(BasePose(1.1, y, 0.0), (1.8, y)))
    assert misses.avoided_by(any_goal_receptacle)(bird_map, HERE) is None
    misses.forget()
    assert misses.avoided_by(any_goal_receptacle)(bird_map, HERE) is not None
    assert misses.count == 3


def test_after_a_miss_no_place_behind_a_wall_is_offered() -> None:
    bird_map = map_of(BED, WALL)
    misses = Misses()
    misses.add(Miss(BasePose(3.0, 0.0, 0.0), (2.4, 0.0)))
    goal = misses.avoided_by(any_goal_receptacle)(bird_map, HERE)
    assert goal is not None
    assert stands_within(bird_map, goal, 1.1, -0.1, 0.1) == 0
    assert stands_within(bird_map, goal, 2.0, 0.8, 0.1) > 0
