"""The teller says what matters, once."""

from dataclasses import replace

import numpy as np

from uniteam.evaluation.episode_loop import Step
from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Action, BaseDisplacement, Decision, DiscreteAction, Explanation, Joints, Observation
from uniteam.visualization.narration import Narrator
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.simulation.touches import Touches
from uniteam.world.task.measures import Measures

CAMERA = PinholeCamera.from_horizontal_fov(4, 6, 1.0)
FORWARD, TURN = DiscreteAction.MOVE_FORWARD, DiscreteAction.TURN_LEFT
UNEVENTFUL, BLOCKED = StepEvents(), StepEvents(blocked=True)
TOUCHING = StepEvents(touches=Touches(robot_scene="coffee_table_1", obj_scene="wall", robot_obj="cup_2"))
NO_MEASURES = Measures()


def step(
    number: int,
    action: Action,
    state: str = "FIND_OBJECT",
    events: StepEvents = UNEVENTFUL,
    measures: Measures = NO_MEASURES,
) -> Step:
    rgb, depth = np.zeros((6, 4, 3), np.uint8), np.zeros((6, 4), np.float32)
    seen = Observation(rgb, depth, CAMERA, np.eye(4), BasePose(0.0, 0.0, 0.0), Joints(0.8, 0.0), False, number)
    done = replace(measures, num_steps=number + 1)
    return Step(seen, Decision(action, state, "Because."), Explanation(), events, done, seen)


def told(*steps: Step) -> list[tuple[int, str, str]]:
    news: list[tuple[int, str, str]] = []
    narrator = Narrator(lambda number, kind, sentence: news.append((number, kind, sentence)))
    for each in steps:
        narrator(each)
    return news


def test_a_state_is_told_when_it_begins() -> None:
    steps = [step(0, FORWARD), step(1, FORWARD), step(2, FORWARD, "PICK")]
    assert told(*steps) == [(0, "state", "FIND_OBJECT: Because."), (2, "state", "PICK: Because.")]


def test_a_blocked_drive_is_told_once_until_the_base_moves_again() -> None:
    drive = BaseDisplacement(x=0.3)
    events = (UNEVENTFUL, BLOCKED, BLOCKED, UNEVENTFUL, BLOCKED)
    news = told(*(step(number, drive, events=each) for number, each in enumerate(events)))
    assert [number for number, kind, _ in news if kind == "trouble"] == [1, 4]


def test_turning_on_the_spot_between_does_not_end_being_blocked() -> None:
    news = told(step(0, FORWARD, events=BLOCKED), step(1, TURN), step(2, FORWARD, events=BLOCKED))
    assert [number for number, kind, _ in news if kind == "trouble"] == [0]


def test_a_grasp_a_measure_and_a_collision_are_told_when_they_happen() -> None:
    picked = Measures(find_object_phase_success=True, pick_object_phase_success=True)
    touched = replace(picked, robot_scene_colls=1, obj_scene_colls=1, robot_obj_colls=1)
    steps = (
        step(0, TURN),
        step(1, DiscreteAction.SNAP_OBJECT, events=StepEvents(grasped="toy_car_3"), measures=picked),
        step(2, DiscreteAction.NAVIGATION_MODE, events=TOUCHING, measures=touched),
        step(3, DiscreteAction.DESNAP_OBJECT, events=StepEvents(released="toy_car_3"), measures=touched),
    )
    assert told(*steps)[1:] == [
        (1, "action", "snap object: Because."),
        (1, "success", "The gripper has grasped toy car 3."),
        (1, "success", "Measure reached: found object."),
        (1, "success", "Measure reached: picked object."),
        (2, "trouble", "Arm or gripper touched coffee table 1."),
        (2, "trouble", "What the gripper holds touched wall."),
        (2, "trouble", "Arm or gripper touched cup 2."),
        (3, "action", "desnap object: Because."),
        (3, "success", "The gripper has let go of toy car 3."),
    ]
