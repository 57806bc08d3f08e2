"""The agent that baseline and UniTeam are: perception, map and machine, with the values of a configuration."""

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose
from uniteam.interface import Decision, Explanation, Instruction, Observation, Perception, Segmentation
from uniteam.mind.agents.blackboard import Memory
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.agents.map_overlay import draw_overlay
from uniteam.mind.agents.state_machine import State, decide
from uniteam.mind.skills.view import View
from uniteam.stretch import is_navigation_posture
from uniteam.timing import section

_NOWHERE = Instruction("", "", "")


class HeuristicAgent:
    """Decides by the state machine of `machine.py`.

    Attributes:
        config: its values and strategies.
    """

    def __init__(self, config: AgentConfig, perception: Perception) -> None:
        """Prepare the agent; `reset` begins an episode."""
        self.config = config
        self._perception = perception
        self._begin(_NOWHERE, seed=0)

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Forget everything and take a new instruction."""
        self._perception.reset(instruction, seed)
        self._begin(instruction, seed)

    def _begin(self, instruction: Instruction, seed: int) -> None:
        self._base = BasePose(0.0, 0.0, 0.0)
        self._explained: Segmentation | None = None
        self._memory = Memory.fresh(instruction, self.config, seed)
        self._state = State.LOOK_AROUND

    def act(self, observation: Observation) -> Decision:
        """Look, remember, decide."""
        memory = self._memory
        with section("perception"):
            segmentation = self._perceive(observation)
        if is_navigation_posture(observation.joints):
            with section("map"):
                memory.bird_map.update(observation, segmentation, memory.roles)
        memory.goal = memory.plan = None
        view = View(observation, segmentation, memory.instruction)
        self._state, step = decide(self._state, memory, view)
        self._base, self._explained = observation.base_to_start, segmentation
        return Decision(step.action, self._state.value, step.reason)

    def explain(self) -> Explanation:
        """Return what was seen, the map and the plan behind the last decision."""
        memory = self._memory
        return Explanation(self._explained, draw_overlay(memory.bird_map, self._base, memory.goal, memory.plan))

    def _perceive(self, observation: Observation) -> Segmentation:
        instruction = self._memory.instruction
        segmentation = self._perception.perceive(observation)
        if segmentation.instances.shape != observation.depth.shape:
            raise InvalidInputError(
                f"perception {type(self._perception).__name__} gave a segmentation of {segmentation.instances.shape} "
                f"for a frame of {observation.depth.shape}; resize its instances to the frame, by nearest neighbour"
            )
        for believe in self.config.filters:
            segmentation = believe(segmentation, observation, instruction)
        return segmentation
