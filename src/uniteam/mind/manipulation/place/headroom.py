"""Points with headroom: tops, seats, boards and the bottoms of hollows, but no walls and no fronts (`headroom`)."""

import numpy as np

from uniteam.mind.skills.view import Points

CELL = 0.025
"""m; side of the columns in which points are gathered."""
RISE = 0.02
"""m; height of the voxels of a column."""
_HEADROOM = range(2, 8)
"""Voxels above a point that must be empty: on a wall, a front or a cushion's flank they are not."""
_FRONT = range(2, 4)
"""Voxels below a point that are not all filled: at the rim of a picture, nothing is seen above a point on a front."""
_LEVELS = 1 << 9
"""A key holds column x, column y and level: 9 bits of level are 10 m, of which a quarter lies below the floor."""
_COLUMNS = 1 << 20
"""20 bits of column are 26 km; with both and the level a key has 49 bits, and `key + n` is n voxels higher."""


def points_with_headroom(points: Points) -> Points:
    """Return one of (N, 3) points (m, z up) in each voxel above which they leave room, and that is on no front."""
    column = np.floor(points[:, :2] / CELL).astype(np.int64)
    level = np.floor(points[:, 2] / RISE).astype(np.int64) + _LEVELS // 4
    keys = (column[:, 0] % _COLUMNS * _COLUMNS + column[:, 1] % _COLUMNS) * _LEVELS + level
    voxels, first = np.unique(keys, return_index=True)
    has_headroom = np.ones(len(voxels), dtype=bool)
    for above in _HEADROOM:
        has_headroom &= ~np.isin(voxels + above, voxels, assume_unique=True)
    is_front = np.ones(len(voxels), dtype=bool)
    for below in _FRONT:
        is_front &= np.isin(voxels - below, voxels, assume_unique=True)
    return points[first[has_headroom & ~is_front]]
