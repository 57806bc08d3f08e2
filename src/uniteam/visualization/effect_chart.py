"""A chart of what improvements are worth: a row an improvement, a column a question, each effect with its interval."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import cv2

from uniteam.evaluation.results.intervals import Estimate
from uniteam.visualization.canvas import Area, Image, TextStyle, blank, text_width, write, write_wrapped
from uniteam.visualization.colors import FAILURE, FAINT_TEXT, FRAME, SUCCESS, TEXT, Color

WIDTH = 1200
ROW = 22
_LEGEND = "Percentage points with 95 % intervals. Green: shown to help. Red: shown to cost. Grey: not shown."
_LEFT = 250
_SMALL = TextStyle(14, FAINT_TEXT)
_HEAD = 96
"""Height (px) above a block's rows: its columns' titles and scales."""


@dataclass(frozen=True)
class Column:
    """One question's effects.

    Attributes:
        title: the question.
        effects: in percentage points, by the row's name.
        shown: names of those that are shown.
    """

    title: str
    effects: Mapping[str, Estimate]
    shown: frozenset[str]


@dataclass(frozen=True)
class Block:
    """Rows that are asked the same questions."""

    rows: Sequence[str]
    columns: Sequence[Column]


def draw_effect_chart(title: str, blocks: Sequence[Block], caption: str) -> Image:
    """Return an RGB picture of the effects; all columns have one scale.

    Args:
        title: what the effects are of.
        blocks: one below the other.
        caption: what they are from.
    """
    height = 60 + sum(_HEAD + ROW * len(block.rows) + 20 for block in blocks) + 70
    canvas = blank(WIDTH, height)
    write(canvas, title, 30, 40, TextStyle(22))
    top, reach = 60, _reach(blocks)
    for block in blocks:
        _draw_block(canvas, block, top, reach)
        top += _HEAD + ROW * len(block.rows) + 20
    write_wrapped(canvas, f"{_LEGEND} {caption}", Area(30, height - 62, WIDTH - 60, 54), _SMALL)
    return canvas


def column_area(number: int, count: int, top: int, rows: int) -> Area:
    """Return where the rows of a block's column are drawn, the block beginning at `top` (px)."""
    width = (WIDTH - _LEFT - 30) // count
    return Area(_LEFT + number * width + 26, top + _HEAD, width - 52, ROW * rows)


def _reach(blocks: Sequence[Block]) -> float:
    """Return how many points the scales reach to either side: all of every interval, in steps of ten."""
    bounds = [
        max(abs(estimate.low), abs(estimate.high))
        for block in blocks
        for column in block.columns
        for estimate in column.effects.values()
    ]
    return max(10.0, 10.0 * math.ceil(max(bounds, default=10.0) / 10.0))


def _draw_block(canvas: Image, block: Block, top: int, reach: float) -> None:
    for number, row in enumerate(block.rows):
        baseline = top + _HEAD + ROW * number + 16
        write(canvas, row, _LEFT - 8 - text_width(row, TextStyle(15)), baseline, TextStyle(15))
    for number, column in enumerate(block.columns):
        area = column_area(number, len(block.columns), top, len(block.rows))
        write_wrapped(canvas, column.title, Area(area.left, area.top - 86, area.width, 44), TextStyle(15, TEXT))
        _draw_scale(canvas, area, reach)
        for place, row in enumerate(block.rows):
            if row in column.effects:
                y = area.top + ROW * place + ROW // 2
                _draw_effect(canvas, column.effects[row], row in column.shown, area, y, reach)


def _draw_scale(canvas: Image, area: Area, reach: float) -> None:
    for part in (-1.0, -0.5, 0.0, 0.5, 1.0):
        x = _x(part * reach, area, reach)
        cv2.line(canvas, (x, area.top), (x, area.top + area.height), FAINT_TEXT if part == 0.0 else FRAME, 1)
        text = f"{part * reach:+.0f}" if part else "0"
        write(canvas, text, x - text_width(text, _SMALL) // 2, area.top - 8, _SMALL)


def _draw_effect(canvas: Image, estimate: Estimate, is_shown: bool, area: Area, y: int, reach: float) -> None:
    color = _color(estimate, is_shown)
    low, mean, high = (_x(value, area, reach) for value in (estimate.low, estimate.mean, estimate.high))
    cv2.line(canvas, (low, y), (high, y), color, 2 if is_shown else 1, cv2.LINE_AA)
    cv2.circle(canvas, (mean, y), 5, color, -1, cv2.LINE_AA)


def _color(estimate: Estimate, is_shown: bool) -> Color:
    if not is_shown:
        return FAINT_TEXT
    return SUCCESS if estimate.mean > 0.0 else FAILURE


def _x(points: float, area: Area, reach: float) -> int:
    return round(area.left + (points / reach + 1.0) / 2.0 * area.width)
