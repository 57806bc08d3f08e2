"""Patches of floor that are taken for furniture: where the light falls, where a rug or the grain of the wood is."""

from dataclasses import dataclass
from statistics import NormalDist

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import transform_points
from uniteam.interface import Observation
from uniteam.mind.perception.noise.random_field import RandomField

FLAT = 0.04
"""m; what is no higher than this, and no deeper, is floor."""
PATCH_LENGTH = 0.5
"""m; how far apart patches are about as likely as not to be one."""
SMALLEST_PATCH = 60
"""Pixels of a frame of 240 x 320."""
STRIDE = 4
"""Every fourth pixel of a row and of a column is looked up."""


@dataclass(frozen=True)
class FloorPatch:
    """A patch of floor: its (H, W) mask, and its middle (2,) on the floor (m, start frame)."""

    mask: NDArray[np.bool_]
    middle: NDArray[np.float64]


def floor_patches(
    observation: Observation, free: NDArray[np.bool_], field: RandomField, share: float
) -> list[FloorPatch]:
    """Return the patches of floor that are taken for something; they lie where they lie, from wherever they are seen.

    Args:
        observation: the frame.
        free: (H, W) pixels that show none of what is there.
        field: of points (x, y) of the floor; where it is highest, patches are.
        share: of the floor that is in patches; a lower one leaves parts of the same patches.
    """
    if share <= 0.0:
        return []
    some = (slice(STRIDE // 2, None, STRIDE),) * 2
    points = transform_points(observation.camera_to_start, observation.camera.unproject(observation.depth)[some])
    is_floor = free[some] & (observation.depth[some] > 0) & (np.abs(points[..., 2]) <= FLAT)
    high = np.zeros(is_floor.shape, dtype=np.uint8)
    high[is_floor] = field(points[is_floor][:, :2]) > NormalDist().inv_cdf(1.0 - share)
    count, labels, statistics, _ = cv2.connectedComponentsWithStats(high, connectivity=8)
    smallest = SMALLEST_PATCH * observation.depth.size / (76_800 * STRIDE**2)
    return [
        FloorPatch(_at_full_size(labels == k, free), points[labels == k][:, :2].mean(axis=0))
        for k in range(1, count)
        if statistics[k, cv2.CC_STAT_AREA] >= smallest
    ]


def _at_full_size(mask: NDArray[np.bool_], free: NDArray[np.bool_]) -> NDArray[np.bool_]:
    large = np.kron(mask, np.ones((STRIDE, STRIDE), dtype=bool))
    full = np.zeros(free.shape, dtype=bool)
    height, width = min(large.shape[0], free.shape[0]), min(large.shape[1], free.shape[1])
    full[:height, :width] = large[:height, :width]
    return full & free
