"""The panel: what it shows can be found in its pixels."""

import dataclasses

import numpy as np
import pytest
from numpy.typing import NDArray

from uniteam.evaluation.episode_loop import Step
from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import (
    BaseDisplacement,
    Decision,
    Detection,
    DiscreteAction,
    Explanation,
    Instruction,
    JointDisplacement,
    Joints,
    MapLabel,
    MapOverlay,
    Observation,
    Segmentation,
)
from uniteam.visualization.canvas import Area, TextStyle, blank, place, text_width, wrap, write_wrapped
from uniteam.visualization.captions import describe_action, new_milestones
from uniteam.visualization.colors import BACKGROUND, GOAL_RECEPTACLE, MAP_COLORS, OBJECT, SUCCESS, name_color
from uniteam.visualization.map_view import draw_map
from uniteam.visualization.panel import HEIGHT, WIDTH, PanelContent, draw_panel
from uniteam.visualization.segmentation_view import draw_segmentation
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.measures import Measures

INSTRUCTION = Instruction("toy_car", "table", "chest_of_drawers")
CAMERA = PinholeCamera.from_horizontal_fov(240, 320, 0.733)
PLACED = Measures(True, True, True, True, 2, 311, False)


def overlay() -> MapOverlay:
    """A free room 4 m by 3 m with a wall to the north and a goal receptacle in its south-east corner."""
    labels = np.zeros((100, 120), dtype=np.uint8)
    labels[20:80, 20:100] = MapLabel.FREE
    labels[80:84, 20:100] = MapLabel.OBSTACLE
    labels[20:30, 90:100] = MapLabel.GOAL_RECEPTACLE
    goal = np.array([[3.5, -1.0]])
    path = np.array([[0.0, 0.0], [1.0, 0.0], [3.5, -1.0]])
    return MapOverlay(labels, (-1.0, -2.5), 0.05, goal, (0.25, 0.0), path)


def segmentation() -> Segmentation:
    instances = np.full((320, 240), -1, dtype=np.int16)
    instances[200:, :] = 0
    instances[150:200, 100:150] = 1
    return Segmentation(instances, (Detection((("table", 0.8),)), Detection((("toy_car", 1.0),))))


def step(reason: str = "The nearest table has not been looked at from close by.") -> Step:
    rgb, depth = np.full((320, 240, 3), 128, np.uint8), np.ones((320, 240), np.float32)
    pose, joints = BasePose(1.0, 0.0, 0.3), Joints(0.78, 0.0)
    seen = Observation(rgb, depth, CAMERA, np.eye(4), pose, joints, True, 311)
    decision = Decision(DiscreteAction.MOVE_FORWARD, "NAVIGATE_TO_OBJECT", reason)
    return Step(seen, decision, Explanation(segmentation(), overlay()), StepEvents(), PLACED, seen)


def count(picture: NDArray[np.uint8], color: tuple[int, int, int]) -> int:
    return int((picture == np.array(color)).all(axis=-1).sum())


def test_a_picture_keeps_its_proportions_in_the_middle_of_its_area() -> None:
    canvas = blank(200, 100)
    place(canvas, np.full((10, 10, 3), 255, np.uint8), Area(0, 0, 200, 100))
    white = np.argwhere((canvas == 255).all(-1))
    assert white.min(0).tolist() == [0, 50]
    assert white.max(0).tolist() == [99, 149]


def test_text_wraps_between_words_within_the_width() -> None:
    style = TextStyle(16)
    text = "The nearest table has not been looked at from close by, so the robot goes there first."
    lines = wrap(text, 200, style)
    assert len(lines) > 2
    assert " ".join(lines) == text
    assert max(text_width(line, style) for line in lines) <= 200


def test_text_that_does_not_fit_stays_within_its_area() -> None:
    canvas = blank(300, 200)
    write_wrapped(canvas, "word " * 200, Area(20, 20, 200, 60), TextStyle(16))
    drawn = np.argwhere((canvas != np.array(BACKGROUND)).any(-1))
    assert drawn[:, 0].max() <= 82
    assert drawn[:, 1].max() <= 222


