"""What Stretch looks like: a mesh for each group of links that moves as one."""

from functools import lru_cache

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
    base_to_world = base.matrix()
    return {PREFIX + group: base_to_world @ motion for group, motion in link_motions(joints).items()}
