"""Depth and instance of every pixel without its colour, for those who do not look at colours: a learner on depth."""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.stretch import DEPTH_RANGE
from uniteam.world.rendering.kernels.scene_buffers import SceneBuffers, Workspace


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def measure(
    buffers: SceneBuffers, workspace: Workspace, depth: NDArray[np.float32], instances: NDArray[np.int16]
) -> None:
    """Write what `shade` writes beside the colours, to the bit.

    Args:
        buffers: of the scene.
        workspace: as the rasteriser left it.
        depth, instances: outputs of `Geometry`.
    """
    inverse_depth, triangle_at = workspace.inverse_depth, workspace.triangle_at
    height, width = triangle_at.shape
    one, zero = np.float32(1.0), np.float32(0.0)
    for y in range(height):
        for x in range(width):
            t = triangle_at[y, x]
            if t < 0:
                depth[y, x] = zero
                instances[y, x] = -1
                continue
            distance = one / inverse_depth[y, x]
            depth[y, x] = distance if distance <= np.float32(DEPTH_RANGE) else zero
            instances[y, x] = buffers.part_labels[buffers.triangle_parts[t]]
