"""The parts of a glTF 2.0 binary that a mesh is read from: its JSON document, its blob, and typed views of the blob.

Whatever a file says is checked against what it holds before memory is taken for it.
"""

import struct
from dataclasses import dataclass
from typing import Annotated, Any

import msgspec
import numpy as np
from numpy.typing import NDArray

READABLE_EXTENSIONS = frozenset({"KHR_mesh_quantization", "KHR_materials_unlit", "KHR_texture_basisu"})
MOST_ELEMENTS = 3_000_000
"""No accessor of more elements is read."""
MOST_PARTS = 10_000
"""Of nodes, of meshes, and of a mesh's primitives."""

_COMPONENT_TYPES = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}

Index = Annotated[int, msgspec.Meta(ge=0, le=2**31)]
Four = tuple[float, float, float, float]
Three = tuple[float, float, float]


class Accessor(msgspec.Struct, rename="camel"):
    """How to read numbers from a view."""

    component_type: int
    count: Annotated[int, msgspec.Meta(ge=0, le=MOST_ELEMENTS)]
    type: str
    buffer_view: Index | None = None
    byte_offset: Index = 0
    normalized: bool = False
    sparse: msgspec.Raw | None = None


class BufferView(msgspec.Struct, rename="camel"):
    """A stretch of the blob."""

    byte_length: Index
    buffer: Index = 0
    byte_offset: Index = 0
    byte_stride: Annotated[int, msgspec.Meta(ge=4, le=252)] | None = None


class Primitive(msgspec.Struct):
    """Triangles of one material; `mode` 4 says that they are triangles."""

    attributes: dict[str, Index]
    indices: Index | None = None
    material: Index | None = None
    mode: int = 4


class MeshPart(msgspec.Struct):
    """What a node shows."""

    primitives: Annotated[list[Primitive], msgspec.Meta(max_length=MOST_PARTS)]


class Node(msgspec.Struct):
    """A frame within its parent's: a matrix by columns, or scale, then rotation (x, y, z, w), then translation."""

    mesh: Index | None = None
    children: list[Index] = []
    matrix: Annotated[list[float], msgspec.Meta(min_length=16, max_length=16)] | None = None
    translation: Three = (0.0, 0.0, 0.0)
    rotation: Four = (0.0, 0.0, 0.0, 1.0)
    scale: Three = (1.0, 1.0, 1.0)


class Scene(msgspec.Struct):
    """The nodes that are seen."""

    nodes: list[Index] = []


class TextureReference(msgspec.Struct):
    """Which texture."""

    index: Index


class Surface(msgspec.Struct, rename="camel", frozen=True):
    """A material's looks."""

    base_color_factor: Four = (1.0, 1.0, 1.0, 1.0)
    base_color_texture: TextureReference | None = None


class MaterialExtensions(msgspec.Struct, rename={"unlit": "KHR_materials_unlit"}, frozen=True):
    """What is said of a material beyond the core of the format; `unlit` holds nothing."""

    unlit: dict[str, Any] | None = None


class MaterialEntry(msgspec.Struct, rename="camel"):
    """A material."""

    pbr_metallic_roughness: Surface = Surface()
    extensions: MaterialExtensions = MaterialExtensions()


class BasisuSource(msgspec.Struct, frozen=True):
    """Which image, in KTX2."""

    source: Index


class TextureExtensions(msgspec.Struct, rename={"basisu": "KHR_texture_basisu"}, frozen=True):
    """What is said of a texture beyond the core of the format."""

    basisu: BasisuSource | None = None


class TextureEntry(msgspec.Struct):
    """Which image a texture shows."""

    source: Index | None = None
    extensions: TextureExtensions = TextureExtensions()


class Image(msgspec.Struct, rename="camel"):
    """A picture within the file."""

    buffer_view: Index | None = None


class Document(msgspec.Struct, rename="camel"):
    """The JSON chunk, as far as it is read."""

    scene: Index = 0
    scenes: list[Scene] = []
    nodes: Annotated[list[Node], msgspec.Meta(max_length=MOST_PARTS)] = []
    meshes: Annotated[list[MeshPart], msgspec.Meta(max_length=MOST_PARTS)] = []
    materials: Annotated[list[MaterialEntry], msgspec.Meta(max_length=MOST_PARTS)] = []
    textures: list[TextureEntry] = []
    images: list[Image] = []
    accessors: list[Accessor] = []
    buffer_views: list[BufferView] = []
    extensions_required: list[str] = []


@dataclass(frozen=True)
class GltfBinary:
    """A file: its document, and the blob that its views lie in."""

    document: Document
    blob: memoryview

    def view(self, index: int) -> memoryview:
        """Return the bytes of a buffer view; raises ValueError, IndexError where there is none."""
        view = self.document.buffer_views[index]
        if view.buffer != 0 or view.byte_offset + view.byte_length > len(self.blob):
            raise ValueError(f"buffer view {index} lies outside of the file")
        return self.blob[view.byte_offset : view.byte_offset + view.byte_length]

    def values(self, index: int) -> NDArray[Any]:
        """Return what an accessor reads, (count, components); raises ValueError, IndexError where it reads too far."""
        accessor = self.document.accessors[index]
        if accessor.buffer_view is None or accessor.sparse is not None:
            raise ValueError(f"accessor {index} is sparse or empty, which uniteam does not read")
        if accessor.component_type not in _COMPONENT_TYPES or accessor.type not in _COMPONENTS:
            raise ValueError(f"accessor {index} is of an unknown type")
        kind = np.dtype(_COMPONENT_TYPES[accessor.component_type])
        columns = _COMPONENTS[accessor.type]
        stride = self.document.buffer_views[accessor.buffer_view].byte_stride or columns * kind.itemsize
        view = self.view(accessor.buffer_view)
        end = accessor.byte_offset + max(accessor.count - 1, 0) * stride + columns * kind.itemsize
        if accessor.count == 0 or end > len(view):
            raise ValueError(f"accessor {index} reads beyond its view, or nothing")
        return np.ndarray((accessor.count, columns), kind, view, accessor.byte_offset, (stride, kind.itemsize))

    def floats(self, index: int) -> NDArray[np.float32]:
        """Return what an accessor reads as numbers; integers that stand for [0, 1] or [-1, 1] become that."""
        values = self.values(index)
        if not self.document.accessors[index].normalized or values.dtype.kind == "f":
            return values.astype(np.float32)
        return np.maximum(values / np.float32(np.iinfo(values.dtype).max), np.float32(-1.0)).astype(np.float32)


def read_gltf(content: bytes) -> GltfBinary:
    """Return the document and the blob of a glTF binary.

    Raises:
        ValueError, struct.error, msgspec.MsgspecError, RecursionError: it is none, or it asks for an extension that is
            not read here.
    """
    magic, version, length = struct.unpack_from("<4sII", content)
    if magic != b"glTF" or version != 2 or length != len(content):
        raise ValueError("it is no complete glTF 2 binary")
    json_length, chunk = struct.unpack_from("<I4s", content, 12)
    if chunk != b"JSON" or 20 + json_length > len(content):
        raise ValueError("it has no JSON chunk")
    document = msgspec.json.decode(content[20 : 20 + json_length], type=Document)
    unreadable = sorted(set(document.extensions_required) - READABLE_EXTENSIONS)
    if unreadable:
        raise ValueError(f"it needs the extension {unreadable[0]}; export it without")
    return GltfBinary(document, memoryview(content)[28 + json_length :])
