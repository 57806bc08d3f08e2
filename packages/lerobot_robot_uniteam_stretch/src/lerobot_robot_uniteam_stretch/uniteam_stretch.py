"""A Stretch that LeRobot drives: its names for what is seen, felt and done are those of exported datasets."""

from typing import Any

import cv2
import numpy as np
from lerobot.robots.robot import Robot
from lerobot.utils.errors import DeviceAlreadyConnectedError, DeviceNotConnectedError

from lerobot_robot_uniteam_stretch.config_uniteam_stretch import UniteamStretchConfig
from uniteam.adapters.action_vector import ACTION_NAMES, action_of, vector_of
from uniteam.adapters.state_vector import STATE_NAMES, state_vector
from uniteam.errors import InvalidActionError, InvalidInputError
from uniteam.geometry import PinholeCamera
from uniteam.interface import Observation
from uniteam.world.real.connect import connect
from uniteam.world.real.dry_run import DryRunLink
from uniteam.world.real.safety import SafetyLimits
from uniteam.world.real.stretch_robot import StretchRobot

CAMERA = "head"


class UniteamStretch(Robot):
    """A Stretch behind the bridge of stretch_ai.

    An action is done to its end before `send_action` returns, and the observation after it is of then. Any error stops
    the base.
    """

    config_class = UniteamStretchConfig
    name = "uniteam_stretch"

    def __init__(self, config: UniteamStretchConfig) -> None:
        """Take the configuration; the robot is reached by `connect`."""
        super().__init__(config)
        self.config = config
        self._body: StretchRobot | None = None

    @property
    def observation_features(self) -> dict[str, Any]:
        """Joints, base and gripper as numbers, and the head camera's picture."""
        return {**dict.fromkeys(STATE_NAMES, float), CAMERA: (self.config.height, self.config.width, 3)}

    @property
    def action_features(self) -> dict[str, type]:
        """The numbers of an action, in metres and radians."""
        return dict.fromkeys(ACTION_NAMES, float)

    @property
    def is_connected(self) -> bool:
        """Whether the robot has been reached."""
        return self._body is not None

    @property
    def is_calibrated(self) -> bool:
        """Always: the robot's own software calibrates it."""
        return True

    def connect(self, calibrate: bool = True) -> None:
        """Reach the robot, open its gripper and take the navigation posture; where it stands is the start.

        Raises:
            UniteamError: the robot cannot be reached or go on, or its pictures have other proportions.
        """
        if self._body is not None:
            raise DeviceAlreadyConnectedError(f"{self} is connected")
        config = self.config
        limits = SafetyLimits(config.speed, config.turn_speed, config.fence)
        link = connect(config.host, config.port, limits)
        try:
            self._check(link.glance().camera)
            body = StretchRobot(DryRunLink(link) if config.dry_run else link, limits)
            self._seen = body.reset()
        except BaseException:
            link.close()
            raise
        self._body = body

    def calibrate(self) -> None:
        """Do nothing: the robot's own software calibrates it."""

    def configure(self) -> None:
        """Do nothing: limits are of the configuration."""

    def get_observation(self) -> dict[str, Any]:
        """Return what was seen and felt after the last action, or at the start."""
        self._connected()
        return {**_named_state(self._seen), CAMERA: self._picture(self._seen)}

    def send_action(self, action: dict[str, Any]) -> dict[str, float]:
        """Do an action to its end, and look; return the numbers of what was asked of the robot.

        Raises:
            InvalidActionError: a number is missing or none; nothing has moved.
            UniteamError: the robot cannot go on; it has been told to stop.
        """
        body = self._connected()
        if lacking := [name for name in ACTION_NAMES if name not in action]:
            raise InvalidActionError(f"the action lacks {', '.join(lacking)}; give all of action_features")
        wanted = action_of([float(action[name]) for name in ACTION_NAMES])
        self._seen = body.step(wanted)
        return dict(zip(ACTION_NAMES, map(float, vector_of(wanted)), strict=True))

    def disconnect(self) -> None:
        """Stop, and let go of the robot."""
        body, self._body = self._connected(), None
        body.close()

    def _connected(self) -> StretchRobot:
        if self._body is None:
            raise DeviceNotConnectedError(f"{self} is not connected; call connect() first")
        return self._body

    def _check(self, camera: PinholeCamera) -> None:
        wanted = self.config
        if abs(camera.height * wanted.width - camera.width * wanted.height) > max(camera.height, camera.width):
            raise InvalidInputError(
                f"the robot's pictures are {camera.height}x{camera.width}, which cannot be shrunk to "
                f"{wanted.height}x{wanted.width}; give height and width in their proportions"
            )

    def _picture(self, seen: Observation) -> np.ndarray:
        size = (self.config.width, self.config.height)
        if seen.rgb.shape[1::-1] == size:
            return seen.rgb
        return np.asarray(cv2.resize(seen.rgb, size, interpolation=cv2.INTER_AREA), np.uint8)


def _named_state(seen: Observation) -> dict[str, float]:
    numbers = state_vector(seen.joints, seen.base_to_start, seen.is_holding)
    return dict(zip(STATE_NAMES, map(float, numbers), strict=True))
