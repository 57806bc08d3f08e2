"""Writing glTF binaries as any program would: y up, float positions, colours, a node for each part."""

import json
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

Point = tuple[float, float, float]


@dataclass(frozen=True)
class Part:
    """Triangles of one colour: corners (T, 3, 3) (m, z up), and a linear RGB in [0, 1]."""

    corners: NDArray[np.float64]
    color: Point = (0.6, 0.5, 0.4)


def box(low: Point, high: Point, color: Point = (0.6, 0.5, 0.4)) -> Part:
    """Return an axis-aligned box, seen from outside."""
    signs = np.array([[(k >> axis) & 1 for axis in range(3)] for k in range(8)])
    points = np.where(signs == 1, high, low).astype(np.float64)
    quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    triangles = [corner for a, b, c, d in quads for corner in ((a, b, c), (a, c, d))]
    return Part(points[np.array(triangles)], color)


def upright(path: Sequence[tuple[float, float]], height: float, color: Point = (0.6, 0.5, 0.4)) -> Part:
    """Return the side faces of a wall along a path (m), seen from its right, from the floor to a height."""
    triangles = []
    for (x0, y0), (x1, y1) in pairwise(path):
        a, b, c, d = (x0, y0, 0.0), (x1, y1, 0.0), (x1, y1, height), (x0, y0, height)
        triangles += [(a, b, c), (a, c, d)]
    return Part(np.array(triangles), color)


def write_glb(path: Path, *parts: Part) -> None:
    """Write the parts, each as a node with a mesh of its own."""
    blob = b"".join(_y_up(part.corners).tobytes() for part in parts)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(packed(document(parts), blob))


def document(parts: Sequence[Part]) -> dict[str, Any]:
    """Return the JSON of a file that holds the parts one after the other."""
    counts = [3 * len(part.corners) for part in parts]
    starts = np.cumsum([0, *counts]) * 12
    return {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": list(range(len(parts)))}],
        "nodes": [{"mesh": k} for k in range(len(parts))],
        "meshes": [{"primitives": [{"attributes": {"POSITION": k}, "material": k}]} for k in range(len(parts))],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [*part.color, 1.0]}} for part in parts],
        "accessors": [
            {"bufferView": k, "componentType": 5126, "count": count, "type": "VEC3"} for k, count in enumerate(counts)
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": int(start), "byteLength": 12 * count}
            for start, count in zip(starts, counts, strict=False)
        ],
        "buffers": [{"byteLength": int(starts[-1])}],
    }


def packed(content: Mapping[str, Any] | bytes, blob: bytes) -> bytes:
    """Return a glTF binary of a JSON document and a blob."""
    text = content if isinstance(content, bytes) else json.dumps(content).encode()
    text += b" " * (-len(text) % 4)
    blob += bytes(-len(blob) % 4)
    header = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(blob))
    return header + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(blob), b"BIN\x00") + blob


def _y_up(corners: NDArray[np.float64]) -> NDArray[np.float32]:
    return np.stack([corners[..., 0], corners[..., 2], -corners[..., 1]], axis=-1).astype("<f4")
