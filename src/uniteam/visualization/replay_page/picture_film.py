"""What camera, perception and an onlooker saw, side by side in one film: so they are always of the same moment."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import cv2
import numpy as np

from uniteam.evaluation.recording.body import RecordedBody
from uniteam.evaluation.recording.recording import RecordedFrame, Recording
from uniteam.evaluation.recording.video import COLOUR, FRAMES_PER_SECOND, VideoEncoder
from uniteam.interface import Instruction
from uniteam.visualization.canvas import Area, Image, blank
from uniteam.visualization.replay_page.packing import letters, packed
from uniteam.visualization.segmentation_view import NamedSegment, draw_segments

CAMERA_HEIGHT = 320
"""Of the camera's picture in the film (px)."""

WATCHED_SIZE = 400
"""Width and height of the third person's (px)."""

_FILM = replace(
    COLOUR,
    options={
        "preset": "veryfast",
        "crf": "28",
        "maxrate": "240k",
        "bufsize": "960k",
        # Key frames are near each other, for scrubbing; the colours are told, or browsers guess by the film's size.
        "x264-params": "keyint=12:colorprim=smpte170m:transfer=smpte170m:colormatrix=smpte170m",
    },
)


@dataclass(frozen=True)
class _Layout:
    """Where the pictures lie in the film's."""

    camera: Area
    segmentation: Area
    third_person: Area

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the whole (px), even."""
        right = max(area.left + area.width for area in (self.segmentation, self.third_person))
        return right + right % 2, self.third_person.top + self.third_person.height


def film_data(recording: Recording, advance: Callable[[], None]) -> dict[str, Any]:
    """Return the film of all moments and the segments' names, as plain data; `advance` is called after each moment."""
    layout, body = _layout(recording), RecordedBody(recording)
    width, height = layout.size
    encoder, names = VideoEncoder(_FILM, height, width), _Names(recording.episode.instruction)
    for moment, frame in enumerate(recording.frames()):
        picture = blank(width, height)
        _put(picture, layout.camera, frame.rgb)
        _put(picture, layout.segmentation, _segments(frame, recording, names))
        size = (layout.third_person.width, layout.third_person.height)
        _put(picture, layout.third_person, body.from_above(moment, size))
        encoder.add(picture)
        advance()
    return {
        "film": letters(encoder.finish()),
        "framesPerSecond": FRAMES_PER_SECOND,
        "areas": {name: [a.left, a.top, a.width, a.height] for name, a in vars(layout).items()},
        "names": names.data(),
    }


def _layout(recording: Recording) -> _Layout:
    camera = recording.header.camera
    width = 2 * round(CAMERA_HEIGHT * camera.width / camera.height / 2.0)
    return _Layout(
        Area(0, 0, width, CAMERA_HEIGHT),
        Area(width, 0, width, CAMERA_HEIGHT),
        Area(0, CAMERA_HEIGHT, WATCHED_SIZE, WATCHED_SIZE),
    )


def _put(picture: Image, area: Area, content: Image) -> None:
    size = (area.width, area.height)
    fitting = content if content.shape[1::-1] == size else cv2.resize(content, size, interpolation=cv2.INTER_AREA)
    picture[area.top : area.top + area.height, area.left : area.left + area.width] = fitting


def _segments(frame: RecordedFrame, recording: Recording, names: "_Names") -> Image:
    if frame.segmentation is None:
        names.add([], 1, 1)
        return np.asarray(cv2.cvtColor(cv2.cvtColor(frame.rgb, cv2.COLOR_RGB2GRAY), cv2.COLOR_GRAY2RGB), np.uint8)
    picture, segments = draw_segments(frame.rgb, frame.segmentation, recording.episode.instruction, 1.0)
    names.add(segments, frame.rgb.shape[1], frame.rgb.shape[0])
    return picture


class _Names:
    """The segments' names of each moment: each written once, and where it stands as shares of the picture."""

    def __init__(self, instruction: Instruction) -> None:
        self._parts = {
            instruction.goal_receptacle: "goal",
            instruction.start_receptacle: "start",
            instruction.object_category: "object",
        }
        self._words: dict[tuple[str, str], int] = {}
        self._counts: list[int] = []
        self._places: list[tuple[int, int, int]] = []

    def add(self, segments: list[NamedSegment], width: int, height: int) -> None:
        """Take in those of the next moment."""
        self._counts.append(len(segments))
        for segment in segments:
            key = (segment.words, self._parts.get(segment.name, "other"))
            number = self._words.setdefault(key, len(self._words))
            u, v = segment.at
            self._places.append((number, round(1000 * u / width), round(1000 * v / height)))

    def data(self) -> dict[str, Any]:
        """Return them as plain data."""
        return {
            "words": [list(key) for key in self._words],
            "counts": packed(np.array(self._counts, np.uint16)),
            "places": packed(np.array(self._places, np.uint16).reshape(-1, 3)),
        }
