"""An agent that breaks a promise is told which, and at which step."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from uniteam.errors import UniteamError
from uniteam.interface import (
    BaseDisplacement,
    Decision,
    DiscreteAction,
    Explanation,
    Instruction,
    JointDisplacement,
    Joints,
    Observation,
    Segmentation,
)
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.registry import AgentContext
from uniteam.testing import CheckFailedError, check_agent

LEFT, RIGHT = DiscreteAction.TURN_LEFT, DiscreteAction.TURN_RIGHT
STEPS = 4


def turn(is_left: bool) -> Decision:
    return Decision(LEFT if is_left else RIGHT, "TURN", "I look around.")


class Sound:
    """Turns by what it sees, and by dice of its own."""

    def reset(self, instruction: Instruction, seed: int) -> None:
        self.dice = np.random.default_rng(seed)

    def act(self, observation: Observation) -> Decision:
        return turn(bool(self.dice.integers(2)) != (float(observation.depth.mean()) > 2.0))

    def explain(self) -> Explanation:
        return Explanation()


class KeepsCount(Sound):
    """Does not forget at reset how many steps it has made."""

    def __init__(self) -> None:
        self.count = 0

    def act(self, observation: Observation) -> Decision:
        self.count += 1
        return turn(self.count <= STEPS)


class SharesCount(Sound):
    """Counts the steps of all of its kind together."""

    counts: tuple[int, ...] = ()

    def act(self, observation: Observation) -> Decision:
        SharesCount.counts += (1,)
        return turn(len(self.counts) % 2 == 0)


class GlobalDice(Sound):
    """Throws the dice that belong to everybody, though it seeds them."""

    def reset(self, instruction: Instruction, seed: int) -> None:
        np.random.seed(seed)

    def act(self, observation: Observation) -> Decision:
        return Decision(BaseDisplacement(heading=float(np.random.random())), "TURN", "I look around.")


class Unseeded(Sound):
    """Lets its seed be."""

    def reset(self, instruction: Instruction, seed: int) -> None:
        self.dice = np.random.default_rng()

    def act(self, observation: Observation) -> Decision:
        return Decision(BaseDisplacement(heading=float(self.dice.random())), "TURN", "I look around.")


class Painter(Sound):
    """Clips the depth where it lies."""

    def act(self, observation: Observation) -> Decision:
        if observation.step == 2:
            np.clip(observation.depth, 0.0, 1.0, out=observation.depth)
        return turn(True)


class LatePainter(Sound):
    """Keeps the first picture and draws into it later."""

    def act(self, observation: Observation) -> Decision:
        if observation.step == 0:
            self.rgb = observation.rgb
        else:
            self.rgb[0, 0] = 255 - self.rgb[0, 0]
        return turn(True)


class Peeker(Sound):
    """Looks into the truth where there is one."""

    def act(self, observation: Observation) -> Decision:
        return turn(observation.truth is None)


class Dependent(Sound):
    """Cannot do without the truth."""

    def act(self, observation: Observation) -> Decision:
        assert observation.truth is not None, "where is the truth?"
        return turn(True)


class Talker(Sound):
    """Goes the other way once it was asked why."""

    is_asked = False

    def act(self, observation: Observation) -> Decision:
        return turn(self.is_asked)

    def explain(self) -> Explanation:
        self.is_asked = True
        return Explanation()


class Mumbler(Sound):
    """Explains a frame of another size."""

    def explain(self) -> Explanation:
        return Explanation(Segmentation(np.full((2, 2), -1, np.int16), ()))


class Faller(Sound):
    """Breaks down at its third step."""

    def act(self, observation: Observation) -> Decision:
        if observation.step == 2:
            raise ZeroDivisionError("division\nby zero")
        return turn(True)


def deciding(decision: Any) -> Callable[[], Sound]:
    """Return what makes agents that always decide one thing."""

    class Stubborn(Sound):
        def act(self, observation: Observation) -> Decision:
            return decision

    return Stubborn


def test_a_sound_agent_passes_and_so_does_a_configuration() -> None:
    check_agent(Sound, steps=STEPS)
    check_agent(replace(BASELINE, first_turns=2), steps=STEPS)


def test_what_is_wrong_is_both_an_assertion_and_an_error_of_the_package() -> None:
    assert issubclass(CheckFailedError, AssertionError)
    assert issubclass(CheckFailedError, UniteamError)


@pytest.mark.parametrize(
    ("agent", "sentence"),
    [
        (KeepsCount, r"agent 'KeepsCount': what was played before leaks.*at step 0, in decision\.action"),
        (SharesCount, r"two copies made alike.*answer differently \(at step 0"),
        (GlobalDice, r"two copies made alike.*in decision\.action\.heading"),
        (Unseeded, r"two copies made alike.*in decision\.action\.heading"),
        (Painter, r"agent 'Painter' wrote into observation\.depth of step 2, which is not its own"),
        (LatePainter, r"agent 'LatePainter' wrote into observation\.rgb of step 0"),
        (Peeker, r"reads observation\.truth, though it is not registered.*\(at step 0"),
        (Dependent, r"act at step 0 raised AssertionError: where is the truth\?"),
        (Talker, r"asking it to explain\(\) changes what it decides \(at step 1"),
        (Mumbler, r"explain at step 0 returned instances of \(2, 2\) for a frame of \(320, 240\)"),
        (Faller, r"act at step 2 raised ZeroDivisionError: division by zero$"),
        (deciding(None), "act at step 0 must return a Decision, but returned None"),
        (deciding(LEFT), "must return a Decision, but returned a DiscreteAction"),
        (deciding(Decision("left", "S", "r")), "whose action is none: .*DiscreteAction"),  # type: ignore[arg-type]
        (deciding(Decision(BaseDisplacement(math.nan), "S", "r")), r"BaseDisplacement\.x is not a finite number"),
        (deciding(Decision(BaseDisplacement(1.5), "S", "r")), r"a move of 1\.5 m, which is cut to .*most_move, 1\.0 m"),
        (
            deciding(Decision(JointDisplacement(Joints(0.0, 0.0), BaseDisplacement(heading=4.0)), "S", "r")),
            r"a turn of 4 rad, which is cut to ACTION_LIMITS\.most_turn, 3\.1416 rad",
        ),
        (deciding(Decision(LEFT, "", "r")), "whose state is ''"),
        (deciding(Decision(LEFT, "S", None)), "whose reason is None"),  # type: ignore[arg-type]
        (dict, r"'dict': making it raised InvalidInputError: .*dict has no reset and no act"),
    ],
)
def test_an_agent_that_breaks_a_promise_is_told_which(agent: Any, sentence: str) -> None:
    with pytest.raises(CheckFailedError, match=sentence) as told:
        check_agent(agent, steps=STEPS)
    assert "\n" not in str(told.value)


class Oracle(Sound):
    """Asks the environment, as its factory says."""

    needs_truth = True

    def __init__(self, context: AgentContext) -> None:
        self.environment: Any = context.environment

    def act(self, observation: Observation) -> Decision:
        return turn(self.environment.simulator.base.x > 0.0)


def test_an_agent_that_is_told_the_truth_is_given_its_environment() -> None:
    check_agent(Oracle, steps=STEPS)
