"""The pack's instances: enough of each class to learn from and to be tested with, each another shape, each at rest."""

import math
from collections import Counter

import mujoco
import numpy as np
import pytest
from numpy.typing import NDArray

from uniteam.cli.assets import assets
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.assets.mesh import load_mesh
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES, Box, Model

CATALOGUE = load_catalogue()
OBJECTS = tuple(m for m in CATALOGUE.models.values() if m.role == "object")
MOST_TILT = math.radians(25.0)
"""A banana or a doll leans by as much before it rests."""
COUNTS = Counter((m.role, m.category, m.pool) for m in CATALOGUE.models.values())


def test_at_least_110_object_classes_have_three_instances_to_test_and_six_to_train_unless_unseen() -> None:
    enough = [
        name
        for name in CATALOGUE.object_categories
        if COUNTS["object", name, "test"] >= 3
        and (name in CATALOGUE.unseen_categories or COUNTS["object", name, "train"] >= 6)
    ]
    assert len(enough) >= 110


def test_every_receptacle_class_has_fourteen_instances_to_train_and_six_to_test() -> None:
    few = {
        name: (COUNTS["receptacle", name, "train"], COUNTS["receptacle", name, "test"])
        for name in RECEPTACLE_CATEGORIES
        if COUNTS["receptacle", name, "train"] < 14 or COUNTS["receptacle", name, "test"] < 6
    }
    assert few == {}


def _shape(model: Model) -> bytes:
    """Return what is equal for two models that differ in their colours alone: their corners, to a millimetre."""
    corners = np.unique(np.round(load_mesh(model.path).vertices, 3) + 0.0, axis=0)
    return corners.tobytes()


def test_no_instance_that_tests_has_the_shape_of_one_that_trains() -> None:
    kinds = [m for m in CATALOGUE.models.values() if m.role in ("object", "receptacle")]
    trained = {(m.category, _shape(m)): m.id for m in kinds if m.pool == "train"}
    assert trained
    repeated = {m.id: trained.get((m.category, _shape(m))) for m in kinds if m.pool == "test"}
    assert [pair for pair in repeated.items() if pair[1] is not None] == []


def _tilts_and_drops(models: tuple[Model, ...]) -> list[tuple[float, float]]:
    """Put objects a millimetre above a floor for two seconds; return their tilts (rad) and speeds (m/s) then."""
    spec = mujoco.MjSpec()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[20.0, 20.0, 0.1])
    for k, model in enumerate(models):
        body = spec.worldbody.add_body(pos=[k % 6, k // 6, 0.001])
        body.add_freejoint()
        for j, shape in enumerate(model.shapes):
            mass = model.mass / len(model.shapes)
            if isinstance(shape, Box):
                size = [s / 2 for s in shape.size]
                body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, pos=shape.center, size=size, mass=mass)
            else:
                name = f"hull_{k}_{j}"
                spec.add_mesh(name=name, uservert=np.array(shape.vertices).ravel())
                body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, mass=mass)
    compiled = spec.compile()
    data = mujoco.MjData(compiled)
    mujoco.mj_step(compiled, data, 1000)
    results = []
    for k in range(len(models)):
        up = _up(data.qpos[7 * k + 3 : 7 * k + 7])
        results.append((math.acos(float(np.clip(up, -1.0, 1.0))), float(np.linalg.norm(data.qvel[6 * k : 6 * k + 3]))))
    return results


def _up(quaternion: NDArray[np.float64]) -> float:
    """Return how much of a body's upright still points up."""
    _, x, y, _ = quaternion
    return 1.0 - 2.0 * float(x * x + y * y)


def test_every_object_comes_to_rest_and_keeps_its_upright() -> None:
    fallen = {}
    for first in range(0, len(OBJECTS), 36):
        group = OBJECTS[first : first + 36]
        for model, (tilt, speed) in zip(group, _tilts_and_drops(group), strict=True):
            if tilt > MOST_TILT or speed > 0.02:
                fallen[model.id] = round(math.degrees(tilt))
    assert not fallen


def test_the_command_counts_instances_by_class_and_pool(capsys: pytest.CaptureFixture[str]) -> None:
    assets(counts=True)
    lines = capsys.readouterr().out.splitlines()
    (cup,) = (line.split() for line in lines if "│ cup " in line)
    numbers = [int(word) for word in cup if word.isdigit()]
    assert numbers == [COUNTS["object", "cup", "train"], COUNTS["object", "cup", "test"]]
    (ladle,) = (line for line in lines if "│ ladle " in line)
    assert "yes" in ladle
