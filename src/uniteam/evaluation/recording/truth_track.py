"""What was true at each moment: before the first step, and after every one."""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.evaluation.recording.pose_track import PoseWriter
from uniteam.world.task.environment import Environment


class TruthTrack:
    """Looks at an environment, whose agent is not told of it."""

    def __init__(self, environment: Environment) -> None:
        """Take the environment; `look` takes the first moment in."""
        self._simulator = environment.simulator
        self._instance_count = len(environment.home.instances)
        self._index = {name: k for k, name in enumerate(self._simulator.physics.names)}
        self._poses = PoseWriter()
        self._bases: list[tuple[float, float, float]] = []
        self._joints: list[tuple[float, ...]] = []
        self._pixels: list[NDArray[np.int32]] = []
        self._version, self._lying = self._simulator.physics.version, self._simulator.physics.poses()
        self._released: str | None = None
        self._resting: tuple[str, ...] | None = None
        self._looked_at = -1

    def look(self) -> None:
        """Take the present moment in."""
        simulator = self._simulator
        base = simulator.base
        self._bases.append((base.x, base.y, base.heading))
        self._joints.append(tuple(vars(simulator.joints).values()))
        self._pixels.append(pixels_of_each(simulator.render().instances, self._instance_count))
        self._poses.add(self._object_poses())

    def _object_poses(self) -> NDArray[np.float64]:
        """Return the (N, 4, 4) poses (world), of what the gripper holds too."""
        simulator, physics = self._simulator, self._simulator.physics
        if physics.version != self._version:
            self._version, self._lying = physics.version, physics.poses()
        if simulator.held is None:
            return self._lying
        poses = self._lying.copy()
        poses[self._index[simulator.held]] = simulator.object_pose(simulator.held)
        return poses

    def resting_on(self, released: str | None) -> tuple[str, ...] | None:
        """Return what that touches which was let go of last, once it lies still; `released` was so in this step."""
        self._released = released or self._released
        if self._released is None or self._simulator.held is not None:
            return None
        physics = self._simulator.physics
        if physics.version != self._looked_at:
            self._looked_at = physics.version
            self._resting = (
                tuple(sorted(physics.touching(self._released))) if physics.is_still(self._released) else None
            )
        return self._resting

    def arrays(self) -> dict[str, NDArray[np.generic]]:
        """Return the arrays, one row a moment, of which there is one more than there are steps.

        They are `base_to_world` (M, 3): x, y (m), heading (rad); `joints` (M, 7); `visible_pixels` (M, N), how many
        pixels of the head camera show each of the home's N instances; and those of `PoseWriter`.
        """
        return {
            "base_to_world": np.array(self._bases, np.float64),
            "joints": np.array(self._joints, np.float64),
            "visible_pixels": np.array(self._pixels, np.int32),
            **self._poses.arrays(),
        }


@njit(cache=True, nogil=True)
def pixels_of_each(instances: NDArray[np.int16], count: int) -> NDArray[np.int32]:
    """Return how many pixels of an (H, W) image show each of `count` instances, (count,); -1 is none of them."""
    pixels = np.zeros(count, np.int32)
    for instance in instances.flat:
        if instance >= 0:
            pixels[instance] += 1
    return pixels
