"""The whole task of uniteam as an environment of LeRobot, which finds this package by its name."""

from lerobot_env_uniteam.config import UniteamEnv
from lerobot_env_uniteam.registration import GYM_ID, register

__all__ = ["GYM_ID", "UniteamEnv", "register"]

register()
