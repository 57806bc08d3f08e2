"""The words that the world and the mind share: what is asked, what is seen, what is decided, what is done.

The world gives an `Observation`; the mind returns a `Decision`, which holds an `Action`. Neither imports the other, so
the same agent runs in the simulator, on a recording and on a robot.
"""

import math
from dataclasses import dataclass, fields
from enum import Enum, IntEnum
from operator import attrgetter
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose, PinholeCamera


@dataclass(frozen=True)
class Instruction:
    """Move `object_category` from `start_receptacle` to `goal_receptacle`; the receptacles are classes of furniture."""

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
        return Joints(*(one + two for one, two in zip(_positions(self), _positions(other), strict=True)))

    def __sub__(self, other: "Joints") -> "Joints":
        return Joints(*(one - two for one, two in zip(_positions(self), _positions(other), strict=True)))


_positions = attrgetter(*(field.name for field in fields(Joints)))


@dataclass(frozen=True)
class ActionLimits:
    """What an action does to the base, and the bounds of what can be asked of it; those of the challenge.

    Attributes:
        forward_step: how far `MOVE_FORWARD` drives (m).
        turn_step: by how much `TURN_LEFT` and `TURN_RIGHT` turn (rad).
        least_move: a continuous displacement along an axis that is shorter is not done (m).
        most_move: a longer one is cut to it (m).
        least_turn: a continuous turn that is smaller is not done (rad).
        most_turn: a larger one is cut to it (rad).
    """

    forward_step: float = 0.25
    turn_step: float = math.radians(30.0)
    least_move: float = 0.1
    most_move: float = 1.0
    least_turn: float = math.radians(5.0)
    most_turn: float = math.pi


ACTION_LIMITS = ActionLimits()
"""The limits of every body that speaks this interface."""


class DiscreteAction(Enum):
    """The challenge's discrete actions, which do what they do there.

    `MANIPULATION_MODE` turns the base by 90 degrees to the left, so that the arm points to where the robot faced, and
    turns the head to the arm; asked twice it turns twice. `NAVIGATION_MODE` folds the arm and turns the head ahead; the
    base stays as it is. `EXTEND_ARM` brings the lift to 0.8 m and extends the arm to its limit. `SNAP_OBJECT` takes
    what the run's grasp rule says, within `uniteam.stretch.GRASP_RANGE` of the gripper in the horizontal plane.
    """

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
    """Move the base: x forward and y left (m) in the base frame, then turn by heading (rad, left-positive).

    What `ACTION_LIMITS` calls too small is not done, what it calls too large is cut.
    """

    x: float = 0.0
    y: float = 0.0
    heading: float = 0.0


@dataclass(frozen=True)
class JointDisplacement:
    """Move the joints by `delta`, after a displacement of the base; they stop at `uniteam.stretch.JOINT_LIMITS`."""

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

    def __post_init__(self) -> None:
        if not self.candidates:
            raise InvalidInputError("a detection needs at least one (name, score) candidate, got none")
        for name, score in self.candidates:
            if not isinstance(name, str) or not 0.0 <= score <= 1.0:
                raise InvalidInputError(
                    f"a detection's candidates must be (name, score) with a score in [0, 1], got ({name!r}, {score!r})"
                )

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
        if self.instances.ndim != 2 or self.instances.dtype != np.int16:
            raise InvalidInputError(
                f"a segmentation's instances must be (H, W) int16, got {self.instances.shape} {self.instances.dtype}; "
                "convert them with astype(np.int16)"
            )
        lowest, highest = self.instances.min(initial=-1), self.instances.max(initial=-1)
        if lowest < -1 or highest >= len(self.detections):
            raise InvalidInputError(
                f"a segmentation's instances must be indices of its {len(self.detections)} detections, or -1 where "
                f"there is none, got {lowest} to {highest}"
            )


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
        if self.rgb.dtype != np.uint8:
            raise InvalidInputError(f"rgb must be uint8 in 0 to 255, got {self.rgb.dtype}; convert it before")
        if self.depth.dtype != np.float32:
            raise InvalidInputError(
                f"depth must be float32 in metres, got {self.depth.dtype}; divide millimetres by 1000 and convert"
            )
        if not (self.depth.min(initial=0.0) >= 0.0 and self.depth.max(initial=0.0) < np.inf):
            raise InvalidInputError("depth must be finite and not negative; give 0 where nothing returned, never NaN")
        if self.truth is not None and self.truth.instances.shape != shape:
            raise InvalidInputError(f"the truth must have the frame's size {shape}, got {self.truth.instances.shape}")


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
    """What the mind wants done, and why: a value that can be recorded and sent.

    Attributes:
        action: what to do.
        state: the state of the agent's machine ("FIND_OBJECT").
        reason: one sentence of why.
    """

    action: Action
    state: str
    reason: str


@dataclass(frozen=True)
class Explanation:
    """What is behind a decision, for films, recordings and reports.

    Attributes:
        segmentation: what perception made of the observation; None for an agent that does not look.
        overlay: the map and the plan; None for an agent without a map.
    """

    segmentation: Segmentation | None = None
    overlay: MapOverlay | None = None


class Agent(Protocol):
    """Whatever decides."""

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Forget everything and take a new instruction; `seed` fixes every random choice of the episode."""

    def act(self, observation: Observation) -> Decision:
        """Decide what to do next."""


@runtime_checkable
class Explaining(Protocol):
    """An agent that can say what is behind its decisions; it is asked only where someone looks."""

    def explain(self) -> Explanation:
        """Return what is behind the last decision; ask before the next `act`."""


class Perception(Protocol):
    """From what is seen to what it is.

    One that sets the class attribute `needs_truth = True` is shown observations with the simulator's own segmentation.
    """

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Forget everything; the instruction gives the vocabulary, `seed` fixes every random choice of the episode."""

    def perceive(self, observation: Observation) -> Segmentation:
        """Return the segmentation of an observation, of the same height and width."""


class Body(Protocol):
    """Whatever acts and sees: a simulated robot, a recording, a real Stretch."""

    def reset(self) -> Observation:
        """Begin, and look; poses are relative to where the base stands now."""

    def step(self, action: Action) -> Observation:
        """Do one action and look; raises InvalidActionError, before anything moves, for what is no action."""
