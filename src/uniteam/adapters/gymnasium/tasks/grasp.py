"""Bring what is asked for into the gripper: HomeRobot's `gaze`, and a skill of ours that uses the arm as well."""

from dataclasses import dataclass

import numpy as np

from uniteam.adapters.gymnasium.controls import ARM, BASE, GRIP, MANIPULATION_MODE, Columns
from uniteam.adapters.gymnasium.open_home import OpenHome
from uniteam.adapters.gymnasium.rewards import SLACK, SUCCESS
from uniteam.adapters.gymnasium.sensors import (
    DEPTH,
    JOINTS,
    OBJECT_EMBEDDING,
    OBJECTS,
    START_RECEPTACLE,
    START_RECEPTACLES,
)
from uniteam.adapters.gymnasium.starts import reachable, start_before
from uniteam.adapters.gymnasium.task import Measures, Referee, Task, Verdict
from uniteam.interface import Action
from uniteam.world.simulation.graspable import GraspRule
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.episode import Episode
from uniteam.world.task.grasp_rules import take_what_is_pointed_at

MOST_STEPS = 300
DISTANCE_REWARD = 2.0
"""Of a metre by which the gripper has come nearer to the nearest object that counts."""
RIGHT_GRASP, WRONG_GRASP = 2.0, -0.5
GAZE_RANGE = (0.1, 0.8)
"""How far the object at the middle of the picture may be from the base on the floor (m)."""


@dataclass(frozen=True)
class Penalties:
    """What costs something.

    Attributes:
        blocked: a step in which something was in the base's way.
        touch: a step in which a link of the robot touches what is no small object; it ends the episode where it costs.
    """

    blocked: float
    touch: float = 0.0


class GraspReferee:
    """Rewards to come nearer with the gripper and to take the right object; whatever is taken ends the episode."""

    def __init__(self, place: OpenHome, episode: Episode, grasp_rule: GraspRule, penalties: Penalties) -> None:
        """Begin where the robot stands now."""
        self.grasp_rule = grasp_rule
        self._place, self._penalties = place, penalties
        self._wanted = {candidate.name for candidate in episode.objects}
        self._distance = self._nearest()
        self._grasped: str | None = None

    def judge(self, action: Action, events: StepEvents) -> Verdict:
        """Reward a step."""
        reward = SLACK - self._penalties.blocked * events.blocked
        is_over = bool(self._penalties.touch) and events.touches.robot_scene is not None
        reward -= self._penalties.touch * is_over
        if events.grasped is not None:
            self._grasped = events.grasped
            is_right = events.grasped in self._wanted
            return Verdict(reward + (RIGHT_GRASP + SUCCESS if is_right else WRONG_GRASP), True, is_right)
        before, self._distance = self._distance, self._nearest()
        return Verdict(reward + DISTANCE_REWARD * round(before - self._distance, 3), is_over)

    def measures(self) -> Measures:
        """Return the distance from the grasp centre to the nearest object that counts (m), and whether it is held."""
        return {"distance_to_object": self._distance, "has_right_object": self._grasped in self._wanted}

    def _nearest(self) -> float:
        simulator = self._place.simulator
        gripper = simulator.gripper_to_world()[:3, 3]
        return float(min(np.linalg.norm(simulator.object_pose(name)[:3, 3] - gripper) for name in self._wanted))


def take_what_is_gazed_at(place: OpenHome) -> GraspRule:
    """Return the rule that takes the small object at the middle pixel, where it is 0.1 to 0.8 m from the base."""

    def rule(things: object) -> str | None:
        instances = place.simulator.render_geometry().instances
        index = int(instances[instances.shape[0] // 2, instances.shape[1] // 2])
        if index < 0 or not place.home.instances[index].movable:
            return None
        name = place.home.instances[index].name
        x, y = place.middle(name)
        return name if GAZE_RANGE[0] <= place.simulator.base.distance_to(x, y) <= GAZE_RANGE[1] else None

    return GraspRule(rule)


def _begin_gaze(place: OpenHome, episode: Episode, generator: np.random.Generator) -> Referee:
    _begin(place, episode, generator)
    return GraspReferee(place, episode, take_what_is_gazed_at(place), Penalties(blocked=1.0))


def _begin_pick(place: OpenHome, episode: Episode, generator: np.random.Generator) -> Referee:
    _begin(place, episode, generator)
    return GraspReferee(place, episode, GraspRule(take_what_is_pointed_at), Penalties(blocked=1.0, touch=6.0))


def _begin(place: OpenHome, episode: Episode, generator: np.random.Generator) -> None:
    place.simulator.reset(episode.start)
    start_before(place, reachable(episode.objects, "object"), generator)


_SENSORS = (DEPTH, OBJECTS, START_RECEPTACLES, OBJECT_EMBEDDING, START_RECEPTACLE, JOINTS)

GAZE = Task("Gaze", MOST_STEPS, _SENSORS, {"continuous": Columns((*BASE, "head_tilt", GRIP))}, _begin_gaze)
PICK = Task(
    "Pick",
    MOST_STEPS,
    _SENSORS,
    {"continuous": Columns((*BASE, *ARM, "head_tilt", GRIP, MANIPULATION_MODE))},
    _begin_pick,
)
