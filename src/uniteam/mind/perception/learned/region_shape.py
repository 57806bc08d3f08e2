"""How large, how far and how high a region is: a few numbers that name things as well as their looks do."""

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import PinholeCamera, pixels_of

SHAPE_NUMBERS = 9
_ENOUGH = 1500
"""Pixels of a region that are measured; of a larger one every second, third, ..."""
_FEWEST = 8
"""Pixels with depth; of fewer nothing is measured."""


def region_shape(
    mask: NDArray[np.bool_], depth: NDArray[np.float32], camera: PinholeCamera, camera_to_start: NDArray[np.float64]
) -> NDArray[np.float32]:
    """Return the shape of a region.

    Args:
        mask: (H, W), which must not be empty.
        depth: (H, W) in metres, 0 where nothing returned.
        camera: intrinsics of both.
        camera_to_start: (4, 4); the floor is at z = 0.

    Returns:
        (SHAPE_NUMBERS,): whether it was measured; logarithms of width, height and distance (m) and of the share of the
        frame; the heights (m) of its lower and upper end above the floor; whether the frame cuts it at a side, and at
        top or bottom. All but the share and the cuts are 0 where depth is missing.
    """
    rows, columns = pixels_of(mask)
    height, width = mask.shape
    shape = np.zeros(SHAPE_NUMBERS, dtype=np.float32)
    shape[4] = np.log(len(rows) / (height * width)) / 4.0 + 1.0
    shape[7] = columns.min() == 0 or columns.max() == width - 1
    shape[8] = rows.min() == 0 or rows.max() == height - 1
    every = 1 + len(rows) // _ENOUGH
    rows, columns = rows[::every], columns[::every]
    z = depth[rows, columns].astype(np.float64)
    near = z > 0
    if np.count_nonzero(near) < _FEWEST:
        return shape
    z, rows, columns = z[near], rows[near], columns[near]
    x, y = (columns - camera.cx) / camera.fx * z, (rows - camera.cy) / camera.fy * z
    up = camera_to_start[2, 0] * x + camera_to_start[2, 1] * y + camera_to_start[2, 2] * z + camera_to_start[2, 3]
    left, right = np.percentile(x, (2, 98))
    low, high = np.percentile(up, (2, 98))
    shape[:4] = 1.0, *(np.log(max(v, 0.01)) + 1.0 for v in (right - left, high - low, float(np.median(z))))
    shape[5:7] = low, high
    return shape
