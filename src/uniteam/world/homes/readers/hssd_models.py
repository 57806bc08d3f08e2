"""Models from object configs: the file's frame made ours, with what they collide as and what holds things.

A model here has its origin in the middle of its underside; a file of HSSD has it anywhere, and an instance may stretch
it. Both go into the model's `file_to_model`, and so does a rotation that is not about the vertical, as furniture here
stands upright.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from hashlib import sha256
from pathlib import Path

import cv2
import msgspec
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import Point2, quaternion_to_matrix
from uniteam.world.assets.mesh import Mesh, load_geometry, load_pieces, moved
from uniteam.world.assets.model import (
    RECEPTACLE_CATEGORIES,
    CollisionShape,
    Model,
    Role,
    SupportSurface,
)
from uniteam.world.assets.reading import damaged, read_json
from uniteam.world.homes.readers.convex_parts import bounding_box, convex_hull, convex_parts
from uniteam.world.homes.readers.habitat_frame import TO_WORLD, scale_to_world
from uniteam.world.homes.readers.hssd_schema import ObjectConfig, ReceptacleData, Three

SUFFIX = ".object_config.json"
OPEN_TO_THE_AIR = 2.0
"""The clearance of a surface with nothing of its model above it (m)."""

_LIGHTEST = 0.01
_THINNEST = 1e-3
_WHAT = "the object config"
Matrix = NDArray[np.float64]


@dataclass(frozen=True)
class PlacedModel:
    """A model, and where its origin and its centre of mass are in the scaled and tilted frame of its file.

    Attributes:
        model: as a library has it.
        origin: (3,) of the model's frame (m, z up).
        center_of_mass: (3,) m.
    """

    model: Model
    origin: Matrix
    center_of_mass: Matrix


@dataclass(frozen=True)
class ModelReader:
    """Reads models from object configs, each way of showing one once.

    Attributes:
        configs: the configs' paths by their names.
        categories: the classes of models by their names; what has none is a "thing".
    """

    configs: Mapping[str, Path]
    categories: Mapping[str, str]
    _known: dict[tuple[str, str], PlacedModel] = field(default_factory=dict)

    def furniture(self, name: str, stretch: Three, tilt: Matrix) -> PlacedModel:
        """Return a model that stays where it is.

        Args:
            name: of its config, without the ending.
            stretch: by how much the instance is longer than its config says, along the file's axes.
            tilt: (3, 3), what of the instance's rotation is not about z.

        Raises:
            DamagedFileError: its config or one of its meshes is missing or cannot be read.
        """
        category = self.categories.get(name, "thing")
        return self._read(name, "receptacle" if category in RECEPTACLE_CATEGORIES else "decor", stretch, tilt)

    def small_object(self, name: str) -> PlacedModel:
        """Return a model that can be grasped; raises DamagedFileError."""
        return self._read(name, "object", (1.0, 1.0, 1.0), np.eye(3))

    def _read(self, name: str, role: Role, stretch: Three, tilt: Matrix) -> PlacedModel:
        linear = tilt * scale_to_world(stretch)
        shape = "" if np.allclose(linear, np.eye(3), atol=1e-6) else _digest(linear)
        key = (name, f"{role} {shape}")
        if key not in self._known:
            if name not in self.configs:
                raise damaged(Path(f"{name}{SUFFIX}"), _WHAT, "there is no such file among those of the data")
            facts = (f"{name}~{shape}" if shape else name, role, self.categories.get(name, "thing"))
            self._known[key] = _placed(self.configs[name], facts, linear)
        return self._known[key]


def _digest(matrix: Matrix) -> str:
    return sha256(repr(matrix.round(6).tolist()).encode()).hexdigest()[:8]


def _placed(path: Path, facts: tuple[str, Role, str], linear: Matrix) -> PlacedModel:
    config = read_json(path, _WHAT, ObjectConfig)
    linear = linear * scale_to_world(config.scale or (1.0, 1.0, 1.0))
    file = path.parent / config.render_asset
    raw = load_geometry(file)
    corners = raw.vertices.astype(np.float64) @ linear.T
    low, high = corners.min(axis=0), corners.max(axis=0)
    origin = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    to_model = np.eye(4)
    to_model[:3, :3], to_model[:3, 3] = linear, -origin
    mass = (low + high) / 2 if config.center_of_mass is None else linear @ TO_WORLD @ np.array(config.center_of_mass)
    x, y, z = np.maximum(high - low, _THINNEST).tolist()
    name, role, category = facts
    model = Model(
        id=name,
        role=role,
        category=category,
        name=category.replace("_", " "),
        size=(x, y, z),
        mass=max(config.mass or 1.0, _LIGHTEST),
        pool="test",
        shapes=_shapes(config, path, moved(raw, to_model), to_model, role),
        surfaces=tuple(_surfaces(config, path, to_model)) if role == "receptacle" else (),
        source="",
        source_id=path.name.removesuffix(SUFFIX),
        creator="",
        licence="",
        checksum="",
        path=file,
        file_to_model=tuple((float(a), float(b), float(c), float(d)) for a, b, c, d in to_model),
    )
    return PlacedModel(model, origin, mass)


def _shapes(config: ObjectConfig, path: Path, shown: Mesh, to_model: Matrix, role: Role) -> tuple[CollisionShape, ...]:
    """Return what a model collides as: its collider's connected parts, one hull for what can be grasped."""
    if not config.is_collidable and role == "decor":
        return ()
    if config.use_bounding_box_for_collision:
        return (bounding_box(shown),)
    file = path.parent / (config.collision_asset or config.render_asset)
    pieces = [moved(piece, to_model) for piece in load_pieces(file)]
    if role == "object":
        hull = convex_hull(np.concatenate([piece.vertices for piece in pieces]))
        return (bounding_box(shown) if hull is None else hull,)
    return convex_parts(pieces) or (bounding_box(shown),)


