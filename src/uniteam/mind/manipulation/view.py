"""What a skill sees: one observation with what is believed of it, as points around the robot."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import invert_transform
from uniteam.interface import Instruction, Observation, Segmentation
from uniteam.mind.perception.vocabulary import ClassRole, roles_of

Points = NDArray[np.float32]
"""(N, 3), m."""


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
        return points @ camera_to_base[:3, :3].T.astype(np.float32) + camera_to_base[:3, 3].astype(np.float32)

    @cached_property
    def returned(self) -> NDArray[np.bool_]:
        """(H, W): where the depth camera measured something."""
        return self.observation.depth > 0

    def mask(self, role: ClassRole) -> NDArray[np.bool_]:
        """Return (H, W): the pixels of every detection that plays a role."""
        detections = self.segmentation.detections
        plays = [role in roles_of(detection, self.instruction) for detection in detections]
        return np.array([*plays, False])[self.segmentation.instances]

    def points(self, role: ClassRole) -> Points:
        """Return the (N, 3) points (m, base frame) of every detection that plays a role."""
        return self.cloud[self.mask(role) & self.returned]

    def nearest(self, role: ClassRole, point: NDArray[np.floating]) -> Points:
        """Return the points (m, base frame) of that detection of a role whose middle is nearest to `point`; or none."""
        best, shortest = np.zeros((0, 3), dtype=np.float32), float(np.inf)
        for index, detection in enumerate(self.segmentation.detections):
            if role in roles_of(detection, self.instruction):
                points = self.cloud[(self.segmentation.instances == index) & self.returned]
                distance = float(np.linalg.norm(points.mean(axis=0) - point)) if len(points) else np.inf
                if distance < shortest:
                    best, shortest = points, distance
        return best

    def surroundings(self) -> Points:
        """Return the (N, 3) points (m, base frame) of everything that is seen, but what the gripper holds."""
        return self.cloud[self.returned & ~self.mask(ClassRole.OBJECT)]
