"""What was true in Rerun, in the frame in which the robot believed to be: the base, and where what counts lay."""

from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.recording.recording import Recording
from uniteam.geometry import transform_points
from uniteam.visualization.colors import GOAL_RECEPTACLE, OBJECT, SUCCESS
from uniteam.visualization.rerun_file import paths


class TruthLayer:
    """Logs the truth, moment by moment."""

    def __init__(self, rerun: ModuleType, stream: Any, recording: Recording) -> None:
        """Log the receptacles that would do, which stay where they are."""
        self._rerun, self._stream, self._recording = rerun, stream, recording
        base, believed = recording.base_to_world(0), recording.base_to_start(0)
        self._world_to_start = believed.matrix() @ np.linalg.inv(base.matrix())
        self._names = [candidate.name for candidate in recording.episode.objects]
        self._lay: NDArray[np.float64] | None = None
        instances = {instance.name: instance.position for instance in recording.home.instances}
        goals = [goal.name for goal in recording.episode.goal_receptacles if goal.name in instances]
        places = self._seen(np.array([instances[name] for name in goals]))
        self._stream.log(paths.TRUE_GOALS, self._points(places, goals, GOAL_RECEPTACLE, 0.1), static=True)

    def log(self, moment: int) -> None:
        """Log where the base was, and the objects where one of them lies elsewhere than before."""
        base = self._recording.base_to_world(moment)
        self._stream.log(
            paths.TRUE_BASE, self._points(self._seen(np.array([[base.x, base.y, 0.0]])), [], SUCCESS, 0.05)
        )
        poses = self._recording.objects.at(moment)
        lie = self._seen(np.array([poses[name][:3, 3] for name in self._names]))
        if self._lay is None or not np.array_equal(lie, self._lay):
            self._stream.log(paths.TRUE_OBJECTS, self._points(lie, self._names, OBJECT, 0.06))
        self._lay = lie

    def _seen(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        return transform_points(self._world_to_start, points.reshape(-1, 3))

    def _points(self, points: NDArray[np.float64], names: list[str], color: tuple[int, int, int], radius: float) -> Any:
        return self._rerun.Points3D(points, labels=names, colors=[color], radii=[radius])
