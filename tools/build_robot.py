"""Build Stretch's meshes of the pack from the URDF that the PyPI package hello-robot-stretch-urdf carries.

pip install hello-robot-stretch-urdf trimesh pycollada meshoptimizer
python tools/build_robot.py

The links that move as one become one mesh, in the base frame with every joint at zero, decimated.
"""

import shutil
from importlib.metadata import distribution
from pathlib import Path
from typing import NamedTuple

import numpy as np
import stretch_urdf
import trimesh
import urchin
from assets_build.geometry import Geometry, decimate, split_by_crease
from assets_build.glb import OutputMaterial, write_glb

from uniteam.stretch import HEAD_RISE
from uniteam.world.rendering.meshes.robot_mesh import ROBOT_DIRECTORY

URDF = Path(stretch_urdf.__file__).parent / "RE2V0" / "stretch_description_RE2V0_tool_stretch_dex_wrist.urdf"

BLACK, DARK, GREY = (0.09, 0.09, 0.10), (0.20, 0.21, 0.23), (0.42, 0.43, 0.46)
SILVER, WHITE = (0.72, 0.73, 0.76), (0.93, 0.93, 0.92)


class Link(NamedTuple):
    """A link of the URDF: how many triangles it may keep, and its colour (sRGB)."""

    name: str
    budget: int
    color: tuple[float, float, float]


GROUPS = {
    "base": (
        Link("base_link", 2600, DARK), Link("link_right_wheel", 200, BLACK), Link("link_left_wheel", 200, BLACK),
        Link("caster_link", 120, BLACK), Link("link_mast", 60, SILVER), Link("link_head", 600, DARK),
        Link("laser", 150, BLACK), Link("respeaker_base", 200, WHITE), Link("link_aruco_right_base", 20, WHITE),
        Link("link_aruco_left_base", 20, WHITE),
    ),
    "lift": (Link("link_lift", 1100, DARK), Link("link_arm_l4", 400, SILVER), Link("link_aruco_shoulder", 20, WHITE)),
    "arm_1": (Link("link_arm_l3", 350, GREY),),
    "arm_2": (Link("link_arm_l2", 350, SILVER),),
    "arm_3": (Link("link_arm_l1", 350, GREY),),
    "arm_4": (
        Link("link_arm_l0", 900, SILVER), Link("link_aruco_top_wrist", 20, WHITE),
        Link("link_aruco_inner_wrist", 20, WHITE),
    ),
    "wrist_yaw": (Link("link_wrist_yaw", 300, SILVER), Link("link_wrist_yaw_bottom", 900, DARK)),
    "wrist_pitch": (Link("link_wrist_pitch", 1000, DARK),),
    "gripper": (
        Link("link_wrist_roll", 300, SILVER), Link("link_straight_gripper", 1600, DARK),
        Link("link_gripper_finger_right", 160, GREY), Link("link_gripper_finger_left", 160, GREY),
        Link("link_gripper_fingertip_right", 400, BLACK), Link("link_gripper_fingertip_left", 400, BLACK),
    ),
    "head_pan": (Link("link_head_pan", 500, DARK),),
    "head_tilt": (Link("link_head_tilt", 700, DARK), Link("camera_link", 500, SILVER)),
}  # fmt: skip
"""The links that move as one; a group's name is that of `stretch.link_motions`. The head is higher than in the URDF."""

RAISED = ("link_head", "link_head_pan", "link_head_tilt", "camera_link", "respeaker_base")


def link_mesh(robot: urchin.URDF, link: Link) -> Geometry:
    """Return a link's visual mesh in the base frame, decimated."""
    visual = robot.link_map[link.name].visuals[0]
    mesh = trimesh.util.concatenate(visual.geometry.meshes)
    mesh.merge_vertices(merge_tex=True, merge_norm=True, digits_vertex=5)
    mesh.update_faces(mesh.nondegenerate_faces())
    mesh.apply_transform(robot.link_fk(link=link.name) @ visual.origin)
    points = mesh.vertices + np.array([0.0, 0.0, HEAD_RISE if link.name in RAISED else 0.0])
    count = len(points)
    whole = Geometry(
        points.astype(np.float32), np.zeros((count, 2), np.float32), np.zeros(count, np.int32), mesh.faces.astype(int)
    )
    return decimate(whole, link.budget, error=0.002)


def join(parts: list[Geometry]) -> Geometry:
    """Return meshes as one; the material of each is its number."""
    offsets = np.cumsum([0, *(len(part.positions) for part in parts)])[:-1]
    return Geometry(
        np.concatenate([part.positions for part in parts]),
        np.concatenate([part.uvs for part in parts]),
        np.concatenate([np.full(len(part.positions), k, np.int32) for k, part in enumerate(parts)]),
        np.concatenate([part.triangles + offset for part, offset in zip(parts, offsets, strict=True)]),
    )


def main() -> None:
    """Build every group and the file that says whose work it is."""
    robot = urchin.URDF.load(str(URDF))
    ROBOT_DIRECTORY.mkdir(parents=True, exist_ok=True)
    for group, links in GROUPS.items():
        geometry, normals = split_by_crease(join([link_mesh(robot, link) for link in links]))
        materials = [OutputMaterial(link.color, None) for link in links]
        write_glb(ROBOT_DIRECTORY / f"{group}.glb", geometry, normals, materials)
        print(f"{group}: {len(geometry.triangles)} triangles")
    package = distribution("hello-robot-stretch-urdf")
    licence = next(f for f in package.files or () if f.name == "LICENSE.md")
    shutil.copy(licence.locate(), ROBOT_DIRECTORY / "LICENSE.md")
    (ROBOT_DIRECTORY / "ATTRIBUTION.md").write_text(
        "# Stretch RE2\n\n"
        f"The meshes in this folder are made from those of hello-robot-stretch-urdf {package.version} (model RE2V0,\n"
        "tool `stretch_dex_wrist`): Copyright (c) 2021-2024 Hello Robot Inc., all rights reserved, under the Clear\n"
        "BSD License, whose text is in `LICENSE.md` beside this file. Changes: links that move as one are merged,\n"
        "triangles are reduced, colours are ours.\n",
        encoding="utf-8",
    )


if __name__ == "__main__":
    main()
