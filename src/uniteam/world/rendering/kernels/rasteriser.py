"""Which triangle is seen at each pixel, and how far it is: a scan-line rasteriser.

An edge is always walked from its upper to its lower end, so two triangles that share it agree to the bit on the pixels
at its two sides: a closed surface has no holes. Inverse depth is linear on the screen, so it needs no correction.
"""

import math

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.world.rendering.kernels.culling import NEAR, TILE, coarsen, drawing_order, is_hidden, screen_bounds
from uniteam.world.rendering.kernels.scene_buffers import SceneBuffers, Workspace

Corner = tuple[np.float64, np.float64, np.float64]
"""Column, row and inverse depth (1/m) of a triangle's corner, in double precision: it may lie far off the screen."""

PARTS_BETWEEN_COARSENINGS = 12
"""So many parts are drawn before the coarse depth buffer is brought up to date."""


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def rasterise(buffers: SceneBuffers, projection: NDArray[np.float32], workspace: Workspace) -> None:
    """Draw every visible part.

    Args:
        buffers: of the scene.
        projection: (3, 4) float32 from the world to pixel coordinates times depth (intrinsics @ world_to_camera).
        workspace: output.
    """
    screen, inverse_depth, triangle_at = workspace.screen, workspace.inverse_depth, workspace.triangle_at
    height, width = inverse_depth.shape
    inverse_depth[:] = 0.0
    triangle_at[:] = -1
    bounds = screen_bounds(buffers, projection, width, height)
    order = drawing_order(bounds, buffers.part_is_stage)
    coarse = np.zeros(((height + TILE - 1) // TILE, (width + TILE - 1) // TILE), dtype=np.float32)
    drawn = PARTS_BETWEEN_COARSENINGS
    for part in order:
        if not buffers.part_is_stage[part]:
            if drawn >= PARTS_BETWEEN_COARSENINGS:
                coarsen(inverse_depth, coarse)
                drawn = 0
            if is_hidden(bounds[part], coarse):
                continue
            drawn += 1
        _project_part(buffers, part, projection, screen)
        _draw_part(buffers, part, projection, screen, inverse_depth, triangle_at)


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def _project_part(
    buffers: SceneBuffers, part: int, projection: NDArray[np.float32], screen: NDArray[np.float32]
) -> None:
    """Write the screen position of a part's vertices; inverse depth is -1 in front of the near plane."""
    near = np.float32(NEAR)
    for k in range(buffers.part_ranges[part, 0], buffers.part_ranges[part, 1]):
        x, y, z = buffers.vertices[k, 0], buffers.vertices[k, 1], buffers.vertices[k, 2]
        w = projection[2, 0] * x + projection[2, 1] * y + projection[2, 2] * z + projection[2, 3]
        inverse = np.float32(1.0) / max(w, near)
        screen[k, 0] = (projection[0, 0] * x + projection[0, 1] * y + projection[0, 2] * z + projection[0, 3]) * inverse
        screen[k, 1] = (projection[1, 0] * x + projection[1, 1] * y + projection[1, 2] * z + projection[1, 3]) * inverse
        screen[k, 2] = inverse if w >= near else np.float32(-1.0)


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def _draw_part(
    buffers: SceneBuffers,
    part: int,
    projection: NDArray[np.float32],
    screen: NDArray[np.float32],
    inverse_depth: NDArray[np.float32],
    triangle_at: NDArray[np.int32],
) -> None:
    triangles = buffers.triangles
    last_row, last_column = np.float32(inverse_depth.shape[0] - 1), np.float32(inverse_depth.shape[1] - 1)
    for t in range(buffers.part_ranges[part, 2], buffers.part_ranges[part, 3]):
        a, b, c = np.uint64(triangles[t, 0]), np.uint64(triangles[t, 1]), np.uint64(triangles[t, 2])
        wa, wb, wc = screen[a, 2], screen[b, 2], screen[c, 2]
        if min(wa, wb, wc) < np.float32(0.0):
            if max(wa, wb, wc) > np.float32(0.0):
                _draw_clipped(buffers, t, projection, inverse_depth, triangle_at)
            continue
        xa, xb, xc = screen[a, 0], screen[b, 0], screen[c, 0]
        ya, yb, yc = screen[a, 1], screen[b, 1], screen[c, 1]
        low_x, high_x = max(min(xa, xb, xc), np.float32(0.0)), min(max(xa, xb, xc), last_column)
        low_y, high_y = max(min(ya, yb, yc), np.float32(0.0)), min(max(ya, yb, yc), last_row)
        if math.ceil(low_x) > high_x or math.ceil(low_y) > high_y:
            continue
        _fill(
            inverse_depth, triangle_at, t, _corner(xa, ya, wa), _corner(xb, yb, wb), _corner(xc, yc, wc)
        )  # fmt: skip


@njit(cache=True, nogil=True, error_model="numpy")
def _corner(x: np.float32, y: np.float32, w: np.float32) -> Corner:
    return np.float64(x), np.float64(y), np.float64(w)


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def _draw_clipped(
    buffers: SceneBuffers,
    t: int,
    projection: NDArray[np.float32],
    inverse_depth: NDArray[np.float32],
    triangle_at: NDArray[np.int32],
) -> None:
    """Cut a triangle at the near plane and draw what remains of it: one triangle or two."""
    corner = np.empty((3, 3), dtype=np.float64)
    for k in range(3):
        v = buffers.triangles[t, k]
        x, y, z = buffers.vertices[v, 0], buffers.vertices[v, 1], buffers.vertices[v, 2]
        for i in range(3):
            corner[k, i] = projection[i, 0] * x + projection[i, 1] * y + projection[i, 2] * z + projection[i, 3]
    polygon = np.empty((4, 3), dtype=np.float64)
    count = 0
    for k in range(3):
        here, there = corner[k], corner[(k + 1) % 3]
        if here[2] >= NEAR:
            polygon[count] = here
            count += 1
        if (here[2] >= NEAR) != (there[2] >= NEAR):
            # Cut from the far end, so that the triangle beyond this edge is cut at the same point to the bit.
            far_end, near_end = (here, there) if here[2] >= NEAR else (there, here)
            share = (far_end[2] - NEAR) / (far_end[2] - near_end[2])
            polygon[count] = far_end + share * (near_end - far_end)
            count += 1
    for k in range(count):
        polygon[k, 0] /= polygon[k, 2]
        polygon[k, 1] /= polygon[k, 2]
        polygon[k, 2] = 1.0 / polygon[k, 2]
    for k in range(1, count - 1):
        a, b, c = polygon[0], polygon[k], polygon[k + 1]
        _fill(inverse_depth, triangle_at, t, (a[0], a[1], a[2]), (b[0], b[1], b[2]), (c[0], c[1], c[2]))


# Sums keep their order here (no `fastmath=True`), so that an edge is the same edge from both of its sides. That is also
# why numba must not inline it: it would take its caller's flags.
@njit(cache=True, nogil=True, fastmath={"nnan", "ninf", "nsz"}, error_model="numpy")
def _fill(
    inverse_depth: NDArray[np.float32], triangle_at: NDArray[np.int32], t: int, p0: Corner, p1: Corner, p2: Corner
) -> None:
    """Draw a triangle given by its corners where it is nearer than what was drawn before."""
    if p1[1] < p0[1]:
        p0, p1 = p1, p0
    if p2[1] < p1[1]:
        p1, p2 = p2, p1
        if p1[1] < p0[1]:
            p0, p1 = p1, p0
    (x0, y0, w0), (x1, y1, w1), (x2, y2, w2) = p0, p1, p2
    height, width = inverse_depth.shape
    first_row, last_row = max(math.ceil(y0), 0), min(math.floor(y2), height - 1)
    area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
    if first_row > last_row or area == 0.0:
        return
    slope_x = ((w1 - w0) * (y2 - y0) - (w2 - w0) * (y1 - y0)) / area
    slope_y = ((w2 - w0) * (x1 - x0) - (w1 - w0) * (x2 - x0)) / area
    lowest, highest, step = np.float32(min(w0, w1, w2)), np.float32(max(w0, w1, w2)), np.float32(slope_x)
    long_edge = (x2 - x0) / (y2 - y0)
    upper_edge = (x1 - x0) / (y1 - y0) if y1 > y0 else 0.0
    lower_edge = (x2 - x1) / (y2 - y1) if y2 > y1 else 0.0
    number = np.int32(t)
    for y in range(first_row, last_row + 1):
        edge_long = x0 + (y - y0) * long_edge
        edge_short = x0 + (y - y0) * upper_edge if y < y1 else x1 + (y - y1) * lower_edge
        first = math.ceil(max(min(edge_long, edge_short), 0.0))
        last = math.floor(min(max(edge_long, edge_short), width - 1.0))
        if first > last:
            continue
        start = np.float32(w0 + (first - x0) * slope_x + (y - y0) * slope_y)
        # Counted from zero in slices, and written in any case, so that the compiler takes many pixels at once.
        nearest, seen = inverse_depth[y, first : last + 1], triangle_at[y, first : last + 1]
        for k in range(nearest.shape[0]):
            nearness = min(max(start + np.float32(np.int32(k)) * step, lowest), highest)
            is_nearer = nearness > nearest[k]
            seen[k] = number if is_nearer else seen[k]
            nearest[k] = nearness if is_nearer else nearest[k]
