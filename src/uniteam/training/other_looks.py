"""The things of a home as other instances of their classes could look: stretched, tapered, recoloured; a few nameless.

What a class has few models of is told by them, and not by what they have in common, unless each look differs.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.random import Generator

from uniteam.geometry import Point3
from uniteam.training.nameless import nameless_mesh
from uniteam.training.records import Thing, things_of
from uniteam.world.assets.model import Model
from uniteam.world.homes.home import Home, Instance
from uniteam.world.rendering.meshes.render_mesh import RenderMesh, load_render_mesh, make_render_mesh

NAMELESS = ""
"""The category of what has no name."""
NAMELESS_SHARE = 0.08
"""Of the small objects."""
_STRETCH, _TAPER = 0.12, 0.1
"""Standard deviations of the logarithm of each side's factor, and of what the top is wider than the floor."""
_NARROWEST = 0.9
"""Furniture may be narrower by this, never wider: it stands beside other furniture."""
_PLAIN, _TINTED = 0.45, 0.4
"""Shares of the things that keep their colours, and whose colours change a little; the others get any hue."""


@dataclass(frozen=True)
class OtherLooks:
    """What the things of a home look like.

    Attributes:
        meshes: by instance.
        nameless: instances that are shown as shapes of no name.
    """

    meshes: Mapping[str, RenderMesh]
    nameless: frozenset[str]

    def mesh_of(self, home: Home, instance: Instance) -> RenderMesh:
        """Return what is shown for an instance of the home."""
        return self.meshes[instance.name]

    def things_of(self, home: Home) -> list[Thing]:
        """Return what the home's instances are, in its order."""
        return [
            Thing(thing.role, NAMELESS, NAMELESS) if instance.name in self.nameless else thing
            for instance, thing in zip(home.instances, things_of(home), strict=True)
        ]


def other_looks(home: Home, rng: Generator) -> OtherLooks:
    """Draw a look for each thing of a home; what is heavy keeps its height, since things stand on it."""
    nameless = frozenset(i.name for i in home.instances if i.movable and rng.random() < NAMELESS_SHARE)
    meshes = {}
    for instance in home.instances:
        model = home.model_of(instance)
        if instance.name in nameless:
            meshes[instance.name] = make_render_mesh(nameless_mesh(_other_size(model, rng), rng))
        else:
            mesh = load_render_mesh(model)
            shaped = stretched(mesh, rng) if instance.movable else narrowed(mesh, rng)
            meshes[instance.name] = recoloured(shaped, rng)
    return OtherLooks(meshes, nameless)


def stretched(mesh: RenderMesh, rng: Generator) -> RenderMesh:
    """Return a small object longer or shorter along each axis, and wider or narrower at its top."""
    factors = np.exp(rng.normal(0.0, _STRETCH, 3))
    height = max(float(mesh.high[2] - mesh.low[2]), 1e-6)
    share = (mesh.vertices[:, 2:3] - mesh.low[2]) / height - 0.5
    widths = np.clip(1.0 + rng.normal(0.0, _TAPER) * 2.0 * share, 0.5, 1.5)
    vertices = mesh.vertices * factors
    vertices[:, :2] *= widths
    return _reshaped(mesh, vertices, factors)


def narrowed(mesh: RenderMesh, rng: Generator) -> RenderMesh:
    """Return a piece of furniture narrower or less deep."""
    factors = np.array([*rng.uniform(_NARROWEST, 1.0, 2), 1.0])
    return _reshaped(mesh, mesh.vertices * factors, factors)


def recoloured(mesh: RenderMesh, rng: Generator) -> RenderMesh:
    """Return a mesh in its own colours, in nearly those, or in others; textures are tinted."""
    kind = rng.random()
    if kind < _PLAIN:
        return mesh
    turn = rng.normal(0.0, 12.0) if kind < _PLAIN + _TINTED else rng.uniform(0.0, 360.0)
    hsv = cv2.cvtColor(np.ascontiguousarray(mesh.colors[None]), cv2.COLOR_RGB2HSV)[0]
    hsv[:, 0] = (hsv[:, 0] + turn) % 360.0
    hsv[:, 1:] *= np.exp(rng.normal(0.0, 0.2, 2))
    hsv[:, 1:] = np.clip(hsv[:, 1:], 0.0, 1.0)
    colors = cv2.cvtColor(np.ascontiguousarray(hsv[None], dtype=np.float32), cv2.COLOR_HSV2RGB)[0]
    tint = np.exp(rng.normal(0.0, 0.12, 3))
    return replace(mesh, colors=np.clip(colors * tint, 0.0, 1.0).astype(np.float32))


def _reshaped(mesh: RenderMesh, vertices: np.ndarray, factors: np.ndarray) -> RenderMesh:
    """Return a mesh with other vertices, whose normals are those of the stretch by (3,) factors."""
    vertices = np.ascontiguousarray(vertices, dtype=np.float32)
    normals = mesh.normals / factors.astype(np.float32)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.float32(1e-6))
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    return replace(mesh, vertices=vertices, normals=normals.astype(np.float32), low=low, high=high)


def _other_size(model: Model, rng: Generator) -> Point3:
    """Return sides that are like a model's, at most 30 cm."""
    x, y, z = (min(0.3, side * float(np.exp(rng.normal(0.0, 0.25)))) for side in model.size)
    return x, y, max(z, 0.02)
