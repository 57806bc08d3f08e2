"""A Stretch among boxes: drives, grasps, reaches and lets go, for tests of the skills without the world's code."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from worlds.box_world import CAMERA, RADIUS, Box, cast, clearance, segmentation

from uniteam.geometry import BasePose, PinholeCamera, transform_points
from uniteam.interface import (
    ACTION_LIMITS,
    Action,
    BaseDisplacement,
    DiscreteAction,
    Instruction,
    JointDisplacement,
    Joints,
    Observation,
)
from uniteam.mind.skills.skill import Skill
from uniteam.mind.skills.view import View
from uniteam.stretch import (
    GRASP_RANGE,
    MANIPULATION_POSTURE,
    NAVIGATION_POSTURE,
    clamp_joints,
    gripper_to_base,
    head_camera_to_base,
)

Point = tuple[float, float, float]
DRIVES = {
    DiscreteAction.MOVE_FORWARD: BaseDisplacement(x=ACTION_LIMITS.forward_step),
    DiscreteAction.TURN_LEFT: BaseDisplacement(heading=ACTION_LIMITS.turn_step),
    DiscreteAction.TURN_RIGHT: BaseDisplacement(heading=-ACTION_LIMITS.turn_step),
}


@dataclass
class ArmWorld:
    """Boxes that stand still, but for the one that the gripper takes.

    Attributes:
        boxes: what there is (m, start frame).
        base: where the robot stands.
        target: name of the boxes that the gripper takes.
        camera: the head camera.
        hits: names (or "box") of what the gripper or what it holds has met, one a step.
        released: the grasp centre (m, start frame) where the gripper let go.
    """

    boxes: tuple[Box, ...]
    base: BasePose
    target: str = "cup"
    camera: PinholeCamera = CAMERA
    held: Box | None = None
    hits: list[str] = field(default_factory=list)
    released: Point | None = None

    def __post_init__(self) -> None:
        self.joints = NAVIGATION_POSTURE

    def observe(self) -> Observation:
        """Return what the head camera sees; the robot itself is invisible."""
        pose = self.base.matrix() @ head_camera_to_base(self.joints)
        depth, seen = cast(self.boxes, pose, self.camera)
        truth = segmentation(self.boxes, seen)
        rgb = np.zeros((self.camera.height, self.camera.width, 3), dtype=np.uint8)
        return Observation(rgb, depth, self.camera, pose, self.base, self.joints, self.held is not None, 0, truth)

    def view(self, instruction: Instruction) -> View:
        """Return the view in which every named box is believed."""
        observation = self.observe()
        assert observation.truth is not None
        return View(observation, observation.truth, instruction)

    def do(self, action: Action) -> None:
        """Do an action as the simulator would."""
        if isinstance(action, BaseDisplacement):
            self._drive(action)
        elif isinstance(action, DiscreteAction) and action in DRIVES:
            self._drive(DRIVES[action])
        elif isinstance(action, JointDisplacement):
            self._drive(action.base)
            self._move(clamp_joints(self.joints + action.delta))
        elif action is DiscreteAction.MANIPULATION_MODE:
            self._drive(BaseDisplacement(heading=math.pi / 2))
            self._move(MANIPULATION_POSTURE)
        elif action is DiscreteAction.NAVIGATION_MODE:
            self._move(NAVIGATION_POSTURE)
        elif action is DiscreteAction.SNAP_OBJECT:
            self._snap()
        elif action is DiscreteAction.DESNAP_OBJECT:
            self.released = self._grasp_centre()
            self.held = None

    def _drive(self, motion: BaseDisplacement) -> None:
        moved = self.base.compose(BasePose(motion.x, motion.y, 0.0))
        if clearance(self.boxes, moved) >= RADIUS:
            self.base = moved
        self.base = self.base.compose(BasePose(0.0, 0.0, motion.heading))

    def _move(self, end: Joints) -> None:
        start = self.joints
        for share in np.linspace(0.1, 1.0, 10):
            self.joints = clamp_joints(start + _scaled(end - start, share))
            hit = self._hit()
            if hit is not None:
                self.hits.append(hit)
                break
        self.joints = end

    def _hit(self) -> str | None:
        """Return what a 6 cm cube around the grasp centre, or the held box below it, overlaps."""
        x, y, z = self._grasp_centre()
        below = 0.03 if self.held is None else self.held.high[2] - self.held.low[2]
        side = 0.03 if self.held is None else (self.held.high[0] - self.held.low[0]) / 2
        low, high = np.array([x - side, y - side, z - below]), np.array([x + side, y + side, z + 0.03])
        for box in self.boxes:
            if (low < box.high).all() and (high > box.low).all():
                return box.name or "box"
        return None

    def _snap(self) -> None:
        in_view = self.observe().truth
        assert in_view is not None
        seen = {in_view.detections[i].name for i in np.unique(in_view.instances) if i >= 0}
        for box in self.boxes:
            middle = (np.array(box.low) + box.high) / 2
            if (
                box.name == self.target
                and box.name in seen
                and math.dist(middle[:2], self._grasp_centre()[:2]) <= GRASP_RANGE
            ):
                self.held = box
                self.boxes = tuple(other for other in self.boxes if other is not box)
                return

    def _grasp_centre(self) -> Point:
        x, y, z = transform_points(self.base.matrix(), gripper_to_base(self.joints)[:3, 3])
        return float(x), float(y), float(z)


def _scaled(joints: Joints, share: float) -> Joints:
    return replace(joints, **{name: share * value for name, value in vars(joints).items()})


def play(world: ArmWorld, instruction: Instruction, begin: Callable[[View], Skill[Any]]) -> tuple[Any, list[Action]]:
    """Carry a skill out in the world; return its result and its actions."""
    skill = begin(world.view(instruction))
    actions = []
    try:
        wanted = next(skill)
        while True:
            actions.append(wanted.action)
            world.do(wanted.action)
            wanted = skill.send(world.view(instruction))
    except StopIteration as end:
        return end.value, actions
