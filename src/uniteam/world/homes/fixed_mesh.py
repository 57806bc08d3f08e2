"""The mesh of a stage: read once as long as its file does not change, and cut at a height."""

from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.mesh import Mesh, load_mesh
from uniteam.world.assets.reading import damaged, modified
from uniteam.world.homes.home import Stage

MOST_TRIANGLES = 20_000
"""Each triangle is collided with by itself."""


def stage_mesh(stage: Stage) -> Mesh | None:
    """Return the mesh of a stage (world frame, m) where it has one.

    Raises:
        DamagedFileError: its file is missing, is no mesh, or has more than `MOST_TRIANGLES`.
    """
    return None if stage.mesh is None else _read(stage.mesh, modified(stage.mesh))


@lru_cache(maxsize=8)
def _read(path: Path, *_: object) -> Mesh:
    mesh = load_mesh(path)
    if len(mesh.triangles) > MOST_TRIANGLES:
        reason = f"a stage may have {MOST_TRIANGLES} triangles, this one has {len(mesh.triangles)}"
        raise damaged(path, "the model", reason)
    return mesh


def wall_lines(stage: Stage, height: float) -> NDArray[np.float64]:
    """Return (N, 2, 2) segments (m, world): centre lines of straight walls, and what of the mesh is at a height."""
    straight = np.array([(wall.start, wall.end) for wall in stage.walls], dtype=np.float64).reshape(-1, 2, 2)
    mesh = stage_mesh(stage)
    return straight if mesh is None else np.concatenate([straight, section(mesh, height)])


def section(mesh: Mesh, height: float) -> NDArray[np.float64]:
    """Return the (N, 2, 2) segments in which a mesh's triangles cut a horizontal plane."""
    corners = mesh.vertices[mesh.triangles].astype(np.float64)
    above = corners[..., 2] > height
    cut = corners[above.any(axis=1) & ~above.all(axis=1)]
    above = cut[..., 2] > height
    # One corner is alone on its side; both segments' ends lie on the edges that lead to it.
    lonely = np.where(above.sum(axis=1) == 1, above.argmax(axis=1), (~above).argmax(axis=1))
    rows = np.arange(len(cut))
    tip = cut[rows, lonely]
    ends = []
    for step in (1, 2):
        other = cut[rows, (lonely + step) % 3]
        share = (height - tip[:, 2]) / (other[:, 2] - tip[:, 2])
        ends.append(tip[:, :2] + share[:, None] * (other[:, :2] - tip[:, :2]))
    return np.stack(ends, axis=1)
