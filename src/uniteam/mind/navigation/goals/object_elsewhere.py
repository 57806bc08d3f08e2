"""Objects that lie on no known start receptacle, once the search has gone on for long (`object_elsewhere`)."""

from dataclasses import dataclass

from uniteam.geometry import BasePose
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.perception.vocabulary import ClassRole


@dataclass(frozen=True)
class ObjectElsewhere:
    """Takes an object wherever it lies: what it lies on may have been taken for something else.

    Attributes:
        after: how many frames are looked at before.
        least: how probable the object must be: a start receptacle under it would have been a second witness.
    """

    after: int = 350
    least: float = 0.4

    def __call__(self, bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
        """Return the goal of standing before such objects and facing them; None where there are none, or too early."""
        if bird_map.update_count < self.after:
            return None
        cells = bird_map.class_cells(ClassRole.OBJECT) & (bird_map.class_probability(ClassRole.OBJECT) >= self.least)
        return Goal(GoalKind.OBJECT, cells, face=cells) if cells.any() else None
