"""Driving through a world of boxes with the mind's map and planner."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from worlds.box_world import Box, move, observe

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import DiscreteAction, Instruction
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.mapping.map_config import MapConfig
from uniteam.mind.mapping.projection import exact_pixels
from uniteam.mind.mapping.visited import mark_line
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.navigation.goals.exploration import ChooseGoal, plan_first
from uniteam.mind.navigation.goals.goal_or_frontier import Commitment
from uniteam.mind.navigation.planning.plan import Plan
from uniteam.mind.navigation.planning.planner import Planner
from uniteam.mind.navigation.planning.planner_config import PlannerConfig, turn_in_steps
from uniteam.mind.navigation.planning.traversible import OWN_CELLS
from uniteam.mind.perception.vocabulary import role_scores

SMALL_CAMERA = PinholeCamera.from_horizontal_fov(120, 160, math.radians(42.0))
EXACT_MAP = MapConfig(project=exact_pixels, mark_visited=mark_line)
EXACT_PLANNER = PlannerConfig(tolerance=0.10, patience=(0.25,), own_cells=OWN_CELLS, face=turn_in_steps)
INSTRUCTION = Instruction("cup", "table", "bed")


@dataclass
class Drive:
    """A robot in a world of boxes, with all that it remembers; `trail` holds where it stood at each step."""

    boxes: tuple[Box, ...]
    base: BasePose
    bird_map: BirdsEyeMap
    planner: Planner
    commitment: Commitment = field(default_factory=Commitment)
    trail: list[BasePose] = field(default_factory=list)
    blocked: int = 0

    @staticmethod
    def begin(
        boxes: tuple[Box, ...],
        base: BasePose,
        planner: PlannerConfig | None = None,
        map_config: MapConfig | None = None,
    ) -> "Drive":
        """Look once around from a base pose."""
        drive = Drive(boxes, base, BirdsEyeMap(map_config or EXACT_MAP), Planner(planner or EXACT_PLANNER))
        for _ in range(12):
            drive.look()
            drive.base = drive.base.compose(BasePose(0.0, 0.0, math.radians(30.0)))
        drive.look()
        return drive

    def look(self) -> None:
        """Bring the present view into the map."""
        observation = observe(self.boxes, self.base, SMALL_CAMERA)
        assert observation.truth is not None
        self.bird_map.update(observation, observation.truth, role_scores(INSTRUCTION))

    def step(self, choices: Sequence[ChooseGoal]) -> tuple[Goal, Plan] | None:
        """Plan, move and look; return what was planned."""
        found = plan_first(self.planner, self.bird_map, self.base, self.commitment.choices(choices))
        if found is None or not self.planner.leads_on(found[1]):
            found = None
        else:
            self.planner.begin(found[1], self.bird_map, self.base)
            self.commitment.follow(self.base, found[1])
            after = move(self.boxes, self.base, found[1].action)
            self.blocked += found[1].action is DiscreteAction.MOVE_FORWARD and after == self.base
            self.trail.append(self.base)
            self.base = after
            self.look()
        return found

    def run(
        self, choices: Sequence[ChooseGoal], steps: int, until: Callable[[Goal, Plan], bool] | None = None
    ) -> tuple[Goal, Plan] | None:
        """Go on for some steps, or until nothing is left, or a condition holds; return the last goal and plan."""
        found = None
        for _ in range(steps):
            found = self.step(choices)
            if found is None or (until is not None and until(*found)):
                break
        return found


def arrived(goal: Goal, plan: Plan) -> bool:
    """Whether the plan has nothing left to do."""
    return plan.reached
