"""Let an agent act in a body that nobody judges: a robot."""

from collections.abc import Callable
from dataclasses import dataclass

from uniteam.interface import Agent, Body, Decision, DiscreteAction, Instruction


@dataclass(frozen=True)
class BodyRun:
    """What came of it, as far as the agent knows.

    Attributes:
        steps: how many actions were done.
        has_stopped: whether the agent ended it; else the steps were used up.
        last: its last decision; None where no step was allowed.
    """

    steps: int
    has_stopped: bool
    last: Decision | None


@dataclass(frozen=True)
class Task:
    """What an agent is asked, and for how long.

    Attributes:
        instruction: what to move from where to where.
        seed: of the agent's random choices.
        most_steps: after which it is ended.
    """

    instruction: Instruction
    seed: int
    most_steps: int


def act_in(
    body: Body, agent: Agent, task: Task, before_step: Callable[[int, Decision], None] = lambda step, decision: None
) -> BodyRun:
    """Reset both and have the agent act until it stops or the steps are used up; exceptions of either pass through.

    Args:
        body: that acts and sees.
        agent: that decides.
        task: what it is asked.
        before_step: is told of each decision, with its number, before it is done.
    """
    agent.reset(task.instruction, task.seed)
    observation, decision = body.reset(), None
    for step in range(task.most_steps):
        decision = agent.act(observation)
        before_step(step, decision)
        if decision.action is DiscreteAction.STOP:
            return BodyRun(step, True, decision)
        observation = body.step(decision.action)
    return BodyRun(task.most_steps, False, decision)
