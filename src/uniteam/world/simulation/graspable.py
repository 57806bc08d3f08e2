"""What the gripper could take, and who says which of it: a grasp rule."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Graspable:
    """A small object, wherever it is, at the moment of a snap.

    Attributes:
        name: of the instance.
        category: its class.
        distance: of its middle from the grasp centre in the horizontal plane (m).
        is_in_view: whether any pixel of it is in the head camera's image.
        is_in_centre: whether any pixel of it is in the middle of that image.
    """

    name: str
    category: str
    distance: float
    is_in_view: bool
    is_in_centre: bool


GraspRule = Callable[[Sequence[Graspable]], str | None]
"""From all small objects of a home to the name of the one that the gripper takes, or None."""


def take_nothing(things: Sequence[Graspable]) -> None:
    """Leave every object where it is: for actions that are no snap."""
