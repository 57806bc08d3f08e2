"""What the bridge of stretch_ai sends, checked: its messages of state (port 4403) and of observation (port 4401)."""

from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Detection, Joints, Segmentation
from uniteam.world.real.fields import Fields
from uniteam.world.real.images import LONGEST_SIDE, decode_depth, decode_rgb
from uniteam.world.real.link import RobotState, View
from uniteam.world.real.robot_errors import StrangeMessageError

NAVIGATION, MANIPULATION = "navigation", "manipulation"
JOINT_COUNT = 11
BASE_X, LIFT, ARM, GRIPPER, ROLL, PITCH, YAW, PAN, TILT = 0, 3, 4, 5, 6, 7, 8, 9, 10
"""Where what stands in a vector of all joints. In the six of a command the order of the wrist is another: `command`."""
TRUTH, TRUTH_NAMES = "uniteam_truth", "uniteam_truth_names"
"""Keys of our own: a picture of instances and their names, from a simulator that was asked for them."""


@dataclass(frozen=True)
class StateMessage:
    """A message of state.

    Attributes:
        state: of the robot.
        base_x: how far the base has been moved since manipulation mode was entered (m).
        mode: "navigation", "manipulation", or whatever it is in between.
        is_homed: whether lift and arm know where they are.
        at_goal: whether the base is where it was last sent to.
        step: of the last action that was done; -1 before the first.
    """

    state: RobotState
    base_x: float
    mode: str
    is_homed: bool
    at_goal: bool
    step: int


@dataclass(frozen=True)
class ObservationMessage:
    """A message of observation, its images still packed.

    Attributes:
        step: as in a message of state.
        is_simulation: whether the sender says that it is one.
    """

    step: int
    is_simulation: bool
    fields: Fields

    def view(self) -> View:
        """Return what it shows; raises StrangeMessageError."""
        camera_to_world, state = self.fields.transform("camera_pose"), _observed_state(self.fields)
        rows, columns = self.fields.integer("rgb_width"), self.fields.integer("rgb_height")  # they call it so
        if not (1 <= rows <= LONGEST_SIDE and 1 <= columns <= LONGEST_SIDE):
            raise StrangeMessageError(f"an observation message has images of {rows} rows and {columns} columns")
        camera = _camera(self.fields.matrix("camera_K"), rows, columns, self.is_simulation)
        return View(
            rgb=decode_rgb(self.fields.image("rgb"), (rows, columns)),
            depth=decode_depth(self.fields.image("depth"), (rows, columns)),
            camera=camera,
            camera_to_world=camera_to_world,
            state=state,
            truth=_truth(self.fields, (rows, columns)) if self.fields.has(TRUTH) else None,
        )


def state_message(data: Any) -> StateMessage:
    """Return a checked message of state; raises StrangeMessageError."""
    fields = Fields(data, "state message")
    joints = fields.numbers("joint_positions", JOINT_COUNT)
    fields.numbers("joint_velocities", JOINT_COUNT)
    x, y, heading = fields.numbers("base_pose", 3)
    base = BasePose(float(x), float(y), float(heading))
    return StateMessage(
        state=RobotState(base, _joints(joints), float(joints[GRIPPER]), fields.boolean("is_runstopped")),
        base_x=float(joints[BASE_X]),
        mode=fields.word("control_mode"),
        is_homed=fields.boolean("is_homed"),
        at_goal=fields.boolean("at_goal"),
        step=fields.integer("step"),
    )


def observation_message(data: Any) -> ObservationMessage:
    """Return a message of observation, checked but for its images; raises StrangeMessageError."""
    fields = Fields(data, "observation message")
    _observed_state(fields)
    fields.transform("camera_pose")
    is_simulation = fields.has("is_simulation") and fields.boolean("is_simulation")
    return ObservationMessage(fields.integer("step"), is_simulation, fields)


def command(base_x: float, joints: Joints) -> list[float]:
    """Return the six numbers of a manipulation command: base_x, lift, arm, and of the wrist yaw, pitch, roll."""
    return [base_x, joints.lift, joints.arm, joints.wrist_yaw, joints.wrist_pitch, joints.wrist_roll]


def _observed_state(fields: Fields) -> RobotState:
    """Return the state that an observation names; it says nothing of the run-stop."""
    (x, y), (heading,) = fields.numbers("gps", 2), fields.numbers("compass", 1)
    joints = fields.numbers("joint", JOINT_COUNT)
    return RobotState(BasePose(float(x), float(y), float(heading)), _joints(joints), float(joints[GRIPPER]), False)


def _joints(vector: NDArray[np.float64]) -> Joints:
    return Joints(*(float(vector[k]) for k in (LIFT, ARM, YAW, PITCH, ROLL, PAN, TILT)))


def _camera(matrix: NDArray[np.float64], rows: int, columns: int, is_simulation: bool) -> PinholeCamera:
    """Return the intrinsics of the upright image.

    The sensor lies on its side. Where its image is turned upright, clockwise by a quarter, a pixel's column is counted
    from what was the last row; the robot's bridge exchanges cx and cy but does not count anew, so its cx is mirrored.
    """
    fx, fy, cx, cy = matrix[0, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2]
    if not (fx > 1.0 and fy > 1.0 and 0.0 < cx < columns and 0.0 < cy < rows):
        raise StrangeMessageError("'camera_K' of an observation message holds no intrinsics of its image")
    across = cx if is_simulation else columns - 1 - cx
    return PinholeCamera(columns, rows, float(fx), float(fy), float(across), float(cy))


def _truth(fields: Fields, shape: tuple[int, int]) -> Segmentation:
    """Return the segmentation of a simulator, packed as a PNG of 16 bits, in which 0 is nothing."""
    names, packed = fields.words(TRUTH_NAMES), fields.image(TRUTH)
    if int.from_bytes(packed[16:20], "big") != shape[1] or int.from_bytes(packed[20:24], "big") != shape[0]:
        raise StrangeMessageError(f"'{TRUTH}' of an observation message is not of the image's size")
    image = cv2.imdecode(np.frombuffer(packed, np.uint8), cv2.IMREAD_UNCHANGED)
    if image is None or image.shape != shape or image.dtype != np.uint16 or image.max(initial=0) > len(names):
        raise StrangeMessageError(f"'{TRUTH}' of an observation message is no segmentation")
    instances = image.astype(np.int16) - np.int16(1)
    instances.flags.writeable = False
    return Segmentation(instances, tuple(Detection(((name, 1.0),)) for name in names))


def pack_truth(truth: Segmentation) -> dict[str, Any]:
    """Return the fields of a message that carry a segmentation."""
    packed = cv2.imencode(".png", (truth.instances + 1).astype(np.uint16), [cv2.IMWRITE_PNG_COMPRESSION, 1])[1]
    return {TRUTH: packed, TRUTH_NAMES: [detection.name for detection in truth.detections]}
