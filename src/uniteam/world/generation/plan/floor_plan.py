"""Floor plans: rectangular rooms that partition a footprint, in whole centimetres so that every machine agrees.

Two families, as flats have them. Columns: stacks of rooms side by side, where the living room connects. Hall: a strip
between two bands of rooms, with or without a cap of day rooms at its end; bands of unlike length make an L. The plan is
then turned by quarters and mirrored.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.random import Generator

from uniteam.world.generation.plan.planned_room import FloorPlan, PlannedRoom, named_plan, turned_plan
from uniteam.world.generation.plan.rect import Rect

DAY_KINDS = ("living_room", "kitchen", "dining_room")
MIN_ROOM_COUNT, MAX_ROOM_COUNT = 4, 8
MIN_FLOOR_AREA, MAX_FLOOR_AREA = 60.0, 160.0
_STEP = 10


@dataclass(frozen=True)
class RoomSize:
    """What is usual for a kind of room: floor area (m2), shortest side (cm), longest side over shortest."""

    area: tuple[float, float]
    shortest: int
    aspect: float


ROOM_SIZES = {
    "living_room": RoomSize((18.0, 30.0), 350, 2.0),
    "kitchen": RoomSize((9.0, 16.0), 260, 2.0),
    "dining_room": RoomSize((10.0, 16.0), 290, 1.8),
    "bedroom": RoomSize((11.0, 18.0), 300, 1.8),
    "office": RoomSize((8.5, 13.0), 260, 1.9),
    "bathroom": RoomSize((5.5, 9.5), 200, 2.1),
    "laundry": RoomSize((5.0, 8.0), 190, 2.2),
    "hall": RoomSize((4.0, 18.0), 140, 7.5),
}


_Stack = tuple[str, ...]


def draw_floor_plan(rng: Generator) -> FloorPlan:
    """Return a plan of 4 to 8 rooms with 60 to 160 m2 whose rooms all have usable sizes."""
    count = int(rng.choice([4, 5, 6, 7, 8], p=[0.12, 0.2, 0.26, 0.24, 0.18]))
    while True:
        rooms = _columns(rng, count) if count == 4 or (count == 5 and rng.random() < 0.6) else _hall(rng, count)
        if _is_usable(rooms):
            drawn = [PlannedRoom("", kind, rect) for kind, rect in rooms]
            return named_plan(turned_plan(drawn, int(rng.integers(4)), bool(rng.integers(2))))


def _is_usable(rooms: Sequence[tuple[str, Rect]]) -> bool:
    area = sum(rect.area for _, rect in rooms)
    return MIN_FLOOR_AREA <= area <= MAX_FLOOR_AREA and all(_is_usable_room(kind, rect) for kind, rect in rooms)


def _is_usable_room(kind: str, rect: Rect) -> bool:
    size = ROOM_SIZES[kind]
    shortest, longest = sorted((rect.width, rect.depth))
    in_area = 0.9 * size.area[0] <= rect.area <= 1.3 * size.area[1]
    return in_area and shortest >= size.shortest and longest <= size.aspect * shortest


def rounded(length: float) -> int:
    """Return a length as whole steps of the plan (cm)."""
    return _STEP * round(length / _STEP)


def _areas(rng: Generator, kinds: Sequence[str]) -> list[float]:
    return [float(rng.uniform(*ROOM_SIZES[kind].area)) for kind in kinds]


def cut_in_shares(start: int, end: int, shares: Sequence[float]) -> list[int]:
    """Return the borders that cut [start, end] in proportion to `shares`."""
    inner = [start + rounded((end - start) * part / sum(shares)) for part in np.cumsum(shares)[:-1]]
    return [start, *inner, end]


def _stack(rng: Generator, kinds: _Stack, x0: int, y0: int, height: int) -> list[tuple[str, Rect]]:
    """Return rooms above one another from (x0, y0), as wide as their areas ask."""
    areas = _areas(rng, kinds)
    x1 = x0 + max(rounded(sum(areas) * 1e4 / height), 180)
    borders = cut_in_shares(y0, y0 + height, areas)
    return [(kind, Rect(x0, low, x1, high)) for kind, (low, high) in zip(kinds, pairwise(borders), strict=True)]


def _row(rng: Generator, stacks: Sequence[_Stack], x0: int, y0: int, depth: int) -> list[tuple[str, Rect]]:
    rooms: list[tuple[str, Rect]] = []
    for kinds in stacks:
        rooms += _stack(rng, kinds, x0, y0, depth)
        x0 = rooms[-1][1].x1
    return rooms


_COLUMN_PLANS: dict[int, tuple[tuple[_Stack, ...], ...]] = {
    4: (
        (("kitchen", "living_room"), ("bathroom", "bedroom")),
        (("living_room", "kitchen"), ("bathroom", "bedroom")),
        (("kitchen", "bathroom"), ("living_room",), ("bedroom",)),
    ),
    5: (
        (("kitchen", "dining_room"), ("living_room",), ("bathroom", "bedroom")),
        (("kitchen", "office"), ("living_room",), ("bathroom", "bedroom")),
        (("kitchen", "living_room"), ("bedroom", "bathroom", "bedroom")),
        (("bedroom", "bathroom"), ("living_room", "kitchen"), ("bedroom",)),
        (("living_room", "dining_room", "kitchen"), ("bedroom", "bathroom")),
    ),
}


def _columns(rng: Generator, count: int) -> list[tuple[str, Rect]]:
    plans = _COLUMN_PLANS[count]
    return _row(rng, plans[rng.integers(len(plans))], 0, 0, rounded(rng.uniform(560, 860)))


def _extra_kinds(rng: Generator, count: int) -> list[str]:
    """Return the kinds beyond hall, living room, kitchen, bedroom and bathroom."""
    if count == 5:
        return []
    first = [str(rng.choice(["bedroom", "bedroom", "office", "dining_room"]))]
    pool = {"bedroom", "office", "dining_room", "laundry", "bathroom"} - set(first)
    return first + [str(kind) for kind in rng.choice(sorted(pool), size=count - 6, replace=False)]


def _hall(rng: Generator, count: int) -> list[tuple[str, Rect]]:
    """Return two bands of rooms with a hall between them."""
    extra = _extra_kinds(rng, count)
    night = ["bedroom", "bathroom", *(kind for kind in extra if kind not in DAY_KINDS)]
    day = ["living_room", "kitchen", *(kind for kind in extra if kind in DAY_KINDS)]
    if rng.random() < 0.5:
        return _hall_with_cap(rng, day, night)
    return _hall_between(rng, [tuple([kind]) for kind in day], _paired(rng, night))


def _paired(rng: Generator, kinds: Sequence[str]) -> list[_Stack]:
    """Return the kinds in a random order, each in a slot of its own."""
    return [(str(kind),) for kind in rng.permutation(list(kinds))]


def _hall_with_cap(rng: Generator, day: Sequence[str], night: Sequence[str]) -> list[tuple[str, Rect]]:
    """Return living room and perhaps a second day room as a cap at the hall's end, the rest along the hall."""
    in_cap = [day[0], *(day[1:2] if rng.random() < 0.6 else [])]
    if rng.random() < 0.5:
        in_cap.reverse()
    rest = _paired(rng, [kind for kind in day if kind not in in_cap] + list(night))
    half = len(rest) // 2
    banded = _hall_between(rng, rest[:half], rest[half:])
    low, high = min(r.y0 for _, r in banded), max(r.y1 for _, r in banded)
    cap = _stack(rng, tuple(in_cap), 0, low, high - low)
    width = cap[0][1].width
    return [(kind, Rect(r.x0 - width, r.y0, r.x1 - width, r.y1)) for kind, r in cap] + banded


