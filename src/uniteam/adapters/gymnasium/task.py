"""What makes an environment of a home: what is seen, what can be done, where it begins, what is rewarded."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from uniteam.adapters.gymnasium.controls import Controls
from uniteam.adapters.gymnasium.open_home import OpenHome
from uniteam.adapters.gymnasium.sensors import Sensor
from uniteam.interface import Action
from uniteam.world.simulation.graspable import GraspRule
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.episode import Episode

Measures = dict[str, Any]
"""Numbers and truth values by name, for `info`."""


@dataclass(frozen=True)
class Verdict:
    """What one step was worth.

    Attributes:
        reward: for the step.
        is_over: whether the episode has come to its end by the rules of the task, its step limit left aside.
        is_success: whether it has been solved.
    """

    reward: float
    is_over: bool = False
    is_success: bool = False


class Referee(Protocol):
    """Watches one episode of a task.

    Attributes:
        grasp_rule: which object the gripper takes when it snaps.
    """

    grasp_rule: GraspRule

    def judge(self, action: Action, events: StepEvents) -> Verdict:
        """Say what the step was worth that has just been done, in the home as it is now."""

    def measures(self) -> Measures:
        """Return how it stands."""


@dataclass(frozen=True)
class Task:
    """What is to be learned.

    Attributes:
        name: of the environment ("Gaze").
        most_steps: after so many the episode is truncated.
        sensors: what is observed.
        controls: ways to act, by name; the first is the usual one.
        begin: puts the robot where the episode begins and returns who watches it; all chance is the generator's.
    """

    name: str
    most_steps: int
    sensors: tuple[Sensor, ...]
    controls: Mapping[str, Controls]
    begin: Callable[[OpenHome, Episode, np.random.Generator], Referee]
