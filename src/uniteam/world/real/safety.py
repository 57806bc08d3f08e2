"""How fast, how far and how blindly a robot may move."""

import math
from dataclasses import dataclass

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose
from uniteam.world.real.link import RobotState
from uniteam.world.real.robot_errors import RunStopError, UnsafeMotionError

FASTEST = 0.3
"""m/s: what the manufacturer allows a Stretch's base at most."""
FASTEST_TURN = 1.0
"""rad/s."""
BEYOND_FENCE = 0.3
"""How far beyond the fence (m) the base may be found before all is stopped; no motion is begun that would end there."""


@dataclass(frozen=True)
class SafetyLimits:
    """What a robot must keep to.

    Attributes:
        speed: of the base at most (m/s).
        turn_speed: of the base at most (rad/s).
        fence: how far from where it began the base may go (m).
        stale: how old what the robot sends may be while it moves (s); older, and the base is stopped.
    """

    speed: float = 0.15
    turn_speed: float = 0.4
    fence: float = 3.0
    stale: float = 0.5

    def __post_init__(self) -> None:
        for name, most in (("speed", math.inf), ("turn_speed", math.inf), ("fence", math.inf), ("stale", 2.0)):
            value = getattr(self, name)
            if not (math.isfinite(value) and 0.0 < value <= most):
                raise InvalidInputError(f"the limit {name} must be above 0 and finite, at most {most:g}, got {value:g}")


@dataclass(frozen=True)
class Fence:
    """A circle on the floor, in the frame of the robot's own poses.

    Attributes:
        centre: where the base began.
        radius: m.
    """

    centre: BasePose
    radius: float

    def allows(self, base: BasePose) -> bool:
        """Return whether the base may be sent to a pose; inwards it always may."""
        return self.centre.distance_to(base.x, base.y) <= self.radius

    def check(self, state: RobotState) -> None:
        """Raise UnsafeMotionError where the base is far outside."""
        distance = self.centre.distance_to(state.base.x, state.base.y)
        if distance > self.radius + BEYOND_FENCE:
            raise UnsafeMotionError(
                f"the base is {distance:.2f} m from where it began, beyond the fence at {self.radius:.2f} m; it was "
                "stopped: see whether its localisation has jumped, and drive it back by hand"
            )


def check_run_stop(state: RobotState) -> None:
    """Raise RunStopError where the robot's run-stop is engaged."""
    if state.is_run_stopped:
        raise RunStopError(
            "the robot's run-stop is engaged, so nothing more was sent; see that all is well, release it by holding "
            "its button for two seconds, and start again"
        )
