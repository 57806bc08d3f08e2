"""What an agent knows in the course of one episode."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from uniteam.interface import Instruction
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.manipulation.pick.pick import object_of_unknown_size
from uniteam.mind.manipulation.place.place import PlaceContext
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.mapping.class_role import RoleScores, role_scores
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.navigation.goals.failed_attempts import Miss, Misses, nowhere
from uniteam.mind.navigation.goals.goal_or_frontier import Commitment
from uniteam.mind.navigation.planning.planner import Plan, Planner
from uniteam.mind.skills.skill import Skill


@dataclass
class Memory:
    """What the machine's states share; made anew for each episode.

    Attributes:
        instruction: what is asked.
        config: the agent's values and strategies.
        generator: of every random choice.
        bird_map: what was seen.
        planner: how to drive there.
        commitment: whether to keep heading there.
        roles: which role a detection plays.
        turns: how many turns the robot has looked around with at first.
        idle_turns: how many turns it has made in a row because nothing was left to head for.
        detour: the steps aside that are under way while something is searched for.
        skill: the pick or the place that is under way.
        attempt: where the pick or the place that is under way began.
        load: what the gripper is believed to hold.
        object_misses, place_misses: where a pick or a place is known to have failed.
        goal, plan: what the robot heads for in this step, for the overlay; None where it does not drive.
    """

    instruction: Instruction
    config: AgentConfig
    generator: np.random.Generator
    bird_map: BirdsEyeMap
    planner: Planner
    commitment: Commitment
    roles: RoleScores
    turns: int = 0
    idle_turns: int = 0
    detour: Skill[None] | None = None
    skill: Skill[Any] | None = None
    attempt: Miss = field(default_factory=nowhere)
    load: Load = field(default_factory=object_of_unknown_size)
    object_misses: Misses = field(default_factory=Misses)
    place_misses: Misses = field(default_factory=Misses)
    goal: Goal | None = None
    plan: Plan | None = None

    @staticmethod
    def fresh(instruction: Instruction, config: AgentConfig, seed: int) -> "Memory":
        """Return the memory at the beginning of an episode."""
        return Memory(
            instruction,
            config,
            np.random.default_rng(seed),
            BirdsEyeMap(config.map),
            Planner(config.planner),
            Commitment(config.is_stuck, config.search.frontier),
            role_scores(instruction),
        )

    def place_context(self) -> PlaceContext:
        """Return what placing needs to know."""
        return self.config.place.context(self.load, self.generator)
