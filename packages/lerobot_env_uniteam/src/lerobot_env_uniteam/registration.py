"""The name under which Gymnasium makes the environment."""

import gymnasium
from gymnasium.envs.registration import WrapperSpec

_ROOM = "uniteam.adapters.gymnasium"
GYM_ID = "lerobot_env_uniteam/OVMM-v0"


def register() -> None:
    """Make the environment known to Gymnasium, if it is not: it shows and takes what datasets hold."""
    if GYM_ID not in gymnasium.registry:
        shown = WrapperSpec("PixelsAndState", f"{_ROOM}.wrappers:PixelsAndState", {})
        gymnasium.register(GYM_ID, f"{_ROOM}.ovmm_env:OvmmEnv", additional_wrappers=(shown,))
