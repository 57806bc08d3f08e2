"""What depth says of each cell of a frame: how near it is, whether it was measured, how high it is above the floor."""

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import PinholeCamera

STRIDE = 4
"""Pixels of a cell's side."""
GEOMETRY_CHANNELS = 3
_HIGHEST = 3.0


def geometry_image(
    depth: NDArray[np.float32], camera: PinholeCamera, camera_to_start: NDArray[np.float64]
) -> NDArray[np.float32]:
    """Return the (GEOMETRY_CHANNELS, H / STRIDE, W / STRIDE) geometry of a (H, W) image of depth (m).

    The channels: the inverse of the depth (1/m), 1 where there is depth, half the height above the floor (m).
    """
    rows = np.arange(STRIDE // 2, depth.shape[0], STRIDE)
    columns = np.arange(STRIDE // 2, depth.shape[1], STRIDE)
    z = depth[rows][:, columns]
    is_seen = z > 0
    x, y = (columns - camera.cx) / camera.fx, (rows - camera.cy) / camera.fy
    rising = camera_to_start[2, 0] * x[None, :] + camera_to_start[2, 1] * y[:, None] + camera_to_start[2, 2]
    height = np.clip(z * rising + camera_to_start[2, 3], -0.5, _HIGHEST)
    nearness = 1.0 / np.maximum(z, 0.25)
    return np.stack([nearness * is_seen, is_seen, height * is_seen / 2.0]).astype(np.float32)
