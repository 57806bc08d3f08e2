"""Grasping and letting go: the challenge's "magic snap".

The gripper takes the nearest object of the class it is asked for, among those that the head camera sees and whose
middle is within its range; nothing is grasped otherwise. What it lets go of falls from where it hung.
"""

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import invert_transform, transform_points
from uniteam.stretch import GRASP_RANGE, gripper_to_base
from uniteam.world.homes.home import Home
from uniteam.world.physics.collision_shapes import model_vertices
from uniteam.world.physics.physics import Physics
from uniteam.world.simulation.held_object import HeldObject, hang
from uniteam.world.simulation.robot_state import RobotState


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

    def grasp(self, category: str, in_view: NDArray[np.integer], state: RobotState) -> str | None:
        """Take the nearest object of a category; in_view has the indices of the home's instances that are seen."""
        if self.held is not None:
            return None
        nearest = min(self._graspable(category, in_view, state), default=None)
        if nearest is None:
            return None
        name = nearest[1]
        object_to_base = invert_transform(state.base.matrix()) @ self._physics.pose(name)
        self.held = hang(name, self._vertices[name], object_to_base)
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

    def _graspable(self, category: str, in_view: NDArray[np.integer], state: RobotState) -> list[tuple[float, str]]:
        """Return the distance (m) and the name of every object that could be grasped."""
        grasp_centre = (state.base.matrix() @ gripper_to_base(state.joints))[:3, 3]
        seen = (self._home.instances[k] for k in in_view if k >= 0)
        names = (i.name for i in seen if i.movable and i.category == category)
        distances = ((float(np.linalg.norm(self._middle(name) - grasp_centre)), name) for name in names)
        return [(distance, name) for distance, name in distances if distance <= GRASP_RANGE]

    def _middle(self, name: str) -> NDArray[np.float64]:
        points = transform_points(self._physics.pose(name), self._vertices[name])
        return np.asarray((points.min(axis=0) + points.max(axis=0)) / 2)
