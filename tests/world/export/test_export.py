"""Homes as files for other programs."""

from functools import lru_cache
from pathlib import Path

import mujoco
import numpy as np
import pytest
import trimesh

from uniteam.world.export.glb import write_glb
from uniteam.world.export.mjcf import FILE, write_mjcf
from uniteam.world.generation.generate import generate_home
from uniteam.world.generation.style import LIVED_IN
from uniteam.world.homes.home import Home


@lru_cache
def home() -> Home:
    return generate_home(6, "test", LIVED_IN)


def bounds() -> tuple[np.ndarray, np.ndarray]:
    """Return the lowest and the highest corner of the home's rooms (m, world)."""
    rooms = home().stage.rooms
    return np.min([room.low for room in rooms], axis=0), np.max([room.high for room in rooms], axis=0)


def test_a_home_is_one_glb_with_a_node_for_each_instance(tmp_path: Path) -> None:
    write_glb(home(), tmp_path / "home.glb")
    scene = trimesh.load_scene(tmp_path / "home.glb")
    assert {instance.name for instance in home().instances} <= set(scene.graph.nodes)
    low, high = bounds()
    assert scene.bounds[0][[0, 2]] == pytest.approx([low[0], -high[1]], abs=0.2)
    assert scene.bounds[1][[0, 2]] == pytest.approx([high[0], -low[1]], abs=0.2)
    bed = home().of_category("bed")[0]
    place, _ = scene.graph[bed.name]
    x, y, z = bed.position
    assert place[:3, 3] == pytest.approx([x, z, -y], abs=1e-6)
    textured = [g for g in scene.geometry.values() if getattr(g.visual, "uv", None) is not None]
    assert len(textured) > 10


def test_a_home_is_a_mujoco_model_in_which_objects_stay_where_they_lie(tmp_path: Path) -> None:
    write_mjcf(home(), tmp_path / "out")
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "out" / FILE))
    movable = [instance for instance in home().instances if instance.movable]
    assert model.nbody == 1 + len(movable)
    assert model.ntex > 5
    seen = model.geom_group == 1
    assert (model.geom_contype[seen] == 0).all() and (model.geom_conaffinity[seen] == 0).all()
    assert seen.sum() > len(home().instances)
    data = mujoco.MjData(model)
    for _ in range(100):
        mujoco.mj_step(model, data)
    for instance in movable:
        body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, instance.name)
        assert np.linalg.norm(data.xpos[body] - instance.position) < 0.02, instance.name
        assert model.body_mass[body] == pytest.approx(home().model_of(instance).mass, rel=1e-4)
