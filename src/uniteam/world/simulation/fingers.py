"""Whether the closing fingers enclose an object: the rule of a grasp that is no snap.

It is geometry alone. Both fingers, which one motor closes alike, have to meet the same small object with some of their
length, before either meets anything else; friction and weight are not asked for.
"""

from dataclasses import replace

import numpy as np

from uniteam.world.physics.arm_shapes import FINGER_GAP
from uniteam.world.simulation.arm_collision import TOUCH_DEPTH, ArmCollider
from uniteam.world.simulation.robot_state import RobotState

CLOSING_STEP = 0.003
"""By how much the fingers close from one look to the next (m)."""
GRIP_DEPTH = 0.001
"""A finger has met an object once it would be so deep in it (m)."""
GRIP_LENGTH = 0.006
"""With so much of its length, from the tip, at least (m); with less the object slips out."""
MOST_SHIFT = 0.03
"""How far a finger may push an object to the other before it counts as pushed over (m)."""


class Fingers:
    """The two fingers of a robot in a home."""

    def __init__(self, collider: ArmCollider) -> None:
        """Look at the home with its collider."""
        self._collider = collider

    def enclosed(self, state: RobotState) -> str | None:
        """Return the small object that the fingers would close around; None where that is none, or they are closed."""
        if state.opening <= FINGER_GAP or self._collider.touches((state,), None).first is not None:
            return None
        wanted, widest = None, state.opening
        for opening in np.arange(state.opening, 0.0, -CLOSING_STEP):
            now = replace(state, opening=float(opening))
            wanted, widest = (self._first_met(now), float(opening)) if wanted is None else (wanted, widest)
            if any(
                owner != wanted for depths in self._collider.finger_depths(now) for owner in _met(depths, TOUCH_DEPTH)
            ):
                return None
            if wanted is None:
                continue
            if widest - opening > 4.0 * MOST_SHIFT:  # pushed, it goes half as far as the finger that pushes it
                return None
            if all(wanted in _met(depths, GRIP_DEPTH) for depths in self._collider.finger_depths(now, GRIP_LENGTH)):
                return wanted
        return None

    def _first_met(self, state: RobotState) -> str | None:
        """Return the small object that either finger meets."""
        met = (_met(depths, GRIP_DEPTH) for depths in self._collider.finger_depths(state, GRIP_LENGTH))
        return next((owner for owners in met for owner in owners if self._collider.is_small(owner)), None)


def _met(depths: dict[str, float], deeper: float) -> list[str]:
    return [owner for owner, depth in depths.items() if depth > deeper]
