"""A Hello Robot Stretch as a robot of LeRobot, which finds this package by its name."""

from lerobot_robot_uniteam_stretch.config_uniteam_stretch import UniteamStretchConfig
from lerobot_robot_uniteam_stretch.uniteam_stretch import UniteamStretch

__all__ = ["UniteamStretch", "UniteamStretchConfig"]
