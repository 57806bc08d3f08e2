"""The pack as it is shipped: complete, within its budgets, licensed, true to size, and able to hold things."""

import os
from collections import Counter

import cv2
import mujoco
import numpy as np
import pytest
from numpy.typing import NDArray

from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.assets.mesh import load_mesh
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES, Box, CollisionShape, Model
from uniteam.world.assets.reading import PACK_DIRECTORY
from uniteam.world.assets.textures import TextureKind, load_texture
from uniteam.world.assets.verify import verify_pack

CATALOGUE = load_catalogue()
MODELS = tuple(CATALOGUE.models.values())
RECEPTACLES = tuple(m for m in MODELS if m.role == "receptacle")
OBJECTS = tuple(m for m in MODELS if m.role == "object")
LICENCES = {"CC0-1.0", "CC-BY-3.0", "CC-BY-3.0-US", "BSD-3-Clause", "BSD-3-Clause-Clear", "MIT"}
MEGABYTE = 1024 * 1024


def _vertices(shape: CollisionShape) -> NDArray[np.float64]:
    if isinstance(shape, Box):
        signs = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
        return np.array(shape.center) + signs * np.array(shape.size)
    return np.array(shape.vertices)


def test_every_receptacle_class_has_models_to_choose_from() -> None:
    counts = Counter(m.category for m in RECEPTACLES)
    assert set(counts) == set(RECEPTACLE_CATEGORIES)
    assert min(counts.values()) >= 4
    assert sum(counts.values()) >= 110


def test_there_are_many_objects_of_many_classes_that_a_gripper_can_hold() -> None:
    assert len(OBJECTS) >= 140
    assert len(CATALOGUE.object_categories) >= 60
    too_large = [m.id for m in OBJECTS if min(m.size) > 0.1405 or max(m.size) > 0.505]
    assert not too_large


def test_a_quarter_of_the_object_classes_is_unseen_and_never_trains() -> None:
    share = len(CATALOGUE.unseen_categories) / len(CATALOGUE.object_categories)
    assert 0.22 <= share <= 0.30
    assert set(CATALOGUE.object_categories) >= CATALOGUE.unseen_categories
    assert not [m.id for m in OBJECTS if m.category in CATALOGUE.unseen_categories and m.pool == "train"]


def test_a_class_of_two_or_more_models_has_both_pools() -> None:
    seen = [m for m in MODELS if m.role != "object" or m.category not in CATALOGUE.unseen_categories]
    counts = Counter((m.role, m.category) for m in seen)
    pools = Counter((m.role, m.category, m.pool) for m in seen)
    lacking = [key for key, n in counts.items() if n > 1 and not (pools[(*key, "train")] and pools[(*key, "test")])]
    assert not lacking


def test_the_pack_is_intact() -> None:
    assert verify_pack() == ()


def test_the_pack_is_small_enough_to_ship() -> None:
    assert sum(f.stat().st_size for f in PACK_DIRECTORY.rglob("*") if f.is_file()) < 45 * MEGABYTE


def test_every_file_of_a_model_is_in_the_catalogue() -> None:
    files = {path.stem for path in (PACK_DIRECTORY / "models").glob("*.glb")}
    assert files == set(CATALOGUE.models)


def test_meshes_keep_their_budgets_and_their_sizes() -> None:
    wrong = []
    for model in MODELS:
        mesh = load_mesh(model.path)
        extent = np.ptp(mesh.vertices, axis=0)
        large = max((max(m.texture.shape[:2]) for m in mesh.materials if m.texture is not None), default=0)
        is_within = len(mesh.triangles) <= (8000 if model.role == "receptacle" else 5000) and large <= 512
        is_true = np.abs(extent - model.size).max() < 0.01 and abs(mesh.vertices[:, 2].min()) < 0.002
        is_centred = np.abs(mesh.vertices[:, :2].min(0) + mesh.vertices[:, :2].max(0)).max() < 0.004
        if not (is_within and is_true and is_centred):
            wrong.append(model.id)
    assert not wrong


def test_meshes_are_well_formed() -> None:
    wrong = []
    for model in MODELS:
        mesh = load_mesh(model.path)
        is_indexed = mesh.triangles.min() >= 0 and mesh.triangles.max() < len(mesh.vertices)
        has_materials = mesh.triangle_materials.max() < len(mesh.materials)
        is_finite = all(np.isfinite(array).all() for array in (mesh.vertices, mesh.normals, mesh.uvs))
        is_unit = np.abs(np.linalg.norm(mesh.normals, axis=1) - 1).max() < 0.02
        if not (is_indexed and has_materials and is_finite and is_unit):
            wrong.append(model.id)
    assert not wrong


