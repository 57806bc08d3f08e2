"""The agent that baseline and UniTeam are: perception, map and machine, with the values of a configuration."""

from typing import NoReturn

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose
from uniteam.interface import Decision, Explanation, Instruction, Observation, Perception, Segmentation
from uniteam.mind.agents.blackboard import Blackboard
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.agents.map_overlay import draw_overlay
from uniteam.mind.agents.state_machine import StateMachine
from uniteam.mind.skills.view import View
from uniteam.stretch import is_navigation_posture
from uniteam.timing import section

_NOWHERE = Instruction("", "", "")


class HeuristicAgent:
    """Decides by the state machine of `state_machine.py`.

    Attributes:
        config: its values and strategies.
    """

    def __init__(self, config: AgentConfig, perception: Perception) -> None:
        """Prepare the agent; `reset` begins an episode."""
        self.config = config
        self._perception = perception
        self._begin(_NOWHERE, seed=0)

    def __reduce__(self) -> NoReturn:
        """Refuse to be copied or sent: a running skill cannot."""
        raise TypeError(
            "a HeuristicAgent cannot be pickled, for it may be in the midst of a skill; send its AgentConfig or "
            "AgentSpec instead, and make the agent there"
        )

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Forget everything and take a new instruction."""
        self._perception.reset(instruction, seed)
        self._begin(instruction, seed)

    def _begin(self, instruction: Instruction, seed: int) -> None:
        self._base = BasePose(0.0, 0.0, 0.0)
        self._explained: Segmentation | None = None
        self._board = Blackboard.fresh(instruction, self.config, seed)
        self._machine = StateMachine()
        self._remember = self.config.remember()

    def act(self, observation: Observation) -> Decision:
        """Look, remember, decide."""
        board = self._board
        with section("perception"):
            segmentation = self._perceive(observation)
        if is_navigation_posture(observation.joints):
            with section("map"):
                board.bird_map.update(observation, segmentation, board.roles)
        board.goal = board.plan = None
        state, move = self._machine.decide(board, View(observation, segmentation, board.instruction))
        self._base, self._explained = observation.base_to_start, segmentation
        return Decision(move.action, state.value, move.reason)

    @property
    def board(self) -> Blackboard:
        """What it knows of the episode, for those who draw it: to be read, not changed."""
        return self._board

    def explain(self) -> Explanation:
        """Return what was seen, the map and the plan behind the last decision."""
        board = self._board
        return Explanation(self._explained, draw_overlay(board.bird_map, self._base, board.goal, board.plan))

    def _perceive(self, observation: Observation) -> Segmentation:
        instruction = self._board.instruction
        segmentation = self._perception.perceive(observation)
        if segmentation.instances.shape != observation.depth.shape:
            raise InvalidInputError(
                f"perception {type(self._perception).__name__} gave a segmentation of {segmentation.instances.shape} "
                f"for a frame of {observation.depth.shape}; resize its instances to the frame, by nearest neighbour"
            )
        segmentation = self._remember(segmentation, observation, instruction)
        for believe in self.config.filters:
            segmentation = believe(segmentation, observation, instruction)
        return segmentation
