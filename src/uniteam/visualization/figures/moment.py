"""A moment of an episode: an agent plays up to where there is something to show, and everything stands still."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from uniteam.errors import UniteamError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Decision, Instruction, Observation
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.task.environment import Environment
from uniteam.world.task.splits import load_split


@dataclass(frozen=True)
class Moment:
    """What an agent sees, knows and has decided, before it is done.

    Attributes:
        environment: where the robot is.
        agent: with what it knows.
        observation: what it sees.
        decision: what it does next.
        trail: where the base has been (start frame).
        blocked: how many motions of the base were blocked so far.
    """

    environment: Environment
    agent: HeuristicAgent
    observation: Observation
    decision: Decision
    trail: Sequence[BasePose]
    blocked: int

    @property
    def instruction(self) -> Instruction:
        """What is asked."""
        return self.environment.episode.instruction


@dataclass(frozen=True)
class Scene:
    """An episode, who plays it, and when it is worth a picture.

    Attributes:
        split, episode: which one, counted from 0.
        agent: who plays; it is made of a configuration.
        shows: whether a moment is the one; the first is taken.
        camera: what it sees with.
    """

    split: str
    episode: int
    agent: AgentSpec
    shows: Callable[[Moment], bool]
    camera: PinholeCamera = HEAD_CAMERA_HALF

    def play(self) -> Moment:
        """Return the moment.

        Raises:
            UniteamError: it never comes.
        """
        split = load_split(self.split)
        episode = split.episodes[self.episode]
        environment = Environment(split.homes[episode.home], episode, self.camera, self.agent.needs_truth)
        agent = self.agent.make(environment)
        assert isinstance(agent, HeuristicAgent)
        agent.reset(episode.instruction, episode.seed)
        observation, trail, blocked = environment.reset(), list[BasePose](), 0
        while not environment.is_over:
            trail.append(observation.base_to_start)
            moment = Moment(environment, agent, observation, agent.act(observation), trail, blocked)
            if self.shows(moment):
                return moment
            observation = environment.step(moment.decision.action)
            blocked += environment.events.blocked
        raise UniteamError(
            f"agent '{self.agent.name}' never came to what the figure shows in episode {self.episode} of split "
            f"'{self.split}'; choose another episode for it"
        )
