"""Where the robot's axis may pass, as far as the map knows; the unknown may be passed."""

import cv2
import numpy as np

from uniteam.grid import Cell, Mask, disc_mask, grown
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.window import Window

OWN_CELLS = 3
_BY_SIDES = 4 | 1 << 8 | cv2.FLOODFILL_MASK_ONLY
"""Connect through the four sides of cells, and write 1 into the mask alone."""


def traversible(bird_map: BirdsEyeMap, window: Window, robot: Cell, dilation: int, own_cells: int = OWN_CELLS) -> Mask:
    """Return the window's free cells: not within `dilation` cells of an obstacle, or visited.

    The robot's own disc is free but for obstacles themselves: it stands there. Obstacles that were felt count more than
    having been there before. Collision cells are not looked at.

    Args:
        bird_map: the map.
        window: the part of it to cut out.
        robot: (row, column) of the robot in the window.
        dilation: cells by which obstacles grow.
        own_cells: radius of the robot's own disc, in cells.
    """
    obstacle = window.cut(bird_map.obstacle)
    blocked = grown(obstacle, dilation)
    own = disc_mask(obstacle.shape, robot, own_cells) & ~obstacle
    felt = grown(window.cut(bird_map.felt), dilation)
    free = ~blocked | own | window.cut(bird_map.visited) & ~felt
    free[robot] = True
    return free


def connected_to(robot: Cell, free: Mask) -> Mask:
    """Return the free cells to which there is a path from the robot, which stands on a free one.

    The steps of `distance_field` connect what is connected through the sides of cells, so no search is needed.
    """
    rows, columns = free.shape
    reached = np.zeros((rows + 2, columns + 2), dtype=np.uint8)  # with the rim that OpenCV asks for
    cv2.floodFill(free.view(np.uint8), reached, robot[::-1], newVal=0, flags=_BY_SIDES)
    return reached[1:-1, 1:-1].astype(np.bool_)
