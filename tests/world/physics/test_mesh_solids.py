"""A mesh as solids to run into."""

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from worlds.glb import Part, box, upright, write_glb

from uniteam.world.assets.mesh import load_mesh
from uniteam.world.physics.mesh_solids import DEPTH, mesh_solids


def solids_of(folder: Path, *parts: Part) -> NDArray[np.float64]:
    write_glb(folder / "mesh.glb", *parts)
    return mesh_solids(load_mesh(folder / "mesh.glb"))


def test_a_solid_lies_behind_its_triangle_as_deep_as_it_must(tmp_path: Path) -> None:
    solids = solids_of(tmp_path, upright([(0.0, 0.0), (2.0, 0.0)], 2.5))
    assert solids.shape == (2, 6, 3)
    front, back = solids[:, :3, 1], solids[:, 3:, 1]
    assert np.allclose(front, 0.0)
    assert np.allclose(np.abs(back), DEPTH)
    assert len(np.unique(back.round(6))) == 1


def test_a_box_is_filled_from_its_faces_inwards(tmp_path: Path) -> None:
    solids = solids_of(tmp_path, box((0.0, 0.0, 0.5), (1.0, 1.0, 1.5)))
    assert len(solids) == 12
    assert solids.min() == pytest.approx(0.0, abs=1e-6)
    assert solids[..., :2].max() == pytest.approx(1.0, abs=1e-6)


def test_the_floor_and_slivers_are_no_solids(tmp_path: Path) -> None:
    floor = box((0.0, 0.0, -0.1), (4.0, 4.0, 0.005))
    sliver = box((0.0, 0.0, 1.0), (2.0, 0.0005, 1.0005))
    assert len(solids_of(tmp_path, floor, box((0.0, 0.0, 0.0), (1.0, 1.0, 1.0)))) == 10
    assert len(solids_of(tmp_path, sliver)) == 0
