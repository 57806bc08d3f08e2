"""Which cells count as those where the robot has been: they stay free whatever is seen there."""

import cv2

from uniteam.grid import Cell, Mask


def mark_stand(visited: Mask, before: Cell, now: Cell) -> None:
    """Mark the cell where the robot's axis is, as HomeRobot does in each step."""
    visited[now] = True


def mark_line(visited: Mask, before: Cell, now: Cell) -> None:
    """Mark the cells over which the robot's axis passed since the last step: `driven_line`."""
    cv2.line(visited.view("uint8"), before[::-1], now[::-1], color=1)
