"""What is met along a motion, by the challenge's three kinds of collisions."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Touches:
    """The first thing of each kind that is met, or None: an instance's name, "wall" or "floor".

    Attributes:
        robot_scene: what a link of the robot other than the base meets, small objects left out.
        obj_scene: what the held object meets, small objects too.
        robot_obj: the small object that a link of the robot meets.
    """

    robot_scene: str | None = None
    obj_scene: str | None = None
    robot_obj: str | None = None

    @property
    def first(self) -> str | None:
        """What was met, of whichever kind; None where nothing was."""
        return self.robot_scene or self.obj_scene or self.robot_obj

    def then(self, later: "Touches") -> "Touches":
        """Return what was met in two motions, one after the other."""
        return Touches(
            self.robot_scene or later.robot_scene, self.obj_scene or later.obj_scene, self.robot_obj or later.robot_obj
        )


NO_TOUCH = Touches()
