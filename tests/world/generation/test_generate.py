"""Generated homes: what a robot and an eye may expect of every one of them."""

import json
import math
from dataclasses import replace
from functools import lru_cache
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from worlds.filled import filled
from worlds.small_home import TABLE, instance, small_home

from uniteam.cli.home import home as home_command
from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.geometry import transform_points
from uniteam.stretch import BASE_RADIUS
from uniteam.world.assets.catalogue import Catalogue, load_catalogue
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES, Box, Pool
from uniteam.world.generation.generate import generate_home
from uniteam.world.generation.objects.settling import resting_on
from uniteam.world.generation.passable import is_roomy
from uniteam.world.homes.home import Home, Instance
from uniteam.world.homes.serialization import home_from_data, home_to_data
from uniteam.world.physics.navigable_floor import CELL_SIZE, NavigableFloor
from uniteam.world.physics.physics import Physics

HOMES: tuple[tuple[int, Pool], ...] = (
    (0, "test"), (1, "test"), (2, "test"), (100, "train"), (101, "train"), (102, "train"),
)  # fmt: skip

each_home = pytest.mark.parametrize(("seed", "pool"), HOMES)


@lru_cache
def generated(seed: int, pool: Pool) -> Home:
    return generate_home(seed, pool)


def furniture(home: Home) -> list[Instance]:
    return [instance for instance in home.instances if not instance.movable]


def objects(home: Home) -> list[Instance]:
    return [instance for instance in home.instances if instance.movable]


def footprint(piece: Instance) -> NDArray[np.float64]:
    """Return the (4, 2) corners of the rectangle an upright instance covers (m, world)."""
    hx, hy = (length / 2 for length in load_catalogue()[piece.model].size[:2])
    corners = np.array([(-hx, -hy, 0), (hx, -hy, 0), (hx, hy, 0), (-hx, hy, 0)])
    return transform_points(piece.model_to_world(), corners)[:, :2]


def overlap_depth(one: Instance, other: Instance) -> float:
    """Return how deep (m) the boxes of two upright instances overlap, by separating axes; negative when apart."""
    a, b = footprint(one), footprint(other)
    depths = [
        min(
            one.position[2] + load_catalogue()[one.model].size[2],
            other.position[2] + load_catalogue()[other.model].size[2],
        )
        - max(one.position[2], other.position[2])
    ]
    for outline in (a, b):
        for edge in (outline[1] - outline[0], outline[2] - outline[1]):
            p, q = (points @ (edge / np.linalg.norm(edge)) for points in (a, b))
            depths.append(float(min(p.max(), q.max()) - max(p.min(), q.min())))
    return min(depths)


@each_home
def test_a_home_is_furnished_and_cluttered(seed: int, pool: Pool) -> None:
    home = generated(seed, pool)
    classes = {piece.category for piece in furniture(home)} & set(RECEPTACLE_CATEGORIES)
    assert 4 <= len(home.stage.rooms) <= 8
    assert len(classes) >= 8
    assert 18 <= len(furniture(home)) <= 90
    assert 20 <= len(objects(home)) <= 60
    for room in filled(home.stage.rooms):
        assert any(piece.room == room.name for piece in furniture(home)), f"{room.name} is empty"


@each_home
def test_furniture_stands_in_its_room_and_not_in_other_furniture(seed: int, pool: Pool) -> None:
    home = generated(seed, pool)
    rooms = {room.name: room for room in home.stage.rooms}
    for piece in filled(furniture(home)):
        room, corners = rooms[piece.room], footprint(piece)
        assert (corners >= room.low).all() and (corners <= room.high).all(), f"{piece.name} reaches out of {room.name}"
    solid = [piece for piece in furniture(home) if load_catalogue()[piece.model].shapes]
    for one, other in filled(combinations(solid, 2)):
        assert overlap_depth(one, other) < 0.002, f"{one.name} stands in {other.name}"


@each_home
def test_the_robot_reaches_every_room_and_almost_every_receptacle(seed: int, pool: Pool) -> None:
    home = generated(seed, pool)
    floor = NavigableFloor(home)
    rows, columns = np.nonzero(floor.largest_component)
    low = np.array(floor.to_point(0, 0))
    step = np.array(floor.to_point(1, 1)) - low
    stands = low + np.stack([columns, rows], axis=1) * step
    for room in filled(home.stage.rooms):
        inside = (stands > room.low).all(axis=1) & (stands < room.high).all(axis=1)
        assert inside.any(), f"{room.name} is out of reach"
    receptacles = [piece for piece in furniture(home) if piece.category in RECEPTACLE_CATEGORIES]
    near = [nearest(stands, piece) <= 0.5 for piece in receptacles]
    assert np.mean(near) >= 0.95


