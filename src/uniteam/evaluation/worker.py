"""What a worker process does: it opens the split once and plays the episodes it is handed."""

import logging
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from traceback import format_exception
from typing import Any

import cv2

from uniteam.errors import InvalidActionError, InvalidInputError, UniteamError, UnknownNameError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.backends.processes import Lost
from uniteam.evaluation.backends.serving import Charging
from uniteam.evaluation.charged_agent import AgentError, ChargedAgent
from uniteam.evaluation.configuration import Run, resolve
from uniteam.evaluation.episode_loop import Observer, play_episode, result_of_exception
from uniteam.evaluation.recording.order import RecordingOrder, forget_recordings
from uniteam.evaluation.recording.provenance import provenance_of
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.warm_up import warm_up
from uniteam.geometry import PinholeCamera
from uniteam.interface import Agent
from uniteam.mind.agents.registry import AGENTS
from uniteam.stretch import HEAD_CAMERA_FULL, HEAD_CAMERA_HALF
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Split
from uniteam.world.task.grasp_rules import grasp_rule_named
from uniteam.world.task.splits import load_split

CAMERAS = {"half": HEAD_CAMERA_HALF, "full": HEAD_CAMERA_FULL}

MakeAgent = Callable[[AgentSpec, Environment], Agent]

_log = logging.getLogger(__name__)


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

    def __init__(
        self, split: Split, setup: "PlayerSetup", charging: Charging, make_agent: MakeAgent = AgentSpec.make
    ) -> None:
        """Prepare to play; `make_agent` makes of each attempt's specification the agent that plays it."""
        run = setup.run
        self._make_agent = make_agent
        self._split = split
        self._setup = setup
        self._run = run
        self._camera = camera_named(run.camera)
        self._grasp = grasp_rule_named(run.grasp)
        self._charging = charging
        self._open = lru_cache(maxsize=1)(self._opened)

    def __call__(self, attempt: Attempt) -> EpisodeResult | Lost:
        """Play an attempt.

        An exception of the agent, or an action that is none, is its result; an exception of the world, and want of
        memory, is nothing that the agent did.

        Raises:
            UniteamError: the home cannot be opened: the split or the pack is at fault, and every episode would crash.
        """
        episode, spec = self._split.episodes[attempt.episode], self._run.agents[attempt.agent]
        try:
            environment = self._open(episode.home, spec.needs_truth)
            environment.reset(episode)
            return self._play(attempt, environment)
        except UniteamError:
            raise
        except MemoryError as error:
            self._open.cache_clear()
            return Lost("the machine had no memory left", "".join(format_exception(error)))
        except Exception as error:
            self._open.cache_clear()
            reason = f"the simulator failed with {type(error).__name__}: {error}"
            return Lost(reason, "".join(format_exception(error)))

    def _play(self, attempt: Attempt, environment: Environment) -> EpisodeResult:
        """Play the environment's episode; its recording, if there is to be one, is on the disk before its result."""
        order, spec = self._setup.recordings, self._run.agents[attempt.agent]
        forget_recordings(order.folder, attempt.agent, environment.episode.id)
        if environment.episode.id not in order.episodes:
            return self._result(environment, spec, None)
        provenance = provenance_of(attempt.agent, spec, self._run.split, self._setup.configuration)
        recorder = order.kind.begin(environment, provenance)
        result = self._result(environment, spec, recorder)
        if order.is_kept(result):
            recorder.write(order.path(attempt.agent, environment.episode.id), result)
        return result

    def _result(self, environment: Environment, spec: AgentSpec, observer: Observer | None) -> EpisodeResult:
        try:
            agent = ChargedAgent(lambda: self._make_agent(spec, environment), self._charging)
            return play_episode(environment, agent, observer)
        except AgentError as error:
            return result_of_exception(environment.episode, error.__cause__ or error, error.steps)
        except InvalidActionError as error:
            return result_of_exception(environment.episode, error, environment.measures.num_steps)

    def _opened(self, home: str, give_truth: bool) -> Environment:
        """Compile a home, for the first of its episodes; the last one is kept, as a worker stays with its home."""
        first = next(episode for episode in self._split.episodes if episode.home == home)
        return Environment(self._split.homes[home], first, self._camera, give_truth, self._grasp)


@dataclass(frozen=True)
class PlayerSetup:
    """A recipe for an `EpisodePlayer` that can be sent to another process.

    Attributes:
        run: what is evaluated.
        configuration: of the run as it began; a worker that finds another one refuses to play.
        recordings: what is to be recorded.
    """

    run: Run
    configuration: Mapping[str, Any]
    recordings: RecordingOrder

    def __call__(self, charging: Charging) -> EpisodePlayer:
        """Open the split and warm up, so that the next worker finds in the cache what this one had to compile.

        Raises:
            InvalidInputError: code, models or split have changed since the run began.
        """
        cv2.setNumThreads(1)
        split = load_split(self.run.split)
        if resolve(self.run, split) != self.configuration:
            raise InvalidInputError(
                "the code, the models or the split have changed since the run began; "
                "give the same command again with another --out"
            )
        _warm_up(split, self.run)
        return EpisodePlayer(split, self, charging)


def _warm_up(split: Split, run: Run) -> None:
    """Have compiled what is uniteam's own; agents and perceptions from outside may hang, and have a clock later."""
    episode, camera = split.episodes[0], camera_named(run.camera)
    for name in sorted({spec.name for spec in run.agents.values() if AGENTS.sources().get(spec.name) == "uniteam"}):
        spec = AgentSpec(name, "truth")
        try:
            environment = Environment(split.homes[episode.home], episode, camera, spec.needs_truth)
            warm_up(environment, spec.make(environment))
        except Exception as error:  # whatever is wrong will come up in an episode and be recorded there
            _log.warning("%s could not be warmed up: %s: %s", name, type(error).__name__, error)
            _log.debug("this is where", exc_info=True)
