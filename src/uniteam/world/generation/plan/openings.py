"""Walls, and the doors, passages and windows in them, for a floor plan; whole centimetres.

A wall runs between two corners of rooms with no corner in between, so that each of its faces belongs to one room. Doors
make a tree that reaches every room by its most natural way, and some loops.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from numpy.random import Generator

from uniteam.world.generation.plan.planned_room import FloorPlan
from uniteam.world.generation.plan.rect import Rect

WALL_THICKNESS = 12
"""cm; rooms meet at the walls' centre lines."""

DOOR_TOP = 210
_CORNER = 16
"""How far from a wall's end an opening stays (cm)."""


@dataclass(frozen=True)
class PlannedOpening:
    """An opening of a planned wall, in cm along it and above the floor."""

    kind: Literal["door", "passage", "window"]
    start: int
    end: int
    bottom: int
    top: int


@dataclass(frozen=True)
class PlannedWall:
    """A stretch of wall along one axis: at `across` on the other, from `start` to `end` (cm).

    Attributes:
        horizontal: whether it runs along x.
        rooms: indices of the rooms below (or left) and above (or right); None outdoors.
        openings: in it, measured from `start`.
    """

    horizontal: bool
    across: int
    start: int
    end: int
    rooms: tuple[int | None, int | None]
    openings: tuple[PlannedOpening, ...] = ()

    @property
    def length(self) -> int:
        """Distance between its ends (cm)."""
        return self.end - self.start

    @property
    def is_exterior(self) -> bool:
        """Whether one side is outdoors."""
        return None in self.rooms

    def stretch(self, opening: PlannedOpening, depth: int) -> Rect:
        """Return the floor before and behind an opening, `depth` to each side of the wall's centre line."""
        start, end = self.start + opening.start, self.start + opening.end
        if self.horizontal:
            return Rect(start, self.across - depth, end, self.across + depth)
        return Rect(self.across - depth, start, self.across + depth, end)


def draw_walls(plan: FloorPlan, door_widths: Sequence[int], rng: Generator) -> tuple[PlannedWall, ...] | None:
    """Return the plan's walls with their openings, or None where some room cannot be reached as it should.

    Args:
        plan: the rooms.
        door_widths: those that a door may have (cm).
        rng: for every choice.
    """
    walls = [*_walls_along(plan, True), *_walls_along(plan, False)]
    openings: dict[int, list[PlannedOpening]] = {index: [] for index in range(len(walls))}
    joints = _chosen_joints(plan, walls, rng)
    if joints is None:
        return None
    for index in joints:
        openings[index].append(_way_through(plan, walls[index], door_widths, rng))
    for index, wall in enumerate(walls):
        if wall.is_exterior:
            openings[index] += _windows(plan, wall, rng)
    return tuple(
        PlannedWall(w.horizontal, w.across, w.start, w.end, w.rooms, tuple(openings[i])) for i, w in enumerate(walls)
    )


def _walls_along(plan: FloorPlan, horizontal: bool) -> Iterator[PlannedWall]:
    """Yield the walls of one direction, cut at every corner of a room that touches them."""
    spans = [_as_span(part, i, horizontal) for i, room in enumerate(plan) for part in room.floor.parts]
    for across in sorted({line for span in spans for line in span[2:4]}):
        touching = [s for s in spans if across in (s[2], s[3])]
        ends = sorted({end for s in touching for end in s[:2]})
        walls: list[PlannedWall] = []
        for start, end in pairwise(ends):
            rooms = (_room_at(spans, start, end, across, 3), _room_at(spans, start, end, across, 2))
            if rooms[0] == rooms[1]:  # the same room on both sides, or none
                continue
            if walls and walls[-1].end == start and walls[-1].rooms == rooms:  # the parts of a room meet here
                start = walls.pop().start
            walls.append(PlannedWall(horizontal, across, start, end, rooms))
        yield from walls


_Span = tuple[int, int, int, int, int]


def _as_span(rect: Rect, room: int, horizontal: bool) -> _Span:
    """Return (start, end) along and (low, high) across the direction, and the room."""
    sides = (rect.x0, rect.x1, rect.y0, rect.y1) if horizontal else (rect.y0, rect.y1, rect.x0, rect.x1)
    return (*sides, room)


def _room_at(spans: Sequence[_Span], start: int, end: int, across: int, side: Literal[2, 3]) -> int | None:
    found = (span[4] for span in spans if span[side] == across and span[0] <= start and end <= span[1])
    return next(found, None)


_ENTRY_COST = {
    "hall": {"hall": 1, "living_room": 1, "kitchen": 3, "dining_room": 3, "bedroom": 1, "bathroom": 1, "office": 1,
             "laundry": 1},
    "living_room": {"hall": 1, "kitchen": 1, "dining_room": 1, "bedroom": 4, "bathroom": 6, "office": 3, "laundry": 6},
    "dining_room": {"hall": 2, "kitchen": 1, "living_room": 1, "bedroom": 6, "bathroom": 7, "office": 4, "laundry": 5},
    "kitchen": {"hall": 2, "dining_room": 1, "living_room": 1, "laundry": 2, "bathroom": 9, "bedroom": 12,
                "office": 9},
    "bedroom": {"bathroom": 8, "office": 10},
    "office": {"bedroom": 20, "bathroom": 14},
    "bathroom": {},
    "laundry": {},
}  # fmt: skip
"""What it costs to enter a room of the inner kind from one of the outer; where nothing stands there is no way."""

