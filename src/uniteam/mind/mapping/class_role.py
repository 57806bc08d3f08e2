"""Which part a detection plays in the instruction: the object, the start receptacle, the goal receptacle, or none."""

from collections.abc import Callable

from uniteam.interface import Detection, Instruction
from uniteam.mind.perception.vocabulary import ClassRole

__all__ = ["ClassRole", "RoleScores", "role_scores"]

RoleScores = Callable[[Detection], tuple[float, float, float]]
"""The score in [0, 1] with which a detection plays each `ClassRole`, in its order; 0 where it does not."""


def role_scores(instruction: Instruction) -> RoleScores:
    """Return the scores of a detection's best name for each role.

    A name may play several roles: "move the cup from a table to a table" makes every table both. Only the best
    candidate counts, as in HomeRobot, where a pixel bears one label.
    """
    names = (instruction.object_category, instruction.start_receptacle, instruction.goal_receptacle)

    def scores(detection: Detection) -> tuple[float, float, float]:
        best, score = detection.candidates[0]
        of_object, of_start, of_goal = (score if best == name else 0.0 for name in names)
        return of_object, of_start, of_goal

    return scores
