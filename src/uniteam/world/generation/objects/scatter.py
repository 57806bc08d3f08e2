"""Small objects on what can hold them: where each goes is decided here by geometry; physics settles them afterwards."""

import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from uniteam.geometry import yaw_quaternion
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Model, SupportSurface
from uniteam.world.generation.objects.stock import ObjectStock
from uniteam.world.homes.home import Instance

DROP = 0.006
"""How far above what it will lie on an object starts (m)."""

Footprint = NDArray[np.float64]
"""(4, 2) corners of what an object covers, with its margin (m, world)."""
Spot = Callable[[NDArray[np.float64], NDArray[np.float64], Sequence[Footprint], Generator], NDArray[np.float64]]
"""Returns a point (2,) to try, from the lowest and highest corner (2,) of a surface and from what stands on it."""


@dataclass(frozen=True)
class Clutter:
    """How many objects lie about, and where.

    Attributes:
        fewest: a home that holds fewer is not kept.
        wanted: the range from which the number to put is drawn, the last excluded.
        more_per_room: how many more are put for each room.
        highest: surfaces above this stay clear (m).
        most_on_one: no piece of furniture holds more.
        bare_share: of the pieces of furniture, that hold nothing.
        per_area: how many more may lie on each square metre.
        edge: how far from a surface's edge and from each other objects stay (m).
        spot: where on a surface to try.
        fitting, frequent: the shares of objects that fit their room, and that are of a class frequent in the home.
    """

    fewest: int
    wanted: tuple[int, int]
    more_per_room: int
    highest: float
    most_on_one: int
    bare_share: float
    per_area: float
    edge: float
    spot: Spot
    fitting: float
    frequent: float


def anywhere(
    low: NDArray[np.float64], high: NDArray[np.float64], taken: Sequence[Footprint], rng: Generator
) -> NDArray[np.float64]:
    """Return any point of a surface's box."""
    return np.asarray(low + (high - low) * rng.random(2))


def often_beside(
    low: NDArray[np.float64], high: NDArray[np.float64], taken: Sequence[Footprint], rng: Generator
) -> NDArray[np.float64]:
    """Return a point close to something that stands there already as often as any point."""
    if not taken or rng.random() < 0.5:
        return anywhere(low, high, taken, rng)
    middle = taken[int(rng.integers(len(taken)))].mean(axis=0)
    return np.asarray(middle + rng.uniform(-_BESIDE, _BESIDE, size=2))


_BESIDE = 0.22
"""m."""


