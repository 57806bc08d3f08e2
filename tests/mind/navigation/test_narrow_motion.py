"""Small and exact motions where the discrete ones do not fit."""

import math
from dataclasses import replace

import numpy as np
import pytest
from worlds.box_world import RADIUS, Box, clearance, observe, room
from worlds.driving import INSTRUCTION, SMALL_CAMERA

from uniteam.geometry import BasePose
from uniteam.grid import disc_mask
from uniteam.interface import Action, BaseDisplacement, DiscreteAction
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.planning.planner import Planner
from uniteam.mind.perception.vocabulary import role_scores

HALF_GAP = 0.32
"""m; half the width of the way between two cupboards, 2 cm more than the robot needs on each side."""
CUPBOARDS = (Box((1.0, -2.0, 0.0), (2.0, -HALF_GAP, 1.2)), Box((1.0, HALF_GAP, 0.0), (2.0, 2.0, 1.2)))
HOME = (*room(-2.0, -2.0, 4.0, 2.0), *CUPBOARDS)


def moved(base: BasePose, action: Action | None) -> BasePose:
    """Return the base after a motion, which a box in its way stops from happening."""
    discrete = {
        DiscreteAction.TURN_LEFT: BaseDisplacement(heading=math.radians(30)),
        DiscreteAction.TURN_RIGHT: BaseDisplacement(heading=math.radians(-30)),
        DiscreteAction.MOVE_FORWARD: BaseDisplacement(x=0.25),
    }
    motion = action if isinstance(action, BaseDisplacement) else discrete[action]  # type: ignore[index]
    ends = [base.compose(BasePose(share * motion.x, 0.0, 0.0)) for share in np.linspace(0.0, 1.0, 13)]
    if any(clearance(HOME, end) < RADIUS for end in ends):
        return base
    return replace(ends[-1], heading=ends[-1].heading + motion.heading)


def drive_through_the_gap(steps: int, *improvements: str) -> tuple[BasePose, int]:
    """Let a planner drive to the other end of the room; return where it came and how often it was blocked."""
    config = improved(BASELINE, improvements)
    bird_map, planner, base, blocked = BirdsEyeMap(config.map), Planner(config.planner), BasePose(-1.0, 0.4, 0.0), 0
    for _ in range(steps):
        observation = observe(HOME, base, SMALL_CAMERA)
        assert observation.truth is not None
        bird_map.update(observation, observation.truth, role_scores(INSTRUCTION))
        planner.notice(bird_map, base)
        cells = disc_mask(bird_map.shape, bird_map.to_cell(3.0, 0.0), 2)
        plan = planner.plan(bird_map, base, Goal(GoalKind.FRONTIER, cells, distance=0.0))
        if plan.action is None:
            break
        planner.begin(plan, bird_map, base)
        after = moved(base, plan.action)
        blocked += after == base
        base = after
    return base, blocked


@pytest.mark.parametrize("others", [("collision_mapping", "true_radius", "clearance_cost")])
def test_narrow_motion_drives_through_a_gap_at_which_others_fail(others: tuple[str, ...]) -> None:
    without, _ = drive_through_the_gap(80, *others)
    through, blocked = drive_through_the_gap(80, *others, "narrow_motion")
    assert without.x < 2.0
    assert through.x > 2.3
    assert blocked <= 3


def test_where_there_is_room_the_robot_moves_in_the_challenge_s_steps() -> None:
    config = improved(BASELINE, {"narrow_motion"})
    open_room = room(-3.0, -3.0, 3.0, 3.0)
    bird_map, base = BirdsEyeMap(config.map), BasePose(0.0, 0.0, 0.0)
    observation = observe(open_room, base, SMALL_CAMERA)
    assert observation.truth is not None
    bird_map.update(observation, observation.truth, role_scores(INSTRUCTION))
    for bearing, action in (
        (0.0, DiscreteAction.MOVE_FORWARD),
        (0.6, DiscreteAction.TURN_LEFT),
        (-2.0, DiscreteAction.TURN_RIGHT),
    ):
        cells = disc_mask(bird_map.shape, bird_map.to_cell(1.5 * math.cos(bearing), 1.5 * math.sin(bearing)), 0)
        plan = Planner(config.planner).plan(bird_map, base, Goal(GoalKind.FRONTIER, cells, distance=0.0))
        assert plan.action is action


@pytest.mark.parametrize("bearing", np.radians([1.0, 2.0, -3.0, 4.9, 5.0, 5.002, -7.0, 12.0]))
def test_in_a_gap_two_turns_at_most_bring_the_robot_to_any_heading(bearing: float) -> None:
    config = improved(BASELINE, {"narrow_motion"})
    bird_map, base = BirdsEyeMap(config.map), BasePose(1.3, 0.0, -float(bearing))
    for heading in np.radians([0.0, 90.0, 180.0, 270.0]):
        observation = observe(HOME, BasePose(0.2, 0.0, float(heading)), SMALL_CAMERA)
        assert observation.truth is not None
        bird_map.update(observation, observation.truth, role_scores(INSTRUCTION))
    cells = disc_mask(bird_map.shape, bird_map.to_cell(2.6, 0.0), 1)
    actions: list[Action | None] = []
    for _ in range(3):
        plan = Planner(config.planner).plan(bird_map, base, Goal(GoalKind.FRONTIER, cells, distance=0.0))
        actions.append(plan.action)
        base = moved(base, plan.action)
    assert base.x > 1.4, actions
