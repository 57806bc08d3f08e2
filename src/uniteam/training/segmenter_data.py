"""What the segmenter learns from: half-size frames, changed at each draw, with the truth of each cell."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from uniteam.mind.perception.learned.geometry_image import STRIDE, geometry_image
from uniteam.mind.perception.learned.kinds import Kind
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.training.augmentation import holed, relit
from uniteam.training.records import FrameRecord, Frames, Thing, from_jpeg, from_png, read_frames

NO_RECEPTACLE = -100
ROLE_KINDS = {"receptacle": Kind.RECEPTACLE, "object": Kind.OBJECT, "decor": Kind.DECOR}
_FEW_PIXELS = 6
"""Of a cell, from which on it belongs to the object in it."""
_BLIND = 0.25
"""Share of the frames without any geometry."""


@dataclass(frozen=True)
class FrameBatch:
    """Frames as the network takes them; h = H / STRIDE, w = W / STRIDE.

    Attributes:
        images: (N, H, W, 3) uint8.
        geometry: (N, GEOMETRY_CHANNELS, h, w) float32.
        kinds: (N, h, w) int64 of `Kind`.
        weights: (N, h, w) float32, what each cell's kind weighs.
        ends: (N, h, w) float32, 1 where a thing meets another of its kind.
        receptacles: (N, h, w) int64, index of the receptacle's name, `NO_RECEPTACLE` elsewhere.
    """

    images: NDArray[np.uint8]
    geometry: NDArray[np.float32]
    kinds: NDArray[np.int64]
    weights: NDArray[np.float32]
    ends: NDArray[np.float32]
    receptacles: NDArray[np.int64]


@dataclass(frozen=True)
class CellTruth:
    """The truth of each cell of a frame, (h, w) each, as `FrameBatch` has it."""

    kinds: NDArray[np.int64]
    weights: NDArray[np.float32]
    ends: NDArray[np.float32]
    receptacles: NDArray[np.int64]


class FrameSampler:
    """Draws frames of homes that are kept on the disk."""

    def __init__(self, paths: Sequence[Path], receptacles: Sequence[str]) -> None:
        """Read the frames, and take the receptacles' names in the order of their labels."""
        self._names = {name: index for index, name in enumerate(receptacles)}
        homes = [read_frames(path) for path in paths]
        self.frames: list[tuple[Frames, FrameRecord]] = [(home, frame) for home in homes for frame in home.frames]

    def batch(self, size: int, rng: Generator) -> FrameBatch:
        """Return a batch of frames, changed."""
        return self._batch([self.frames[int(i)] for i in rng.integers(len(self.frames), size=size)], rng)

    def plain(self, first: int, size: int) -> FrameBatch:
        """Return a batch of frames as they are."""
        return self._batch(self.frames[first : first + size], None)

    def _batch(self, chosen: Sequence[tuple[Frames, FrameRecord]], rng: Generator | None) -> FrameBatch:
        images, geometries, truths = [], [], []
        for home, frame in chosen:
            rgb, depth = from_jpeg(frame.rgb), from_png(frame.depth).astype(np.float32) / np.float32(1000.0)
            ids = from_png(frame.instances).astype(np.int32) - 1
            if rng is not None:
                rgb, depth = relit(rgb, rng), holed(depth, rng)
            geometry = geometry_image(depth, HEAD_CAMERA_HALF, np.array(frame.camera_to_start).reshape(4, 4))
            if rng is not None and rng.random() < _BLIND:
                geometry = np.zeros_like(geometry)
            truth = cell_truth(ids, home.things, self._names)
            if rng is not None and rng.random() < 0.5:
                rgb, geometry, truth = rgb[:, ::-1], geometry[..., ::-1], _mirrored(truth)
            images.append(rgb)
            geometries.append(geometry)
            truths.append(truth)
        return FrameBatch(
            np.stack(images),
            np.stack(geometries),
            *(np.stack([getattr(t, name) for t in truths]) for name in ("kinds", "weights", "ends", "receptacles")),
        )


def cell_truth(ids: NDArray[np.int32], things: Sequence[Thing], names: dict[str, int]) -> CellTruth:
    """Return the truth of each cell of a frame.

    Args:
        ids: (H, W), indices of `things`, -1 for none.
        things: what they mean.
        names: index of each receptacle's name.
    """
    kind_of = np.array([*(ROLE_KINDS.get(t.role, Kind.STUFF) for t in things), Kind.STUFF], dtype=np.int64)
    name_of = np.array([*(_receptacle_label(t, names) for t in things), NO_RECEPTACLE], dtype=np.int64)
    cells = cell_ids(ids, kind_of)
    kinds = kind_of[cells]
    areas = np.bincount(cells.ravel() + 1, minlength=len(things) + 1)
    weights = np.where(cells < 0, 0.12, 1.0 / np.sqrt(np.maximum(areas[cells + 1], 4))).astype(np.float32)
    weights = np.where(kinds == Kind.STUFF, np.float32(0.06), np.maximum(weights, np.float32(0.04)))
    return CellTruth(kinds, weights.astype(np.float32), _ends(cells, kinds), name_of[cells])


def cell_ids(ids: NDArray[np.int32], kind_of: NDArray[np.int64]) -> NDArray[np.int32]:
    """Return the (h, w) instance of each cell: that of its middle, but a small thing's where enough of it is in it."""
    height, width = ids.shape
    middle = ids[STRIDE // 2 :: STRIDE, STRIDE // 2 :: STRIDE]
    blocks = ids.reshape(height // STRIDE, STRIDE, width // STRIDE, STRIDE).transpose(0, 2, 1, 3)
    is_object = kind_of[blocks] == Kind.OBJECT
    largest = np.where(is_object, blocks, -1).max(axis=(2, 3))
    is_its = (is_object.sum(axis=(2, 3)) >= _FEW_PIXELS) & (kind_of[middle] != Kind.OBJECT)
    return np.where(is_its, largest, middle)


def _ends(cells: NDArray[np.int32], kinds: NDArray[np.int64]) -> NDArray[np.float32]:
    """Return 1 where a cell's neighbour is of another thing of the same kind."""
    ends = np.zeros(cells.shape, dtype=bool)
    for axis in (0, 1):
        one = [slice(None), slice(None)]
        other = [slice(None), slice(None)]
        one[axis], other[axis] = slice(None, -1), slice(1, None)
        a, b = tuple(one), tuple(other)
        meets = (cells[a] != cells[b]) & (kinds[a] == kinds[b]) & (kinds[a] != Kind.STUFF)
        ends[a] |= meets
        ends[b] |= meets
    return ends.astype(np.float32)


def _receptacle_label(thing: Thing, names: dict[str, int]) -> int:
    return names.get(thing.category, NO_RECEPTACLE) if thing.role == "receptacle" else NO_RECEPTACLE


def _mirrored(truth: CellTruth) -> CellTruth:
    return CellTruth(truth.kinds[:, ::-1], truth.weights[:, ::-1], truth.ends[:, ::-1], truth.receptacles[:, ::-1])
