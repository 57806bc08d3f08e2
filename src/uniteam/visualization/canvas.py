"""A picture to lay things out on: boxes, images that keep their proportions, and text that wraps."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.visualization.colors import BACKGROUND, FRAME, TEXT, Color

Image = NDArray[np.uint8]

REGULAR = 400
BOLD = 700
LINE_SPACING = 1.35

_FONT = cv2.FontFace("sans")


@dataclass(frozen=True)
class Area:
    """A rectangle of pixels: its upper left corner, width and height."""

    left: int
    top: int
    width: int
    height: int


@dataclass(frozen=True)
class TextStyle:
    """How text looks: size in pixels, colour, weight (400 regular, 700 bold)."""

    size: int = 16
    color: Color = TEXT
    weight: int = REGULAR


def blank(width: int, height: int) -> Image:
    """Return an empty (height, width, 3) RGB picture."""
    return np.full((height, width, 3), BACKGROUND, dtype=np.uint8)


def place(canvas: Image, picture: Image, area: Area) -> None:
    """Draw a picture into an area, as large as fits without distortion, in the middle, with a thin frame."""
    scale = min(area.width / picture.shape[1], area.height / picture.shape[0])
    width, height = round(picture.shape[1] * scale), round(picture.shape[0] * scale)
    resized = cv2.resize(picture, (width, height), interpolation=cv2.INTER_AREA if scale < 1 else cv2.INTER_LINEAR)
    left, top = area.left + (area.width - width) // 2, area.top + (area.height - height) // 2
    canvas[top : top + height, left : left + width] = resized
    cv2.rectangle(canvas, (left - 1, top - 1), (left + width, top + height), FRAME, 1)


def write(canvas: Image, text: str, left: int, baseline: int, style: TextStyle = TextStyle()) -> int:
    """Write one line and return the x (px) where it ends."""
    cv2.putText(canvas, text, (left, baseline), style.color, _FONT, style.size, style.weight, wrap=(0, 100_000))
    return left + text_width(text, style)


def write_wrapped(canvas: Image, text: str, area: Area, style: TextStyle = TextStyle()) -> int:
    """Write lines broken between words to fit the area, ending in … where it is full; return the y (px) below them."""
    step = round(style.size * LINE_SPACING)
    lines = wrap(text, area.width, style)
    room = max(area.height // step, 1)
    if len(lines) > room:
        lines = [*lines[: room - 1], _shorten(" ".join(lines[room - 1 :]), area.width, style)]
    for number, line in enumerate(lines):
        write(canvas, line, area.left, area.top + style.size + number * step, style)
    return area.top + len(lines) * step


def wrap(text: str, width: int, style: TextStyle) -> list[str]:
    """Return the text broken between words into lines that fit the width (px)."""
    lines: list[str] = []
    for word in text.split():
        if lines and text_width(f"{lines[-1]} {word}", style) <= width:
            lines[-1] += f" {word}"
        else:
            lines.append(word)
    return lines


def write_tag(canvas: Image, text: str, left: int, top: int, style: TextStyle) -> None:
    """Write a short text on a dark patch, to be legible over a picture."""
    width, pad = text_width(text, style), style.size // 3
    bottom, right = top + style.size + pad, left + width + 2 * pad
    canvas[max(top, 0) : bottom, max(left, 0) : right] = canvas[max(top, 0) : bottom, max(left, 0) : right] // 4
    write(canvas, text, left + pad, top + style.size - 1, style)


def text_width(text: str, style: TextStyle) -> int:
    """Return the width (px) of one line of text."""
    _, _, width, _ = cv2.getTextSize((100_000, 1_000), text, (0, 0), _FONT, style.size, style.weight)
    return int(width)


def _shorten(text: str, width: int, style: TextStyle) -> str:
    while text and text_width(text + "…", style) > width:
        text = text[:-1]
    return text + "…"
