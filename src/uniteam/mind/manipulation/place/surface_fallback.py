"""Placing where no receptacle is detected: on whatever flat surface the arm reaches, rather than blindly out."""

from dataclasses import dataclass, field

from uniteam.mind.manipulation.place.baseline_place import blind_path
from uniteam.mind.manipulation.place.flat_surfaces import level_points
from uniteam.mind.manipulation.place.local_cloud import Nearby
from uniteam.mind.manipulation.place.place import Aim, PlaceTask, enter_manipulation_mode
from uniteam.mind.manipulation.place.stepwise_place import CloseInStepwise
from uniteam.mind.skills.skill import Skill
from uniteam.mind.skills.view import View


@dataclass(frozen=True)
class OntoFlatSurface:
    """Aims at a flat surface of anything that stands high enough to be furniture.

    Attributes:
        lowest: height (m) above the floor from which a surface counts.
        arm: how the arm's way is checked.
    """

    lowest: float = 0.2
    arm: CloseInStepwise = field(default_factory=CloseInStepwise)

    def __call__(self, view: View, task: PlaceTask) -> Skill[Aim]:
        """Answer with an aim at a flat surface in reach; with the whole arm out where there is none."""
        nearby = Nearby()
        view = yield from enter_manipulation_mode(view, "I see no receptacle, so I look for a flat surface beside me.")
        nearby.add(view)
        around = nearby.surroundings(view.observation.base_to_start)
        flat = level_points(around[around[:, 2] > self.lowest])
        aim = yield from self.arm.aim(view, flat, around, task)
        return Aim(view, blind_path(view)) if aim is None else aim
