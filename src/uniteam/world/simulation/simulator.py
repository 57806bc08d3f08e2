"""A home with a robot that acts in it.

The base is a cylinder: what would bring it into anything is not done, and it does not slide along. The arm, the wrist,
the gripper and what it holds are moved as asked, and whatever they meet on the way counts as a collision (HomeRobot
puts the joints where they are asked to be and looks there only). Objects move only when they fall.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import ACTION_LIMITS, Action, BaseDisplacement, DiscreteAction, Joints
from uniteam.stretch import (
    JOINT_LIMITS,
    MANIPULATION_POSTURE,
    NAVIGATION_POSTURE,
    gripper_to_base,
    head_camera_to_base,
)
from uniteam.timing import section
from uniteam.world.homes.home import Home
from uniteam.world.physics.arm_shapes import FINGER_GAP
from uniteam.world.physics.navigable_floor import NavigableFloor
from uniteam.world.physics.physics import Physics, PhysicsState
from uniteam.world.rendering.kernels.frame import Frame, Geometry
from uniteam.world.simulation.arm_collision import ArmCollider
from uniteam.world.simulation.fingers import Fingers
from uniteam.world.simulation.floor_watch import FloorWatch
from uniteam.world.simulation.graspable import GraspRule
from uniteam.world.simulation.gripper import Gripper
from uniteam.world.simulation.held_object import HeldObject
from uniteam.world.simulation.home_view import HomeView
from uniteam.world.simulation.robot_state import (
    RobotState,
    admissible,
    samples,
    translated,
    turned,
    with_joints,
)
from uniteam.world.simulation.step_events import NOTHING, StepEvents

STEP_SECONDS = 0.032
"""How much time passes in a step (s): the challenge's 30 steps a second, in whole physics steps."""
QUARTER_TURN = np.pi / 2
"""By how much the base turns for the arm to point to where it faced (rad)."""
EXTENDED_LIFT = 0.8
"""To which `EXTEND_ARM` brings the lift (m), as HomeRobot does."""


@dataclass(frozen=True)
class Moment:
    """Where everything is in a home, and what the gripper holds."""

    physics: PhysicsState
    state: RobotState
    held: HeldObject | None


