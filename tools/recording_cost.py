"""What recording costs: bytes an episode and a step, and processor time beside the same episodes unrecorded.

    python tools/recording_cost.py --split minival --agents uniteam-plus --episodes 3

Each episode is played twice in this process, once with and once without a recorder, in turn the one and the other
first; the clock is that of the processor, so that other processes on the machine disturb it less.
"""

import tempfile
from dataclasses import dataclass
from pathlib import Path
from time import process_time

import cv2
import tyro

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.configuration import Run, resolve
from uniteam.evaluation.episode_loop import play_episode
from uniteam.evaluation.evaluation import choose_episodes
from uniteam.evaluation.recording.provenance import Provenance, provenance_of
from uniteam.evaluation.recording.recorder import Recorder
from uniteam.evaluation.warm_up import warm_up
from uniteam.interface import Agent
from uniteam.world.task.environment import Environment
from uniteam.world.task.splits import load_split


@dataclass(frozen=True)
class Cost:
    """Of one episode: its steps, bytes of the recording, seconds of the processor without and with it."""

    steps: int
    size: int
    plain: float
    recorded: float

    def __str__(self) -> str:
        size = f"{self.size / 1e6:5.2f} MB, {self.size / self.steps:5.0f} bytes a step"
        before, after = (1000.0 * seconds / self.steps for seconds in (self.plain, self.recorded))
        return (
            f"{self.steps:5d} steps, {size}, {before:5.2f} ms a step, recorded {after:5.2f} ({after / before - 1:+.0%})"
        )


def main(split: str = "minival", agents: tuple[str, ...] = ("uniteam-plus",), episodes: int = 3) -> None:
    """Print what recording costs.

    Args:
        split: a built-in split's name or a file of episodes.
        agents: by name.
        episodes: how many, taken from the homes in turn.
    """
    cv2.setNumThreads(1)
    loaded = load_split(split)
    specs = {name: AgentSpec(name, "truth") for name in agents}
    configuration = resolve(Run(split, specs, "truth", "half"), loaded)
    for name, spec in specs.items():
        costs = []
        for turn, index in enumerate(choose_episodes(loaded.episodes, episodes)):
            episode = loaded.episodes[index]
            environment = Environment(loaded.homes[episode.home], episode, give_truth=spec.needs_truth)
            warm_up(environment, spec.make(environment))
            source = provenance_of(name, spec, split, configuration)
            costs.append(measure(environment, spec.make(environment), source, recorded_first=turn % 2 == 1))
            print(f"{name}, {episode.id}: {costs[-1]}", flush=True)
        total = Cost(*(sum(getattr(cost, field) for cost in costs) for field in ("steps", "size", "plain", "recorded")))
        print(f"{name}, all {len(costs)}: {total}; the largest {max(cost.size for cost in costs) / 1e6:.2f} MB")


def measure(environment: Environment, agent: Agent, source: Provenance, recorded_first: bool) -> Cost:
    """Play the environment's episode twice."""
    plain = 0.0 if recorded_first else play_plainly(environment, agent)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "episode.zip"
        environment.reset()
        began = process_time()
        recorder = Recorder(environment, source)
        result = play_episode(environment, agent, recorder)
        recorder.write(path, result)
        recorded = process_time() - began
        size = path.stat().st_size
    return Cost(result.measures.num_steps, size, plain or play_plainly(environment, agent), recorded)


def play_plainly(environment: Environment, agent: Agent) -> float:
    """Return the seconds of the processor that the episode takes without a recorder."""
    began = process_time()
    play_episode(environment, agent)
    return process_time() - began


if __name__ == "__main__":
    tyro.cli(main)
