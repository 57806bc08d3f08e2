"""Plans of homes that are lived in, and rooms that are no rectangles."""

from collections.abc import Iterator
from itertools import combinations, product

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.world.generation.plan.floor_shape import FloorShape
from uniteam.world.generation.plan.large_plan import (
    FEWEST_ROOMS,
    LEAST_AREA,
    MOST_AREA,
    MOST_ROOMS,
    draw_large_plan,
)
from uniteam.world.generation.plan.openings import draw_walls
from uniteam.world.generation.plan.planned_room import FloorPlan
from uniteam.world.generation.plan.rect import Rect
from uniteam.world.homes import polygon

SEEDS = range(24)
ANGLED = FloorShape(Rect(0, 0, 400, 300), (Rect(0, 200, 150, 300),))


def plans() -> Iterator[FloorPlan]:
    return (draw_large_plan(np.random.default_rng(seed)) for seed in SEEDS)


def test_plans_have_five_to_twelve_rooms_that_do_not_overlap() -> None:
    for plan in filled(plans()):
        assert FEWEST_ROOMS <= len(plan) <= MOST_ROOMS
        assert LEAST_AREA <= sum(room.floor.area for room in plan) <= MOST_AREA
        for one, other in filled(combinations(plan, 2)):
            assert not any(a.overlaps(b) for a, b in filled(product(one.floor.parts, other.floor.parts)))


def test_rooms_and_corridors_are_often_angled() -> None:
    drawn = list(plans())
    corridors = [room for plan in drawn for room in plan if room.kind == "hall"]
    others = [room for plan in drawn for room in plan if room.kind != "hall"]
    assert sum(bool(room.cuts) for room in corridors) >= 3
    assert sum(bool(room.cuts) for room in others) >= 6


def test_walls_close_an_angled_room() -> None:
    found = 0
    for seed in SEEDS:
        rng = np.random.default_rng(seed)
        plan = draw_large_plan(rng)
        walls = draw_walls(plan, (76, 80), rng)
        if walls is None:  # no doors could be drawn; such a plan is drawn again
            continue
        for index, room in filled(enumerate(plan)):
            around = sum(wall.length for wall in walls if index in wall.rooms)
            assert around == 2 * (room.rect.width + room.rect.depth)
            found += bool(room.cuts)
    assert found >= 10


def test_the_outline_of_an_angled_floor_goes_around_it_counter_clockwise() -> None:
    assert ANGLED.outline == ((0, 0), (400, 0), (400, 300), (150, 300), (150, 200), (0, 200))
    assert polygon.area(tuple((float(x), float(y)) for x, y in ANGLED.outline)) == pytest.approx(1e4 * ANGLED.area)


@pytest.mark.parametrize("corner", [(0, 0), (300, 0), (300, 220), (0, 220)])
def test_every_corner_can_be_cut(corner: tuple[int, int]) -> None:
    x, y = corner
    shape = FloorShape(Rect(0, 0, 400, 300), (Rect(x, y, x + 100, y + 80),))
    assert polygon.is_simple(tuple((float(a), float(b)) for a, b in shape.outline))
    assert polygon.area(tuple((float(a), float(b)) for a, b in shape.outline)) == pytest.approx(1e4 * shape.area)
    assert sum(part.area for part in shape.parts) == pytest.approx(shape.area)
    assert not shape.heart.overlaps(shape.cuts[0])


def test_walls_are_found_at_every_side_of_an_angled_floor() -> None:
    runs = {(run.quarters, run.line): (run.start, run.end) for run in ANGLED.runs}
    assert runs == {
        (0, 300): (150, 400), (0, 200): (0, 150), (1, 0): (0, 200), (1, 150): (200, 300), (2, 0): (0, 400),
        (3, 400): (0, 300),
    }  # fmt: skip


def test_the_heart_of_an_angled_floor_is_its_largest_rectangle() -> None:
    assert ANGLED.heart == Rect(0, 0, 400, 200)
    assert ANGLED.shrunk(10) == FloorShape(Rect(10, 10, 390, 290), (Rect(10, 190, 160, 290),))
