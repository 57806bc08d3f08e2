"""What is wrong with an observation of a body, beyond what `Observation` itself refuses."""

from dataclasses import astuple, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import Joints, Observation
from uniteam.stretch import JOINT_LIMITS

_SLACK = 1e-6


def observation_problem(observation: object, step: int) -> str:
    """Return what keeps something from being what a body returns after `step` steps; empty where nothing does."""
    if not isinstance(observation, Observation):
        kind = "None" if observation is None else f"a {type(observation).__name__}"
        return f"{kind}, not an Observation"
    numbers = (*astuple(observation.base_to_start), *astuple(observation.joints))
    if observation.step != step:
        return f"an observation whose step is {observation.step}; it must be {step}"
    if not np.isfinite(numbers).all():
        return "an observation whose base_to_start or joints are not finite"
    if step == 0 and np.abs(numbers[:3]).max() > _SLACK:
        return f"{observation.base_to_start}; after reset() the base is at the origin of the start frame"
    return (
        _joint_problem(observation.joints)
        or _transform_problem(observation.camera_to_start)
        or _writable_problem(observation)
    )


def _joint_problem(joints: Joints) -> str:
    low, high = JOINT_LIMITS
    for name in (field.name for field in fields(Joints)):
        position = getattr(joints, name)
        if not getattr(low, name) - _SLACK <= position <= getattr(high, name) + _SLACK:
            return f"an observation whose joint {name} is at {position:g}, beyond uniteam.stretch.JOINT_LIMITS"
    return ""


def _transform_problem(camera_to_start: NDArray[np.float64]) -> str:
    if camera_to_start.shape != (4, 4) or camera_to_start.dtype != np.float64:
        return f"a camera_to_start of {camera_to_start.shape} {camera_to_start.dtype}; it must be (4, 4) float64"
    rotation = camera_to_start[:3, :3]
    is_rotation = np.abs(rotation @ rotation.T - np.eye(3)).max() < _SLACK and np.linalg.det(rotation) > 0.0
    if not is_rotation or not np.array_equal(camera_to_start[3], (0.0, 0.0, 0.0, 1.0)):
        return "a camera_to_start that is no rigid transform"
    return ""


def _writable_problem(observation: Observation) -> str:
    arrays: dict[str, NDArray[Any]] = {
        "rgb": observation.rgb,
        "depth": observation.depth,
        "camera_to_start": observation.camera_to_start,
        "truth": observation.camera_to_start if observation.truth is None else observation.truth.instances,
    }
    writable = next((name for name, array in arrays.items() if array.flags.writeable), None)
    if writable is None:
        return ""
    return f"an observation whose {writable} can be written into; give it array.flags.writeable = False"