def _surfaces(config: ObjectConfig, path: Path, to_model: Matrix) -> Iterator[SupportSurface]:
    """Yield the surfaces that a config calls receptacles."""
    outlines = []
    for name, value in sorted(config.user_defined.items()):
        if name.startswith(("receptacle_mesh_", "receptacle_aabb_")):
            points = _receptacle(name, value, path) @ to_model[:3, :3].T + to_model[:3, 3]
            outlines.append((float(points[:, 2].mean()), _outline(points)))
    for height, outline in outlines:
        above = [other - height for other, _ in outlines if other > height + 0.02]
        if height >= 0.0 and len(outline) >= 3:
            yield SupportSurface(height, outline, min(above, default=OPEN_TO_THE_AIR))


def _receptacle(name: str, value: object, path: Path) -> Matrix:
    """Return the (N, 3) points of a receptacle, in its file's frame turned to z up; of a box, those of its floor."""
    try:
        data = msgspec.convert(value, ReceptacleData)
    except msgspec.ValidationError as error:
        raise damaged(path, _WHAT, f"{name}: {error}") from error
    rotation = TO_WORLD @ quaternion_to_matrix(np.array(data.rotation)) @ TO_WORLD.T
    if name.startswith("receptacle_aabb_") or data.mesh_filepath is None:
        points = np.array([[x, y, -1.0] for x in (-1.0, 1.0) for y in (-1.0, 1.0)])
    else:
        points = load_geometry(path.parent / data.mesh_filepath).vertices.astype(np.float64)
    return np.asarray((points * scale_to_world(data.scale)) @ rotation.T + TO_WORLD @ np.array(data.position))


def _outline(points: Matrix) -> tuple[Point2, ...]:
    """Return the convex outline of some points seen from above, counter-clockwise."""
    hull = cv2.convexHull(points[:, :2].astype(np.float32))[:, 0].astype(np.float64)
    x, y = hull.T
    turns = float(x @ np.roll(y, -1) - y @ np.roll(x, -1))
    return tuple((float(a), float(b)) for a, b in (hull if turns > 0.0 else hull[::-1]))
