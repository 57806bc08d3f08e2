"""The head camera in Rerun: where it is, and its pictures as the recording keeps them."""

from types import ModuleType
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.recording.depth_code import STRIDE
from uniteam.evaluation.recording.recording import RecordedFrame, Recording
from uniteam.geometry import PinholeCamera
from uniteam.interface import Segmentation
from uniteam.stretch import DEPTH_RANGE
from uniteam.visualization.colors import name_color
from uniteam.visualization.rerun_file import paths

JPEG_QUALITY = 85
MILLIMETRES = 1000.0
NOTHING = 0
"""Class of a pixel that no detection has."""


class Frames:
    """Logs the pictures of a recording, moment by moment."""

    def __init__(self, rerun: ModuleType, stream: Any, recording: Recording) -> None:
        """Log the camera's intrinsics, of which those of depth are of every second pixel."""
        self._rerun, self._stream, self._recording = rerun, stream, recording
        self._classes: dict[str, int] = {}
        camera = recording.header.camera
        stream.log(paths.CAMERA, self._pinhole(camera, 1), static=True)
        stream.log(paths.DEPTH, self._pinhole(camera, STRIDE), static=True)

    def log(self, moment: int, frame: RecordedFrame) -> None:
        """Log what was seen at a moment."""
        rerun, stream = self._rerun, self._stream
        pose = self._recording.camera_to_start(moment)
        stream.log(paths.HEAD, rerun.Transform3D(translation=pose[:3, 3], mat3x3=pose[:3, :3]))
        stream.log(paths.COLOUR, rerun.EncodedImage(contents=_jpeg(frame.rgb), media_type="image/jpeg"))
        stream.log(
            paths.DEPTH,
            rerun.EncodedDepthImage(
                _png(frame.depth),
                media_type="image/png",
                meter=MILLIMETRES,
                depth_range=(0.0, DEPTH_RANGE * MILLIMETRES),
            ),
        )
        if frame.segmentation is not None:
            stream.log(paths.SEGMENTATION, rerun.SegmentationImage(self._labels(frame.segmentation), opacity=0.6))

    def finish(self) -> None:
        """Log what the classes are called, which is known only once all pictures have been seen."""
        instruction = self._recording.episode.instruction
        named = [(number, name, name_color(name, instruction)) for name, number in self._classes.items()]
        told = [(NOTHING, "nothing", (0, 0, 0, 0)), *named]
        self._stream.log(paths.CAMERA, self._rerun.AnnotationContext(told), static=True)

    def _labels(self, segmentation: Segmentation) -> NDArray[np.uint16]:
        """Return the class of each pixel: one for each name, over all pictures."""
        numbers = [self._classes.setdefault(d.name, len(self._classes) + 1) for d in segmentation.detections]
        return np.array([*numbers, NOTHING], np.uint16)[segmentation.instances]

    def _pinhole(self, camera: PinholeCamera, stride: int) -> Any:
        """Return the intrinsics of every `stride`th pixel, in Rerun's pixels, whose first has its middle at 0.5."""
        width, height = -(-camera.width // stride), -(-camera.height // stride)
        return self._rerun.Pinhole(
            resolution=(width, height),
            focal_length=(camera.fx / stride, camera.fy / stride),
            principal_point=(camera.cx / stride + 0.5, camera.cy / stride + 0.5),
            camera_xyz=self._rerun.ViewCoordinates.RDF,
            image_plane_distance=0.4,
        )


def _jpeg(rgb: NDArray[np.uint8]) -> bytes:
    return _encoded(".jpg", cv2.cvtColor(rgb, cv2.COLOR_RGB2BGR), [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])


def _png(depth: NDArray[np.float32]) -> bytes:
    """Return depth (m) in whole millimetres of 16 bits."""
    return _encoded(".png", np.rint(depth * MILLIMETRES).astype(np.uint16), [])


def _encoded(ending: str, image: NDArray[Any], options: list[int]) -> bytes:
    _, content = cv2.imencode(ending, image, options)
    return content.tobytes()
