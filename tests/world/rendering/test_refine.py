"""Cutting triangles smaller, and the parts that a stage's mesh becomes."""

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from worlds.glb import box, write_glb

from uniteam.world.assets.mesh import Mesh, load_mesh
from uniteam.world.rendering.meshes.fixed_parts import fixed_parts
from uniteam.world.rendering.meshes.refine import refined


def long_box(folder: Path) -> Mesh:
    write_glb(folder / "box.glb", box((0.0, 0.0, 0.0), (5.0, 1.0, 2.0)))
    return load_mesh(folder / "box.glb")


def areas(mesh: Mesh) -> NDArray[np.float64]:
    a, b, c = (mesh.vertices[mesh.triangles[:, k]] for k in range(3))
    return np.asarray(np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2)


def test_no_side_is_longer_than_asked_and_the_surface_is_the_same(tmp_path: Path) -> None:
    mesh = long_box(tmp_path)
    fine = refined(mesh, 0.7)
    corners = fine.vertices[fine.triangles]
    assert np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max() <= 0.7
    assert np.isclose(areas(fine).sum(), areas(mesh).sum())
    assert np.allclose(np.linalg.norm(fine.normals, axis=1), 1.0)


def test_triangles_that_share_a_side_still_do(tmp_path: Path) -> None:
    fine = refined(long_box(tmp_path), 0.7)
    points, index = np.unique(fine.vertices.round(5), axis=0, return_inverse=True)
    triangles = index.reshape(-1)[fine.triangles]
    sides = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
    _, counts = np.unique(sides, axis=0, return_counts=True)
    assert len(points) > 8
    assert (counts == 2).all()  # a closed box has two triangles at every side


def test_a_mesh_of_small_triangles_stays_as_it_is(tmp_path: Path) -> None:
    mesh = long_box(tmp_path)
    assert refined(mesh, 10.0) is mesh


def test_a_stages_mesh_is_lit_by_the_rooms_it_faces_and_hidden_with_the_ceiling(tmp_path: Path) -> None:
    wall, lid = box((3.97, 0.0, 0.0), (4.03, 4.0, 2.5)), box((0.0, 0.0, 2.48), (8.0, 4.0, 2.52))
    write_glb(tmp_path / "stage.glb", wall, lid)
    parts = list(fixed_parts(load_mesh(tmp_path / "stage.glb"), 2.5, beside_the_wall))
    sides = {(name, room): mesh.vertices for name, mesh, room, _ in parts}
    assert sides["stage", 0][:, 0].max() == pytest.approx(3.97)
    assert sides["stage", 1][:, 0].min() == pytest.approx(4.03)
    assert min(vertices[:, 2].min() for (name, _), vertices in sides.items() if name == "ceiling") > 2.45


def beside_the_wall(x: float, y: float) -> int | None:
    """Return which of two rooms a point is in; none within the wall between them."""
    return None if abs(x - 4.0) < 0.05 else int(x > 4.0)
