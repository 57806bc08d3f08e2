"""A home as a MuJoCo model in a folder: what it collides as, and above that what it looks like.

The folder holds `home.xml`, a Wavefront file for each material of a mesh in `meshes`, and pictures in `textures`. What
collides is in group 3, which MuJoCo's viewer hides at first; what is seen is in group 1 and touches nothing. Objects
are free bodies of their names.
"""

from pathlib import Path
from typing import Any

import cv2
import mujoco
import numpy as np
from numpy.typing import NDArray

from uniteam.files import try_folder, write_whole
from uniteam.world.assets.mesh import Material, Mesh
from uniteam.world.export.visible import by_material, visible
from uniteam.world.homes.home import Home
from uniteam.world.physics.physics_model import home_spec

FILE = "home.xml"
_COLLIDES, _SEEN = 3, 1


def write_mjcf(home: Home, folder: Path) -> None:
    """Write a home as a MuJoCo model with its meshes and textures, without its ceiling.

    Raises:
        DamagedFileError: a file of the home's library cannot be read.
        InvalidInputError: a collision shape is one that MuJoCo does not take.
        UnwritableError: a file cannot be written.
    """
    for name in ("meshes", "textures"):
        try_folder(folder / name)
    writer = _Writer(home_spec(home), folder)
    seen = visible(home)
    for name, mesh in seen.stage.items():
        for piece in writer.pieces(name, mesh):
            writer.show(writer.spec.worldbody, piece, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))
    pieces = {name: writer.pieces(name, mesh) for name, mesh in seen.models.items()}
    for instance in seen.instances:
        for piece in pieces[instance.model]:
            if instance.movable:
                writer.show(writer.spec.body(instance.name), piece, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))
            else:
                writer.show(writer.spec.worldbody, piece, instance.position, instance.quaternion)
    writer.finish()


class _Writer:
    """Adds what is seen to a model that has what collides."""

    def __init__(self, spec: Any, folder: Path) -> None:
        self.spec = spec
        self._folder = folder
        self._materials: dict[tuple[Any, ...], str] = {}
        self._textures: dict[int, str] = {}
        self._material_of: dict[str, str] = {}
        for geom in spec.geoms:
            geom.group = _COLLIDES
        spec.worldbody.add_light(
            pos=[0.0, 0.0, 8.0], dir=[0.2, 0.1, -1.0], type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL
        )

    def pieces(self, name: str, mesh: Mesh) -> list[str]:
        """Write a mesh's pieces, one for each material, and return their names."""
        names = []
        for number, (material, piece) in enumerate(by_material(mesh)):
            own = f"{name}-{number}"
            write_whole(self._folder / "meshes" / f"{own}.obj", _wavefront(piece))
            file = f"meshes/{own}.obj"
            self.spec.add_mesh(name=own, file=file, inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL)
            self._material_of[own] = self._material(material)
            names.append(own)
        return names

    def show(self, body: Any, piece: str, position: tuple[float, ...], quaternion: tuple[float, ...]) -> None:
        """Add a piece to a body."""
        body.add_geom(
            type=mujoco.mjtGeom.mjGEOM_MESH, meshname=piece, material=self._material_of[piece], pos=list(position),
            quat=list(quaternion), contype=0, conaffinity=0, group=_SEEN, mass=0.0,
        )  # fmt: skip

    def finish(self) -> None:
        """Write the model's file."""
        self.spec.modelfiledir = str(self._folder)
        self.spec.compile()
        write_whole(self._folder / FILE, self.spec.to_xml().encode())

    def _material(self, material: Material) -> str:
        key = (material.color, id(material.texture))
        if key not in self._materials:
            name = f"material-{len(self._materials)}"
            added = self.spec.add_material(name=name, rgba=[*material.color, 1.0], specular=0.0)
            if material.texture is not None:
                added.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = self._texture(material.texture)
            self._materials[key] = name
        return self._materials[key]

    def _texture(self, texture: NDArray[np.uint8]) -> str:
        if id(texture) not in self._textures:
            name = f"texture-{len(self._textures)}"
            _, data = cv2.imencode(".png", texture[..., ::-1])
            write_whole(self._folder / "textures" / f"{name}.png", data.tobytes())
            self.spec.add_texture(name=name, type=mujoco.mjtTexture.mjTEXTURE_2D, file=f"textures/{name}.png")
            self._textures[id(texture)] = name
        return self._textures[id(texture)]


def _wavefront(mesh: Mesh) -> bytes:
    """Return a mesh as a Wavefront file; MuJoCo takes none of fewer than four vertices, a spare one does no harm."""
    spare = max(0, 4 - len(mesh.vertices))
    lines = [f"v {x:.6g} {y:.6g} {z:.6g}" for x, y, z in np.pad(mesh.vertices, ((0, spare), (0, 0)), mode="edge")]
    lines += [f"vt {u:.6g} {1.0 - v:.6g}" for u, v in mesh.uvs]
    lines += [f"vn {x:.4g} {y:.4g} {z:.4g}" for x, y, z in mesh.normals]
    lines += [f"f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}" for a, b, c in mesh.triangles + 1]
    return ("\n".join(lines) + "\n").encode()
