"""A chart of waterfalls: from all episodes down to overall success, a panel an agent."""

from collections.abc import Mapping, Sequence

import cv2

from uniteam.evaluation.analysis.waterfall import Stage, Waterfall, causes_in
from uniteam.evaluation.causes.cause import Cause
from uniteam.evaluation.causes.diagnosis import PHASES
from uniteam.visualization.canvas import Area, Image, TextStyle, blank, text_width, write, write_wrapped
from uniteam.visualization.colors import FAILURE, FAINT_TEXT, FRAME, SUCCESS, TEXT, Color

PANEL, BAR, LINE = 640, 26, 20
"""Width of a panel, and heights of a bar and of a line of words (px)."""

_LEFT, _BARS = 30, 300
"""Left margin, and width of the bar of all episodes (px)."""
_LEFT_OVER: Color = (70, 110, 160)
_SMALL = TextStyle(14, FAINT_TEXT)
_LEGEND = "Red: lost in a phase, with the causes below. Grey: left. Green: overall success."


def draw_waterfalls(title: str, waterfalls: Sequence[Waterfall], caption: str) -> Image:
    """Return an RGB picture of some agents' waterfalls, side by side.

    Args:
        title: what they are of.
        waterfalls: one an agent; bars are shares of the agent's own episodes.
        caption: what the figures are from.
    """
    causes = {phase: causes_in(waterfalls, phase) for phase in PHASES}
    height = 110 + (len(PHASES) + 2) * (BAR + 14) + LINE * sum(map(len, causes.values())) + 80
    canvas = blank(PANEL * max(len(waterfalls), 2) + _LEFT, height)
    write(canvas, title, _LEFT, 40, TextStyle(22))
    for number, waterfall in enumerate(waterfalls):
        _draw(canvas, waterfall, causes, _LEFT + number * PANEL)
    area = Area(_LEFT, height - 62, canvas.shape[1] - 2 * _LEFT, 54)
    write_wrapped(canvas, f"{_LEGEND} {caption}", area, _SMALL)
    return canvas


def bar_ends(waterfall: Waterfall, stage: Stage) -> tuple[int, int]:
    """Return from where to where (px, of `_BARS`) the red part of a phase's bar reaches."""
    return _pixels(waterfall, stage.left), _pixels(waterfall, stage.left + stage.lost)


def _draw(canvas: Image, waterfall: Waterfall, causes: Mapping[str, Sequence[Cause]], left: int) -> None:
    write_wrapped(canvas, waterfall.label, Area(left, 62, PANEL - 30, 40), TextStyle(17, TEXT))
    top = 110
    _bar(canvas, left, top, (0, _BARS), _LEFT_OVER)
    write(canvas, f"{waterfall.episodes} episodes", left + _BARS + 14, top + 18, TextStyle(15, TEXT))
    top += BAR + 14
    for stage in waterfall.stages:
        _draw_lost(canvas, waterfall, stage, left, top)
        top = _draw_causes(canvas, stage, causes[stage.phase], left, top + BAR + 4) + 10
    _bar(canvas, left, top, (0, _pixels(waterfall, waterfall.successes)), SUCCESS)
    share = 100.0 * waterfall.successes / waterfall.episodes
    words = f"{waterfall.successes} overall success ({share:.1f} %)"
    write(canvas, words, left + _BARS + 14, top + 18, TextStyle(15, TEXT))


def _draw_lost(canvas: Image, waterfall: Waterfall, stage: Stage, left: int, top: int) -> None:
    begin, end = bar_ends(waterfall, stage)
    _bar(canvas, left, top, (0, begin), FRAME)
    _bar(canvas, left, top, (begin, end), FAILURE)
    write(canvas, f"{stage.lost} failed: {stage.phase}", left + _BARS + 14, top + 18, TextStyle(15, TEXT))


def _draw_causes(canvas: Image, stage: Stage, causes: Sequence[Cause], left: int, top: int) -> int:
    """Draw a line for each cause that any of the agents has in a phase, and return the y (px) below."""
    for cause in causes:
        number = str(stage.causes.get(cause, 0))
        write(canvas, number, left + _BARS + 40 - text_width(number, _SMALL), top + 12, _SMALL)
        write(canvas, cause.value, left + _BARS + 50, top + 12, _SMALL)
        top += LINE
    return top


def _pixels(waterfall: Waterfall, count: int) -> int:
    return round(_BARS * count / waterfall.episodes)


def _bar(canvas: Image, left: int, top: int, span: tuple[int, int], color: Color) -> None:
    if span[1] > span[0]:
        cv2.rectangle(canvas, (left + span[0], top), (left + span[1] - 1, top + BAR - 1), color, -1)
