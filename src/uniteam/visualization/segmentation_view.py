"""What perception made of an image, as a picture: segments in colour, with their names."""

from dataclasses import dataclass

import cv2
import numpy as np

from uniteam.interface import Instruction, Segmentation
from uniteam.visualization.canvas import Image, TextStyle, text_width, write_tag
from uniteam.visualization.colors import TEXT, name_color

SMALLEST_NAMED = 0.004
"""Share of the image below which a segment that the instruction does not name goes without its name."""


def draw_segmentation(rgb: Image, segmentation: Segmentation, instruction: Instruction, scale: float) -> Image:
    """Return the image in grey, enlarged, with each segment in its colour, outlined and named.

    Args:
        rgb: (H, W, 3), what was seen.
        segmentation: what it was taken for.
        instruction: its object and receptacles have colours of their own.
        scale: size of the picture over that of the image.
    """
    picture, segments = draw_segments(rgb, segmentation, instruction, scale)
    for segment in segments:
        _write_name(picture, segment)
    return picture


@dataclass(frozen=True)
class NamedSegment:
    """A segment that is large enough for its name, or that the instruction asks for.

    Attributes:
        name: its category.
        words: the name and, where it is below 1, the score.
        at: the pixel (u, v) at which it is thickest.
    """

    name: str
    words: str
    at: tuple[int, int]


def draw_segments(
    rgb: Image, segmentation: Segmentation, instruction: Instruction, scale: float
) -> tuple[Image, list[NamedSegment]]:
    """Return the picture of `draw_segmentation` without names, and whose names belong where, the foremost last."""
    size = (round(rgb.shape[1] * scale), round(rgb.shape[0] * scale))
    colored = cv2.resize(_colored(rgb, segmentation, instruction), size, interpolation=cv2.INTER_LINEAR)
    picture = colored.astype(np.uint8, copy=False)
    instances = cv2.resize(segmentation.instances, size, interpolation=cv2.INTER_NEAREST)
    asked = (instruction.object_category, instruction.start_receptacle, instruction.goal_receptacle)
    segments = []
    for index, detection in enumerate(segmentation.detections):
        mask: Image = (instances == index).astype(np.uint8)
        area = int(np.count_nonzero(mask))
        if area and (detection.name in asked or area > SMALLEST_NAMED * mask.size):
            contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
            cv2.drawContours(picture, contours, -1, name_color(detection.name, instruction), 1, cv2.LINE_AA)
            named = NamedSegment(detection.name, _words(detection.name, detection.score), _thickest(mask))
            segments.append((detection.name in asked, area, named))
    return picture, [named for _, _, named in sorted(segments, key=lambda segment: segment[:2])]


def _colored(rgb: Image, segmentation: Segmentation, instruction: Instruction) -> Image:
    """Return the image in grey, with half of each segment's colour mixed in."""
    grey = cv2.cvtColor(cv2.cvtColor(rgb, cv2.COLOR_RGB2GRAY), cv2.COLOR_GRAY2RGB).astype(np.float32)
    colors = np.array([*(name_color(d.name, instruction) for d in segmentation.detections), (0, 0, 0)], np.float32)
    tint = colors[segmentation.instances]
    share = np.where(segmentation.instances[..., None] >= 0, 0.5, 0.0)
    mixed = grey * (1.0 - share) + tint * share
    return mixed.astype(np.uint8)


def _words(name: str, score: float) -> str:
    words = name.replace("_", " ")
    return words if score >= 1.0 else f"{words} {score:.2f}"


def _thickest(mask: Image) -> tuple[int, int]:
    distance = cv2.distanceTransform(cv2.copyMakeBorder(mask, 1, 1, 1, 1, cv2.BORDER_CONSTANT), cv2.DIST_L2, 3)
    _, _, _, (u, v) = cv2.minMaxLoc(distance)
    return u, v


def _write_name(picture: Image, segment: NamedSegment) -> None:
    """Write the name where the segment is thickest, within the picture."""
    (u, v), style = segment.at, TextStyle(13, TEXT)
    width = text_width(segment.words, style) + 10
    left = min(max(u - width // 2, 0), picture.shape[1] - width)
    top = min(max(v - 9, 0), picture.shape[0] - 18)
    write_tag(picture, segment.words, left, top, style)
