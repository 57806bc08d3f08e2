"""Crops of a view for the namer: of every thing that can be told, and of regions that are no whole thing."""

from collections.abc import Iterator

import cv2
import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from uniteam.mind.perception.learned.crops import GREY, Square, cut, square_around
from uniteam.mind.perception.learned.region_shape import region_shape
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.training.records import CropRecord, Thing, jpeg, png
from uniteam.training.views import View

STORED_SIZE = 176
STORED_MARGIN = 1.8
"""Of what is kept, so that training can shift and scale the crop."""
FEWEST_PIXELS = {"object": 40, "receptacle": 300, "decor": 300}
"""Of a thing in the half-size frame, by its role; what is smaller cannot be told."""
FARTHEST = 5.0
"""m; of an object."""
JUNK_A_VIEW = 2


def crops_of(view: View, things: list[Thing], rng: Generator) -> Iterator[CropRecord]:
    """Yield the crops of a view: of the things that have names, and last of what is no whole thing."""
    pixels = np.bincount(view.half.instances.ravel() + 1, minlength=len(things) + 1)[1:]
    for index in np.flatnonzero(pixels):
        thing = things[index]
        if not thing.category or pixels[index] < FEWEST_PIXELS.get(thing.role, view.half.depth.size):
            continue
        mask = view.half.instances == index
        if thing.role == "object" and np.median(view.half.depth[mask]) > FARTHEST:
            continue
        yield crop_record(view, mask, thing)
    for _ in range(JUNK_A_VIEW):
        part = _no_whole_thing(view, things, pixels, rng)
        if np.count_nonzero(part) >= FEWEST_PIXELS["object"]:
            yield crop_record(view, part, None)


def crop_record(view: View, mask: NDArray[np.bool_], thing: Thing | None) -> CropRecord:
    """Return the crop of a region given by its mask at half size."""
    square, factor = square_around(mask, STORED_MARGIN), view.fine.rgb.shape[0] // mask.shape[0]
    fine = Square(square.x * factor + (factor - 1) / 2.0, square.y * factor + (factor - 1) / 2.0, square.side * factor)
    shape = region_shape(mask, view.half.depth, HEAD_CAMERA_HALF, view.camera_to_start)
    return CropRecord(
        jpeg(cut(view.fine.rgb, fine, STORED_SIZE, GREY)),
        png(cut(mask.astype(np.uint8) * 255, square, STORED_SIZE, 0)),
        fine.side,
        [float(v) for v in shape],
        thing,
        int(np.count_nonzero(mask)),
    )


def _no_whole_thing(view: View, things: list[Thing], pixels: NDArray[np.int64], rng: Generator) -> NDArray[np.bool_]:
    """Return the mask of a piece of furniture, or of wall and floor, within a random ellipse."""
    height, width = view.half.instances.shape
    large = [i for i in np.flatnonzero(pixels >= 800) if things[i].role in ("receptacle", "decor", "door")]
    if large and rng.random() < 0.75:
        whole = view.half.instances == large[rng.integers(len(large))]
    else:
        whole = view.half.instances < 0
    rows, columns = np.nonzero(whole)
    if len(rows) == 0:
        return whole
    middle = rng.integers(len(rows))
    axes = tuple(int(v) for v in rng.uniform(4.0, 45.0, 2) * rng.uniform(0.5, 1.0))
    ellipse = np.zeros((height, width), np.uint8)
    centre = (int(columns[middle]), int(rows[middle]))
    cv2.ellipse(ellipse, centre, axes, float(rng.uniform(0.0, 180.0)), 0.0, 360.0, 1, -1)
    part = whole & (ellipse > 0)
    is_most_of_it = np.count_nonzero(part) > 0.5 * np.count_nonzero(whole)
    return np.zeros_like(whole) if is_most_of_it else part
