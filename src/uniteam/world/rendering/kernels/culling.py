"""Which parts of a scene can be seen, and in what order to draw them: a view frustum and a coarse depth buffer."""

import math

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.world.rendering.kernels.scene_buffers import SceneBuffers

NEAR = 0.05
"""Nothing nearer than this along the optical axis is drawn (m)."""

TILE = 8
"""Side of a tile of the coarse depth buffer (pixels)."""


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def screen_bounds(
    buffers: SceneBuffers, projection: NDArray[np.float32], width: int, height: int
) -> NDArray[np.float32]:
    """Return (P, 5): low and high column, low and high row of each part's box on the screen, largest inverse depth.

    A part that cannot be seen has inverse depth -1; one that reaches through the near plane covers the whole screen.

    Args:
        buffers: of the scene.
        projection: (3, 4) float32 from the world to pixel coordinates times depth (intrinsics @ world_to_camera).
        width, height: of the image.
    """
    count = buffers.part_boxes.shape[0]
    bounds = np.empty((count, 5), dtype=np.float32)
    near = np.float32(NEAR)
    for part in range(count):
        bounds[part, 4] = -1.0
        if not buffers.part_visible[part]:
            continue
        low_u, high_u, low_v, high_v = np.float32(1e9), np.float32(-1e9), np.float32(1e9), np.float32(-1e9)
        nearest, farthest = np.float32(1e9), np.float32(-1e9)
        left, right, above, below = True, True, True, True
        for k in range(8):
            x, y, z = buffers.part_boxes[part, k, 0], buffers.part_boxes[part, k, 1], buffers.part_boxes[part, k, 2]
            u = projection[0, 0] * x + projection[0, 1] * y + projection[0, 2] * z + projection[0, 3]
            v = projection[1, 0] * x + projection[1, 1] * y + projection[1, 2] * z + projection[1, 3]
            w = projection[2, 0] * x + projection[2, 1] * y + projection[2, 2] * z + projection[2, 3]
            nearest, farthest = min(nearest, w), max(farthest, w)
            left &= u < np.float32(-0.5) * w
            right &= u > (np.float32(width) - np.float32(0.5)) * w
            above &= v < np.float32(-0.5) * w
            below &= v > (np.float32(height) - np.float32(0.5)) * w
            if w > near:
                low_u, high_u = min(low_u, u / w), max(high_u, u / w)
                low_v, high_v = min(low_v, v / w), max(high_v, v / w)
        if farthest < near or left or right or above or below:
            continue
        if nearest < near:
            bounds[part, 0], bounds[part, 1], bounds[part, 2], bounds[part, 3] = 0.0, width - 1, 0.0, height - 1
            bounds[part, 4] = np.float32(1.0) / near
            continue
        bounds[part, 0] = max(low_u - np.float32(1.0), np.float32(0.0))
        bounds[part, 1] = min(high_u + np.float32(1.0), np.float32(width - 1))
        bounds[part, 2] = max(low_v - np.float32(1.0), np.float32(0.0))
        bounds[part, 3] = min(high_v + np.float32(1.0), np.float32(height - 1))
        bounds[part, 4] = np.float32(1.0) / nearest
    return bounds


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def may_be_seen(
    vertices: NDArray[np.float32],
    triangles: NDArray[np.int32],
    projection: NDArray[np.float32],
    width: int,
    height: int,
) -> bool:
    """Return False where each triangle lies wholly beyond one side of the view, or before the near plane.

    Args:
        vertices: (N, 3) of a mesh (m), in any frame.
        triangles: (T, 3) of them.
        projection: (3, 4) float32 from that frame to pixel coordinates times depth.
        width, height: of the image.
    """
    sides = np.empty(vertices.shape[0], dtype=np.uint8)
    for k in range(vertices.shape[0]):
        x, y, z = vertices[k, 0], vertices[k, 1], vertices[k, 2]
        u = projection[0, 0] * x + projection[0, 1] * y + projection[0, 2] * z + projection[0, 3]
        v = projection[1, 0] * x + projection[1, 1] * y + projection[1, 2] * z + projection[1, 3]
        w = projection[2, 0] * x + projection[2, 1] * y + projection[2, 2] * z + projection[2, 3]
        beyond = 1 if u < np.float32(-1.0) * w else 0
        beyond |= 2 if u > np.float32(width) * w else 0
        beyond |= 4 if v < np.float32(-1.0) * w else 0
        beyond |= 8 if v > np.float32(height) * w else 0
        beyond |= 16 if w < np.float32(NEAR) else 0
        sides[k] = beyond
    for t in range(triangles.shape[0]):
        if sides[triangles[t, 0]] & sides[triangles[t, 1]] & sides[triangles[t, 2]] == 0:
            return True
    return False


@njit(cache=True, nogil=True, error_model="numpy")
def drawing_order(bounds: NDArray[np.float32], is_stage: NDArray[np.bool_]) -> NDArray[np.int32]:
    """Return the parts that can be seen: the stage first, then the others, each from the nearest to the farthest."""
    order = np.empty(bounds.shape[0], dtype=np.int32)
    count = 0
    for part in range(bounds.shape[0]):
        if bounds[part, 4] < 0.0:
            continue
        slot = count
        while slot > 0 and _is_before(part, order[slot - 1], bounds, is_stage):
            order[slot] = order[slot - 1]
            slot -= 1
        order[slot] = part
        count += 1
    return order[:count]


@njit(cache=True, nogil=True, error_model="numpy")
def _is_before(part: int, other: int, bounds: NDArray[np.float32], is_stage: NDArray[np.bool_]) -> bool:
    if is_stage[part] != is_stage[other]:
        return is_stage[part]
    return bounds[part, 4] > bounds[other, 4]


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def coarsen(inverse_depth: NDArray[np.float32], coarse: NDArray[np.float32]) -> None:
    """Write the smallest inverse depth of each tile: (H, W) float32 to (ceil(H / TILE), ceil(W / TILE))."""
    height, width = inverse_depth.shape
    for row in range(coarse.shape[0]):
        for column in range(coarse.shape[1]):
            coarse[row, column] = np.float32(1e9)
    for y in range(height):
        row = y // TILE
        for column in range(coarse.shape[1]):
            smallest = coarse[row, column]
            for x in range(column * TILE, min(column * TILE + TILE, width)):
                smallest = min(smallest, inverse_depth[y, x])
            coarse[row, column] = smallest


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def is_hidden(bound: NDArray[np.float32], coarse: NDArray[np.float32]) -> bool:
    """Say whether everything drawn so far is nearer than a part, over its whole rectangle (5,) of the screen."""
    first_column, last_column = int(bound[0]) // TILE, math.ceil(bound[1]) // TILE
    first_row, last_row = int(bound[2]) // TILE, math.ceil(bound[3]) // TILE
    for row in range(first_row, min(last_row, coarse.shape[0] - 1) + 1):
        for column in range(first_column, min(last_column, coarse.shape[1] - 1) + 1):
            if coarse[row, column] < bound[4]:
                return False
    return True
