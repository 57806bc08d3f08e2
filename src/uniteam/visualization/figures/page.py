"""A white page for a figure: what is written on it, and its legend."""

from dataclasses import dataclass

import cv2
import numpy as np

from uniteam.visualization.canvas import BOLD, Area, Image, TextStyle, place, write
from uniteam.visualization.colors import Color
from uniteam.visualization.figures.colors import FAINT_INK, INK, PAPER

TEXT_SIZE = 24
"""Pixels: about 8 points where a picture 1600 pixels wide is as wide as a page."""
SWATCH = 24
ROW = 38

PLAIN = TextStyle(TEXT_SIZE, INK)
STRONG = TextStyle(TEXT_SIZE, INK, BOLD)
FAINT = TextStyle(TEXT_SIZE - 2, FAINT_INK)


@dataclass(frozen=True)
class Entry:
    """A line of a legend: a colour, and what has it; `is_point` for what is drawn as a disc."""

    color: Color
    words: str
    is_point: bool = False


def white_page(width: int, height: int) -> Image:
    """Return an empty (height, width, 3) RGB page."""
    return np.full((height, width, 3), PAPER, dtype=np.uint8)


def place_titled(page: Image, picture: Image, area: Area, title: str) -> None:
    """Draw a picture into an area, and its title above it."""
    write(page, title, area.left, area.top - 12, STRONG)
    place(page, picture, area)


def draw_legend(page: Image, entries: tuple[Entry, ...], left: int, top: int) -> None:
    """Write a legend, one entry below the other."""
    for number, entry in enumerate(entries):
        y = top + number * ROW
        _swatch(page, entry, left, y)
        write(page, entry.words, left + SWATCH + 12, y + SWATCH - 4, PLAIN)


def _swatch(page: Image, entry: Entry, left: int, top: int) -> None:
    if entry.is_point:
        middle = left + SWATCH // 2, top + SWATCH // 2
        cv2.circle(page, middle, SWATCH // 2, entry.color, cv2.FILLED, cv2.LINE_AA)
        return
    page[top : top + SWATCH, left : left + SWATCH] = entry.color
    cv2.rectangle(page, (left, top), (left + SWATCH - 1, top + SWATCH - 1), FAINT_INK, 1)
