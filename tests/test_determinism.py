"""One seed gives one trace, to the bit, for every agent."""

import pytest

from uniteam.evaluation.agent_spec import ORACLE, AgentSpec
from uniteam.geometry import BasePose
from uniteam.interface import Action, Agent
from uniteam.world.task.environment import Environment
from uniteam.world.task.measures import Measures
from uniteam.world.task.splits import load_split

STEPS = 60
Trace = list[tuple[Action, str, BasePose, bytes, Measures]]


def environment_of(episode_index: int) -> Environment:
    split = load_split("minival")
    episode = split.episodes[episode_index]
    return Environment(split.homes[episode.home], episode, give_truth=True)


def trace(environment: Environment, agent: Agent) -> Trace:
    """Play the first steps of an episode and return every action, state, pose, image and measure."""
    agent.reset(environment.episode.instruction, environment.episode.seed)
    observation = environment.reset()
    steps: Trace = []
    while not environment.is_over and len(steps) < STEPS:
        decision = agent.act(observation)
        observation = environment.step(decision.action)
        seen = observation.depth[::16, ::16].tobytes()
        steps.append((decision.action, decision.state, observation.base_to_start, seen, environment.measures))
    return steps


@pytest.mark.parametrize("name", ["baseline", "uniteam", "random", ORACLE])
def test_two_copies_of_a_world_and_an_agent_do_the_same(name: str) -> None:
    """Both copies are alive at once, so that nothing can pass from one to the other."""
    spec = AgentSpec(name, "truth")
    worlds = environment_of(1), environment_of(1)
    assert worlds[0].simulator is not worlds[1].simulator
    agents = [spec.make(world) for world in worlds]
    first, second = (trace(world, agent) for world, agent in zip(worlds, agents, strict=True))
    assert first
    assert first == second


def test_what_was_played_before_leaves_no_trace() -> None:
    """A world and an agent that are used again behave as new."""
    world = environment_of(2)
    agent = AgentSpec("uniteam", "truth").make(world)
    assert trace(world, agent) == trace(world, agent)
