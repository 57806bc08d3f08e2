"""A package from outside of the repository: an agent, a perception, an improvement and a source of homes.

Tests install it into a folder of their own; nothing in the repository imports it.
"""

import os
import signal
import time
from dataclasses import replace
from typing import Any

import numpy as np

from uniteam.interface import Decision, DiscreteAction, Instruction, Observation, Segmentation
from uniteam.mind.agents.config import BASELINE, AgentConfig
from uniteam.mind.agents.improvement import Improvement
from uniteam.mind.agents.improvements import improved
from uniteam.mind.agents.registry import AgentContext
from uniteam.world.generation.generate import generate_home
from uniteam.world.homes.home import Home


class Spinner:
    """Turns on the spot and stops after five steps."""

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Remember what is asked."""
        self.instruction = instruction

    def act(self, observation: Observation) -> Decision:
        """Turn, or stop."""
        action = DiscreteAction.TURN_LEFT if observation.step < 5 else DiscreteAction.STOP
        return Decision(action, "SPIN", f"I am looking for the {self.instruction.object_category}.")


class Blindfold:
    """Sees nothing at all."""

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Forget nothing, for nothing was seen."""

    def perceive(self, observation: Observation) -> Segmentation:
        """Return an empty segmentation."""
        return Segmentation(np.full(observation.depth.shape, -1, np.int16), ())


def _impatient(config: AgentConfig) -> AgentConfig:
    return replace(config, first_turns=3)


careful = Improvement("careful", "does something with care that others do not", _impatient)


sharp_edged = improved(BASELINE, ["edge_margin"])
"""A configuration that does not say which improvement it has."""


def cabins(seed: int) -> Home:
    """Return a home of the generator under another name."""
    return replace(generate_home(seed), name=f"cabin_{seed}")


class Crasher(Spinner):
    """Breaks down at its third step."""

    def act(self, observation: Observation) -> Decision:
        """Turn twice."""
        if observation.step == 2:
            raise ValueError("a wheel came off")
        return super().act(observation)


class Mute(Spinner):
    """Decides nothing."""

    def act(self, observation: Observation) -> Decision:
        """Return what is no decision."""
        return None  # type: ignore[return-value]


class Quitter(Spinner):
    """Tries to leave at its third step."""

    def act(self, observation: Observation) -> Decision:
        """Turn twice."""
        if observation.step == 2:
            raise SystemExit(0)
        return super().act(observation)


class Jumper(Spinner):
    """Asks for what no robot can do."""

    def act(self, observation: Observation) -> Decision:
        """Decide upon a word."""
        return Decision("jump", "JUMP", "I want to.")  # type: ignore[arg-type]


class Sleeper(Spinner):
    """Falls asleep at its third step."""

    def act(self, observation: Observation) -> Decision:
        """Turn twice."""
        if observation.step == 2:
            time.sleep(600.0)
        return super().act(observation)


class Victim(Spinner):
    """Is killed at its third step, unless the variable SPARE_ME is set."""

    def act(self, observation: Observation) -> Decision:
        """Turn twice."""
        if observation.step == 2 and "SPARE_ME" not in os.environ:
            os.kill(os.getpid(), signal.SIGKILL)
        return super().act(observation)


class Saboteur(Spinner):
    """Breaks the simulator at its third step."""

    needs_truth = True

    def __init__(self, context: AgentContext) -> None:
        """Keep the environment, as only an oracle should."""
        self.environment: Any = context.environment

    def act(self, observation: Observation) -> Decision:
        """Turn, or break what turns the robot."""
        if observation.step == 2:
            self.environment.simulator = None
        return super().act(observation)
