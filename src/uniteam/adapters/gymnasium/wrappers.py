"""Wrappers for what libraries of reinforcement learning expect."""

from typing import Any

import cv2
import gymnasium
import numpy as np
from numpy.typing import NDArray

from uniteam.adapters.gymnasium.sensors import COMPASS, DEPTH, GPS, IS_HOLDING, JOINTS, RGB, joints_of_vector
from uniteam.adapters.state_vector import STATE_NAMES, state_vector
from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose

Spaces = dict[str, gymnasium.Space[Any]]

SHORT_SIDE, LONG_SIDE = 120, 160
"""Of HomeRobot's pictures (pixels), which are upright."""


class ImageAndVector(gymnasium.ObservationWrapper[dict[str, Any], Any, dict[str, Any]]):
    """Stack all pictures as channels of one, and put all else into one vector.

    `image` is (H, W, C) uint8, depth first and in steps of 10 m / 255, then the others by name; `vector` is (N,)
    float32, numbers of classes one-hot. So HomeRobot's policy begins too, and so the policies for several inputs of
    common libraries want it.
    """

    def __init__(self, env: gymnasium.Env[Any, Any]) -> None:
        """Wrap an environment whose observation is a dictionary.

        Raises:
            InvalidInputError: it is none.
        """
        super().__init__(env)
        spaces = _spaces(env)
        images = sorted(
            (name for name, space in spaces.items() if _is_image(space)), key=lambda name: name != DEPTH.name
        )
        self._images = {name: spaces[name] for name in images}
        self._others = {name: space for name, space in spaces.items() if name not in self._images}
        some = next(iter(self._images.values())).shape
        assert some is not None, "a picture has a shape"
        channels = sum(space.shape[2] for space in self._images.values() if space.shape is not None)
        flat = [gymnasium.spaces.flatten_space(space) for space in self._others.values()]
        low, high = (np.concatenate([getattr(box, end) for box in flat]).astype(np.float32) for end in ("low", "high"))
        self.observation_space = gymnasium.spaces.Dict(
            {
                "image": gymnasium.spaces.Box(0, 255, (*some[:2], channels), np.uint8),
                "vector": gymnasium.spaces.Box(low, high, dtype=np.float32),
            }
        )

    def observation(self, observation: dict[str, Any]) -> dict[str, Any]:
        """Return the picture and the vector."""
        pictures = [_as_bytes(observation[name]) for name in self._images]
        flat = [np.asarray(gymnasium.spaces.flatten(s, observation[name])) for name, s in self._others.items()]
        return {"image": np.concatenate(pictures, axis=-1), "vector": np.concatenate(flat).astype(np.float32)}


class SmallPictures(gymnasium.ObservationWrapper[dict[str, Any], Any, dict[str, Any]]):
    """Shrink all pictures of a larger camera to 120 pixels wide and 160 high, by the pixel nearest to each.

    `camera="small"` renders that size at once, which is faster; this is for who looks at the large picture as well.
    """

    def __init__(self, env: gymnasium.Env[Any, Any]) -> None:
        """Wrap an environment whose observation is a dictionary.

        Raises:
            InvalidInputError: it is none.
        """
        super().__init__(env)
        spaces = _spaces(env)
        self._images = [name for name, space in spaces.items() if _is_image(space)]
        self.observation_space = gymnasium.spaces.Dict(
            {name: _shrunk(space) if name in self._images else space for name, space in spaces.items()}
        )

    def observation(self, observation: dict[str, Any]) -> dict[str, Any]:
        """Return the observation with its pictures shrunk."""
        return {**observation, **{name: shrink(observation[name]) for name in self._images}}


class PixelsAndState(gymnasium.ObservationWrapper[dict[str, Any], Any, dict[str, Any]]):
    """Show of the whole task what datasets of demonstrations hold: the head camera and what the robot feels of itself.

    `pixels` has the picture `head`, (H, W, 3) uint8; `agent_pos` is (11,) float32 in the order of
    `uniteam.adapters.state_vector.STATE_NAMES`. So LeRobot looks for them.
    """

    def __init__(self, env: gymnasium.Env[Any, Any]) -> None:
        """Wrap an environment of the whole task.

        Raises:
            InvalidInputError: it is another.
        """
        super().__init__(env)
        spaces, wanted = _spaces(env), (RGB, JOINTS, GPS, COMPASS, IS_HOLDING)
        if lacking := [sensor.name for sensor in wanted if sensor.name not in spaces]:
            raise InvalidInputError(f"this wrapper needs uniteam/OVMM-v0; {', '.join(lacking)} is not observed here")
        state = gymnasium.spaces.Box(-np.inf, np.inf, (len(STATE_NAMES),), np.float32)
        pixels = gymnasium.spaces.Dict({"head": spaces[RGB.name]})
        self.observation_space = gymnasium.spaces.Dict({"pixels": pixels, "agent_pos": state})

    @property
    def task(self) -> str:
        """The instruction, where LeRobot looks for words; it can be sent to another process, which a `Task` cannot."""
        return str(self.get_wrapper_attr("task_description"))

    def observation(self, observation: dict[str, Any]) -> dict[str, Any]:
        """Return the picture and the state."""
        base = BasePose(*map(float, (*observation[GPS.name], *observation[COMPASS.name])))
        joints = joints_of_vector(observation[JOINTS.name])
        state = state_vector(joints, base, bool(observation[IS_HOLDING.name]))
        return {"pixels": {"head": observation[RGB.name]}, "agent_pos": state}


def shrink(picture: NDArray[Any]) -> NDArray[Any]:
    """Return the (160, 120, C) picture of (H, W, C); each pixel is the one nearest to its middle."""
    small = cv2.resize(picture, (SHORT_SIDE, LONG_SIDE), interpolation=cv2.INTER_NEAREST_EXACT)
    return small.reshape(LONG_SIDE, SHORT_SIDE, picture.shape[2])


def _spaces(env: gymnasium.Env[Any, Any]) -> Spaces:
    space = env.observation_space
    if not isinstance(space, gymnasium.spaces.Dict) or not any(_is_image(one) for one in space.spaces.values()):
        raise InvalidInputError(f"this wrapper needs a dictionary with pictures to be observed, got {space}")
    return dict(space.spaces)


def _is_image(space: gymnasium.Space[Any]) -> bool:
    return isinstance(space, gymnasium.spaces.Box) and len(space.shape) == 3


def _shrunk(space: gymnasium.Space[Any]) -> gymnasium.Space[Any]:
    assert isinstance(space, gymnasium.spaces.Box)
    shape = (LONG_SIDE, SHORT_SIDE, space.shape[2])
    return gymnasium.spaces.Box(space.low.min(), space.high.max(), shape, space.dtype.type)


def _as_bytes(picture: NDArray[Any]) -> NDArray[np.uint8]:
    """Return a picture in 0 to 255; one of floats is in 0 to 1."""
    return picture if picture.dtype == np.uint8 else np.asarray(picture * 255.0 + 0.5).astype(np.uint8)
