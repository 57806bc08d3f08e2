"""The look around with which an episode begins."""

from collections.abc import Callable
from dataclasses import dataclass

from uniteam.interface import DiscreteAction
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap


def object_is_known(bird_map: BirdsEyeMap) -> bool:
    """Look no further once the object has been seen on its receptacle."""
    return bool(bird_map.object_on_start_receptacle(play=0).any())


def never_enough(bird_map: BirdsEyeMap) -> bool:
    """Look all around, whatever is seen."""
    return False


@dataclass(frozen=True)
class FirstLook:
    """How the robot turns on the spot; the defaults are HomeRobot's.

    Attributes:
        side: to which the robot turns.
        is_enough: whether to stop earlier.
    """

    side: DiscreteAction = DiscreteAction.TURN_RIGHT
    is_enough: Callable[[BirdsEyeMap], bool] = object_is_known


FULL_CIRCLE = FirstLook(DiscreteAction.TURN_LEFT, never_enough)
"""`full_circle`."""
HOMEROBOT_TURNS = 10
"""Of 30 degrees; HomeRobot's counter runs two ahead of the twelve of a circle."""
