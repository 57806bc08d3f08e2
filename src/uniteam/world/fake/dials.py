"""What of a real robot a fake one has: delays, an odometry that drifts, a depth camera that errs."""

import math
from dataclasses import dataclass, fields

from uniteam.errors import InvalidInputError

_MOST = {"latency": 2.0, "drift": 0.5, "depth_noise": 0.1, "holes": 0.9, "agility": 50.0, "image_hz": 60.0}
_LEAST = {"agility": 0.1, "image_hz": 2.0}


@dataclass(frozen=True)
class Dials:
    """How much a fake robot is like a real one; with the defaults it is exact, and as quick as a Stretch.

    Attributes:
        latency: s by which every message is late, in either direction.
        drift: odometry's error: as a share of what was driven and turned, and as rad of heading per metre.
        depth_noise: standard deviation of depth (m) at 1 m; it grows with the square of the distance.
        holes: share of the depth image in which nothing returns, in patches.
        agility: how many times as fast its motors are as a Stretch's.
        image_hz: pictures a second.
        seed: of drift, noise and holes.
    """

    latency: float = 0.0
    drift: float = 0.0
    depth_noise: float = 0.0
    holes: float = 0.0
    agility: float = 1.0
    image_hz: float = 15.0
    seed: int = 0

    def __post_init__(self) -> None:
        for name in (field.name for field in fields(self) if field.name != "seed"):
            value, least = getattr(self, name), _LEAST.get(name, 0.0)
            if not (math.isfinite(value) and least <= value <= _MOST[name]):
                raise InvalidInputError(f"the dial {name} must be from {least:g} to {_MOST[name]:g}, got {value:g}")
        if self.seed < 0:
            raise InvalidInputError(f"the dial seed must not be negative, got {self.seed}")
