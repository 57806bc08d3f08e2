"""Floor plans, walls and the floors of rooms."""

from itertools import combinations

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.world.generation.furniture.room_floor import RoomFloor, Volume, standing_strip
from uniteam.world.generation.plan.floor_plan import (
    MAX_FLOOR_AREA,
    MAX_ROOM_COUNT,
    MIN_FLOOR_AREA,
    MIN_ROOM_COUNT,
    draw_floor_plan,
)
from uniteam.world.generation.plan.floor_shape import FloorShape
from uniteam.world.generation.plan.openings import PlannedWall, draw_walls
from uniteam.world.generation.plan.planned_room import FloorPlan
from uniteam.world.generation.plan.rect import Rect

SEEDS = range(60)


def planned(seed: int) -> tuple[FloorPlan, tuple[PlannedWall, ...]]:
    rng = np.random.default_rng(seed)
    while True:
        plan = draw_floor_plan(rng)
        walls = draw_walls(plan, (90, 95, 100), rng)
        if walls is not None:
            return plan, walls


def ways(walls: tuple[PlannedWall, ...]) -> list[tuple[int, int]]:
    """Return the pairs of rooms that a door or a passage joins."""
    joined = []
    for wall, opening in filled((each, opening) for each in walls for opening in each.openings):
        if opening.kind != "window":
            below, above = wall.rooms
            assert below is not None and above is not None, "a door leads outdoors"
            joined.append((below, above))
    return joined


def reached(joined: list[tuple[int, int]], start: int, barred: set[int]) -> set[int]:
    """Return the rooms one comes to from `start` without passing through those that are barred."""
    found, edge = {start}, {start}
    while edge:
        edge = {b for pair in joined for a, b in (pair, pair[::-1]) if a in edge and b not in found}
        found |= edge
        edge -= barred
    return found


@pytest.mark.parametrize("seed", SEEDS)
def test_a_plan_has_four_to_eight_rooms_of_sixty_to_a_hundred_and_sixty_square_metres(seed: int) -> None:
    plan = draw_floor_plan(np.random.default_rng(seed))
    assert MIN_ROOM_COUNT <= len(plan) <= MAX_ROOM_COUNT
    assert MIN_FLOOR_AREA <= sum(room.rect.area for room in plan) <= MAX_FLOOR_AREA
    assert not any(one.rect.overlaps(other.rect) for one, other in filled(combinations(plan, 2)))
    assert {"living_room", "kitchen", "bedroom", "bathroom"} <= {room.kind for room in plan}


@pytest.mark.parametrize("seed", SEEDS)
def test_every_room_is_reached_without_crossing_a_bathroom(seed: int) -> None:
    plan, walls = planned(seed)
    kinds = [room.kind for room in plan]
    bathrooms = {index for index, kind in enumerate(kinds) if kind == "bathroom"}
    assert reached(ways(walls), kinds.index("living_room"), bathrooms) == set(range(len(plan)))


@pytest.mark.parametrize("seed", SEEDS)
def test_ways_are_at_least_ninety_centimetres_wide_and_inside_their_walls(seed: int) -> None:
    walls = planned(seed)[1]
    for wall, opening in filled((each, opening) for each in walls for opening in each.openings):
        assert 0 < opening.start < opening.end < wall.length
        if opening.kind != "window":
            assert opening.bottom == 0
            assert opening.end - opening.start >= 90


def test_walls_close_every_room() -> None:
    plan, walls = planned(3)
    for index, room in filled(enumerate(plan)):
        around = sum(wall.length for wall in walls if index in wall.rooms)
        assert around == 2 * (room.rect.width + room.rect.depth)


def test_plans_differ_in_their_outline_and_their_number_of_rooms() -> None:
    plans = [draw_floor_plan(np.random.default_rng(seed)) for seed in SEEDS]
    assert len({len(plan) for plan in plans}) == 5
    is_angled = [sum(r.rect.area for r in plan) < 0.97 * hull_area(plan) for plan in plans]
    assert 10 <= sum(is_angled) <= 50


def hull_area(plan: FloorPlan) -> float:
    rects = [room.rect for room in plan]
    return Rect(0, 0, max(r.x1 for r in rects), max(r.y1 for r in rects)).area


def empty_room() -> RoomFloor:
    """Return a room of 4 m by 3 m with doors in the middle of its west and its east wall."""
    return RoomFloor(FloorShape(Rect(0, 0, 400, 300)), [Rect(0, 105, 70, 195), Rect(330, 105, 400, 195)], [])


def test_a_cupboard_across_the_room_would_part_its_doors() -> None:
    room = empty_room()
    assert not room.stays_passable(Volume(Rect(180, 0, 220, 250), 0, 200), [])
    assert room.stays_passable(Volume(Rect(180, 0, 220, 230), 0, 200), [])


def test_what_hangs_above_the_robot_parts_nothing() -> None:
    assert empty_room().stays_passable(Volume(Rect(180, 0, 220, 300), 150, 200), [])


def test_nothing_may_stand_before_a_door_or_in_another_thing() -> None:
    room = empty_room()
    room.take(Volume(Rect(100, 0, 200, 60), 0, 80), [])
    rows = np.array(
        [v.as_row() for v in (
            Volume(Rect(20, 150, 80, 250), 0, 80), Volume(Rect(150, 20, 250, 80), 0, 80),
            Volume(Rect(150, 20, 250, 80), 90, 120), Volume(Rect(200, 0, 300, 60), 0, 80),
            Volume(Rect(250, 250, 350, 301), 0, 80),
        )]
    )  # fmt: skip
    assert room.unobstructed(rows).tolist() == [False, False, True, True, False]


def test_a_thing_keeps_the_side_it_is_used_from_within_reach() -> None:
    room = empty_room()
    cabinet = Rect(150, 240, 250, 300)
    front = standing_strip(cabinet, (0, -1))
    room.take(Volume(cabinet, 0, 80), [front])
    in_the_way = Volume(Rect(140, 150, 260, 200), 0, 80)
    assert not room.stays_passable(in_the_way, [])
    assert room.stays_passable(Volume(Rect(140, 0, 260, 50), 0, 80), [])
