"""Floor plans of homes that grew with those who live in them: up to twelve rooms along straight or angled corridors.

Two families. Straight: a corridor between two bands of rooms. Angled: the corridor turns into a second wing, an L that
is one room. In both, small rooms (a bathroom beside a bedroom, a store beside a kitchen) are then cut out of the
corners of large ones, which become L-shaped. Whole centimetres.
"""

from collections.abc import Sequence
from itertools import pairwise

from numpy.random import Generator

from uniteam.world.generation.plan.floor_plan import DAY_KINDS, RoomSize, cut_in_shares, rounded
from uniteam.world.generation.plan.planned_room import FloorPlan, PlannedRoom, named_plan, turned_plan
from uniteam.world.generation.plan.rect import Rect

FEWEST_ROOMS, MOST_ROOMS = 5, 12
LEAST_AREA, MOST_AREA = 80.0, 220.0
CORRIDOR_WIDTH = (110, 170)
"""Between the centre lines of its walls (cm)."""

_SIZES = {
    "living_room": RoomSize((18.0, 38.0), 350, 2.0),
    "kitchen": RoomSize((9.0, 19.0), 260, 2.1),
    "dining_room": RoomSize((10.0, 18.0), 280, 1.9),
    "bedroom": RoomSize((10.0, 21.0), 280, 1.9),
    "office": RoomSize((8.0, 15.0), 240, 2.0),
    "bathroom": RoomSize((5.5, 11.0), 190, 2.2),
    "laundry": RoomSize((4.0, 9.0), 170, 2.3),
}
_CUT_OUT = {"bedroom": ("bathroom", 16.0), "kitchen": ("laundry", 14.0), "living_room": ("bathroom", 26.0)}
"""What may be cut out of a corner of a room, and the area (m2) from which it is."""
_CUT_CHANCE = 0.65
_ANGLED_SHARE = 0.8
"""Of the draws; fewer of these than of the others are usable."""
_CUT_SIDES = (200, 290)
_LEAST_ARM = 190
"""What a cut leaves of each side of its room (cm)."""
_EXTRAS = ("bedroom", "office", "dining_room", "laundry", "bathroom", "bedroom", "bedroom", "office")


def draw_large_plan(rng: Generator) -> FloorPlan:
    """Return a plan of 5 to 12 rooms with 80 to 220 m2 whose rooms all have usable sizes."""
    count = int(rng.integers(FEWEST_ROOMS, MOST_ROOMS + 1))
    while True:
        angled = count >= 7 and rng.random() < _ANGLED_SHARE
        rooms = _angled(rng, _kinds(rng, count)) if angled else _straight(rng, _kinds(rng, count))
        rooms = _with_cuts(rng, rooms, count)
        if len(rooms) == count and _is_usable(rooms):
            return named_plan(turned_plan(rooms, int(rng.integers(4)), bool(rng.integers(2))))


def _kinds(rng: Generator, count: int) -> list[str]:
    """Return the kinds of all rooms but the corridor and up to two that are cut out of others, day rooms first."""
    extra = [_EXTRAS[i] for i in rng.permutation(len(_EXTRAS))[: max(0, count - 5 - int(rng.integers(1, 4)))]]
    kinds = ["living_room", "kitchen", "bedroom", "bathroom", *extra]
    return sorted(kinds, key=lambda kind: kind not in DAY_KINDS)


def _is_usable(rooms: Sequence[PlannedRoom]) -> bool:
    area = sum(room.floor.area for room in rooms)
    return LEAST_AREA <= area <= MOST_AREA and all(_is_usable_room(room) for room in rooms)


def _is_usable_room(room: PlannedRoom) -> bool:
    if room.kind == "hall":
        return room.floor.area <= 34.0
    size = _SIZES[room.kind]
    shortest, longest = sorted((room.rect.width, room.rect.depth))
    in_area = 0.8 * size.area[0] <= room.floor.area <= 1.25 * size.area[1]
    return in_area and shortest >= size.shortest and longest <= size.aspect * shortest


def _straight(rng: Generator, kinds: Sequence[str]) -> list[PlannedRoom]:
    """Return two bands of rooms with a straight corridor between them."""
    day, night = _bands(rng, kinds)
    width = rounded(rng.uniform(*CORRIDOR_WIDTH))
    areas = [_areas(rng, band) for band in (day, night)]
    length = max(rounded(sum(map(sum, areas)) * 1e4 / rng.uniform(700, 950)), 500)
    depths = [max(rounded(sum(own) * 1e4 / length), 200) for own in areas]
    rooms = _row(day, areas[0], Rect(0, -depths[0], length, 0))
    rooms += _row(night, areas[1], Rect(0, width, length, width + depths[1]))
    return [*rooms, PlannedRoom("", "hall", Rect(0, 0, length, width))]


