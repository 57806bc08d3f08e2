"""Gymnasium environments of the whole task and of each of its skills; importing this registers them.

import gymnasium
import uniteam.adapters.gymnasium

env = gymnasium.make("uniteam/NavigateToObject-v0", split="train")
"""

from uniteam.adapters.gymnasium.registration import ENVIRONMENTS, register

__all__ = ["ENVIRONMENTS", "register"]

register()
