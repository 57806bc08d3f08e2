"""Looks that the things of a training home get: other shapes and colours, the same places, a few of no name."""

import numpy as np
import pytest
import trimesh
from worlds.filled import filled

from uniteam.training.crop_samples import crops_of
from uniteam.training.nameless import nameless_mesh
from uniteam.training.other_looks import NAMELESS, OtherLooks, other_looks, recoloured
from uniteam.training.records import things_of
from uniteam.training.views import training_home, views_of
from uniteam.world.homes.home import Home
from uniteam.world.rendering.meshes.render_mesh import load_render_mesh


@pytest.fixture(scope="module")
def drawn() -> tuple[Home, OtherLooks]:
    home = training_home(0)
    return home, other_looks(home, np.random.default_rng(0))


def test_furniture_keeps_its_height_and_gets_no_wider(drawn: tuple[Home, OtherLooks]) -> None:
    home, looks = drawn
    for instance in filled([i for i in home.instances if not i.movable]):
        mesh, own = looks.mesh_of(home, instance), load_render_mesh(home.model_of(instance))
        assert mesh.high[2] == own.high[2] and mesh.low[2] == own.low[2]
        assert ((mesh.high - mesh.low)[:2] <= (own.high - own.low)[:2] + 1e-6).all()


def test_small_things_are_of_other_shapes_and_stand_on_their_floor(drawn: tuple[Home, OtherLooks]) -> None:
    home, looks = drawn
    for instance in filled([i for i in home.instances if i.movable]):
        mesh, own = looks.mesh_of(home, instance), load_render_mesh(home.model_of(instance))
        assert abs(mesh.low[2]) < 1e-3
        assert np.abs((mesh.high - mesh.low) / (own.high - own.low) - 1.0).max() > 0.01
        assert np.abs(np.linalg.norm(mesh.normals, axis=1) - 1.0).max() < 1e-3


def test_a_few_things_have_no_name_and_teach_none(drawn: tuple[Home, OtherLooks]) -> None:
    home, looks = drawn
    things, own = looks.things_of(home), things_of(home)
    nameless = [i for i, thing in enumerate(things) if thing.category == NAMELESS]
    assert 0 < len(nameless) < 0.3 * sum(i.movable for i in home.instances)
    assert all(things[i].role == "object" for i in nameless)
    assert [t for i, t in enumerate(things) if i not in nameless] == [t for i, t in enumerate(own) if i not in nameless]
    rng = np.random.default_rng(0)
    views = list(views_of(home, 12, rng, mesh_of=looks.mesh_of))
    assert any(np.isin(nameless, view.half.instances).any() for view in views)
    shown = [c.thing.category for view in views for c in crops_of(view, things, rng) if c.thing is not None]
    assert shown and NAMELESS not in shown


def test_colours_change_for_some_and_stay_colours() -> None:
    home, rng = training_home(0), np.random.default_rng(0)
    own = load_render_mesh(home.model_of(home.instances[0]))
    meshes = [recoloured(own, rng) for _ in range(60)]
    changed = [mesh for mesh in meshes if mesh is not own]
    assert 0.3 < len(changed) / len(meshes) < 0.8
    for mesh in changed:
        assert mesh.colors.min() >= 0.0 and mesh.colors.max() <= 1.0 and mesh.colors.shape == own.colors.shape


@pytest.mark.parametrize("seed", range(12))
def test_nameless_shapes_are_closed_and_of_the_size_asked_for(seed: int) -> None:
    mesh = nameless_mesh((0.1, 0.2, 0.3), np.random.default_rng(seed))
    solid = trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False)
    solid.merge_vertices(digits_vertex=6)
    assert solid.is_watertight and solid.volume > 0.0
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    assert low[2] == 0.0 and high[2] == pytest.approx(0.3)
    assert (high[:2] <= np.array([0.05, 0.1]) + 1e-6).all() and (low[:2] >= np.array([-0.05, -0.1]) - 1e-6).all()
    assert np.abs(np.einsum("ij,ij->i", mesh.normals[::3], solid.face_normals) - 1.0).max() < 1e-3
