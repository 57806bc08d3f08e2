"""Grasping and letting go, by a grasp rule.

It says which object is taken, and how it is held. By the challenge's "magic snap" that is in the gripper at once, from
wherever it lay. What the gripper lets go of falls from where it hung.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import invert_transform, transform_points
from uniteam.stretch import gripper_to_base
from uniteam.world.homes.home import Home
from uniteam.world.physics.collision_shapes import model_vertices
from uniteam.world.physics.physics import Physics
from uniteam.world.simulation.graspable import Graspable, GraspRule
from uniteam.world.simulation.held_object import HeldObject
from uniteam.world.simulation.robot_state import RobotState

CENTRE_SHARE = 0.25
"""Of the image's width and height: the window around its middle in which lies what the camera points at. Half of it is
5 degrees, 8 cm on a table before the arm."""


class Gripper:
    """The gripper of a robot in a home.

    Attributes:
        held: what it holds, or None.
    """

    def __init__(self, home: Home, physics: Physics) -> None:
        """Begin with nothing; what is grasped is taken out of `physics` until it is released."""
        self._home = home
        self._physics = physics
        self._vertices = {i.name: model_vertices(home.model_of(i).shapes) for i in home.instances if i.movable}
        self.held: HeldObject | None = None

    def snap(
        self, rule: GraspRule, instances: NDArray[np.integer], state: RobotState, enclosed: str | None
    ) -> str | None:
        """Take the object that a rule names and say which; a full gripper takes nothing.

        Args:
            rule: which object to take.
            instances: (H, W) what the head camera sees, as indices of the home's instances.
            state: of the robot.
            enclosed: what the fingers would close around.
        """
        name = None if self.held is not None else rule.choose(tuple(self._graspable(instances, state, enclosed)))
        if name is None:
            return None
        object_to_base = invert_transform(state.base.matrix()) @ self._physics.pose(name)
        self.held = rule.hold(name, self._vertices[name], object_to_base, gripper_to_base(state.joints)[:3, 3])
        self._physics.remove(name)
        return name

    def release(self, state: RobotState) -> str | None:
        """Let go of what is held and say what it was."""
        if self.held is None:
            return None
        name = self.held.name
        self._physics.set_pose(name, self.hanging(state)[name])
        self.held = None
        return name

    def hanging(self, state: RobotState) -> dict[str, NDArray[np.float64]]:
        """Return the (4, 4) pose (world) of what is held, by its name."""
        if self.held is None:
            return {}
        return {self.held.name: state.base.matrix() @ self.held.to_base(gripper_to_base(state.joints))}

    def _graspable(
        self, instances: NDArray[np.integer], state: RobotState, enclosed: str | None
    ) -> Iterator[Graspable]:
        in_view, in_centre = set(np.unique(instances)), set(np.unique(_centre(instances)))
        x, y = (state.base.matrix() @ gripper_to_base(state.joints))[:2, 3]
        for index, instance in enumerate(self._home.instances):
            if instance.movable:
                middle = self._middle(instance.name)
                distance = float(np.hypot(middle[0] - x, middle[1] - y))
                seen = index in in_view, index in in_centre
                yield Graspable(instance.name, instance.category, distance, *seen, instance.name == enclosed)

    def _middle(self, name: str) -> NDArray[np.float64]:
        points = transform_points(self._physics.pose(name), self._vertices[name])
        return np.asarray((points.min(axis=0) + points.max(axis=0)) / 2)


def _centre(image: NDArray[np.integer]) -> NDArray[np.integer]:
    """Return the window in the middle of an (H, W) image."""
    spans = []
    for size in image.shape:
        half = CENTRE_SHARE * size / 2
        spans.append(slice(round(size / 2 - half), round(size / 2 + half)))
    return image[spans[0], spans[1]]
