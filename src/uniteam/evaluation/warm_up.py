"""Have everything compiled before the clock runs: the first steps of a fresh machine take seconds each."""

from uniteam.evaluation.episode_loop import PlayableEnvironment
from uniteam.interface import Agent, DiscreteAction

STEPS = 20
"""Enough to look around and to plan the first drives."""

_ARM = (DiscreteAction.MANIPULATION_MODE, DiscreteAction.EXTEND_ARM, DiscreteAction.NAVIGATION_MODE)


def warm_up(environment: PlayableEnvironment, agent: Agent) -> None:
    """Move the arm, then let the agent play the episode's first steps; both are reset when they play next."""
    observation = environment.reset()
    for action in _ARM:
        observation = environment.step(action)
    agent.reset(environment.episode.instruction, environment.episode.seed)
    observation = environment.reset()
    for _ in range(STEPS):
        if not environment.is_over:
            observation = environment.step(agent.act(observation).action)
