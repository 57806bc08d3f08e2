"""What a worker process does: it opens the split once and plays the episodes it is handed."""

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass

import cv2

from uniteam.errors import DamagedFileError, UniteamError, UnknownNameError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.episode_loop import play_episode, result_of_exception
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.warm_up import warm_up
from uniteam.geometry import PinholeCamera
from uniteam.stretch import HEAD_CAMERA_FULL, HEAD_CAMERA_HALF
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import load_split

CAMERAS = {"half": HEAD_CAMERA_HALF, "full": HEAD_CAMERA_FULL}


def camera_named(name: str) -> PinholeCamera:
    """Return the head camera at half or full size; raises UnknownNameError."""
    if name not in CAMERAS:
        raise UnknownNameError("camera", name, CAMERAS)
    return CAMERAS[name]


@dataclass(frozen=True)
class Attempt:
    """One agent's turn at one episode.

    Attributes:
        agent: the agent's label in the run.
        episode: index of the episode in the split.
    """

    agent: str
    episode: int


class EpisodePlayer:
    """Plays attempts at the episodes of one split."""

    def __init__(self, split: Split, agents: Mapping[str, AgentSpec], camera: PinholeCamera) -> None:
        self._split = split
        self._agents = agents
        self._camera = camera

    def __call__(self, attempt: Attempt) -> EpisodeResult:
        """Play an attempt; an exception becomes a result.

        Raises:
            UniteamError: the home cannot be opened: the split or the pack is at fault, and every episode would crash.
        """
        episode, spec = self._split.episodes[attempt.episode], self._agents[attempt.agent]
        try:
            environment = Environment(self._split.homes[episode.home], episode, self._camera, spec.needs_truth)
        except UniteamError:
            raise
        except Exception as error:
            return result_of_exception(episode, error, steps=0)
        try:
            return play_episode(environment, spec.make(environment))
        except DamagedFileError:
            raise
        except Exception as error:
            return result_of_exception(episode, error, environment.measures.num_steps)


@dataclass(frozen=True)
class PlayerSetup:
    """A recipe for an `EpisodePlayer` that can be sent to another process."""

    split: str
    agents: Mapping[str, AgentSpec]
    camera: str

    def __call__(self) -> EpisodePlayer:
        """Open the split and warm up, so that the next worker finds in the cache what this one had to compile."""
        cv2.setNumThreads(1)
        split, camera = load_split(self.split), camera_named(self.camera)
        episode = split.episodes[0]
        with suppress(Exception):  # whatever is wrong will come up in an episode and be recorded there
            for spec in self.agents.values():
                environment = Environment(split.homes[episode.home], episode, camera, spec.needs_truth)
                warm_up(environment, spec.make(environment))
        return EpisodePlayer(split, self.agents, camera)
