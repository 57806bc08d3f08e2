"""Grids of square cells on the floor: from points to cells and back, and discs of cells.

Row is y and column is x; cell [0, 0] has the least of both.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeVar

import cv2
import numpy as np
from numpy.typing import NDArray

Mask = NDArray[np.bool_]
"""(H, W): a property of cells."""
Cell = tuple[int, int]
"""(row, column)."""

_Scalar = TypeVar("_Scalar", bound=np.generic)


@dataclass(frozen=True)
class Grid:
    """Where a grid lies.

    Attributes:
        origin: (x, y) of the corner of cell [0, 0] (m).
        cell_size: side of a cell (m).
    """

    origin: tuple[float, float]
    cell_size: float

    def to_cell(self, x: float, y: float) -> Cell:
        """Return the (row, column) of the cell that holds a point (m); it may lie outside the array of cells."""
        return math.floor((y - self.origin[1]) / self.cell_size), math.floor((x - self.origin[0]) / self.cell_size)

    def to_point(self, row: float, column: float) -> tuple[float, float]:
        """Return the centre (x, y) of a cell (m)."""
        return self.origin[0] + (column + 0.5) * self.cell_size, self.origin[1] + (row + 0.5) * self.cell_size

    def to_points(self, cells: NDArray[np.number]) -> NDArray[np.float64]:
        """Return the (K, 2) centres (x, y) (m) of (K, 2) cells (row, column)."""
        return np.asarray(self.origin) + (np.asarray(cells).reshape(-1, 2)[:, ::-1] + 0.5) * self.cell_size


@lru_cache(maxsize=64)
def disc(radius: int) -> NDArray[np.uint8]:
    """Return the (2r + 1, 2r + 1) uint8 disc of a radius in cells, for dilations."""
    offsets = np.arange(-radius, radius + 1)
    return (offsets[:, None] ** 2 + offsets[None, :] ** 2 <= radius * radius).astype(np.uint8)


def disc_mask(shape: tuple[int, int], centre: Cell, radius: int) -> Mask:
    """Return the (H, W) mask of the cells within `radius` cells of a centre, which may lie outside."""
    mask = np.zeros(shape, dtype=np.bool_)
    draw_disc(mask, centre, radius)
    return mask


def draw_disc(mask: Mask, centre: Cell, radius: int, value: bool = True) -> None:
    """Write a value into the cells of an (H, W) mask within `radius` cells of a centre, which may lie outside."""
    cv2.circle(mask.view(np.uint8), (int(centre[1]), int(centre[0])), radius, color=int(value), thickness=-1)


def grown(cells: Mask, radius: int) -> Mask:
    """Return the cells within `radius` cells of some of an (H, W) mask; where there are none, it is returned itself."""
    return cv2.dilate(cells.view(np.uint8), disc(radius)).view(np.bool_) if cells.any() else cells


def grown_by_rows(cells: Mask, half_widths: Sequence[int]) -> Mask:
    """Return the cells of which some of an (H, W) mask lie in a symmetric shape around them.

    The shape reaches `half_widths[k]` cells to either side in the rows k above and below its middle; the farther away
    a row, the shorter it is. A large shape takes a dilation a step for each of its cells, and this one for each row.
    """
    reach, widest = len(half_widths) - 1, max(half_widths)
    rows, columns = cells.shape
    width = columns + widest  # what grows beyond a row's end does not come into the next one
    around = np.zeros((rows + 2 * reach) * width + 2 * widest, dtype=np.bool_)
    around[widest : around.size - widest].reshape(-1, width)[reach : reach + rows, :columns] = cells
    grown_cells, size, half = np.zeros((rows, width), dtype=np.bool_), rows * width, 0
    for away in range(reach, -1, -1):
        while half < half_widths[away]:
            around = around[:-2] | around[1:-1] | around[2:]
            half += 1
        for first_row in {reach - away, reach + away}:
            first = first_row * width + widest - half
            grown_cells.reshape(-1)[:] |= around[first : first + size]
    return grown_cells[:, :columns]


def enlarged(channel: NDArray[_Scalar], corner: Cell, shape: Cell) -> NDArray[_Scalar]:
    """Return a larger channel, zero but for the old one from a corner on; memory never touched costs nothing."""
    rows, columns = channel.shape[-2:]
    larger = np.zeros((*channel.shape[:-2], *shape), dtype=channel.dtype)
    larger[..., corner[0] : corner[0] + rows, corner[1] : corner[1] + columns] = channel
    return larger
