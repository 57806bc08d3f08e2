"""What Stretch's arm, wrist and gripper collide as: boxes that move with its groups of links.

Only what can leave the base's cylinder is here: the base, the mast, the lift's carriage, the arm's outer tube and the
head do not. The boxes enclose the URDF's meshes, rounded to millimetres.
"""

from dataclasses import dataclass

from uniteam.world.assets.model import Box


@dataclass(frozen=True)
class ArmBox:
    """A box (base frame, where every joint is at zero) that moves with a group of `stretch.link_motions`.

    Attributes:
        group: with which it moves.
        box: itself; a finger as `FINGER_GAP` has it.
        side: to which side along x it moves when the fingers open: 1, -1, or 0 for what is no finger.
    """

    group: str
    box: Box
    side: int = 0


def _between(group: str, low: tuple[float, float, float], high: tuple[float, float, float], side: int = 0) -> ArmBox:
    (x0, y0, z0), (x1, y1, z1) = low, high
    return ArmBox(group, Box(((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2), (x1 - x0, y1 - y0, z1 - z0)), side)


FINGER_GAP = 0.018
"""How far apart the two boxes of the fingers are (m) with the gripper as in the URDF."""


ARM_BOXES = (
    _between("arm_1", (-0.132, -0.133, 0.167), (-0.077, 0.094, 0.223)),
    _between("arm_2", (-0.130, -0.146, 0.169), (-0.079, 0.081, 0.221)),
    _between("arm_3", (-0.128, -0.159, 0.171), (-0.081, 0.068, 0.219)),
    _between("arm_4", (-0.126, -0.170, 0.173), (-0.083, 0.055, 0.217)),
    _between("arm_4", (-0.123, -0.170, 0.165), (0.001, -0.118, 0.224)),
    _between("wrist_yaw", (-0.090, -0.163, 0.123), (0.004, -0.100, 0.202)),
    _between("wrist_pitch", (-0.042, -0.178, 0.095), (0.001, -0.124, 0.160)),
    _between("gripper", (-0.048, -0.288, 0.073), (0.005, -0.164, 0.130)),
    _between("gripper", (-0.070, -0.429, 0.105), (-0.030, -0.213, 0.131), side=-1),
    _between("gripper", (-0.012, -0.429, 0.105), (0.027, -0.213, 0.131), side=1),
)
