"""Places that could not be reached are avoided for a while."""

import pytest
from worlds.box_world import room
from worlds.driving import Drive

from uniteam.geometry import BasePose
from uniteam.grid import disc_mask
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind

NEAR, FAR = (1.0, 0.0), (-1.6, 0.0)


def both_places(bird_map: BirdsEyeMap) -> Goal:
    cells = disc_mask(bird_map.shape, bird_map.to_cell(*NEAR), 1) | disc_mask(bird_map.shape, bird_map.to_cell(*FAR), 1)
    return Goal(GoalKind.FRONTIER, cells, distance=0.0)


@pytest.fixture(scope="module")
def drive() -> Drive:
    return Drive.begin(room(-3.0, -3.0, 3.0, 3.0), BasePose(0.0, 0.0, 0.0))


@pytest.mark.parametrize(("improvements", "led_to"), [((), NEAR), (("failed_goal_memory",), FAR)])
def test_failed_goal_memory_leads_elsewhere_where_the_baseline_goes_back(
    drive: Drive, improvements: tuple[str, ...], led_to: tuple[float, float]
) -> None:
    failed = improved(BASELINE, improvements).failed_goals()
    failed.add((1.1, 0.1), step=0)
    goal = failed.avoid(both_places(drive.bird_map), drive.bird_map, step=1)
    plan = drive.planner.plan(drive.bird_map, drive.base, goal)
    assert plan.reachable
    assert plan.path[-1] == pytest.approx(led_to, abs=0.12)


def test_a_failure_is_remembered_the_longer_the_more_often_it_happened(drive: Drive) -> None:
    failed = improved(BASELINE, {"failed_goal_memory"}).failed_goals()
    goal = both_places(drive.bird_map)

    def avoided_for(begin: int) -> int:
        return next(n for n in range(10_000) if failed.avoid(goal, drive.bird_map, begin + n).shunned is None)

    failed.add(NEAR, step=0)
    assert avoided_for(0) == 100
    failed.add((NEAR[0] + 0.3, NEAR[1]), step=100)
    assert avoided_for(100) == 200
    failed.add(FAR, step=300)
    assert avoided_for(300) == 100


def test_what_was_forgotten_may_be_tried_again(drive: Drive) -> None:
    failed = improved(BASELINE, {"failed_goal_memory"}).failed_goals()
    failed.add(NEAR, step=0)
    failed.forget()
    assert failed.avoid(both_places(drive.bird_map), drive.bird_map, step=1).shunned is None
