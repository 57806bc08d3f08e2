"""The whole task of the challenge, judged as the evaluation judges it; the return is the partial success."""

from dataclasses import asdict

import numpy as np

from uniteam.adapters.gymnasium.controls import (
    ARM,
    BASE,
    EVERY_ACTION,
    GRIP,
    MANIPULATION_MODE,
    NAVIGATION_MODE,
    STOP,
    Columns,
    Metric,
)
from uniteam.adapters.gymnasium.open_home import OpenHome
from uniteam.adapters.gymnasium.sensors import (
    COMPASS,
    DEPTH,
    GOAL_RECEPTACLE,
    GOAL_RECEPTACLES,
    GPS,
    IS_HOLDING,
    JOINTS,
    OBJECT_EMBEDDING,
    OBJECTS,
    RECEPTACLES,
    RGB,
    START_RECEPTACLE,
    START_RECEPTACLES,
)
from uniteam.adapters.gymnasium.task import Measures, Referee, Task, Verdict
from uniteam.interface import Action, DiscreteAction
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.episode import MAXIMUM_STEPS, Episode
from uniteam.world.task.grasp_rules import EpisodeGraspRule
from uniteam.world.task.judge import Judge


class OvmmReferee:
    """The challenge's judge."""

    def __init__(self, place: OpenHome, episode: Episode, grasp: EpisodeGraspRule) -> None:
        """Begin with nothing achieved."""
        self.grasp_rule = grasp(episode)
        self._simulator = place.simulator
        self._judge = Judge(place.home, episode)

    def judge(self, action: Action, events: StepEvents) -> Verdict:
        """Reward what the partial success has grown by; the episode ends where the robot stops."""
        before, is_stop = self._judge.measures.partial_success, action is DiscreteAction.STOP
        self._judge.update(self._simulator, events, self._simulator.render(), is_stop)
        measures = self._judge.measures
        return Verdict(measures.partial_success - before, is_stop, measures.overall_success)

    def measures(self) -> Measures:
        """Return the challenge's measures."""
        measures = self._judge.measures
        return {
            **asdict(measures),
            "overall_success": measures.overall_success,
            "partial_success": measures.partial_success,
        }


def ovmm(grasp: EpisodeGraspRule) -> Task:
    """Return the task with a rule by which the gripper takes objects."""

    def begin(place: OpenHome, episode: Episode, generator: np.random.Generator) -> Referee:
        place.simulator.reset(episode.start)
        return OvmmReferee(place, episode, grasp)

    arm = Columns((*BASE, *ARM, "head_pan", "head_tilt", GRIP, MANIPULATION_MODE, NAVIGATION_MODE, STOP))
    return Task(
        "OVMM",
        MAXIMUM_STEPS,
        (
            RGB, DEPTH, OBJECTS, START_RECEPTACLES, GOAL_RECEPTACLES, RECEPTACLES,
            OBJECT_EMBEDDING, START_RECEPTACLE, GOAL_RECEPTACLE, GPS, COMPASS, JOINTS, IS_HOLDING,
        ),
        {"discrete": EVERY_ACTION, "continuous": arm, "metric": Metric()},
        begin,
    )  # fmt: skip
