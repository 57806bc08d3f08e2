"""An agent that does anything at all: to check an environment from the shell, and to stand at the table's foot."""

import numpy as np

from uniteam.interface import Decision, DiscreteAction, Instruction, Observation

_ACTIONS = tuple(DiscreteAction)


class RandomAgent:
    """Chooses uniformly among the discrete actions."""

    def __init__(self) -> None:
        self._generator = np.random.default_rng(0)

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Begin the sequence of choices that `seed` fixes."""
        self._generator = np.random.default_rng(seed)

    def act(self, observation: Observation) -> Decision:
        """Choose an action without looking."""
        action = _ACTIONS[int(self._generator.integers(len(_ACTIONS)))]
        return Decision(action, "RANDOM", f"The dice say {action.value.replace('_', ' ')}.")
