"""Whether to keep heading for the goal, or to leave it for a frontier when that leads nowhere."""

import math
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from uniteam.geometry import BasePose
from uniteam.grid import draw_disc
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.navigation.goals.exploration import ChooseGoal, any_frontier
from uniteam.mind.navigation.planning.plan import Plan

Trail = Sequence[BasePose]
"""Where the base was (start frame) at each step since it set out for what it heads for, the latest last."""


_HEADING_BIN = math.radians(30.0)


def never_stuck(trail: Trail) -> bool:
    """Whatever happens, keep heading for the goal: the baseline commits to it."""
    return False


@dataclass(frozen=True)
class StuckDetector:
    """Notices that progress has stalled or that the robot oscillates: UniTeam's `goal_or_frontier`.

    Attributes:
        stall_steps, stall_radius: so many steps within so small a disc (m) are a stall.
        oscillation_steps: how far back to look for poses that return.
        returns: so many returns to one pose (within 0.1 m and 15 degrees) are an oscillation.
    """

    stall_steps: int = 24
    stall_radius: float = 0.5
    oscillation_steps: int = 60
    returns: int = 3

    def __call__(self, trail: Trail) -> bool:
        """Return whether the robot is stuck."""
        return self._has_stalled(trail) or self._oscillates(trail)

    def _has_stalled(self, trail: Trail) -> bool:
        recent = trail[-self.stall_steps :]
        if len(recent) < self.stall_steps:
            return False
        return all(recent[0].distance_to(base.x, base.y) <= self.stall_radius for base in recent)

    def _oscillates(self, trail: Trail) -> bool:
        poses = [_pose_bin(base) for base in trail[-self.oscillation_steps :]]
        arrivals = Counter(now for before, now in pairwise(poses) if now != before)
        return max(arrivals.values(), default=0) > self.returns


def _pose_bin(base: BasePose) -> tuple[int, int, int]:
    return round(base.x / 0.1), round(base.y / 0.1), round(base.heading / _HEADING_BIN) % 12


@dataclass
class Commitment:
    """What the robot has committed itself to in the course of an episode.

    Attributes:
        is_stuck: when to turn away from it.
        frontier: what it turns to then.
        detour_steps: for how many steps the frontier then comes first.
        avoid_radius: frontiers this near (m) to where a goal was left are avoided.
        trail: see `Trail`.
        left: (x, y) of the places (m, start frame) that the robot was stuck on its way to.
        detour_left: how many steps the present detour still has; 0 when there is none.
    """

    is_stuck: Callable[[Trail], bool] = never_stuck
    frontier: ChooseGoal = any_frontier
    detour_steps: int = 40
    avoid_radius: float = 0.75
    trail: list[BasePose] = field(default_factory=list)
    left: list[tuple[float, float]] = field(default_factory=list)
    detour_left: int = 0

    def choices(self, choices: Sequence[ChooseGoal]) -> tuple[ChooseGoal, ...]:
        """Return what to try in order: the choices themselves, or in a detour the frontiers elsewhere first."""
        return (self._frontier_elsewhere, *choices) if self.detour_left > 0 else tuple(choices)

    def follow(self, base: BasePose, plan: Plan) -> bool:
        """Note a step of a plan; return whether the robot is stuck, which begins a detour."""
        self.trail.append(base)
        if self.detour_left > 0:
            self.detour_left -= 1
            if self.detour_left == 0:
                self.trail.clear()
        is_stuck = self.is_stuck(self.trail)
        if is_stuck:
            x, y = plan.path[-1]
            self.left.append((float(x), float(y)))
            self.detour_left = self.detour_steps
            self.trail.clear()
        return is_stuck

    def set_out(self) -> None:
        """Begin anew: something else than driving happened, or something else is searched for."""
        self.trail.clear()
        self.detour_left = 0

    def _frontier_elsewhere(self, bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
        goal = self.frontier(bird_map, base)
        if goal is None:
            return None
        cells = goal.cells.copy()
        for x, y in self.left:
            draw_disc(cells, bird_map.to_cell(x, y), round(self.avoid_radius / bird_map.cell_size), value=False)
        return Goal(goal.kind, cells, goal.distance) if cells.any() else None
