"""Bring an agent of your own: it wanders where there is room, and stops before the object if it comes across it.

uniteam evaluate --agents baseline bring_an_agent:Wanderer
uniteam run --agent bring_an_agent:Wanderer --video wanderer.mp4
"""

import numpy as np

from uniteam import AgentContext, BasePose, Decision, DiscreteAction, Instruction, Observation

ROOM_AHEAD = 0.8
"""m; nearer than this, something is in the way."""
TURNS = [DiscreteAction.TURN_LEFT, DiscreteAction.TURN_RIGHT]


class Wanderer:
    """Drives straight on, and turns to a random side where something is in the way."""

    def __init__(self, context: AgentContext) -> None:
        """Take the perception that the run asks for; an agent that sees for itself needs no `__init__`."""
        self.perception = context.make_perception()

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Begin an episode; all that is random comes from its seed."""
        self.wanted = instruction.object_category
        self.perception.reset(instruction, seed)
        self.generator = np.random.default_rng(seed)
        self.turn = TURNS[0]
        self.stood: BasePose | None = None

    def act(self, observation: Observation) -> Decision:
        """Look, then drive, turn or stop."""
        is_seen = any(detection.name == self.wanted for detection in self.perception.perceive(observation).detections)
        is_stuck, self.stood = observation.base_to_start == self.stood, observation.base_to_start
        height, width = observation.depth.shape
        ahead = observation.depth[height // 4 : height // 2, width // 4 : -width // 4]
        if not is_stuck and not np.any((ahead > 0) & (ahead < ROOM_AHEAD)):  # 0 is no measurement
            self.turn = self.generator.choice(TURNS)
            return Decision(DiscreteAction.MOVE_FORWARD, "DRIVE", "There is room ahead.")
        if is_seen:
            return Decision(DiscreteAction.STOP, "FOUND", f"I stand before a {self.wanted}.")
        return Decision(self.turn, "TURN", "Something is in the way.")
