"""What a planner makes of a goal."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import Action


@dataclass(frozen=True)
class Plan:
    """What the planner makes of a goal. Points are in the start frame (m).

    Attributes:
        action: what to do next; None when the goal is reached (or nothing can be done).
        reached: the robot stands as near as it can or as was asked for, and faces the goal.
        reachable: whether a path leads as near to the goal as was asked for; else the plan leads to the nearest place.
        is_daring: whether the path leads through collision cells, or nearer to obstacles than it should.
        distance: length of the path (m).
        short_term_goal: (x, y) the robot heads for now, or None when it has arrived.
        path: (P, 2) from the robot to where it will stand.
        goal_points: (K, 2) the goal's cells; K may be 0.
        has_place: whether anywhere near enough to the goal is free, be there a path or not.
    """

    action: Action | None
    reached: bool
    reachable: bool
    is_daring: bool
    distance: float
    short_term_goal: tuple[float, float] | None
    path: NDArray[np.float64]
    goal_points: NDArray[np.float64]
    has_place: bool = True
