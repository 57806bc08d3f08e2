"""The loop that joins a world and an agent, on a corridor of five steps."""

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.evaluation.episode_loop import Step, play_episode, result_of_exception
from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import (
    Action,
    Decision,
    DiscreteAction,
    Explanation,
    Instruction,
    Joints,
    Observation,
    Segmentation,
)
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.episode import Candidate, Episode
from uniteam.world.task.measures import Measures

CAMERA = PinholeCamera.from_horizontal_fov(4, 6, 1.0)
EPISODE = Episode(
    id="corridor_1",
    home="corridor",
    start=BasePose(0.0, 0.0, 0.0),
    instruction=Instruction("toy_car", "table", "chest_of_drawers"),
    objects=(Candidate("toy_car_0", ((3.0, 0.0),)),),
    start_receptacles=("table_0",),
    goal_receptacles=(Candidate("chest_of_drawers_0", ((4.0, 0.0),)),),
    unseen=True,
    seed=11,
)


class Corridor:
    """The object is found after three steps forward; the world ends after five steps or at STOP."""

    def __init__(self) -> None:
        self.episode = EPISODE
        self.actions: list[Action] = []

    @property
    def events(self) -> StepEvents:
        return StepEvents()

    @property
    def measures(self) -> Measures:
        forward = self.actions.count(DiscreteAction.MOVE_FORWARD)
        stopped = DiscreteAction.STOP in self.actions
        return Measures(forward >= 3, num_steps=len(self.actions), does_want_terminate=stopped)

    @property
    def is_over(self) -> bool:
        return self.measures.does_want_terminate or len(self.actions) >= 5

    def reset(self) -> Observation:
        self.actions = []
        return self._observation()

    def step(self, action: Action) -> Observation:
        self.actions.append(action)
        return self._observation()

    def _observation(self) -> Observation:
        pose = BasePose(0.25 * len(self.actions), 0.0, 0.0)
        rgb, depth = np.zeros((6, 4, 3), np.uint8), np.zeros((6, 4), np.float32)
        return Observation(rgb, depth, CAMERA, np.eye(4), pose, Joints(0.8, 0.0), False, len(self.actions))


class Walker:
    """Walks forward and stops after a number of steps that the seed gives away."""

    def __init__(self, patience: int) -> None:
        self.patience = patience
        self.asked: tuple[Instruction, int] | None = None

    def reset(self, instruction: Instruction, seed: int) -> None:
        self.asked = (instruction, seed)

    def act(self, observation: Observation) -> Decision:
        if observation.step >= self.patience:
            return Decision(DiscreteAction.STOP, "DONE", "I am tired.")
        return Decision(DiscreteAction.MOVE_FORWARD, "WALK", "There is more corridor.")


class Breaks(Walker):
    """Walks, and breaks where the walker would stop."""

    def act(self, observation: Observation) -> Decision:
        if observation.step >= self.patience:
            raise ValueError("a wheel came off")
        return super().act(observation)


class Explains(Walker):
    """Walks, and counts how often it is asked what is behind its decisions."""

    asked_for = 0

    def explain(self) -> Explanation:
        self.asked_for += 1
        return Explanation(Segmentation(np.full((6, 4), -1, np.int16), ()))


def test_an_episode_ends_when_the_agent_stops_and_says_why_it_failed() -> None:
    agent = Walker(patience=3)
    result = play_episode(Corridor(), agent)
    assert agent.asked == (EPISODE.instruction, 11)
    assert result.measures == Measures(find_object_phase_success=True, num_steps=4, does_want_terminate=True)
    assert (result.episode, result.home, result.unseen) == ("corridor_1", "corridor", True)
    assert result.instruction == "Move toy car from table to chest of drawers"
    assert result.state == "DONE"
    assert result.failure == (
        "found the object but never grasped a candidate; stopped after 4 steps in DONE (I am tired)"
    )
    assert not result.crashed
    assert 0.0 < result.seconds < 5.0
    assert result.peak_memory > 10.0


def test_an_episode_ends_when_its_steps_are_used_up() -> None:
    result = play_episode(Corridor(), Walker(patience=100))
    assert result.measures.num_steps == 5
    assert "ran out of steps" in result.failure


def test_the_observer_is_shown_each_step_with_what_was_seen_before_and_measured_after() -> None:
    steps: list[Step] = []
    play_episode(Corridor(), Walker(patience=3), steps.append)
    assert [s.observation.step for s in steps] == [0, 1, 2, 3]
    assert [s.measures.num_steps for s in steps] == [1, 2, 3, 4]
    assert [s.decision.state for s in steps] == ["WALK", "WALK", "WALK", "DONE"]
    assert [s.measures.find_object_phase_success for s in steps] == [False, False, True, True]
    assert all(s.explanation == Explanation() for s in steps)


def test_an_agent_is_asked_to_explain_itself_only_where_someone_looks() -> None:
    agent = Explains(patience=3)
    play_episode(Corridor(), agent)
    assert agent.asked_for == 0
    steps: list[Step] = []
    play_episode(Corridor(), agent, steps.append)
    assert agent.asked_for == 4
    assert all(s.explanation.segmentation is not None for s in filled(steps))


def test_a_crash_is_a_failure_in_every_phase_and_keeps_its_traceback() -> None:
    world = Corridor()
    with pytest.raises(ValueError, match="wheel") as caught:
        play_episode(world, Breaks(patience=4))
    assert world.measures.find_object_phase_success
    result = result_of_exception(EPISODE, caught.value, steps=4)
    assert result.crashed
    assert result.measures == Measures(num_steps=4)
    assert "ValueError: a wheel came off" in result.failure
    assert "in act" in result.traceback
