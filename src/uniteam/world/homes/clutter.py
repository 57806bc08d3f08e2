"""Small objects on what can hold them: where each goes is decided here by geometry; physics settles them afterwards."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from uniteam.geometry import yaw_quaternion
from uniteam.world.assets.catalogue import Catalogue, Model, Pool, SupportSurface
from uniteam.world.homes.home import Instance

MIN_OBJECT_COUNT, MAX_OBJECT_COUNT = 20, 60
_DROP = 0.006
"""How far above its surface an object starts (m)."""
_EDGE = 0.015
"""How far from a surface's edge and from each other objects stay (m)."""
_HIGHEST = 1.25
"""Surfaces above this are out of the robot's sight and reach, and stay clear (m)."""

_FITTING_ROOMS: Mapping[str, frozenset[str]] = {
    room: frozenset(words)
    for room, words in {
        "kitchen": ("cup", "mug", "plate", "bowl", "bottle", "glass", "fork", "knife", "spoon", "pan", "pot", "kettle",
                    "electric_kettle", "teapot", "bread", "apple", "banana", "toy_food", "spatula", "ladle", "jar",
                    "toaster", "butter_dish", "canister", "wine_bottle", "squeezer", "tray", "salt_and_pepper_shaker",
                    "utensil_holder_cup", "sponge", "can", "dish", "blender", "coffee_maker", "cutting_board"),
        "bathroom": ("bath_towel", "towel", "soap_dispenser", "toiletry", "sponge", "cloth", "toothbrush",
                     "spray_bottle", "hair_dryer", "toilet_paper", "shampoo", "basket"),
        "living_room": ("remote_control", "remote", "book", "vase", "candle", "picture_frame", "lamp", "newspaper",
                        "gaming_console", "board_game", "statue", "clock", "radio", "plant_container", "magazine"),
        "bedroom": ("book", "lamp", "clock", "watch", "spectacles", "hat", "handbag", "stuffed_toy", "cellphone",
                    "doll", "headphones", "shoe", "toy_animal", "picture_frame"),
        "office": ("laptop", "pen", "pencil_case", "stapler", "file_sorter", "scissors", "tape", "calculator", "book",
                   "telephone", "lamp", "cup", "mouse", "keyboard", "calendar", "camera"),
        "hall": ("shoe", "hat", "handbag", "keychain", "umbrella", "helmet", "backpack", "cellphone"),
        "laundry": ("spray_bottle", "bath_towel", "cloth", "basket", "box", "sponge"),
        "dining_room": ("plate", "glass", "candle", "bowl", "wine_bottle", "vase", "cup", "tray", "fork", "knife"),
    }.items()
}  # fmt: skip


@dataclass(frozen=True)
class _Place:
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
    furniture: Sequence[Instance], room_kinds: Mapping[str, str], stock: "ObjectStock", rng: Generator
) -> tuple[Instance, ...]:
    """Return objects a hair above the surfaces of the furniture.

    Args:
        furniture: everything that stands in the home.
        room_kinds: the kind of each room by its name.
        stock: the models that may lie about.
        rng: for every choice.
    """
    places = [place for piece in furniture for place in _places(piece, stock.catalogue, room_kinds[piece.room])]
    blocked = [_footprint(piece, stock.catalogue[piece.model]) for piece in furniture]
    wanted = int(rng.integers(MIN_OBJECT_COUNT + 8, MAX_OBJECT_COUNT - 5))
    objects: list[Instance] = []
    boxes: dict[int, list[NDArray[np.float64]]] = {}
    for index in _visits(places, wanted, rng):
        if len(objects) == wanted:
            break
        place = places[index]
        taken = boxes.setdefault(index, _standing_on(place, furniture, blocked))
        placed = _try_place(place, taken, stock.choose(place.room_kind, rng), rng)
        if placed is not None:
            taken.append(placed[1])
            objects.append(placed[0])
    return tuple(objects)


