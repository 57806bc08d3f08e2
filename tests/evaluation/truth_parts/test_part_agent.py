"""A part that the truth plays does what it should, from where the agent stands, and hands back."""

import math

import pytest
from worlds.filled import filled

from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.episode_loop import Step, play_episode
from uniteam.evaluation.truth_parts.part_agent import PartAgent, TruePart
from uniteam.evaluation.truth_parts.true_pick import TruePick
from uniteam.evaluation.truth_parts.true_place import TruePlace
from uniteam.interface import Decision, DiscreteAction, Instruction, Observation
from uniteam.world.oracle.oracle import Oracle
from uniteam.world.task.environment import Environment
from uniteam.world.task.splits import load_split


class Idler:
    """Goes with the oracle up to one of its states; then it says that it is in another, waits, and stops."""

    def __init__(self, environment: Environment, until: str, state: str) -> None:
        self._oracle, self._until, self._state = Oracle(environment), until, state
        self._idle_steps = 0

    def reset(self, instruction: Instruction, seed: int) -> None:
        self._oracle.reset(instruction, seed)
        self._idle_steps = 0

    def act(self, observation: Observation) -> Decision:
        if not self._idle_steps:
            decision = self._oracle.act(observation)
            if decision.state != self._until:
                return decision
        self._idle_steps += 1
        action = DiscreteAction.STOP if self._idle_steps > 3 else DiscreteAction.EMPTY_ACTION
        return Decision(action, self._state, "I idle.")


def played(until: str, part: TruePart | None, state: str) -> tuple[Environment, list[Step]]:
    split = load_split("minival")
    episode = split.episodes[5]
    environment = Environment(split.homes[episode.home], episode)
    idler = Idler(environment, until, state)
    steps: list[Step] = []
    play_episode(environment, idler if part is None else PartAgent(idler, environment, part), steps.append)
    return environment, steps


def test_the_true_pick_brings_the_object_and_the_robot_back_to_where_it_was() -> None:
    without, own = played("NAVIGATE_TO_OBJECT", None, "PICK")
    assert without.simulator.held is None and not without.measures.pick_object_phase_success
    environment, steps = played("NAVIGATE_TO_OBJECT", TruePick(), "PICK")
    certificate = environment.episode.certificate
    assert certificate is not None and environment.simulator.held == certificate.object
    assert environment.measures.pick_object_phase_success
    begun = next(step.observation for step in filled(steps) if step.decision.state == "PICK")
    there, back = begun.base_to_start, steps[-1].observation.base_to_start
    assert math.hypot(there.x - back.x, there.y - back.y) < 0.01 and abs(there.heading - back.heading) < 0.01
    assert steps[-1].observation.joints == begun.joints
    assert [step.decision.reason for step in steps[-4:]] == ["I idle."] * 4
    assert len(steps) > len(own)


def test_the_true_place_puts_the_object_down_and_ends_the_episode() -> None:
    environment, steps = played("NAVIGATE_TO_RECEPTACLE", TruePlace(), "PLACE")
    assert environment.measures.overall_success
    assert steps[-1].decision.reason == "The truth does this part."
    assert not played("NAVIGATE_TO_RECEPTACLE", None, "PLACE")[0].measures.place_success


@pytest.mark.parametrize("part", [TruePick(), TruePlace()])
def test_a_part_is_not_played_from_far_away(part: TruePart) -> None:
    environment, steps = played("FIND_OBJECT", part, part.state)
    assert [step.decision.reason for step in steps] == ["I idle."] * 4
    assert environment.simulator.held is None


def test_replaced_agents_are_told_the_truth_and_only_those_of_a_configuration_can_be() -> None:
    split = load_split("minival")
    environment = Environment(split.homes[split.episodes[5].home], split.episodes[5])
    assert isinstance(AgentSpec("true-pick:baseline", "truth").make(environment), PartAgent)
    with pytest.raises(InvalidInputError, match="environment only"):
        AgentSpec("true-place:uniteam", "truth").make(None)
    with pytest.raises(InvalidInputError, match="no part of agent 'random' can be replaced"):
        AgentSpec("true-pick:random", "truth").describe()
