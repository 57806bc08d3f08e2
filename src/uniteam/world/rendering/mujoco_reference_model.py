"""A scene as MuJoCo's renderer draws it: the same triangles and textures, nothing that moves or collides."""

from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import PinholeCamera
from uniteam.world.rendering.kernels.culling import NEAR
from uniteam.world.rendering.kernels.scene_buffers import SceneBuffers

_FAR = 60.0
_OPENGL_AXES = np.diag([1.0, -1.0, -1.0])
CAMERA_NAME = "view"


def mujoco_model(buffers: SceneBuffers, camera: PinholeCamera, samples: int) -> tuple[Any, NDArray[np.int16]]:
    """Return the `MjModel` of everything visible, under MuJoCo's headlight, and the (G,) int16 label of each geom.

    Args:
        buffers: of a scene; parts stay where they are.
        camera: its size and its vertical field of view become those of the model's one camera.
        samples: of multisampling; MuJoCo's own default is 4.
    """
    spec = mujoco.MjSpec()
    spec.visual.global_.offwidth, spec.visual.global_.offheight = camera.width, camera.height
    spec.visual.quality.offsamples = samples
    spec.visual.map.znear, spec.visual.map.zfar = NEAR, _FAR
    spec.stat.extent, spec.stat.center = 1.0, np.zeros(3)
    fovy = np.degrees(2.0 * np.arctan(camera.height / (2.0 * camera.fy)))
    spec.worldbody.add_camera(name=CAMERA_NAME, fovy=fovy)
    used = np.unique(buffers.triangle_materials)
    for material in used:
        _add_material(spec, buffers, int(material))
    labels = [
        buffers.part_labels[part]
        for part in np.flatnonzero(buffers.part_visible)
        for _ in _add_part(spec, buffers, int(part))
    ]
    return spec.compile(), np.array(labels, dtype=np.int16)


def set_camera_pose(model: Any, camera_to_world: NDArray[np.floating]) -> None:
    """Put the model's camera at a (4, 4) pose whose axes are OpenCV's."""
    model.cam_pos[0] = camera_to_world[:3, 3]
    rotation = np.ascontiguousarray(camera_to_world[:3, :3] @ _OPENGL_AXES, dtype=np.float64)
    mujoco.mju_mat2Quat(model.cam_quat[0], rotation.ravel())


def _add_material(spec: Any, buffers: SceneBuffers, material: int) -> None:
    red, green, blue = buffers.material_colors[material]
    added = spec.add_material(name=f"material_{material}", rgba=[red, green, blue, 1.0], specular=0.0)
    log2_width, log2_height, last_level, start = buffers.texture_layout[buffers.material_textures[material], :4]
    if last_level == 0:
        return
    width, height = 1 << int(log2_width), 1 << int(log2_height)
    texels = buffers.texels[start : start + (width + 1) * (height + 1)].reshape(height + 1, width + 1)[:-1, :-1]
    image = np.stack([texels & 255, (texels >> 8) & 255, (texels >> 16) & 255], axis=-1).astype(np.uint8)
    texture = spec.add_texture(
        name=f"texture_{material}", type=mujoco.mjtTexture.mjTEXTURE_2D, width=width, height=height, nchannel=3
    )
    texture.data = image.tobytes()
    added.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = texture.name


def _add_part(spec: Any, buffers: SceneBuffers, part: int) -> list[Any]:
    """Add a geom for each material of a part, as MuJoCo's meshes have one each."""
    _, _, first, last = buffers.part_ranges[part]
    materials = buffers.triangle_materials[first:last]
    return [
        _add_geom(spec, buffers, f"{part}_{material}", buffers.triangles[first:last][materials == material])
        for material in np.unique(materials)
    ]


def _add_geom(spec: Any, buffers: SceneBuffers, name: str, triangles: NDArray[np.int32]) -> Any:
    kept, faces = np.unique(triangles, return_inverse=True)
    # MuJoCo takes no mesh of fewer than four vertices; a spare one does no harm.
    kept = np.pad(kept, (0, max(0, 4 - len(kept))), mode="edge")
    uvs = buffers.uvs[kept].copy()
    uvs[:, 1] = 1.0 - uvs[:, 1]
    spec.add_mesh(
        name=name,
        uservert=buffers.vertices[kept].ravel(),
        usertexcoord=uvs.ravel(),
        userface=faces.astype(np.int32).ravel(),
        userfacetexcoord=faces.astype(np.int32).ravel(),
        inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL,
    )
    return spec.worldbody.add_geom(
        type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, material=f"material_{name.split('_')[1]}", contype=0,
        conaffinity=0,
    )  # fmt: skip