def _angled(rng: Generator, kinds: Sequence[str]) -> list[PlannedRoom]:
    """Return two wings of rooms along a corridor that turns by a right angle."""
    day, night = _bands(rng, kinds)
    third = max(1, len(night) // 2)
    east, north = night[:third], night[third:]
    if not north:
        return []
    width = rounded(rng.uniform(*CORRIDOR_WIDTH))
    areas = [_areas(rng, band) for band in (day, north, east)]
    north_depth = rounded(rng.uniform(300, 460))
    north_length = max(rounded(sum(areas[1]) * 1e4 / north_depth), 250)
    turn = north_length + width
    depth = max(rounded(sum(areas[0]) * 1e4 / turn), 250)
    top = width + north_depth
    bottom = -depth if rng.random() < 0.5 else 0
    east_width = max(rounded(sum(areas[2]) * 1e4 / (top - bottom)), 200)
    rooms = _row(day, areas[0], Rect(0, -depth, turn, 0))
    rooms += _row(north, areas[1], Rect(0, width, north_length, top))
    rooms += _column(east, areas[2], Rect(turn, bottom, turn + east_width, top))
    corner = Rect(0, width, north_length, top)
    return [*rooms, PlannedRoom("", "hall", Rect(0, 0, turn, top), (corner,))]


def _bands(rng: Generator, kinds: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the day rooms in some order, and the others; what there are too many of goes to the day rooms."""
    day = [kind for kind in kinds if kind in DAY_KINDS]
    night = [str(kind) for kind in rng.permutation([kind for kind in kinds if kind not in DAY_KINDS])]
    while len(night) > len(day) + 2:
        day.append(night.pop())
    return [day[i] for i in rng.permutation(len(day))], night


def _areas(rng: Generator, kinds: Sequence[str]) -> list[float]:
    return [float(rng.uniform(*_SIZES[kind].area)) for kind in kinds]


def _row(kinds: Sequence[str], areas: Sequence[float], space: Rect) -> list[PlannedRoom]:
    """Return rooms side by side that fill a space, as wide as their areas ask."""
    borders = cut_in_shares(space.x0, space.x1, areas)
    stretches = zip(kinds, pairwise(borders), strict=True)
    return [PlannedRoom("", kind, Rect(low, space.y0, high, space.y1)) for kind, (low, high) in stretches]


def _column(kinds: Sequence[str], areas: Sequence[float], space: Rect) -> list[PlannedRoom]:
    """Return rooms above one another that fill a space."""
    borders = cut_in_shares(space.y0, space.y1, areas)
    stretches = zip(kinds, pairwise(borders), strict=True)
    return [PlannedRoom("", kind, Rect(space.x0, low, space.x1, high)) for kind, (low, high) in stretches]


def _with_cuts(rng: Generator, rooms: Sequence[PlannedRoom], most: int) -> list[PlannedRoom]:
    """Return the rooms, and small ones cut out of corners of the large ones until there are as many as wanted."""
    drawn: list[PlannedRoom] = []
    left = most - len(rooms)
    for room in rooms:
        kind, least_area = _CUT_OUT.get(room.kind, ("", 0.0))
        if left > 0 and kind and room.rect.area >= least_area and rng.random() < _CUT_CHANCE:
            cut = _corner(rng, room.rect)
            if cut is not None:
                drawn += [PlannedRoom("", room.kind, room.rect, (cut,)), PlannedRoom("", kind, cut)]
                left -= 1
                continue
        drawn.append(room)
    return drawn


def _corner(rng: Generator, rect: Rect) -> Rect | None:
    """Return a rectangle at a corner, or None where it would leave too little."""
    width, depth = (rounded(rng.uniform(*_CUT_SIDES)) for _ in range(2))
    if rect.width - width < _LEAST_ARM or rect.depth - depth < _LEAST_ARM:
        return None
    x0 = rect.x0 if rng.random() < 0.5 else rect.x1 - width
    y0 = rect.y0 if rng.random() < 0.5 else rect.y1 - depth
    return Rect(x0, y0, x0 + width, y0 + depth)
