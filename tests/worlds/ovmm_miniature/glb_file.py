"""Meshes as glTF binaries with textures in KTX2 or PNG: y up, a node a mesh."""

import json
import struct
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.material import Material
from uniteam.world.assets.mesh import Mesh
from uniteam.world.export.visible import by_material

_FLOAT, _UNSIGNED_INT = 5126, 5125
_PNG, _BASISU = b"\x89PNG", "KHR_texture_basisu"


class Pictures(Protocol):
    """Makes pictures into files."""

    def file(self, picture: NDArray[np.uint8]) -> bytes:
        """Return the file of an (H, W, 3) RGB picture."""


@dataclass
class _Document:
    pictures: Pictures
    blob: bytearray = field(default_factory=bytearray)
    lists: dict[str, list[Any]] = field(default_factory=dict)
    known: dict[int, int] = field(default_factory=dict)

    def add(self, name: str, entry: object) -> int:
        self.lists.setdefault(name, []).append(entry)
        return len(self.lists[name]) - 1

    def view(self, data: bytes) -> int:
        self.blob += bytes(-len(self.blob) % 4)
        view = {"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data)}
        self.blob += data
        return self.add("bufferViews", view)

    def accessor(self, values: NDArray[Any], kind: str, **bounds: Any) -> int:
        component = _FLOAT if values.dtype.kind == "f" else _UNSIGNED_INT
        entry = {"bufferView": self.view(values.tobytes()), "componentType": component, "count": len(values)}
        return self.add("accessors", {**entry, "type": kind, **bounds})

    def primitive(self, mesh: Mesh, material: int) -> dict[str, Any]:
        position = _y_up(mesh.vertices)
        attributes = {
            "POSITION": self.accessor(
                position, "VEC3", min=position.min(axis=0).tolist(), max=position.max(axis=0).tolist()
            ),
            "NORMAL": self.accessor(_y_up(mesh.normals), "VEC3"),
            "TEXCOORD_0": self.accessor(mesh.uvs.astype("<f4"), "VEC2"),
        }
        indices = self.accessor(mesh.triangles.astype("<u4").ravel(), "SCALAR")
        return {"attributes": attributes, "indices": indices, "material": material}

    def material(self, material: Material) -> int:
        surface: dict[str, Any] = {"baseColorFactor": [*map(_linear, material.color), 1.0]}
        if material.texture is not None:
            surface["baseColorTexture"] = {"index": self.texture(material.texture)}
        entry: dict[str, Any] = {"pbrMetallicRoughness": surface}
        if not material.is_lit:
            entry["extensions"] = {"KHR_materials_unlit": {}}
        return self.add("materials", entry)

    def texture(self, picture: NDArray[np.uint8]) -> int:
        if id(picture) not in self.known:
            file = self.pictures.file(picture)
            kind = "image/png" if file.startswith(_PNG) else "image/ktx2"
            source = {"source": self.add("images", {"bufferView": self.view(file), "mimeType": kind})}
            texture = source if kind == "image/png" else {"extensions": {_BASISU: source}}
            self.known[id(picture)] = self.add("textures", texture)
        return self.known[id(picture)]


def write_glb(path: Path, meshes: Sequence[Mesh], pictures: Pictures) -> None:
    """Write meshes, whose frame has z up, into one file, each as a node of its own."""
    document = _Document(pictures)
    for mesh in meshes:
        primitives = [document.primitive(piece, document.material(kind)) for kind, piece in by_material(mesh)]
        document.add("nodes", {"mesh": document.add("meshes", {"primitives": primitives})})
    textures = document.lists.get("textures", [])
    extensions = sorted({name for texture in textures for name in texture.get("extensions", {})})
    content = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(meshes)))}],
        "buffers": [{"byteLength": len(document.blob)}],
        **document.lists,
        **({"extensionsRequired": extensions, "extensionsUsed": extensions} if extensions else {}),
    }
    text = json.dumps(content).encode()
    text += b" " * (-len(text) % 4)
    blob = bytes(document.blob) + bytes(-len(document.blob) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(blob), b"BIN\x00") + blob
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)


def _y_up(vectors: NDArray[np.floating]) -> NDArray[np.float32]:
    return np.stack([vectors[:, 0], vectors[:, 2], -vectors[:, 1]], axis=1).astype("<f4")


def _linear(color: float) -> float:
    return color / 12.92 if color <= 0.04045 else ((color + 0.055) / 1.055) ** 2.4
