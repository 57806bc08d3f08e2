"""The agent that baseline and UniTeam are: perception, map and machine, with the values of a configuration."""

from functools import partial

import numpy as np

from uniteam.geometry import BasePose
from uniteam.interface import Decision, Instruction, MapOverlay, Observation, Perception, Segmentation
from uniteam.mind.agents.blackboard import Memory
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.agents.map_overlay import draw_overlay
from uniteam.mind.agents.state_machine import State, decide
from uniteam.mind.skills.view import View
from uniteam.timing import section

_NOWHERE = Instruction("", "", "")


class HeuristicAgent:
    """Decides by the state machine of `machine.py`.

    Attributes:
        config: its values and strategies.
    """

    def __init__(self, config: AgentConfig, perception: Perception) -> None:
        """Take the values and the eyes."""
        self.config = config
        self._perception = perception
        self.reset(_NOWHERE, seed=0)

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Forget everything and take a new instruction."""
        self._memory = Memory.fresh(instruction, self.config, seed)
        self._state = State.LOOK_AROUND

    def act(self, observation: Observation) -> Decision:
        """Look, remember, decide."""
        memory = self._memory
        with section("perception"):
            segmentation = self._perceive(observation)
        if _is_driving(observation):
            with section("map"):
                memory.bird_map.update(observation, segmentation, memory.roles)
        memory.goal = memory.plan = None
        view = View(observation, segmentation, memory.instruction)
        self._state, step = decide(self._state, memory, view)
        overlay = partial(self._overlay, observation.base_to_start)
        return Decision(step.action, self._state.value, step.reason, segmentation, overlay)

    def _overlay(self, base: BasePose) -> MapOverlay:
        memory = self._memory
        return draw_overlay(memory.bird_map, base, memory.goal, memory.plan)

    def _perceive(self, observation: Observation) -> Segmentation:
        instruction = self._memory.instruction
        segmentation = self._perception(observation, instruction)
        for believe in self.config.filters:
            segmentation = believe(segmentation, observation, instruction)
        return segmentation


def _is_driving(observation: Observation) -> bool:
    """Whether the robot is in navigation posture; seen from elsewhere, the arm itself would be mapped."""
    return bool(np.hypot(observation.joints.head_pan, observation.joints.arm) < 0.05)
