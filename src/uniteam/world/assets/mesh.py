"""Triangle meshes of the pack, read from its glTF binaries.

The reader knows the subset of glTF 2.0 that `tools/build_assets.py` writes: one node, whose rotation stands the z-up
vertices up for other programs and which is left out here; triangles, float positions and texture coordinates,
signed-byte normals (KHR_mesh_quantization), base colours and JPEG textures within the file.
"""

import json
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.errors import DamagedFileError

Color = tuple[float, float, float]

_COMPONENT_TYPES = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}


@dataclass(frozen=True)
class Material:
    """A surface: its colour (sRGB, [0, 1]) multiplies the texture ((H, W, 3) uint8 sRGB) where there is one."""

    color: Color
    texture: NDArray[np.uint8] | None = None


@dataclass(frozen=True)
class Mesh:
    """Triangles of the model frame.

    Attributes:
        vertices: (V, 3) float32, m.
        normals: (V, 3) float32, unit length, outwards.
        uvs: (V, 2) float32; (0, 0) is the texture's upper left corner, u to the right, v down; they repeat.
        triangles: (T, 3) int32, counter-clockwise seen from outside.
        triangle_materials: (T,) int32, index into `materials`.
        materials: what the triangles are made of.
    """

    vertices: NDArray[np.float32]
    normals: NDArray[np.float32]
    uvs: NDArray[np.float32]
    triangles: NDArray[np.int32]
    triangle_materials: NDArray[np.int32]
    materials: tuple[Material, ...]


def load_mesh(path: Path) -> Mesh:
    """Read a model of the pack.

    Raises:
        DamagedFileError: the file is missing or is not a glTF binary of the pack's kind.
    """
    try:
        document, blob = _read_chunks(path.read_bytes())
        return _mesh(document, blob)
    except (OSError, ValueError, KeyError, IndexError, TypeError, struct.error, cv2.error) as error:
        raise DamagedFileError(f"the model {path} cannot be read ({error}); reinstall uniteam") from error


def _read_chunks(data: bytes) -> tuple[dict[str, Any], memoryview]:
    magic, version, length = struct.unpack_from("<4sII", data)
    if magic != b"glTF" or version != 2 or length != len(data):
        raise ValueError("not a complete glTF 2 binary")
    json_length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20 : 20 + json_length])
    return document, memoryview(data)[28 + json_length :]


def _accessor(document: dict[str, Any], blob: memoryview, index: int) -> NDArray[Any]:
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    kind = np.dtype(_COMPONENT_TYPES[accessor["componentType"]])
    columns = _COMPONENTS[accessor["type"]]
    stride = view.get("byteStride", columns * kind.itemsize) // kind.itemsize
    values = np.frombuffer(blob, kind, accessor["count"] * stride, view["byteOffset"])
    return values.reshape(accessor["count"], stride)[:, :columns]


def _srgb(linear: float) -> float:
    return 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055


def _material(document: dict[str, Any], blob: memoryview, data: dict[str, Any]) -> Material:
    surface = data["pbrMetallicRoughness"]
    r, g, b = (_srgb(v) for v in surface["baseColorFactor"][:3])
    if "baseColorTexture" not in surface:
        return Material((r, g, b))
    image = document["images"][document["textures"][surface["baseColorTexture"]["index"]]["source"]]
    view = document["bufferViews"][image["bufferView"]]
    encoded = np.frombuffer(blob, np.uint8, view["byteLength"], view["byteOffset"])
    decoded = cv2.imdecode(encoded, cv2.IMREAD_COLOR)
    if decoded is None:
        raise ValueError("a texture does not decode")
    return Material((r, g, b), np.ascontiguousarray(decoded[..., ::-1], dtype=np.uint8))


def _mesh(document: dict[str, Any], blob: memoryview) -> Mesh:
    vertices, normals, uvs, triangles, materials = [], [], [], [], []
    offset = 0
    for primitive in document["meshes"][0]["primitives"]:
        attributes = primitive["attributes"]
        position = _accessor(document, blob, attributes["POSITION"]).astype(np.float32)
        normal = _accessor(document, blob, attributes["NORMAL"]).astype(np.float32)
        indices = _accessor(document, blob, primitive["indices"]).astype(np.int32).reshape(-1, 3)
        if "TEXCOORD_0" in attributes:
            uv = _accessor(document, blob, attributes["TEXCOORD_0"]).astype(np.float32)
        else:
            uv = np.zeros((len(position), 2), np.float32)
        vertices.append(position)
        normals.append(normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), np.float32(1e-6)))
        uvs.append(uv)
        triangles.append(indices + np.int32(offset))
        materials.append(np.full(len(indices), primitive["material"], np.int32))
        offset += len(position)
    return Mesh(
        np.ascontiguousarray(np.concatenate(vertices)),
        np.ascontiguousarray(np.concatenate(normals)),
        np.ascontiguousarray(np.concatenate(uvs)),
        np.ascontiguousarray(np.concatenate(triangles)),
        np.concatenate(materials),
        tuple(_material(document, blob, m) for m in document["materials"]),
    )
