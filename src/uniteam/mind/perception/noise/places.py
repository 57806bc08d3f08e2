"""Where each detection of a segmentation is, and from where it is seen."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import transform_points
from uniteam.interface import Observation, Segmentation


@dataclass(frozen=True)
class Sighting:
    """One detection in one frame.

    Attributes:
        name: what it is.
        pixels: how many show it.
        distance: m from the camera, along its axis.
        place: (3,) middle of what is seen of it (m, start frame).
        eye: (3,) where the camera is (m, start frame).
    """

    name: str
    pixels: int
    distance: float
    place: NDArray[np.float64]
    eye: NDArray[np.float64]

    @property
    def view(self) -> NDArray[np.float64]:
        """(6,) of both: the same thing from the same place has the same view."""
        return np.concatenate([self.place, self.eye])


def sightings(segmentation: Segmentation, observation: Observation) -> list[Sighting]:
    """Return where each detection of a frame is, in their order; a detection needs a pixel with depth."""
    count, camera = len(segmentation.detections), observation.camera
    rows, columns = np.nonzero(segmentation.instances >= 0)
    index = segmentation.instances[rows, columns].astype(np.intp)
    depth = observation.depth[rows, columns].astype(np.float64)
    pixels = np.bincount(index, minlength=count)
    means = [
        np.bincount(index, weights, minlength=count) / np.maximum(pixels, 1)
        for weights in (
            depth * (columns - camera.cx) / camera.fx,
            depth * (rows - camera.cy) / camera.fy,
            depth,
        )
    ]
    in_camera = np.stack(means, axis=-1)
    places, eye = transform_points(observation.camera_to_start, in_camera), observation.camera_to_start[:3, 3]
    return [
        Sighting(detection.name, int(pixels[k]), float(in_camera[k, 2]), places[k], eye)
        for k, detection in enumerate(segmentation.detections)
    ]
