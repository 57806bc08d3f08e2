"""Measuring the tags of an episode that was certified."""

import math
from itertools import pairwise

import numpy as np

from uniteam.geometry import BasePose, Point2
from uniteam.world.oracle.true_paths import PathField
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.episode import Candidate, Certificate, Episode
from uniteam.world.task.tags import Tags

_MOST_VIEWS = 8
_STEP = 0.02
"""How far apart (m) the clearance is measured on a way."""


def measure_tags(episode: Episode, certificate: Certificate, simulator: Simulator, style: str) -> Tags:
    """Return the tags of an episode that was solved as its certificate says, with its home's simulator."""
    home = simulator.home
    grasped = next(candidate for candidate in episode.objects if candidate.name == certificate.object)
    pixels = _best_view(grasped, simulator)
    simulator.reset(episode.start)
    ways = [_way(simulator, *ends) for ends in pairwise((episode.start, certificate.grasp, certificate.release))]
    of_class = home.of_category(episode.instruction.object_category)
    return Tags(
        style=style,
        area=round(sum(room.area for room in home.stage.rooms), 1),
        rooms=len(home.stage.rooms),
        shortest_path=round(sum(math.dist(a, b) for way in ways for a, b in pairwise(way)), 2),
        least_clearance=round(min(_least_clearance(way, simulator) for way in ways), 3),
        object_height=round(home.by_name[certificate.object].position[2], 3),
        object_pixels=pixels,
        goals=len(episode.goal_receptacles),
        same_class=len(of_class) - len(episode.objects),
    )


def _way(simulator: Simulator, start: BasePose, end: BasePose) -> list[Point2]:
    field = PathField(simulator.floor, (end.x, end.y))
    return [(start.x, start.y), *field.path_from(start.x, start.y)]


def _least_clearance(way: list[Point2], simulator: Simulator) -> float:
    points = [way[0]]
    for a, b in pairwise(way):
        points += [(float(x), float(y)) for x, y in np.linspace(a, b, 2 + int(math.dist(a, b) / _STEP))]
    return min(simulator.floor.clearance(*point) for point in points)


def _best_view(target: Candidate, simulator: Simulator) -> int:
    """Return the most pixels of an object that are seen when the robot faces it from one of its view points."""
    home = simulator.home
    index = home.instances.index(home.by_name[target.name])
    x, y, _ = home.by_name[target.name].position
    points = sorted(target.view_points, key=lambda point: math.dist(point, (x, y)))
    chosen = np.unique(np.linspace(0, len(points) - 1, _MOST_VIEWS).round().astype(int))
    counts = []
    for px, py in (points[i] for i in chosen):
        simulator.reset(BasePose(px, py, math.atan2(y - py, x - px)))
        counts.append(int(np.count_nonzero(simulator.render().instances == index)))
    return max(counts)
