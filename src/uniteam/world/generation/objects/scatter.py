"""Small objects on what can hold them: where each goes is decided here by geometry; physics settles them afterwards."""

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from uniteam.geometry import yaw_quaternion
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Model, SupportSurface
from uniteam.world.generation.objects.stock import ObjectStock
from uniteam.world.homes.home import Instance

MIN_OBJECT_COUNT, MAX_OBJECT_COUNT = 20, 60
_DROP = 0.006
"""How far above its surface an object starts (m)."""
_EDGE = 0.015
"""How far from a surface's edge and from each other objects stay (m)."""
_HIGHEST = 1.25
"""Surfaces above this are out of the robot's sight and reach, and stay clear (m)."""

_MOST_ON_ONE = 7
"""No piece of furniture holds more objects than this."""


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
    furniture: Sequence[Instance], room_kinds: Mapping[str, str], stock: ObjectStock, rng: Generator
) -> tuple[Instance, ...]:
    """Return objects a hair above the surfaces of the furniture.

    Args:
        furniture: everything that stands in the home.
        room_kinds: the kind of each room by its name.
        stock: the models that may lie about.
        rng: for every choice.
    """
    supports = [support for piece in furniture for support in _supports(piece, stock.catalogue, room_kinds[piece.room])]
    footprints = [_rectangle(stock.catalogue[piece.model], piece.model_to_world()) for piece in furniture]
    space = _quotas(supports, rng)
    wanted = int(rng.integers(MIN_OBJECT_COUNT + 8, MAX_OBJECT_COUNT - 5))
    objects: list[Instance] = []
    boxes: dict[int, list[NDArray[np.float64]]] = {}
    for index in _visits(supports, space, 8 * wanted, rng):
        support = supports[index]
        if space[support.furniture.name] == 0:
            continue
        taken = boxes.setdefault(index, _standing_on(support, furniture, footprints))
        put = _try_support(support, taken, stock.choose(support.room_kind, rng), rng)
        if put is not None:
            objects.append(put[0])
            taken.append(put[1])
            space[support.furniture.name] -= 1
        if len(objects) == wanted:
            break
    return tuple(objects)


def _quotas(supports: Sequence[_Support], rng: Generator) -> dict[str, int]:
    """Return how many objects each piece of furniture may hold: none for one in five, few on small ones."""
    areas: dict[str, float] = {}
    for support in supports:
        areas[support.furniture.name] = areas.get(support.furniture.name, 0.0) + support.area
    return {
        name: 0 if rng.random() < 0.2 else 1 + min(_MOST_ON_ONE - 1, int(rng.integers(0, 2 + int(6 * area))))
        for name, area in sorted(areas.items())
    }


def _supports(piece: Instance, catalogue: Catalogue, room_kind: str) -> Iterator[_Support]:
    model = catalogue[piece.model]
    if model.role != "receptacle":
        return
    to_world = piece.model_to_world()
    for surface in model.surfaces:
        height = surface.height + piece.position[2]
        if height <= _HIGHEST:
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
    support: _Support, taken: Sequence[NDArray[np.float64]], model: Model, rng: Generator
) -> tuple[Instance, NDArray[np.float64]] | None:
    """Return the object at a random spot of the support where it fits, with its footprint; None where it does not."""
    if model.size[2] + 0.02 > support.clearance:
        return None
    low, high = support.outline.min(axis=0), support.outline.max(axis=0)
    for _ in range(6):
        x, y = (round(float(v), 4) for v in low + (high - low) * rng.random(2))
        yaw = math.radians(int(rng.integers(360)))
        quaternion = tuple(round(q, 9) for q in yaw_quaternion(yaw))
        position = (x, y, round(support.height + _DROP, 4))
        instance = Instance("", model.id, model.category, True, position, quaternion, support.furniture.room)  # type: ignore[arg-type]
        corners = _rectangle(model, instance.model_to_world(), _EDGE)
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
