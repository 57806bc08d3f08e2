"""Colour, depth and instance of every pixel, once it is known which triangle it sees.

A ray of unit depth meets its pixel's triangle at the pixel's distance, which the rasteriser knows. What changes evenly
over a triangle (texture coordinates, light) is then linear in the ray times that distance: the ray-triangle test of
Möller and Trumbore (1997) with its products done once a triangle. So texture coordinates are right in perspective and
clipping needs no care. Pixels of one triangle that stand side by side, a run, are shaded together.
"""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.stretch import DEPTH_RANGE
from uniteam.world.rendering.kernels.scene_buffers import SceneBuffers, Workspace

BACKGROUND = (196, 206, 214)
"""Colour (RGB) where nothing is seen."""

Triple = tuple[np.float32, np.float32, np.float32]

FLOOR_LEVEL = 0.04
"""What is no higher than this lies in the furniture's shade: floors and rugs (m)."""
LONGEST_RUN = 32
"""Pixels that share a level of their texture: so few that the right one hardly changes."""

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
    column_step = _row(rays, 2)
    pixel_area = _norm(_cross(column_step, _row(rays, 3)))
    center = _row(rays, 0)
    one, zero, full = np.float32(1.0), np.float32(0.0), np.float32(255.0)
    previous = -1
    for y in range(height):
        row = np.float32(y)
        row_start = (rays[1, 0] + row * rays[3, 0], rays[1, 1] + row * rays[3, 1], rays[1, 2] + row * rays[3, 2])
        end = 0
        while end < width:
            first, t = end, triangle_at[y, end]
            end += 1
            while end < width and end - first < LONGEST_RUN and triangle_at[y, end] == t:
                end += 1
            if t < 0:
                for x in range(first, end):
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
                across_1, across_2 = _cross(edge_2, offset), _cross(offset, edge_1)
                volume = _dot(offset, _cross(edge_2, edge_1))
                inverse = -one / volume if volume != zero else zero
                # The camera is on one side of a triangle's plane, whichever of its pixels is looked at.
                side = 0 if volume < zero else 1
                light_0, light_1, light_2 = buffers.light[a, side], buffers.light[b, side], buffers.light[c, side]
                darkest, brightest = min(light_0, light_1, light_2), max(light_0, light_1, light_2)
                light_gradient = _mix(across_1, (light_1 - light_0) * inverse, across_2, (light_2 - light_0) * inverse)
                light_step = _dot(column_step, light_gradient)
                is_low = max(origin[2], origin[2] + edge_1[2], origin[2] + edge_2[2]) < np.float32(FLOOR_LEVEL)
                part, material = buffers.triangle_parts[t], buffers.triangle_materials[t]
                label = buffers.part_labels[part]
                texture = buffers.material_textures[material]
                is_plain = buffers.texture_layout[texture, 2] == 0
                scale = full if is_plain else one / np.float32(256.0)
                red = buffers.part_tints[part, 0] * buffers.material_colors[material, 0] * scale
                green = buffers.part_tints[part, 1] * buffers.material_colors[material, 1] * scale
                blue = buffers.part_tints[part, 2] * buffers.material_colors[material, 2] * scale
                footprint = buffers.texel_areas[t] * pixel_area * abs(inverse)
                u0, v0 = buffers.uvs[a, 0], buffers.uvs[a, 1]
                u1, v1 = (buffers.uvs[b, 0] - u0) * inverse, (buffers.uvs[b, 1] - v0) * inverse
                u2, v2 = (buffers.uvs[c, 0] - u0) * inverse, (buffers.uvs[c, 1] - v0) * inverse
                u_gradient, v_gradient = _mix(across_1, u1, across_2, u2), _mix(across_1, v1, across_2, v2)
                u_step, v_step = _dot(column_step, u_gradient), _dot(column_step, v_gradient)
            light_start = _dot(row_start, light_gradient)
            u_start, v_start = _dot(row_start, u_gradient), _dot(row_start, v_gradient)
            middle = one / inverse_depth[y, (first + end - 1) >> 1]
            level = min(_mip_level(footprint * middle * middle * middle), buffers.texture_layout[texture, 2])
            columns = np.int64(1) << max(buffers.texture_layout[texture, 0] - level, 0)
            rows = np.int64(1) << max(buffers.texture_layout[texture, 1] - level, 0)
            level_start = np.int64(buffers.texture_layout[texture, _LAYOUT_LEVELS + level])
            inverse_run, depth_run = inverse_depth[y, first:end], depth[y, first:end]
            instance_run, rgb_run = instances[y, first:end], rgb[y, first:end]
            start = np.float32(first)
            for k in range(inverse_run.shape[0]):
                step = start + np.float32(np.int32(k))
                distance = one / inverse_run[k]
                light = light_0 + distance * (light_start + step * light_step)
                light = min(max(light, darkest), brightest)
                if is_low:
                    light *= _floor_light(
                        buffers.floor_shade,
                        buffers.floor_frame,
                        center[0] + distance * (row_start[0] + step * column_step[0]),
                        center[1] + distance * (row_start[1] + step * column_step[1]),
                    )
                texel = (one, one, one)
                if not is_plain:
                    u = u0 + distance * (u_start + step * u_step)
                    v = v0 + distance * (v_start + step * v_step)
                    texel = _sample(buffers.texels, level_start, columns, rows, u, v)
                rgb_run[k, 0] = np.uint8(np.int32(min(texel[0] * red * light, full)))
                rgb_run[k, 1] = np.uint8(np.int32(min(texel[1] * green * light, full)))
                rgb_run[k, 2] = np.uint8(np.int32(min(texel[2] * blue * light, full)))
                depth_run[k] = distance if distance <= np.float32(DEPTH_RANGE) else zero
                instance_run[k] = label


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy", inline="always")
def _sample(
    texels: NDArray[np.uint32], start: np.int64, columns: np.int64, rows: np.int64, u: np.float32, v: np.float32
) -> Triple:
    """Return the bilinear colour, 0 to 255 * 256, at (u, v) of the level of a texture that begins at `start`.

    Weights are multiples of 1/256, so red and blue, which stand 16 bits apart, are weighed in one product.
    """
    column, row = u * np.float32(columns) - np.float32(0.5), v * np.float32(rows) - np.float32(0.5)
    low_column, low_row = np.floor(column), np.floor(row)
    right = np.int64((column - low_column) * np.float32(256.0))
    down = np.int64((row - low_row) * np.float32(256.0))
    x, y = np.int64(low_column) & (columns - 1), np.int64(low_row) & (rows - 1)
    upper = start + y * (columns + 1) + x
    lower = upper + columns + 1
    a, b, c, d = (
        np.int64(texels[np.uint64(upper)]), np.int64(texels[np.uint64(upper + 1)]),
        np.int64(texels[np.uint64(lower)]), np.int64(texels[np.uint64(lower + 1)]),
    )  # fmt: skip
    wd = (right * down) >> 8
    wb, wc = right - wd, down - wd
    wa = 256 - right - wc
    outer = (a & 0xFF00FF) * wa + (b & 0xFF00FF) * wb + (c & 0xFF00FF) * wc + (d & 0xFF00FF) * wd
    inner = ((a >> 8) & 0xFF) * wa + ((b >> 8) & 0xFF) * wb + ((c >> 8) & 0xFF) * wc + ((d >> 8) & 0xFF) * wd
    return np.float32(outer & 0xFFFF), np.float32(inner), np.float32(outer >> 16)


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy", inline="always")
def _floor_light(shade: NDArray[np.float32], frame: NDArray[np.float32], x: np.float32, y: np.float32) -> np.float32:
    """Return the share of light left at a point of the floor (m, world), between the centres of four cells."""
    one, zero = np.float32(1.0), np.float32(0.0)
    column = min(max((x - frame[0]) * frame[2], zero), np.float32(shade.shape[1] - 1))
    row = min(max((y - frame[1]) * frame[2], zero), np.float32(shade.shape[0] - 1))
    x0, y0 = np.uint64(np.int64(column)), np.uint64(np.int64(row))
    x1, y1 = (
        np.uint64(min(np.int64(column) + 1, shade.shape[1] - 1)),
        np.uint64(min(np.int64(row) + 1, shade.shape[0] - 1)),
    )
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
def _mix(a: Triple, weight_a: np.float32, b: Triple, weight_b: np.float32) -> Triple:
    return a[0] * weight_a + b[0] * weight_b, a[1] * weight_a + b[1] * weight_b, a[2] * weight_a + b[2] * weight_b


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
