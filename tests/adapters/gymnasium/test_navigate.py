"""Rewards and the end of a navigation, term by term."""

import math

import numpy as np
import pytest
from worlds.gym_scene import stand
from worlds.judged_scene import EPISODE

from uniteam.adapters.gymnasium.open_home import OpenHome
from uniteam.adapters.gymnasium.task import Task
from uniteam.adapters.gymnasium.tasks.navigate import NAVIGATE_TO_OBJECT, NAVIGATE_TO_RECEPTACLE, NavigationReferee
from uniteam.interface import DiscreteAction
from uniteam.world.simulation.step_events import NOTHING, StepEvents

FORWARD, STOP = DiscreteAction.MOVE_FORWARD, DiscreteAction.STOP
SLACK = -0.005
SPOT = (0.9, 1.45)
"""Less than half a metre from the view point (1, 1), and so far from the cup that the camera sees it."""
TO_THE_CUP = math.atan2(0.5 - 1.45, 0.5 - 0.9)


def referee_at(room: OpenHome, x: float, y: float, heading: float) -> NavigationReferee:
    stand(room, x, y, heading)
    return NavigationReferee(room, EPISODE.objects)


def test_a_step_that_changes_nothing_costs_the_slack(room: OpenHome) -> None:
    verdict = referee_at(room, 5.0, 2.0, math.pi).judge(FORWARD, NOTHING)
    assert (verdict.reward, verdict.is_over) == (pytest.approx(SLACK), False)


def test_a_metre_less_of_way_is_worth_one(room: OpenHome) -> None:
    referee = referee_at(room, 0.9, 2.9, -math.pi / 2)
    stand(room, 0.9, 2.4, -math.pi / 2)
    nearer = math.hypot(0.1, 1.9) - math.hypot(0.1, 1.4)
    turned = math.atan2(0.4, 2.4) - math.atan2(0.4, 1.9)
    assert referee.judge(FORWARD, NOTHING).reward == pytest.approx(SLACK + nearer + turned, abs=0.02)


def test_far_away_the_turn_is_worth_nothing_and_near_a_radian_is_worth_one(room: OpenHome) -> None:
    far = referee_at(room, 5.0, 2.0, 0.0)
    stand(room, 5.0, 2.0, math.pi)
    assert far.judge(DiscreteAction.TURN_LEFT, NOTHING).reward == pytest.approx(SLACK)
    near = referee_at(room, 0.9, 2.0, 0.0)
    stand(room, 0.9, 2.0, -0.5)
    assert near.judge(DiscreteAction.TURN_RIGHT, NOTHING).reward == pytest.approx(SLACK + 0.5)
    stand(room, 0.9, 2.0, 0.0)
    assert near.judge(DiscreteAction.TURN_LEFT, NOTHING).reward == pytest.approx(SLACK - 0.5)


def test_to_come_near_is_no_turn(room: OpenHome) -> None:
    referee = referee_at(room, 5.0, 2.0, math.pi)
    before = referee.measures()["distance_to_goal"]
    stand(room, 0.9, 2.5, 0.0)
    gained = before - math.hypot(0.1, 1.5)
    assert before > 3.0
    assert referee.judge(FORWARD, NOTHING).reward == pytest.approx(SLACK + gained, abs=0.02)


def test_a_blocked_drive_costs_nothing_more(room: OpenHome) -> None:
    verdict = referee_at(room, 5.0, 2.0, math.pi).judge(FORWARD, StepEvents(blocked=True))
    assert verdict.reward == pytest.approx(SLACK)


def test_to_stop_before_the_goal_and_see_it_is_a_success_worth_ten(room: OpenHome) -> None:
    referee = referee_at(room, *SPOT, TO_THE_CUP)
    assert referee.measures()["coverage"] >= 0.001
    verdict = referee.judge(STOP, NOTHING)
    assert (verdict.is_over, verdict.is_success, verdict.reward) == (True, True, pytest.approx(SLACK + 10.0))


@pytest.mark.parametrize(
    ("x", "y", "heading"),
    [
        pytest.param(0.9, 1.55, TO_THE_CUP, id="more than half a metre from the view point"),
        pytest.param(*SPOT, TO_THE_CUP + math.radians(16.0), id="turned away by more than 15 degrees"),
        pytest.param(1.0, 1.0, math.radians(-135.0), id="so near that the cup is below the picture"),
    ],
)
def test_to_stop_elsewhere_ends_without_success(room: OpenHome, x: float, y: float, heading: float) -> None:
    verdict = referee_at(room, x, y, heading).judge(STOP, NOTHING)
    assert (verdict.is_over, verdict.is_success, verdict.reward) == (True, False, pytest.approx(SLACK))


def test_where_an_object_lay_at_first_the_way_stays_as_it_was(room: OpenHome) -> None:
    referee = referee_at(room, 1.0, 3.0, 0.0)
    before = referee.measures()["distance_to_goal"]
    stand(room, 1.0, 3.5, 0.0)  # on the ball
    verdict = referee.judge(FORWARD, NOTHING)
    assert referee.measures()["distance_to_goal"] == before
    assert math.isfinite(verdict.reward)


@pytest.mark.parametrize("task", [NAVIGATE_TO_OBJECT, NAVIGATE_TO_RECEPTACLE])
def test_it_begins_on_free_floor_three_metres_of_way_from_the_goal(room: OpenHome, task: Task) -> None:
    starts = []
    for seed in range(10):
        referee = task.begin(room, EPISODE, np.random.default_rng(seed))
        base = room.simulator.base
        assert room.simulator.floor.is_free(base.x, base.y)
        assert referee.measures()["distance_to_goal"] >= 2.95
        starts.append((base.x, base.y, base.heading))
    assert len(set(starts)) == 10


def test_the_object_is_in_the_hand_on_the_way_to_the_receptacle_only(room: OpenHome) -> None:
    NAVIGATE_TO_RECEPTACLE.begin(room, EPISODE, np.random.default_rng(0))
    assert room.simulator.held == "cup"
    NAVIGATE_TO_OBJECT.begin(room, EPISODE, np.random.default_rng(0))
    assert room.simulator.held is None
