"""Our camera and MuJoCo's renderer see the same home; skipped where there is no OpenGL."""

import numpy as np
import pytest
from worlds.camera_scenes import looking

from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.generation.generate import generate_home
from uniteam.world.rendering.mujoco_reference import OpenGLMissingError, compare_with_mujoco


def test_the_camera_agrees_with_mujoco_s_renderer_in_a_furnished_home() -> None:
    home = generate_home(7)
    poses = []
    for room in home.stage.rooms[:2]:
        (x0, y0), (x1, y1) = room.low, room.high
        poses.append(looking((x0 + 0.4, y0 + 0.4, 1.31), ((x0 + x1) / 2.0, (y0 + y1) / 2.0, 0.5)))
        poses.append(looking((x1 - 0.4, y0 + 0.4, 1.31), (x0, (y0 + y1) / 2.0, 0.3)))
    try:
        comparison = compare_with_mujoco(home, HEAD_CAMERA_HALF, [np.asarray(pose) for pose in poses])
    except OpenGLMissingError as missing:
        pytest.skip(str(missing))
    assert comparison.view_count == 4
    assert comparison.depth_median_error < 1e-3
    assert comparison.instance_agreement >= 0.995
    assert comparison.camera_speedup > 1.0
