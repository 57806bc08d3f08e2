"""Where the objects are: the pose of each at first, and again whenever it has changed."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Poses = NDArray[np.float64]


class PoseWriter:
    """Takes the poses of all objects in, moment by moment, and keeps those that are new."""

    def __init__(self) -> None:
        """Begin before the first moment."""
        self._before: Poses | None = None
        self._moments: list[NDArray[np.int32]] = []
        self._objects: list[NDArray[np.int32]] = []
        self._poses: list[Poses] = []
        self._count = 0

    def add(self, poses: Poses) -> None:
        """Take in the (N, 4, 4) poses (world) at the next moment."""
        is_new = np.ones(len(poses), bool) if self._before is None else (poses != self._before).any(axis=(1, 2))
        changed = np.flatnonzero(is_new).astype(np.int32)
        self._moments.append(np.full(len(changed), self._count, np.int32))
        self._objects.append(changed)
        self._poses.append(poses[changed])
        self._before = poses
        self._count += 1

    def arrays(self) -> dict[str, NDArray[np.generic]]:
        """Return the moments (K,), the objects' indices (K,) and the poses (K, 4, 4) of what changed, in that order."""
        return {
            "object_moments": np.concatenate([np.zeros(0, np.int32), *self._moments]),
            "object_indices": np.concatenate([np.zeros(0, np.int32), *self._objects]),
            "object_poses": np.concatenate([np.zeros((0, 4, 4)), *self._poses]),
        }


class PoseTrack:
    """Where the objects were at every moment."""

    def __init__(
        self, names: Sequence[str], moments: NDArray[np.int32], indices: NDArray[np.int32], poses: Poses
    ) -> None:
        """Take the objects' names and the arrays of `PoseWriter`; raises ValueError where they do not fit together."""
        if not len(moments) == len(indices) == len(poses) or poses.shape[1:] != (4, 4):
            raise ValueError("the arrays of the objects' poses are of different lengths")
        if len(indices) and not 0 <= indices.min() <= indices.max() < len(names):
            raise ValueError("a pose is of no object")
        self.names = tuple(names)
        self._moments, self._indices, self._poses = moments, indices, poses

    def at(self, moment: int) -> dict[str, Poses]:
        """Return the (4, 4) pose (world) of every object at a moment, by its name."""
        return dict(zip(self.names, self.all_at(moment), strict=True))

    def all_at(self, moment: int) -> Poses:
        """Return the (N, 4, 4) poses (world) at a moment in the order of `names`."""
        count = self.changes_until(moment)
        poses = np.tile(np.eye(4), (len(self.names), 1, 1))
        poses[self._indices[:count]] = self._poses[:count]  # of several of one object the last stays
        return poses

    def changes_until(self, moment: int) -> int:
        """Return how many poses were new up to a moment: between two with the same count nothing has moved."""
        return int(np.searchsorted(self._moments, moment, side="right"))

    def of(self, name: str) -> list[tuple[int, Poses]]:
        """Return the moments at which an object came to another pose, and that (4, 4) pose (world); the first is 0."""
        index = self.names.index(name)
        own = np.flatnonzero(self._indices == index)
        return [(int(self._moments[k]), self._poses[k]) for k in own]
