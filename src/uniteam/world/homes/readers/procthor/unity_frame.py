"""From Unity's frame to ours.

Unity's world is left-handed: x to the right, y up, z ahead; seen from above, angles about y grow clockwise. Ours has
x to the east, y to the north and z up. To exchange y and z turns a left-handed frame into a right-handed one, so that
nothing is mirrored: what is to the right of something from above stays there.
"""

import math

from uniteam.geometry import Point2, Point3, wrap_angle
from uniteam.world.homes.readers.procthor.schema import Rotation, Vector


def point_to_world(point: Vector) -> Point3:
    """Return a point of Unity's world in ours (m)."""
    return point.x, point.z, point.y


def floor_point(point: Vector) -> Point2:
    """Return where on our floor a point of Unity's world lies (m)."""
    return point.x, point.z


def model_yaw(rotation: Rotation) -> float:
    """Return the yaw (rad) of a model of ours that is to face as an asset does.

    An unturned asset of AI2-THOR faces +z, which is +y here, a model of ours -y. Tilts are passed over.
    """
    return wrap_angle(math.pi - math.radians(rotation.y))


def front_of(rotation: Rotation) -> Point2:
    """Return the unit vector (world) that an asset faces."""
    angle = math.radians(rotation.y)
    return math.sin(angle), math.cos(angle)
