"""HomeRobot's projection: blocks of pixels, each with its first pixel's depth and the mean of its labels.

Each block is one point. It is spread over the eight nearest voxels of a grid before the robot, by nearness; voxels are
rounded to whole points and summed over their height. The sums are turned and shifted onto the map, bilinearly both
times. A cell is an obstacle from half a point on, after a median over 3 x 3 cells, and of a class from one point on. A
block on the edge of two things marks what is behind where the thing before it stands.

The method is that of HomeRobot's semantic map (arXiv 2306.11565).
"""

import math
from typing import NamedTuple

import cv2
import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.mind.mapping.projection import ROLE_COUNT, Box, Channels, Limits, MappedFrame
from uniteam.mind.mapping.view_on_map import CHANNELS, View, ahead, bring_onto_map

BLOCKS_ACROSS = 120
"""Of a frame: 4 x 4 pixels of one that is 480 wide."""
VIEW_CELLS = 100
"""How far the grid before the robot reaches, and how wide it is at least."""
LOWEST, LEVELS = -8, 80
"""Of the voxels: from 40 cm below the floor to 3.6 m above it, in voxels as high as a cell is long."""
OFF_AXIS = 1.15
"""See `map_config.OFF_AXIS`."""
CAMERA_CLEARANCE = 0.01
"""m; what is higher above the camera is no obstacle."""

_RIM, _NONE = 1, 1 << 30


class _Voxels(NamedTuple):
    """The grid before the robot, empty between frames: only what a frame has touched need be emptied after it.

    It has a rim of a voxel on all sides, for what points beside it spread beyond it. What is spread to its first rows,
    columns and levels does not count either, as in HomeRobot.

    Attributes:
        points: (rows, rows, levels, 1 + ROLE_COUNT), how many are in each voxel, and of each role.
        lowest, highest: (rows, rows), the levels between which a column of voxels is not empty.
    """

    points: NDArray[np.float32]
    lowest: NDArray[np.int32]
    highest: NDArray[np.int32]


class AveragedBlocks:
    """Brings frames into the map block by block."""

    def __init__(self) -> None:
        """Begin without voxels; the first frame says how many are needed."""
        self._voxels = _make_voxels(0)

    def __call__(self, frame: MappedFrame, limits: Limits, channels: Channels) -> Box:
        """Bring a frame into the map; return the first row and column and the last ones that may have changed."""
        size = _size(limits)
        if len(self._voxels.lowest) != size + 2 * _RIM:
            self._voxels = _make_voxels(size)
        block = max(1, round(frame.depth.shape[1] / BLOCKS_ACROSS))
        scores = _splat(frame, limits, block, self._voxels)
        view = _sum_levels(self._voxels, frame.camera_to_grid[2, 3], limits)
        view[..., 0] = cv2.medianBlur(np.ascontiguousarray(view[..., 0]), 3)
        return bring_onto_map(view, scores, frame, limits, channels)


def averaged_blocks() -> AveragedBlocks:
    """Begin an episode as HomeRobot does."""
    return AveragedBlocks()


def _make_voxels(size: int) -> _Voxels:
    rows, levels = size + 2 * _RIM, LEVELS + 2 * _RIM
    return _Voxels(
        np.zeros((rows, rows, levels, 1 + ROLE_COUNT), dtype=np.float32),
        np.full((rows, rows), _NONE, dtype=np.int32),
        np.full((rows, rows), -1, dtype=np.int32),
    )


def _size(limits: Limits) -> int:
    farthest = max(limits.max_depth, float(limits.class_depths.max()))
    return max(VIEW_CELLS, math.ceil(OFF_AXIS * farthest * limits.cells_per_metre))


@njit(cache=True, nogil=True)
def _splat(frame: MappedFrame, limits: Limits, block: int, voxels: _Voxels) -> NDArray[np.float32]:  # pragma: no cover
    """Spread a frame's blocks over the voxels; return the (ROLE_COUNT, size, size) best scores at their columns."""
    size = voxels.lowest.shape[0] - 2 * _RIM
    best = np.zeros((ROLE_COUNT, size, size), dtype=np.float32)
    scores = np.zeros(ROLE_COUNT, dtype=np.float32)
    fx, fy, cx, cy = frame.intrinsics
    m = frame.camera_to_grid
    c, s = ahead(m)
    features = np.zeros(1 + ROLE_COUNT, dtype=np.float32)
    is_wanted = _wanted(frame.scores)
    any_wanted = bool(is_wanted.any())
    farthest = max(limits.max_depth, limits.class_depths.max())
    for v in range(0, frame.depth.shape[0] - block + 1, block):
        for u in range(0, frame.depth.shape[1] - block + 1, block):
            z = frame.depth[np.uint64(v), np.uint64(u)]
            if z < limits.min_depth or z > farthest:
                continue
            features[0] = 1.0 if z <= limits.max_depth else 0.0
            has_class = any_wanted and _average(frame, limits, u, v, block, is_wanted, features, scores)
            a, b = (np.float32(u) - cx) / fx, (np.float32(v) - cy) / fy
            x = (m[0, 0] * a + m[0, 1] * b + m[0, 2]) * z
            y = (m[1, 0] * a + m[1, 1] * b + m[1, 2]) * z
            height = (m[2, 0] * a + m[2, 1] * b + m[2, 2]) * z + m[2, 3]
            row = (c * x + s * y) * limits.cells_per_metre
            column = (c * y - s * x) * limits.cells_per_metre + size // 2
            level = height * limits.cells_per_metre - LOWEST
            _spread_point(voxels, features, has_class, row, column, level)
            if has_class and 0 <= row < size - 1 and 0 <= column < size - 1:
                r, k = round(row), round(column)
                for role in range(ROLE_COUNT):
                    best[role, r, k] = max(best[role, r, k], scores[role])
    return best


