"""A home as one glTF 2.0 binary: a node for each instance, its mesh and its textures once.

glTF has y up; one node above all turns the world, which has z up, into that.
"""

import json
import struct
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.files import write_whole
from uniteam.world.assets.mesh import Material, Mesh
from uniteam.world.export.visible import by_material, visible
from uniteam.world.homes.home import Home

_FLOAT, _UNSIGNED_INT = 5126, 5125
_QUARTER = 0.7071067811865476
_JPEG_QUALITY = 90


def write_glb(home: Home, path: Path) -> None:
    """Write a home into a glTF binary, without its ceiling.

    Raises:
        DamagedFileError: a file of the home's library cannot be read.
        UnwritableError: the file cannot be written.
    """
    seen = visible(home)
    document = _Document()
    nodes = [{"name": name, "mesh": document.mesh(name, mesh)} for name, mesh in seen.stage.items()]
    meshes = {name: document.mesh(name, mesh) for name, mesh in seen.models.items()}
    for instance in seen.instances:
        w, x, y, z = instance.quaternion
        place = {"translation": list(instance.position), "rotation": [x, y, z, w]}
        nodes.append({"name": instance.name, "mesh": meshes[instance.model], **place})
    write_whole(path, document.packed(home.name, nodes))


class _Document:
    """Collects meshes, materials and textures, and the numbers that they are made of."""

    def __init__(self) -> None:
        self._blob = bytearray()
        self._views: list[dict[str, int]] = []
        self._accessors: list[dict[str, Any]] = []
        self._meshes: list[dict[str, Any]] = []
        self._materials: list[dict[str, Any]] = []
        self._images: list[dict[str, Any]] = []
        self._known: dict[tuple[Any, ...], int] = {}

    def mesh(self, name: str, mesh: Mesh) -> int:
        """Add a mesh and return its number."""
        primitives = [self._primitive(piece, self._material(material)) for material, piece in by_material(mesh)]
        self._meshes.append({"name": name, "primitives": primitives})
        return len(self._meshes) - 1

    def packed(self, name: str, nodes: list[dict[str, Any]]) -> bytes:
        """Return the file."""
        children = list(range(1, len(nodes) + 1))
        root = {"name": name, "rotation": [-_QUARTER, 0.0, 0.0, _QUARTER], "children": children}
        document = {
            "asset": {"version": "2.0", "generator": "uniteam"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [root, *nodes],
            "meshes": self._meshes,
            "materials": self._materials,
            "images": self._images,
            "textures": [{"source": k, "sampler": 0} for k in range(len(self._images))],
            "samplers": [{"wrapS": 10497, "wrapT": 10497}],
            "accessors": self._accessors,
            "bufferViews": self._views,
            "buffers": [{"byteLength": len(self._blob)}],
        }
        text = json.dumps({key: value for key, value in document.items() if value != []}).encode()
        text += b" " * (-len(text) % 4)
        blob = bytes(self._blob) + bytes(-len(self._blob) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(blob), b"BIN\x00") + blob
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks

    def _primitive(self, mesh: Mesh, material: int) -> dict[str, Any]:
        low, high = mesh.vertices.min(axis=0).tolist(), mesh.vertices.max(axis=0).tolist()
        attributes = {
            "POSITION": self._accessor(mesh.vertices.astype("<f4"), "VEC3", min=low, max=high),
            "NORMAL": self._accessor(mesh.normals.astype("<f4"), "VEC3"),
            "TEXCOORD_0": self._accessor(mesh.uvs.astype("<f4"), "VEC2"),
        }
        indices = self._accessor(mesh.triangles.astype("<u4").ravel(), "SCALAR")
        return {"attributes": attributes, "indices": indices, "material": material}

    def _accessor(self, values: NDArray[Any], kind: str, **bounds: list[float]) -> int:
        component = _FLOAT if values.dtype.kind == "f" else _UNSIGNED_INT
        view = self._view(values.tobytes())
        accessor = {"bufferView": view, "componentType": component, "count": len(values), "type": kind, **bounds}
        self._accessors.append(accessor)
        return len(self._accessors) - 1

    def _view(self, data: bytes) -> int:
        self._blob += bytes(-len(self._blob) % 4)
        self._views.append({"buffer": 0, "byteOffset": len(self._blob), "byteLength": len(data)})
        self._blob += data
        return len(self._views) - 1

    def _material(self, material: Material) -> int:
        """Return the number of a material, which is added where it is new."""
        key = ("material", material.color, id(material.texture))
        if key not in self._known:
            surface: dict[str, Any] = {"baseColorFactor": [*_linear(material.color), 1.0], "metallicFactor": 0.0}
            if material.texture is not None:
                surface["baseColorTexture"] = {"index": self._image(material.texture)}
            self._materials.append({"pbrMetallicRoughness": surface, "doubleSided": True})
            self._known[key] = len(self._materials) - 1
        return self._known[key]

    def _image(self, texture: NDArray[np.uint8]) -> int:
        key = ("image", id(texture))
        if key not in self._known:
            _, data = cv2.imencode(".jpg", texture[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, _JPEG_QUALITY])
            self._images.append({"bufferView": self._view(data.tobytes()), "mimeType": "image/jpeg"})
            self._known[key] = len(self._images) - 1
        return self._known[key]


def _linear(color: tuple[float, float, float]) -> list[float]:
    """Return the linear colour of an sRGB one."""
    return [round(c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4, 5) for c in color]
