"""What is in a frame before anybody asks for it: regions, each with a vector of meaning."""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import PinholeCamera
from uniteam.interface import Observation
from uniteam.mind.perception.learned.crops import region_crop
from uniteam.mind.perception.learned.geometry_image import geometry_image
from uniteam.mind.perception.learned.networks import WEIGHTS, Network, as_input
from uniteam.mind.perception.learned.region_shape import region_shape
from uniteam.mind.perception.learned.regions import Region, find_regions
from uniteam.stretch import HEAD_CAMERA_HALF

HALF_HEIGHT, HALF_WIDTH = HEAD_CAMERA_HALF.height, HEAD_CAMERA_HALF.width
"""The size at which frames are segmented; a finer frame is used for the names."""


@dataclass(frozen=True)
class Glimpse:
    """A region and what the namer makes of it.

    Attributes:
        region: its mask has the half size.
        vector: (DIMENSIONS,) float32 of unit length, in the space of the words.
        junk: logit of its being no whole thing.
    """

    region: Region
    vector: NDArray[np.float32]
    junk: float


@dataclass(frozen=True)
class HalfFrame:
    """A frame at the size at which it is segmented, and the colours at the finest size there is."""

    rgb: NDArray[np.uint8]
    fine_rgb: NDArray[np.uint8]
    depth: NDArray[np.float32]
    camera: PinholeCamera


class Eyes:
    """The two networks: where things are, and what they are."""

    def __init__(self, folder: Path = WEIGHTS) -> None:
        """Load them; raises DamagedFileError where a file cannot be read."""
        self._segmenter, self._namer = _network(folder / "segmenter.onnx"), _network(folder / "namer.onnx")
        self._seen: tuple[PinholeCamera, tuple[NDArray[np.generic], ...]] | None = None
        self._glimpses: list[Glimpse] = []

    def look(self, observation: Observation) -> list[Glimpse]:
        """Return what may be things in an observation; the networks are not asked again about what they saw last.

        A simulated robot that waits, or is blocked, sees the same to the bit.
        """
        arrays = observation.rgb, observation.depth, observation.camera_to_start
        if not self._has_seen(observation.camera, arrays):
            frame, to_start = half_frame(observation), observation.camera_to_start
            self._glimpses = self.name(_segmented(self._segmenter, frame, to_start), frame, to_start)
            self._seen = observation.camera, tuple(array.copy() for array in arrays)
        return list(self._glimpses)

    def _has_seen(self, camera: PinholeCamera, arrays: tuple[NDArray[np.generic], ...]) -> bool:
        """Return whether just this was seen last."""
        if self._seen is None or self._seen[0] != camera:
            return False
        return all(np.array_equal(array, seen) for array, seen in zip(arrays, self._seen[1], strict=True))

    def name(self, regions: list[Region], frame: HalfFrame, camera_to_start: NDArray[np.float64]) -> list[Glimpse]:
        """Return what the namer makes of regions of a frame."""
        if not regions:
            return []
        crops = np.stack([region_crop(frame.fine_rgb, region.mask) for region in regions])
        shapes = np.stack([region_shape(region.mask, frame.depth, frame.camera, camera_to_start) for region in regions])
        vectors, junk = self._namer(as_input(crops), shapes)
        return [Glimpse(r, v, float(j)) for r, v, j in zip(regions, vectors, junk, strict=True)]


@lru_cache(maxsize=4)
def _network(path: Path) -> Network:
    """Return the network of a file, loaded once a process: it remembers nothing, so every agent can share it."""
    return Network(path)


def segmented(segmenter: Network, observation: Observation) -> list[Region]:
    """Return the regions that a segmenter finds in an observation, before any of them is named."""
    return _segmented(segmenter, half_frame(observation), observation.camera_to_start)


def _segmented(segmenter: Network, frame: HalfFrame, camera_to_start: NDArray[np.float64]) -> list[Region]:
    geometry = geometry_image(frame.depth, frame.camera, camera_to_start)
    logits = segmenter(as_input(frame.rgb[None]), geometry[None])[0][0]
    return find_regions(logits, frame.depth)


def half_frame(observation: Observation) -> HalfFrame:
    """Return an observation at half size, and its colours as fine as they are."""
    camera, rgb, depth = observation.camera, observation.rgb, observation.depth
    if (camera.height, camera.width) == (HALF_HEIGHT, HALF_WIDTH):
        return HalfFrame(rgb, rgb, depth, camera)
    across, down = HALF_WIDTH / camera.width, HALF_HEIGHT / camera.height
    half = PinholeCamera(
        HALF_WIDTH, HALF_HEIGHT, camera.fx * across, camera.fy * down,
        (camera.cx + 0.5) * across - 0.5, (camera.cy + 0.5) * down - 0.5,
    )  # fmt: skip
    size = (HALF_WIDTH, HALF_HEIGHT)
    small = np.asarray(cv2.resize(rgb, size, interpolation=cv2.INTER_AREA), dtype=np.uint8)
    return HalfFrame(small, rgb, np.asarray(cv2.resize(depth, size, interpolation=cv2.INTER_NEAREST)), half)
