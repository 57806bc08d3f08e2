"""What the robot knew of itself at each moment."""

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.recording.checksums import Checksums, checksums_of
from uniteam.interface import Observation


class RobotTrack:
    """Takes observations in and keeps all of them but the images, of which it keeps the checksums."""

    def __init__(self) -> None:
        """Begin without a step."""
        self._poses: list[tuple[float, float, float]] = []
        self._joints: list[tuple[float, ...]] = []
        self._cameras: list[NDArray[np.float64]] = []
        self._is_holding: list[bool] = []
        self._checksums: list[Checksums] = []

    def add(self, seen: Observation) -> None:
        """Take an observation in."""
        base = seen.base_to_start
        self._poses.append((base.x, base.y, base.heading))
        self._joints.append(tuple(vars(seen.joints).values()))
        self._cameras.append(seen.camera_to_start)
        self._is_holding.append(seen.is_holding)
        self._checksums.append(checksums_of(seen))

    def arrays(self) -> dict[str, NDArray[np.generic]]:
        """Return the arrays, one row a moment; none where no step was taken.

        They are `base_to_start` (T, 3): x, y (m), heading (rad), as the robot believed; `joints` (T, 7) in the order of
        `Joints`; `camera_to_start` (T, 4, 4); `is_holding` (T,); and `checksums` (T, 3) of `checksums_of`.
        """
        return {
            "base_to_start": np.array(self._poses, np.float64).reshape(-1, 3),
            "joints": np.array(self._joints, np.float64).reshape(-1, 7),
            "camera_to_start": np.array(self._cameras, np.float64).reshape(-1, 4, 4),
            "is_holding": np.array(self._is_holding, np.bool_),
            "checksums": np.array(self._checksums, np.uint32).reshape(-1, 3),
        }
