"""The teller says what matters, once."""

from dataclasses import replace

import numpy as np

from uniteam.evaluation.episode_loop import Step
from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Action, BaseDisplacement, Decision, DiscreteAction, Explanation, Joints, Observation
from uniteam.visualization.narration import Narrator
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.measures import Measures

NOTHING = Measures()
CAMERA = PinholeCamera.from_horizontal_fov(4, 6, 1.0)


def step(number: int, x: float, action: Action, state: str = "FIND_OBJECT", measures: Measures = NOTHING) -> Step:
    rgb, depth = np.zeros((6, 4, 3), np.uint8), np.zeros((6, 4), np.float32)
    seen = Observation(rgb, depth, CAMERA, np.eye(4), BasePose(x, 0.0, 0.0), Joints(0.8, 0.0), False, number)
    return Step(
        seen, Decision(action, state, "Because."), Explanation(), StepEvents(), replace(measures, num_steps=number + 1)
    )


def told(*steps: Step) -> list[tuple[int, str, str]]:
    news: list[tuple[int, str, str]] = []
    narrator = Narrator(lambda number, kind, sentence: news.append((number, kind, sentence)))
    for each in steps:
        narrator(each)
    return news


def test_a_state_is_told_when_it_begins() -> None:
    forward = DiscreteAction.MOVE_FORWARD
    steps = [step(0, 0.0, forward), step(1, 0.25, forward), step(2, 0.5, forward, "PICK")]
    assert told(*steps) == [(0, "state", "FIND_OBJECT: Because."), (2, "state", "PICK: Because.")]


def test_a_blocked_drive_is_told_once_until_the_base_moves_again() -> None:
    drive = BaseDisplacement(x=0.3)
    xs = (0.0, 0.3, 0.3, 0.3, 0.6, 0.6)
    news = told(*(step(number, x, drive) for number, x in enumerate(xs)))
    assert [number for number, kind, _ in news if kind == "trouble"] == [2, 5]


def test_turning_on_the_spot_is_no_blocked_drive() -> None:
    turn = DiscreteAction.TURN_LEFT
    assert len(told(step(0, 0.0, turn), step(1, 0.0, turn), step(2, 0.0, turn))) == 1


def test_a_grasp_a_measure_and_a_collision_are_told_when_they_happen() -> None:
    picked = Measures(find_object_phase_success=True, pick_object_phase_success=True)
    snap = step(1, 0.0, DiscreteAction.SNAP_OBJECT, measures=picked)
    after = step(2, 0.0, DiscreteAction.NAVIGATION_MODE, measures=replace(picked, robot_scene_colls=1))
    held = replace(after, observation=replace(after.observation, is_holding=True))
    assert told(step(0, 0.0, DiscreteAction.TURN_LEFT), snap, held)[1:] == [
        (1, "action", "snap object: Because."),
        (1, "success", "Measure reached: found object."),
        (1, "success", "Measure reached: picked object."),
        (2, "success", "The gripper holds something."),
        (2, "trouble", "Arm, gripper or load touched the scene."),
    ]
