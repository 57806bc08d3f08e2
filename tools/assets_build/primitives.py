"""Drawing simple models from boards, turned profiles and tubes, in the model frame (m, z up, front towards -y)."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from assets_build.glb import OutputMaterial
from assets_build.wavefront import SourceMaterial, SourceMesh

Color = tuple[float, float, float]
Vector = tuple[float, float, float]
Section = tuple[float, float, float, float, float, float]
"""A level ring of a lofted body: its height, half extents along x and y, power of roundness, and centre (x, y)."""


@dataclass(frozen=True)
class Finish:
    """What a piece is made of: a colour, or a texture's JPEG of which one repeat covers `tile` metres."""

    color: Color = (1.0, 1.0, 1.0)
    jpeg: bytes | None = None
    tile: float = 0.5


@dataclass
class Drawing:
    """Triangles gathered piece by piece."""

    corners: list[NDArray[np.float64]] = field(default_factory=list)
    uvs: list[NDArray[np.float64]] = field(default_factory=list)
    owners: list[NDArray[np.int32]] = field(default_factory=list)
    finishes: list[Finish] = field(default_factory=list)

    def add(self, corners: NDArray[np.float64], finish: Finish, uvs: NDArray[np.float64] | None = None) -> None:
        """Add (T, 3, 3) corners; texture coordinates (T, 3, 2), v up, are projected along the face where not given."""
        if finish not in self.finishes:
            self.finishes.append(finish)
        self.corners.append(corners)
        self.uvs.append(_projected(corners, finish.tile) if uvs is None else uvs)
        self.owners.append(np.full(len(corners), self.finishes.index(finish), np.int32))

    def box(self, low: Vector, high: Vector, finish: Finish) -> None:
        """Add a board or block between two corners."""
        (x0, y0, z0), (x1, y1, z1) = low, high
        p = np.array([[x, y, z] for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)])
        quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        self.add(np.concatenate([[p[[a, b, c]], p[[a, c, d]]] for a, b, c, d in quads]), finish)

    def block(self, centre: Vector, size: Vector, finish: Finish) -> None:
        """Add a box by its centre and extents."""
        low, high = np.array(centre) - np.array(size) / 2, np.array(centre) + np.array(size) / 2
        self.box(tuple(low), tuple(high), finish)  # type: ignore[arg-type]

    def soft_block(self, centre: Vector, size: Vector, power: float, finish: Finish, steps: int = 12) -> None:
        """Add a cushion-like superellipsoid; `power` below 1 makes it boxier."""

        def bent(value: float) -> float:
            return math.copysign(abs(value) ** power, value)

        grid = np.zeros((steps + 1, 2 * steps, 3))
        for i in range(steps + 1):
            v = math.pi * (i / steps - 0.5)
            for j in range(2 * steps):
                u = math.pi * j / steps
                grid[i, j] = (
                    bent(math.cos(v)) * bent(math.cos(u)),
                    bent(math.cos(v)) * bent(math.sin(u)),
                    bent(math.sin(v)),
                )
        self.add(_skin(grid * np.array(size) / 2 + np.array(centre)), finish)

    def lathe(
        self,
        profile: Sequence[tuple[float, float]],
        finish: Finish,
        centre: tuple[float, float] = (0.0, 0.0),
        segments: int = 24,
    ) -> None:
        """Add a body turned about a vertical axis; `profile` is (radius, height) up the outside, then down within."""
        angles = 2 * math.pi * np.arange(segments) / segments
        grid = np.array(
            [[(r * math.cos(a) + centre[0], r * math.sin(a) + centre[1], z) for a in angles] for r, z in profile]
        )
        lengths = np.cumsum([0.0] + [math.dist(p, q) for p, q in pairwise(profile)])
        widest = max(r for r, _ in profile)
        across = max(1.0, round(2 * math.pi * widest / finish.tile))
        self.add(_skin(grid), finish, _wrapped_uvs(lengths / finish.tile, segments, across))

    def tube(self, path: Sequence[Vector], radius: float | Sequence[float], finish: Finish, segments: int = 8) -> None:
        """Add a round bar along a path, closed at both ends; `radius` may differ from point to point."""
        points = np.array(path, dtype=float)
        radii = np.broadcast_to(np.array(radius, dtype=float), (len(points),))
        along = np.gradient(points, axis=0)
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        aside = np.cross(along[0], [0.0, 0.0, 1.0] if abs(along[0, 2]) < 0.9 else [1.0, 0.0, 0.0])
        rings = []
        for point, direction, r in zip(points, along, radii, strict=True):
            aside = aside - direction * (aside @ direction)
            aside /= np.linalg.norm(aside)
            other = np.cross(direction, aside)
            angles = 2 * math.pi * np.arange(segments) / segments
            rings.append([point + r * (math.cos(a) * aside + math.sin(a) * other) for a in angles])
        capped = [np.tile(points[0], (segments, 1)), *rings, np.tile(points[-1], (segments, 1))]
        self.add(_skin(np.array(capped)), finish)

    def loft(self, sections: Sequence[Section], finish: Finish, segments: int = 20) -> None:
        """Add a body through level rings, closed at both ends; `power` below 1 makes a ring boxier."""
        rings = _level_rings(sections, segments)
        ends = [np.tile(ring.mean(axis=0), (segments, 1)) for ring in (rings[0], rings[-1])]
        self.add(_skin(np.array([ends[0], *rings, ends[1]])), finish)

    def shell(self, sections: Sequence[Section], finish: Finish, segments: int = 20) -> None:
        """Add a skin through level rings, open at both ends."""
        self.add(_skin(np.array(_level_rings(sections, segments))), finish)

    def prism(self, outline: Sequence[tuple[float, float]], low: float, high: float, finish: Finish) -> None:
        """Add an upright prism over a simple polygon (x, y), counter-clockwise, between two heights."""
        flat = np.array(outline, dtype=float)
        caps = flat[_ears(flat)]
        bottom = np.concatenate([caps[:, ::-1], np.full((len(caps), 3, 1), low)], axis=2)
        top = np.concatenate([caps, np.full((len(caps), 3, 1), high)], axis=2)
        rings = np.array([np.column_stack([flat, np.full(len(flat), z)]) for z in (low, high)])
        self.add(np.concatenate([bottom, top, _skin(rings)]), finish)

    def place(self, part: "Drawing", at: Vector = (0.0, 0.0, 0.0), turn: Vector = (0.0, 0.0, 0.0)) -> None:
        """Add what another drawing holds, turned by degrees about x, then y, then z, and moved."""
        for axis, degrees in enumerate(turn):
            part.turn(degrees, axis)
        for corners, uvs, owners in zip(part.corners, part.uvs, part.owners, strict=True):
            self.add(corners + np.array(at), part.finishes[int(owners[0])], uvs)

    def turn(self, degrees: float, axis: int = 2) -> None:
        """Turn everything drawn so far about an axis through the origin."""
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        a, b = ((1, 2), (2, 0), (0, 1))[axis]
        matrix = np.eye(3)
        matrix[a, a], matrix[a, b], matrix[b, a], matrix[b, b] = c, -s, s, c
        self.corners = [corners @ matrix.T for corners in self.corners]

    def mesh(self) -> SourceMesh:
        """Return what was drawn, with the origin at the centre of the bottom."""
        points = np.concatenate(self.corners)
        flat = points.reshape(-1, 3)
        low, high = flat.min(0), flat.max(0)
        points = points - np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
        materials = [SourceMaterial(f.color) for f in self.finishes]
        return SourceMesh(points, np.concatenate(self.uvs), np.concatenate(self.owners), materials)

    def materials(self) -> list[OutputMaterial]:
        """Return the finishes as the file's materials."""
        return [OutputMaterial(f.color, f.jpeg) for f in self.finishes]


