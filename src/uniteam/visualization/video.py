"""Films as MP4 files, written frame by frame."""

from pathlib import Path

import cv2
import numpy as np

from uniteam.errors import InvalidInputError
from uniteam.visualization.canvas import Image

FRAMES_PER_SECOND = 10


class VideoWriter:
    """Writes RGB frames of one size to an MP4 file (MPEG-4 part 2, which every OpenCV wheel can write)."""

    def __init__(self, path: Path, width: int, height: int, frames_per_second: float = FRAMES_PER_SECOND) -> None:
        """Open the file.

        Raises:
            InvalidInputError: the path does not end in .mp4, or cannot be written.
        """
        if path.suffix != ".mp4":
            raise InvalidInputError(f"a film is an .mp4 file, '{path}' is not; name it '{path.with_suffix('.mp4')}'")
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InvalidInputError(f"the film cannot be written to '{path}': {error}") from error
        self._shape = (height, width, 3)
        code = cv2.VideoWriter.fourcc(*"mp4v")
        self._writer = cv2.VideoWriter(str(path), code, frames_per_second, (width, height))
        if not self._writer.isOpened():
            raise InvalidInputError(f"the film cannot be written to '{path}'")

    def add(self, frame: Image, repeat: int = 1) -> None:
        """Append a (height, width, 3) RGB frame, `repeat` times."""
        if frame.shape != self._shape:
            raise InvalidInputError(f"this film's frames are {self._shape}, got {frame.shape}")
        for _ in range(repeat):
            self._writer.write(np.ascontiguousarray(frame[:, :, ::-1]))

    def close(self) -> None:
        """Finish the file."""
        self._writer.release()