def test_the_map_is_drawn_with_y_up_and_x_to_the_right() -> None:
    picture = draw_map(overlay(), BasePose(0.0, 0.0, 0.0), [], (400, 300))
    wall = np.argwhere((picture == np.array(MAP_COLORS[MapLabel.OBSTACLE])).all(-1)).mean(0)
    goal = np.argwhere((picture == np.array(GOAL_RECEPTACLE)).all(-1)).mean(0)
    assert wall[0] < goal[0]
    assert goal[1] > wall[1]


def test_the_map_shows_cells_where_they_are() -> None:
    """A cell's colour is found at the pixel of its centre: 5 m known across 6 m of view."""
    shown = overlay()
    shown.labels[:] = MapLabel.UNKNOWN
    shown.labels[40:60, 60:80] = MapLabel.FREE  # x from 2 to 3, y from -0.5 to 0.5
    picture = draw_map(shown, BasePose(2.5, 0.0, 0.0), [], (600, 600))  # 6 m, 100 px a metre, centre (2.5, 0)
    free = np.argwhere((picture == np.array(MAP_COLORS[MapLabel.FREE])).all(-1))
    assert free.min(0) == pytest.approx([250, 250], abs=2)
    assert free.max(0) == pytest.approx([349, 349], abs=2)


def test_an_empty_map_is_drawn_too() -> None:
    empty = MapOverlay(np.zeros((10, 10), np.uint8), (0, 0), 0.05, np.zeros((0, 2)), None, np.zeros((0, 2)))
    picture = draw_map(empty, BasePose(0.0, 0.0, 0.0), [], (400, 300))
    assert picture.shape == (300, 400, 3)


def test_segments_have_the_colours_of_their_parts_in_the_instruction() -> None:
    rgb = np.full((320, 240, 3), 100, np.uint8)
    picture = draw_segmentation(rgb, segmentation(), INSTRUCTION, scale=2.0)
    assert picture.shape == (640, 480, 3)
    assert picture[320, 210] == pytest.approx([(100 + c) / 2 for c in OBJECT], abs=2)
    assert picture[100, 100] == pytest.approx([100, 100, 100], abs=2)
    assert name_color("plant", INSTRUCTION) == name_color("plant", Instruction("cup", "bed", "sink"))


def test_the_panel_shows_the_reached_measures_as_lit_lamps() -> None:
    content = PanelContent("uniteam", INSTRUCTION, step(), [], np.zeros((322, 592, 3), np.uint8))
    panel = draw_panel(content)
    assert panel.shape == (HEIGHT, WIDTH, 3)
    lamp = 113  # pixels of a disc of radius 6
    assert count(panel, SUCCESS) == pytest.approx(4 * lamp, rel=0.25)


def test_a_panel_of_an_agent_without_map_and_perception_is_drawn_too() -> None:
    decision = Decision(DiscreteAction.STOP, "RANDOM", "The dice.")
    plain = dataclasses.replace(step(), decision=decision, explanation=Explanation(), measures=Measures())
    panel = draw_panel(PanelContent("random", INSTRUCTION, plain, [], np.zeros((322, 592, 3), np.uint8)))
    assert count(panel, SUCCESS) == 0


def test_actions_are_described_in_metres_and_degrees() -> None:
    assert describe_action(DiscreteAction.SNAP_OBJECT) == "snap object"
    assert describe_action(BaseDisplacement(x=0.31)) == "base 0.31 m forward"
    assert describe_action(BaseDisplacement(heading=-0.5236)) == "turn 30° right"
    raised = JointDisplacement(Joints(lift=0.1, arm=-0.2, wrist_yaw=0.1745))
    assert describe_action(raised) == "lift +0.10 m, arm -0.20 m, wrist yaw +10°"
    assert describe_action(BaseDisplacement()) == "stay"


def test_new_milestones_are_those_that_were_not_reached_before() -> None:
    assert new_milestones(Measures(), Measures(True)) == ["found object"]
    assert new_milestones(Measures(True, True), Measures(True, True, True, True)) == [
        "found receptacle",
        "placed",
        "overall success",
    ]
