"""The mesh of a stage: read anew when it changes, bounded, and cut at a height."""

from pathlib import Path

import numpy as np
import pytest
from worlds.glb import Part, box, write_glb

from uniteam.errors import DamagedFileError
from uniteam.world.assets.mesh import load_mesh
from uniteam.world.homes.fixed_mesh import section, stage_mesh, wall_lines
from uniteam.world.homes.home import Stage, Wall

BLOCK = box((1.0, 1.0, 0.0), (2.0, 3.0, 1.0))


def test_a_block_is_cut_along_its_outline(tmp_path: Path) -> None:
    write_glb(tmp_path / "block.glb", BLOCK)
    mesh = load_mesh(tmp_path / "block.glb")
    lines = section(mesh, 0.5)
    assert np.linalg.norm(lines[:, 1] - lines[:, 0], axis=1).sum() == pytest.approx(6.0, abs=1e-5)
    assert lines.min(axis=(0, 1)) == pytest.approx((1.0, 1.0)) and lines.max(axis=(0, 1)) == pytest.approx((2.0, 3.0))
    assert len(section(mesh, 1.5)) == 0


def test_the_walls_of_a_stage_are_straight_ones_and_cuts_of_its_mesh(tmp_path: Path) -> None:
    write_glb(tmp_path / "block.glb", BLOCK)
    wall = Wall((0.0, 0.0), (4.0, 0.0), 0.1)
    assert len(wall_lines(Stage((), (wall,), 2.5), 0.5)) == 1
    assert len(wall_lines(Stage((), (wall,), 2.5, tmp_path / "block.glb"), 0.5)) == 1 + 8


def test_a_changed_mesh_is_read_anew(tmp_path: Path) -> None:
    stage = Stage((), (), 2.5, tmp_path / "block.glb")
    for parts in (1, 2):
        write_glb(tmp_path / "block.glb", *[BLOCK] * parts)
        mesh = stage_mesh(stage)
        assert mesh is not None and len(mesh.triangles) == 12 * parts


def test_a_mesh_of_too_many_triangles_to_run_into_is_refused(tmp_path: Path) -> None:
    write_glb(tmp_path / "dense.glb", Part(np.tile(BLOCK.corners, (1700, 1, 1))))
    with pytest.raises(DamagedFileError, match="a stage may have 20000 triangles, this one has 20400"):
        stage_mesh(Stage((), (), 2.5, tmp_path / "dense.glb"))
