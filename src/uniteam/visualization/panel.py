"""The panel: one frame of a film that shows what the robot sees, what it makes of it, its map, and itself."""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2

from uniteam.evaluation.episode_loop import Step
from uniteam.geometry import BasePose
from uniteam.interface import Instruction
from uniteam.visualization.canvas import BOLD, Area, Image, TextStyle, blank, place, text_width, write, write_tag
from uniteam.visualization.canvas import write_wrapped as paragraph
from uniteam.visualization.captions import MILESTONES, describe_action
from uniteam.visualization.colors import (
    FAILURE,
    FAINT_TEXT,
    FRAME,
    GOAL_RECEPTACLE,
    OBJECT,
    START_RECEPTACLE,
    SUCCESS,
    TEXT,
)
from uniteam.visualization.map_view import draw_map
from uniteam.visualization.segmentation_view import draw_segmentation

WIDTH, HEIGHT = 1280, 720

_HEAD = Area(14, 56, 318, 424)
_SEGMENTS = Area(344, 56, 318, 424)
_THIRD_PERSON = Area(674, 56, 592, 322)
_MAP = Area(674, 390, 592, 318)
_WORDS = Area(14, 494, 648, 214)

THIRD_PERSON_SIZE = (_THIRD_PERSON.width, _THIRD_PERSON.height)
"""Width and height (px) that the third-person view should be rendered at."""


@dataclass(frozen=True)
class PanelContent:
    """What one frame shows.

    Attributes:
        title: which agent, split and episode.
        instruction: what is asked.
        step: what was seen, decided and measured.
        trail: where the base has been (start frame).
        third_person: (H, W, 3) RGB view of the robot in its home.
    """

    title: str
    instruction: Instruction
    step: Step
    trail: Sequence[BasePose]
    third_person: Image


def draw_panel(content: PanelContent) -> Image:
    """Return the (720, 1280, 3) RGB frame."""
    canvas = blank(WIDTH, HEIGHT)
    _draw_heading(canvas, content)
    place(canvas, content.step.observation.rgb, _HEAD)
    place(canvas, _segments(content), _SEGMENTS)
    place(canvas, content.third_person, _THIRD_PERSON)
    place(canvas, _map(content), _MAP)
    for text, area in (
        ("head camera", _HEAD),
        ("perception", _SEGMENTS),
        ("third person", _THIRD_PERSON),
        ("map: goal in red, path in blue", _MAP),
    ):
        write_tag(canvas, text, area.left, area.top, TextStyle(13, FAINT_TEXT))
    _draw_words(canvas, content.step)
    return canvas


def _draw_heading(canvas: Image, content: PanelContent) -> None:
    """Write the instruction, each part in its colour, and on the right which episode and step this is."""
    asked, size, x = content.instruction, 22, 14
    plain, bold = TextStyle(size), TextStyle(size, weight=BOLD)
    for words, color in (
        ("Move ", None),
        (asked.object_category, OBJECT),
        (" from ", None),
        (asked.start_receptacle, START_RECEPTACLE),
        (" to ", None),
        (asked.goal_receptacle, GOAL_RECEPTACLE),
    ):
        style = TextStyle(size, color, BOLD) if color else plain
        x = write(canvas, words.replace("_", " "), x, 36, style)
    steps = f"step {content.step.measures.num_steps}"
    right = WIDTH - 14 - text_width(steps, bold)
    write(canvas, steps, right, 36, bold)
    small = TextStyle(15, FAINT_TEXT)
    write(canvas, content.title, right - 20 - text_width(content.title, small), 36, small)


def _segments(content: PanelContent) -> Image:
    observation, segmentation = content.step.observation, content.step.explanation.segmentation
    if segmentation is None:
        return blank(_SEGMENTS.width, _SEGMENTS.height)
    scale = _SEGMENTS.width / observation.camera.width
    return draw_segmentation(observation.rgb, segmentation, content.instruction, scale)


def _map(content: PanelContent) -> Image:
    overlay = content.step.explanation.overlay
    if overlay is None:
        return blank(_MAP.width, _MAP.height)
    base = content.step.observation.base_to_start
    return draw_map(overlay, base, content.trail, (_MAP.width, _MAP.height))


def _draw_words(canvas: Image, step: Step) -> None:
    """Write the state, the action, the reason and how far the task has come."""
    state, action = step.decision.state.replace("_", " "), describe_action(step.decision.action)
    x = write(canvas, state, _WORDS.left, _WORDS.top + 22, TextStyle(22, weight=BOLD))
    write(canvas, action, x + 16, _WORDS.top + 22, TextStyle(18, FAINT_TEXT))
    reason = Area(_WORDS.left, _WORDS.top + 38, _WORDS.width, 78)
    paragraph(canvas, step.decision.reason, reason, TextStyle(18))
    _draw_milestones(canvas, step, _WORDS.top + 142)


def _draw_milestones(canvas: Image, step: Step, top: int) -> None:
    """Draw a lamp for each measure, lit where it is reached, and count the collisions."""
    x = _WORDS.left
    for name, words in MILESTONES.items():
        reached = getattr(step.measures, name)
        cv2.circle(canvas, (x + 7, top), 6, SUCCESS if reached else FRAME, cv2.FILLED, cv2.LINE_AA)
        x = write(canvas, words, x + 19, top + 5, TextStyle(14, TEXT if reached else FAINT_TEXT)) + 16
    collisions = step.measures.robot_scene_colls
    words = f"arm or gripper touched the scene in {collisions} steps"
    write(canvas, words, _WORDS.left, top + 34, TextStyle(14, FAILURE if collisions else FAINT_TEXT))
    holding = "holding an object" if step.observation.is_holding else "gripper empty"
    write(canvas, holding, _WORDS.left, top + 60, TextStyle(14, FAINT_TEXT))
