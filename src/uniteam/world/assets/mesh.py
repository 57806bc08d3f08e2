"""Triangle meshes, read from glTF 2.0 binaries (https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html).

Read are the triangles of the scene's nodes with positions, normals, texture coordinates, base colours, and JPEG, PNG
or KTX2 textures within the file; skins, morphing, animations and transparency are left out. glTF has y up and a model's
front to +z; what is returned has z up and its front to -y.
"""

import struct
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeVar

import msgspec
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import quaternion_to_matrix
from uniteam.world.assets.gltf import GltfBinary, MeshPart, Node, Primitive, read_gltf
from uniteam.world.assets.material import Material, materials_of, plain_materials
from uniteam.world.assets.model import Model
from uniteam.world.assets.reading import damaged, read_bytes

Matrix = NDArray[np.float64]
Read = TypeVar("Read")

MOST_TRIANGLES = 1_000_000
FARTHEST = 1_000.0
"""No vertex lies farther than this from the origin along an axis (m)."""

_PLAIN = (Material((1.0, 1.0, 1.0)),)
_TRIANGLES = 4
_LINES = frozenset(range(4))
_Z_UP = np.array([[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]])


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


@dataclass(frozen=True)
class _Piece:
    """The triangles of one primitive in the mesh's frame; arrays as in `Mesh`, of one material."""

    vertices: NDArray[np.float32]
    normals: NDArray[np.float32]
    uvs: NDArray[np.float32]
    triangles: NDArray[np.int64]
    material: int


def load_mesh(path: Path) -> Mesh:
    """Read the mesh of a glTF binary.

    Raises:
        DamagedFileError: the file is missing, is damaged, holds no triangle, or needs what is not read here.
        UnavailableError: its textures are of a kind for which an extra has to be installed.
    """
    return _load(path, materials_of)


def load_geometry(path: Path) -> Mesh:
    """Read the mesh of a glTF binary without its looks: every material is plain. Raises DamagedFileError."""
    return _load(path, plain_materials)


def load_pieces(path: Path) -> tuple[Mesh, ...]:
    """Read each primitive of a glTF binary as a mesh of its own, without its looks; raises DamagedFileError."""
    return _reading(path, lambda gltf: tuple(_joined([replace(piece, material=0)], _PLAIN) for piece in _pieces(gltf)))


def load_model_mesh(model: Model) -> Mesh:
    """Read the mesh of a model in the model's frame; raises what `load_mesh` does."""
    mesh = load_mesh(model.path)
    return mesh if model.file_to_model is None else moved(mesh, np.array(model.file_to_model))


def moved(mesh: Mesh, to_other: Matrix) -> Mesh:
    """Return a mesh in another frame, by an affine (4, 4); one that mirrors turns the triangles around."""
    vertices, normals, triangles = _transformed(mesh.vertices, mesh.normals, mesh.triangles, to_other)
    return replace(mesh, vertices=vertices, normals=normals, triangles=triangles.astype(np.int32))


def _load(path: Path, look: Callable[[GltfBinary, int], tuple[Material, ...]]) -> Mesh:
    def read(gltf: GltfBinary) -> Mesh:
        pieces = _pieces(gltf)
        return _joined(pieces, look(gltf, max(piece.material for piece in pieces)))

    return _reading(path, read)


def _reading(path: Path, read: Callable[[GltfBinary], Read]) -> Read:
    content = read_bytes(path, "the model")
    try:
        return read(read_gltf(content))
    except (ValueError, IndexError, struct.error, msgspec.MsgspecError, RecursionError) as error:
        raise damaged(path, "the model", str(error)) from error


def _joined(pieces: Sequence[_Piece], materials: tuple[Material, ...]) -> Mesh:
    starts = np.cumsum([0, *(len(piece.vertices) for piece in pieces)])
    return Mesh(
        np.ascontiguousarray(np.concatenate([piece.vertices for piece in pieces])),
        np.ascontiguousarray(np.concatenate([piece.normals for piece in pieces])),
        np.ascontiguousarray(np.concatenate([piece.uvs for piece in pieces])),
        np.concatenate([p.triangles + start for p, start in zip(pieces, starts, strict=False)]).astype(np.int32),
        np.concatenate([np.full(len(piece.triangles), piece.material, np.int32) for piece in pieces]),
        materials,
    )


def _pieces(gltf: GltfBinary) -> list[_Piece]:
    pieces: list[_Piece] = []
    count = 0
    for part, to_mesh in _parts(gltf):
        for primitive in part.primitives:
            if primitive.mode not in _LINES:
                pieces.append(_piece(gltf, primitive, to_mesh))
                count += len(pieces[-1].triangles)
            if count > MOST_TRIANGLES:
                raise ValueError(f"it has more than {MOST_TRIANGLES} triangles")
    if not pieces:
        raise ValueError("it holds no triangle")
    return pieces


