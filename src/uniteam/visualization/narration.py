"""An episode told in words: one line for each thing that matters."""

from collections.abc import Callable
from typing import Protocol

from uniteam.evaluation.episode_loop import Step
from uniteam.interface import BaseDisplacement, Decision, DiscreteAction
from uniteam.visualization.captions import describe_action, new_milestones
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.measures import Measures

_TOLD = (DiscreteAction.SNAP_OBJECT, DiscreteAction.DESNAP_OBJECT, DiscreteAction.STOP)


class Told(Protocol):
    """What is told of a step: the step of an episode that is played has it, and that of a recording."""

    @property
    def decision(self) -> Decision:
        """What the agent decided."""

    @property
    def events(self) -> StepEvents:
        """What the action came to."""

    @property
    def measures(self) -> Measures:
        """The measures once it was done."""


class Narrator:
    """Watches an episode and says what changes: states, grasps, blocked drives, collisions, measures."""

    def __init__(self, say: Callable[[int, str, str], None]) -> None:
        """Begin with an episode's first step.

        Args:
            say: takes the step's number, the kind of news ("state", "action", "trouble" or "success") and a sentence.
        """
        self._say = say
        self._before: Told | None = None
        self._blocked = False

    def __call__(self, step: Step) -> None:
        """Tell what is new in a step that is played."""
        self.tell(step.observation.step, step)

    def tell(self, number: int, step: Told) -> None:
        """Tell what is new in step `number`."""
        if self._before is None or step.decision.state != self._before.decision.state:
            self._say(number, "state", f"{step.decision.state}: {step.decision.reason}")
        elif step.decision.action in _TOLD:
            self._say(number, "action", f"{describe_action(step.decision.action)}: {step.decision.reason}")
        self._tell_events(step, number)
        self._tell_measures(step, number)
        self._before = step

    def _tell_events(self, step: Told, number: int) -> None:
        events = step.events
        if events.grasped is not None:
            self._say(number, "success", f"The gripper has grasped {_words(events.grasped)}.")
        if events.released is not None:
            self._say(number, "success", f"The gripper has let go of {_words(events.released)}.")
        if events.blocked and not self._blocked:
            self._say(number, "trouble", "The base was blocked.")
        self._blocked = events.blocked or (self._blocked and not _drives(step))

    def _tell_measures(self, step: Told, number: int) -> None:
        before = self._before.measures if self._before is not None else Measures()
        for words in new_milestones(before, step.measures):
            self._say(number, "success", f"Measure reached: {words}.")
        if step.measures.robot_scene_colls > before.robot_scene_colls:
            self._say(number, "trouble", f"Arm or gripper touched {_words(step.events.touches.robot_scene)}.")
        if step.measures.obj_scene_colls > before.obj_scene_colls:
            self._say(number, "trouble", f"What the gripper holds touched {_words(step.events.touches.obj_scene)}.")
        if step.measures.robot_obj_colls > before.robot_obj_colls:
            self._say(number, "trouble", f"Arm or gripper touched {_words(step.events.touches.robot_obj)}.")


def _drives(step: Told) -> bool:
    action = step.decision.action
    return action is DiscreteAction.MOVE_FORWARD or (
        isinstance(action, BaseDisplacement) and bool(action.x or action.y)
    )


def _words(instance: str | None) -> str:
    return "something" if instance is None else instance.replace("_", " ")
