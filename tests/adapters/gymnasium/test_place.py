"""Rewards and the ends of placing, term by term."""

import math

import numpy as np
import pytest
from worlds.judged_scene import EPISODE, ON_THE_TABLE

from uniteam.adapters.gymnasium.open_home import OpenHome
from uniteam.adapters.gymnasium.task import Verdict
from uniteam.adapters.gymnasium.tasks.place import PLACE, PlaceReferee
from uniteam.interface import DiscreteAction
from uniteam.world.simulation.step_events import NOTHING, StepEvents
from uniteam.world.simulation.touches import Touches

SLACK = -0.005
WAIT = DiscreteAction.EMPTY_ACTION


@pytest.fixture
def referee(room: OpenHome) -> PlaceReferee:
    return PlaceReferee(room, EPISODE, "cup")


def let_go(room: OpenHome, referee: PlaceReferee, x: float, y: float, z: float) -> Verdict:
    """Let the cup be released somewhere."""
    pose = np.eye(4)
    pose[:3, 3] = (x, y, z)
    room.simulator.physics.set_pose("cup", pose)
    room.simulator.physics.advance(0.032)
    return referee.judge(DiscreteAction.DESNAP_OBJECT, StepEvents(released="cup"))


def wait(room: OpenHome, referee: PlaceReferee, most: int) -> list[Verdict]:
    """Let steps pass until the episode is over."""
    verdicts: list[Verdict] = []
    while len(verdicts) < most and not (verdicts and verdicts[-1].is_over):
        room.simulator.physics.advance(0.032)
        verdicts.append(referee.judge(WAIT, NOTHING))
    return verdicts


def test_to_carry_costs_the_slack_and_a_blocked_base_a_twentieth(referee: PlaceReferee) -> None:
    assert referee.judge(WAIT, NOTHING) == Verdict(SLACK)
    assert referee.judge(WAIT, StepEvents(blocked=True)).reward == pytest.approx(SLACK - 0.05)


def test_a_touch_costs_six_and_ends_the_episode(referee: PlaceReferee) -> None:
    verdict = referee.judge(WAIT, StepEvents(touches=Touches(robot_scene="table")))
    assert (verdict.reward, verdict.is_over, verdict.is_success) == (pytest.approx(SLACK - 6.0), True, False)
    assert referee.judge(WAIT, StepEvents(touches=Touches(robot_obj="ball", obj_scene="table"))).is_over is False


def test_on_the_goal_it_is_worth_five_once_and_ten_after_fifty_steps_of_rest(
    room: OpenHome, referee: PlaceReferee
) -> None:
    x, y, z = ON_THE_TABLE
    verdicts = [let_go(room, referee, x, y, z + 0.02), *wait(room, referee, 80)]
    rewards = [verdict.reward - SLACK for verdict in verdicts]
    arrival = next(step for step, reward in enumerate(rewards) if reward > 1.0)
    assert rewards[arrival] == pytest.approx(5.0)
    assert arrival <= 20
    assert rewards[-1] == pytest.approx(10.0)
    assert sum(rewards) == pytest.approx(15.0)
    assert (verdicts[-1].is_over, verdicts[-1].is_success) == (True, True)
    assert 49 <= len(verdicts) - 1 - arrival < 75


def test_elsewhere_it_costs_one_after_twenty_steps_and_ends_the_episode(room: OpenHome, referee: PlaceReferee) -> None:
    assert let_go(room, referee, 3.5, 3.5, 0.02) == Verdict(SLACK)
    verdicts = wait(room, referee, 80)
    assert len(verdicts) == 20
    assert verdicts[:-1] == [Verdict(SLACK)] * 19
    assert (verdicts[-1].reward, verdicts[-1].is_over) == (pytest.approx(SLACK - 1.0), True)
    assert verdicts[-1].is_success is False


def test_it_begins_at_a_view_point_of_the_goal_with_the_object_in_the_hand(room: OpenHome) -> None:
    for seed in range(5):
        PLACE.begin(room, EPISODE, np.random.default_rng(seed))
        base = room.simulator.base
        assert (base.x, base.y) in EPISODE.goal_receptacles[0].view_points
        assert abs(base.bearing_to(2.0, 1.0)) < math.radians(60.0)
        assert room.simulator.held == "cup"
