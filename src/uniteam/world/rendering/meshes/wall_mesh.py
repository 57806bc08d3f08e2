"""A wall as meshes: two faces painted by the rooms they look into, reveals, casings, baseboards, window panes."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.mesh import Material, Mesh
from uniteam.world.homes.home import Opening, Wall
from uniteam.world.rendering.meshes.mesh_builder import MeshBuilder, Plane, Surface, grid_cuts

BASEBOARD_HEIGHT, BASEBOARD_DEPTH = 0.08, 0.012
CASING_WIDTH, CASING_DEPTH = 0.07, 0.018
MULLION_WIDTH, MULLION_DEPTH = 0.05, 0.06
END_GAP = 0.001
"""A wall ends this far (m) before the far face of the one it meets, so that no two faces lie in one plane."""

TRIM_SURFACE = Surface(Material((0.93, 0.92, 0.90)))
TOP_SURFACE = Surface(Material((0.42, 0.42, 0.44)))
OUTSIDE_SURFACE = Surface(Material((0.80, 0.78, 0.74)))


def _sky() -> NDArray[np.uint8]:
    """Return a small picture of the sky over far hills, brightest at the horizon."""
    blue, haze, green = np.array([150, 190, 235.0]), np.array([228, 236, 242.0]), np.array([120, 140, 110.0])
    rows = np.linspace(0.0, 1.0, 64)[:, None]
    sky = blue + (haze - blue) * np.clip(rows / 0.7, 0.0, 1.0)
    image = np.where(rows > 0.72, green, sky)
    return np.ascontiguousarray(np.broadcast_to(image[:, None], (64, 4, 3)), dtype=np.uint8)


SKY_SURFACE = Surface(Material((1.0, 1.0, 1.0), _sky()))


@dataclass(frozen=True)
class WallFace:
    """A piece of a wall that is lit by one room (None: from outside)."""

    mesh: Mesh
    room: int | None
    is_glowing: bool = False


@dataclass(frozen=True)
class WallPainter:
    """What rooms' walls look like, and which room is at a point (m, world)."""

    surfaces: Sequence[Surface]
    room_at: Callable[[float, float], int | None]

    def surface(self, room: int | None) -> Surface:
        """Return the paint of a room, or that of the house's outside."""
        return OUTSIDE_SURFACE if room is None else self.surfaces[room]


@dataclass(frozen=True)
class _Side:
    """A wall seen from one side.

    Attributes:
        frame: (4, 4); x along the wall, y out of this face, z up, origin on the centre line, at the foot of the
            world's origin, so that the paint of walls in one line goes on from one to the next.
        begin, end: where the wall is along x, with what reaches into the walls that it meets (m).
        half_thickness, height: m.
        openings: along x.
    """

    frame: NDArray[np.float64]
    begin: float
    end: float
    half_thickness: float
    height: float
    openings: tuple[Opening, ...]

    def plane(self, normal: Sequence[float], origin: Sequence[float], right: Sequence[float]) -> Plane:
        """Return a plane of the wall's frame whose `up` is z, or y where it faces up or down."""
        rotation = self.frame[:3, :3]
        up = (0.0, 0.0, 1.0) if normal[2] == 0.0 else (0.0, 1.0, 0.0)
        return Plane(
            rotation @ np.array(origin) + self.frame[:3, 3], rotation @ right, rotation @ up, rotation @ normal
        )

    def point(self, along: float, out: float) -> tuple[float, float]:
        """Return a point (m, world) at `along` and `out` from the centre line."""
        x, y, _ = self.frame[:3, :3] @ np.array([along, out, 0.0]) + self.frame[:3, 3]
        return float(x), float(y)


