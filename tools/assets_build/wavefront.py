"""Reading Wavefront OBJ and MTL files as the furniture libraries write them."""

import math
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from assets_build.builtin_materials import builtin_color

Color = tuple[float, float, float]


@dataclass
class SourceMaterial:
    """A material: diffuse colour (sRGB, [0, 1]), opacity and the path of its texture, if it has one that exists."""

    color: Color = (0.75, 0.75, 0.75)
    opacity: float = 1.0
    texture: Path | None = None


@dataclass
class SourceMesh:
    """Corners of triangles, not welded: positions (T, 3, 3) y-up, uvs (T, 3, 2) v-up, each triangle's material."""

    positions: NDArray[np.float64]
    uvs: NDArray[np.float64]
    triangle_materials: NDArray[np.int32]
    materials: list[SourceMaterial] = field(default_factory=list)


def _find_texture(folder: Path, name: str) -> Path | None:
    """Return the image a material names, whatever its folder or letter case, or None where it is dead."""
    wanted = name.replace("\\", "/").split("/")[-1].strip().lower()
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.name.lower() == wanted:
            return path
    return None


def read_materials(path: Path) -> dict[str, SourceMaterial]:
    """Return the materials of an MTL file by name; empty where the file is missing."""
    materials: dict[str, SourceMaterial] = {}
    current = SourceMaterial()
    if not path.exists():
        return materials
    for line in path.read_text(encoding="latin-1").splitlines():
        key, _, value = line.strip().partition(" ")
        value = value.strip()
        if key == "newmtl":
            current = materials.setdefault(value, SourceMaterial())
        elif key == "Kd":
            r, g, b = (min(max(float(v), 0.0), 1.0) for v in value.split()[:3])
            current.color = (r, g, b)
        elif key == "d":
            current.opacity = float(value.split()[-1])
        elif key == "map_Kd":
            current.texture = _find_texture(path.parent, value)
    return materials


def _face_corners(words: list[str], counts: tuple[int, int]) -> list[tuple[int, int]]:
    """Return (vertex, uv) indices from 0 of a face's corners; uv is -1 where there is none."""
    corners = []
    for word in words:
        parts = word.split("/")
        vertex = int(parts[0])
        uv = int(parts[1]) if len(parts) > 1 and parts[1] else 0
        corners.append(
            (vertex - 1 if vertex > 0 else counts[0] + vertex, uv - 1 if uv > 0 else counts[1] + uv if uv else -1)
        )
    return corners


def read_obj(path: Path) -> SourceMesh:
    """Read an OBJ with its materials; polygons become fans."""
    vertices: list[list[float]] = []
    uvs: list[list[float]] = []
    corners: list[tuple[int, int]] = []
    owners: list[int] = []
    library: dict[str, SourceMaterial] = {}
    names: dict[str, int] = {"": 0}
    materials = [SourceMaterial()]
    current = 0
    for line in path.read_text(encoding="latin-1").replace("\\\n", " ").splitlines():
        words = line.split()
        if not words:
            continue
        if words[0] == "v":
            vertices.append([float(w) for w in words[1:4]])
        elif words[0] == "vt":
            uvs.append([float(w) for w in words[1:3]])
        elif words[0] == "f":
            face = _face_corners(words[1:], (len(vertices), len(uvs)))
            for k in range(1, len(face) - 1):
                corners += [face[0], face[k], face[k + 1]]
                owners.append(current)
        elif words[0] == "mtllib":
            library |= read_materials(path.parent / line.split(None, 1)[1].strip())
        elif words[0] == "usemtl":
            name = words[1] if len(words) > 1 else ""
            if name not in names:
                names[name] = len(materials)
                materials.append(library.get(name) or SourceMaterial(builtin_color(name)))
            current = names[name]
    index = np.array(corners, dtype=np.int64).reshape(-1, 3, 2)
    points = np.array(vertices, dtype=np.float64)
    coordinates = np.array([*uvs, [0.0, 0.0]], dtype=np.float64).reshape(-1, 2)
    coordinates[~np.isfinite(coordinates)] = math.nan
    return SourceMesh(
        points[index[..., 0]], np.nan_to_num(coordinates[index[..., 1]]), np.array(owners, np.int32), materials
    )
