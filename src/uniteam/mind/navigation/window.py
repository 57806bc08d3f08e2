"""The part of the map that is worth searching: what is known, with a margin of the unknown around it."""

from dataclasses import dataclass
from typing import TypeVar

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.grid import Cell, Mask
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap

MARGIN_CELLS = 20

_Scalar = TypeVar("_Scalar", bound=np.generic)


@dataclass(frozen=True)
class Window:
    """Rows `low[0]` to `high[0]` and columns `low[1]` to `high[1]` of the map, the last ones excluded."""

    low: Cell
    high: Cell

    def cut(self, channel: NDArray[_Scalar]) -> NDArray[_Scalar]:
        """Return the window's part of an (H, W) channel as a contiguous copy."""
        return channel[self.low[0] : self.high[0], self.low[1] : self.high[1]].copy()

    def paste(self, part: Mask, shape: Cell) -> Mask:
        """Return an (H, W) channel that is False but for the window's part."""
        channel = np.zeros(shape, dtype=np.bool_)
        channel[self.low[0] : self.high[0], self.low[1] : self.high[1]] = part
        return channel

    def inside(self, cell: Cell) -> Cell:
        """Return a cell of the map as a cell of the window."""
        return cell[0] - self.low[0], cell[1] - self.low[1]

    def outside(self, cells: NDArray[np.integer]) -> NDArray[np.integer]:
        """Return (..., 2) cells of the window as cells of the map."""
        return np.asarray(cells) + np.asarray(self.low)


def window_around(bird_map: BirdsEyeMap, base: BasePose, *others: Mask) -> Window:
    """Return the window that holds all that is known, the robot and the cells of other masks, with a margin."""
    row, column = bird_map.to_cell(base.x, base.y)
    known, past = bird_map.known
    low, high = [min(row, known[0]), min(column, known[1])], [max(row + 1, past[0]), max(column + 1, past[1])]
    for mask in others:
        x, y, width, height = cv2.boundingRect(np.ascontiguousarray(mask).view(np.uint8))
        if width and height:
            low = [min(low[0], y), min(low[1], x)]
            high = [max(high[0], y + height), max(high[1], x + width)]
    rows, columns = bird_map.shape
    return Window(
        (max(0, low[0] - MARGIN_CELLS), max(0, low[1] - MARGIN_CELLS)),
        (min(rows, high[0] + MARGIN_CELLS), min(columns, high[1] + MARGIN_CELLS)),
    )
