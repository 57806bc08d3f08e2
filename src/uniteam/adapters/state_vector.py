"""What the robot feels of itself as a vector of named numbers: joints, base and gripper."""

from dataclasses import astuple, fields

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.interface import Joints

STATE_NAMES = (
    *(f"{field.name}.pos" for field in fields(Joints)),
    "base_x.pos",
    "base_y.pos",
    "base_heading.pos",
    "gripper.holding",
)
"""Of the numbers, in their order: joints (m, rad), the base in the start frame (m, rad), and 1 where it holds."""


def state_vector(joints: Joints, base_to_start: BasePose, is_holding: bool) -> NDArray[np.float32]:
    """Return the (11,) numbers in the order of `STATE_NAMES`."""
    base = base_to_start
    return np.array([*astuple(joints), base.x, base.y, base.heading, float(is_holding)], np.float32)
