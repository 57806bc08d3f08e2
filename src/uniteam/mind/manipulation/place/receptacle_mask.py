"""Which pixels count as the goal receptacle's: the inside of its mask, or all of it (`whole_mask`)."""

import cv2
import numpy as np

from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.view import Points, View

RIM_SHARE = 10 / 480
"""Of the picture's width: HomeRobot erodes the mask five times by a square of five pixels, in a picture 480 wide."""


def inside_of_mask(view: View) -> Points:
    """Return the (N, 3) points (m, base frame) of the goal receptacle that are not near the rim of its mask."""
    mask = (view.mask(ClassRole.GOAL_RECEPTACLE) & view.returned).view(np.uint8)
    rim = round(RIM_SHARE * mask.shape[1])
    inside = cv2.erode(mask, np.ones((2 * rim + 1, 2 * rim + 1), dtype=np.uint8))
    return view.cloud[inside.view(np.bool_)]


def whole_mask(view: View) -> Points:
    """Return the (N, 3) points (m, base frame) of the goal receptacle, to the rim of its mask."""
    return view.points(ClassRole.GOAL_RECEPTACLE)
