"""What is done once the gripper has let go: wait for the fall, and leave."""

from collections.abc import Callable
from dataclasses import dataclass

from uniteam.interface import DiscreteAction
from uniteam.mind.skills.skill import Move, Skill, discrete
from uniteam.mind.skills.view import View


@dataclass(frozen=True)
class Lying:
    """Where an object lies that is not where it should be: (x, y) in the start frame (m)."""

    x: float
    y: float


Wait = Callable[[View], Skill[View]]
"""Waits until what was let go has come to rest; answers with the last view."""
Verify = Callable[[View], Skill[Lying | None]]
"""Looks for the object after that; answers with where it lies, or None where it is as it should be, or not known."""


@dataclass(frozen=True)
class WaitSteps:
    """Waits for a number of steps, whatever is seen."""

    steps: int = 200

    def __call__(self, view: View) -> Skill[View]:
        """Wait."""
        for _ in range(self.steps):
            view = yield wait_for_rest(view)
        return view


def wait_for_rest(view: View) -> Move:
    """Return the move that waits a step."""
    name = view.instruction.object_category.replace("_", " ")
    return discrete(DiscreteAction.EMPTY_ACTION, f"I wait until the {name} has come to rest.")


def take_it_for_placed(view: View) -> Skill[Lying | None]:
    """Believe that it is where it should be, without a look."""
    yield from ()
    return None