def test_collision_shapes_are_few_simple_and_within_the_model() -> None:
    wrong = []
    for model in MODELS:
        low = np.array([-model.size[0] / 2, -model.size[1] / 2, 0.0]) - 0.03
        high = np.array([model.size[0] / 2, model.size[1] / 2, model.size[2]]) + 0.03
        points = [_vertices(shape) for shape in model.shapes]
        is_inside = all((p >= low).all() and (p <= high).all() for p in points)
        is_simple = len(points) <= 20 and all(len(p) <= 32 for p in points)
        is_there = bool(points) or model.role == "decor"
        if not (is_inside and is_simple and is_there):
            wrong.append(model.id)
    assert not wrong


def test_every_receptacle_has_a_surface_that_the_robot_reaches() -> None:
    without = [
        m.id for m in RECEPTACLES if not any(0.05 <= s.height <= 1.1 and s.clearance >= 0.15 for s in m.surfaces)
    ]
    assert not without


def test_surfaces_are_convex_counter_clockwise_and_within_the_model() -> None:
    wrong = []
    for model in RECEPTACLES:
        for surface in model.surfaces:
            outline = np.array(surface.outline)
            edges = np.roll(outline, -1, axis=0) - outline
            after = np.roll(edges, -1, axis=0)
            turns = edges[:, 0] * after[:, 1] - edges[:, 1] * after[:, 0]
            is_inside = (np.abs(outline) <= np.array(model.size[:2]) / 2 + 0.03).all()
            if not (is_inside and (turns > -1e-6).all() and 0 < surface.height <= model.size[2] + 0.02):
                wrong.append(model.id)
    assert not wrong


def _resting_errors(model: Model) -> list[float]:
    """Drop a 5 cm cube on the middle of every surface; return how far (m) it rests from the surface's height."""
    half = 0.025
    spec = mujoco.MjSpec()
    for k, shape in enumerate(model.shapes):
        if isinstance(shape, Box):
            size = [s / 2 for s in shape.size]
            spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, pos=shape.center, size=size)
        else:
            spec.add_mesh(name=f"hull_{k}", uservert=np.array(shape.vertices).ravel())
            spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=f"hull_{k}")
    for surface in model.surfaces:
        x, y = np.mean(surface.outline, axis=0)
        body = spec.worldbody.add_body(pos=[x, y, surface.height + half + 0.01])
        body.add_freejoint()
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=[half] * 3, mass=0.1, contype=2)
    compiled = spec.compile()
    data = mujoco.MjData(compiled)
    for _ in range(200):
        mujoco.mj_step(compiled, data)
    return [float(data.qpos[7 * k + 2] - half - s.height) for k, s in enumerate(model.surfaces)]


def test_what_is_dropped_on_a_surface_rests_at_its_height() -> None:
    wrong = {m.id: errors for m in RECEPTACLES if np.abs(errors := _resting_errors(m)).max(initial=0) > 0.01}
    assert not wrong


def test_only_free_licences_and_everyone_is_thanked() -> None:
    text = (PACK_DIRECTORY / "ATTRIBUTION.md").read_text(encoding="utf-8")
    assert {m.licence for m in MODELS} <= LICENCES
    assert not [m.id for m in MODELS if m.creator not in text or f"`{m.source_id}`" not in text or m.source not in text]
    assert all(licence in text for licence in {m.licence for m in MODELS})


def test_masses_are_plausible() -> None:
    assert not [m.id for m in OBJECTS if not 0.005 <= m.mass <= 3.0]
    assert not [m.id for m in RECEPTACLES if not 1.5 <= m.mass <= 200.0]


@pytest.mark.parametrize("kind", ["floor", "wall"])
def test_textures_are_square_tiles_of_a_known_size(kind: TextureKind) -> None:
    names = CATALOGUE.texture_names(kind)
    assert len(names) >= 15
    for name in names:
        image = load_texture(CATALOGUE.texture(name))
        assert image.dtype == np.uint8
        assert image.shape == (512, 512, 3)
        assert 0.2 <= CATALOGUE.texture(name).size <= 3.0


def test_textures_tile_without_a_seam() -> None:
    for name in ("planks_oak", "plaster_white", "carpet_grey"):
        grey = cv2.cvtColor(load_texture(CATALOGUE.texture(name)), cv2.COLOR_RGB2GRAY).astype(float)
        seam = np.abs(grey[:, 0] - grey[:, -1]).mean()
        inner = np.abs(np.diff(grey, axis=1)).mean()
        assert seam < 3 * inner + 2


def test_models_read_fast() -> None:
    chosen = [m.path for m in MODELS[::6]][:100]
    spent = -os.times().user
    for path in chosen:
        load_mesh(path)
    spent += os.times().user
    assert spent < 1.5
