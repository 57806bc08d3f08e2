"""Our models where a house has its assets: on the floor, against the wall, or on the stand-in of what they lay on."""

import math
from collections import Counter, defaultdict
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from uniteam.geometry import Point2, yaw_quaternion
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Model
from uniteam.world.homes.home import Instance, Room, Stage
from uniteam.world.homes.readers.procthor.classes import CLASSES, HUNG, ON_FURNITURE, Asset, type_of
from uniteam.world.homes.readers.procthor.free_spot import Footprint, Tops, footprint
from uniteam.world.homes.readers.procthor.schema import ObjectEntry
from uniteam.world.homes.readers.procthor.stage import WALL_THICKNESS
from uniteam.world.homes.readers.procthor.stand_ins import Sizes, stand_in
from uniteam.world.homes.readers.procthor.unity_frame import floor_point, front_of, model_yaw

DROP = 0.006
"""How far above what it will lie on an object starts (m)."""


@dataclass(frozen=True)
class Stood:
    """A stand-in that stands: its instance, its model, its yaw (rad), and what is free on it."""

    instance: Instance
    model: Model
    yaw: float
    tops: Tops
    stretch: float
    """Its height over the asset's."""


@dataclass
class Furnisher:
    """Puts stand-ins into a stage.

    Attributes:
        stage: of the house.
        library: of the models.
        assets: what is known of assets, by id.
        instances: what stands so far.
        unknown: types that our library has no like of, with their numbers.
        no_place: types for which there was no place on their parent, with their numbers.
    """

    stage: Stage
    library: Catalogue
    assets: Mapping[str, Asset]
    instances: list[Instance] = field(default_factory=list)
    unknown: Counter[str] = field(default_factory=Counter)
    no_place: Counter[str] = field(default_factory=Counter)
    _numbers: defaultdict[str, int] = field(default_factory=lambda: defaultdict(int))

    def put(self, entry: ObjectEntry, parent: Stood | None = None) -> None:
        """Put an asset's stand-in and those of what lies on it, or count what is left out."""
        stood = self._stood(entry, parent)
        for child in entry.children:
            if stood is None:
                self._leave_out(child)
            else:
                self.put(child, stood)

    def _leave_out(self, entry: ObjectEntry) -> None:
        """Count an asset, and all that lies on it, for which there is no place."""
        self.no_place[type_of(entry, self.assets)] += 1
        for child in entry.children:
            self._leave_out(child)

    def _stood(self, entry: ObjectEntry, parent: Stood | None) -> Stood | None:
        kind = type_of(entry, self.assets)
        category = (ON_FURNITURE if parent is not None else {}).get(kind) or CLASSES.get(kind)
        size = self._size(entry, parent)
        model = None if category is None else stand_in(self.library, category, entry.asset_id, size)
        if model is None:
            self.unknown[kind] += 1
            return None
        yaw = model_yaw(entry.rotation)
        on_floor = parent is None or model.role == "receptacle"
        place = self._on_floor(entry, model, yaw, size) if on_floor else _on_parent(entry, model, yaw, parent)
        if place is None:
            self.no_place[kind] += 1
            return None
        x, y, z = place
        self._numbers[model.category] += 1
        name, room = f"{model.category}_{self._numbers[model.category]}", self._room_at((x, y)).name
        movable = model.role == "object"
        position = (x, y, z + DROP if movable else z)
        instance = Instance(name, model.id, model.category, movable, position, yaw_quaternion(yaw), room)
        self.instances.append(instance)
        return Stood(instance, model, yaw, Tops(model), model.size[2] / (size[2] or model.size[2]))

    def _size(self, entry: ObjectEntry, parent: Stood | None) -> Sizes:
        """Return what is known of an asset's size; of one on the floor at least its height."""
        if entry.asset_id in self.assets:
            return self.assets[entry.asset_id].size
        hangs = CLASSES.get(type_of(entry, self.assets)) in HUNG
        stands = parent is None and not hangs and entry.position.y > 0.0
        return (None, None, 2.0 * entry.position.y if stands else None)

    def _on_floor(self, entry: ObjectEntry, model: Model, yaw: float, size: Sizes) -> tuple[float, float, float]:
        """Return where a model stands that keeps the asset's back where it was, within the room."""
        x, y = floor_point(entry.position)
        room = self._room_at((x, y))
        if size[1] is not None and model.role != "object":
            ahead = (model.size[1] - size[1]) / 2.0
            dx, dy = front_of(entry.rotation)
            x, y = x + ahead * dx, y + ahead * dy
        half = footprint(model, yaw).max(axis=0)
        low, high = np.array(room.low) + WALL_THICKNESS / 2 + half, np.array(room.high) - WALL_THICKNESS / 2 - half
        inside = np.where(low <= high, np.clip((x, y), low, high), (low + high) / 2)
        hung = entry.position.y - model.size[2] / 2.0 if model.category in HUNG else 0.0
        return float(inside[0]), float(inside[1]), max(min(hung, self.stage.ceiling_height - model.size[2]), 0.0)

    def _room_at(self, point: Point2) -> Room:
        rooms = self.stage.rooms
        return next((r for r in rooms if r.contains(*point)), min(rooms, key=lambda r: math.dist(r.middle, point)))


def _on_parent(entry: ObjectEntry, model: Model, yaw: float, parent: Stood | None) -> tuple[float, float, float] | None:
    """Return where on its parent a model finds room, as near to the asset's place as can be; None where it has none."""
    assert parent is not None, "what stands on the floor has none"
    (px, py, pz), turn = parent.instance.position, parent.yaw
    dx, dy = entry.position.x - px, entry.position.z - py
    c, s = math.cos(turn), math.sin(turn)
    wanted = (c * dx + s * dy, c * dy - s * dx)
    bottom = (entry.position.y - pz) * parent.stretch - model.size[2] / 2.0
    covered: Footprint = footprint(model, yaw - turn)
    spot = parent.tops.take(wanted, bottom, covered, model.size[2])
    if spot is None:
        return None
    x, y, height = spot
    return px + c * x - s * y, py + s * x + c * y, pz + height
