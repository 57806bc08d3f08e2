"""Getting away from a place where the same motion is blocked again and again (`step_aside`)."""

from dataclasses import dataclass

import numpy as np

from uniteam.interface import DiscreteAction
from uniteam.mind.skills.skill import Skill, discrete
from uniteam.mind.skills.view import View


def never_step_aside(blocked_in_a_row: int) -> bool:
    """Keep to the plan however often it is blocked, as the baseline does."""
    return False


@dataclass(frozen=True)
class AfterBlockedMotions:
    """Leaves the plan once so many forward motions in a row were blocked."""

    motions: int = 6

    def __call__(self, blocked_in_a_row: int) -> bool:
        """Return whether to step aside."""
        return blocked_in_a_row >= self.motions


def step_aside(view: View, generator: np.random.Generator) -> Skill[View]:
    """Turn by a random angle and drive a little, so that the next plan begins somewhere else."""
    side = DiscreteAction.TURN_LEFT if generator.random() < 0.5 else DiscreteAction.TURN_RIGHT
    for _ in range(int(generator.integers(1, 6))):
        view = yield discrete(side, "I am blocked here again and again, so I turn aside.")
    for _ in range(2):
        view = yield discrete(DiscreteAction.MOVE_FORWARD, "I step aside to plan from another place.")
    return view
