"""How often a robot is spoken to, and how long it is waited for."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Pace:
    """How a motion is followed.

    Attributes:
        poll: s between two looks at what the robot sends.
        command: s between two velocities; a Stretch's driver stops a base that has been given none for 0.5 s.
        resend: s after which what was not acknowledged is sent again.
        gain: which part of what remains of a motion the base drives in a second (1/s); with d seconds between a command
            and its echo it does not overshoot while gain * d is below 0.37.
        rest: s for which what moved must have stood still to be at rest.
        settle: s from rest to the picture, for the robot to stop swaying and the camera's picture to get through.
    """

    poll: float = 0.02
    command: float = 0.1
    resend: float = 0.1
    gain: float = 1.5
    rest: float = 0.4
    settle: float = 0.2


@dataclass(frozen=True)
class Patience:
    """After how many seconds it is given up.

    Attributes:
        connect: until a first state and a first picture.
        acknowledge: until the robot says that it has done what it was sent; its gripper takes 2.2 s.
        obey: until it has taken a velocity.
        mode: until it is in the mode that was asked for.
        motion: until joints are at rest.
        stall: for which a base that is driven may stay where it is; then something is in its way.
        picture: until a picture that shows what was asked for.
        recover: until a robot that fell silent speaks again.
    """

    connect: float = 10.0
    acknowledge: float = 8.0
    obey: float = 1.0
    mode: float = 20.0
    motion: float = 20.0
    stall: float = 2.0
    picture: float = 5.0
    recover: float = 10.0
