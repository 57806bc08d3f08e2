"""A home with a robot that acts in it.

The base is a cylinder: what would bring it into anything is not done, and it does not slide along. The arm, the wrist,
the gripper and what it holds are moved as asked, and whatever they meet on the way counts as a collision. Objects move
only when they fall.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose, PinholeCamera, invert_transform, transform_points
from uniteam.interface import Action, BaseDisplacement, DiscreteAction, Joints
from uniteam.stretch import (
    JOINT_LIMITS,
    MANIPULATION_POSTURE,
    NAVIGATION_POSTURE,
    gripper_to_base,
    head_camera_to_base,
)
from uniteam.timing import section
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.home import Home
from uniteam.world.simulation.collision import ArmCollider
from uniteam.world.simulation.frame import Frame
from uniteam.world.simulation.held import HeldObject, hang
from uniteam.world.simulation.home_view import HomeView
from uniteam.world.simulation.motion import (
    FORWARD_STEP,
    TURN_STEP,
    RobotState,
    admissible,
    samples,
    translated,
    turned,
    with_joints,
)
from uniteam.world.simulation.navigable import NavigableFloor
from uniteam.world.simulation.physics import Physics
from uniteam.world.simulation.shapes import model_vertices

STEP_SECONDS = 0.032
"""How much time passes in a step (s): the challenge's 30 steps a second, in whole physics steps."""
GRASP_RANGE = 0.8
"""How far from the grasp centre an object's middle may be to be grasped (m)."""
QUARTER_TURN = np.pi / 2


@dataclass(frozen=True)
class StepEvents:
    """What came of an action.

    Attributes:
        base_blocked: whether the base stayed because something was in its way.
        scene_collision: whether the arm, the gripper or the held object met the scene.
        grasped: the instance that was grasped, or None.
        released: the instance that was released, or None.
        hit: what was met first: an instance's name, "wall", "floor" or None.
    """

    base_blocked: bool = False
    scene_collision: bool = False
    grasped: str | None = None
    released: str | None = None
    hit: str | None = None


