"""The films of one camera: pictures of many episodes one after the other, a new file once one is large."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

import av
import numpy as np
from numpy.typing import NDArray

from uniteam.adapters.lerobot.layout import FRAMES_PER_SECOND, VIDEO_FILE_MB, FileNumber, video_file

KEY_FRAMES = 2
"""Frames from one that can be decoded by itself to the next: learners ask for single ones."""


@dataclass(frozen=True)
class FilmKind:
    """How pictures are encoded.

    Attributes:
        codec: of FFmpeg.
        called: the codec's name in `info.json`.
        pixel_format: of the film.
        array_format: of a picture, as PyAV calls it.
        channels: of a picture.
        options: of the encoder.
        told: what else `info.json` says of the film.
    """

    codec: str
    called: str
    pixel_format: str
    array_format: str
    channels: int
    options: Mapping[str, str]
    told: Mapping[str, Any]


COLOUR = FilmKind(
    "libx264",
    "h264",
    "yuv420p",
    "rgb24",
    3,
    {"preset": "veryfast", "crf": "20", "bf": "0", "tune": "zerolatency"},
    {"video.crf": 20, "video.preset": "veryfast", "is_depth_map": False},
)
"""With losses that are hardly seen."""


@dataclass(frozen=True)
class FilmPlace:
    """Where the pictures of an episode are.

    Attributes:
        file: which of the camera's.
        begins: of the first (s into the film).
        ends: of the last, when it has been shown (s).
    """

    file: FileNumber
    begins: float
    ends: float


class FilmSeries:
    """Takes the pictures of one camera in, episode by episode."""

    def __init__(self, root: Path, key: str, kind: FilmKind, size: tuple[int, int]) -> None:
        """Begin without a file.

        Args:
            root: folder of the dataset.
            key: name of the feature.
            kind: how pictures are encoded.
            size: their height and width (px), both even.
        """
        self._path_of: Callable[[FileNumber], Path] = lambda number: root / video_file(key, number)
        self._kind, self._size = kind, size
        self._number: FileNumber | None = None
        self._container: Any = None
        self._count = self._began = self._bytes = 0

    def begin_episode(self) -> None:
        """Begin a new file where there is none yet, or the last is large."""
        if self._number is None:
            self._open(FileNumber(0, 0))
        elif self._bytes >= VIDEO_FILE_MB << 20:
            self.close()
            self._open(self._number.next())
        self._began = self._count

    def add(self, picture: NDArray[Any]) -> None:
        """Append a picture."""
        frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(picture), format=self._kind.array_format)
        frame = frame.reformat(format=self._kind.pixel_format)
        frame.pts, frame.time_base = self._count, Fraction(1, FRAMES_PER_SECOND)
        packets = self._stream.encode(frame)
        self._container.mux(packets)
        self._bytes += sum(packet.size for packet in packets)
        self._count += 1

    def end_episode(self) -> FilmPlace:
        """Return where the pictures since `begin_episode` are."""
        assert self._number is not None, "an episode has begun"
        return FilmPlace(self._number, self._began / FRAMES_PER_SECOND, self._count / FRAMES_PER_SECOND)

    def close(self) -> None:
        """Finish the file."""
        if self._container is not None:
            self._container.mux(self._stream.encode())
            self._container.close()
            self._container = None

    def _open(self, number: FileNumber) -> None:
        path = self._path_of(number)
        path.parent.mkdir(parents=True, exist_ok=True)
        self._container = av.open(str(path), "w", format="mp4")
        self._stream: Any = self._container.add_stream(self._kind.codec, rate=FRAMES_PER_SECOND)
        self._stream.height, self._stream.width = self._size
        self._stream.pix_fmt = self._kind.pixel_format
        self._stream.time_base = Fraction(1, FRAMES_PER_SECOND)
        self._stream.codec_context.thread_count = 1  # with the encoder's options, the same bytes every time
        self._stream.gop_size = KEY_FRAMES
        self._stream.options = dict(self._kind.options)
        self._number, self._count, self._bytes = number, 0, 0


def film_info(kind: FilmKind, size: tuple[int, int]) -> dict[str, Any]:
    """Return what `info.json` says of films of a kind."""
    return {
        "video.height": size[0],
        "video.width": size[1],
        "video.codec": kind.called,
        "video.pix_fmt": kind.pixel_format,
        "video.fps": FRAMES_PER_SECOND,
        "video.channels": kind.channels,
        "video.g": KEY_FRAMES,
        "has_audio": False,
        **kind.told,
    }
