"""Keep an episode's actions while it is played, and nothing else."""

from pathlib import Path

from uniteam.evaluation.episode_loop import Step
from uniteam.evaluation.recording.action_file import write_actions
from uniteam.evaluation.recording.provenance import Provenance
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.interface import Action
from uniteam.world.task.check_action import checked_action
from uniteam.world.task.environment import Environment


class ActionRecorder:
    """An observer that keeps what was done."""

    def __init__(self, environment: Environment, provenance: Provenance) -> None:
        """Begin with an environment whose episode has not begun, or was reset."""
        self._agent, self._episode = provenance.agent, environment.episode.id
        self._actions: list[Action] = []

    def __call__(self, step: Step) -> None:
        """Take a step in."""
        self._actions.append(checked_action(step.decision.action))

    def write(self, path: Path, result: EpisodeResult) -> None:
        """Write the actions; raises UnwritableError, and what was there before is still there."""
        write_actions(path, self._agent, self._episode, self._actions)