@njit(cache=True, nogil=True)
def _wanted(scores: NDArray[np.float32]) -> NDArray[np.bool_]:  # pragma: no cover
    """Return which of (D, ROLE_COUNT) detections are of any role."""
    is_wanted = np.zeros(scores.shape[0], dtype=np.bool_)
    for instance in range(scores.shape[0]):
        for role in range(ROLE_COUNT):
            is_wanted[instance] |= scores[instance, role] > 0
    return is_wanted


@njit(cache=True, nogil=True, inline="always")
def _average(
    frame: MappedFrame,
    limits: Limits,
    u: int,
    v: int,
    block: int,
    is_wanted: NDArray[np.bool_],
    features: NDArray[np.float32],
    scores: NDArray[np.float32],
) -> bool:  # pragma: no cover
    """Fill in the share of a block's pixels and their best scores, by role; return whether it has anything of one."""
    z = frame.depth[np.uint64(v), np.uint64(u)]
    share = np.float32(1.0) / np.float32(block * block)
    for role in range(ROLE_COUNT):
        features[1 + role], scores[role] = 0, 0
    has_class = False
    for dv in range(block):
        for du in range(block):
            instance = frame.instances[np.uint64(v + dv), np.uint64(u + du)]
            if instance < 0 or not is_wanted[np.uint64(instance)]:
                continue
            for role in range(ROLE_COUNT):
                score = frame.scores[np.uint64(instance), role]
                if score > 0 and z <= limits.class_depths[role]:
                    features[1 + role] += share
                    scores[role] = max(scores[role], score)
                    has_class = True
    return has_class


@njit(cache=True, nogil=True, inline="always")
def _spread_point(
    voxels: _Voxels, features: NDArray[np.float32], has_class: bool, row: float, column: float, level: float
) -> None:  # pragma: no cover
    """Add a point's features to the eight voxels around it, and note between which levels their columns are filled.

    The first feature is 1 where the point counts for the map, and the others, by role, are all 0 unless it has a class.
    """
    top, left, base = math.floor(row), math.floor(column), math.floor(level)
    size, levels = voxels.lowest.shape[0], voxels.points.shape[2]
    is_near = -1 <= top < size - 2 and -1 <= left < size - 2 and -1 <= base < levels - 2
    points = voxels.points
    solid, first, second, third = features[0], features[1], features[2], features[3]
    below = np.uint64(base + 1)
    for dr in range(2 if is_near else 0):
        for dc in range(2):
            r, k = np.uint64(top + dr + 1), np.uint64(left + dc + 1)
            voxels.lowest[r, k] = min(voxels.lowest[r, k], np.int32(below))
            voxels.highest[r, k] = max(voxels.highest[r, k], np.int32(below) + np.int32(1))
            flat = (1 - abs(row - (top + dr))) * (1 - abs(column - (left + dc)))
            for dl in range(2):
                weight = np.float32(flat * (1 - abs(level - (base + dl))))
                n = below + np.uint64(dl)
                points[r, k, n, 0] += weight * solid
                if has_class:
                    points[r, k, n, 1] += weight * first
                    points[r, k, n, 2] += weight * second
                    points[r, k, n, 3] += weight * third


@njit(cache=True, nogil=True)
def _sum_levels(voxels: _Voxels, camera_height: float, limits: Limits) -> View:  # pragma: no cover
    """Return the sums of whole points over the height, and over the obstacles' heights; the voxels are emptied."""
    size = voxels.lowest.shape[0] - 2 * _RIM
    view = np.zeros((size, size, CHANNELS), dtype=np.float32)
    low = round(limits.min_height * limits.cells_per_metre) - LOWEST
    high = math.floor((camera_height + CAMERA_CLEARANCE) * limits.cells_per_metre) - LOWEST
    for r in range(size + 2 * _RIM):
        for k in range(size + 2 * _RIM):
            is_inside = _RIM < r < size + _RIM and _RIM < k < size + _RIM
            for n in range(voxels.lowest[r, k], voxels.highest[r, k] + 1):
                if is_inside and _RIM < n < LEVELS + _RIM:
                    cell = view[r - _RIM, k - _RIM]
                    points = np.round(voxels.points[r, k, n, 0])
                    cell[1] += points
                    if low <= n - _RIM < high:
                        cell[0] += points
                    for role in range(ROLE_COUNT):
                        cell[2 + role] += np.round(voxels.points[r, k, n, 1 + role])
                voxels.points[r, k, n] = 0
            voxels.lowest[r, k], voxels.highest[r, k] = _NONE, -1
    return view
