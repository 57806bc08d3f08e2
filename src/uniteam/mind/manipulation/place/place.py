"""Placing: close in on the goal receptacle, bring the gripper over it, let go, and wait for the fall."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from uniteam.interface import DiscreteAction
from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.manipulation.arm_path import ArmPath, follow, let_go
from uniteam.mind.manipulation.place.drop_height import ReleaseRule
from uniteam.mind.manipulation.place.placing_points import PointRule
from uniteam.mind.skills.skill import Skill, discrete
from uniteam.mind.skills.view import View


@dataclass(frozen=True)
class PlaceTask:
    """What a strategy of placing needs to know beside the view.

    Attributes:
        load: what the gripper holds.
        choose_points: where a thing can be put.
        release: how it is let go.
        generator: of the random choices.
    """

    load: Load
    choose_points: PointRule
    release: ReleaseRule
    generator: np.random.Generator


@dataclass(frozen=True)
class Aim:
    """The view in manipulation mode from which the arm follows a path."""

    view: View
    path: ArmPath


CloseIn = Callable[[View, PlaceTask], Skill[Aim | None]]
"""From where navigation ended to an aim; None where no receptacle is seen or reached."""
Fallback = Callable[[View, PlaceTask], Skill[Aim]]
"""What to do without an aim."""


@dataclass(frozen=True)
class PlaceConfig:
    """The strategies of placing.

    Attributes:
        choose_points: where a thing can be put.
        close_in: how the robot gets from where navigation ended to where the arm reaches.
        release: how high and with which wrist the gripper lets go.
        fall_back: what to do where no receptacle is seen or reached.
        attempts: at how many places to try for an aim; at the last one the object is let go without one.
        rest_steps: how long to wait for the object to come to rest.
    """

    choose_points: PointRule
    close_in: CloseIn
    release: ReleaseRule
    fall_back: Fallback
    attempts: int = 1
    rest_steps: int = 200


def place(view: View, task: PlaceTask, config: PlaceConfig, is_last: bool) -> Skill[bool]:
    """Put what the gripper holds on the goal receptacle that the robot faces.

    Args:
        view: in navigation mode, before the receptacle.
        task: what is to be placed, and how.
        config: the strategies.
        is_last: whether it is let go in any case.

    Returns:
        True once what was let go has come to rest; False, in navigation mode, where there was no aim.
    """
    aim = yield from config.close_in(view, task)
    if aim is None and not is_last:
        yield discrete(DiscreteAction.NAVIGATION_MODE, "The arm cannot place it from here; I try elsewhere.")
        return False
    if aim is None:
        aim = yield from config.fall_back(view, task)
    view = yield from follow(aim.view, aim.path)
    yield from let_go(view, config.rest_steps)
    return True


def enter_manipulation_mode(view: View, reason: str) -> Skill[View]:
    """Point the arm to where the robot faces, unless it looks along the arm already."""
    if view.observation.joints.head_pan < -1.0:
        return view
    return (yield discrete(DiscreteAction.MANIPULATION_MODE, reason))
