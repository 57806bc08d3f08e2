"""How much light reaches a vertex: ambient, the room's lamp, a little from one direction, less in the corners.

Light does not depend on the viewer, so it is computed where a part comes to stand, not in every frame. It is kept as
the factor that multiplies an sRGB colour: (colour * light) ** (1 / 2.2) is the product of both, encoded.
"""

import math
from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.world.homes.home import Room, Stage

GAMMA = 2.2
"""Exponent that stands for the sRGB curve."""

_SHOULDER, _WHITE = 0.65, 1.05
_CORNER_REACH = 0.30
_CORNER_SHADE = 0.45


@dataclass(frozen=True)
class RoomLight:
    """A room's light as the kernel reads it.

    Attributes:
        numbers: (13,) float32: position (3), ambient share, lamp share, directional share, reach (m),
            low and high corner (3 each) of the box around the room, in whose corners light is dimmer.
        tint: (3,) float32 colour, as the factor of an sRGB colour.
    """

    numbers: NDArray[np.float32]
    tint: NDArray[np.float32]


def room_light(room: Room, ceiling_height: float) -> RoomLight:
    """Return the light of a room; the lamp's reach grows with the room."""
    reach = 2.2 + 0.5 * math.hypot(room.high[0] - room.low[0], room.high[1] - room.low[1])
    ambient = room.light.ambient
    numbers = (
        *room.light.position, ambient, 0.85 * (1.0 - ambient), 0.25 * (1.0 - ambient), reach,
        *room.low, 0.0, *room.high, ceiling_height,
    )  # fmt: skip
    return RoomLight(np.array(numbers, dtype=np.float32), _tint(room.light.color))


def outdoor_light(stage: Stage) -> RoomLight:
    """Return the even light on what stands in no room."""
    lows, highs = np.array([r.low for r in stage.rooms]), np.array([r.high for r in stage.rooms])
    x, y = (lows.min(axis=0) + highs.max(axis=0)) / 2.0 if len(lows) else np.zeros(2)
    numbers = (x, y, 12.0, 0.6, 0.3, 0.1, 30.0, -1e3, -1e3, -1e3, 1e3, 1e3, 1e3)
    return RoomLight(np.array(numbers, dtype=np.float32), np.ones(3, dtype=np.float32))


def _tint(color: tuple[float, float, float]) -> NDArray[np.float32]:
    return (np.maximum(np.array(color), 0.0) ** (1.0 / GAMMA)).astype(np.float32)


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def pose_part(
    vertices: NDArray[np.float32],
    normals: NDArray[np.float32],
    model_to_world: NDArray[np.float32],
    light: NDArray[np.float32],
    world_vertices: NDArray[np.float32],
    world_light: NDArray[np.float32],
) -> None:
    """Write a part's vertices (V, 3) in the world frame and the light (V, 2) on their two sides.

    Args:
        vertices, normals: (V, 3) float32, model frame.
        model_to_world: (3, 4) float32 rigid.
        light: (13,) float32 of `RoomLight`.
        world_vertices, world_light: outputs.
    """
    m = model_to_world
    for k in range(vertices.shape[0]):
        vx, vy, vz = vertices[k, 0], vertices[k, 1], vertices[k, 2]
        x = m[0, 0] * vx + m[0, 1] * vy + m[0, 2] * vz + m[0, 3]
        y = m[1, 0] * vx + m[1, 1] * vy + m[1, 2] * vz + m[1, 3]
        z = m[2, 0] * vx + m[2, 1] * vy + m[2, 2] * vz + m[2, 3]
        world_vertices[k, 0], world_vertices[k, 1], world_vertices[k, 2] = x, y, z
        vx, vy, vz = normals[k, 0], normals[k, 1], normals[k, 2]
        nx = m[0, 0] * vx + m[0, 1] * vy + m[0, 2] * vz
        ny = m[1, 0] * vx + m[1, 1] * vy + m[1, 2] * vz
        nz = m[2, 0] * vx + m[2, 1] * vy + m[2, 2] * vz
        world_light[k, 0] = _light_at(x, y, z, nx, ny, nz, light)
        world_light[k, 1] = _light_at(x, y, z, -nx, -ny, -nz, light)


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def _light_at(
    x: np.float32, y: np.float32, z: np.float32, nx: np.float32, ny: np.float32, nz: np.float32,
    light: NDArray[np.float32],
) -> np.float32:  # fmt: skip
    lx, ly, lz = light[0] - x, light[1] - y, light[2] - z
    squared = lx * lx + ly * ly + lz * lz + np.float32(1e-4)
    cosine = (nx * lx + ny * ly + nz * lz) / math.sqrt(squared)
    # A lamp in a room with bright walls lights what turns away from it too: wrap the cosine around.
    wrapped = max(np.float32(0.0), np.float32(0.65) * cosine + np.float32(0.35))
    lamp = light[4] * wrapped / (np.float32(0.45) + squared / (light[6] * light[6]))
    directional = light[5] * max(np.float32(0.0), np.float32(0.36) * nx - np.float32(0.48) * ny + np.float32(0.8) * nz)
    shade = np.float32(1.0)
    shade *= _open_share(x - light[7], nx) * _open_share(light[10] - x, -nx)
    shade *= _open_share(y - light[8], ny) * _open_share(light[11] - y, -ny)
    shade *= _open_share(z - light[9], nz) * _open_share(light[12] - z, -nz)
    total = (light[3] + lamp + directional) * shade
    # Bright places are compressed towards `_WHITE`, so that white things keep their shape under a lamp.
    excess = max(total - np.float32(_SHOULDER), np.float32(0.0))
    total -= excess * excess / (excess + np.float32(_WHITE - _SHOULDER))
    return np.float32(total ** (1.0 / GAMMA))


@njit(cache=True, nogil=True, fastmath=True, error_model="numpy")
def _open_share(distance: np.float32, along: np.float32) -> np.float32:
    """Return the share of light left near one of the room's six planes, whose inward normal has cosine `along`."""
    near = max(distance, np.float32(0.0)) / np.float32(_CORNER_REACH)
    facing = np.float32(0.5) - np.float32(0.5) * along
    return np.float32(1.0) - np.float32(_CORNER_SHADE) * facing / (np.float32(1.0) + near * near)
