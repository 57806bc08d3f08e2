"""Maps that grow: of each only the cells that differ from the one before.

A cell that the map before did not reach was unknown.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.recording.step_line import MapLine
from uniteam.interface import MapLabel, MapOverlay

Labels = NDArray[np.uint8]


@dataclass(frozen=True)
class Frame:
    """Where a map lies: the cell of its first corner, counted from the start frame's origin, and its shape."""

    corner: tuple[int, int]
    shape: tuple[int, int]


NO_MAP = Frame((0, 0), (0, 0)), np.zeros((0, 0), np.uint8)
"""The map before the first."""


def frame_of(origin: tuple[float, float], cell_size: float, shape: tuple[int, int]) -> Frame:
    """Return the frame of a map as `MapOverlay` places it."""
    x, y = origin
    return Frame((round(y / cell_size), round(x / cell_size)), shape)


def carried_over(before: tuple[Frame, Labels], frame: Frame) -> Labels:
    """Return the labels of the map before in another frame, unknown where it did not reach."""
    old_frame, old = before
    if frame == old_frame:
        return old.copy()
    labels = np.full(frame.shape, MapLabel.UNKNOWN, np.uint8)
    low = np.maximum(old_frame.corner, frame.corner)
    past = np.minimum(np.add(old_frame.corner, old_frame.shape), np.add(frame.corner, frame.shape))
    if (past > low).all():
        labels[_part(frame, low, past)] = old[_part(old_frame, low, past)]
    return labels


def _part(frame: Frame, low: NDArray[np.int64], past: NDArray[np.int64]) -> tuple[slice, ...]:
    """Return where the cells from `low` to before `past` stand in a frame."""
    return tuple(slice(int(a - c), int(b - c)) for a, b, c in zip(low, past, frame.corner, strict=True))


class MapWriter:
    """Takes maps in and keeps what changes."""

    def __init__(self) -> None:
        """Begin without a map."""
        self._before = NO_MAP
        self._cells: list[NDArray[np.int32]] = []
        self._labels: list[Labels] = []
        self._points: list[NDArray[np.float32]] = []

    def add(self, overlay: MapOverlay) -> int:
        """Take a map in and return how many of its cells have changed."""
        frame = frame_of(overlay.origin, overlay.cell_size, _shape(overlay.labels))
        old, new = carried_over(self._before, frame).ravel(), overlay.labels.ravel()
        changed = np.flatnonzero(old != new).astype(np.int32)
        self._cells.append(changed)
        self._labels.append(new[changed])
        self._points += [np.asarray(points, np.float32).reshape(-1, 2) for points in (overlay.goal, overlay.path)]
        self._before = frame, overlay.labels.copy()
        return len(changed)

    def arrays(self) -> dict[str, NDArray[np.generic]]:
        """Return the changed cells (C,) as indices of their map, row by row, their labels (C,), and the points (P, 2).

        The points are those of each map's goal and then of its path (m, start frame).
        """
        return {
            "cells": np.concatenate([np.zeros(0, np.int32), *self._cells]),
            "labels": np.concatenate([np.zeros(0, np.uint8), *self._labels]),
            "points": np.concatenate([np.zeros((0, 2), np.float32), *self._points]),
        }


def _shape(labels: Labels) -> tuple[int, int]:
    rows, columns = labels.shape
    return rows, columns


def read_maps(lines: Iterable[MapLine | None], arrays: Mapping[str, NDArray[Any]]) -> Iterator[MapOverlay | None]:
    """Yield the maps, one for each step; None where a step has none.

    Args:
        lines: what each step says of its map.
        arrays: those of `MapWriter`.

    Raises:
        ValueError: lines and arrays do not fit together.
    """
    before, cell, point = NO_MAP, 0, 0
    for line in lines:
        if line is None:
            yield None
            continue
        labels = _labels(line, before, *(arrays[name][cell : cell + line.changed] for name in ("cells", "labels")))
        cell += line.changed
        before = frame_of(line.origin, line.cell_size, line.shape), labels
        points = arrays["points"][point : point + line.goal + line.path].astype(np.float64)
        point += line.goal + line.path
        goal, path = points[: line.goal], points[line.goal :]
        yield MapOverlay(labels.copy(), line.origin, line.cell_size, goal, line.short_term_goal, path)


def _labels(line: MapLine, before: tuple[Frame, Labels], cells: NDArray[np.int32], own: Labels) -> Labels:
    labels = carried_over(before, frame_of(line.origin, line.cell_size, line.shape))
    if not len(cells) == len(own) == line.changed or (len(cells) and not 0 <= cells.min() <= cells.max() < labels.size):
        raise ValueError("the changes of a map do not fit it")
    labels.ravel()[cells] = own
    return labels
