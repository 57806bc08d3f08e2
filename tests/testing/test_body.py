"""A body that breaks a promise is told which, and after which step."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from uniteam.errors import InvalidActionError
from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Action, DiscreteAction, Observation
from uniteam.stretch import NAVIGATION_POSTURE
from uniteam.testing import CheckFailedError, check_body
from uniteam.world.task.check_action import checked_action

CAMERA = PinholeCamera.from_horizontal_fov(8, 6, math.radians(42.0))


class Cart:
    """Drives along a line before a wall, and keeps its promises."""

    def __init__(self) -> None:
        self.x, self.count = 0.0, 0

    def reset(self) -> Observation:
        self.x, self.count = 0.0, 0
        return self.look()

    def step(self, action: Action) -> Observation:
        if checked_action(action) is DiscreteAction.MOVE_FORWARD:
            self.x += 0.25
        self.count += 1
        return self.look()

    def look(self) -> Observation:
        pose = BasePose(self.x, 0.0, 0.0)
        rgb, depth = np.full((6, 8, 3), 90, np.uint8), np.full((6, 8), 3.0 - self.x, np.float32)
        transform = pose.matrix()
        for array in (rgb, depth, transform):
            array.flags.writeable = False
        return Observation(rgb, depth, CAMERA, transform, pose, NAVIGATION_POSTURE, False, self.count)


class DoublePrecision(Cart):
    def look(self) -> Observation:
        seen = super().look()
        return replace(seen, depth=seen.depth.astype(np.float64))


class OpenArrays(Cart):
    def look(self) -> Observation:
        seen = super().look()
        return replace(seen, rgb=seen.rgb.copy())


class NeverResets(Cart):
    def reset(self) -> Observation:
        self.count = 0
        return replace(self.look(), base_to_start=BasePose(0.0, 0.0, 0.0))


class WornOut(Cart):
    """Sees less well the more it has moved, ever."""

    def __init__(self) -> None:
        super().__init__()
        self.moves = 0

    def look(self) -> Observation:
        self.moves += 1
        return replace(super().look(), is_holding=self.moves > 20)


class Noisy(Cart):
    def look(self) -> Observation:
        seen = super().look()
        noise = np.random.default_rng().random(seen.depth.shape).astype(np.float32)
        noise.flags.writeable = False
        return replace(seen, depth=noise)


class MovesFirst(Cart):
    """Looks at what it was asked for once it has done it."""

    def step(self, action: Action) -> Observation:
        self.x += 0.01
        return super().step(action)


class TakesAnything(Cart):
    def step(self, action: Action) -> Observation:
        try:
            return super().step(action)
        except InvalidActionError:
            return super().step(DiscreteAction.EMPTY_ACTION)


class Falls(Cart):
    """Takes for granted that it is given an action."""

    def step(self, action: Action) -> Observation:
        return super().step(action if hasattr(action, "__dataclass_fields__") else DiscreteAction[action.name])


class OneBuffer(Cart):
    """Hands out the same array again and again, locked only for others."""

    def __init__(self) -> None:
        super().__init__()
        self.buffer = np.zeros((6, 8), np.float32)

    def look(self) -> Observation:
        self.buffer[:] = 3.0 - self.x
        view = self.buffer.view()
        view.flags.writeable = False
        return replace(super().look(), depth=view)


def looking(**changes: Any) -> type[Cart]:
    """Return a cart whose observations are changed."""

    class Changed(Cart):
        def look(self) -> Observation:
            return replace(super().look(), **changes)

    return Changed


def locked(array: Any) -> Any:
    array.flags.writeable = False
    return array


def test_a_sound_body_passes() -> None:
    check_body(Cart)


@pytest.mark.parametrize(
    ("body", "sentence"),
    [
        (DoublePrecision, r"reset\(\) raised InvalidInputError: depth must be float32 in metres, got float64"),
        (OpenArrays, r"reset\(\) returned an observation whose rgb can be written into"),
        (
            NeverResets,
            r"reset\(\) does not bring the body back .*\(observation\.depth after reset\(\)\)",
        ),
        (WornOut, r"reset\(\) does not bring the body back .*observation\.is_holding after step 6"),
        (Noisy, r"two bodies made alike.*\(observation\.depth after reset\(\)\)"),
        (MovesFirst, r"a step that was refused has changed something \(observation\.depth after step 1, .*TURN_LEFT"),
        (TakesAnything, r"step\(None\) must raise InvalidActionError, but was done"),
        (Falls, r"step\(None\) must raise InvalidActionError, but raised AttributeError"),
        (OneBuffer, r"observation\.depth, which reset\(\) returned, was changed afterwards"),
        (looking(step=0), r"step 1, .*TURN_LEFT, returned an observation whose step is 0; it must be 1"),
        (looking(base_to_start=BasePose(1.0, 0.0, 0.0)), r"after reset\(\) the base is at the origin"),
        (looking(base_to_start=BasePose(math.nan, 0.0, 0.0)), "base_to_start or joints are not finite"),
        (looking(joints=replace(NAVIGATION_POSTURE, lift=9.0)), "joint lift is at 9, beyond .*JOINT_LIMITS"),
        (looking(camera_to_start=locked(np.eye(3))), r"a camera_to_start of \(3, 3\) float64"),
        (looking(camera_to_start=locked(2.0 * np.eye(4))), "a camera_to_start that is no rigid transform"),
        (lambda: None, r"reset\(\) raised AttributeError"),
    ],
)
def test_a_body_that_breaks_a_promise_is_told_which(body: Any, sentence: str) -> None:
    with pytest.raises(CheckFailedError, match=sentence):
        check_body(body)
