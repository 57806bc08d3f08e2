"""What a skill sees: one observation with what is believed of it, as points around the robot."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import invert_transform
from uniteam.interface import Instruction, Observation, Segmentation
from uniteam.mind.perception.vocabulary import ClassRole, roles_of
from uniteam.stretch import gripper_to_base

Points = NDArray[np.float32]
"""(N, 3), m."""

HELD_WITHIN = 0.15
"""m; what comes so near to the grasp centre of a gripper that holds something is what it holds."""


@dataclass(frozen=True)
class View:
    """One observation, what is believed to be in it, and what the robot was asked."""

    observation: Observation
    segmentation: Segmentation
    instruction: Instruction

    @cached_property
    def cloud(self) -> NDArray[np.float32]:
        """(H, W, 3) points (m, base frame) of every pixel; only those of `returned` mean anything."""
        observation = self.observation
        camera_to_base = invert_transform(observation.base_to_start.matrix()) @ observation.camera_to_start
        points = observation.camera.unproject(observation.depth)
        turned = points @ camera_to_base[:3, :3].T.astype(np.float32)
        # A row at a time, for numpy adds three numbers at a time much more slowly.
        rows = turned.reshape(len(turned), -1)
        rows += np.tile(camera_to_base[:3, 3].astype(np.float32), turned.shape[1])
        return turned

    @cached_property
    def returned(self) -> NDArray[np.bool_]:
        """(H, W): where the depth camera measured something."""
        return self.observation.depth > 0

    def mask(self, role: ClassRole) -> NDArray[np.bool_]:
        """Return (H, W): the pixels of every detection that plays a role."""
        detections = self.segmentation.detections
        plays = [role in roles_of(detection, self.instruction) for detection in detections]
        return np.array([*plays, False]).take(self.segmentation.instances, mode="wrap")

    def points(self, role: ClassRole) -> Points:
        """Return the (N, 3) points (m, base frame) of every detection that plays a role."""
        return self.cloud[self.mask(role) & self.returned]

    def nearest(self, role: ClassRole, point: NDArray[np.floating]) -> Points:
        """Return the points (m, base frame) of that detection of a role whose middle is nearest to `point`; or none."""
        index = self._nearest_index(role, point)
        return self.cloud[(self.segmentation.instances == index) & self.returned & (index >= 0)]

    def surroundings(self) -> Points:
        """Return the (N, 3) points (m, base frame) of everything seen, but the object in the gripper or soon to be."""
        own = self._own_object()
        return self.cloud[self.returned & ~((self.segmentation.instances == own) & (own >= 0))]

    def surroundings_but(self, role: ClassRole) -> Points:
        """Return the surroundings' (N, 3) points (m, base frame) that no detection of a role shows."""
        own = self._own_object()
        is_own = (self.segmentation.instances == own) & (own >= 0)
        return self.cloud[self.returned & ~is_own & ~self.mask(role)]

    def _own_object(self) -> int:
        """Return the index of the detection that the gripper holds or, empty, is nearest to; -1 where there is none."""
        grasp_centre = gripper_to_base(self.observation.joints)[:3, 3]
        index = self._nearest_index(ClassRole.OBJECT, grasp_centre)
        if index < 0 or not self.observation.is_holding:
            return index
        points = self.cloud[(self.segmentation.instances == index) & self.returned]
        return index if np.linalg.norm(points - grasp_centre, axis=1).min() < HELD_WITHIN else -1

    def _nearest_index(self, role: ClassRole, point: NDArray[np.floating]) -> int:
        best, shortest = -1, float(np.inf)
        for index, detection in enumerate(self.segmentation.detections):
            if role in roles_of(detection, self.instruction):
                points = self.cloud[(self.segmentation.instances == index) & self.returned]
                distance = float(np.linalg.norm(points.mean(axis=0) - point)) if len(points) else np.inf
                if distance < shortest:
                    best, shortest = index, distance
        return best