_LOOP_CHANCE = {
    frozenset({"living_room", "kitchen"}): 0.9,
    frozenset({"living_room", "dining_room"}): 0.9,
    frozenset({"kitchen", "dining_room"}): 0.9,
    frozenset({"hall", "living_room"}): 0.9,
    frozenset({"hall", "kitchen"}): 0.4,
    frozenset({"hall", "dining_room"}): 0.4,
    frozenset({"bedroom", "bathroom"}): 0.35,
    frozenset({"kitchen", "laundry"}): 0.4,
    frozenset({"living_room", "office"}): 0.4,
    frozenset({"bedroom", "office"}): 0.2,
}


def _chosen_joints(plan: FloorPlan, walls: Sequence[PlannedWall], rng: Generator) -> list[int] | None:
    """Return the walls that get a way through: the cheapest tree from the hall or the living room, then some loops."""
    shared = [i for i, w in enumerate(walls) if not w.is_exterior and w.length >= 100 + 2 * _CORNER]
    kinds = [room.kind for room in plan]
    root = kinds.index("hall") if "hall" in kinds else kinds.index("living_room")
    reached, joints = {root}, []
    while len(reached) < len(plan):
        ways = [way for i in shared for way in _ways_in(walls[i], i, kinds, reached)]
        if not ways:
            return None
        _, _, joint, room = min(ways)
        reached.add(room)
        joints.append(joint)
    for i in shared:
        pair = frozenset(kinds[room] for room in walls[i].rooms if room is not None)
        if rng.random() < _LOOP_CHANCE.get(pair, 0.0) and i not in joints:
            joints.append(i)
    return joints


def _ways_in(
    wall: PlannedWall, index: int, kinds: Sequence[str], reached: set[int]
) -> Iterator[tuple[int, int, int, int]]:
    """Yield (cost, -length, wall, room) of entering an unreached room through this wall from a reached one."""
    for outer, inner in (wall.rooms, wall.rooms[::-1]):
        if outer in reached and inner not in reached and outer is not None and inner is not None:
            cost = _ENTRY_COST[kinds[outer]].get(kinds[inner])
            if cost is not None:
                yield cost, -wall.length, index, inner


_OPEN_PAIRS = {
    frozenset({"living_room", "kitchen"}): 0.65,
    frozenset({"living_room", "dining_room"}): 0.8,
    frozenset({"kitchen", "dining_room"}): 0.6,
    frozenset({"hall", "living_room"}): 0.5,
}
"""How often these rooms meet in a passage rather than a door."""


def _way_through(plan: FloorPlan, wall: PlannedWall, door_widths: Sequence[int], rng: Generator) -> PlannedOpening:
    """Return a passage, or a door at the middle or near an end of the wall."""
    pair = frozenset(plan[room].kind for room in wall.rooms if room is not None)
    room_left = wall.length - 2 * _CORNER
    if rng.random() < _OPEN_PAIRS.get(pair, 0.0) and room_left >= 120:
        width = 10 * int(rng.integers(12, 1 + min(room_left, 240) // 10))
        start = _CORNER + int(rng.integers(0, 3)) * (room_left - width) // 2
        return PlannedOpening("passage", start, start + width, 0, 230)
    width = int(rng.choice(door_widths))
    spare = room_left - width
    offset = min(int(rng.choice([0, 10, 30])), spare)
    start = _CORNER + (offset if rng.random() < 0.5 else spare - offset)
    return PlannedOpening("door", start, start + width, 0, DOOR_TOP)


_WINDOW_WIDTHS = {"bathroom": (60, 60), "laundry": (60, 80), "hall": (60, 90)}


def _windows(plan: FloorPlan, wall: PlannedWall, rng: Generator) -> list[PlannedOpening]:
    """Return no window, one in the wall's middle, or two in a long wall."""
    kind = next(plan[room].kind for room in wall.rooms if room is not None)
    chance = {"bathroom": 0.5, "laundry": 0.5, "hall": 0.4}.get(kind, 0.75)
    if rng.random() > chance or wall.length < 120:
        return []
    widths = _WINDOW_WIDTHS.get(kind, (90, 180))
    count = 2 if wall.length >= 420 and rng.random() < 0.5 else 1
    width = min(10 * int(rng.integers(widths[0] // 10, widths[1] // 10 + 1)), wall.length // count - 60)
    bottom = 140 if kind in ("bathroom", "laundry") else int(rng.choice([80, 90, 100]))
    starts = [(2 * i + 1) * wall.length // (2 * count) - width // 2 for i in range(count)]
    return [PlannedOpening("window", start, start + width, bottom, DOOR_TOP) for start in starts]
