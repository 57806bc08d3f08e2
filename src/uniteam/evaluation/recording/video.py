"""Images of a kind as a film in memory: H.264, of which every picture or every bit comes back, as the kind says."""

import io
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import av
import cv2
import numpy as np
from av.video.reformatter import ColorRange
from numpy.typing import NDArray

FRAMES_PER_SECOND = 10
KEY_FRAMES = 50
"""Frames from one that can be decoded by itself to the next."""

Image = NDArray[np.uint8]


def _in_planes(image: Image) -> Image:
    """Return (3 H / 2, W): the brightness of an (H, W, 3) RGB image above its colours, at half their size."""
    return np.asarray(cv2.cvtColor(image, cv2.COLOR_RGB2YUV_I420), np.uint8)


def _as_it_is(image: Image) -> Image:
    return image


@dataclass(frozen=True)
class VideoKind:
    """How images are encoded.

    Attributes:
        array_format: of an image, as PyAV calls it: "rgb24" is (H, W, 3) uint8, "gray" is (H, W) uint8.
        pixel_format: of the film.
        options: of the encoder x264.
        convert: from an image to the film's pixels.
    """

    array_format: str
    pixel_format: str
    options: Mapping[str, str]
    convert: Callable[[Image], Image] = _as_it_is


_CABAC = {"preset": "ultrafast", "x264-params": "cabac=1:deblock=0,0:no-deblock=0"}
"""The fastest preset, but for what makes a film a tenth smaller at the same quality."""

COLOUR = VideoKind("rgb24", "yuv420p", {**_CABAC, "crf": "25", "maxrate": "120k", "bufsize": "600k"}, _in_planes)
"""With losses, hardly seen but where much changes at once: no more than 1,500 bytes an image on average."""

BYTES = VideoKind("gray", "gray", {**_CABAC, "qp": "0"})
"""Every byte comes back."""


class VideoEncoder:
    """Takes images of one shape in and gives the film as bytes."""

    def __init__(self, kind: VideoKind, height: int, width: int) -> None:
        """Begin a film of images of `height` and `width` (px); an odd one is filled up by its last row or column."""
        self._kind = kind
        self._margins = (height % 2, width % 2)
        self._content = io.BytesIO()
        self._container = av.open(self._content, "w", format="mp4")
        self._stream = self._container.add_stream("libx264", rate=FRAMES_PER_SECOND)
        self._stream.height, self._stream.width = height + height % 2, width + width % 2
        self._stream.pix_fmt = kind.pixel_format
        if kind.pixel_format == "gray":
            self._stream.codec_context.color_range = ColorRange.JPEG  # or readers stretch what they take for 16 to 235
        self._stream.time_base = Fraction(1, FRAMES_PER_SECOND)
        self._stream.codec_context.thread_count = 1  # the same bytes every time, and no core of another worker
        self._stream.gop_size = KEY_FRAMES
        self._stream.options = {**kind.options, "tune": "zerolatency"}

    def add(self, image: Image) -> None:
        """Append an image."""
        if any(self._margins):
            image = np.pad(image, [(0, margin) for margin in self._margins] + [(0, 0)] * (image.ndim - 2), "edge")
        frame = av.VideoFrame.from_ndarray(
            np.ascontiguousarray(self._kind.convert(image)), format=self._kind.pixel_format
        )
        self._container.mux(self._stream.encode(frame))

    def finish(self) -> bytes:
        """Return the whole film, an MP4 file."""
        self._container.mux(self._stream.encode())
        self._container.close()
        return self._content.getvalue()


def decode_video(content: bytes, kind: VideoKind, height: int, width: int) -> Iterator[Image]:
    """Yield a film's images, one by one.

    Raises:
        ValueError: the content is no film.
    """
    try:
        with av.open(io.BytesIO(content), "r") as container:
            for frame in container.decode(video=0):
                image: NDArray[Any] = frame.to_ndarray(format=kind.array_format)
                yield image[:height, :width]
    except av.FFmpegError as error:
        raise ValueError(f"a film in it cannot be decoded: {error}") from error
