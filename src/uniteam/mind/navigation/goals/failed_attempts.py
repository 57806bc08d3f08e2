"""Where picks have failed, and how that changes what the robot heads for next."""

from dataclasses import dataclass, field

import cv2
import numpy as np

from uniteam.geometry import BasePose
from uniteam.grid import Mask, disc, draw_disc
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.goals.exploration import ChooseGoal
from uniteam.mind.navigation.planning.distance_field import distance_field
from uniteam.mind.perception.vocabulary import ClassRole


@dataclass(frozen=True)
class Miss:
    """A failed attempt: where the base stood, and what it faced (m, start frame)."""

    stand: BasePose
    target: tuple[float, float]


@dataclass
class Misses:
    """The failed attempts of an episode.

    Attributes:
        made: those that are remembered, in the order in which they were made.
        count: how many there were, the forgotten ones too.
        same_target: targets closer together (m) are one.
        same_stand: stands closer together (m) are one.
        patience: after so many misses of one target it is given up.
    """

    made: list[Miss] = field(default_factory=list)
    count: int = 0
    same_target: float = 0.5
    same_stand: float = 0.3
    patience: int = 3

    def add(self, miss: Miss) -> None:
        """Remember one more."""
        self.made.append(miss)
        self.count += 1

    def forget(self) -> None:
        """Forget where they were, so that what failed once may be tried again."""
        self.made.clear()

    def given_up(self) -> tuple[tuple[float, float], ...]:
        """Return the targets that were missed too often."""
        return tuple(miss.target for miss in self.made if self._count(miss.target) >= self.patience)

    def _count(self, target: tuple[float, float]) -> int:
        return sum(np.hypot(m.target[0] - target[0], m.target[1] - target[1]) < self.same_target for m in self.made)

    def avoided_by(self, choose: ChooseGoal) -> ChooseGoal:
        """Return `choose`, but for targets that were given up, and with other places to stand at where one failed."""
        if not self.made:
            return choose

        def elsewhere(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
            goal = choose(bird_map, base)
            if goal is None or goal.kind not in (GoalKind.OBJECT, GoalKind.GOAL_RECEPTACLE):
                return goal
            hopeless = self._around(bird_map, self.given_up(), self.same_target)
            return self._from_elsewhere(bird_map, goal, hopeless)

        return elsewhere

    def _from_elsewhere(self, bird_map: BirdsEyeMap, goal: Goal, hopeless: Mask) -> Goal | None:
        """Return the goal of standing as near to the cells as asked for, but not where an attempt has failed."""
        face = (goal.cells if goal.face is None else goal.face) & ~hopeless
        stands = _before(bird_map, goal.cells & ~hopeless, goal.distance)
        stands &= ~self._around(bird_map, tuple((m.stand.x, m.stand.y) for m in self.made), self.same_stand)
        if not (stands.any() and face.any()):
            return None
        return Goal(goal.kind, stands, distance=0.0, face=face)

    def _around(self, bird_map: BirdsEyeMap, points: tuple[tuple[float, float], ...], radius: float) -> Mask:
        mask = np.zeros(bird_map.shape, dtype=np.bool_)
        for x, y in points:
            draw_disc(mask, bird_map.to_cell(x, y), round(radius / bird_map.cell_size))
        return mask


def _before(bird_map: BirdsEyeMap, cells: Mask, distance: float) -> Mask:
    """Return the cells within a distance (m) of some cells, over receptacles, but not through a wall."""
    x, y, width, height = cv2.boundingRect(cells.view(np.uint8))
    if width == 0:
        return cells
    play = round(distance / bird_map.cell_size) + 2
    box = slice(max(0, y - play), y + height + play), slice(max(0, x - play), x + width + play)
    receptacles = (bird_map.class_cells(role)[box] for role in (ClassRole.START_RECEPTACLE, ClassRole.GOAL_RECEPTACLE))
    own = cv2.dilate(np.logical_or.reduce((cells[box], *receptacles)).view(np.uint8), disc(1)).view(np.bool_)
    stands = np.zeros_like(cells)
    free = ~bird_map.obstacle[box] | own
    stands[box] = distance_field(free, np.ascontiguousarray(cells[box]), bird_map.cell_size) <= distance
    return stands
