"""Small and exact motions where the discrete ones do not fit (`narrow_motion`)."""

import math
from dataclasses import dataclass, replace
from itertools import product

from uniteam.geometry import BasePose
from uniteam.interface import ACTION_LIMITS, Action, BaseDisplacement
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.planning.clearance import Clearance
from uniteam.mind.navigation.planning.collision_mapping import BlockedMotion
from uniteam.mind.navigation.planning.planner_config import Way, move_in_steps
from uniteam.mind.navigation.window import window_around
from uniteam.mind.skills.skill import SMALLEST_TURN
from uniteam.stretch import BASE_RADIUS

NARROW = BASE_RADIUS + 0.1
"""m; with less clearance the way is narrow: the play of a step of 15 degrees off its course, and of a cell."""


@dataclass(frozen=True)
class ExactWhereNarrow:
    """Moves in steps where there is room; else along the straight line that keeps farthest from what was seen.

    Attributes:
        turn_from: a bearing so wide (rad) is turned to in steps of 30 degrees first.
        headings: of the lines that are weighed, off the bearing of the short-term goal (rad).
        lengths: of the lines (m).
        precision: a heading so near to the wanted one is as good (rad).
    """

    turn_from: float = math.radians(35.0)
    headings: tuple[float, ...] = tuple(math.radians(d) for d in (0, -3, 3, -6, 6, -10, 10, -15, 15, -20, 20))
    lengths: tuple[float, ...] = (0.25, 0.15)
    precision: float = math.radians(1.5)

    def __call__(self, base: BasePose, way: Way) -> Action:
        """Return the next motion from the robot (start frame) along the way."""
        bearing, step = base.bearing_to(*way.goal), ACTION_LIMITS.forward_step
        towards = replace(base, heading=base.heading + bearing)
        is_near_ahead = abs(bearing) <= ACTION_LIMITS.turn_step / 2 and way.clearance.ahead(base, step) < NARROW
        is_narrow = way.clearance.ahead(towards, step) < NARROW
        if abs(bearing) > self.turn_from or not (is_narrow or is_near_ahead):
            return move_in_steps(base, way)
        off, length = self._roomiest(towards, way.bird_map) if is_narrow else (0.0, step)
        needed = math.remainder(bearing + off, 2 * math.pi)
        if abs(needed) <= self.precision:
            return BaseDisplacement(x=length)
        if abs(needed) < SMALLEST_TURN:  # too small a turn to be done: overshoot, to come back by one that is not
            needed += math.copysign(1.5 * SMALLEST_TURN, needed)
        return BaseDisplacement(heading=needed)

    def _roomiest(self, towards: BasePose, bird_map: BirdsEyeMap) -> tuple[float, float]:
        """Return the heading off the bearing and the length of the best line from a base that faces the goal."""
        fine = Clearance(*bird_map.fine.around(towards))
        best, chosen = -math.inf, (0.0, self.lengths[0])
        for off, length in product(self.headings, self.lengths):
            line = replace(towards, heading=towards.heading + off)
            room = min(fine.ahead(line, length), NARROW)
            worth = room + 0.02 * length * math.cos(off) - 0.005 * abs(off) - bird_map.fine.was_blocked(line)
            if worth > best:
                best, chosen = worth, (off, length)
        return chosen


@dataclass(frozen=True)
class SpareNarrowWays:
    """Has no obstacle written where a narrow way was grazed, which would close it for ever.

    The motion itself is remembered, so that another one is tried, until one too many was blocked.

    Attributes:
        tries: so many blocked motions in a row are not written.
    """

    tries: int = 5

    def __call__(self, bird_map: BirdsEyeMap, motion: BlockedMotion) -> bool:
        """Return whether a blocked motion is not written into the map."""
        bird_map.fine.note_blocked(motion.base)
        if motion.in_a_row > self.tries:
            return False
        clearance = Clearance.of(bird_map, window_around(bird_map, motion.base))
        return clearance.ahead(motion.base, ACTION_LIMITS.forward_step) < NARROW
