"""A furnished home from a seed: plan, walls, furniture, objects; drawn again until everything that must hold holds."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import replace
from itertools import count

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.geometry import yaw_quaternion
from uniteam.stretch import BASE_RADIUS
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES, Pool
from uniteam.world.generation.furniture.furnishing import FurnishedRoom, FurnitureShop, furnish
from uniteam.world.generation.furniture.piece import Piece
from uniteam.world.generation.objects.scatter import MIN_OBJECT_COUNT, scatter
from uniteam.world.generation.objects.settling import settle
from uniteam.world.generation.objects.stock import ObjectStock
from uniteam.world.generation.plan.floor_plan import draw_floor_plan
from uniteam.world.generation.plan.openings import WALL_THICKNESS, draw_walls
from uniteam.world.generation.plan.stage import Decorator
from uniteam.world.homes.home import Home, Instance, Room
from uniteam.world.physics.navigable_floor import CELL_SIZE, NavigableFloor

LARGEST_SEED = 2**53
"""Of a home, so that every reader of JSON keeps it whole."""

_POOLS: tuple[Pool, ...] = ("train", "test")
_CEILINGS = (250, 260, 270)
_FEWEST_FURNITURE = 18
_FEWEST_RECEPTACLE_CLASSES = 8
_SCATTERINGS = 4
"""How often objects are scattered in a layout before another one is drawn."""
_ROOM_TO_STAND = 0.5
"""The robot's centre reaches at least so much of every room, without its doorways (m2)."""
_SHARE_TO_REACH = 0.3
"""And at least this share of where it could stand in the room: no furniture shuts the rest off."""


def generate_home(seed: int, pool: Pool = "test") -> Home:
    """Return the furnished home of a seed.

    Everything but the objects is the same on every machine; where they come to rest is the same on one machine.

    Args:
        seed: from 0 to `LARGEST_SEED`.
        pool: "train" homes hold training models only and no unseen category; "test" homes hold the other models.

    Raises:
        InvalidInputError: the seed is negative or too large.
        UnknownNameError: there is no such pool.
    """
    check_seed(seed)
    if pool not in _POOLS:
        raise UnknownNameError("pool", pool, _POOLS)
    catalogue = load_catalogue()
    for attempt in count():
        seeds = [seed, _POOLS.index(pool), attempt]
        home = _draw_layout(f"{pool}-{seed}", seed, FurnitureShop(catalogue, pool), np.random.default_rng(seeds))
        if home is None or not is_roomy(home):
            continue
        for scattering in range(_SCATTERINGS):
            rng = np.random.default_rng([*seeds, scattering])
            cluttered = settle(_with_objects(home, ObjectStock(catalogue, pool, rng), rng))
            if sum(instance.movable for instance in cluttered.instances) >= MIN_OBJECT_COUNT:
                return cluttered
    raise AssertionError("unreachable")


def check_seed(seed: int) -> None:
    """Raise InvalidInputError where no home can be of a seed."""
    if not 0 <= seed <= LARGEST_SEED:
        what = "must not be negative" if seed < 0 else f"must be at most {LARGEST_SEED}"
        raise InvalidInputError(f"a home's seed {what}, got {seed}")


def _draw_layout(name: str, seed: int, shop: FurnitureShop, rng: Generator) -> Home | None:
    """Return a furnished home without objects, or None where the draw is a poor one."""
    plan = draw_floor_plan(rng)
    walls = draw_walls(plan, rng)
    if walls is None:
        return None
    ceiling = int(rng.choice(_CEILINGS))
    rooms = furnish(plan, walls, shop, ceiling, rng)
    furniture = [_instance(piece, room) for room in rooms for piece in room.pieces]
    if not _is_furnished(furniture):
        return None
    stage = Decorator(shop.catalogue, rng).stage(plan, walls, ceiling)
    return Home(name, stage, _numbered(furniture), shop.catalogue, seed)


def _with_objects(home: Home, stock: ObjectStock, rng: Generator) -> Home:
    """Return the home with objects a hair above where they will lie."""
    room_kinds = {room.name: room.kind for room in home.stage.rooms}
    objects = scatter(home.instances, room_kinds, stock, rng)
    return replace(home, instances=_numbered([*home.instances, *objects]))


def _instance(piece: Piece, room: FurnishedRoom) -> Instance:
    degrees = 90 * piece.quarters + piece.degrees
    w, x, y, z = (round(v, 9) for v in yaw_quaternion(np.radians(degrees)))
    position = (piece.x / 100, piece.y / 100, round(piece.z / 100, 4))
    return Instance("", piece.model.id, piece.model.category, False, position, (w, x, y, z), room.room.name)


def _numbered(instances: Iterable[Instance]) -> tuple[Instance, ...]:
    """Return the instances with names that count within their category."""
    numbers: Counter[str] = Counter()
    named = []
    for instance in instances:
        numbers[instance.category] += 1
        named.append(replace(instance, name=f"{instance.category}_{numbers[instance.category]}"))
    return tuple(named)


def _is_furnished(furniture: Iterable[Instance]) -> bool:
    categories = [instance.category for instance in furniture]
    classes = set(categories) & set(RECEPTACLE_CATEGORIES)
    return len(categories) >= _FEWEST_FURNITURE and len(classes) >= _FEWEST_RECEPTACLE_CLASSES


def is_roomy(home: Home) -> bool:
    """Say whether the robot gets from every room into every other, and to a fair share of where it could stand."""
    floor = NavigableFloor(home)
    reached = np.array([_area_within(floor, room, floor.largest_component) for room in home.stage.rooms])
    free = np.array([_area_within(floor, room, floor.free) for room in home.stage.rooms])
    return bool((reached >= np.maximum(_ROOM_TO_STAND, _SHARE_TO_REACH * free)).all())


def _area_within(floor: NavigableFloor, room: Room, cells: NDArray[np.bool_]) -> float:
    """Return how much of a room (m2) chosen cells of its floor fill, without those in its doorways.

    No robot stands nearer to the walls' centre lines than this but in a doorway.
    """
    border = BASE_RADIUS + WALL_THICKNESS / 200
    low = floor.to_cell(room.low[0] + border, room.low[1] + border)
    high = floor.to_cell(room.high[0] - border, room.high[1] - border)
    return float(cells[low[0] : high[0], low[1] : high[1]].sum()) * CELL_SIZE**2
