"""Drive to where something can be seen, face it, and stop: HomeRobot's `nav_to_obj` and `nav_to_rec`."""

import math
from collections.abc import Mapping

import numpy as np

from uniteam.adapters.gymnasium.controls import BASE, FOUR_MOVES, STOP, Columns, Controls
from uniteam.adapters.gymnasium.goals import Goals, Nearest
from uniteam.adapters.gymnasium.open_home import OpenHome
from uniteam.adapters.gymnasium.rewards import SLACK, SUCCESS
from uniteam.adapters.gymnasium.sensors import (
    COMPASS,
    DEPTH,
    GOAL_RECEPTACLE,
    GPS,
    OBJECT_EMBEDDING,
    OBJECT_GOAL,
    RECEPTACLE_GOAL,
    RECEPTACLES,
    START_RECEPTACLE,
)
from uniteam.adapters.gymnasium.starts import reachable, start_away, take_object
from uniteam.adapters.gymnasium.task import Measures, Referee, Task, Verdict
from uniteam.interface import Action, DiscreteAction
from uniteam.world.simulation.graspable import TAKE_NOTHING, GraspRule
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.episode import Candidate, Episode
from uniteam.world.task.judge import VIEW_COVERAGE

MOST_STEPS = 400
SUCCESS_DISTANCE = 0.5
"""Of the way to the nearest view point (m): a success is nearer."""
SUCCESS_ANGLE = math.radians(15.0)
"""Between the heading and the goal (rad): a success is less."""
TURN_REWARD_DISTANCE = 3.0
"""Nearer than this to a view point (m), turning to the goal is rewarded too."""


class NavigationReferee:
    """Rewards the way to the nearest of some goals, and near it the turn to face it."""

    grasp_rule: GraspRule = TAKE_NOTHING

    def __init__(self, place: OpenHome, goals: tuple[Candidate, ...]) -> None:
        """Begin where the robot stands now."""
        self._simulator = place.simulator
        names = [instance.name for instance in place.home.instances]
        self._indices = [names.index(goal.name) for goal in goals]
        distances = [place.distances(goal) for goal in goals]
        self._goals = Goals(place.simulator.floor, distances, [place.middle(goal.name) for goal in goals])
        self._now = self._goals.nearest(place.simulator.base)
        self._angle = self._now.angle if self._now.distance < TURN_REWARD_DISTANCE else None

    def judge(self, action: Action, events: StepEvents) -> Verdict:
        """Reward what the way and the turn have become shorter by; the episode ends where the robot stops."""
        before, now = self._now, self._look()
        self._now = now
        reward = SLACK + before.distance - now.distance + self._turned(now.distance, now.angle)
        if action is not DiscreteAction.STOP:
            return Verdict(reward)
        is_success = now.distance < SUCCESS_DISTANCE and now.angle < SUCCESS_ANGLE and self._coverage() >= VIEW_COVERAGE
        return Verdict(reward + SUCCESS * is_success, True, is_success)

    def measures(self) -> Measures:
        """Return the way (m), the turn (rad) and the share of the picture that shows the goal."""
        return {
            "distance_to_goal": self._now.distance,
            "angle_to_goal": self._now.angle,
            "coverage": self._coverage(),
        }

    def _look(self) -> Nearest:
        """Return the nearest goal; nothing changes where the base stands on what lay there at first."""
        now = self._goals.nearest(self._simulator.base)
        return now if math.isfinite(now.distance) else self._now

    def _turned(self, distance: float, angle: float) -> float:
        """Return by how much less the robot must turn than when it was within 3 m last."""
        if distance >= TURN_REWARD_DISTANCE:
            return 0.0
        before, self._angle = self._angle, angle
        return 0.0 if before is None else before - angle

    def _coverage(self) -> float:
        instances = self._simulator.render_geometry().instances
        return float(np.count_nonzero(instances == self._indices[self._now.index]) / instances.size)


def _begin_to_object(place: OpenHome, episode: Episode, generator: np.random.Generator) -> Referee:
    goals = reachable(episode.objects, "object")
    place.simulator.reset(episode.start)
    start_away(place, goals, generator)
    return NavigationReferee(place, goals)


def _begin_to_receptacle(place: OpenHome, episode: Episode, generator: np.random.Generator) -> Referee:
    goals = reachable(episode.goal_receptacles, "goal receptacle")
    take_object(place, episode, generator)
    start_away(place, goals, generator)
    return NavigationReferee(place, goals)


_CONTROLS: Mapping[str, Controls] = {"continuous": Columns((*BASE, STOP)), "discrete": FOUR_MOVES}

NAVIGATE_TO_OBJECT = Task(
    "NavigateToObject",
    MOST_STEPS,
    (DEPTH, OBJECT_GOAL, RECEPTACLES, OBJECT_EMBEDDING, START_RECEPTACLE, GPS, COMPASS),
    _CONTROLS,
    _begin_to_object,
)
NAVIGATE_TO_RECEPTACLE = Task(
    "NavigateToReceptacle",
    MOST_STEPS,
    (DEPTH, RECEPTACLE_GOAL, RECEPTACLES, GOAL_RECEPTACLE, GPS, COMPASS),
    _CONTROLS,
    _begin_to_receptacle,
)
