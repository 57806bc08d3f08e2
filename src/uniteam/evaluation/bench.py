"""Measure where a step's time goes."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median
from time import perf_counter

import cv2

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.episode_loop import play_episode
from uniteam.evaluation.memory import peak_memory
from uniteam.evaluation.warm_up import warm_up
from uniteam.interface import Agent, DiscreteAction
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.timing import stopwatch
from uniteam.world.rendering.mujoco_reference import Comparison, compare_with_mujoco
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Episode, Split

VIEWS = 12
"""Views of one home, all around the robot, to compare the camera on."""

SECTIONS = ("camera", "physics", "perception", "map", "planner")
REST = "rest"


@dataclass(frozen=True)
class EpisodeTiming:
    """How long one episode took.

    Attributes:
        steps: taken.
        seconds: of the whole loop.
        sections: seconds by section, "rest" included.
    """

    steps: int
    seconds: float
    sections: dict[str, float]


@dataclass(frozen=True)
class BenchReport:
    """What `uniteam bench` measures, of one process.

    Attributes:
        episode_count, step_count: what it is from.
        steps_per_second: of the whole loop, median over the episodes.
        milliseconds: a step, by section, mean over all steps.
        opening_seconds: to open a home, median.
        warm_up_seconds: to import, compile or load from the cache what is compiled, and play the first steps.
        peak_memory_mb: largest resident memory of the process.
    """

    episode_count: int
    step_count: int
    steps_per_second: float
    milliseconds: dict[str, float]
    opening_seconds: float
    warm_up_seconds: float
    peak_memory_mb: float


def measure(split: Split, spec: AgentSpec, episode_count: int, on_episode: Callable[[], None]) -> BenchReport:
    """Play the first `episode_count` episodes of a split, one after the other, with the clock running."""
    cv2.setNumThreads(1)
    began = perf_counter()
    environment = _open(split, split.episodes[0], spec)
    warm_up(environment, spec.make(environment))
    warm = perf_counter() - began
    timings: list[EpisodeTiming] = []
    openings: list[float] = []
    for episode in split.episodes[:episode_count]:
        if environment.home.name != episode.home or not timings:
            began = perf_counter()
            environment = _open(split, episode, spec)
            openings.append(perf_counter() - began)
        environment.reset(episode)
        timings.append(_time_episode(environment, spec.make(environment)))
        on_episode()
    return _report(timings, openings, warm)


def _open(split: Split, episode: Episode, spec: AgentSpec) -> Environment:
    return Environment(split.homes[episode.home], episode, HEAD_CAMERA_HALF, spec.needs_truth)


def _time_episode(environment: Environment, agent: Agent) -> EpisodeTiming:
    with stopwatch() as watch:
        result = play_episode(environment, agent)
    sections = {name: watch.seconds.get(name, 0.0) for name in SECTIONS}
    sections[REST] = result.seconds - sum(sections.values())
    return EpisodeTiming(result.measures.num_steps, result.seconds, sections)


def _report(timings: Sequence[EpisodeTiming], openings: Sequence[float], warm: float) -> BenchReport:
    steps = sum(timing.steps for timing in timings)
    return BenchReport(
        episode_count=len(timings),
        step_count=steps,
        steps_per_second=median(timing.steps / timing.seconds for timing in timings),
        milliseconds={
            name: 1000.0 * sum(timing.sections[name] for timing in timings) / steps for name in (*SECTIONS, REST)
        },
        opening_seconds=median(openings),
        warm_up_seconds=warm,
        peak_memory_mb=peak_memory(),
    )


def compare_cameras(split: Split) -> Comparison:
    """Compare our camera with MuJoCo's renderer on views from where the first episode starts.

    Raises:
        OpenGLMissingError: MuJoCo's renderer does not work here.
    """
    episode = split.episodes[0]
    home = split.homes[episode.home]
    environment = Environment(home, episode)
    environment.reset()
    poses = []
    for _ in range(VIEWS):
        environment.step(DiscreteAction.TURN_LEFT)
        poses.append(environment.simulator.camera_to_world())
    return compare_with_mujoco(home, HEAD_CAMERA_HALF, poses)
