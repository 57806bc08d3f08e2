"""Places that could not be reached, and are not tried again for a while (`failed_goal_memory`)."""

from dataclasses import dataclass, field, replace
from typing import Protocol

import numpy as np

from uniteam.grid import Mask, draw_disc
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal

Point2 = tuple[float, float]


class FailedGoals(Protocol):
    """What is remembered of places that could not be reached."""

    def add(self, place: Point2, step: int) -> None:
        """Remember that the robot failed to get to a place (m, start frame) in a step."""

    def avoid(self, goal: Goal, bird_map: BirdsEyeMap, step: int) -> Goal:
        """Return the goal of standing elsewhere than at what failed."""

    def forget(self) -> None:
        """Forget them all, so that they may be tried again."""


class NoFailedGoals:
    """Remembers nothing: the baseline tries the same place again and again."""

    def add(self, place: Point2, step: int) -> None:
        """Do nothing."""

    def avoid(self, goal: Goal, bird_map: BirdsEyeMap, step: int) -> Goal:
        """Return the goal as it is."""
        return goal

    def forget(self) -> None:
        """Do nothing."""


def remember_no_goals() -> FailedGoals:
    """Begin an episode as the baseline does, which remembers none."""
    return NoFailedGoals()


@dataclass(frozen=True)
class FailedGoalMemory:
    """Begins an episode with a memory of what fails.

    Attributes:
        radius, steps: see `DecayingFailedGoals`.
    """

    radius: float = 0.5
    steps: int = 100

    def __call__(self) -> FailedGoals:
        """Return the memory, with nothing in it yet."""
        return DecayingFailedGoals(self.radius, self.steps)


@dataclass(frozen=True)
class _Failure:
    place: Point2
    count: int
    until: int


@dataclass
class DecayingFailedGoals:
    """Avoids what failed, the longer the more often it failed.

    Attributes:
        radius: places so near to one another are one (m).
        steps: for how many steps a place is avoided after its first failure; every further one doubles them.
    """

    radius: float
    steps: int
    _failures: list[_Failure] = field(default_factory=list)

    def add(self, place: Point2, step: int) -> None:
        """Remember that the robot failed to get to a place (m, start frame) in a step."""
        known = next((i for i, failure in enumerate(self._failures) if self._is_near(failure.place, place)), None)
        if known is None:
            self._failures.append(_Failure(place, 1, step + self.steps))
        else:
            failure = self._failures[known]
            until = step + self.steps * 2**failure.count
            self._failures[known] = replace(failure, count=failure.count + 1, until=until)

    def avoid(self, goal: Goal, bird_map: BirdsEyeMap, step: int) -> Goal:
        """Return the goal of standing elsewhere than at what failed lately."""
        places = [failure.place for failure in self._failures if step < failure.until]
        return replace(goal, shunned=self._around(places, bird_map)) if places else goal

    def forget(self) -> None:
        """Forget them all, so that they may be tried again; how often each failed stays known."""
        self._failures = [replace(failure, until=0) for failure in self._failures]

    def _is_near(self, a: Point2, b: Point2) -> bool:
        return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 <= self.radius**2

    def _around(self, places: list[Point2], bird_map: BirdsEyeMap) -> Mask:
        cells = round(self.radius / bird_map.cell_size)
        mask = np.zeros(bird_map.shape, dtype=np.bool_)
        for place in places:
            draw_disc(mask, bird_map.to_cell(*place), cells)
        return mask
