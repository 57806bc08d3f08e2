"""Where an episode of a skill begins, after HomeRobot: away from the goal, or before it; with or without the object."""

import math

import numpy as np

from uniteam.adapters.gymnasium.open_home import OpenHome
from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose, wrap_angle
from uniteam.interface import DiscreteAction
from uniteam.world.simulation.graspable import GraspRule
from uniteam.world.task.episode import Candidate, Episode

LEAST_WAY = 3.0
"""From the start of a navigation to the nearest view point of its goals (m)."""
HEADING_NOISE = math.radians(15.0)
"""Standard deviation of the heading at a view point about facing what is seen from there (rad)."""

_NEARLY_FARTHEST = 0.9


def start_away(place: OpenHome, goals: tuple[Candidate, ...], generator: np.random.Generator) -> None:
    """Put the robot on a random free point at least 3 m of way from the view points of all goals, heading anywhere.

    In a home without such a point it is one of the farthest.
    """
    floor = place.simulator.floor
    ways = np.minimum.reduce([place.distances(goal) for goal in goals])
    ways = np.where(floor.largest_component & np.isfinite(ways), ways, 0.0)
    cells = np.flatnonzero(ways >= min(LEAST_WAY, _NEARLY_FARTHEST * float(ways.max())))
    row, column = np.unravel_index(cells[generator.integers(len(cells))], ways.shape)
    heading = float(generator.uniform(-math.pi, math.pi))
    _stand(place, BasePose(*floor.to_point(int(row), int(column)), heading))


def start_before(place: OpenHome, goals: tuple[Candidate, ...], generator: np.random.Generator) -> None:
    """Put the robot at a random view point of a random goal, facing it but for a normal error of 15 degrees."""
    goal = goals[generator.integers(len(goals))]
    x, y = goal.view_points[generator.integers(len(goal.view_points))]
    to_x, to_y = place.middle(goal.name)
    heading = math.atan2(to_y - y, to_x - x) + float(generator.normal(0.0, HEADING_NOISE))
    _stand(place, BasePose(x, y, wrap_angle(heading)))


def take_object(place: OpenHome, episode: Episode, generator: np.random.Generator) -> str:
    """Put a random object that counts into the gripper, from wherever it lies, and return its name."""
    name = episode.objects[generator.integers(len(episode.objects))].name
    place.simulator.reset(episode.start)
    place.simulator.apply(DiscreteAction.SNAP_OBJECT, GraspRule(lambda things: name))
    return name


def reachable(candidates: tuple[Candidate, ...], what: str) -> tuple[Candidate, ...]:
    """Return the candidates that have view points; raises InvalidInputError where none has."""
    seen = tuple(candidate for candidate in candidates if candidate.view_points)
    if not seen:
        raise InvalidInputError(f"no {what} of the episode has view points; generate episodes with 'uniteam episodes'")
    return seen


def _stand(place: OpenHome, base: BasePose) -> None:
    """Move the base (world), whatever the gripper holds."""
    place.simulator.return_to(place.simulator.moment(), base)
