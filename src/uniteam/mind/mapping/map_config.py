"""How frames become the cells of the bird's-eye-view map."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from uniteam.grid import Cell, Mask
from uniteam.mind.mapping.block_projection import averaged_blocks
from uniteam.mind.mapping.clearing import Clear, never_clear
from uniteam.mind.mapping.fine_obstacles import FineObstacles, nothing_finer
from uniteam.mind.mapping.projection import Box, Channels, Limits, MappedFrame
from uniteam.mind.mapping.viewed_sides import LookBits, look_bits
from uniteam.mind.mapping.visited import mark_stand
from uniteam.stretch import BASE_RADIUS, ROBOT_HEIGHT

_REFERENCE_PIXELS = 240 * 320
OFF_AXIS = 1.15
"""A pixel at the corner of the picture is so much farther away over the floor than its depth along the optical axis."""

Project = Callable[[MappedFrame, Limits, Channels], Box]
"""Writes a frame into the map's cells; returns the part of the map that may have changed."""


@dataclass(frozen=True)
class MapConfig:
    """How frames become cells; the defaults are those that HomeRobot ships for this task.

    Attributes:
        cell_size: m.
        initial_size: side of the square map at the start (m).
        growth: where more is needed, the map grows by so much, or a multiple of it (m).
        min_depth, max_depth: depth along the optical axis that is mapped (m).
        min_obstacle_height, max_obstacle_height: what lies between blocks the robot (m above the floor).
        been_close_radius: the disc around the robot that it has been close to (m).
        explored_radius: the disc around the robot that counts as explored, which its camera cannot see (m).
        own_radius: points nearer than this to the base's axis are the robot itself (m).
        project: what writes frames into the map's cells.
        mark_visited: marks where the robot has been between the cells of two steps.
        min_solid_points, min_class_points: how many points of one frame make a cell an obstacle or one of a class, in a
            frame of 240 x 320 pixels; they grow with the number of pixels. Where `exact_labels` counts pixels.
        probability_gain: how far the running probability of a class moves to the score of a new sighting.
        probability_decay: the share it loses when the cell is seen again without the class.
        class_depths: up to which depth each `ClassRole` is mapped (m). HomeRobot maps all to `max_depth`, and keeps
            them; `far_sight` keeps goal receptacles from as far as depth is measured.
        clear: what takes cells back.
        fine_obstacles: what is known of obstacles at a finer grain.
        looks: from which sides the start receptacles have been looked at.
        closer_looks: the same, once all looks were forgotten because they showed nothing.
    """

    project: Callable[[], Project] = averaged_blocks
    mark_visited: Callable[[Mask, Cell, Cell], None] = mark_stand
    cell_size: float = 0.05
    initial_size: float = 24.0
    growth: float = 8.0
    min_depth: float = 0.5
    max_depth: float = 3.5
    min_obstacle_height: float = 0.10
    max_obstacle_height: float = ROBOT_HEIGHT
    been_close_radius: float = 1.0
    explored_radius: float = 0.5
    own_radius: float = BASE_RADIUS
    min_solid_points: int = 3
    min_class_points: int = 2
    probability_gain: float = 0.3
    probability_decay: float = 0.05
    class_depths: tuple[float, float, float] = (3.5, 3.5, 3.5)
    looks: LookBits = look_bits
    closer_looks: LookBits = look_bits
    clear: Callable[[], Clear] = never_clear
    fine_obstacles: Callable[[], FineObstacles] = nothing_finer

    def limits(self, pixels: int) -> Limits:
        """Return the kernel's limits for frames of so many pixels."""
        scale = pixels / _REFERENCE_PIXELS
        return Limits(
            1.0 / self.cell_size,
            self.min_depth,
            self.max_depth,
            np.array(self.class_depths, dtype=np.float32),
            self.min_obstacle_height,
            self.max_obstacle_height,
            self.own_radius,
            max(1, round(self.min_solid_points * scale)),
            max(1, round(self.min_class_points * scale)),
            self.probability_gain,
            self.probability_decay,
        )

    @property
    def reach(self) -> float:
        """How far from the robot a frame may write (m)."""
        return OFF_AXIS * max(self.max_depth, self.max_obstacle_height, *self.class_depths)
