"""The films of an episode: what the camera showed, and what the perception made of it."""

import numpy as np

from uniteam.evaluation.recording.depth_code import encode_depth
from uniteam.evaluation.recording.label_video import LabelEncoder
from uniteam.evaluation.recording.video import BYTES, COLOUR, VideoEncoder
from uniteam.interface import Observation, Segmentation

COLOUR_FILM, DEPTH_FILM = "camera/colour.mp4", "camera/depth.mp4"
LABEL_FILM, HIGH_LABEL_FILM = "camera/segmentation.mp4", "camera/segmentation_high.mp4"
"""The films' names in the archive; the last is there only where an image has more than 254 detections."""


class CameraFilms:
    """Takes in what is seen and what the perception answers."""

    def __init__(self, height: int, width: int) -> None:
        """Begin the films of a camera of `height` and `width` (px)."""
        self._nothing = Segmentation(np.full((height, width), -1, np.int16), ())
        self._colour = VideoEncoder(COLOUR, height, width)
        self._depth = VideoEncoder(BYTES, *encode_depth(np.zeros((height, width), np.float32)).shape)
        self._segmentation = LabelEncoder(height, width)

    def add(self, seen: Observation, segmentation: Segmentation | None) -> None:
        """Append a picture to each film; no segmentation is one without detections."""
        self._colour.add(seen.rgb)
        self._depth.add(encode_depth(seen.depth))
        self._segmentation.add(self._nothing if segmentation is None else segmentation)

    def members(self) -> dict[str, bytes]:
        """Return the whole films by their names in the archive."""
        low, high = self._segmentation.finish()
        return {
            COLOUR_FILM: self._colour.finish(),
            DEPTH_FILM: self._depth.finish(),
            LABEL_FILM: low,
            **({HIGH_LABEL_FILM: high} if high else {}),
        }
