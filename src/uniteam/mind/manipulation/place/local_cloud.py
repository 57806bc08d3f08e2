"""What was seen around the robot while it closed in: the points of several views, together."""

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose, grain_keys, invert_transform, transform_points
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.view import Points, View
from uniteam.stretch import BASE_RADIUS

_RADIUS = 2.0
"""m around the base; what is farther is of no concern to the arm."""
_GRAIN = 0.02
"""m; of points closer together than this, one is kept."""
_OWN_RADIUS = BASE_RADIUS + 0.02
"""m around the base's axis; what is seen there is the robot itself, give or take a grain."""
_NO_KEY = np.iinfo(np.int64).max


class LocalCloud:
    """The goal receptacle and everything else near the robot, in the start frame, over all views that were added."""

    def __init__(self) -> None:
        """Begin with nothing seen."""
        self._goal, self._others, self._surroundings = _Grains(), _Grains(), _Grains()

    def add(self, view: View, goal: Points) -> None:
        """Add what a view shows; the arm must be retracted in it, or it is taken for furniture.

        Args:
            view: what is seen.
            goal: (N, 3) points (m, base frame) of it that are the goal receptacle's.
        """
        pose = view.observation.base_to_start
        self._goal.add(_to_start(_around(goal), pose))
        self._others.add(_to_start(_around(view.surroundings_but(ClassRole.GOAL_RECEPTACLE)), pose))
        self._surroundings.add(_to_start(_around(view.surroundings()), pose))

    def goal_points(self, pose: BasePose) -> Points:
        """Return the (N, 3) points seen of goal receptacles, in the frame of a base that stands at `pose` (m)."""
        return _to_base(self._goal.points, pose)

    def others(self, pose: BasePose) -> Points:
        """Return the (N, 3) points seen of anything else, in the frame of a base that stands at `pose` (m)."""
        return _to_base(self._others.points, pose)

    def surroundings(self, pose: BasePose) -> Points:
        """Return the (N, 3) points seen of anything, in the frame of a base that stands at `pose` (m)."""
        return _to_base(self._surroundings.points, pose)


def _around(points: Points) -> Points:
    distance = np.hypot(points[:, 0], points[:, 1])
    return points[(distance < _RADIUS) & (distance > _OWN_RADIUS)]


def _to_start(points: Points, pose: BasePose) -> NDArray[np.float64]:
    return transform_points(pose.matrix(), points)


def _to_base(points: NDArray[np.float64], pose: BasePose) -> Points:
    return transform_points(invert_transform(pose.matrix()), points).astype(np.float32)


class _Grains:
    """Points, (N, 3) m, one of each grain of space: the first that was added."""

    def __init__(self) -> None:
        """Begin with none."""
        self.points: NDArray[np.float64] = np.zeros((0, 3))
        self._keys: NDArray[np.int64] = np.zeros(0, dtype=np.int64)

    def add(self, points: NDArray[np.float64]) -> None:
        """Add those of (M, 3) points in whose grains there is none yet, in their order."""
        keys, first = np.unique(grain_keys(points, _GRAIN), return_index=True)
        place = np.searchsorted(self._keys, keys)
        is_known = np.append(self._keys, _NO_KEY)[place] == keys
        self.points = np.concatenate([self.points, points[np.sort(first[~is_known])]])
        self._keys = np.insert(self._keys, place[~is_known], keys[~is_known])
