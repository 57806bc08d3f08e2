"""Damaged homes, libraries and meshes, many of them: each is refused in one sentence, or can be used to the end."""

import copy
import json
import shutil
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from worlds.filled import filled
from worlds.glb import packed
from worlds.nonsense import outcome
from worlds.own_home import made_home

from uniteam.visualization.home_pictures import draw_plan
from uniteam.world.assets.catalogue import load_catalogue, load_library
from uniteam.world.assets.mesh import load_mesh
from uniteam.world.assets.verify import library_problems
from uniteam.world.homes.home import Home
from uniteam.world.homes.serialization import home_from_data, home_to_data, read_home
from uniteam.world.physics.navigable_floor import NavigableFloor
from uniteam.world.physics.physics import Physics
from uniteam.world.rendering.scene import Scene

pytestmark = pytest.mark.slow

many = settings(
    max_examples=150,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)

NUMBERS = st.one_of(
    st.sampled_from([0, -1, 1, 2**31, 2**63, 10**400, 0.0, -0.0, 1e-9, 1e9, 1e308, float("nan"), float("inf")]),
    st.floats(-10.0, 10.0),
    st.integers(-5, 5),
)
VALUES = st.one_of(
    st.none(), st.booleans(), NUMBERS, st.text(max_size=8), st.sampled_from(["", "floor", "../..", "/etc", "a\x1b[2J"]),
    st.lists(NUMBERS, max_size=4), st.just({}), st.just([[]]), st.just({"low": [0, 0]}),
)  # fmt: skip


def places(data: Any, path: tuple[str | int, ...] = ()) -> list[tuple[str | int, ...]]:
    """Return the paths to everything in JSON data."""
    items = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    return [path, *(found for key, value in items for found in places(value, (*path, key)))]


@st.composite
def changed(draw: st.DrawFn, data: Any) -> Any:
    """Return JSON data with one to three things replaced, left out or doubled."""
    data = copy.deepcopy(data)
    for _ in range(draw(st.integers(1, 3))):
        found = places(data)[1:]
        if not found:
            break
        *way, key = found[draw(st.integers(0, len(found) - 1))]
        owner = data
        for step in way:
            owner = owner[step]
        action = draw(st.sampled_from(["replace", "replace", "leave out", "double", "nudge"]))
        if action == "leave out":
            del owner[key]
        elif action == "double" and isinstance(owner, list):
            owner.insert(int(key), copy.deepcopy(owner[int(key)]))
        elif action == "nudge" and isinstance(owner[key], float | int) and abs(owner[key]) < 1e9:
            owner[key] = owner[key] * draw(st.sampled_from([-1, 1000, 0.001])) + draw(st.sampled_from([0, 0.5, -3]))
        else:
            owner[key] = copy.deepcopy(draw(VALUES))
    return data


def broken(content: bytes) -> st.SearchStrategy[bytes]:
    """Return a strategy for files with bytes changed, left out or cut off."""
    spots = st.lists(st.tuples(st.integers(0, len(content) - 1), st.integers(0, 255)), min_size=1, max_size=8)
    cuts = st.tuples(st.integers(0, len(content)), st.integers(1, 40))
    return st.one_of(
        spots.map(lambda changes: _with_bytes(content, changes)),
        st.integers(0, len(content)).map(lambda end: content[:end]),
        cuts.map(lambda cut: content[: cut[0]] + content[cut[0] + cut[1] :]),
    )


def _with_bytes(content: bytes, changes: list[tuple[int, int]]) -> bytes:
    changed = bytearray(content)
    for index, value in changes:
        changed[index] = value
    return bytes(changed)


def use(home: Home) -> None:
    """Do with a home all that is done with one, and see that nothing in it is infinite or no number."""
    assert np.isfinite(NavigableFloor(home).cells).all()
    physics = Physics(home)
    assert all(np.isfinite(physics.pose(i.name)).all() for i in filled(i for i in home.instances if i.movable))
    buffers = Scene(home).buffers()
    assert np.isfinite(buffers.vertices).all() and np.isfinite(buffers.light).all()
    assert buffers.triangles.min(initial=0) >= 0 and buffers.triangles.max(initial=-1) < len(buffers.vertices)
    draw_plan(home)


def read_mesh(path: Path) -> None:
    """Read a mesh, and see that its triangles are of its vertices, somewhere."""
    mesh = load_mesh(path)
    assert np.isfinite(mesh.vertices).all() and np.isfinite(mesh.normals).all()
    assert mesh.triangles.min(initial=0) >= 0 and mesh.triangles.max(initial=-1) < len(mesh.vertices)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("own")


@pytest.fixture(scope="module")
def home(folder: Path) -> Home:
    return made_home(folder)


@many
@given(data=st.data())
def test_a_changed_home_is_refused_or_can_be_used(data: st.DataObject, home: Home, folder: Path) -> None:
    plain = json.loads(json.dumps(home_to_data(home, folder)))
    wrong = data.draw(changed(plain))
    outcome(lambda: use(home_from_data(wrong, folder)))


@many
@given(data=st.data())
def test_a_changed_catalogue_is_refused_or_can_be_used(data: st.DataObject, home: Home, folder: Path) -> None:
    path = folder / "library" / "catalogue.json"
    content = path.read_bytes()
    plain = home_to_data(home, folder)
    wrong = data.draw(st.one_of(broken(content), changed(json.loads(content)).map(lambda d: json.dumps(d).encode())))
    path.write_bytes(wrong)
    try:
        outcome(lambda: use(home_from_data(plain, folder)))
        outcome(lambda: list(library_problems(load_library(folder / "library"))))
    finally:
        path.write_bytes(content)


@many
@given(data=st.data())
def test_a_changed_mesh_is_refused_or_can_be_read(data: st.DataObject, tmp_path: Path) -> None:
    model = load_catalogue()[data.draw(st.sampled_from(["book_cookery", "cup_red_mug", "trunk_b0_crate"]))]
    content = model.path.read_bytes()
    (json_length,) = struct.unpack_from("<I", content, 12)
    document, blob = json.loads(content[20 : 20 + json_length]), content[28 + json_length :]
    path = tmp_path / "mesh.glb"
    path.write_bytes(data.draw(st.one_of(broken(content), changed(document).map(lambda wrong: packed(wrong, blob)))))
    outcome(lambda: read_mesh(path))


@many
@given(data=st.data())
def test_a_home_with_a_changed_mesh_is_refused_or_can_be_used(data: st.DataObject, home: Home, folder: Path) -> None:
    name = data.draw(st.sampled_from(["stage.glb", "library/models/own_table.glb"]))
    shutil.copytree(folder / "library", folder / "other" / "library", dirs_exist_ok=True)
    shutil.copy(folder / "stage.glb", folder / "other" / "stage.glb")
    (folder / "other" / name).write_bytes(data.draw(broken((folder / name).read_bytes())))
    outcome(lambda: use(home_from_data(home_to_data(home, folder), folder / "other")))


@many
@given(content=st.binary(max_size=60))
def test_any_bytes_are_no_home(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "home.json"
    path.write_bytes(content)
    outcome(lambda: use(read_home(path)))
