"""Which word of the instruction a detection answers to: object, start receptacle, goal receptacle, or none."""

from collections.abc import Callable
from enum import IntEnum

from uniteam.interface import Detection, Instruction


class ClassRole(IntEnum):
    """What a class of things is to the instruction; the value is the index of its channel in the map."""

    OBJECT = 0
    START_RECEPTACLE = 1
    GOAL_RECEPTACLE = 2


def class_names(instruction: Instruction) -> dict[ClassRole, str]:
    """Return the class that plays each role."""
    return {
        ClassRole.OBJECT: instruction.object_category,
        ClassRole.START_RECEPTACLE: instruction.start_receptacle,
        ClassRole.GOAL_RECEPTACLE: instruction.goal_receptacle,
    }


def roles_of_name(name: str, instruction: Instruction) -> tuple[ClassRole, ...]:
    """Return every role of a class; two where start and goal receptacle are of one class, none for other things."""
    return tuple(role for role, class_name in class_names(instruction).items() if class_name == name)


def roles_of(detection: Detection, instruction: Instruction) -> tuple[ClassRole, ...]:
    """Return every role of a detection, by its best candidate's name."""
    return roles_of_name(detection.name, instruction)


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