def _hall_between(rng: Generator, south: Sequence[_Stack], north: Sequence[_Stack]) -> list[tuple[str, Rect]]:
    hall_width = rounded(rng.uniform(140, 200))
    south_depth, north_depth = (rounded(rng.uniform(300, 460)) for _ in range(2))
    lower = _row(rng, south, 0, -south_depth, south_depth)
    upper = _row(rng, north, 0, hall_width, north_depth)
    lower, upper = _evened(lower, upper)
    reach = [rooms[-1][1].x0 + 150 for rooms in (lower, upper)]
    end = max(*reach, min(rooms[-1][1].x1 for rooms in (lower, upper)))
    return [*lower, ("hall", Rect(0, 0, end, hall_width)), *upper]


def _evened(
    lower: list[tuple[str, Rect]], upper: list[tuple[str, Rect]]
) -> tuple[list[tuple[str, Rect]], list[tuple[str, Rect]]]:
    """Let the last room of the shorter band reach the longer one's end where little is missing; else it is an L."""
    ends = [rooms[-1][1].x1 for rooms in (lower, upper)]
    missing = abs(ends[0] - ends[1])
    if missing <= 100:
        rooms = lower if ends[0] < ends[1] else upper
        kind, rect = rooms[-1]
        rooms[-1] = (kind, Rect(rect.x0, rect.y0, max(ends), rect.y1))
    return lower, upper
