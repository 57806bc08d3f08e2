"""The way to a goal leads through the door, and the nearest goal is that with the shortest way."""

import math

import pytest
from worlds.small_home import small_home

from uniteam.adapters.gymnasium.goals import Goals, distances_from
from uniteam.geometry import BasePose
from uniteam.stretch import BASE_RADIUS
from uniteam.world.physics.navigable_floor import NavigableFloor

FLOOR = NavigableFloor(small_home())
BESIDE_THE_WALL, BEHIND_THE_WALL, FAR_IN_THE_ROOM = (3.6, 3.6), (4.4, 3.6), (1.5, 3.6)


def goals(*points: tuple[float, float]) -> Goals:
    return Goals(FLOOR, [distances_from(FLOOR, [point]) for point in points], points)


@pytest.mark.parametrize("to", [(3.0, 1.0), (2.0, 3.5), (0.6, 2.2)])
def test_in_the_open_the_way_is_as_long_as_the_straight_line(to: tuple[float, float]) -> None:
    nearest = goals(to).nearest(BasePose(1.0, 1.0, 0.0))
    assert nearest.distance == pytest.approx(math.dist((1.0, 1.0), to), rel=0.02, abs=0.04)


def test_behind_a_wall_it_leads_through_the_door() -> None:
    # Along the wall to the door's post, a quarter of a circle of the base's radius around it, and the same behind it.
    through = 2 * (3.6 - 2.4 + BASE_RADIUS * math.pi / 2) + 0.1
    assert goals(BEHIND_THE_WALL).nearest(BasePose(*BESIDE_THE_WALL, 0.0)).distance == pytest.approx(through, rel=0.02)


def test_the_nearest_goal_is_nearest_by_the_way_and_not_by_air() -> None:
    nearest = goals(BEHIND_THE_WALL, FAR_IN_THE_ROOM).nearest(BasePose(*BESIDE_THE_WALL, math.pi / 2))
    assert nearest.index == 1
    assert nearest.angle == pytest.approx(math.pi / 2)
