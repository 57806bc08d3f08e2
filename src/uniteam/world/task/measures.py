"""The challenge's measures under its evaluator's names."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Measures:
    """What an episode came to (see the HomeRobot paper, arXiv 2306.11565).

    Attributes:
        find_object_phase_success: the base stood at a view point of a candidate object that covered 0.1 % of the image.
        pick_object_phase_success: and a candidate object was grasped.
        find_recep_phase_success: and later the base stood at a view point of a goal receptacle in view.
        place_success: and the object came to rest on a goal receptacle.
        robot_scene_colls: number of steps in which arm, gripper or held object collided with the scene.
        num_steps: steps taken.
        does_want_terminate: whether the agent itself called STOP.
    """

    find_object_phase_success: bool = False
    pick_object_phase_success: bool = False
    find_recep_phase_success: bool = False
    place_success: bool = False
    robot_scene_colls: int = 0
    num_steps: int = 0
    does_want_terminate: bool = False

    @property
    def overall_success(self) -> bool:
        """Placed, and nothing was touched on the way."""
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
