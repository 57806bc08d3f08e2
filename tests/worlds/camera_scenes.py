"""Scenes made of a few triangles, a camera that sees them, and a home of two rooms with models of the pack."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import PinholeCamera
from uniteam.world.assets.catalogue import Catalogue, load_catalogue
from uniteam.world.assets.mesh import Material, Mesh
from uniteam.world.homes.home import Home, Instance, Light, Opening, Room, Stage, Wall
from uniteam.world.homes.polygon import rectangle
from uniteam.world.rendering.camera import render
from uniteam.world.rendering.kernels.frame import Frame
from uniteam.world.rendering.scene import Scene

Array = NDArray[Any]

CAMERA = PinholeCamera.from_horizontal_fov(64, 48, np.radians(60.0))
NOWHERE = Home("nowhere", Stage((), (), 2.5), (), Catalogue({}, frozenset()))
"""A home without rooms: only extra parts are seen, under an even light."""

FORWARD = np.array([[0.0, 0.0, 1.0, 0.0], [-1.0, 0.0, 0.0, 0.0], [0.0, -1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]])
"""camera_to_world of a camera at the origin that looks along x."""

RED, GREEN, BLUE = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def quad(distance: float, half: float, material: Material, tilt: float = 0.0) -> Mesh:
    """Return a square that faces the camera at `FORWARD`; `tilt` (m per m) moves its left side nearer.

    Its texture's upper left corner is at the upper left of the image.
    """
    y, z = half * np.array([1.0, -1.0, -1.0, 1.0]), half * np.array([1.0, 1.0, -1.0, -1.0])
    vertices = np.stack([distance - tilt * y, y, z], axis=1).astype(np.float32)
    normals = np.tile(np.array([-1.0, 0.0, 0.0], dtype=np.float32), (4, 1))
    uvs = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], dtype=np.float32)
    return _mesh(vertices, normals, uvs, np.array([[0, 2, 1], [0, 3, 2]]), material)


def sphere(center: tuple[float, float, float], radius: float, material: Material) -> Mesh:
    """Return a ball of 160 x 80 facets."""
    turn, rise = np.meshgrid(np.linspace(0, 2 * np.pi, 161), np.linspace(-np.pi / 2, np.pi / 2, 81), indexing="ij")
    normals = np.stack([np.cos(rise) * np.cos(turn), np.cos(rise) * np.sin(turn), np.sin(rise)], axis=-1)
    corner = np.arange(turn.size).reshape(turn.shape)
    a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
    triangles = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    flat = normals.reshape(-1, 3)
    return _mesh(np.array(center) + radius * flat, flat, np.zeros((len(flat), 2)), triangles, material)


def _mesh(vertices: Array, normals: Array, uvs: Array, triangles: Array, material: Material) -> Mesh:
    return Mesh(
        vertices.astype(np.float32),
        normals.astype(np.float32),
        uvs.astype(np.float32),
        triangles.astype(np.int32),
        np.zeros(len(triangles), dtype=np.int32),
        (material,),
    )


def see(parts: dict[str, Mesh], camera: PinholeCamera = CAMERA) -> Frame:
    """Return what a camera at the origin that looks along x sees of the parts."""
    return render(Scene(NOWHERE, parts), camera, FORWARD)


def looking(eye: tuple[float, float, float], target: tuple[float, float, float]) -> NDArray[np.float64]:
    """Return camera_to_world (4, 4), upright."""
    forward = np.subtract(target, eye) / np.linalg.norm(np.subtract(target, eye))
    right = np.cross(forward, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    pose = np.eye(4)
    pose[:3, :3] = np.stack([right, np.cross(forward, right), forward], axis=1)
    pose[:3, 3] = eye
    return pose


def two_rooms(*instances: Instance) -> Home:
    """Return rooms "west" (x 0 to 4, warm) and "east" (4 to 8, cool), y 0 to 4, a door between, an eastern window."""
    library = load_catalogue()
    floor, wall = library.texture_names("floor")[0], library.texture_names("wall")[0]
    rooms = tuple(
        Room(
            name,
            "living_room",
            rectangle((x, 0.0), (x + 4.0, 4.0)),
            floor,
            wall,
            tint,
            Light((x + 2.0, 2.0, 2.3), light, 0.4),
        )
        for name, x, tint, light in (
            ("west", 0.0, (1.0, 0.6, 0.6), (1.0, 0.9, 0.8)),
            ("east", 4.0, (0.6, 0.6, 1.0), (0.9, 0.95, 1.0)),
        )
    )
    walls = (
        Wall((0.0, 0.0), (8.0, 0.0), 0.1),
        Wall((8.0, 0.0), (8.0, 4.0), 0.1, (Opening("window", 1.2, 2.8, 0.8, 2.0),)),
        Wall((8.0, 4.0), (0.0, 4.0), 0.1),
        Wall((0.0, 4.0), (0.0, 0.0), 0.1),
        Wall((4.0, 0.0), (4.0, 4.0), 0.1, (Opening("door", 1.5, 2.4, 0.0, 2.0),)),
    )
    return Home("two_rooms", Stage(rooms, walls, 2.5), instances, library)
