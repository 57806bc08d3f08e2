"""How far a point of the floor is from the patch of floor that an instance covers."""

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import transform_points
from uniteam.world.homes.home import Home, Instance

VIEW_DISTANCE = 1.0
"""How far (m) view points may be from the footprint of what is seen from them, as in HomeRobot's episodes."""


def distance_to_footprint(home: Home, instance: Instance, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the distances (...) (m) of (..., 2) points of the floor to an instance's footprint; 0 inside.

    The footprint is the outline from above of the model's bounding box, however the instance is turned.
    """
    outline = _outline(home, instance)
    edges = np.roll(outline, -1, axis=0) - outline
    offsets = points[..., None, :] - outline
    share = np.clip((offsets * edges).sum(axis=-1) / (edges**2).sum(axis=-1), 0.0, 1.0)
    to_edges = np.linalg.norm(offsets - share[..., None] * edges, axis=-1).min(axis=-1)
    sides = edges[:, 0] * offsets[..., 1] - edges[:, 1] * offsets[..., 0]
    is_inside = (sides >= 0.0).all(axis=-1) | (sides <= 0.0).all(axis=-1)
    return np.where(is_inside, 0.0, to_edges)


def _outline(home: Home, instance: Instance) -> NDArray[np.float64]:
    """Return the (V, 2) corners (m, world) of an instance's footprint, in their order around it."""
    width, depth, height = home.model_of(instance).size
    corners = np.array(
        [[x, y, z] for x in (-width / 2, width / 2) for y in (-depth / 2, depth / 2) for z in (0, height)]
    )
    seen = transform_points(instance.model_to_world(), corners)[:, :2]
    return seen[cv2.convexHull(seen.astype(np.float32), returnPoints=False)[:, 0]]
