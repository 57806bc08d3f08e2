"""The flat arrays that the compiled kernels of the camera read: every triangle of a scene, in the world frame."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Workspace(NamedTuple):
    """Arrays that the rasteriser writes anew in every frame, kept because fresh memory costs milliseconds.

    Attributes:
        screen: (V, 3) float32: column, row and inverse depth (1/m) of each vertex; -1 in front of the near plane.
        inverse_depth: (H, W) float32, 1/m; 0 where nothing is seen.
        triangle_at: (H, W) int32, the triangle that is seen; -1 where there is none.
    """

    screen: NDArray[np.float32]
    inverse_depth: NDArray[np.float32]
    triangle_at: NDArray[np.int32]


class SceneBuffers(NamedTuple):
    """Everything that can be seen; a PART is what moves and is lit as one (an instance, a wall, a link of the robot).

    Attributes:
        vertices: (V, 3) float32, world frame (m).
        light: (V, 2) float32, what reaches the vertex from the side of its normal and from the other side, as the
            factor that multiplies an sRGB colour.
        uvs: (V, 2) float32; (0, 0) is the upper left corner of the texture.
        triangles: (T, 3) int32 into the vertices.
        triangle_parts: (T,) int32.
        triangle_materials: (T,) int32.
        texel_areas: (T,) float32, twice the triangle's area in texels of the largest mip level.
        material_colors: (M, 3) float32 in [0, 1].
        material_textures: (M,) int32 into `texture_layout`.
        texture_layout, texels: see `TextureAtlas`.
        part_ranges: (P, 4) int32: first vertex, one past the last, first triangle, one past the last.
        part_boxes: (P, 8, 3) float32, corners of the bounding box in the world frame.
        part_labels: (P,) int16, what the instance image shows.
        part_tints: (P, 3) float32, colour of the light.
        part_visible: (P,) bool.
        part_is_stage: (P,) bool: drawn first, because walls hide most of a home.
        floor_shade, floor_frame: see `FloorShade`.
    """

    vertices: NDArray[np.float32]
    light: NDArray[np.float32]
    uvs: NDArray[np.float32]
    triangles: NDArray[np.int32]
    triangle_parts: NDArray[np.int32]
    triangle_materials: NDArray[np.int32]
    texel_areas: NDArray[np.float32]
    material_colors: NDArray[np.float32]
    material_textures: NDArray[np.int32]
    texture_layout: NDArray[np.int32]
    texels: NDArray[np.uint32]
    part_ranges: NDArray[np.int32]
    part_boxes: NDArray[np.float32]
    part_labels: NDArray[np.int16]
    part_tints: NDArray[np.float32]
    part_visible: NDArray[np.bool_]
    part_is_stage: NDArray[np.bool_]
    floor_shade: NDArray[np.float32]
    floor_frame: NDArray[np.float32]
