"""A furnished home from a seed: plan, walls, furniture, objects; drawn again until everything that must hold holds."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace
from itertools import count

import numpy as np
from numpy.random import Generator

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.geometry import yaw_quaternion
from uniteam.world.assets.catalogue import Catalogue, load_catalogue
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES, Pool
from uniteam.world.generation.furniture.furnishing import FurnishedRoom, FurnitureShop, HomeFurnisher
from uniteam.world.generation.furniture.piece import Piece
from uniteam.world.generation.objects.scatter import scatter
from uniteam.world.generation.objects.settling import settle
from uniteam.world.generation.objects.stock import ObjectStock
from uniteam.world.generation.plan.openings import draw_walls
from uniteam.world.generation.plan.stage import Decorator
from uniteam.world.generation.style import TIDY, HomeStyle
from uniteam.world.homes.home import Home, Instance

LARGEST_SEED = 2**53
"""Of a home, so that every reader of JSON keeps it whole."""

POOLS: tuple[Pool, ...] = ("train", "test")
_CEILINGS = (250, 260, 270)
_FEWEST_FURNITURE = 18
_FEWEST_RECEPTACLE_CLASSES = 8
_SCATTERINGS = 4
"""How often objects are scattered in a layout before another one is drawn."""


def generate_home(seed: int, pool: Pool = "test", style: HomeStyle = TIDY, library: Catalogue | None = None) -> Home:
    """Return the furnished home of a seed.

    Everything but the objects is the same on every machine; where they come to rest is the same on one machine.

    Args:
        seed: from 0 to `LARGEST_SEED`.
        pool: "train" homes hold training models only and no unseen category; "test" homes hold the other models.
        style: how it is planned, furnished and used.
        library: the models and textures that it is made of; None for the pack.

    Raises:
        InvalidInputError: the seed is negative or too large.
        UnknownNameError: there is no such pool.
    """
    check_seed(seed)
    if pool not in POOLS:
        raise UnknownNameError("pool", pool, POOLS)
    catalogue = library or load_catalogue()
    for attempt in count():
        seeds = [seed, POOLS.index(pool), attempt]
        home = _draw_layout(_Order(seed, pool, style, catalogue), np.random.default_rng(seeds))
        if home is None or not style.is_sound(home):
            continue
        for scattering in range(_SCATTERINGS):
            rng = np.random.default_rng([*seeds, scattering])
            stock = ObjectStock(catalogue, pool, rng, style.clutter.fitting, style.clutter.frequent)
            used = _with_objects(home, stock, style, rng)
            if used is not None:
                return used
    raise AssertionError("unreachable")


@dataclass(frozen=True)
class _Order:
    """What home is wanted."""

    seed: int
    pool: Pool
    style: HomeStyle
    catalogue: Catalogue

    @property
    def name(self) -> str:
        """The home's."""
        return f"{self.pool}-{self.style.prefix}{self.seed}"


def check_seed(seed: int) -> None:
    """Raise InvalidInputError where no home can be of a seed."""
    if not 0 <= seed <= LARGEST_SEED:
        what = "must not be negative" if seed < 0 else f"must be at most {LARGEST_SEED}"
        raise InvalidInputError(f"a home's seed {what}, got {seed}")


def _draw_layout(order: _Order, rng: Generator) -> Home | None:
    """Return a furnished home without objects, or None where the draw is a poor one."""
    plan = order.style.draw_plan(rng)
    walls = draw_walls(plan, order.style.door_widths, rng)
    if walls is None:
        return None
    ceiling = int(rng.choice(_CEILINGS))
    shop = FurnitureShop(order.catalogue, order.pool)
    rooms = HomeFurnisher(order.style.furnishing, shop, ceiling, rng).furnish(plan, walls)
    furniture = [_instance(piece, room) for room in rooms for piece in room.pieces]
    if not _is_furnished(furniture):
        return None
    stage = Decorator(order.catalogue, rng).stage(plan, walls, ceiling)
    return Home(order.name, stage, _numbered(furniture), order.catalogue, order.seed)


def _with_objects(home: Home, stock: ObjectStock, style: HomeStyle, rng: Generator) -> Home | None:
    """Return the home with its objects where they came to rest, or None where too few stay or they shut the ways."""
    room_kinds = {room.name: room.kind for room in home.stage.rooms}
    objects = scatter(home.instances, room_kinds, stock, style.clutter, rng)
    litter = style.litter(home, stock, rng)
    settled = settle(replace(home, instances=_numbered([*home.instances, *objects, *litter])))
    if sum(instance.movable for instance in settled.instances) < style.clutter.fewest:
        return None
    return settled if not litter or style.is_sound(settled) else None


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