def nearest(stands: NDArray[np.float64], piece: Instance) -> float:
    """Return the least distance (m) from (N, 2) points to the rectangle a piece of furniture covers."""
    hx, hy = (length / 2 for length in load_catalogue()[piece.model].size[:2])
    local = (stands - piece.position[:2]) @ piece.model_to_world()[:2, :2]
    return float(np.hypot(*np.maximum(np.abs(local) - (hx, hy), 0.0).T).min())


@pytest.mark.parametrize("seed", [2004, 3016, 4000, 70001])
def test_the_robot_gets_into_a_room_itself_and_not_only_into_its_doorway(seed: int) -> None:
    home = generated(seed, "test")
    floor = NavigableFloor(home)
    for room in filled(home.stage.rooms):
        low, high = np.array(room.low) + BASE_RADIUS + 0.06, np.array(room.high) - BASE_RADIUS - 0.06
        (top, left), (bottom, right) = floor.to_cell(*low), floor.to_cell(*high)
        reached, free = (cells[top:bottom, left:right].sum() for cells in (floor.largest_component, floor.free))
        assert reached * CELL_SIZE**2 >= 0.5, f"{room.name} can hardly be entered"
        assert reached >= 0.3 * free, f"most of {room.name} is shut off"


@pytest.mark.parametrize(("x", "roomy"), [(2.2, True), (2.6, False)])
def test_furniture_does_not_shut_off_most_of_a_room(x: float, roomy: bool) -> None:
    counter = replace(TABLE, id="counter", shapes=(Box((0.0, 0.0, 0.5), (0.1, 4.0, 1.0)),))
    library = Catalogue({"counter": counter}, frozenset())
    assert is_roomy(small_home(instance("counter_1", counter, x, 2.0), library=library)) is roomy


@each_home
def test_every_object_rests_on_a_receptacle_and_stays_there(seed: int, pool: Pool) -> None:
    home = generated(seed, pool)
    physics = Physics(home)
    holders = resting_on(home, physics)
    assert set(holders) == {thing.name for thing in objects(home)}
    assert all(home.by_name[holder].category in RECEPTACLE_CATEGORIES for holder in holders.values())
    physics.advance(1.0)
    for thing in filled(objects(home)):
        assert thing.position[2] > 0.0
        assert math.dist(physics.pose(thing.name)[:3, 3], thing.position) < 0.01, f"{thing.name} moves"


@each_home
def test_pools_are_kept_apart(seed: int, pool: Pool) -> None:
    home, catalogue = generated(seed, pool), load_catalogue()
    for thing in filled(objects(home)):
        model = catalogue[thing.model]
        is_unseen = thing.category in catalogue.unseen_categories
        assert model.role == "object"
        assert (model.pool == "train" and not is_unseen) if pool == "train" else (model.pool == "test" or is_unseen)
    for piece in filled(furniture(home)):
        model = catalogue[piece.model]
        assert model.pool == pool or not catalogue.of_category(model.category, pool)


def test_the_same_seed_gives_the_same_home() -> None:
    assert generate_home(0) == generated(0, "test")


def test_other_seeds_and_pools_give_other_homes() -> None:
    stages = [generated(*key).stage for key in HOMES]
    assert all(one != other for one, other in filled(combinations(stages, 2)))


def test_a_negative_seed_and_an_unknown_pool_are_refused() -> None:
    with pytest.raises(InvalidInputError, match="negative"):
        generate_home(-1)
    with pytest.raises(InvalidInputError, match="at most"):
        generate_home(10**30)
    with pytest.raises(UnknownNameError, match="'test'"):
        generate_home(1, "tets")  # type: ignore[arg-type]


def test_a_home_survives_json() -> None:
    home = generated(1, "test")
    assert home_from_data(json.loads(json.dumps(home_to_data(home)))) == home


def test_the_layout_is_in_whole_centimetres_and_the_settled_poses_are_rounded() -> None:
    home = generated(2, "test")
    numbers = [v for room in home.stage.rooms for v in (*room.low, *room.high)]
    numbers += [v for piece in furniture(home) for v in piece.position[:2]]
    assert all(round(v, 2) == v for v in filled(numbers))
    assert all(round(v, 5) == v for thing in filled(objects(home)) for v in filled(thing.position))


def test_the_command_draws_a_plan_and_every_room(tmp_path: Path) -> None:
    home_command("1", out=tmp_path)
    names = {path.stem for path in tmp_path.glob("*.png")}
    assert names == {"plan", "above"} | {room.name for room in generated(1, "test").stage.rooms}
