"""Support surfaces: where the tops of collision shapes and the model's own upward faces agree."""

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.spatial import ConvexHull

from assets_build.sampling import SurfaceSamples
from assets_build.shapes import Shape, box

CELL = 0.01
LEAST_CLEARANCE = 0.12
OPEN_CLEARANCE = 0.5
UNBOUNDED = 3.0
MOST_SURFACES = 8
CUSHION_TOLERANCE = 0.03

Surface = dict[str, object]


def find_surfaces(
    shapes: list[Shape], samples: SurfaceSamples, size: tuple[float, ...], heights: tuple[float, float]
) -> list[Surface]:
    """Return the flat regions of a model, between two heights, that can hold a thing, the largest first."""
    grid = _Grid(shapes, samples, size)
    found: list[tuple[float, Surface]] = []
    for height in (h for h in grid.levels() if heights[0] <= h <= heights[1]):
        clearance = grid.clearance(height)
        for low, high in ((OPEN_CLEARANCE, np.inf), (LEAST_CLEARANCE, OPEN_CLEARANCE)):
            mask = (clearance >= low) & (clearance <= high if high == np.inf else clearance < high)
            for polygon, cells in convex_parts(mask):
                room = float(min(clearance[cells].min(), UNBOUNDED))
                outline = [[round(float(v), 4) for v in grid.point(p)] for p in polygon]
                surface: Surface = {"height": round(height, 4), "outline": outline, "clearance": round(room, 3)}
                found.append((float(cells.sum()) * CELL * CELL, surface))
    found.sort(key=lambda pair: -pair[0])
    return [surface for _, surface in found[:MOST_SURFACES]]


def is_usable(surface: Surface) -> bool:
    """Say whether a robot whose gripper reaches from 0.1 to 1.1 m could put a thing on the surface."""
    return 0.05 <= float(surface["height"]) <= 1.05 and float(surface["clearance"]) >= 0.2  # type: ignore[arg-type]


def seat_box(samples: SurfaceSamples, shapes: list[Shape]) -> Shape | None:
    """Return a box under a model's widest nearly level region between 5 cm and 1.05 m, or None where there is none.

    It stands for the leaning seats and curved basins that have no flat top. It tops whatever shape reaches into it.
    """
    points = samples.points[
        (samples.normals[:, 2] > 0.8) & (samples.points[:, 2] > 0.05) & (samples.points[:, 2] < 1.02)
    ]
    if not len(points):
        return None
    heights = np.arange(0.05, 1.02, 0.01)
    band = [np.abs(points[:, 2] - h) < CUSHION_TOLERANCE for h in heights]
    chosen = points[band[int(np.argmax([b.sum() for b in band]))]]
    low = chosen[:, :2].min(0)
    index = np.floor((chosen[:, :2] - low) / CELL).astype(int)
    mask = np.zeros(index.max(0) + 1, bool)
    mask[index[:, 0], index[:, 1]] = True
    x0, x1, y0, y1 = largest_rectangle(ndimage.binary_closing(np.pad(mask, 3), iterations=3)[3:-3, 3:-3])
    if min(x1 - x0, y1 - y0) < 10:
        return None
    corner, far = low + np.array([x0, y0]) * CELL, low + np.array([x1, y1]) * CELL
    top = float(np.median(chosen[:, 2]))
    for shape in shapes:
        points_of = (
            np.array(shape["hull"])
            if "hull" in shape
            else np.array(shape["center"]) + np.array(shape["size"]) / 2 * _CORNERS
        )
        meets = (points_of[:, :2].min(0) < far).all() and (points_of[:, :2].max(0) > corner).all()
        if meets and abs(points_of[:, 2].max() - top) < 0.025:
            top = max(top, float(points_of[:, 2].max()))
    return box(np.array([*corner, top - 0.03]), np.array([*far, top]))


_CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])