def wall_faces(
    wall: Wall, height: float, painter: WallPainter, is_continued: tuple[bool, bool] = (False, False)
) -> Iterator[WallFace]:
    """Yield a wall's pieces up to the ceiling's height (m); another wall may go on from its start or from its end."""
    left, right = (_side(wall, height, sign, is_continued) for sign in (1.0, -1.0))
    for side in (left, right):
        for start, end, room in _stretches(side, painter):
            yield WallFace(_face(side, start, end, painter.surface(room)), room)
    for opening in left.openings:
        middle, out = (opening.start + opening.end) / 2.0, left.half_thickness + 0.1
        rooms = [room for room in (painter.room_at(*left.point(middle, y)) for y in (out, -out)) if room is not None]
        room = rooms[0] if rooms else None
        yield WallFace(_reveal(left, opening), room)
        if opening.kind == "window":
            yield WallFace(_pane(left, opening), room, is_glowing=True)
    yield WallFace(_rim(left), None)


def _side(wall: Wall, height: float, sign: float, is_continued: tuple[bool, bool]) -> _Side:
    start, end = np.array(wall.start), np.array(wall.end)
    along = (end - start) / np.linalg.norm(end - start)
    first, last = float(start @ along), float(end @ along)
    frame = np.eye(4)
    frame[:2, 0] = along
    frame[:2, 1] = sign * np.array([-along[1], along[0]])
    frame[:2, 3] = start - first * along
    before, after = (0.0 if continued else wall.thickness / 2.0 - END_GAP for continued in is_continued)
    openings = tuple(replace(o, start=o.start + first, end=o.end + first) for o in wall.openings)
    return _Side(frame, first - before, last + after, wall.thickness / 2.0, height, openings)


def _stretches(side: _Side, painter: WallPainter) -> Iterator[tuple[float, float, int | None]]:
    """Yield where the room on this side changes: start, end (m along the wall) and the room."""
    borders = np.linspace(side.begin, side.end, max(2, round((side.end - side.begin) / 0.05)) + 1)
    middles = (borders[:-1] + borders[1:]) / 2.0
    rooms = [painter.room_at(*side.point(float(a), side.half_thickness + 0.02)) for a in middles]
    changes = [0, *(k for k in range(1, len(rooms)) if rooms[k] != rooms[k - 1]), len(rooms)]
    for first, last in pairwise(changes):
        yield float(borders[first]), float(borders[last]), rooms[first]


def _face(side: _Side, start: float, end: float, surface: Surface) -> Mesh:
    builder = MeshBuilder()
    plane = side.plane((0.0, 1.0, 0.0), (0.0, side.half_thickness, 0.0), (1.0, 0.0, 0.0))
    holes = [o for o in side.openings if o.end > start and o.start < end]
    along = grid_cuts(start, end, [x for o in holes for x in (o.start, o.end)])
    up = grid_cuts(0.0, side.height, [z for o in holes for z in (o.bottom, o.top)])
    builder.add_rectangle(plane, (along, up), surface, _solid(along, up, holes))
    for low, high in _free_floor(start, end, holes):
        _add_bar(builder, side, (low, high), (0.0, BASEBOARD_HEIGHT), BASEBOARD_DEPTH)
    for opening in holes:
        _add_casing(builder, side, opening)
    return builder.build()


def _solid(along: Sequence[float], up: Sequence[float], holes: Sequence[Opening]) -> NDArray[np.bool_]:
    solid = np.ones((len(along) - 1, len(up) - 1), dtype=bool)
    a = (np.array(along)[:-1] + np.array(along)[1:]) / 2.0
    z = (np.array(up)[:-1] + np.array(up)[1:]) / 2.0
    for hole in holes:
        solid[np.ix_((a > hole.start) & (a < hole.end), (z > hole.bottom) & (z < hole.top))] = False
    return solid


def _free_floor(start: float, end: float, holes: Sequence[Opening]) -> Iterator[tuple[float, float]]:
    """Yield the stretches along which the wall meets the floor."""
    edge = start
    for hole in sorted((h for h in holes if h.bottom <= 0.0), key=lambda h: h.start):
        if hole.start > edge:
            yield edge, hole.start
        edge = hole.end
    if end > edge:
        yield edge, end


def _add_bar(
    builder: MeshBuilder, side: _Side, along: tuple[float, float], up: tuple[float, float], depth: float
) -> None:
    """Add a board that stands out of the face by `depth` (m)."""
    low = np.array([along[0], side.half_thickness - 0.001, up[0]])
    high = np.array([along[1], side.half_thickness + depth, up[1]])
    builder.add_box(low, high, side.frame, TRIM_SURFACE)


