"""What an agent knows in the course of one episode."""

from dataclasses import dataclass, field

import numpy as np

from uniteam.geometry import BasePose, Point2
from uniteam.interface import Instruction
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.manipulation.place.after_release import Lying
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.navigation.goals.exploration import SearchConfig
from uniteam.mind.navigation.goals.failed_attempts import Misses
from uniteam.mind.navigation.goals.failed_goals import FailedGoals
from uniteam.mind.navigation.goals.goal_or_frontier import Commitment
from uniteam.mind.navigation.planning.plan import Plan
from uniteam.mind.navigation.planning.planner import Planner
from uniteam.mind.perception.vocabulary import RoleScores, role_scores


@dataclass
class Blackboard:
    """What the skills of one episode share.

    Attributes:
        instruction: what is asked.
        config: the agent's values and strategies.
        generator: of every random choice.
        bird_map: what was seen.
        planner: how to drive there.
        commitment: whether to keep heading there.
        roles: which role a detection plays.
        search: what to head for.
        failed_goals: places that could not be reached.
        object_misses, place_misses: where a pick or a place is known to have failed.
        heading_for: (x, y) where the last plan led (m, start frame).
        blocked: how many motions in a row had been blocked when that plan began.
        rounds: how often something was forgotten for want of anything to head for.
        turned_at: where the robot last turned all the way round for want of anything to head for (start frame).
        lying: where the object was seen to lie after it was let go, until it is picked up again.
        falls: how often that was.
        looked_again: what was looked at from another side (m, start frame).
        goal, plan: what the robot heads for in this step, for the overlay; None where it does not drive.
    """

    instruction: Instruction
    config: AgentConfig
    generator: np.random.Generator
    bird_map: BirdsEyeMap
    planner: Planner
    commitment: Commitment
    roles: RoleScores
    search: SearchConfig
    failed_goals: FailedGoals
    object_misses: Misses = field(default_factory=Misses)
    place_misses: Misses = field(default_factory=Misses)
    heading_for: tuple[float, float] | None = None
    blocked: int = 0
    rounds: int = 0
    turned_at: BasePose | None = None
    lying: Lying | None = None
    falls: int = 0
    looked_again: list[Point2] = field(default_factory=list)
    goal: Goal | None = None
    plan: Plan | None = None

    @staticmethod
    def fresh(instruction: Instruction, config: AgentConfig, seed: int) -> "Blackboard":
        """Return what is known at the beginning of an episode: nothing but what is asked."""
        return Blackboard(
            instruction,
            config,
            np.random.default_rng(seed),
            BirdsEyeMap(config.map),
            config.make_planner(config.planner),
            Commitment(config.is_stuck, config.search.frontier),
            role_scores(instruction),
            config.search,
            config.failed_goals(),
        )
