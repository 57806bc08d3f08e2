"""The bird's-eye-view map: what the robot has seen, from above, in the frame where it started."""

import math
from functools import partial

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.grid import Cell, Grid, Mask, disc, disc_mask, enlarged
from uniteam.interface import Observation, Segmentation
from uniteam.mind.mapping.clearing import MapCells
from uniteam.mind.mapping.frame_on_map import frame_on_map, receptacle_pixels
from uniteam.mind.mapping.map_config import MapConfig
from uniteam.mind.mapping.projection import ROLE_COUNT, Channels
from uniteam.mind.mapping.viewed_sides import Gaze, LookBits, Pixels, look_bits
from uniteam.mind.perception.vocabulary import ClassRole, RoleScores

FACED_RANGE = 1.2
"""m; up to which what the robot faces at the end of its way is looked at."""


class BirdsEyeMap:
    """Obstacles, what is explored, where the robot was, and where each class was seen: a grid in the start frame.

    Row is y and column is x; all channels have the same (H, W) shape, which changes when the map grows: keep points,
    not cells or masks, from one step to the next. Nothing clears an obstacle, as in HomeRobot, but `clear` of the
    configuration. Update it in navigation
    posture only: seen from another, the arm itself would be mapped.

    Attributes:
        obstacle: something between the obstacle heights was seen there (or a collision was written there).
        explored: anything at all was seen there, or the robot stood within `explored_radius`.
        visited: the robot's axis passed over it.
        been_close: the robot stood within `been_close_radius`.
        collision: a blocked motion left its mark there.
        felt: an obstacle that a collision wrote there, and nothing was seen.
        looked_from: (H, W) uint8, the sides from which the start receptacle there was looked at, as bits (see
            `viewed_sides`).
        fine: obstacles at a finer grain, where the configuration asks for it.
        origin: (x, y) in the start frame (m) of the corner of cell [0, 0].
        update_count: how many frames have been brought in.
    """

    obstacle: Mask
    explored: Mask
    visited: Mask
    been_close: Mask
    collision: Mask
    felt: Mask

    def __init__(self, config: MapConfig | None = None) -> None:
        """Begin with an empty map around the start."""
        self.config = config or MapConfig()
        half = round(self.config.initial_size / self.config.cell_size / 2)
        shape = (2 * half, 2 * half)
        self.origin = (-half * self.config.cell_size, -half * self.config.cell_size)
        self.obstacle, self.explored, self.visited, self.been_close, self.collision, self.felt = (
            np.zeros(shape, dtype=np.bool_) for _ in range(6)
        )
        self.looked_from = np.zeros(shape, dtype=np.uint8)
        self._class_cells = np.zeros((ROLE_COUNT, *shape), dtype=np.bool_)
        self._class_probability = np.zeros((ROLE_COUNT, *shape), dtype=np.float32)
        self._class_height = np.zeros((ROLE_COUNT, *shape), dtype=np.float32)
        self._last_base: BasePose | None = None
        self._known: tuple[Cell, Cell] = (shape, (0, 0))
        self._project, self._clear = self.config.project(), self.config.clear()
        self._looks = self.config.looks
        self.fine = self.config.fine_obstacles()
        self.update_count = 0

    @property
    def shape(self) -> tuple[int, int]:
        """The number of rows and columns."""
        return self.obstacle.shape[0], self.obstacle.shape[1]

    @property
    def known(self) -> tuple[Cell, Cell]:
        """The first (row, column) and the one past the last of the part that holds all that was ever seen."""
        return self._known

    @property
    def cell_size(self) -> float:
        """The side of a cell (m)."""
        return self.config.cell_size

    def class_cells(self, role: ClassRole) -> Mask:
        """Return the (H, W) cells where the class was ever seen: HomeRobot's binary channel."""
        return self._class_cells[role]

    def class_probability(self, role: ClassRole) -> NDArray[np.float32]:
        """Return the (H, W) running probability of the class.

        The first sighting sets it to the detection's score; later ones pull it towards theirs by `probability_gain`;
        each frame that shows the cell without the class takes `probability_decay` of it.
        """
        return self._class_probability[role]

    def class_height(self, role: ClassRole) -> NDArray[np.float32]:
        """Return the (H, W) greatest height (m) of the class at its last sighting; 0 where it was never seen."""
        return self._class_height[role]

    def object_on_start_receptacle(self, play: int) -> Mask:
        """Return the (H, W) cells of the object with the start receptacle at most `play` cells away."""
        (top, left), (bottom, right) = self._known
        known = slice(top, bottom), slice(left, right)
        receptacle = np.ascontiguousarray(self.class_cells(ClassRole.START_RECEPTACLE)[known]).view(np.uint8)
        both = np.zeros(self.shape, dtype=np.bool_)
        if receptacle.size:
            both[known] = self.class_cells(ClassRole.OBJECT)[known] & cv2.dilate(receptacle, disc(play)).view(np.bool_)
        return both

    @property
    def grid(self) -> Grid:
        """Where the map's cells lie in the start frame, until it grows."""
        return Grid(self.origin, self.cell_size)

    def to_cell(self, x: float, y: float) -> Cell:
        """Return the (row, column) of a point of the start frame (m); it may lie outside the map."""
        return self.grid.to_cell(x, y)

    def to_point(self, row: float, column: float) -> tuple[float, float]:
        """Return the (x, y) in the start frame (m) of a cell's centre."""
        return self.grid.to_point(row, column)

    def to_points(self, cells: NDArray[np.number]) -> NDArray[np.float64]:
        """Return the (K, 2) centres (x, y) in the start frame (m) of (K, 2) cells (row, column)."""
        return self.grid.to_points(cells)

    def points_of(self, mask: Mask) -> NDArray[np.float64]:
        """Return the (K, 2) centres (x, y) in the start frame (m) of a mask's cells, row by row."""
        return self.to_points(np.column_stack(np.divmod(np.flatnonzero(mask), mask.shape[1])))

    def update(self, observation: Observation, segmentation: Segmentation, roles: RoleScores) -> None:
        """Bring a frame into the map, and the robot's own place."""
        base = observation.base_to_start
        self._cover(base)
        frame, limits = (
            frame_on_map(observation, segmentation, roles, self.origin),
            self.config.limits(observation.depth.size),
        )
        touched = self._project(frame, limits, self._channels())
        self._know(touched[:2], touched[2:])
        self._clear(frame, MapCells(self._channels(), self.felt, self.grid))
        self.fine.update(observation)
        self._mark_robot(base)
        pixels = partial(receptacle_pixels, observation, segmentation, frame.scores)
        self._mark_look(Gaze(base.x, base.y, base.heading), self._looks, pixels)
        self.update_count += 1

    def mark_collision(self, points: NDArray[np.floating]) -> None:
        """Set the collision cells at (K, 2) points (x, y) of the start frame (m)."""
        self._mark(self.collision, points)

    def mark_felt(self, points: NDArray[np.floating]) -> None:
        """Make obstacles of the cells at (K, 2) points (x, y) of the start frame (m) that are none yet."""
        felt = np.zeros(self.shape, dtype=np.bool_)
        self._mark(felt, points)
        felt &= ~self.obstacle
        self.felt |= felt
        self.obstacle |= felt

    def forget_looks(self) -> None:
        """Forget where the robot has been close to things and looked at them, so that it does so again, and closer."""
        self.been_close[:] = False
        self.looked_from[:] = 0
        self._looks = self.config.closer_looks

    def forget_explored(self) -> None:
        """Forget where anything was seen, so that the robot goes everywhere again; what was seen there stays known."""
        self.explored[:] = False

    def forget_probability(self, role: ClassRole) -> None:
        """Forget how probable the class is wherever it was seen; that it was seen stays known."""
        self._class_probability[role] = 0.0

    def forget_thing(self, role: ClassRole, x: float, y: float, radius: float = 1.0) -> None:
        """Forget that a class was seen in the cells that lie together around a point (m, start frame)."""
        cells = self._class_cells[role]
        near = disc_mask(self.shape, self.to_cell(x, y), round(radius / self.cell_size))
        _, labels = cv2.connectedComponents(cells.view(np.uint8), connectivity=8)
        thing = cells & np.isin(labels, labels[cells & near])
        cells[thing] = False
        self._class_probability[role][thing] = 0.0

    def clear_collisions(self) -> None:
        """Forget every collision cell."""
        self.collision[:] = False

    def clear_felt(self) -> None:
        """Forget every obstacle that was only felt."""
        self.obstacle &= ~self.felt
        self.felt[:] = False

    def _mark(self, channel: Mask, points: NDArray[np.floating]) -> None:
        for x, y in points:
            row, column = self.to_cell(x, y)
            if 0 <= row < self.shape[0] and 0 <= column < self.shape[1]:
                channel[row, column] = True

    def _channels(self) -> Channels:
        return Channels(self.obstacle, self.explored, self._class_cells, self._class_probability, self._class_height)

    def _mark_robot(self, base: BasePose) -> None:
        cell = self.to_cell(base.x, base.y)
        last = self._last_base or base
        start = self.to_cell(last.x, last.y)
        self.config.mark_visited(self.visited, start, cell)
        self._last_base = base
        for channel, radius in (
            (self.been_close, self.config.been_close_radius),
            (self.explored, self.config.explored_radius),
        ):
            cv2.circle(channel.view(np.uint8), cell[::-1], round(radius / self.cell_size), color=1, thickness=-1)
        own = round(self.config.explored_radius / self.cell_size)
        self._know((cell[0] - own, cell[1] - own), (cell[0] + own, cell[1] + own))

    def _know(self, first: Cell, last: Cell) -> None:
        """Widen the known part to hold a first and a last cell."""
        low, high = self._known
        self._known = (
            (min(low[0], first[0]), min(low[1], first[1])),
            (max(high[0], last[0] + 1), max(high[1], last[1] + 1)),
        )

    def mark_faced(self, base: BasePose) -> None:
        """Note that the start receptacles just before the robot were looked at from where it stands.

        What it has not seen of them from there, it will not see from there.
        """
        nothing: Pixels = partial(np.zeros, (0, 3))
        self._mark_look(Gaze(base.x, base.y, base.heading, range=FACED_RANGE), look_bits, nothing)

    def _mark_look(self, gaze: Gaze, looks: LookBits, pixels: Pixels) -> None:
        """Note from which side the start receptacles ahead are looked at; see `LookBits`."""
        reach = round(gaze.range / self.cell_size)
        row, column = self.to_cell(gaze.x, gaze.y)
        near = slice(max(0, row - reach), row + reach + 1), slice(max(0, column - reach), column + reach + 1)
        corner = np.array([near[0].start, near[1].start])
        cells = corner + np.argwhere(self._class_cells[ClassRole.START_RECEPTACLE][near])
        self.looked_from[cells[:, 0], cells[:, 1]] |= looks(self.to_points(cells), gaze, pixels)

    def _cover(self, base: BasePose) -> None:
        """Grow until everything in reach of the robot lies on the map."""
        reach = round(self.config.reach / self.cell_size)
        row, column = self.to_cell(base.x, base.y)
        rows, columns = self.shape
        low = self._growth(reach - row), self._growth(reach - column)
        high = self._growth(row + reach + 1 - rows), self._growth(column + reach + 1 - columns)
        if any((*low, *high)):
            self._grow(low, high)

    def _growth(self, missing: int) -> int:
        """Return how many rows or columns to add where some are missing."""
        block = round(self.config.growth / self.cell_size)
        return block * math.ceil(max(0, missing) / block)

    def _grow(self, low: Cell, high: Cell) -> None:
        """Add so many rows and columns before the first and after the last."""
        rows, columns = self.shape
        shape = rows + low[0] + high[0], columns + low[1] + high[1]
        self.obstacle, self.explored, self.visited, self.been_close, self.collision, self.felt = (
            enlarged(channel, low, shape)
            for channel in (self.obstacle, self.explored, self.visited, self.been_close, self.collision, self.felt)
        )
        self.looked_from = enlarged(self.looked_from, low, shape)
        self._class_cells = enlarged(self._class_cells, low, shape)
        self._class_probability = enlarged(self._class_probability, low, shape)
        self._class_height = enlarged(self._class_height, low, shape)
        first, past = self._known
        self._known = ((first[0] + low[0], first[1] + low[1]), (past[0] + low[0], past[1] + low[1]))
        self.origin = (self.origin[0] - low[1] * self.cell_size, self.origin[1] - low[0] * self.cell_size)
