"""A world of boxes on a floor, seen by ray casting: observations for the mind's tests without the world's code."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Detection, DiscreteAction, Joints, Observation, Segmentation

CAMERA = PinholeCamera.from_horizontal_fov(240, 320, math.radians(42.0))
CAMERA_HEIGHT = 1.31
TILT = math.radians(-30.0)
RADIUS = 0.3


@dataclass(frozen=True)
class Box:
    """An axis-aligned box (m, start frame); a name makes it a detection with a score."""

    low: tuple[float, float, float]
    high: tuple[float, float, float]
    name: str | None = None
    score: float = 1.0


def room(x0: float, y0: float, x1: float, y1: float, thickness: float = 0.1) -> tuple[Box, ...]:
    """Return four walls, 2.5 m high, around the rectangle."""
    t, h = thickness, 2.5
    return (
        Box((x0 - t, y0 - t, 0), (x0, y1 + t, h)),
        Box((x1, y0 - t, 0), (x1 + t, y1 + t, h)),
        Box((x0, y0 - t, 0), (x1, y0, h)),
        Box((x0, y1, 0), (x1, y1 + t, h)),
    )


def camera_to_start(base: BasePose) -> NDArray[np.float64]:
    """Return the (4, 4) pose of the head camera in navigation posture."""
    axes = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
    c, s = math.cos(-TILT), math.sin(-TILT)
    pitch = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
    camera_to_base = np.eye(4)
    camera_to_base[:3, :3] = pitch @ axes
    camera_to_base[:3, 3] = (0.0, 0.0, CAMERA_HEIGHT)
    return base.matrix() @ camera_to_base


def observe(boxes: tuple[Box, ...], base: BasePose, camera: PinholeCamera = CAMERA, step: int = 0) -> Observation:
    """Return what the robot sees at a base pose; `truth` holds the named boxes."""
    pose = camera_to_start(base)
    depth, seen = cast(boxes, pose, camera)
    return Observation(
        np.zeros((camera.height, camera.width, 3), dtype=np.uint8),
        depth,
        camera,
        pose,
        base,
        Joints(0.78, 0.0),
        False,
        step,
        segmentation(boxes, seen),
    )


def cast(
    boxes: tuple[Box, ...], pose: NDArray[np.float64], camera: PinholeCamera
) -> tuple[NDArray[np.float32], NDArray[np.integer]]:
    """Return (H, W) depth (m) and the index of the box seen, -1 for none, from a camera at a pose (4, 4)."""
    rays = camera.unproject(np.ones((camera.height, camera.width), dtype=np.float32)).astype(np.float64)
    directions = rays @ pose[:3, :3].T
    with np.errstate(divide="ignore", invalid="ignore"):
        floor = np.where(directions[..., 2] < 0, -pose[2, 3] / directions[..., 2], np.inf)
        depth, seen = floor, np.full(floor.shape, -1)
        for index, box in enumerate(boxes):
            near = (np.array(box.low) - pose[:3, 3]) / directions
            far = (np.array(box.high) - pose[:3, 3]) / directions
            enter, leave = np.minimum(near, far).max(axis=-1), np.maximum(near, far).min(axis=-1)
            hit = (enter < leave) & (enter > 0.05) & (enter < depth)
            depth, seen = np.where(hit, enter, depth), np.where(hit, index, seen)
    depth = np.where(depth < 10.0, depth, 0.0).astype(np.float32)
    return depth, np.where(depth > 0, seen, -1)


def segmentation(boxes: tuple[Box, ...], seen: NDArray[np.integer]) -> Segmentation:
    named = [index for index, box in enumerate(boxes) if box.name is not None]
    to_detection = np.full(len(boxes) + 1, -1, dtype=np.int16)
    to_detection[named] = np.arange(len(named))
    return Segmentation(to_detection[seen], tuple(Detection(((boxes[i].name or "", boxes[i].score),)) for i in named))


def move(boxes: tuple[Box, ...], base: BasePose, action: object) -> BasePose:
    """Return the base after a discrete motion; a forward motion into a box leaves it where it was."""
    if action is DiscreteAction.TURN_LEFT:
        return base.compose(BasePose(0.0, 0.0, math.radians(30.0)))
    if action is DiscreteAction.TURN_RIGHT:
        return base.compose(BasePose(0.0, 0.0, math.radians(-30.0)))
    if action is not DiscreteAction.MOVE_FORWARD:
        return base
    ends = [base.compose(BasePose(share, 0.0, 0.0)) for share in np.linspace(0.02, 0.25, 12)]
    return base if any(clearance(boxes, end) < RADIUS for end in ends) else ends[-1]


def clearance(boxes: tuple[Box, ...], base: BasePose) -> float:
    """Return the distance (m) from the base's axis to the nearest box that is not above the robot."""
    distances = [
        math.hypot(
            max(box.low[0] - base.x, 0.0, base.x - box.high[0]), max(box.low[1] - base.y, 0.0, base.y - box.high[1])
        )
        for box in boxes
        if box.low[2] < 1.4
    ]
    return min(distances, default=math.inf)
