"""The map and the plan as a picture of labels, for videos and reports."""

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.grid import Mask
from uniteam.interface import MapLabel, MapOverlay
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.planning.plan import Plan
from uniteam.mind.navigation.window import Window, window_around
from uniteam.mind.perception.vocabulary import ClassRole

_NO_POINTS: NDArray[np.float64] = np.zeros((0, 2))


def draw_overlay(
    bird_map: BirdsEyeMap, base: BasePose, goal: Goal | None = None, plan: Plan | None = None
) -> MapOverlay:
    """Return the known part of the map, with the goal and the path of a plan made from it in this step."""
    window = window_around(bird_map, base)
    labels = np.full((window.high[0] - window.low[0], window.high[1] - window.low[1]), MapLabel.UNKNOWN, dtype=np.uint8)
    for label, channel in _layers(bird_map, goal):
        np.maximum(labels, window.cut(channel).view(np.uint8) * np.uint8(label), out=labels)  # later labels are larger
    return MapOverlay(
        labels,
        _corner(bird_map, window),
        bird_map.cell_size,
        plan.goal_points if plan else _NO_POINTS,
        plan.short_term_goal if plan else None,
        plan.path if plan else _NO_POINTS,
    )


def _layers(bird_map: BirdsEyeMap, goal: Goal | None) -> tuple[tuple[MapLabel, Mask], ...]:
    """Return the labels and their cells, the lowest first."""
    frontier = ((MapLabel.FRONTIER, goal.cells),) if goal is not None and goal.kind is GoalKind.FRONTIER else ()
    return (
        (MapLabel.FREE, bird_map.explored),
        (MapLabel.VISITED, bird_map.visited),
        (MapLabel.OBSTACLE, bird_map.obstacle),
        (MapLabel.COLLISION, bird_map.collision),
        *frontier,
        (MapLabel.START_RECEPTACLE, bird_map.class_cells(ClassRole.START_RECEPTACLE)),
        (MapLabel.GOAL_RECEPTACLE, bird_map.class_cells(ClassRole.GOAL_RECEPTACLE)),
        (MapLabel.OBJECT, bird_map.class_cells(ClassRole.OBJECT)),
    )


def _corner(bird_map: BirdsEyeMap, window: Window) -> tuple[float, float]:
    """Return the (x, y) in the start frame (m) of the window's first corner."""
    x, y = bird_map.to_point(*window.low)
    return x - bird_map.cell_size / 2, y - bird_map.cell_size / 2
