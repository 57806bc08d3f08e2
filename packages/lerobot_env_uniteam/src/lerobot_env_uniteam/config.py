"""What LeRobot is told of the environment: `--env.type=uniteam`."""

from dataclasses import dataclass, field
from typing import Any

from lerobot.configs import FeatureType, PolicyFeature
from lerobot.envs.configs import EnvConfig
from lerobot.utils.constants import ACTION, OBS_IMAGES, OBS_STATE

from lerobot_env_uniteam.registration import GYM_ID
from uniteam.adapters.action_vector import ACTION_NAMES
from uniteam.adapters.lerobot.layout import FRAMES_PER_SECOND
from uniteam.adapters.state_vector import STATE_NAMES
from uniteam.stretch import HEAD_CAMERA_FULL, HEAD_CAMERA_HALF
from uniteam.world.task.episode import MAXIMUM_STEPS

_CAMERAS = {"half": HEAD_CAMERA_HALF, "full": HEAD_CAMERA_FULL}


@EnvConfig.register_subclass("uniteam")
@dataclass
class UniteamEnv(EnvConfig):
    """The whole task of the challenge in generated homes.

    Attributes:
        task: the only one there is.
        fps: how many steps are counted as a second, as datasets have it.
        split: a split's name, or a file of episodes.
        camera: "half" is 240 x 320 pixels, "full" 480 x 640.
        grasp: rule by which the gripper takes objects: "challenge" or "honest".
        episode_length: after so many steps an episode is over.
    """

    task: str | None = "OVMM-v0"
    fps: int = FRAMES_PER_SECOND
    split: str = "val"
    camera: str = "half"
    grasp: str = "challenge"
    episode_length: int = MAXIMUM_STEPS
    features: dict[str, PolicyFeature] = field(default_factory=dict)
    features_map: dict[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Tell the features, whose pictures depend on the camera; raises ValueError for one that there is not."""
        if self.camera not in _CAMERAS:
            raise ValueError(f"there is no camera '{self.camera}'; there are {', '.join(_CAMERAS)}")
        camera = _CAMERAS[self.camera]
        self.features = {
            ACTION: PolicyFeature(FeatureType.ACTION, (len(ACTION_NAMES),)),
            "agent_pos": PolicyFeature(FeatureType.STATE, (len(STATE_NAMES),)),
            "pixels/head": PolicyFeature(FeatureType.VISUAL, (camera.height, camera.width, 3)),
        }
        self.features_map = {ACTION: ACTION, "agent_pos": OBS_STATE, "pixels/head": f"{OBS_IMAGES}.head"}

    @property
    def package_name(self) -> str:
        """What registers the environment."""
        return "lerobot_env_uniteam"

    @property
    def gym_id(self) -> str:
        """Its name for Gymnasium."""
        return GYM_ID

    @property
    def gym_kwargs(self) -> dict[str, Any]:
        """What `gymnasium.make` is given."""
        return {
            "split": self.split,
            "camera": self.camera,
            "grasp": self.grasp,
            "actions": "metric",
            "render_mode": "rgb_array",
            "max_episode_steps": self.episode_length,
        }
