"""Contact sheets: many models of the pack on one page, seen from the front right, or as their shapes and surfaces."""

import math
from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import PinholeCamera
from uniteam.visualization.shape_mesh import shapes_and_surfaces
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.mesh import Mesh, load_model_mesh
from uniteam.world.assets.model import Model
from uniteam.world.homes.home import Home, Stage
from uniteam.world.rendering.camera import render
from uniteam.world.rendering.scene import Scene

Image = NDArray[np.uint8]

_CAPTION_HEIGHT = 30
_PAPER = (250, 250, 248)
_INK = (30, 30, 30)


def draw_sheet(models: Sequence[Model], columns: int = 8, side: int = 200, shapes: bool = False) -> Image:
    """Return an RGB page of captioned pictures, `columns` across.

    Args:
        models: what to show, in order.
        columns: pictures across.
        side: pixels of a picture's side.
        shapes: show collision shapes (coloured) and support surfaces (green) instead of the looks.
    """
    cells = [_captioned(picture(model, _parts(model, shapes), side), model) for model in models]
    blank = np.full((side + _CAPTION_HEIGHT, side, 3), _PAPER, np.uint8)
    cells += [blank] * (-len(cells) % columns)
    return np.concatenate([np.concatenate(cells[k : k + columns], axis=1) for k in range(0, len(cells), columns)])


def picture(model: Model, parts: dict[str, Mesh], side: int) -> Image:
    """Return a square RGB picture of parts that lie within a model's bounding box."""
    camera = PinholeCamera.from_horizontal_fov(side, side, math.radians(30.0))
    radius = 0.5 * math.hypot(*model.size)
    scale = 1.0 / radius
    scaled = {name: _scaled(mesh, scale, model.size[2] / 2) for name, mesh in parts.items()}
    scene = Scene(Home("sheet", Stage((), (), 2.6), (), Catalogue({}, frozenset())), scaled)
    frame = render(scene, camera, _look_at_origin(np.array([0.62, -1.0, 0.62]), 1.02 / math.sin(math.radians(15.0))))
    rgb = frame.rgb.copy()
    rgb[frame.depth == 0] = _PAPER
    return rgb


def _parts(model: Model, shapes: bool) -> dict[str, Mesh]:
    """Return what a picture shows: a model without shapes shows its looks in any case."""
    return shapes_and_surfaces(model) if shapes and model.shapes else {"model": load_model_mesh(model)}


def _scaled(mesh: Mesh, scale: float, middle: float) -> Mesh:
    vertices = (mesh.vertices - np.array([0, 0, middle], np.float32)) * np.float32(scale)
    return Mesh(vertices, mesh.normals, mesh.uvs, mesh.triangles, mesh.triangle_materials, mesh.materials)


def _look_at_origin(direction: NDArray[np.float64], distance: float) -> NDArray[np.float64]:
    """Return the (4, 4) pose of a camera that looks at the origin from a direction."""
    back = direction / np.linalg.norm(direction)
    right = np.cross(-back, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    pose = np.eye(4)
    pose[:3, :3] = np.stack([right, np.cross(-back, right), -back], axis=1)
    pose[:3, 3] = back * distance
    return pose


def _captioned(rgb: Image, model: Model) -> Image:
    caption = np.full((_CAPTION_HEIGHT, rgb.shape[1], 3), _PAPER, np.uint8)
    size = " x ".join(f"{100 * s:.0f}" for s in model.size)
    for row, text in enumerate((model.id, f"{size} cm, {model.mass:.3g} kg")):
        cv2.putText(caption, text, (3, 12 + 14 * row), cv2.FONT_HERSHEY_SIMPLEX, 0.35, _INK, 1, cv2.LINE_AA)
    return np.concatenate([rgb, caption])
