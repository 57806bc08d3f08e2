"""An episode told in words: one line for each thing that matters."""

from collections.abc import Callable

from uniteam.evaluation.episode_loop import Step
from uniteam.geometry import BasePose
from uniteam.interface import BaseDisplacement, DiscreteAction
from uniteam.visualization.captions import describe_action, new_milestones
from uniteam.world.task.measures import Measures

STILL = 0.01
"""A base that was told to drive and moved less than this (m) was blocked."""

_TOLD = (DiscreteAction.SNAP_OBJECT, DiscreteAction.DESNAP_OBJECT, DiscreteAction.STOP)


class Narrator:
    """Watches an episode and says what changes: states, grasps, blocked drives, collisions, measures."""

    def __init__(self, say: Callable[[int, str, str], None]) -> None:
        """Begin with an episode's first step.

        Args:
            say: takes the step's number, the kind of news ("state", "action", "trouble" or "success") and a sentence.
        """
        self._say = say
        self._before: Step | None = None
        self._blocked = False

    def __call__(self, step: Step) -> None:
        """Tell what is new in a step."""
        number = step.observation.step
        self._tell_body(step, number)
        if self._before is None or step.decision.state != self._before.decision.state:
            self._say(number, "state", f"{step.decision.state}: {step.decision.reason}")
        elif step.decision.action in _TOLD:
            self._say(number, "action", f"{describe_action(step.decision.action)}: {step.decision.reason}")
        self._tell_measures(step, number)
        self._before = step

    def _tell_body(self, step: Step, number: int) -> None:
        """Tell what the last action came to, as the robot feels it now."""
        if self._before is None:
            return
        was, now = self._before.observation, step.observation
        if now.is_holding != was.is_holding:
            self._say(number, "success", "The gripper holds something." if now.is_holding else "The gripper is empty.")
        blocked = _drives(self._before) and _distance(was.base_to_start, now.base_to_start) < STILL
        if blocked and not self._blocked:
            self._say(number, "trouble", "The base was blocked.")
        self._blocked = blocked or (self._blocked and not _drives(self._before))

    def _tell_measures(self, step: Step, number: int) -> None:
        before = self._before.measures if self._before is not None else Measures()
        for words in new_milestones(before, step.measures):
            self._say(number, "success", f"Measure reached: {words}.")
        if step.measures.robot_scene_colls > before.robot_scene_colls:
            self._say(number, "trouble", "Arm, gripper or load touched the scene.")


def _drives(step: Step) -> bool:
    action = step.decision.action
    return action is DiscreteAction.MOVE_FORWARD or (
        isinstance(action, BaseDisplacement) and bool(action.x or action.y)
    )


def _distance(a: BasePose, b: BasePose) -> float:
    return a.distance_to(b.x, b.y)
