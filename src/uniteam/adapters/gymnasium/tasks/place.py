"""Put the held object down on a goal receptacle without touching anything: HomeRobot's `place`."""

import numpy as np

from uniteam.adapters.gymnasium.controls import ARM, BASE, GRIP, MANIPULATION_MODE, Columns
from uniteam.adapters.gymnasium.open_home import OpenHome
from uniteam.adapters.gymnasium.rewards import SLACK, SUCCESS
from uniteam.adapters.gymnasium.sensors import (
    DEPTH,
    GOAL_RECEPTACLE,
    GOAL_RECEPTACLES,
    IS_HOLDING,
    JOINTS,
    OBJECT_EMBEDDING,
)
from uniteam.adapters.gymnasium.starts import reachable, start_before, take_object
from uniteam.adapters.gymnasium.task import Measures, Referee, Task, Verdict
from uniteam.interface import Action
from uniteam.world.simulation.graspable import TAKE_NOTHING, GraspRule
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.episode import Episode
from uniteam.world.task.judge import REST_STEPS, lies_on, rests_on

MOST_STEPS = 350
PLACED = 5.0
"""Once, when the object comes to lie on a goal receptacle in time."""
DROPPED = -1.0
"""When it has not; the episode ends."""
STEPS_TO_ARRIVE = 20
"""After its release, in which the object must have come to lie on a goal receptacle."""
BLOCKED = -0.05
"""Of a step in which something was in the base's way."""
TOUCH, TOUCH_END = -1.0, -5.0
"""Of a step in which a link of the robot touches what is no small object, and for the end to which that comes."""


class PlaceReferee:
    """Rewards the object's arrival on a goal receptacle, and its rest there."""

    grasp_rule: GraspRule = TAKE_NOTHING

    def __init__(self, place: OpenHome, episode: Episode, held: str) -> None:
        """Begin with the object in the gripper."""
        self._simulator, self._object = place.simulator, held
        self._goals = {candidate.name for candidate in episode.goal_receptacles}
        self._steps_since_release: int | None = None
        self._has_arrived = False
        self._steps_at_rest = 0

    def judge(self, action: Action, events: StepEvents) -> Verdict:
        """Reward a step."""
        reward = SLACK + BLOCKED * events.blocked
        if events.touches.robot_scene is not None:
            return Verdict(reward + TOUCH + TOUCH_END, True)
        if events.released is not None:
            self._steps_since_release = 0
        elif self._steps_since_release is not None:
            self._steps_since_release += 1
        return self._follow(reward) if self._steps_since_release is not None else Verdict(reward)

    def _follow(self, reward: float) -> Verdict:
        """Watch what was let go of."""
        if not self._has_arrived and lies_on(self._simulator.physics.contacts(self._object), self._goals):
            self._has_arrived = True
            reward += PLACED
        if not self._has_arrived:
            is_late = (self._steps_since_release or 0) >= STEPS_TO_ARRIVE
            return Verdict(reward + DROPPED * is_late, is_late)
        is_at_rest = rests_on(self._simulator, self._object, self._goals)
        self._steps_at_rest = self._steps_at_rest + 1 if is_at_rest else 0
        is_success = self._steps_at_rest >= REST_STEPS
        return Verdict(reward + SUCCESS * is_success, is_success, is_success)

    def measures(self) -> Measures:
        """Return whether the object was let go of, whether it lay on a goal receptacle, and for how many steps."""
        return {
            "is_released": self._steps_since_release is not None,
            "has_arrived": self._has_arrived,
            "steps_at_rest": self._steps_at_rest,
        }


def _begin(place: OpenHome, episode: Episode, generator: np.random.Generator) -> Referee:
    held = take_object(place, episode, generator)
    start_before(place, reachable(episode.goal_receptacles, "goal receptacle"), generator)
    return PlaceReferee(place, episode, held)


PLACE = Task(
    "Place",
    MOST_STEPS,
    (DEPTH, GOAL_RECEPTACLES, OBJECT_EMBEDDING, GOAL_RECEPTACLE, JOINTS, IS_HOLDING),
    {"continuous": Columns((*BASE, *ARM, GRIP, MANIPULATION_MODE))},
    _begin,
)
