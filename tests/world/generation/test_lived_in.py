"""Homes as people leave them: what makes them harder, and that the robot still gets about."""

from functools import lru_cache
from itertools import combinations

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.errors import UnknownNameError
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.generation.furniture.furnishing import FurnitureShop, HomeFurnisher
from uniteam.world.generation.furniture.piece import Piece
from uniteam.world.generation.generate import generate_home
from uniteam.world.generation.objects.settling import resting_on
from uniteam.world.generation.passable import is_passable
from uniteam.world.generation.plan.large_plan import draw_large_plan
from uniteam.world.generation.plan.openings import draw_walls
from uniteam.world.generation.registry import HOMES, source_name
from uniteam.world.generation.style import LIVED_IN, TIDY, style_of
from uniteam.world.homes.home import Home
from uniteam.world.homes.polygon import as_rectangle
from uniteam.world.physics.navigable_floor import STEP_HEIGHT, NavigableFloor
from uniteam.world.physics.physics import Physics

SEEDS = range(4)


@lru_cache
def generated(seed: int) -> Home:
    return generate_home(seed, "test", LIVED_IN)


def homes() -> list[Home]:
    return [generated(seed) for seed in SEEDS]


def on_floor(home: Home) -> list[str]:
    return [i.name for i in home.instances if i.movable and i.position[2] < 0.02]


def test_the_styles_are_sources_of_homes_by_name() -> None:
    assert {"test", "train", "test-lived_in", "train-lived_in"} <= set(HOMES.names())
    assert HOMES.get(source_name("test", "lived_in"))(0) == generated(0)
    assert HOMES.get(source_name("test", "tidy"))(0) == generate_home(0, "test", TIDY)
    assert generated(0).name == "test-lived_in-0"
    with pytest.raises(UnknownNameError, match="'lived_in'"):
        style_of("lived-in")


def test_homes_are_large_and_full() -> None:
    for home in filled(homes()):
        assert 5 <= len(home.stage.rooms) <= 12
        assert 80.0 <= sum(room.area for room in home.stage.rooms) <= 220.0
        assert sum(i.movable for i in home.instances) >= LIVED_IN.clutter.fewest
        assert all(any(i.room == room.name for i in home.instances) for room in home.stage.rooms)
    assert any(as_rectangle(room.outline) is None for home in homes() for room in home.stage.rooms)


def test_the_robot_gets_into_living_room_and_kitchen_and_most_rooms() -> None:
    assert all(is_passable(home) for home in filled(homes()))


def test_things_on_the_floor_are_in_the_bases_way() -> None:
    home = generated(1)
    floor = NavigableFloor(home)
    things = [home.by_name[name] for name in on_floor(home)]
    tall = [thing for thing in things if home.model_of(thing).size[2] > 2 * STEP_HEIGHT]
    assert len(tall) >= 3
    for thing in tall:
        assert not floor.is_free(thing.position[0], thing.position[1])


def test_what_lies_on_the_floor_lies_still_and_is_held_by_nothing() -> None:
    for home in filled(homes()):
        physics = Physics(home)
        holders = resting_on(home, physics)
        lying = {name for name in physics.names if "floor" in physics.touching(name)}
        assert lying and not lying & set(holders)
        assert {i.name for i in home.instances if i.movable} == lying | set(holders)
        physics.advance(1.0)
        for name in lying:
            assert np.linalg.norm(physics.pose(name)[:3, 3] - home.by_name[name].position) < 0.02


def test_what_lies_on_the_floor_lies_in_its_room() -> None:
    for home in filled(homes()):
        rooms = {room.name: room for room in home.stage.rooms}
        for thing in filled(home.by_name[name] for name in on_floor(home)):
            assert rooms[thing.room].contains(*thing.position[:2])


def test_objects_lie_high_and_low() -> None:
    heights = [i.position[2] for home in homes() for i in home.instances if i.movable and i.position[2] > 0.03]
    assert min(heights) < 0.2
    assert max(heights) > 1.25
    assert max(heights) <= LIVED_IN.clutter.highest + 0.05


def test_some_things_of_one_class_lie_in_several_places() -> None:
    for home in filled(homes()):
        categories = [i.category for i in home.instances if i.movable]
        assert max(categories.count(category) for category in set(categories)) >= 3


def leaves_and_walls(seed: int) -> tuple[list[Piece], list[tuple[int, int]]]:
    """Return the leaves of a home's doors, and the widths and openings of its doors (cm)."""
    rng = np.random.default_rng(seed)
    while True:
        plan = draw_large_plan(rng)
        walls = draw_walls(plan, LIVED_IN.door_widths, rng)
        if walls is not None:
            break
    rooms = HomeFurnisher(LIVED_IN.furnishing, FurnitureShop(load_catalogue(), "test"), 260, rng).furnish(plan, walls)
    leaves = [piece for room in rooms for piece in room.pieces if piece.model.category == "door"]
    doors = [(o.start, o.end) for wall in walls for o in wall.openings if o.kind == "door"]
    return leaves, doors


def test_doors_are_narrow_and_some_stand_half_open() -> None:
    leaves, doors = zip(*(leaves_and_walls(seed) for seed in range(6)), strict=True)
    widths = [end - start for of_home in doors for start, end in of_home]
    assert min(widths) == 76
    assert max(widths) <= 95
    turned = [leaf.degrees for of_home in leaves for leaf in of_home if leaf.degrees]
    assert len(turned) >= 3
    for of_home in filled(leaves):
        assert not any(a.rect.grown(-2).overlaps(b.rect.grown(-2)) for a, b in filled(combinations(of_home, 2)))
