"""The challenge's measures under its evaluator's names."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Measures:
    """What an episode came to (see the HomeRobot paper, arXiv 2306.11565). What has become true stays true.

    Attributes:
        find_object_phase_success: the base stood at a view point of a candidate object that covered 0.1 % of the image.
        pick_object_phase_success: and, then or later, a candidate object was in the gripper.
        find_recep_phase_success: and, then or later, the base stood at a view point of a goal receptacle in view.
        place_success: and the released object had lain at rest on a goal receptacle for 50 steps in a row.
        robot_scene_colls: number of steps in which arm or gripper touched what is no small object.
        num_steps: steps taken.
        does_want_terminate: whether the agent itself called STOP.
        obj_scene_colls: number of steps in which the held object touched anything.
        robot_obj_colls: number of steps in which arm or gripper touched a small object.
    """

    find_object_phase_success: bool = False
    pick_object_phase_success: bool = False
    find_recep_phase_success: bool = False
    place_success: bool = False
    robot_scene_colls: int = 0
    num_steps: int = 0
    does_want_terminate: bool = False
    obj_scene_colls: int = 0
    robot_obj_colls: int = 0

    @property
    def overall_success(self) -> bool:
        """Placed, and the robot touched nothing but small objects on the way."""
        return self.place_success and self.robot_scene_colls == 0

    @property
    def partial_success(self) -> float:
        """The mean of the four successes."""
        phases = (
            self.find_object_phase_success,
            self.pick_object_phase_success,
            self.find_recep_phase_success,
            self.overall_success,
        )
        return sum(phases) / 4.0
