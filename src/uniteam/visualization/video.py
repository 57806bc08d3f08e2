"""Films as MP4 files that browsers play (H.264), written frame by frame and playable wherever they are cut off."""

import logging
import os
from fractions import Fraction
from pathlib import Path

import av
import numpy as np

from uniteam.errors import InvalidInputError
from uniteam.files import UnwritableError, try_output
from uniteam.visualization.canvas import Image

FRAMES_PER_SECOND = 10

_KEY_FRAMES = 2 * FRAMES_PER_SECOND
"""Frames from one key frame to the next: no more than these are missing from a film that was cut off."""

_WHILE_WRITING = {"movflags": "frag_keyframe+empty_moov+default_base_moof", "flush_packets": "1"}
"""Fragments that each play by themselves."""

_FINISHED = {"movflags": "faststart"}
"""One index before the pictures: a browser begins at once and finds every place."""

_log = logging.getLogger(__name__)


class VideoWriter:
    """Writes RGB frames of one size to an MP4 file."""

    def __init__(self, path: Path, width: int, height: int, frames_per_second: int = FRAMES_PER_SECOND) -> None:
        """Open the file.

        Args:
            path: ending in .mp4; its folder is made where it is missing.
            width: of a frame (px), even.
            height: of a frame (px), even.
            frames_per_second: at which it will be played.

        Raises:
            InvalidInputError: the path does not end in .mp4 or is a folder, or the size is odd.
            UnwritableError: the file cannot be written.
        """
        if width % 2 or height % 2:
            raise InvalidInputError(f"a film's width and height must be even, got {width}x{height}")
        try_output(path, (".mp4",))
        self.path = path
        self._shape = (height, width, 3)
        try:
            self._container = av.open(str(path), "w", format="mp4", options=_WHILE_WRITING)
            self._stream = self._container.add_stream("libx264", rate=frames_per_second)
            self._stream.width, self._stream.height, self._stream.pix_fmt = width, height, "yuv420p"
            self._stream.time_base = Fraction(1, frames_per_second)
            self._stream.gop_size = _KEY_FRAMES
            self._stream.options = {"preset": "veryfast", "tune": "zerolatency", "crf": "21"}
        except (OSError, av.FFmpegError) as error:
            raise UnwritableError(path, error) from error

    def add(self, frame: Image, repeat: int = 1) -> None:
        """Append a (height, width, 3) RGB frame, `repeat` times; raises UnwritableError."""
        if frame.shape != self._shape:
            raise InvalidInputError(f"this film's frames are {self._shape}, got {frame.shape}")
        try:
            for _ in range(repeat):
                picture = av.VideoFrame.from_ndarray(np.ascontiguousarray(frame), format="rgb24")
                self._container.mux(self._stream.encode(picture))
        except (OSError, av.FFmpegError) as error:
            raise UnwritableError(self.path, error) from error

    def close(self) -> None:
        """Finish the file; raises UnwritableError where what was added did not get there."""
        try:
            self._container.mux(self._stream.encode())
            self._container.close()
        except (OSError, av.FFmpegError) as error:
            raise UnwritableError(self.path, error) from error
        _index(self.path)


def _index(path: Path) -> None:
    """Rewrite a film of fragments with one index at its beginning; without room for that it stays as it is."""
    indexed = path.with_name(f"{path.name}.{os.getpid()}.partial")
    if not path.is_file():  # a pipe or a device
        return
    try:
        with av.open(str(path)) as source, av.open(str(indexed), "w", format="mp4", options=_FINISHED) as target:
            (stream,) = source.streams.video
            copy = target.add_stream_from_template(stream)
            for packet in source.demux(stream):
                if packet.dts is not None:
                    packet.stream = copy
                    target.mux(packet)
        indexed.replace(path)
    except (OSError, av.FFmpegError) as error:
        _log.warning("the film %s plays, but could not be given an index: %s", path, error)
    finally:
        indexed.unlink(missing_ok=True)
