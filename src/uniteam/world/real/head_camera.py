"""The head camera of a Stretch, a RealSense D435i that lies on its side, as upright pictures."""

from importlib import import_module
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import UnavailableError
from uniteam.geometry import PinholeCamera
from uniteam.stretch import DEPTH_RANGE
from uniteam.world.real.robot_errors import SilentRobotError

Picture = tuple[NDArray[np.uint8], NDArray[np.float32], PinholeCamera]
"""(H, W, 3) colours, (H, W) depth (m, 0 where nothing returned), both upright and read-only, and their intrinsics."""

WIDTH, HEIGHT, RATE = 640, 480, 15
"""Of the sensor as it lies (pixels), and pictures a second."""
WAIT = 1000
"""ms for a picture."""


class HeadCamera(Protocol):
    """Whatever gives the head's pictures."""

    def read(self) -> Picture:
        """Return the next picture; raises RobotError where none comes."""

    def close(self) -> None:
        """Let go of the camera."""


class RealSenseHead:
    """The head camera through pyrealsense2."""

    def __init__(self) -> None:
        """Begin to stream; raises UnavailableError where the library or the camera is not there."""
        try:
            library = import_module("pyrealsense2")
        except ImportError as error:
            raise UnavailableError(
                f"the head camera is read by pyrealsense2, which cannot be imported ({error}); install it on the robot "
                "with: pip install pyrealsense2"
            ) from error
        config = library.config()
        config.enable_device(_serial_of(library, "D435"))
        config.enable_stream(library.stream.color, WIDTH, HEIGHT, library.format.rgb8, RATE)
        config.enable_stream(library.stream.depth, WIDTH, HEIGHT, library.format.z16, RATE)
        self._pipeline = library.pipeline()
        profile = self._pipeline.start(config)
        self._scale = float(profile.get_device().first_depth_sensor().get_depth_scale())
        self._align = library.align(library.stream.color)
        self._failed = RuntimeError  # what the library raises where no picture comes

    def read(self) -> Picture:
        """Return the next picture."""
        try:
            frames = self._align.process(self._pipeline.wait_for_frames(WAIT))
        except self._failed as error:
            raise SilentRobotError(f"the head camera gave no picture in {WAIT} ms ({error}); see its cable") from error
        color, depth = frames.get_color_frame(), frames.get_depth_frame()
        lying = color.profile.as_video_stream_profile().get_intrinsics()
        sensor = PinholeCamera(lying.width, lying.height, lying.fx, lying.fy, lying.ppx, lying.ppy)
        metres = np.asanyarray(depth.get_data()).astype(np.float32) * np.float32(self._scale)
        return upright(np.asanyarray(color.get_data()), metres, sensor)

    def close(self) -> None:
        """End the stream."""
        self._pipeline.stop()


def upright(rgb: NDArray[np.uint8], depth: NDArray[np.float32], sensor: PinholeCamera) -> Picture:
    """Return a picture of a camera that lies on its side, turned clockwise by a quarter, with its intrinsics.

    Args:
        rgb: (H, W, 3).
        depth: (H, W) (m); beyond the range it becomes 0.
        sensor: intrinsics of both, as they lie.
    """
    turned, deep = np.rot90(rgb, k=-1).copy(), np.rot90(depth, k=-1).astype(np.float32)
    deep[~(deep <= DEPTH_RANGE)] = 0.0
    turned.flags.writeable = deep.flags.writeable = False
    across = sensor.height - 1 - sensor.cy
    return turned, deep, PinholeCamera(sensor.height, sensor.width, sensor.fy, sensor.fx, across, sensor.cx)


def _serial_of(library: Any, name: str) -> str:
    """Return the serial number of the first camera with such a name; raises UnavailableError."""
    for device in library.context().query_devices():
        if name in device.get_info(library.camera_info.name):
            return str(device.get_info(library.camera_info.serial_number))
    raise UnavailableError(f"there is no camera of kind {name}; see its cable, and that no other process uses it")
