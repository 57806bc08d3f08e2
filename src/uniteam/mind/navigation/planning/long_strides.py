"""Whole strides where the way ahead is free (`long_strides`): up to a metre, or an exact turn, is one step."""

from dataclasses import dataclass, replace

from uniteam.geometry import BasePose
from uniteam.interface import ACTION_LIMITS, Action, BaseDisplacement
from uniteam.mind.navigation.planning.planner_config import Way
from uniteam.mind.skills.skill import LONGEST_DRIVE, SMALLEST_TURN
from uniteam.stretch import BASE_RADIUS


@dataclass(frozen=True)
class LongStrides:
    """Turns exactly and drives as far as the way is straight, explored and clear.

    Attributes:
        shortest: strides are no shorter (m): what a discrete step does is left to it.
        clearance: on the way to the nearest obstacle (m).
    """

    shortest: float = 0.4
    clearance: float = BASE_RADIUS + 0.08

    def __call__(self, base: BasePose, way: Way) -> Action | None:
        """Return the next motion from the robot (start frame) along the way; None where that is no stride."""
        length = min(way.straight, LONGEST_DRIVE)
        bearing = base.bearing_to(*way.goal)
        towards = replace(base, heading=base.heading + bearing)
        if way.blocked_in_a_row or length < self.shortest or not self._is_clear(towards, length, way):
            return None
        if abs(bearing) >= SMALLEST_TURN:
            return BaseDisplacement(heading=bearing)
        ahead = self._is_clear(base, length, way)
        return BaseDisplacement(x=length if ahead else ACTION_LIMITS.forward_step)

    def _is_clear(self, base: BasePose, length: float, way: Way) -> bool:
        """Return whether nothing is near and nothing unknown on the way straight ahead of a base."""
        end = base.compose(BasePose(length, 0.0, 0.0))
        row, column = way.bird_map.to_cell(end.x, end.y)
        rows, columns = way.bird_map.shape
        is_known = 0 <= row < rows and 0 <= column < columns and bool(way.bird_map.explored[row, column])
        return is_known and way.clearance.ahead(base, length) >= self.clearance
