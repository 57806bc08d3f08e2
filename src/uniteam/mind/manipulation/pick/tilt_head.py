"""Tilting the head at the pick: a high object is above the picture, a low one below (`tilt_head`)."""

import math
from dataclasses import dataclass, replace

from uniteam.mind.manipulation.pick.pick import object_points
from uniteam.mind.skills.skill import Skill, move_joints
from uniteam.mind.skills.view import View


@dataclass(frozen=True)
class TiltHead:
    """Looks up and down along the arm until the object is in view; straight again where it never is.

    Attributes:
        tilts: of the head, tried in this order (rad).
    """

    tilts: tuple[float, ...] = (math.radians(-22.0), math.radians(-68.0))

    def __call__(self, view: View) -> Skill[View]:
        """Answer with the first view of the object, or with the last view."""
        at_first = view.observation.joints.head_tilt
        for tilt in (*self.tilts, at_first):
            if len(object_points(view)):
                break
            target = replace(view.observation.joints, head_tilt=tilt)
            view = yield from move_joints(view, target, "The object is not in view of the arm; I tilt the head.")
        return view