def _parts(gltf: GltfBinary) -> Iterator[tuple[MeshPart, Matrix]]:
    """Yield what the scene's nodes show, with the (4, 4) transforms to the mesh's frame."""
    document = gltf.document
    waiting = [(index, _Z_UP) for index in reversed(document.scenes[document.scene].nodes)]
    seen: set[int] = set()
    while waiting:
        index, parent = waiting.pop()
        if index in seen:
            raise ValueError(f"node {index} has two parents")
        seen.add(index)
        node = document.nodes[index]
        to_mesh = parent @ _node_matrix(node)
        if node.mesh is not None:
            yield document.meshes[node.mesh], to_mesh
        waiting += [(child, to_mesh) for child in reversed(node.children)]


def _node_matrix(node: Node) -> Matrix:
    if node.matrix is not None:
        return np.array(node.matrix).reshape(4, 4).T
    x, y, z, w = node.rotation
    if abs(w * w + x * x + y * y + z * z - 1.0) > 1e-2:
        raise ValueError("the rotation of a node is no unit quaternion")
    matrix = np.eye(4)
    matrix[:3, :3] = quaternion_to_matrix(np.array([w, x, y, z])) * np.array(node.scale)
    matrix[:3, 3] = node.translation
    return matrix


def _piece(gltf: GltfBinary, primitive: Primitive, to_mesh: Matrix) -> _Piece:
    if primitive.mode != _TRIANGLES or "POSITION" not in primitive.attributes:
        raise ValueError("a primitive is neither triangles nor lines nor points")
    vertices = _vectors(gltf, primitive.attributes["POSITION"], 3)
    triangles = _triangles(gltf, primitive, len(vertices))
    normals = _normals(gltf, primitive, vertices, triangles)
    uvs = np.zeros((len(vertices), 2), np.float32)
    if "TEXCOORD_0" in primitive.attributes:
        uvs = _vectors(gltf, primitive.attributes["TEXCOORD_0"], 2)
    if len(normals) != len(vertices) or len(uvs) != len(vertices):
        raise ValueError("a primitive has not as many normals or texture coordinates as positions")
    # The pack's files are upright but for rounding; their vertices are taken as they are, to the bit.
    if not np.allclose(to_mesh, np.eye(4), atol=1e-9):
        vertices, normals, triangles = _transformed(vertices, normals, triangles, to_mesh)
    if np.abs(vertices).max() > FARTHEST:
        raise ValueError(f"a vertex lies more than {FARTHEST:g} m from the origin")
    last = len(gltf.document.materials)
    return _Piece(vertices, normals, uvs, triangles, last if primitive.material is None else primitive.material)


def _vectors(gltf: GltfBinary, accessor: int, size: int) -> NDArray[np.float32]:
    values = gltf.floats(accessor)
    if values.shape[1] != size or not np.isfinite(values).all():
        raise ValueError(f"accessor {accessor} does not hold finite vectors of {size} numbers")
    return values


def _triangles(gltf: GltfBinary, primitive: Primitive, vertex_count: int) -> NDArray[np.int64]:
    if primitive.indices is None:
        indices = np.arange(vertex_count, dtype=np.int64)
    else:
        values = gltf.values(primitive.indices)
        if values.dtype.kind != "u" or values.shape[1] != 1:
            raise ValueError("the corners of triangles are not given by whole numbers")
        indices = values.astype(np.int64).reshape(-1)
    if len(indices) % 3 or indices.max() >= vertex_count:
        raise ValueError("a triangle has a corner that does not exist")
    return indices.reshape(-1, 3)


def _normals(
    gltf: GltfBinary, primitive: Primitive, vertices: NDArray[np.float32], triangles: NDArray[np.int64]
) -> NDArray[np.float32]:
    """Return the unit normals that the file gives, or the means of the faces around each vertex."""
    if "NORMAL" in primitive.attributes:
        normals = gltf.values(primitive.attributes["NORMAL"])[:, :3].astype(np.float32)
        if normals.shape[1] != 3 or not np.isfinite(normals).all():
            raise ValueError("a normal is not three finite numbers")
        return _unit(normals)
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    normals = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(normals, triangles[:, k], np.cross(b - a, c - a))
    return _unit(normals)


def _unit(normals: NDArray[np.float32]) -> NDArray[np.float32]:
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.float32(1e-6))


def _transformed(
    vertices: NDArray[np.float32], normals: NDArray[np.float32], triangles: NDArray[Any], to_mesh: Matrix
) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[Any]]:
    """Return vertices, normals and triangles in the mesh's frame; a mirrored node's triangles turn around."""
    linear = to_mesh[:3, :3]
    size = float(np.linalg.det(linear))
    if not abs(size) > 1e-12:
        raise ValueError("a node flattens what it shows")
    moved = vertices.astype(np.float64) @ linear.T + to_mesh[:3, 3]
    turned = normals.astype(np.float64) @ np.linalg.inv(linear)
    around = triangles if size > 0 else triangles[:, ::-1]
    return moved.astype(np.float32), _unit(turned.astype(np.float32)), around