class Simulator:
    """A home, the robot in it, and time.

    Attributes:
        home: as it was given; objects may have moved since.
        camera: the head camera's intrinsics.
        physics: where the objects are.
        floor: where the base can stand.
    """

    def __init__(self, home: Home, camera: PinholeCamera) -> None:
        """Build the home and let its objects come to rest; the robot stands in the middle of the first room."""
        self.home = home
        self.camera = camera
        self.floor = NavigableFloor(home)
        self.physics = Physics(home)
        self.physics.settle()
        self._at_first = self.physics.save()
        self._collider = ArmCollider(self.physics)
        self._view = HomeView(home, self.physics)
        self._vertices = _vertices_of_movables(home)
        self._handlers = self._discrete_handlers()
        room = home.stage.rooms[0]
        self.reset(BasePose((room.low[0] + room.high[0]) / 2, (room.low[1] + room.high[1]) / 2, 0.0))

    def reset(self, base: BasePose) -> None:
        """Put every object back and the robot at a pose (world), in its navigation posture with an empty gripper."""
        self.physics.restore(self._at_first)
        self._state = RobotState(base, NAVIGATION_POSTURE)
        self._is_manipulating = False
        self._held: HeldObject | None = None
        self._frame: Frame | None = None

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
        return None if self._held is None else self._held.name

    def camera_to_world(self) -> NDArray[np.float64]:
        """Return the (4, 4) pose of the head camera."""
        return np.asarray(self.base.matrix() @ head_camera_to_base(self.joints))

    def gripper_to_world(self) -> NDArray[np.float64]:
        """Return the (4, 4) pose of the gripper; its origin is the grasp centre."""
        return np.asarray(self.base.matrix() @ gripper_to_base(self.joints))

    def object_pose(self, name: str) -> NDArray[np.float64]:
        """Return the (4, 4) pose of a movable instance, held or not."""
        hanging = self._hanging()
        return hanging[name] if name in hanging else self.physics.pose(name)

    def render(self) -> Frame:
        """Return what the head camera sees now; a state is rendered once."""
        if self._frame is None:
            with section("camera"):
                self._frame = self._view.head(self._state, self.camera, self._hanging())
        return self._frame

    def render_third_person(self, width: int = 640, height: int = 480) -> NDArray[np.uint8]:
        """Return the (H, W, 3) picture of the robot from above, without the ceiling."""
        return self._view.from_above(self._state, (width, height), self._hanging())

    def apply(self, action: Action, target_category: str) -> StepEvents:
        """Do an action and let time pass.

        Args:
            action: what to do.
            target_category: the class of objects that the gripper grasps.
        """
        before = self._state
        events = self._do(action, target_category)
        with section("physics"):
            if self._state is before:
                events = _joined(events, self._touch())
            self.physics.advance(STEP_SECONDS)
        self._frame = None
        return events

    def _do(self, action: Action, target_category: str) -> StepEvents:
        if action is DiscreteAction.SNAP_OBJECT:
            return StepEvents(grasped=self._grasp(target_category))
        if isinstance(action, DiscreteAction):
            return self._handlers[action]()
        if isinstance(action, BaseDisplacement):
            return self._displace(admissible(action))
        return _joined(self._displace(admissible(action.base)), self._pose(self.joints + action.delta))

    def _discrete_handlers(self) -> dict[DiscreteAction, Callable[[], StepEvents]]:
        """Return what each discrete action does, but for the grasp, which needs its target."""
        extended = JOINT_LIMITS[1].arm
        return {
            DiscreteAction.STOP: StepEvents,
            DiscreteAction.EMPTY_ACTION: StepEvents,
            DiscreteAction.MOVE_FORWARD: lambda: self._displace(BaseDisplacement(x=FORWARD_STEP)),
            DiscreteAction.TURN_LEFT: lambda: self._displace(BaseDisplacement(heading=TURN_STEP)),
            DiscreteAction.TURN_RIGHT: lambda: self._displace(BaseDisplacement(heading=-TURN_STEP)),
            DiscreteAction.NAVIGATION_MODE: self._navigation_mode,
            DiscreteAction.MANIPULATION_MODE: self._manipulation_mode,
            DiscreteAction.EXTEND_ARM: lambda: self._pose(replace(self.joints, arm=extended)),
            DiscreteAction.DESNAP_OBJECT: lambda: StepEvents(released=self._release()),
        }

    def _displace(self, displacement: BaseDisplacement) -> StepEvents:
        """Move the base, then turn it; where it is blocked it stays, and does not turn either."""
        moved = translated(self._state, displacement.x, displacement.y)
        is_move = displacement.x != 0.0 or displacement.y != 0.0
        if is_move and not self.floor.sweep(self.base, moved.base.x, moved.base.y):
            return StepEvents(base_blocked=True)
        events = self._go(moved, 0.0) if is_move else StepEvents()
        if displacement.heading == 0.0:
            return events
        return _joined(events, self._go(turned(self._state, displacement.heading), displacement.heading))

    def _pose(self, joints: Joints) -> StepEvents:
        return self._go(with_joints(self._state, joints), 0.0)

    def _navigation_mode(self) -> StepEvents:
        """Fold the arm, and turn back if the robot was manipulating."""
        events = self._pose(NAVIGATION_POSTURE)
        if not self._is_manipulating:
            return events
        self._is_manipulating = False
        return _joined(events, self._displace(BaseDisplacement(heading=-QUARTER_TURN)))

    def _manipulation_mode(self) -> StepEvents:
        """Turn the arm to where the robot faced, if it did not yet, and look along it."""
        turn = StepEvents() if self._is_manipulating else self._displace(BaseDisplacement(heading=QUARTER_TURN))
        self._is_manipulating = True
        return _joined(turn, self._pose(MANIPULATION_POSTURE))

    def _go(self, end: RobotState, turn: float) -> StepEvents:
        """Move to a state and say what was met on the way."""
        radius = 0.0 if self._held is None else self._held.radius
        with section("physics"):
            hit = self._collider.first_hit(tuple(samples(self._state, end, turn, radius)), self._held)
        self._state = end
        return StepEvents(scene_collision=hit is not None, hit=hit)

    def _touch(self) -> StepEvents:
        """Say what the robot touches where it stands."""
        hit = self._collider.first_hit((self._state,), self._held)
        return StepEvents(scene_collision=hit is not None, hit=hit)

    def _grasp(self, category: str) -> str | None:
        """Take the nearest object of a category that is in view and in range, if the gripper is empty."""
        if self._held is not None:
            return None
        nearest = min(self._graspable(category), default=None)
        if nearest is None:
            return None
        name = nearest[1]
        object_to_base = invert_transform(self.base.matrix()) @ self.physics.pose(name)
        self._held = hang(name, self._vertices[name], object_to_base)
        self.physics.remove(name)
        return name

    def _graspable(self, category: str) -> list[tuple[float, str]]:
        """Return the distance (m) and name of every object that could be grasped."""
        in_view = set(np.unique(self.render().instances).tolist())
        gripper = self.gripper_to_world()[:3, 3]
        found = []
        for index, instance in enumerate(self.home.instances):
            if instance.movable and instance.category == category and index in in_view:
                distance = float(np.linalg.norm(self._middle(instance.name) - gripper))
                if distance <= GRASP_RANGE:
                    found.append((distance, instance.name))
        return found

    def _middle(self, name: str) -> NDArray[np.float64]:
        points = transform_points(self.physics.pose(name), self._vertices[name])
        return np.asarray((points.min(axis=0) + points.max(axis=0)) / 2)

    def _release(self) -> str | None:
        """Let go of what the gripper holds: it falls from where it hangs."""
        if self._held is None:
            return None
        name = self._held.name
        self.physics.set_pose(name, self._hanging()[name])
        self._held = None
        return name

    def _hanging(self) -> dict[str, NDArray[np.float64]]:
        """Return the (4, 4) pose (world) of what the gripper holds, by name."""
        if self._held is None:
            return {}
        return {self._held.name: self.base.matrix() @ self._held.to_base(gripper_to_base(self.joints))}


def _joined(first: StepEvents, second: StepEvents) -> StepEvents:
    """Return what came of two things that were done one after the other."""
    hit = first.hit or second.hit
    return StepEvents(
        first.base_blocked or second.base_blocked,
        hit is not None,
        first.grasped or second.grasped,
        first.released or second.released,
        hit,
    )


def _vertices_of_movables(home: Home) -> dict[str, NDArray[np.float64]]:
    """Return the (V, 3) vertices (m, model frame) of each movable instance's shapes."""
    catalogue = load_catalogue()
    return {i.name: model_vertices(catalogue[i.model].shapes) for i in home.instances if i.movable}
