"""Colour, depth and instance of every pixel, once it is known which triangle it sees.

Where a pixel's ray meets its triangle follows from the triangle's corners in the world (the ray-triangle test of Möller
and Trumbore, 1997, with its cross products done once a triangle), so texture coordinates are right in perspective and
clipping needs no care.
"""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.stretch import DEPTH_RANGE
from uniteam.world.rendering.kernels.scene_buffers import SceneBuffers, Workspace

BACKGROUND = (196, 206, 214)
"""Colour (RGB) where nothing is seen."""

Pair = tuple[np.float32, np.float32]
Triple = tuple[np.float32, np.float32, np.float32]

FLOOR_LEVEL = 0.04
"""What is no higher than this lies in the furniture's shade: floors and rugs (m)."""

_LAYOUT_LEVELS = 3
"""Column of the texture layout where the levels' starts begin."""


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def shade(
    buffers: SceneBuffers,
    rays: NDArray[np.float32],
    workspace: Workspace,
    rgb: NDArray[np.uint8],
    depth: NDArray[np.float32],
    instances: NDArray[np.int16],
) -> None:
    """Write what is seen.

    Args:
        buffers: of the scene.
        rays: (4, 3) float32, world: the camera's position, the ray through pixel (0, 0) with unit depth, and how the
            ray changes from one column and from one row to the next.
        workspace: as the rasteriser left it.
        rgb, depth, instances: outputs of `Frame`.
    """
    inverse_depth, triangle_at = workspace.inverse_depth, workspace.triangle_at
    height, width = triangle_at.shape
    pixel_area = _norm(_cross(_row(rays, 2), _row(rays, 3)))
    center = _row(rays, 0)
    one, zero = np.float32(1.0), np.float32(0.0)
    previous = -1
    for y in range(height):
        ray_y = np.float32(y)
        start_x = rays[1, 0] + ray_y * rays[3, 0]
        start_y = rays[1, 1] + ray_y * rays[3, 1]
        start_z = rays[1, 2] + ray_y * rays[3, 2]
        for x in range(width):
            t = triangle_at[y, x]
            if t < 0:
                rgb[y, x, 0], rgb[y, x, 1], rgb[y, x, 2] = BACKGROUND
                depth[y, x] = zero
                instances[y, x] = -1
                continue
            if t != previous:
                previous = t
                a, b, c = buffers.triangles[t, 0], buffers.triangles[t, 1], buffers.triangles[t, 2]
                origin = _row(buffers.vertices, a)
                edge_1 = _minus(_row(buffers.vertices, b), origin)
                edge_2 = _minus(_row(buffers.vertices, c), origin)
                offset = _minus(center, origin)
                normal = _cross(edge_2, edge_1)
                across_1 = _cross(edge_2, offset)
                across_2 = _cross(offset, edge_1)
                # The camera is on one side of a triangle's plane, whichever of its pixels is looked at.
                side = 0 if _dot(offset, normal) < zero else 1
                light_0 = buffers.light[a, side]
                light_1, light_2 = buffers.light[b, side] - light_0, buffers.light[c, side] - light_0
                is_low = max(origin[2], origin[2] + edge_1[2], origin[2] + edge_2[2]) < np.float32(FLOOR_LEVEL)
                part, material = buffers.triangle_parts[t], buffers.triangle_materials[t]
                label = buffers.part_labels[part]
                red = buffers.part_tints[part, 0] * buffers.material_colors[material, 0]
                green = buffers.part_tints[part, 1] * buffers.material_colors[material, 1]
                blue = buffers.part_tints[part, 2] * buffers.material_colors[material, 2]
                texture = buffers.material_textures[material]
                is_plain = buffers.texture_layout[texture, 2] == 0
                texel_area = buffers.texel_areas[t] * pixel_area
                u0, v0 = buffers.uvs[a, 0], buffers.uvs[a, 1]
                u1, v1 = buffers.uvs[b, 0] - u0, buffers.uvs[b, 1] - v0
                u2, v2 = buffers.uvs[c, 0] - u0, buffers.uvs[c, 1] - v0
            step = np.float32(x)
            ray = (start_x + step * rays[2, 0], start_y + step * rays[2, 1], start_z + step * rays[2, 2])
            facing = _dot(ray, normal)
            inverse = one / facing if facing != zero else zero
            share_1 = min(max(_dot(ray, across_1) * inverse, zero), one)
            share_2 = min(max(_dot(ray, across_2) * inverse, zero), one)
            distance = one / inverse_depth[y, x]
            light = light_0 + share_1 * light_1 + share_2 * light_2
            if is_low:
                light *= _floor_light(
                    buffers.floor_shade,
                    buffers.floor_frame,
                    origin[0] + share_1 * edge_1[0] + share_2 * edge_2[0],
                    origin[1] + share_1 * edge_1[1] + share_2 * edge_2[1],
                )
            texel_red = texel_green = texel_blue = np.float32(255.0)
            if not is_plain:
                uv = (u0 + share_1 * u1 + share_2 * u2, v0 + share_1 * v1 + share_2 * v2)
                footprint = texel_area * distance * distance * abs(inverse)
                texel_red, texel_green, texel_blue = _sample(
                    buffers.texels, buffers.texture_layout, texture, uv, footprint
                )
            rgb[y, x, 0] = np.uint8(min(texel_red * red * light, np.float32(255.0)))
            rgb[y, x, 1] = np.uint8(min(texel_green * green * light, np.float32(255.0)))
            rgb[y, x, 2] = np.uint8(min(texel_blue * blue * light, np.float32(255.0)))
            depth[y, x] = distance if distance <= np.float32(DEPTH_RANGE) else zero
            instances[y, x] = label


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy", inline="always")
def _sample(
    texels: NDArray[np.uint32], layouts: NDArray[np.int32], texture: int, uv: Pair, footprint: np.float32
) -> Triple:
    """Return the bilinear colour at (u, v) of the level whose texels are about as large as the pixel's footprint."""
    level = min(_mip_level(footprint), layouts[texture, 2])
    log2_width, log2_height = max(layouts[texture, 0] - level, 0), max(layouts[texture, 1] - level, 0)
    columns, rows = 1 << log2_width, 1 << log2_height
    column = uv[0] * np.float32(columns) - np.float32(0.5)
    row = uv[1] * np.float32(rows) - np.float32(0.5)
    low_column, low_row = np.floor(column), np.floor(row)
    right, down = column - low_column, row - low_row
    x0, y0 = np.int64(low_column) & (columns - 1), np.int64(low_row) & (rows - 1)
    upper = np.int64(layouts[texture, _LAYOUT_LEVELS + level]) + y0 * (columns + 1) + x0
    lower = upper + columns + 1
    a, b, c, d = texels[upper], texels[upper + 1], texels[lower], texels[lower + 1]
    one = np.float32(1.0)
    wa, wb, wc, wd = (one - right) * (one - down), right * (one - down), (one - right) * down, right * down
    red = wa * _channel(a, 0) + wb * _channel(b, 0) + wc * _channel(c, 0) + wd * _channel(d, 0)
    green = wa * _channel(a, 8) + wb * _channel(b, 8) + wc * _channel(c, 8) + wd * _channel(d, 8)
    blue = wa * _channel(a, 16) + wb * _channel(b, 16) + wc * _channel(c, 16) + wd * _channel(d, 16)
    return red, green, blue


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy", inline="always")
def _channel(texel: np.uint32, shift: int) -> np.float32:
    return np.float32(np.int32((texel >> np.uint32(shift)) & np.uint32(255)))


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy", inline="always")
def _floor_light(shade: NDArray[np.float32], frame: NDArray[np.float32], x: np.float32, y: np.float32) -> np.float32:
    """Return the share of light left at a point of the floor (m, world), between the centres of four cells."""
    one, zero = np.float32(1.0), np.float32(0.0)
    column = min(max((x - frame[0]) * frame[2], zero), np.float32(shade.shape[1] - 1))
    row = min(max((y - frame[1]) * frame[2], zero), np.float32(shade.shape[0] - 1))
    x0, y0 = np.int64(column), np.int64(row)
    x1, y1 = min(x0 + 1, shade.shape[1] - 1), min(y0 + 1, shade.shape[0] - 1)
    right, up = column - np.float32(x0), row - np.float32(y0)
    lower = shade[y0, x0] * (one - right) + shade[y0, x1] * right
    upper = shade[y1, x0] * (one - right) + shade[y1, x1] * right
    return lower * (one - up) + upper * up


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy", inline="always")
def _mip_level(footprint: np.float32) -> int:
    """Return half the binary logarithm of a pixel's area in texels, rounded: each level quarters it."""
    exponent = (np.float32(footprint * np.float32(2.0)).view(np.int32) >> 23) - 127
    return max(int(exponent) >> 1, 0)


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy", inline="always")
def _row(array: NDArray[np.float32], k: int) -> Triple:
    return array[k, 0], array[k, 1], array[k, 2]


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy", inline="always")
def _minus(a: Triple, b: Triple) -> Triple:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy", inline="always")
def _cross(a: Triple, b: Triple) -> Triple:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy", inline="always")
def _dot(a: Triple, b: Triple) -> np.float32:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy", inline="always")
def _norm(a: Triple) -> np.float32:
    return np.sqrt(_dot(a, a))
