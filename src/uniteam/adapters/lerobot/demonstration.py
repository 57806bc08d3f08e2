"""A recorded episode as a learner wants it: what was seen and felt at each step, what was done, what it was worth."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.adapters.action_vector import vector_of
from uniteam.adapters.state_vector import state_vector
from uniteam.evaluation.recording.body import RecordedBody
from uniteam.evaluation.recording.recording import Recording
from uniteam.world.rendering.kernels.frame import Frame


@dataclass(frozen=True)
class Demonstration:
    """An episode of T steps but for its pictures.

    Attributes:
        task: the instruction in words.
        agent: who acted.
        episode: its id in the split.
        is_success: whether it was an overall success.
        states: (T, 11) float32, what was felt before each step, in the order of `STATE_NAMES`.
        actions: (T, 15) float32, what was done upon that, in the order of `ACTION_NAMES`.
        rewards: (T,) float32, what the partial success grew by in each step.
        are_successes: (T,) bool, whether all was achieved after each step.
    """

    task: str
    agent: str
    episode: str
    is_success: bool
    states: NDArray[np.float32]
    actions: NDArray[np.float32]
    rewards: NDArray[np.float32]
    are_successes: NDArray[np.bool_]

    @property
    def length(self) -> int:
        """How many steps there are."""
        return len(self.actions)


def demonstration(recording: Recording) -> Demonstration:
    """Return what a recording of at least one step holds for a learner."""
    steps, moments = recording.steps, range(len(recording.steps))
    felt = [state_vector(recording.joints(m), recording.base_to_start(m), recording.is_holding(m)) for m in moments]
    partial = np.array([0.0, *(step.measures.partial_success for step in steps)], np.float32)
    return Demonstration(
        task=str(recording.episode.instruction),
        agent=recording.header.agent,
        episode=recording.episode.id,
        is_success=recording.result.measures.overall_success,
        states=np.stack(felt),
        actions=np.stack([vector_of(step.decision.action) for step in steps]),
        rewards=np.diff(partial),
        are_successes=np.array([step.measures.overall_success for step in steps]),
    )


def pictures(recording: Recording) -> Iterator[Frame]:
    """Yield what the head camera saw before each step, without losses: drawn again from the recorded poses."""
    body = RecordedBody(recording)
    return (body.frame(moment) for moment in range(len(recording.steps)))
