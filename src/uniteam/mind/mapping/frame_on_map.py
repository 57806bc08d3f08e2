"""What a frame brings to the map: observation and segmentation as the kernels take them."""

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import Point2, pixels_of, transform_points
from uniteam.interface import Observation, Segmentation
from uniteam.mind.mapping.projection import ROLE_COUNT, MappedFrame
from uniteam.mind.perception.vocabulary import ClassRole, RoleScores


def frame_on_map(
    observation: Observation, segmentation: Segmentation, roles: RoleScores, origin: Point2
) -> MappedFrame:
    """Return a frame on a map whose cell [0, 0] has its corner at `origin` (m, start frame)."""
    camera = observation.camera
    camera_to_grid = np.array(observation.camera_to_start[:3], dtype=np.float64)
    camera_to_grid[:2, 3] -= origin
    base = observation.base_to_start
    scores = np.zeros((max(1, len(segmentation.detections)), ROLE_COUNT), dtype=np.float32)
    for index, detection in enumerate(segmentation.detections):
        scores[index] = roles(detection)
    return MappedFrame(
        np.ascontiguousarray(observation.depth, dtype=np.float32),
        np.ascontiguousarray(segmentation.instances, dtype=np.int16),
        scores,
        np.array([camera.fx, camera.fy, camera.cx, camera.cy], dtype=np.float32),
        camera_to_grid.astype(np.float32),
        np.array([base.x - origin[0], base.y - origin[1]], dtype=np.float32),
    )


def receptacle_pixels(
    observation: Observation, segmentation: Segmentation, scores: NDArray[np.float32]
) -> NDArray[np.float64]:
    """Return the (N, 3) pixels of start receptacles: x, y (m, start frame) and the resolution there (m a pixel)."""
    camera, is_start = observation.camera, np.append(scores[:, ClassRole.START_RECEPTACLE] > 0, False)
    rows, columns = pixels_of(is_start.take(segmentation.instances, mode="wrap") & (observation.depth > 0))
    depth = observation.depth[rows, columns].astype(np.float64)
    points = transform_points(observation.camera_to_start, camera.unproject_pixels(rows, columns, depth))
    return np.column_stack([points[:, :2], depth / camera.fx])
