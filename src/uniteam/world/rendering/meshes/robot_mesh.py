"""What Stretch looks like: a mesh for each group of links that moves as one."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.interface import Joints
from uniteam.stretch import Transform, link_motions
from uniteam.world.assets.mesh import Mesh, load_mesh
from uniteam.world.assets.reading import PACK_DIRECTORY

ROBOT_DIRECTORY = PACK_DIRECTORY / "robot"
PREFIX = "robot/"
"""The names of the robot's parts in a scene begin with this."""


@lru_cache(maxsize=1)
def robot_parts() -> dict[str, Mesh]:
    """Return the robot's meshes by their names in a scene (m, base frame, where every joint is at zero).

    Raises:
        DamagedFileError: a mesh is missing from the pack or cannot be read.
    """
    groups = link_motions(Joints(0.0, 0.0))
    return {PREFIX + group: load_mesh(ROBOT_DIRECTORY / f"{group}.glb") for group in groups}


def part_poses(base: BasePose, joints: Joints) -> dict[str, Transform]:
    """Return the (4, 4) poses in the world of the robot's parts, by their names in a scene."""
    names, motions = _motions(joints)
    return dict(zip(names, base.matrix() @ motions, strict=True))


@lru_cache(maxsize=256)
def _motions(joints: Joints) -> tuple[tuple[str, ...], NDArray[np.float64]]:
    """Return the parts' names and how each is displaced (N, 4, 4): driving leaves the joints as they are."""
    motions = link_motions(joints)
    return tuple(PREFIX + group for group in motions), np.array(list(motions.values()))
