"""Where to put a camera to watch the robot or to look into a home from above."""

import math

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.world.homes.home import Home, Room
from uniteam.world.simulation.stage_mesh import room_at

WATCHING_DISTANCE = 3.0
"""m from the camera to the robot's middle."""

_ROBOT_MIDDLE = 0.7
_BEHIND = 2.0
_WALL_MARGIN = 0.35


def look_at(eye: NDArray[np.float64], target: NDArray[np.float64], up: tuple[float, float, float]) -> NDArray:
    """Return camera_to_world (4, 4) of a camera at `eye` that looks at `target`, with `up` upwards in its image."""
    forward = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    pose = np.eye(4)
    pose[:3, :3] = np.stack([right, np.cross(forward, right), forward], axis=1)
    pose[:3, 3] = eye
    return pose


def third_person_pose(home: Home, base: BasePose) -> NDArray[np.float64]:
    """Return camera_to_world (4, 4) of a camera above and behind the robot; hide the "ceiling" for it.

    The camera stays within the robot's room, so that no wall stands between; where the room leaves it little space
    behind the robot, it rises and looks down more steeply, and always from `WATCHING_DISTANCE`.
    """
    index = room_at(home.stage, base.x, base.y)
    behind = _BEHIND if index is None else min(_BEHIND, _space_behind(home.stage.rooms[index], base))
    rise = math.sqrt(WATCHING_DISTANCE**2 - behind**2)
    target = np.array([base.x, base.y, _ROBOT_MIDDLE])
    heading = np.array([math.cos(base.heading), math.sin(base.heading), 0.0])
    return look_at(target - behind * heading + np.array([0.0, 0.0, rise]), target, tuple(heading))


def _space_behind(room: Room, base: BasePose) -> float:
    """Return how far (m) the camera can stand behind the base before it comes near a wall."""
    back = (-math.cos(base.heading), -math.sin(base.heading))
    limits = [
        ((high - _WALL_MARGIN if step > 0.0 else low + _WALL_MARGIN) - at) / step
        for at, step, low, high in zip((base.x, base.y), back, room.low, room.high, strict=True)
        if abs(step) > 1e-6
    ]
    return max(0.0, min(limits))
