"""What LeRobot is told of the robot: `--robot.type=uniteam_stretch`."""

from dataclasses import dataclass

from lerobot.robots.config import RobotConfig

from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.real.safety import FASTEST, FASTEST_TURN
from uniteam.world.real.zmq_wire import OBSERVATION_PORT


@RobotConfig.register_subclass("uniteam_stretch")
@dataclass(kw_only=True)
class UniteamStretchConfig(RobotConfig):
    """Where the robot is, and what it keeps to.

    Attributes:
        host: name or address of a robot that runs the bridge of stretch_ai; "here" on the robot itself.
        port: the first of the bridge's four.
        dry_run: whether it is only looked at.
        speed: of the base at most (m/s).
        turn_speed: of the base at most (rad/s).
        fence: how far from where it began the base may go (m).
        height: of the pictures that are shown (px).
        width: of the pictures that are shown (px).
    """

    host: str
    port: int = OBSERVATION_PORT
    dry_run: bool = False
    speed: float = 0.15
    turn_speed: float = 0.4
    fence: float = 3.0
    height: int = HEAD_CAMERA_HALF.height
    width: int = HEAD_CAMERA_HALF.width

    def __post_init__(self) -> None:
        """Raise ValueError for a speed that a Stretch must not have."""
        super().__post_init__()
        for name, most in (("speed", FASTEST), ("turn_speed", FASTEST_TURN)):
            if not 0.0 < getattr(self, name) <= most:
                raise ValueError(f"{name} must be above 0 and at most {most:g}, got {getattr(self, name)}")
