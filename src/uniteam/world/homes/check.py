"""What must hold for a home beyond the types and bounds of its fields: unique names, sound outlines, known models."""

import math
import re
from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import pairwise

import numpy as np

from uniteam.errors import DamagedFileError, UnknownNameError
from uniteam.world.homes.fixed_mesh import stage_mesh
from uniteam.world.homes.home import Home, Instance, Opening, Room, Wall
from uniteam.world.homes.polygon import is_simple

LONGEST = 100.0
"""The rooms together are no longer than this along an axis (m): memory grows with the floor."""
SMALLEST_ROOM = 0.5
"""m2."""
MOST_SHAPES = 20_000
OUTSIDE = 10.0
"""An instance stands no farther than this from the rooms (m)."""

_RESERVED = re.compile(r"arm|ceiling|floor|stage|wall|wall_\d+|world|robot/.*")
_SLACK = 1e-3


def home_problems(home: Home) -> Iterator[str]:
    """Yield what is wrong with a home whose fields have sensible types and bounds, a clause each."""
    yield from _twice("room", (room.name for room in home.stage.rooms))
    yield from _twice("instance", (instance.name for instance in home.instances))
    for room in home.stage.rooms:
        yield from (f"room '{room.name}': {problem}" for problem in _room_problems(home, room))
    low, high = np.min([r.low for r in home.stage.rooms], axis=0), np.max([r.high for r in home.stage.rooms], axis=0)
    if (high - low).max() > LONGEST:
        yield f"its rooms reach over {(high - low).max():.0f} m, more than {LONGEST:.0f} m"
    for index, wall in enumerate(home.stage.walls):
        yield from (f"wall {index}: {problem}" for problem in _wall_problems(wall))
    rooms = {room.name for room in home.stage.rooms}
    for instance in home.instances:
        yield from (f"instance '{instance.name}': {problem}" for problem in _instance_problems(home, instance))
        if instance.room not in rooms:
            yield f"instance '{instance.name}': it stands in room '{instance.room}', which there is not"
        if not ((low - OUTSIDE <= instance.position[:2]) & (instance.position[:2] <= high + OUTSIDE)).all():
            yield f"instance '{instance.name}': it stands more than {OUTSIDE:.0f} m away from the rooms"
    known = [home.library.models[i.model] for i in home.instances if i.model in home.library.models]
    shape_count = sum(len(model.shapes) for model in known)
    if shape_count > MOST_SHAPES:
        yield f"its instances have {shape_count} collision shapes, more than {MOST_SHAPES}"
    try:
        stage_mesh(home.stage)
    except DamagedFileError as error:
        yield f"its stage's mesh: {error}"


def _twice(kind: str, names: Iterable[str]) -> Iterator[str]:
    yield from (f"two are named {kind} '{name}'" for name, count in Counter(names).items() if count > 1)


def _room_problems(home: Home, room: Room) -> Iterator[str]:
    if not is_simple(room.outline):
        yield "its outline crosses or touches itself"
    elif room.area < SMALLEST_ROOM:
        yield f"its outline is clockwise or holds less than {SMALLEST_ROOM} m2"
    for texture in (room.floor_texture, room.wall_texture):
        if texture is not None and texture not in home.library.textures:
            yield str(UnknownNameError("texture", texture, home.library.textures))


def _wall_problems(wall: Wall) -> Iterator[str]:
    length = math.dist(wall.start, wall.end)
    if length < 0.01:
        yield "it is shorter than a centimetre"
    for opening in wall.openings:
        if not (-_SLACK <= opening.start < opening.end <= length + _SLACK and 0.0 <= opening.bottom < opening.top):
            yield f"its {opening.kind} does not lie within it"
    if _overlap(wall.openings):
        yield "two of its openings overlap"


def _overlap(openings: tuple[Opening, ...]) -> bool:
    ordered = sorted(openings, key=lambda opening: opening.start)
    return any(after.start < before.end - _SLACK for before, after in pairwise(ordered))


def _instance_problems(home: Home, instance: Instance) -> Iterator[str]:
    if _RESERVED.fullmatch(instance.name):
        yield "its name is one that the stage or the robot has"
    if abs(math.hypot(*instance.quaternion) - 1.0) > _SLACK:
        yield "its quaternion is not of unit length"
    if instance.model not in home.library.models:
        yield str(UnknownNameError("model", instance.model, home.library.models))
        return
    model = home.model_of(instance)
    if instance.category != model.category:
        yield f"its category is '{instance.category}', but '{model.category}' that of its model '{model.id}'"
    if instance.movable and not model.shapes:
        yield f"it is movable, but its model '{model.id}' has no collision shapes"
    if model.role == "receptacle" and math.hypot(*instance.quaternion[1:3]) > _SLACK:
        yield "a receptacle must stand upright"
