"""Writing a model as a glTF binary: one primitive a material, quantised normals, JPEG textures within the file."""

import json
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from assets_build.geometry import Geometry

FLOAT, BYTE, SHORT, UNSIGNED_SHORT, UNSIGNED_INT = 5126, 5120, 5122, 5123, 5125
MOST_SHORT = 32767


@dataclass(frozen=True)
class OutputMaterial:
    """A colour (sRGB, [0, 1]) and a texture's JPEG bytes or None."""

    color: tuple[float, float, float]
    jpeg: bytes | None


class _Writer:
    """Collects buffer views, accessors and the blob they lie in."""

    def __init__(self) -> None:
        self.blob = bytearray()
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, object]] = []

    def view(self, data: bytes, stride: int = 0) -> int:
        self.blob += bytes(-len(self.blob) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data)})
        if stride:
            self.views[-1]["byteStride"] = stride
        self.blob += data
        return len(self.views) - 1

    def accessor(self, data: bytes, kind: str, component: int, count: int, **more: object) -> int:
        view = self.view(data, {BYTE: 4, SHORT: 8}.get(component, 0))
        accessor = {"bufferView": view, "componentType": component, "count": count, "type": kind}
        self.accessors.append(accessor | more)
        return len(self.accessors) - 1


def _linear(color: tuple[float, float, float]) -> list[float]:
    return [round(c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4, 5) for c in color]


def _float_positions(writer: _Writer, points: NDArray[np.floating]) -> int:
    points = points.astype("<f4")
    bounds = {"min": points.min(0).tolist(), "max": points.max(0).tolist()}
    return writer.accessor(points.tobytes(), "VEC3", FLOAT, len(points), **bounds)


def _short_positions(writer: _Writer, points: NDArray[np.floating]) -> int:
    """Write points of [-1, 1] as normalised shorts, which take two thirds of the bytes."""
    packed = np.zeros((len(points), 4), "<i2")
    packed[:, :3] = np.round(points * MOST_SHORT)
    bounds = {"min": packed[:, :3].min(0).tolist(), "max": packed[:, :3].max(0).tolist()}
    return writer.accessor(packed.tobytes(), "VEC3", SHORT, len(points), normalized=True, **bounds)


def _primitive(
    writer: _Writer,
    geometry: Geometry,
    normals: NDArray[np.float32],
    material: int,
    textured: bool,
    write_positions: Callable[[_Writer, NDArray[np.floating]], int],
) -> dict:
    chosen = geometry.triangles[geometry.triangle_materials == material]
    used, inverse = np.unique(chosen, return_inverse=True)
    packed = np.zeros((len(used), 4), np.int8)
    packed[:, :3] = np.round(normals[used] * 127)
    attributes = {
        "POSITION": write_positions(writer, geometry.positions[used]),
        "NORMAL": writer.accessor(packed.tobytes(), "VEC3", BYTE, len(used), normalized=True),
    }
    if textured:
        attributes["TEXCOORD_0"] = writer.accessor(geometry.uvs[used].astype("<f4").tobytes(), "VEC2", FLOAT, len(used))
    small = len(used) < 65535
    data = inverse.astype("<u2" if small else "<u4").tobytes()
    indices = writer.accessor(data, "SCALAR", UNSIGNED_SHORT if small else UNSIGNED_INT, inverse.size)
    return {"attributes": attributes, "indices": indices, "material": material}


def write_glb(path: Path, geometry: Geometry, normals: NDArray[np.float32], materials: list[OutputMaterial]) -> None:
    """Write the file; glTF is y-up, so the one node turns the model frame's z up to it."""
    _write(path, geometry, normals, materials, {}, _float_positions)


def write_small_glb(
    path: Path, geometry: Geometry, normals: NDArray[np.float32], materials: list[OutputMaterial]
) -> None:
    """Write the file with positions to 1/32767 of the greatest, which the node scales back."""
    reach = float(np.abs(geometry.positions).max())
    scaled = Geometry(geometry.positions / reach, geometry.uvs, geometry.vertex_materials, geometry.triangles)
    _write(path, scaled, normals, materials, {"scale": [reach] * 3}, _short_positions)


def _write(
    path: Path,
    geometry: Geometry,
    normals: NDArray[np.float32],
    materials: list[OutputMaterial],
    placing: dict[str, object],
    write_positions: Callable[[_Writer, NDArray[np.floating]], int],
) -> None:
    writer = _Writer()
    used = np.unique(geometry.triangle_materials)
    renumber = {int(old): new for new, old in enumerate(used)}
    remap = np.zeros(len(materials), np.int32)
    remap[used] = np.arange(len(used))
    geometry = Geometry(geometry.positions, geometry.uvs, remap[geometry.vertex_materials], geometry.triangles)
    kept = [materials[old] for old in renumber]
    primitives = [
        _primitive(writer, geometry, normals, k, m.jpeg is not None, write_positions) for k, m in enumerate(kept)
    ]
    images: list[dict[str, object]] = []
    described = []
    for material in kept:
        surface: dict[str, object] = {"baseColorFactor": [*_linear(material.color), 1.0], "metallicFactor": 0.0}
        if material.jpeg is not None:
            images.append({"bufferView": writer.view(material.jpeg), "mimeType": "image/jpeg"})
            surface["baseColorTexture"] = {"index": len(images) - 1}
        described.append({"pbrMetallicRoughness": surface})
    turn = 0.7071067811865476
    document: dict[str, object] = {
        "asset": {"version": "2.0", "generator": "uniteam"},
        "extensionsUsed": ["KHR_mesh_quantization"],
        "extensionsRequired": ["KHR_mesh_quantization"],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "rotation": [-turn, 0.0, 0.0, turn], **placing}],
        "meshes": [{"primitives": primitives}],
        "materials": described,
        "accessors": writer.accessors,
        "bufferViews": writer.views,
        "buffers": [{"byteLength": len(writer.blob)}],
    }
    if images:
        document |= {"images": images, "textures": [{"source": k} for k in range(len(images))]}
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    blob = bytes(writer.blob) + bytes(-len(writer.blob) % 4)
    total = 12 + 8 + len(text) + 8 + len(blob)
    header = struct.pack("<4sII", b"glTF", 2, total) + struct.pack("<I4s", len(text), b"JSON")
    path.write_bytes(header + text + struct.pack("<I4s", len(blob), b"BIN\x00") + blob)
