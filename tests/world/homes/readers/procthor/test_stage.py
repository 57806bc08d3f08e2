"""Rooms and walls of the miniature, each number by hand from its layout."""

from typing import Any

import msgspec
import pytest
from worlds.procthor_miniature import CEILING, first_house, second_house

from uniteam.world.homes.home import Opening, Stage, Wall
from uniteam.world.homes.readers.procthor.schema import House
from uniteam.world.homes.readers.procthor.stage import UnknownWallError, stage_of


def stage(data: dict[str, Any]) -> Stage:
    """Return the stage of a house's data."""
    return stage_of(msgspec.convert(data, House))


def along(wall: Wall, opening: Opening) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the two ends of an opening on the floor (m, world), the western and southern first."""
    length = abs(wall.end[0] - wall.start[0]) + abs(wall.end[1] - wall.start[1])
    dx, dy = (wall.end[0] - wall.start[0]) / length, (wall.end[1] - wall.start[1]) / length
    first, second = sorted((wall.start[0] + s * dx, wall.start[1] + s * dy) for s in (opening.start, opening.end))
    return first, second


def openings(found: Stage) -> dict[tuple[tuple[float, float], tuple[float, float]], str]:
    """Return the kinds of a stage's openings by where they are."""
    return {along(wall, opening): opening.kind for wall in found.walls for opening in wall.openings}


def test_the_l_shaped_room_keeps_its_shape_and_is_not_mirrored() -> None:
    living = stage(first_house()).rooms[0]
    assert living.name == "living_room_1"
    assert living.area == pytest.approx(26.0)
    assert set(living.outline) == {(0, 0), (0, 5), (4, 5), (4, 3), (6, 3), (6, 0)}
    assert living.contains(5.5, 2.0) and not living.contains(5.5, 4.0)


def test_a_door_is_measured_from_the_first_corner_of_its_wall() -> None:
    found = openings(stage(first_house()))
    assert found == {
        ((6.0, 1.0), (6.0, 2.0)): "door",
        ((0.6, 5.0), (1.6, 5.0)): "door",
        ((0.0, 6.5), (0.0, 7.7)): "window",
    }


def test_a_hole_is_measured_the_same_way_in_both_schemas() -> None:
    assert openings(stage(second_house())) == {((8.0, 0.5), (8.0, 1.5)): "door"}


def test_the_door_outside_stays_shut_and_two_sides_make_one_wall() -> None:
    found = stage(first_house())
    ends = [frozenset((wall.start, wall.end)) for wall in found.walls]
    assert len(ends) == len(set(ends)) == 13
    south = next(wall for wall in found.walls if {wall.start, wall.end} == {(0.0, 0.0), (6.0, 0.0)})
    assert not south.openings
    assert found.ceiling_height == pytest.approx(CEILING)


def test_an_open_wall_is_none() -> None:
    shared = {(4.0, 0.0), (4.0, 4.0)}
    assert shared not in [{wall.start, wall.end} for wall in stage(second_house()).walls]
    closed = second_house()
    for wall in closed["walls"]:
        wall["empty"] = False
    assert shared in [{wall.start, wall.end} for wall in stage(closed).walls]


def test_a_door_in_a_wall_that_there_is_not_is_said() -> None:
    house = first_house()
    house["doors"][0]["wall0"] = "wall|9|0|0|1|1"
    with pytest.raises(
        UnknownWallError, match=r"'door\|2\|3' is in the wall 'wall\|9\|0\|0\|1\|1', which there is not"
    ):
        stage(house)
