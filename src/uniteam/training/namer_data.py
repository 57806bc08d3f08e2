"""What the namer learns from: crops drawn so that rare names are not rare, changed at each draw."""

import math
import zlib
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from uniteam.mind.perception.learned.crops import CROP_MARGIN, CROP_SIZE, GREY, greyed
from uniteam.training.augmentation import relit
from uniteam.training.crop_samples import STORED_MARGIN, STORED_SIZE
from uniteam.training.records import CropRecord, Thing, from_jpeg, from_png

JUNK = -1
"""The label of what is no whole thing."""
SHARES = {"object": 0.46, "receptacle": 0.34, "decor": 0.04, "junk": 0.16}
"""Of the roles in what is drawn."""
HELD_OUT = 7
"""One model in so many is kept from training, to validate and to calibrate with."""


@dataclass(frozen=True)
class CropBatch:
    """Crops as the network takes them.

    Attributes:
        crops: (N, CROP_SIZE, CROP_SIZE, 3) uint8.
        shapes: (N, SHAPE_NUMBERS) float32.
        labels: (N,) int64, index of the name, JUNK for no whole thing.
    """

    crops: NDArray[np.uint8]
    shapes: NDArray[np.float32]
    labels: NDArray[np.int64]


def is_held_out(model: str) -> bool:
    """Return whether a training model is kept from training; by its name, so that it stays so."""
    return zlib.crc32(model.encode()) % HELD_OUT == 0


def role_of(thing: Thing | None) -> str:
    """Return the role of what a crop shows."""
    return "junk" if thing is None else thing.role


class CropSampler:
    """Draws crops: the roles by `SHARES`, within a role each name by the root of how often it occurs."""

    def __init__(self, crops: Sequence[CropRecord], names: Sequence[str]) -> None:
        """Take the crops, and the names in the order of their labels; crops of other names are left out."""
        self._names = {name: index for index, name in enumerate(names)}
        self._crops = [c for c in crops if c.thing is None or c.thing.category in self._names]
        labels = [(role_of(c.thing), c.thing.category if c.thing else "") for c in self._crops]
        of_label, of_role = Counter(labels), Counter[str]()
        for label, count in of_label.items():
            of_role[label[0]] += math.sqrt(count)  # type: ignore[assignment]
        weights = [SHARES.get(r, 0.0) / of_role[r] / math.sqrt(of_label[r, n]) for r, n in labels]
        self._chances = np.array(weights) / np.sum(weights)

    def batch(self, size: int, rng: Generator) -> CropBatch:
        """Return a batch."""
        chosen = rng.choice(len(self._crops), size=size, p=self._chances)
        return self._batch([self._crops[i] for i in chosen], [varied(self._crops[i], rng) for i in chosen], rng)

    def _batch(self, crops: list[CropRecord], images: list[NDArray[np.uint8]], rng: Generator) -> CropBatch:
        shapes = np.array([crop.shape for crop in crops], dtype=np.float32)
        shapes[:, 1:4] += rng.normal(0.0, 0.06, (len(crops), 3))
        shapes[:, 5:7] += rng.normal(0.0, 0.02, (len(crops), 2))
        shapes[rng.random(len(crops)) < 0.15, :7] = 0.0
        return CropBatch(np.stack(images), shapes, self.labels(crops))

    def labels(self, crops: Sequence[CropRecord]) -> NDArray[np.int64]:
        """Return the (N,) labels of crops."""
        return np.array([JUNK if c.thing is None else self._names[c.thing.category] for c in crops], dtype=np.int64)


def plain_batch(crops: Sequence[CropRecord], names: Sequence[str]) -> CropBatch:
    """Return crops as they are, for validation."""
    index = {name: label for label, name in enumerate(names)}
    images = [warped(from_jpeg(c.rgb), from_png(c.mask).astype(np.uint8), 0.0, 0.0, CROP_MARGIN) for c in crops]
    labels = [JUNK if c.thing is None else index.get(c.thing.category, JUNK) for c in crops]
    shapes = np.array([c.shape for c in crops], dtype=np.float32)
    return CropBatch(np.stack([greyed(*image) for image in images]), shapes, np.array(labels, dtype=np.int64))


def varied(crop: CropRecord, rng: Generator) -> NDArray[np.uint8]:
    """Return the (CROP_SIZE, CROP_SIZE, 3) image of a crop as another look could have given it."""
    image, mask = from_jpeg(crop.rgb), from_png(crop.mask).astype(np.uint8)
    if rng.random() < 0.3 and crop.side < 2 * STORED_SIZE:  # as a half-size frame shows it
        small = max(6, round(crop.side / 2))
        coarse = cv2.resize(image, (small, small), interpolation=cv2.INTER_AREA)
        image = np.asarray(cv2.resize(coarse, (STORED_SIZE, STORED_SIZE)), dtype=np.uint8)
    grow = int(rng.integers(-4, 6))
    if grow:
        kernel = np.ones((abs(grow), abs(grow)), np.uint8)
        mask = np.asarray(cv2.dilate(mask, kernel) if grow > 0 else cv2.erode(mask, kernel), dtype=np.uint8)
    x, y = rng.normal(0.0, 0.05, 2)
    image, mask = warped(image, mask, x, y, CROP_MARGIN * float(np.exp(rng.normal(0.04, 0.1))))
    image = relit(image, rng)
    if rng.random() < 0.5:
        image, mask = image[:, ::-1], mask[:, ::-1]
    return greyed(image, mask)


def warped(
    image: NDArray[np.uint8], mask: NDArray[np.uint8], x: float, y: float, margin: float
) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Return the part of a stored crop and its mask that a square of a margin shows, moved by shares x and y."""
    scale = CROP_SIZE / (STORED_SIZE * margin / STORED_MARGIN)
    middle = STORED_SIZE / 2.0
    to = np.array(
        [[scale, 0.0, CROP_SIZE * (0.5 + x) - scale * middle], [0.0, scale, CROP_SIZE * (0.5 + y) - scale * middle]]
    )
    size, grey = (CROP_SIZE, CROP_SIZE), (GREY, GREY, GREY)
    moved = np.asarray(cv2.warpAffine(image, to, size, flags=cv2.INTER_LINEAR, borderValue=grey), dtype=np.uint8)
    return moved, np.asarray(cv2.warpAffine(mask, to, size, flags=cv2.INTER_LINEAR), dtype=np.uint8)