@dataclass(frozen=True)
class _Support:
    """A surface of a piece of furniture, as seen from above in the world (m).

    Attributes:
        outline: (N, 2) counter-clockwise.
        height: above the floor.
        clearance: free height above it.
    """

    furniture: Instance
    outline: NDArray[np.float64]
    height: float
    clearance: float
    room_kind: str

    @property
    def area(self) -> float:
        """m2."""
        x, y = self.outline.T
        return float(0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def scatter(
    furniture: Sequence[Instance], room_kinds: Mapping[str, str], stock: ObjectStock, clutter: Clutter, rng: Generator
) -> tuple[Instance, ...]:
    """Return objects a hair above the surfaces of the furniture.

    Args:
        furniture: everything that stands in the home.
        room_kinds: the kind of each room by its name.
        stock: the models that may lie about.
        clutter: how many, and where.
        rng: for every choice.
    """
    found = (support for i in furniture for support in _supports(i, stock.catalogue, room_kinds[i.room]))
    supports = [support for support in found if support.height <= clutter.highest]
    footprints = [_rectangle(stock.catalogue[piece.model], piece.model_to_world()) for piece in furniture]
    space = _quotas(supports, clutter, rng)
    wanted = int(rng.integers(*clutter.wanted)) + clutter.more_per_room * len(room_kinds)
    objects: list[Instance] = []
    boxes: dict[int, list[NDArray[np.float64]]] = {}
    for index in _visits(supports, space, 8 * wanted, rng):
        support = supports[index]
        if space[support.furniture.name] == 0:
            continue
        taken = boxes.setdefault(index, _standing_on(support, furniture, footprints))
        put = _try_support(support, taken, stock.choose(support.room_kind, rng), clutter, rng)
        if put is not None:
            objects.append(put[0])
            taken.append(put[1])
            space[support.furniture.name] -= 1
        if len(objects) == wanted:
            break
    return tuple(objects)


def _quotas(supports: Sequence[_Support], clutter: Clutter, rng: Generator) -> dict[str, int]:
    """Return how many objects each piece of furniture may hold: none on some, few on small ones."""
    areas: dict[str, float] = {}
    for support in supports:
        areas[support.furniture.name] = areas.get(support.furniture.name, 0.0) + support.area
    return {
        name: 0
        if rng.random() < clutter.bare_share
        else 1 + min(clutter.most_on_one - 1, int(rng.integers(0, 2 + int(clutter.per_area * area))))
        for name, area in sorted(areas.items())
    }


def _supports(piece: Instance, catalogue: Catalogue, room_kind: str) -> Iterator[_Support]:
    model = catalogue[piece.model]
    if model.role != "receptacle":
        return
    to_world = piece.model_to_world()
    for surface in model.surfaces:
        height = surface.height + piece.position[2]
        yield _Support(piece, _outline(surface, to_world), height, surface.clearance, room_kind)


def _outline(surface: SupportSurface, to_world: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.array(surface.outline) @ to_world[:2, :2].T + to_world[:2, 3]


def _visits(supports: Sequence[_Support], space: Mapping[str, int], tries: int, rng: Generator) -> Iterator[int]:
    """Yield indices of supports to try, larger surfaces more often; a piece's many shelves share its chances."""
    counts = Counter(support.furniture.name for support in supports)
    weights = [
        support.area**0.5 / counts[support.furniture.name] ** 0.5 if space[support.furniture.name] else 0.0
        for support in supports
    ]
    borders = np.cumsum(np.round(weights, 9))
    if not supports or borders[-1] == 0.0:
        return
    for draw in rng.random(tries):
        yield min(int(np.searchsorted(borders, draw * borders[-1], side="right")), len(supports) - 1)


def _rectangle(model: Model, to_world: NDArray[np.float64], margin: float = 0.0) -> NDArray[np.float64]:
    hx, hy = model.size[0] / 2 + margin, model.size[1] / 2 + margin
    corners = np.array([(-hx, -hy), (hx, -hy), (hx, hy), (-hx, hy)])
    return corners @ to_world[:2, :2].T + to_world[:2, 3]


def _standing_on(
    support: _Support, furniture: Sequence[Instance], footprints: Sequence[NDArray[np.float64]]
) -> list[NDArray[np.float64]]:
    """Return the footprints of furniture that stands on the support, such as a television."""
    return [
        footprint
        for piece, footprint in zip(furniture, footprints, strict=True)
        if piece.room == support.furniture.room
        and abs(piece.position[2] - support.height) < 0.05
        and support.height > 0.1
    ]


def _try_support(
    support: _Support, taken: Sequence[Footprint], model: Model, clutter: Clutter, rng: Generator
) -> tuple[Instance, Footprint] | None:
    """Return the object at a random spot of the support where it fits, with its footprint; None where it does not."""
    if model.size[2] + 0.02 > support.clearance:
        return None
    low, high = support.outline.min(axis=0), support.outline.max(axis=0)
    for _ in range(6):
        x, y = (round(float(v), 4) for v in clutter.spot(low, high, taken, rng))
        yaw = math.radians(int(rng.integers(360)))
        quaternion = tuple(round(q, 9) for q in yaw_quaternion(yaw))
        position = (x, y, round(support.height + DROP, 4))
        instance = Instance("", model.id, model.category, True, position, quaternion, support.furniture.room)  # type: ignore[arg-type]
        corners = _rectangle(model, instance.model_to_world(), clutter.edge)
        if _inside(corners, support.outline) and not any(_overlap(corners, other) for other in taken):
            return instance, corners
    return None


def _inside(points: NDArray[np.float64], outline: NDArray[np.float64]) -> bool:
    """Say whether every point lies inside a convex counter-clockwise outline."""
    edges = np.roll(outline, -1, axis=0) - outline
    offsets = points[:, None] - outline[None]
    return bool((edges[None, :, 0] * offsets[..., 1] - edges[None, :, 1] * offsets[..., 0] >= 0).all())


def _overlap(one: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    """Say whether two convex outlines meet, by separating axes."""
    for outline in (one, other):
        edges = np.roll(outline, -1, axis=0) - outline
        normals = np.stack([edges[:, 1], -edges[:, 0]])
        a, b = one @ normals, other @ normals
        if ((a.max(axis=0) <= b.min(axis=0)) | (b.max(axis=0) <= a.min(axis=0))).any():
            return False
    return True
