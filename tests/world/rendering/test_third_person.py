"""The camera that follows the robot is never behind a wall if it can be elsewhere."""

import math

import numpy as np
import pytest

from uniteam.geometry import BasePose
from uniteam.world.homes.home import Stage, Wall
from uniteam.world.rendering.third_person import HEIGHT, REACH, TARGET_HEIGHT, Watcher

SOUTH = Wall((-5.0, 0.0), (5.0, 0.0), 0.1)
WEST = Wall((-5.0, 0.0), (-5.0, 8.0), 0.1)


def test_the_camera_looks_at_the_robot() -> None:
    pose = Watcher(Stage((), (), 2.5)).pose(BasePose(1.0, 2.0, 0.5))
    towards = np.array([1.0, 2.0, TARGET_HEIGHT]) - pose[:3, 3]
    assert pose[:3, 2] == pytest.approx(towards / np.linalg.norm(towards))
    assert pose[:3, :3].T @ pose[:3, :3] == pytest.approx(np.eye(3))
    assert np.linalg.det(pose[:3, :3]) == pytest.approx(1.0)
    assert pose[2, 1] < 0.0  # down in the image is down in the world
    assert pose[2, 3] == HEIGHT


@pytest.mark.parametrize(("x", "y"), [(0.0, 0.6), (-4.4, 0.6), (-4.4, 4.0), (4.0, 0.4)])
def test_no_wall_is_close_between_the_camera_and_the_robot(x: float, y: float) -> None:
    camera = Watcher(Stage((), (SOUTH, WEST), 2.5)).pose(BasePose(x, y, 0.0))[:2, 3]
    assert math.hypot(camera[0] - x, camera[1] - y) == pytest.approx(REACH)
    nearest = min(_share(camera, (x, y), axis, at) for axis, at in ((1, 0.0), (0, -5.0)))
    assert nearest * REACH >= 1.7


def test_the_camera_stays_on_its_side_as_long_as_the_robot_is_seen() -> None:
    watcher = Watcher(Stage((), (SOUTH,), 2.5))
    offsets = [watcher.pose(BasePose(0.0, y, 0.0))[:2, 3] - (0.0, y) for y in (5.0, 0.5, 5.0)]
    assert not np.allclose(offsets[0], offsets[1])
    assert np.allclose(offsets[1], offsets[2])


def _share(camera: np.ndarray, robot: tuple[float, float], axis: int, at: float) -> float:
    """Return where the line from the robot to the camera crosses a wall's line, as a share of its length."""
    step = camera[axis] - robot[axis]
    share = (at - robot[axis]) / step if step else math.inf
    return share if share > 0.0 else math.inf