def _level_rings(sections: Sequence[Section], segments: int) -> list[NDArray[np.float64]]:
    angles = 2 * math.pi * (np.arange(segments) + 0.5) / segments
    cosines, sines = np.cos(angles), np.sin(angles)
    rings = []
    for z, half_x, half_y, power, x, y in sections:
        ring = np.full((segments, 3), float(z))
        ring[:, 0] = x + half_x * np.sign(cosines) * np.abs(cosines) ** power
        ring[:, 1] = y + half_y * np.sign(sines) * np.abs(sines) ** power
        rings.append(ring)
    return rings


def _skin(grid: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the triangles of a grid of closed rings (R, S, 3); degenerate ones are left to the weld."""
    a, b = grid[:-1], grid[1:]
    a_next, b_next = np.roll(a, -1, axis=1), np.roll(b, -1, axis=1)
    first = np.stack([a, a_next, b_next], axis=2)
    second = np.stack([a, b_next, b], axis=2)
    return np.concatenate([first.reshape(-1, 3, 3), second.reshape(-1, 3, 3)])


def _ears(polygon: NDArray[np.float64]) -> list[tuple[int, int, int]]:
    """Return the triangles of a simple polygon, counter-clockwise, by clipping its ears."""

    def side(a: NDArray[np.float64], b: NDArray[np.float64], c: NDArray[np.float64]) -> float:
        return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))

    left = list(range(len(polygon)))
    triangles: list[tuple[int, int, int]] = []
    while len(left) > 3:
        for k in range(len(left)):
            i, j, m = left[k - 1], left[k], left[(k + 1) % len(left)]
            a, b, c = polygon[[i, j, m]]
            others = (polygon[n] for n in left if n not in (i, j, m))
            if side(a, b, c) > 0 and not any(
                side(a, b, p) >= 0 and side(b, c, p) >= 0 and side(c, a, p) >= 0 for p in others
            ):
                triangles.append((i, j, m))
                del left[k]
                break
        else:
            raise ValueError("the outline crosses itself, or runs clockwise")
    return [*triangles, (left[0], left[1], left[2])]


def _wrapped_uvs(heights: NDArray[np.float64], segments: int, across: float) -> NDArray[np.float64]:
    u = np.arange(segments + 1) / segments * across
    grid = np.stack(np.meshgrid(u, heights), axis=-1)
    a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
    return np.concatenate(
        [np.stack([a, b, c], axis=2).reshape(-1, 3, 2), np.stack([a, c, d], axis=2).reshape(-1, 3, 2)]
    )


def _projected(corners: NDArray[np.float64], tile: float) -> NDArray[np.float64]:
    """Return texture coordinates by projection along each face's main axis; grain runs along the longer side."""
    normals = np.abs(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    axis = normals.argmax(axis=1)
    extent = np.ptp(corners.reshape(-1, 3), axis=0)
    uvs = np.zeros((len(corners), 3, 2))
    for k, (i, j) in enumerate(((1, 2), (0, 2), (0, 1))):
        i, j = (i, j) if extent[i] >= extent[j] else (j, i)
        uvs[axis == k] = corners[axis == k][:, :, [i, j]] / tile
    return uvs