def _add_casing(builder: MeshBuilder, side: _Side, opening: Opening) -> None:
    left, right, width = opening.start, opening.end, CASING_WIDTH
    bottom = opening.bottom if opening.bottom <= 0.0 else opening.bottom - width
    for along in ((left - width, left), (right, right + width)):
        _add_bar(builder, side, along, (bottom, opening.top + width), CASING_DEPTH)
    _add_bar(builder, side, (left, right), (opening.top, opening.top + width), CASING_DEPTH)
    if opening.bottom > 0.0:
        _add_bar(builder, side, (left, right), (opening.bottom - width, opening.bottom), CASING_DEPTH * 2.0)


def _reveal(side: _Side, opening: Opening) -> Mesh:
    """Return the inner faces of an opening, through the wall's thickness."""
    builder = MeshBuilder()
    half, across = side.half_thickness, (-side.half_thickness, side.half_thickness)
    for along, normal in ((opening.start, 1.0), (opening.end, -1.0)):
        plane = side.plane((normal, 0.0, 0.0), (along, 0.0, 0.0), (0.0, 1.0, 0.0))
        builder.add_rectangle(plane, (across, (opening.bottom, opening.top)), TRIM_SURFACE)
    ends = ((opening.top, -1.0), (opening.bottom, 1.0)) if opening.bottom > 0.0 else ((opening.top, -1.0),)
    for height, normal in ends:
        plane = side.plane((0.0, 0.0, normal), (0.0, 0.0, height), (1.0, 0.0, 0.0))
        builder.add_rectangle(plane, ((opening.start, opening.end), (-half, half)), TRIM_SURFACE)
    if opening.kind == "window":
        _add_mullions(builder, side, opening)
    return builder.build()


def _add_mullions(builder: MeshBuilder, side: _Side, opening: Opening) -> None:
    middle, half, depth = (opening.start + opening.end) / 2.0, MULLION_WIDTH / 2.0, MULLION_DEPTH / 2.0
    posts = (opening.start, opening.start + MULLION_WIDTH), (middle - half, middle + half)
    for low, high in (*posts, (opening.end - MULLION_WIDTH, opening.end)):
        builder.add_box(
            np.array([low, -depth, opening.bottom]), np.array([high, depth, opening.top]), side.frame, TRIM_SURFACE
        )
    for low, high in (
        (opening.bottom, opening.bottom + MULLION_WIDTH),
        (opening.top - MULLION_WIDTH, opening.top),
    ):
        builder.add_box(
            np.array([opening.start, -depth * 0.9, low]), np.array([opening.end, depth * 0.9, high]), side.frame,
            TRIM_SURFACE,
        )  # fmt: skip


def _pane(side: _Side, opening: Opening) -> Mesh:
    builder = MeshBuilder()
    height = opening.top - opening.bottom
    origin = side.frame[:3, 3] + np.array([0.0, 0.0, opening.bottom])
    # One tile of the sky covers the pane: v runs from 0 at its top to 1 at its sill.
    surface = Surface(SKY_SURFACE.material, height)
    plane = Plane(origin + np.array([0.0, 0.0, height]), side.frame[:3, 0], np.eye(3)[2], side.frame[:3, 1])
    builder.add_rectangle(plane, ((opening.start, opening.end), (-height, 0.0)), surface)
    return builder.build()


def _rim(side: _Side) -> Mesh:
    """Return the wall's top and its two ends."""
    builder = MeshBuilder()
    half = side.half_thickness
    top = side.plane((0.0, 0.0, 1.0), (0.0, 0.0, side.height), (1.0, 0.0, 0.0))
    builder.add_rectangle(top, ((side.begin, side.end), (-half, half)), TOP_SURFACE)
    for along, normal in ((side.begin, -1.0), (side.end, 1.0)):
        plane = side.plane((normal, 0.0, 0.0), (along, 0.0, 0.0), (0.0, 1.0, 0.0))
        builder.add_rectangle(plane, ((-half, half), (0.0, side.height)), OUTSIDE_SURFACE)
    return builder.build()
