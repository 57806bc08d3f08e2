"""Stand-ins for the classes of `home_robot.core.interfaces` that an adapter meets, after their published form."""

import sys
from dataclasses import dataclass
from enum import Enum
from types import ModuleType
from typing import Any

import numpy as np
import pytest

_NAMES = (
    "STOP MOVE_FORWARD TURN_LEFT TURN_RIGHT PICK_OBJECT PLACE_OBJECT NAVIGATION_MODE MANIPULATION_MODE POST_NAV_MODE "
    "EXTEND_ARM EMPTY_ACTION SNAP_OBJECT DESNAP_OBJECT OPEN_GRIPPER CLOSE_GRIPPER"
)

DiscreteNavigationAction = Enum("DiscreteNavigationAction", _NAMES, start=0)  # type: ignore[misc]


class ContinuousNavigationAction:
    def __init__(self, xyt: Any) -> None:
        self.xyt = np.asarray(xyt)


class ContinuousFullBodyAction:
    def __init__(self, joints: Any, xyt: Any = None) -> None:
        self.joints, self.xyt = np.asarray(joints), xyt


@dataclass
class Observations:
    gps: np.ndarray
    compass: np.ndarray
    rgb: np.ndarray
    depth: np.ndarray
    xyz: np.ndarray | None = None
    semantic: np.ndarray | None = None
    third_person_image: np.ndarray | None = None
    camera_pose: np.ndarray | None = None
    joint: np.ndarray | None = None
    relative_resting_position: np.ndarray | None = None
    is_holding: np.ndarray | None = None
    task_observations: dict[str, Any] | None = None


CLASSES = (DiscreteNavigationAction, ContinuousNavigationAction, ContinuousFullBodyAction, Observations)


def put_in_place(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have `import home_robot.core.interfaces` find the stand-ins."""
    for name in ("home_robot", "home_robot.core", "home_robot.core.interfaces"):
        monkeypatch.setitem(sys.modules, name, ModuleType(name))
    for one in CLASSES:
        setattr(sys.modules["home_robot.core.interfaces"], one.__name__, one)