class _Grid:
    """The shapes seen from above on 1 cm cells: footprints, bottoms and tops."""

    def __init__(self, shapes: list[Shape], samples: SurfaceSamples, size: tuple[float, ...]) -> None:
        self.low = np.array([-size[0] / 2, -size[1] / 2])
        self.shape = tuple(int(np.ceil(s / CELL)) + 1 for s in size[:2])
        i, j = np.meshgrid(np.arange(self.shape[0]), np.arange(self.shape[1]), indexing="ij")
        self.centres = np.stack([i, j], axis=-1) * CELL + CELL / 2 + self.low
        self.samples = samples
        self.layers = [self._layer(s) for s in shapes]

    def _layer(self, shape: Shape) -> tuple[NDArray[np.bool_], float, float, bool]:
        """Return a shape's footprint, bottom, top, and whether its top is flat."""
        if "hull" in shape:
            points = np.array(shape["hull"])
            top, bottom = points[:, 2].max(), points[:, 2].min()
            rim = points[points[:, 2] > top - 1e-3]
            flat = len(rim) >= 3
            outline = ConvexHull((rim if flat else points)[:, :2])
            inside = (self.centres @ outline.equations[:, :2].T + outline.equations[:, 2] <= -1e-3).all(-1)
            return inside, bottom, top, flat
        centre, half = np.array(shape["center"]), np.array(shape["size"]) / 2
        inside = (np.abs(self.centres - centre[:2]) <= half[:2]).all(-1)
        return inside, centre[2] - half[2], centre[2] + half[2], True

    def point(self, cell: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the model-frame point of a (fractional) cell corner."""
        return cell * CELL + self.low

    def levels(self) -> list[float]:
        """Return the heights of flat tops, lowest first, those within 4 mm as one."""
        tops = sorted({top for _, _, top, flat in self.layers if flat})
        return [top for k, top in enumerate(tops) if k + 1 == len(tops) or tops[k + 1] - top > 0.004]

    def clearance(self, height: float) -> NDArray[np.float64]:
        """Return for each cell the free height above a top at `height`; 0 where there is no top or it is not free."""
        top_here = np.zeros(self.shape, bool)
        ceiling = np.full(self.shape, np.inf)
        for inside, bottom, top, flat in self.layers:
            if flat and abs(top - height) <= 0.004:
                top_here |= inside
            elif top > height:
                ceiling[inside] = np.minimum(ceiling[inside], max(bottom, height))
        free = np.where(top_here & self._shown(height), ceiling - height, 0.0)
        return np.where(free < LEAST_CLEARANCE, 0.0, free)

    def _shown(self, height: float) -> NDArray[np.bool_]:
        """Return the cells where the model itself faces up near that height and nothing of it stands just above."""
        points, normals = self.samples.points, self.samples.normals
        near = (np.abs(points[:, 2] - height) < CUSHION_TOLERANCE) & (normals[:, 2] > 0.6)
        above = (points[:, 2] > height + CUSHION_TOLERANCE) & (points[:, 2] < height + LEAST_CLEARANCE)
        shown = ndimage.binary_closing(np.pad(self._cells(points[near]), 3), iterations=3)[3:-3, 3:-3]
        return shown & ~ndimage.binary_dilation(self._cells(points[above]))

    def _cells(self, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        mask = np.zeros(self.shape, bool)
        index = np.floor((points[:, :2] - self.low) / CELL).astype(int)
        index = np.clip(index, 0, np.array(self.shape) - 1)
        mask[index[:, 0], index[:, 1]] = True
        return mask


def convex_parts(
    mask: NDArray[np.bool_], least: int = 10, most: int = 4
) -> list[tuple[NDArray[np.float64], NDArray[np.bool_]]]:
    """Return convex polygons (corners in cells, counter-clockwise) within a mask, with the cells each holds.

    A part that is nearly convex keeps its outline; any other gives its largest rectangle, then that of the rest.
    """
    left = ndimage.binary_opening(np.pad(mask, 1), np.ones((3, 3)))[1:-1, 1:-1]
    parts = []
    for _ in range(most):
        labels, count = ndimage.label(left)
        if not count:
            break
        sizes = ndimage.sum_labels(left, labels, np.arange(1, count + 1))
        component = labels == 1 + int(np.argmax(sizes))
        polygon = _outline(component)
        if polygon is None:
            x0, x1, y0, y1 = largest_rectangle(component)
            polygon = np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]], float)
            component = np.zeros_like(component)
            component[x0:x1, y0:y1] = True
        left &= ~component
        if _narrowest(component) < least or component.sum() < 2.5 * least * least:
            continue
        parts.append((polygon, component))
    return parts


def _narrowest(component: NDArray[np.bool_]) -> int:
    x0, x1, y0, y1 = largest_rectangle(component)
    return min(x1 - x0, y1 - y0)


def _outline(component: NDArray[np.bool_]) -> NDArray[np.float64] | None:
    """Return the simplified outline of a nearly convex component, pulled inside it, or None."""
    i, j = np.nonzero(component)
    centres = np.column_stack([i + 0.5, j + 0.5])
    if len(centres) < 20 or min(np.ptp(i), np.ptp(j)) < 3:
        return None
    around = ConvexHull(centres)
    if component.sum() < 0.97 * around.volume:
        return None
    polygon = centres[around.vertices]
    angles = np.arange(16) * np.pi / 8
    middle = centres.mean(0)
    chosen = sorted({int(np.argmax((polygon - middle) @ np.array([np.cos(a), np.sin(a)]))) for a in angles})
    return polygon[chosen]


def largest_rectangle(mask: NDArray[np.bool_]) -> tuple[int, int, int, int]:
    """Return (x0, x1, y0, y1), half-open, of the largest rectangle of set cells."""
    heights = np.zeros(mask.shape[1], int)
    best, found = 0, (0, 0, 0, 0)
    for row in range(mask.shape[0]):
        heights = np.where(mask[row], heights + 1, 0)
        stack: list[tuple[int, int]] = []
        for column, height in enumerate([*heights.tolist(), 0]):
            start = column
            while stack and stack[-1][1] >= height:
                start, tall = stack.pop()
                if tall * (column - start) > best:
                    best, found = tall * (column - start), (row + 1 - tall, row + 1, start, column)
            stack.append((start, height))
    return found
