"""Placing: close in on the goal receptacle, bring the gripper over it, let go, and wait for the fall."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from uniteam.interface import DiscreteAction
from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.manipulation.arm_path import ArmPath, follow, let_go
from uniteam.mind.manipulation.leave_manipulation import fold
from uniteam.mind.manipulation.place.after_release import Lying, Verify, Wait, WaitSteps, take_it_for_placed
from uniteam.mind.manipulation.place.drop_height import Release
from uniteam.mind.manipulation.place.motion import Motion, WholeSteps
from uniteam.mind.manipulation.place.placing_points import ChoosePoints, PlacingPoints
from uniteam.mind.manipulation.place.receptacle_mask import inside_of_mask
from uniteam.mind.manipulation.place.withdraw import lift_and_retract
from uniteam.mind.skills.skill import Skill, discrete, turn_exactly
from uniteam.mind.skills.view import Points, View
from uniteam.stretch import looks_along_arm


@dataclass(frozen=True)
class Stand:
    """Where the robot stands when the arm is to reach out.

    Attributes:
        view: in manipulation mode.
        candidates: where it may put down (base frame).
        surroundings: (N, 3) points (m, base frame) of all that the arm may touch.
        line_up: from the turn (rad) that would bring the arm's line over a point to the turn that the base makes; None
            where it makes none that does.
    """

    view: View
    candidates: PlacingPoints
    surroundings: Points
    line_up: Callable[[float], float | None]

    def but_poor_points(self, least_worth: float) -> "Stand":
        """Return the stand without the candidates of less worth (m)."""
        points, worth = self.candidates.points, self.candidates.worth
        is_good = worth >= least_worth
        return replace(self, candidates=PlacingPoints(points[is_good], worth[is_good]))


@dataclass(frozen=True)
class Aim:
    """The view in manipulation mode, the base's turn (rad) that lines the arm up, and the path that it then follows."""

    view: View
    turn: float
    path: ArmPath


@dataclass(frozen=True)
class PlaceContext:
    """What a strategy of placing needs to know beside the view.

    Attributes:
        load: what the gripper holds.
        choose_points: where a thing can be put.
        receptacle: which points are the goal receptacle's.
        motion: how the base moves.
        release: how it is let go.
        find_path: how the arm gets there.
        generator: of the random choices.
    """

    load: Load
    choose_points: ChoosePoints
    receptacle: Callable[[View], Points]
    motion: Motion
    release: Release
    find_path: "FindPath"
    generator: np.random.Generator


CloseIn = Callable[[View, PlaceContext], Skill[Stand | None]]
"""From where navigation ended to a stand; None where no receptacle is seen."""
FindPath = Callable[[Stand, PlaceContext], Aim | None]
"""From a stand to an aim at one of its candidates; None where the arm reaches none."""
Fallback = Callable[[View, Stand | None, PlaceContext], Skill[Aim]]
"""What to do without an aim, from the last view and the stand if there is one."""


@dataclass(frozen=True)
class PlaceConfig:
    """The strategies of placing.

    Attributes:
        choose_points: where a thing can be put.
        receptacle: which of the points in view are the goal receptacle's.
        motion: in which steps the base moves.
        close_in: how the robot gets from where navigation ended to where the arm reaches.
        find_path: how the arm gets from there over a placing point.
        release: how high and with which wrist the gripper lets go.
        fall_back: what to do where no receptacle is seen or reached.
        attempts: at how many places to try for an aim; at the last one the object is let go without one. The baseline
            has one, `more_attempts` as many as the steps allow.
        last_call: from this step on the next place is the last one.
        least_worth: while there are attempts left, points of less worth (m) are not aimed at.
        leave: how the robot gets back to driving.
        withdraw: what the arm does once it has let go.
        wait: how to wait for the object to come to rest.
        verify: how to find out where it lies then.
    """

    choose_points: ChoosePoints
    close_in: CloseIn
    find_path: FindPath
    release: Release
    fall_back: Fallback
    receptacle: Callable[[View], Points] = inside_of_mask
    motion: Motion = field(default_factory=WholeSteps)
    leave: Callable[[View, str], Skill[View]] = fold
    withdraw: Callable[[View], Skill[View]] = lift_and_retract
    attempts: int = 1
    last_call: float = math.inf
    least_worth: float = -math.inf
    wait: Wait = field(default_factory=WaitSteps)
    verify: Verify = take_it_for_placed

    def context(self, load: Load, generator: np.random.Generator) -> PlaceContext:
        """Return what the strategies need to know to place a load."""
        return PlaceContext(
            load, self.choose_points, self.receptacle, self.motion, self.release, self.find_path, generator
        )


@dataclass(frozen=True)
class PlaceResult:
    """How a place ended.

    Attributes:
        released: whether the object was let go; else there was no aim, and the robot holds it still.
        lying: where it lies, once it was let go and is seen not to be where it should be.
    """

    released: bool
    lying: Lying | None = None


def place(view: View, context: PlaceContext, config: PlaceConfig, is_last: bool) -> Skill[PlaceResult]:
    """Put what the gripper holds on the goal receptacle that the robot faces.

    Args:
        view: in navigation mode, before the receptacle.
        context: what is to be placed, and how.
        config: the strategies.
        is_last: whether it is let go in any case.

    Returns:
        What became of it; in navigation mode where there is something left to do.
    """
    stand = yield from config.close_in(view, context)
    offered = stand if stand is None or is_last else stand.but_poor_points(config.least_worth)
    aim = None if offered is None else context.find_path(offered, context)
    if aim is None and not is_last:
        yield from config.leave(
            view if stand is None else stand.view, "The arm cannot place it from here; I try elsewhere."
        )
        return PlaceResult(released=False)
    if aim is None:
        aim = yield from config.fall_back(view if stand is None else stand.view, stand, context)
    view = yield from turn_exactly(aim.view, aim.turn, "I turn so that the arm's line meets the placing point.")
    view = yield from follow(view, aim.path)
    view = yield from let_go(view)
    view = yield from config.withdraw(view)
    view = yield from config.wait(view)
    lying = yield from config.verify(view)
    if lying is not None:
        yield discrete(DiscreteAction.NAVIGATION_MODE, "It does not lie on the receptacle; I pick it up again.")
    return PlaceResult(released=True, lying=lying)


def enter_manipulation_mode(view: View, reason: str) -> Skill[View]:
    """Point the arm to where the robot faces, unless it looks along the arm already."""
    if looks_along_arm(view.observation.joints):
        return view
    return (yield discrete(DiscreteAction.MANIPULATION_MODE, reason))
