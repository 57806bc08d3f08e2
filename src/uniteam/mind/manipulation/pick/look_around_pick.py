"""Looking around at the pick: what to do when the object is not where the arm points (`look_around_pick`)."""

import math
from dataclasses import dataclass

from uniteam.mind.manipulation.pick.pick import object_points
from uniteam.mind.skills.skill import Skill, turn
from uniteam.mind.skills.view import View


@dataclass(frozen=True)
class LookAround:
    """Turns left and right until the object is in view.

    Attributes:
        turns: of the whole base, one after the other (rad).
    """

    turns: tuple[float, ...] = tuple(math.radians(degrees) for degrees in (30, 30, -90, -30))

    def __call__(self, view: View) -> Skill[View]:
        """Answer with the first view of the object, or with the last view."""
        for angle in self.turns:
            if len(object_points(view)):
                break
            side = "left" if angle > 0 else "right"
            view = yield turn(angle, f"The object is not in view of the arm; I look further to the {side}.")
        return view
