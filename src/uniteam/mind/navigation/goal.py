"""What navigation is asked for."""

from dataclasses import dataclass
from enum import Enum

from uniteam.grid import Mask


class GoalKind(Enum):
    """What stands behind the cells of a goal."""

    OBJECT = "object"
    START_RECEPTACLE = "start receptacle"
    GOAL_RECEPTACLE = "goal receptacle"
    FRONTIER = "frontier"


@dataclass(frozen=True)
class Goal:
    """Cells to come near to, and what to face there.

    The masks belong to the map's present shape: make a goal anew at each step.

    Attributes:
        kind: what the cells are.
        cells: (H, W) bool; any of them will do.
        distance: how near is near enough (m, in a straight line); 0 asks for the cells themselves.
        face: (H, W) bool, the cells to face in the end (the nearest of them); None does not turn.
        shunned: (H, W) bool, cells not to stand at in the end, though near enough; None shuns none.
    """

    kind: GoalKind
    cells: Mask
    distance: float = 0.5
    face: Mask | None = None
    shunned: Mask | None = None
