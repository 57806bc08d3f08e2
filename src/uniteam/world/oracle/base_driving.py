"""Driving the base exactly: turns and straight moves with continuous displacements, within their limits.

A displacement shorter than the least one is made of two longer ones, there and back.
"""

import math
from collections.abc import Iterator

from uniteam.geometry import BasePose, Point2, wrap_angle
from uniteam.interface import ACTION_LIMITS, BaseDisplacement

_NEGLIGIBLE_MOVE, _NEGLIGIBLE_TURN = 1e-3, math.radians(0.1)
_DETOUR_MOVE, _DETOUR_TURN = 0.2, math.radians(30.0)


def turn(angle: float) -> Iterator[BaseDisplacement]:
    """Yield the displacements that turn the base by an angle (rad)."""
    angle = wrap_angle(angle)
    if abs(angle) < _NEGLIGIBLE_TURN:
        return
    if abs(angle) <= ACTION_LIMITS.least_turn:
        yield BaseDisplacement(heading=math.copysign(_DETOUR_TURN, angle))
        angle -= math.copysign(_DETOUR_TURN, angle)
    yield BaseDisplacement(heading=angle)


def straight(distance: float) -> Iterator[BaseDisplacement]:
    """Yield the displacements that move the base forward (m)."""
    if distance < _NEGLIGIBLE_MOVE:
        return
    if distance <= ACTION_LIMITS.least_move:
        yield BaseDisplacement(x=-_DETOUR_MOVE)
        distance += _DETOUR_MOVE
    count = math.ceil(distance / ACTION_LIMITS.most_move)
    for _ in range(count):
        yield BaseDisplacement(x=distance / count)


def to_point(base: BasePose, point: Point2) -> Iterator[BaseDisplacement]:
    """Yield the displacements that face a point (m, in the frame of `base`'s pose) and drive there."""
    distance = base.distance_to(*point)
    if distance >= _NEGLIGIBLE_MOVE:
        yield from turn(base.bearing_to(*point))
        yield from straight(distance)
