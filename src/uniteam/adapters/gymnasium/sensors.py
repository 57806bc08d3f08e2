"""What a policy observes, under HomeRobot's names.

Segmentations are the simulator's own truth, as they are for HomeRobot's skills: a privileged observation.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray

from uniteam.adapters.gymnasium.labels import OTHER_RECEPTACLE, Labels, receptacle_number
from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Joints
from uniteam.mind.perception.words.meaning import DIMENSIONS, load_words
from uniteam.stretch import ARM_SEGMENTS, DEPTH_RANGE, JOINT_LIMITS
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.episode import Episode

FARTHEST = 1000.0
"""Bound of a position (m): no home is that large."""


@dataclass(frozen=True)
class Scene:
    """One moment of an episode.

    Attributes:
        simulator: the home as it is now.
        episode: what is asked.
        start: where the base stood at first (world).
        labels: what each instance is to the instruction.
    """

    simulator: Simulator
    episode: Episode
    start: BasePose
    labels: Labels

    @property
    def base_to_start(self) -> BasePose:
        """Where the base is now, seen from where it stood at first."""
        return self.start.inverse().compose(self.simulator.base)


@dataclass(frozen=True)
class Sensor:
    """One entry of the observation.

    Attributes:
        name: of the entry.
        space: what it may be, for a camera.
        read: what it is now.
    """

    name: str
    space: Callable[[PinholeCamera], gymnasium.Space[Any]]
    read: Callable[[Scene], Any]


def _image(channels: int) -> Callable[[PinholeCamera], gymnasium.Space[Any]]:
    return lambda camera: gymnasium.spaces.Box(0, 255, (camera.height, camera.width, channels), np.uint8)


def _unit_image(camera: PinholeCamera) -> gymnasium.Space[Any]:
    return gymnasium.spaces.Box(0.0, 1.0, (camera.height, camera.width, 1), np.float32)


def _vector(low: NDArray[np.float32], high: NDArray[np.float32]) -> Callable[[PinholeCamera], gymnasium.Space[Any]]:
    return lambda camera: gymnasium.spaces.Box(low, high, dtype=np.float32)


def _within(bound: float, count: int) -> Callable[[PinholeCamera], gymnasium.Space[Any]]:
    return lambda camera: gymnasium.spaces.Box(-bound, bound, (count,), np.float32)


def _number(count: int) -> Callable[[PinholeCamera], gymnasium.Space[Any]]:
    return lambda camera: gymnasium.spaces.Discrete(count)


def _depth(scene: Scene) -> NDArray[np.float32]:
    return (scene.simulator.render_geometry().depth * np.float32(1.0 / DEPTH_RANGE))[..., None]


def _segments(*roles: str) -> Callable[[Scene], NDArray[np.uint8]]:
    def read(scene: Scene) -> NDArray[np.uint8]:
        instances = scene.simulator.render_geometry().instances
        return np.stack([getattr(scene.labels, role)[instances] for role in roles], axis=-1)

    return read


def _joints(scene: Scene) -> NDArray[np.float32]:
    return joint_vector(scene.simulator.joints)


def joint_vector(joints: Joints) -> NDArray[np.float32]:
    """Return the (10,) joints in Habitat's order: four arm segments and the lift (m); yaw, pitch, roll, pan, tilt."""
    arm = [joints.arm / ARM_SEGMENTS] * ARM_SEGMENTS
    wrist = [joints.wrist_yaw, joints.wrist_pitch, joints.wrist_roll]
    return np.array([*arm, joints.lift, *wrist, joints.head_pan, joints.head_tilt], np.float32)


def joints_of_vector(vector: NDArray[np.float32]) -> Joints:
    """Return the joints that `joint_vector` made a vector of."""
    *arm, lift, yaw, pitch, roll, pan, tilt = map(float, vector)
    return Joints(lift, sum(arm), yaw, pitch, roll, pan, tilt)


@lru_cache(maxsize=256)
def _embedding(category: str) -> NDArray[np.float32]:
    return np.asarray(load_words().meaning(category).vector, np.float32)


def _gps(scene: Scene) -> NDArray[np.float32]:
    base = scene.base_to_start
    return np.array([base.x, base.y], np.float32)


def _compass(scene: Scene) -> NDArray[np.float32]:
    return np.array([scene.base_to_start.heading], np.float32)


_PI = float(np.nextafter(np.float32(np.pi), np.float32(4.0)))
_RECEPTACLES = _number(OTHER_RECEPTACLE + 1)
_JOINT_RANGE = tuple(joint_vector(limit) for limit in JOINT_LIMITS)

RGB = Sensor("head_rgb", _image(3), lambda scene: scene.simulator.render().rgb.copy())
"""(H, W, 3)."""
DEPTH = Sensor("head_depth", _unit_image, _depth)
"""(H, W, 1), in tens of metres; 0 where nothing returned."""
OBJECTS = Sensor("object_segmentation", _image(1), _segments("objects"))
"""(H, W, 1): 1 on objects of the asked class."""
START_RECEPTACLES = Sensor("start_recep_segmentation", _image(1), _segments("start_receptacles"))
"""(H, W, 1): 1 on receptacles of the start class."""
GOAL_RECEPTACLES = Sensor("goal_recep_segmentation", _image(1), _segments("goal_receptacles"))
"""(H, W, 1): 1 on receptacles of the goal class."""
RECEPTACLES = Sensor("receptacle_segmentation", _image(1), _segments("receptacles"))
"""(H, W, 1): the number of the receptacle's class, 0 on what is none."""
OBJECT_GOAL = Sensor("ovmm_nav_goal_segmentation", _image(2), _segments("objects", "start_receptacles"))
"""(H, W, 2): 1 on objects of the asked class, and on receptacles of the start class."""
RECEPTACLE_GOAL = Sensor("ovmm_nav_goal_segmentation", _image(1), _segments("goal_receptacles"))
"""(H, W, 1): 1 on receptacles of the goal class."""
OBJECT_EMBEDDING = Sensor(
    "object_embedding",
    _within(1.0, DIMENSIONS),
    lambda scene: _embedding(scene.episode.instruction.object_category).copy(),
)
"""(128,): CLIP's text vector of the object class, reduced; of unit length."""
START_RECEPTACLE = Sensor(
    "start_receptacle", _RECEPTACLES, lambda scene: receptacle_number(scene.episode.instruction.start_receptacle)
)
"""Number of the start class, as `receptacle_segmentation` has it."""
GOAL_RECEPTACLE = Sensor(
    "goal_receptacle", _RECEPTACLES, lambda scene: receptacle_number(scene.episode.instruction.goal_receptacle)
)
"""Number of the goal class."""
GPS = Sensor("robot_start_gps", _within(FARTHEST, 2), _gps)
"""(2,): x forward and y left of where the base stood at first (m)."""
COMPASS = Sensor("robot_start_compass", _within(_PI, 1), _compass)
"""(1,): heading relative to that at first (rad, left-positive)."""
JOINTS = Sensor("joint", _vector(*_JOINT_RANGE), _joints)
"""(10,): see `joint_vector`."""
IS_HOLDING = Sensor("is_holding", _number(2), lambda scene: np.int64(scene.simulator.held is not None))
"""1 where the gripper holds something, else 0."""
