"""How far a point of the floor is from the rectangle that a piece of furniture covers."""

import math

import numpy as np
from numpy.typing import NDArray

from uniteam.world.homes.home import Home, Instance

VIEW_DISTANCE = 1.5
"""How far (m) the base may be from what it is said to have found: from furniture's footprint, or an object's centre."""


def yaw_of(instance: Instance) -> float:
    """Return the heading (rad) of an upright instance's model frame in the world."""
    w, _, _, z = instance.quaternion
    return 2.0 * math.atan2(z, w)


def distance_to_footprint(home: Home, instance: Instance, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the distances (...) (m) of (..., 2) points of the floor to an upright instance's rectangle; 0 inside."""
    yaw = yaw_of(instance)
    c, s = math.cos(yaw), math.sin(yaw)
    in_model = (points - instance.position[:2]) @ np.array([[c, -s], [s, c]])
    half = np.array(home.model_of(instance).size[:2]) / 2.0
    return np.asarray(np.linalg.norm(np.maximum(0.0, np.abs(in_model) - half), axis=-1))
