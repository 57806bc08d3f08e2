"""Ask an agent again what it would do upon what was seen in a recording."""

from collections.abc import Callable
from dataclasses import dataclass

from uniteam.evaluation.recording.body import RecordedBody
from uniteam.evaluation.recording.recording import Recording
from uniteam.evaluation.recording.step_line import text
from uniteam.interface import Agent, Decision
from uniteam.world.task.check_action import checked_action


@dataclass(frozen=True)
class Difference:
    """The first step at which an agent decides otherwise than was recorded.

    Attributes:
        step: its number.
        recorded: what was decided.
        decided: what the agent decides now.
    """

    step: int
    recorded: Decision
    decided: Decision

    def __str__(self) -> str:
        was, now = self.recorded, self.decided
        return (
            f"step {self.step} was {was.action} in {was.state} ('{was.reason}'), "
            f"and is now {now.action} in {now.state} ('{now.reason}')"
        )


def first_difference(
    recording: Recording, agent: Agent, body: RecordedBody, on_step: Callable[[], None] = lambda: None
) -> Difference | None:
    """Return the first step at which an agent decides otherwise than was recorded: another action, state or reason.

    Args:
        recording: of an episode.
        agent: whom to ask; it is reset first.
        body: that plays the recording.
        on_step: called after each step.

    Raises:
        OtherFrameError: the camera does not draw what was recorded.
        InvalidInputError: no step was recorded.
    """
    episode = recording.episode
    agent.reset(episode.instruction, episode.seed)
    observation = body.reset()
    for recorded in recording.steps:
        decided = _as_recorded(agent.act(observation))
        if decided != recorded.decision:
            return Difference(recorded.step, recorded.decision, decided)
        observation = body.step(decided.action)
        on_step()
    return None


def _as_recorded(decision: Decision) -> Decision:
    """Return a decision as a recording has it."""
    return Decision(checked_action(decision.action), text(decision.state), text(decision.reason))
