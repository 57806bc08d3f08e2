"""How far a motion of the base has come, and how fast it is to go on."""

import math
from collections.abc import Callable

from uniteam.geometry import BasePose, wrap_angle
from uniteam.world.real.pace import Pace, Patience
from uniteam.world.real.robot_errors import UnsafeMotionError

ARRIVED = 0.01
"""m or rad: a base at rest that is nearer to its end is there."""
MOST_COAST = 1.0
"""s: no base coasts longer than this; what seems to is pushed."""
SLOWEST_SHARE = 0.1
"""Of the speed limit: a base creeps no more slowly, or it would not move at all."""
TOO_FAR = 0.3
"""m or rad: a base that has gone so much farther than it was asked to is not under control."""

Meter = Callable[[BasePose], float]
"""Is shown one pose after the other and says how far (m or rad) the base has come since the first."""


def travelled() -> Meter:
    """Return what measures the way straight ahead of the first pose."""
    first: list[BasePose] = []

    def measure(base: BasePose) -> float:
        if not first:
            first.append(base)
        return first[0].inverse().compose(base).x

    return measure


def turned() -> Meter:
    """Return what adds up turns, so that more than half a circle can be measured."""
    last: list[BasePose] = []
    total = [0.0]

    def measure(base: BasePose) -> float:
        if last:
            total[0] += wrap_angle(base.heading - last[0].heading)
        last[:] = [base]
        return total[0]

    return measure


class Coast:
    """How long a base goes on at its speed after it is told to stop: delays and brakes, learned from each stop.

    Attributes:
        seconds: what it came to lately; 0 before the first stop.
    """

    def __init__(self) -> None:
        """Begin with a base that stops at once."""
        self.seconds = 0.0

    def learn(self, way: float, speed: float) -> None:
        """Take in how far (m or rad) a base went on after it was told to stop, and how fast it was to go until then."""
        if speed != 0.0:
            seconds = min(max(way / speed, 0.0), MOST_COAST)
            self.seconds = (self.seconds + seconds) / 2.0


class Drive:
    """One motion of the base along one axis.

    Attributes:
        is_stuck: whether the base has not come nearer for a while.
        rest: how far it has yet to go (m or rad), with its sign.
    """

    def __init__(self, wanted: float, meter: Meter, most: float, still: float, pace: Pace, patience: Patience) -> None:
        """Begin a motion.

        Args:
            wanted: how far (m or rad), with its sign.
            meter: measures it.
            most: speed (m/s or rad/s).
            still: what is less (m or rad) is no progress.
            pace: of the control.
            patience: with a base that does not move.
        """
        self._wanted, self._meter, self._most, self._still = wanted, meter, most, still
        self._gain, self._poll, self._stall = pace.gain, pace.poll, patience.stall
        self.rest = self._first_rest = wanted
        self.is_stuck = False
        self._best, self._best_at = math.inf, math.inf

    def begin_again(self, now: float) -> None:
        """Take up the motion once more from where the base came to rest, half as fast: delays made it overshoot."""
        self._gain, self._most, self._first_rest = self._gain / 2.0, self._most / 2.0, self.rest
        self._best, self._best_at = abs(self.rest), now

    def see(self, base: BasePose, now: float) -> None:
        """Take note of where the base is; raises UnsafeMotionError where it has run away."""
        self.rest = self._wanted - self._meter(base)
        beyond = -self.rest * math.copysign(1.0, self._wanted)
        if abs(self.rest) > abs(self._wanted) + TOO_FAR or beyond > TOO_FAR:
            raise UnsafeMotionError(
                f"the base was to move by {self._wanted:.2f} (m or rad) and is {abs(self.rest):.2f} from there; it "
                "was told to stop: see whether its wheels slip or its localisation has jumped"
            )
        if abs(self.rest) < self._best - self._still:
            self._best, self._best_at = abs(self.rest), now
        self.is_stuck = now - self._best_at > self._stall

    @property
    def is_there(self) -> bool:
        """Whether a base at rest is near enough to where it was sent."""
        return abs(self.rest) <= ARRIVED

    def is_to_stop(self, coast: Coast) -> bool:
        """Return whether the base, told to stop now, comes to rest at the end of its way, or beyond."""
        on = coast.seconds + self._poll / 2.0  # it is looked at once a poll: half the time it is too late already
        return math.copysign(1.0, self._first_rest) * self.rest <= abs(self.speed()) * on

    def speed(self) -> float:
        """Return how fast (m/s or rad/s) to go on, with its sign."""
        share = min(max(self._gain * abs(self.rest), SLOWEST_SHARE * self._most), self._most)
        return math.copysign(share, self.rest)
