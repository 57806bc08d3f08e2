"""What the gripper could take, and who says which of it and how: a grasp rule."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from uniteam.world.physics.arm_shapes import FINGER_GAP
from uniteam.world.simulation.held_object import Hold, hang


@dataclass(frozen=True)
class Graspable:
    """A small object, wherever it is, at the moment of a snap.

    Attributes:
        name: of the instance.
        category: its class.
        distance: of its middle from the grasp centre in the horizontal plane (m).
        is_in_view: whether any pixel of it is in the head camera's image.
        is_in_centre: whether any pixel of it is in the middle of that image.
        is_enclosed: whether the closing fingers would have it between them, and neither they nor the arm anything else.
    """

    name: str
    category: str
    distance: float
    is_in_view: bool
    is_in_centre: bool
    is_enclosed: bool = False


Choose = Callable[[Sequence[Graspable]], str | None]
"""From all small objects of a home to the name of the one that the gripper takes, or None."""


@dataclass(frozen=True)
class GraspRule:
    """How the gripper takes things and lets go of them.

    Attributes:
        choose: which object it takes when it closes.
        hold: where in the gripper that then is.
        opening: how far apart its fingers are once it has been opened (m); the challenge's do not move.
    """

    choose: Choose
    hold: Hold = hang
    opening: float = FINGER_GAP


def _nothing(things: Sequence[Graspable]) -> None:
    return None


TAKE_NOTHING = GraspRule(_nothing)
"""Leaves every object where it is: for actions that are no snap."""
