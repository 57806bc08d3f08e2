"""Maps for scrubbing to and fro: of each step only the cells that change, as what is to be XORed with them.

What is applied once goes a step on, and what is applied again goes back.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import MapOverlay
from uniteam.visualization.replay_page.packing import packed


def map_data(overlays: Sequence[MapOverlay | None]) -> dict[str, Any] | None:
    """Return the maps of all steps in one frame, as plain data; None where there are none.

    A step without a map keeps the one before, without a plan; so does one whose cells have another size than the
    first's.
    """
    sizes = [overlay.cell_size for overlay in overlays if overlay is not None]
    if not sizes:
        return None
    shown = [o if o is not None and o.cell_size == sizes[0] else None for o in overlays]
    corner, shape = _frame([o for o in shown if o is not None])
    points, places = _points(shown)
    return {
        "cellSize": sizes[0],
        "origin": [corner[1] * sizes[0], corner[0] * sizes[0]],
        "rows": shape[0],
        "columns": shape[1],
        **_changes(shown, corner, shape),
        "shortTerm": packed(np.array([_short_term(o) for o in shown], np.float32)),
        "goal": packed(places[:, 0]),
        "path": packed(places[:, 1]),
        **points,
    }


def _corner(overlay: MapOverlay) -> tuple[int, int]:
    x, y = overlay.origin
    return round(y / overlay.cell_size), round(x / overlay.cell_size)


def _frame(overlays: Sequence[MapOverlay]) -> tuple[tuple[int, int], tuple[int, int]]:
    """Return the first corner (cells from the start frame's origin) and the shape of what holds every map."""
    low = np.min([_corner(o) for o in overlays], axis=0)
    high = np.max([np.add(_corner(o), o.labels.shape) for o in overlays], axis=0)
    rows, columns = high - low
    return (int(low[0]), int(low[1])), (int(rows), int(columns))


def _changes(overlays: Sequence[MapOverlay | None], corner: tuple[int, int], shape: tuple[int, int]) -> dict[str, Any]:
    """Return how many cells each step changes, the way from one of them to the next, and what to XOR with them."""
    before, counts, ways, changes = np.zeros(shape, np.uint8), [], [], []
    for overlay in overlays:
        now = before if overlay is None else _in_frame(overlay, corner, shape)
        difference = (before ^ now).ravel()
        cells = np.flatnonzero(difference)
        counts.append(len(cells))
        ways.append(np.diff(cells, prepend=0).astype(np.uint32))
        changes.append(difference[cells])
        before = now
    return {
        "counts": packed(np.array(counts, np.uint32)),
        "ways": packed(np.concatenate(ways)),
        "changes": packed(np.concatenate(changes)),
    }


def _in_frame(overlay: MapOverlay, corner: tuple[int, int], shape: tuple[int, int]) -> NDArray[np.uint8]:
    (row, column), labels = np.subtract(_corner(overlay), corner), np.zeros(shape, np.uint8)
    labels[row : row + overlay.labels.shape[0], column : column + overlay.labels.shape[1]] = overlay.labels
    return labels


def _short_term(overlay: MapOverlay | None) -> tuple[float, float]:
    if overlay is None or overlay.short_term_goal is None:
        return np.nan, np.nan
    return overlay.short_term_goal


def _points(overlays: Sequence[MapOverlay | None]) -> tuple[dict[str, Any], NDArray[np.uint16]]:
    """Return each list of points once, in centimetres, and (T, 2) which of them each step's goal and path are."""
    lists: dict[bytes, int] = {}
    places = np.zeros((len(overlays), 2), np.uint16)
    for step, overlay in enumerate(overlays):
        for k, metres in enumerate((None, None) if overlay is None else (overlay.goal, overlay.path)):
            own = np.zeros((0, 2)) if metres is None else np.asarray(metres).reshape(-1, 2)
            content = np.clip(np.rint(own * 100.0), -32767, 32767).astype("<i2").tobytes()
            places[step, k] = lists.setdefault(content, len(lists))
    lengths = np.array([len(content) // 4 for content in lists], np.uint32)
    everything = np.frombuffer(b"".join(lists), "<i2")
    return {"lengths": packed(lengths), "points": packed(everything)}, places
