"""How far a point of the floor is from the rectangle that a piece of furniture covers."""

import math

from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.home import Instance


def yaw_of(instance: Instance) -> float:
    """Return the heading (rad) of an upright instance's model frame in the world."""
    w, _, _, z = instance.quaternion
    return 2.0 * math.atan2(z, w)


def distance_to_footprint(instance: Instance, x: float, y: float) -> float:
    """Return the distance (m) on the floor from (x, y) to an upright instance's bounding rectangle; 0 inside."""
    along, across = to_model_frame(instance, x, y)
    width, depth, _ = load_catalogue()[instance.model].size
    return math.hypot(max(0.0, abs(along) - width / 2.0), max(0.0, abs(across) - depth / 2.0))


def to_model_frame(instance: Instance, x: float, y: float) -> tuple[float, float]:
    """Return a point (m, world) of the floor in an upright instance's model frame."""
    yaw = yaw_of(instance)
    c, s = math.cos(yaw), math.sin(yaw)
    dx, dy = x - instance.position[0], y - instance.position[1]
    return c * dx + s * dy, -s * dx + c * dy
