"""Unity's frame against what is known of it by hand: a corner, a turn, and on which side of a sofa the door is."""

import math

import pytest

from uniteam.geometry import wrap_angle
from uniteam.world.homes.readers.procthor.schema import Rotation, Vector
from uniteam.world.homes.readers.procthor.unity_frame import front_of, model_yaw, point_to_world


def facing(degrees: float) -> tuple[float, float]:
    """Return what the front of a model of ours (-y) points to that stands in for an asset turned so."""
    yaw = model_yaw(Rotation(y=degrees))
    return math.sin(yaw), -math.cos(yaw)


def test_a_point_keeps_its_east_its_ahead_and_its_height() -> None:
    assert point_to_world(Vector(x=1.0, y=2.0, z=3.0)) == (1.0, 3.0, 2.0)


@pytest.mark.parametrize(
    ("degrees", "front"),
    [(0.0, (0.0, 1.0)), (90.0, (1.0, 0.0)), (180.0, (0.0, -1.0)), (270.0, (-1.0, 0.0)), (30.0, (0.5, math.sqrt(0.75)))],
)
def test_turns_are_clockwise_from_ahead(degrees: float, front: tuple[float, float]) -> None:
    assert facing(degrees) == pytest.approx(front, abs=1e-12)
    assert front_of(Rotation(y=degrees)) == pytest.approx(front, abs=1e-12)


def test_what_is_to_the_right_in_unity_is_to_the_right_here() -> None:
    ahead, right = Vector(x=0.0, z=1.0), Vector(x=1.0, z=0.0)
    bearings = [math.atan2(point_to_world(p)[1], point_to_world(p)[0]) for p in (ahead, right)]
    assert wrap_angle(bearings[1] - bearings[0]) == pytest.approx(-math.pi / 2)
