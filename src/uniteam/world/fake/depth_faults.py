"""What a stereo camera makes of depth: noise that grows with the distance, and patches in which nothing returns."""

import cv2
import numpy as np
from numpy.typing import NDArray

PATCH = 8
"""Side of a hole's patches (pixels)."""


def with_faults(
    depth: NDArray[np.float32], noise: float, holes: float, rng: np.random.Generator
) -> NDArray[np.float32]:
    """Return (H, W) depth (m) with a camera's errors; the same array where there are none.

    Args:
        depth: 0 where nothing returned.
        noise: standard deviation (m) at 1 m; that of stereo grows with the square of the distance.
        holes: share of the image without depth.
        rng: what the errors are drawn from.
    """
    if noise == 0.0 and holes == 0.0:
        return depth
    spread = rng.standard_normal(depth.shape, np.float32) * np.float32(noise) * depth * depth
    faulty = np.where(depth > 0.0, np.clip(depth + spread, 0.001, 65.0), 0.0).astype(np.float32)
    rows, columns = depth.shape
    patches = (rng.random((-(-rows // PATCH), -(-columns // PATCH))) < holes).astype(np.uint8)
    is_hole = cv2.resize(patches, (columns, rows), interpolation=cv2.INTER_NEAREST) > 0
    faulty[is_hole] = 0.0
    return faulty
