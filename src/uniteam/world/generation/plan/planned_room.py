"""A room of a plan, before anything is built."""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from uniteam.world.generation.plan.floor_shape import FloorShape
from uniteam.world.generation.plan.rect import Rect


@dataclass(frozen=True)
class PlannedRoom:
    """A room of the plan: its name, its kind, and its floor between the walls' centre lines.

    Attributes:
        name: unique in the plan.
        kind: what it is for.
        rect: the rectangle around its floor.
        cuts: the corners of it that other rooms or the outdoors have; none where the room is a rectangle.
    """

    name: str
    kind: str
    rect: Rect
    cuts: tuple[Rect, ...] = ()

    @property
    def floor(self) -> FloorShape:
        """Its floor."""
        return FloorShape(self.rect, self.cuts)


FloorPlan = tuple[PlannedRoom, ...]


def turned_plan(rooms: Sequence[PlannedRoom], quarters: int, mirrored: bool) -> list[PlannedRoom]:
    """Return the rooms turned and mirrored, with their lower left corner at the origin."""

    def turned(rect: Rect) -> Rect:
        if mirrored:
            rect = Rect(-rect.x1, rect.y0, -rect.x0, rect.y1)
        for _ in range(quarters):
            rect = Rect(-rect.y1, rect.x0, -rect.y0, rect.x1)
        return rect

    rects = [turned(room.rect) for room in rooms]
    x, y = min(rect.x0 for rect in rects), min(rect.y0 for rect in rects)
    return [
        replace(room, rect=rect.shifted(-x, -y), cuts=tuple(turned(cut).shifted(-x, -y) for cut in room.cuts))
        for room, rect in zip(rooms, rects, strict=True)
    ]


def named_plan(rooms: Iterable[PlannedRoom]) -> FloorPlan:
    """Return the rooms with names that count within their kind."""
    counts: Counter[str] = Counter()
    named = []
    for room in rooms:
        counts[room.kind] += 1
        named.append(replace(room, name=f"{room.kind}_{counts[room.kind]}"))
    return tuple(named)