class ObjectStock:
    """The graspable objects a home of one pool may hold, and the few categories that occur again and again in it."""

    def __init__(self, catalogue: Catalogue, pool: Pool, rng: Generator) -> None:
        self.catalogue = catalogue
        self._models: dict[str, list[Model]] = {}
        for model in sorted(catalogue.models.values(), key=lambda m: m.id):
            if model.role == "object" and _is_allowed(model, catalogue, pool):
                self._models.setdefault(model.category, []).append(model)
        self._categories = sorted(self._models)
        size = min(6, len(self._categories))
        self._frequent = [str(name) for name in rng.choice(self._categories, size=size, replace=False)]

    def choose(self, room_kind: str, rng: Generator) -> Model:
        """Return a model: often one that fits the room or is frequent in this home, as often any."""
        fitting = [name for name in self._categories if name in _FITTING_ROOMS.get(room_kind, ())]
        draw = rng.random()
        if draw < 0.4 and fitting:
            names = fitting
        elif draw < 0.6:
            names = self._frequent
        else:
            names = self._categories
        models = self._models[names[int(rng.integers(len(names)))]]
        return models[int(rng.integers(len(models)))]


def _is_allowed(model: Model, catalogue: Catalogue, pool: Pool) -> bool:
    is_unseen = model.category in catalogue.unseen_categories
    return model.pool == "train" and not is_unseen if pool == "train" else model.pool == "test" or is_unseen


def _places(piece: Instance, catalogue: Catalogue, room_kind: str) -> Iterator[_Place]:
    model = catalogue[piece.model]
    if model.role != "receptacle":
        return
    to_world = piece.model_to_world()
    for surface in model.surfaces:
        height = surface.height + piece.position[2]
        if height <= _HIGHEST:
            yield _Place(piece, _outline(surface, to_world), height, surface.clearance, room_kind)


def _outline(surface: SupportSurface, to_world: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.array(surface.outline) @ to_world[:2, :2].T + to_world[:2, 3]


def _visits(places: Sequence[_Place], wanted: int, rng: Generator) -> Iterator[int]:
    """Yield indices of places to try: a part of the furniture, larger surfaces more often, some again and again."""
    if not places:
        return
    names = sorted({place.furniture.name for place in places})
    used = {name for name in names if rng.random() < 0.8}
    weights = np.array([place.area**0.5 if place.furniture.name in used else 0.0 for place in places])
    counts = {name: sum(place.furniture.name == name for place in places) for name in names}
    weights *= [counts[place.furniture.name] ** -0.5 for place in places]
    if not weights.any():
        return
    borders = np.cumsum(weights.round(9))
    for draw in rng.random(8 * wanted):
        yield min(int(np.searchsorted(borders, draw * borders[-1], side="right")), len(places) - 1)


def _footprint(piece: Instance, model: Model) -> NDArray[np.float64]:
    """Return the (4, 2) corners of an upright instance's bounding rectangle (m, world)."""
    return _rectangle(model, piece.model_to_world())


def _rectangle(model: Model, to_world: NDArray[np.float64], margin: float = 0.0) -> NDArray[np.float64]:
    hx, hy = model.size[0] / 2 + margin, model.size[1] / 2 + margin
    corners = np.array([(-hx, -hy), (hx, -hy), (hx, hy), (-hx, hy)])
    return corners @ to_world[:2, :2].T + to_world[:2, 3]


def _standing_on(
    place: _Place, furniture: Sequence[Instance], footprints: Sequence[NDArray[np.float64]]
) -> list[NDArray[np.float64]]:
    """Return the footprints of furniture that stands on the place, such as a television."""
    return [
        footprint
        for piece, footprint in zip(furniture, footprints, strict=True)
        if piece.room == place.furniture.room and abs(piece.position[2] - place.height) < 0.05 and place.height > 0.1
    ]


def _try_place(
    place: _Place, taken: Sequence[NDArray[np.float64]], model: Model, rng: Generator
) -> tuple[Instance, NDArray[np.float64]] | None:
    """Return the object at a random spot of the place where it fits, with its footprint; None where it does not."""
    if model.size[2] + 0.02 > place.clearance:
        return None
    low, high = place.outline.min(axis=0), place.outline.max(axis=0)
    for _ in range(6):
        x, y = (round(float(v), 4) for v in low + (high - low) * rng.random(2))
        yaw = math.radians(int(rng.integers(360)))
        quaternion = tuple(round(q, 9) for q in yaw_quaternion(yaw))
        position = (x, y, round(place.height + _DROP, 4))
        instance = Instance("", model.id, model.category, True, position, quaternion, place.furniture.room)  # type: ignore[arg-type]
        corners = _rectangle(model, instance.model_to_world(), _EDGE)
        if _inside(corners, place.outline) and not any(_overlap(corners, other) for other in taken):
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
