"""The words that the world and the mind share: what is asked, what is seen, what is decided, what is done.

The world gives an `Observation`; the mind returns a `Decision`, which holds an `Action`. Neither imports the other, so
the same agent runs in the simulator, on a recording and on a robot.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, fields
from enum import Enum, IntEnum
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose, PinholeCamera


@dataclass(frozen=True)
class Instruction:
    """Move <object_category> from <start_receptacle> to <goal_receptacle>; the receptacles are classes of furniture."""

    object_category: str
    start_receptacle: str
    goal_receptacle: str

    def __str__(self) -> str:
        words = (self.object_category, self.start_receptacle, self.goal_receptacle)
        return "Move {} from {} to {}".format(*(word.replace("_", " ") for word in words))


@dataclass(frozen=True)
class Joints:
    """Positions of Stretch's joints: lift and arm extension in m, the others in rad."""

    lift: float
    arm: float
    wrist_yaw: float = 0.0
    wrist_pitch: float = 0.0
    wrist_roll: float = 0.0
    head_pan: float = 0.0
    head_tilt: float = 0.0

    def __add__(self, other: "Joints") -> "Joints":
        return Joints(*(getattr(self, f.name) + getattr(other, f.name) for f in fields(Joints)))

    def __sub__(self, other: "Joints") -> "Joints":
        return Joints(*(getattr(self, f.name) - getattr(other, f.name) for f in fields(Joints)))


class DiscreteAction(Enum):
    """The challenge's discrete actions."""

    STOP = "stop"
    MOVE_FORWARD = "move_forward"
    TURN_LEFT = "turn_left"
    TURN_RIGHT = "turn_right"
    NAVIGATION_MODE = "navigation_mode"
    MANIPULATION_MODE = "manipulation_mode"
    EXTEND_ARM = "extend_arm"
    SNAP_OBJECT = "snap_object"
    DESNAP_OBJECT = "desnap_object"
    EMPTY_ACTION = "empty_action"


@dataclass(frozen=True)
class BaseDisplacement:
    """Move the base: x forward and y left (m) in the base frame, then turn by heading (rad, left-positive)."""

    x: float = 0.0
    y: float = 0.0
    heading: float = 0.0


@dataclass(frozen=True)
class JointDisplacement:
    """Move the joints by `delta`, after a displacement of the base."""

    delta: Joints
    base: BaseDisplacement = BaseDisplacement()


Action = DiscreteAction | BaseDisplacement | JointDisplacement


@dataclass(frozen=True)
class Detection:
    """One instance that perception believes in.

    Attributes:
        candidates: (name, score) pairs, best first; at least one. A detector that wavers gives several.
        embedding: (D,) float32 of the detector's own space, or None where it has none.
    """

    candidates: tuple[tuple[str, float], ...]
    embedding: NDArray[np.float32] | None = None

    @property
    def name(self) -> str:
        """The best candidate's name."""
        return self.candidates[0][0]

    @property
    def score(self) -> float:
        """The best candidate's score, in [0, 1]."""
        return self.candidates[0][1]


@dataclass(frozen=True)
class Segmentation:
    """Which pixel belongs to which detection.

    Attributes:
        instances: (H, W) int16; index into `detections`, -1 where there is none.
        detections: what the indices mean.
    """

    instances: NDArray[np.int16]
    detections: tuple[Detection, ...]

    def __post_init__(self) -> None:
        if self.instances.ndim != 2:
            raise InvalidInputError(f"a segmentation's instances must be (H, W), got {self.instances.shape}")


@dataclass(frozen=True)
class Observation:
    """What the robot knows at one step.

    Attributes:
        rgb: (H, W, 3) uint8.
        depth: (H, W) float32, metres along the optical axis; 0 where nothing returned (beyond 10 m).
        camera: intrinsics of both images.
        camera_to_start: (4, 4) float64.
        base_to_start: exact localisation, relative to where the episode began.
        joints: where the joints are.
        is_holding: whether the gripper feels something between its fingers.
        step: how many steps have been taken.
        truth: the simulator's own segmentation by category name; None unless the run was asked for perception `truth`.
    """

    rgb: NDArray[np.uint8]
    depth: NDArray[np.float32]
    camera: PinholeCamera
    camera_to_start: NDArray[np.float64]
    base_to_start: BasePose
    joints: Joints
    is_holding: bool
    step: int
    truth: Segmentation | None = None

    def __post_init__(self) -> None:
        shape = (self.camera.height, self.camera.width)
        if self.rgb.shape != (*shape, 3) or self.depth.shape != shape:
            raise InvalidInputError(
                f"a frame of a {shape[1]}x{shape[0]} camera needs rgb {(*shape, 3)} and depth {shape}, "
                f"got {self.rgb.shape} and {self.depth.shape}"
            )


class MapLabel(IntEnum):
    """What a cell of a `MapOverlay` shows; a later one is drawn over an earlier."""

    UNKNOWN = 0
    FREE = 1
    VISITED = 2
    OBSTACLE = 3
    COLLISION = 4
    FRONTIER = 5
    START_RECEPTACLE = 6
    GOAL_RECEPTACLE = 7
    OBJECT = 8


@dataclass(frozen=True)
class MapOverlay:
    """The agent's map as a picture of labels, with what it wants.

    Attributes:
        labels: (H, W) uint8 of `MapLabel`; row = y, column = x in the start frame.
        origin: (x, y) in the start frame (m) of the corner of cell [0, 0].
        cell_size: m.
        goal: (K, 2) points (m, start frame) the robot heads for; K may be 0.
        short_term_goal: (x, y) or None.
        path: (P, 2) points (m, start frame) from the robot to the goal; P may be 0.
    """

    labels: NDArray[np.uint8]
    origin: tuple[float, float]
    cell_size: float
    goal: NDArray[np.float64]
    short_term_goal: tuple[float, float] | None
    path: NDArray[np.float64]


@dataclass(frozen=True)
class Decision:
    """What the mind wants done, and why.

    Attributes:
        action: what to do.
        state: the state of the agent's machine ("FIND_OBJECT").
        reason: one sentence of why.
        segmentation: what perception made of the observation, or None for an agent that does not look.
        overlay: call it, within the same step, for the map behind the decision; None for an agent without a map.
    """

    action: Action
    state: str
    reason: str
    segmentation: Segmentation | None = None
    overlay: Callable[[], MapOverlay] | None = field(default=None, compare=False)


class Agent(Protocol):
    """Whatever decides."""

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Forget everything and take a new instruction; `seed` fixes every random choice of the episode."""

    def act(self, observation: Observation) -> Decision:
        """Decide what to do next."""


Perception = Callable[[Observation, Instruction], Segmentation]
"""From what is seen to what it is; the instruction gives the vocabulary. May be any callable, stateful or not."""
