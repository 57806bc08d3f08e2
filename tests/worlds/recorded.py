"""Short recordings of real episodes, and what was seen and decided while they were made."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.configuration import Run, resolve
from uniteam.evaluation.episode_loop import Step, play_episode
from uniteam.evaluation.recording.provenance import provenance_of
from uniteam.evaluation.recording.recorder import Recorder
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.interface import Action, Agent, Decision, DiscreteAction, Explaining, Explanation, Instruction, Observation
from uniteam.world.task.environment import Environment
from uniteam.world.task.splits import load_split


class Brief:
    """Another agent, stopped after some steps."""

    def __init__(self, agent: Agent, steps: int) -> None:
        self._agent, self._steps = agent, steps

    def reset(self, instruction: Instruction, seed: int) -> None:
        self._agent.reset(instruction, seed)

    def act(self, observation: Observation) -> Decision:
        decision = self._agent.act(observation)
        if observation.step < self._steps:
            return decision
        return Decision(DiscreteAction.STOP, "DONE", "Enough.")

    def explain(self) -> Explanation:
        return self._agent.explain() if isinstance(self._agent, Explaining) else Explanation()


class Reciter:
    """Does what stands in a script, then stops."""

    def __init__(self, script: tuple[Action, ...]) -> None:
        self._script = script

    def reset(self, instruction: Instruction, seed: int) -> None:
        """There is nothing to forget."""

    def act(self, observation: Observation) -> Decision:
        script = (*self._script, DiscreteAction.STOP)
        return Decision(script[observation.step], "RECITE", "It is written so.")


@dataclass(frozen=True)
class Played:
    """An episode that was recorded: the file, and what it should hold."""

    path: Path
    steps: list[Step]
    result: EpisodeResult
    environment: Environment


def record(path: Path, agent: Agent, spec: AgentSpec, episode: int = 5) -> Played:
    """Record an agent on an episode of minival, under another agent's name."""
    return record_made(path, lambda environment: agent, spec, episode)


def record_made(path: Path, make: Callable[[Environment], Agent], spec: AgentSpec, episode: int = 5) -> Played:
    """Record an agent that is made of the environment, under another agent's name."""
    split = load_split("minival")
    chosen = split.episodes[episode]
    environment = Environment(split.homes[chosen.home], chosen, give_truth=spec.needs_truth)
    configuration = resolve(Run("minival", {spec.name: spec}, spec.perception, "half"), split)
    recorder = Recorder(environment, provenance_of(spec.name, spec, "minival", configuration))
    steps: list[Step] = []

    def observe(step: Step) -> None:
        steps.append(step)
        recorder(step)

    result = play_episode(environment, make(environment), observe)
    recorder.write(path, result)
    return Played(path, steps, result, environment)