class Simulator:
    """A home, the robot in it, and time.

    Attributes:
        home: as it was given; objects may have moved since.
        camera: the head camera's intrinsics.
        physics: where the objects are.
    """

    def __init__(self, home: Home, camera: PinholeCamera) -> None:
        """Build the home and let its objects come to rest; the robot stands in the middle of the first room."""
        self.home = home
        self.camera = camera
        self.physics = Physics(home)
        self.physics.settle()
        self._at_first = self.physics.save()
        self._watch = FloorWatch(home, self.physics)
        self._collider = ArmCollider(self.physics)
        self._view = HomeView(home, self.physics)
        self._gripper = Gripper(home, self.physics)
        self._fingers = Fingers(self._collider)
        self.reset(BasePose(*home.stage.rooms[0].middle, 0.0))

    def reset(self, base: BasePose) -> None:
        """Put every object back and the robot at a pose (world), in its navigation posture with an empty gripper."""
        self.physics.restore(self._at_first)
        self._watch.restart()
        self._state = RobotState(base, NAVIGATION_POSTURE)
        self._gripper.held = None
        self._seen_at = self._state, self.physics.version
        self._frame: Frame | None = None
        self._geometry: Geometry | None = None

    def moment(self) -> Moment:
        """Return everything that decides how the home goes on, for `return_to`."""
        return Moment(self.physics.save(), self._state, self._gripper.held)

    def return_to(self, moment: Moment, base: BasePose) -> None:
        """Go on from a moment with the base elsewhere (world): for those who try things out, not for agents."""
        self.physics.restore(moment.physics)
        self._state = replace(moment.state, base=base)
        self._gripper.held = moment.held

    @property
    def floor(self) -> NavigableFloor:
        """Where the base can stand, with every object that has come to rest where it lies now."""
        return self._watch.floor

    @property
    def base(self) -> BasePose:
        """The base's pose (world)."""
        return self._state.base

    @property
    def joints(self) -> Joints:
        """The joints' positions."""
        return self._state.joints

    @property
    def held(self) -> str | None:
        """The instance in the gripper, if there is one."""
        held = self._gripper.held
        return None if held is None else held.name

    def camera_to_world(self) -> NDArray[np.float64]:
        """Return the (4, 4) pose of the head camera."""
        return np.asarray(self.base.matrix() @ head_camera_to_base(self.joints))

    def gripper_to_world(self) -> NDArray[np.float64]:
        """Return the (4, 4) pose of the gripper; its origin is the grasp centre."""
        return np.asarray(self.base.matrix() @ gripper_to_base(self.joints))

    def object_pose(self, name: str) -> NDArray[np.float64]:
        """Return the (4, 4) pose of a movable instance, held or not."""
        hanging = self._gripper.hanging(self._state)
        return hanging[name] if name in hanging else self.physics.pose(name)

    def render(self) -> Frame:
        """Return what the head camera sees now; a state is rendered once."""
        self._forget_what_was_seen_elsewhere()
        if self._frame is None:
            with section("camera"):
                self._frame = self._view.head(self._state, self.camera, self._gripper.hanging(self._state))
        return self._frame

    def render_geometry(self) -> Geometry:
        """Return what the head camera sees now but for its colours, in less time."""
        self._forget_what_was_seen_elsewhere()
        if self._frame is not None:
            return self._frame.geometry
        if self._geometry is None:
            with section("camera"):
                hanging = self._gripper.hanging(self._state)
                self._geometry = self._view.head_geometry(self._state, self.camera, hanging)
        return self._geometry

    def render_third_person(self, width: int = 640, height: int = 480) -> NDArray[np.uint8]:
        """Return the (H, W, 3) picture of the robot from above, without the ceiling."""
        return self._view.from_above(self._state, (width, height), self._gripper.hanging(self._state))

    def apply(self, action: Action, rule: GraspRule) -> StepEvents:
        """Do an action and let time pass.

        Args:
            action: what to do.
            rule: how the gripper takes things and lets go of them.
        """
        before = self._state
        events = self._do(action, rule)
        with section("physics"):
            if self._state is before:
                events = events.then(self._touch())
            self.physics.advance(STEP_SECONDS)
            self._watch.update()
        return events

    def creep(self, displacement: BaseDisplacement, joints: Joints) -> StepEvents:
        """Move the base by however little, then the joints, while no time passes: for a robot that moves in time."""
        events = self._displace(displacement)
        return events if joints == self.joints else events.then(self._pose(joints))

    def wait(self, seconds: float) -> None:
        """Let time pass, in which only objects move."""
        with section("physics"):
            self.physics.advance(seconds)
            self._watch.update()

    def grip(self, closed: bool, rule: GraspRule) -> StepEvents:
        """Close the gripper on what a rule names, or open it, while no time passes."""
        return self._do(DiscreteAction.SNAP_OBJECT if closed else DiscreteAction.DESNAP_OBJECT, rule)

    def _forget_what_was_seen_elsewhere(self) -> None:
        """Forget the view of another state: a robot that is blocked or waits among things at rest sees the same."""
        now = self._state, self.physics.version
        if now != self._seen_at:
            self._seen_at, self._frame, self._geometry = now, None, None

    def _do(self, action: Action, rule: GraspRule) -> StepEvents:
        if action is DiscreteAction.SNAP_OBJECT:
            return self._snap(rule)
        if action is DiscreteAction.DESNAP_OBJECT:
            return self._release(rule)
        if isinstance(action, DiscreteAction):
            return _DISCRETE[action](self)
        if isinstance(action, BaseDisplacement):
            return self._displace(admissible(action))
        return self._displace(admissible(action.base)).then(self._pose(self.joints + action.delta))

    def _displace(self, displacement: BaseDisplacement) -> StepEvents:
        """Move the base, then turn it; where it is blocked it stays, and does not turn either."""
        moved = translated(self._state, displacement.x, displacement.y)
        is_move = displacement.x != 0.0 or displacement.y != 0.0
        if is_move and not self.floor.sweep(self.base, moved.base.x, moved.base.y):
            return StepEvents(blocked=True)
        events = self._go(moved, 0.0) if is_move else NOTHING
        if displacement.heading == 0.0:
            return events
        return events.then(self._go(turned(self._state, displacement.heading), displacement.heading))

    def _pose(self, joints: Joints) -> StepEvents:
        return self._go(with_joints(self._state, joints), 0.0)

    def _manipulation_mode(self) -> StepEvents:
        """Turn the arm to where the robot faces, and look along it."""
        turn = self._displace(BaseDisplacement(heading=QUARTER_TURN))
        return turn.then(self._pose(MANIPULATION_POSTURE))

    def _extend_arm(self) -> StepEvents:
        """Bring the lift to its height, then the arm to its limit."""
        lifted = self._pose(replace(self.joints, lift=EXTENDED_LIFT))
        return lifted.then(self._pose(replace(self.joints, arm=JOINT_LIMITS[1].arm)))

    def _snap(self, rule: GraspRule) -> StepEvents:
        """Close the fingers; what they have between them then, or what the rule takes from elsewhere, is held."""
        enclosed = self._fingers.enclosed(self._state)
        grasped = self._gripper.snap(rule, self.render_geometry().instances, self._state, enclosed)
        return StepEvents(grasped=grasped).then(self._spread(FINGER_GAP))

    def _release(self, rule: GraspRule) -> StepEvents:
        released = StepEvents(released=self._gripper.release(self._state))
        return released.then(self._spread(rule.opening))

    def _spread(self, opening: float) -> StepEvents:
        """Bring the fingers so far apart (m)."""
        if self._state.opening == opening:
            return NOTHING
        return self._go(replace(self._state, opening=opening), 0.0)

    def _go(self, end: RobotState, turn: float) -> StepEvents:
        """Move to a state and say what was met on the way."""
        held = self._gripper.held
        with section("physics"):
            path = tuple(samples(self._state, end, turn, 0.0 if held is None else held.radius))
            touches = self._collider.touches(path, held)
        self._state = end
        return StepEvents(touches=touches)

    def _touch(self) -> StepEvents:
        """Say what the robot touches where it stands."""
        return StepEvents(touches=self._collider.touches((self._state,), self._gripper.held))


_DISCRETE: Mapping[DiscreteAction, Callable[[Simulator], StepEvents]] = {
    DiscreteAction.STOP: lambda simulator: NOTHING,
    DiscreteAction.EMPTY_ACTION: lambda simulator: NOTHING,
    DiscreteAction.MOVE_FORWARD: lambda simulator: simulator._displace(BaseDisplacement(x=ACTION_LIMITS.forward_step)),
    DiscreteAction.TURN_LEFT: lambda simulator: simulator._displace(BaseDisplacement(heading=ACTION_LIMITS.turn_step)),
    DiscreteAction.TURN_RIGHT: lambda simulator: simulator._displace(
        BaseDisplacement(heading=-ACTION_LIMITS.turn_step)
    ),
    DiscreteAction.NAVIGATION_MODE: lambda simulator: simulator._pose(NAVIGATION_POSTURE),
    DiscreteAction.MANIPULATION_MODE: Simulator._manipulation_mode,
    DiscreteAction.EXTEND_ARM: Simulator._extend_arm,
}
"""What each discrete action does, but for those of the gripper, which need a rule."""
