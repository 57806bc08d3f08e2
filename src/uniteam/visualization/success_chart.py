"""A chart of success against noise: a line an agent, with the 95 % interval of each point."""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.results.intervals import Estimate
from uniteam.visualization.canvas import Area, Image, TextStyle, blank, text_width, write, write_wrapped
from uniteam.visualization.colors import FAINT_TEXT, FRAME, TEXT, Color

WIDTH, HEIGHT = 1120, 620
LINE_COLORS: tuple[Color, ...] = ((92, 160, 255), (255, 176, 40), (92, 201, 122), (255, 64, 160), (150, 222, 226))
_PLOT = Area(90, 70, 700, 440)
_LEGEND_LEFT = 830
_SMALL = TextStyle(15, FAINT_TEXT)


@dataclass(frozen=True)
class Curve:
    """One line of the chart.

    Attributes:
        label: what it is of.
        points: (level in [0, 1], share in [0, 1] with its interval), by increasing level.
    """

    label: str
    points: Sequence[tuple[float, Estimate]]


def draw_success_chart(title: str, curves: Sequence[Curve], caption: str) -> Image:
    """Return an RGB picture of what share of the episodes succeeded at which level of noise.

    Args:
        title: what the vertical axis shows.
        curves: lines, each in a colour of its own; those beyond the fifth repeat colours.
        caption: what the figures are from.
    """
    canvas = blank(WIDTH, HEIGHT)
    write(canvas, title, _PLOT.left, 42, TextStyle(22))
    _draw_axes(canvas)
    for number, curve in enumerate(curves):
        shift = 7 * number - 7 * (len(curves) - 1) // 2  # whiskers of one level stand beside each other
        color = LINE_COLORS[number % len(LINE_COLORS)]
        _draw_curve(canvas, curve, color, shift)
        top = _PLOT.top + 20 + 52 * number
        cv2.line(canvas, (_LEGEND_LEFT, top), (_LEGEND_LEFT + 30, top), color, 3, cv2.LINE_AA)
        write_wrapped(canvas, curve.label, Area(_LEGEND_LEFT + 42, top - 12, WIDTH - _LEGEND_LEFT - 52, 44))
    write_wrapped(canvas, caption, Area(_PLOT.left, HEIGHT - 52, WIDTH - 2 * _PLOT.left, 44), _SMALL)
    return canvas


def _draw_axes(canvas: Image) -> None:
    for percent in range(0, 101, 20):
        _, y = _at(0.0, percent / 100.0)
        cv2.line(canvas, (_PLOT.left, y), (_PLOT.left + _PLOT.width, y), FRAME, 1)
        text = f"{percent} %"
        write(canvas, text, _PLOT.left - 14 - text_width(text, _SMALL), y + 5, _SMALL)
    for quarter in range(5):
        x, y = _at(quarter / 4.0, 0.0)
        cv2.line(canvas, (x, y), (x, y + 6), FAINT_TEXT, 1)
        text = f"{quarter / 4.0:g}"
        write(canvas, text, x - text_width(text, _SMALL) // 2, y + 24, _SMALL)
    words = "noise of perception: 0 = truth, 1 = about a published detector's"
    x, y = _at(0.5, 0.0)
    write(canvas, words, x - text_width(words, _SMALL) // 2, y + 48, TextStyle(15, TEXT))


def _draw_curve(canvas: Image, curve: Curve, color: Color, shift: int) -> None:
    middles = [_at(level, estimate.mean) for level, estimate in curve.points]
    line: NDArray[np.int32] = np.array([(x + shift, y) for x, y in middles], np.int32)
    cv2.polylines(canvas, [line], False, color, 2, cv2.LINE_AA)
    for (level, estimate), (x, y) in zip(curve.points, middles, strict=True):
        low, high = _at(level, estimate.low)[1], _at(level, estimate.high)[1]
        cv2.line(canvas, (x + shift, low), (x + shift, high), color, 1, cv2.LINE_AA)
        for end in (low, high):
            cv2.line(canvas, (x + shift - 4, end), (x + shift + 4, end), color, 1)
        cv2.circle(canvas, (x + shift, y), 5, color, -1, cv2.LINE_AA)


def _at(level: float, share: float) -> tuple[int, int]:
    """Return the pixel (x, y) of a level and a share, both in [0, 1]."""
    return round(_PLOT.left + level * _PLOT.width), round(_PLOT.top + (1.0 - share) * _PLOT.height)
