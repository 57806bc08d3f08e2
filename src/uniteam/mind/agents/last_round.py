"""What is given up once nothing is left to head for, so that the search goes on (`last_round`)."""

from dataclasses import dataclass
from enum import Enum, auto

CLOSE = 0.5
"""m; how far from a start receptacle the robot stands at most when it looks again."""
CLOSE_LOOK = 0.75
"""m; how far what is looked at again is off over the floor, at most."""


class Relaxation(Enum):
    """Something that kept the robot from places, and is forgotten."""

    FAILED_GOALS = auto()
    COLLISIONS = auto()
    LOOKS = auto()
    EXPLORED = auto()


def give_up(rounds: int) -> Relaxation | None:
    """Return None: the baseline stops once nothing is left."""
    return None


@dataclass(frozen=True)
class LastRound:
    """Tries again what failed, looks again at what it has looked at, goes round the home again, and feels its way.

    Attributes:
        order: of what is forgotten, one a round, over and over until the steps are used up.
    """

    order: tuple[Relaxation, ...] = (
        Relaxation.FAILED_GOALS,
        Relaxation.LOOKS,
        Relaxation.EXPLORED,
        Relaxation.COLLISIONS,
    )

    def __call__(self, rounds: int) -> Relaxation | None:
        """Return what to forget after so many rounds."""
        return self.order[rounds % len(self.order)]
