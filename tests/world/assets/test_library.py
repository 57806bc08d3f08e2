"""Libraries from folders of anybody's: what a catalogue must say, what it adds to, and when it has changed."""

import hashlib
import json
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from worlds.glb import box, write_glb
from worlds.own_home import write_library

from uniteam.errors import DamagedFileError
from uniteam.world.assets.catalogue import Catalogue, load_catalogue, load_library
from uniteam.world.assets.textures import load_texture
from uniteam.world.assets.verify import library_problems
from uniteam.world.rendering.meshes.render_mesh import load_render_mesh

CUBE = {"id": "cube", "role": "object", "category": "die", "size": [0.1, 0.1, 0.1], "mass": 0.1,
        "shapes": [{"center": [0, 0, 0.05], "size": [0.1, 0.1, 0.1]}]}  # fmt: skip


def library_of(folder: Path, *models: dict[str, Any], **more: Any) -> Catalogue:
    (folder / "catalogue.json").write_text(json.dumps({"models": models, **more}))
    return load_library(folder)


def test_a_small_catalogue_is_enough(tmp_path: Path) -> None:
    library = library_of(tmp_path, CUBE)
    cube = library["cube"]
    assert (cube.name, cube.pool, cube.surfaces) == ("die", "test", ())
    assert cube.path == tmp_path / "models" / "cube.glb"
    assert library.object_categories == ("die",)
    assert list(library.models) == ["cube"]


def test_a_library_may_add_to_the_pack(tmp_path: Path) -> None:
    library = library_of(tmp_path, CUBE, adds_to_pack=True, unseen_categories=["die"])
    pack = load_catalogue()
    assert set(library.models) == {*pack.models, "cube"}
    assert library.textures == pack.textures
    assert library.unseen_categories == pack.unseen_categories | {"die"}
    assert library.folder == tmp_path


def test_what_adds_to_the_pack_takes_none_of_its_names(tmp_path: Path) -> None:
    with pytest.raises(DamagedFileError, match="'cup_red_mug' is a name of the pack already"):
        library_of(tmp_path, {**CUBE, "id": "cup_red_mug"}, adds_to_pack=True)


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"id": "../cube"}, r"models\[0\].id"),
        ({"id": "cube\n"}, r"models\[0\].id"),
        ({"role": "toy"}, r"Invalid enum value 'toy' - at `\$.models\[0\].role`"),
        ({"mass": 0}, r"models\[0\].mass"),
        ({"size": [0.1, 0.1]}, r"models\[0\].size"),
        ({"size": [0.1, 0.1, float("nan")]}, "malformed"),
        ({"weight": 3}, "unknown field `weight`"),
        ({"shapes": []}, "model 'cube': a model whose role is object needs collision shapes"),
        ({"shapes": [{"center": [0, 0, 0]}]}, "either a center and a size, or a hull"),
        ({"shapes": [{"hull": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}]}, r"shapes\[0\].hull"),
        ({"category": "table"}, "is a class of receptacles"),
        ({"role": "receptacle"}, "category 'die' of a receptacle must be one of bathtub"),
        ({"surfaces": [{"height": 1, "outline": [[0, 0], [0, 1], [1, 0]], "clearance": 1}]}, "counter-clockwise"),
    ],
)
def test_a_wrong_catalogue_names_the_model_and_the_field(tmp_path: Path, change: dict[str, Any], reason: str) -> None:
    with pytest.raises(DamagedFileError, match=reason) as raised:
        library_of(tmp_path, {**CUBE, **change})
    assert str(tmp_path / "catalogue.json") in str(raised.value)


def test_two_models_of_one_name_are_refused(tmp_path: Path) -> None:
    with pytest.raises(DamagedFileError, match="model 'cube': there are two of them"):
        library_of(tmp_path, CUBE, CUBE)


def test_a_changed_catalogue_is_read_anew(tmp_path: Path) -> None:
    assert library_of(tmp_path, CUBE)["cube"].mass == 0.1
    assert library_of(tmp_path, {**CUBE, "mass": 0.25})["cube"].mass == 0.25


def test_a_mesh_that_is_not_as_large_as_the_catalogue_says_is_refused(tmp_path: Path) -> None:
    write_glb(tmp_path / "models" / "cube.glb", box((-5.0, -5.0, 0.0), (5.0, 5.0, 10.0)))
    with pytest.raises(DamagedFileError, match=r"its bounding box is 10 x 10 x 10 m and must be 0.1 x 0.1 x 0.1 m"):
        load_render_mesh(library_of(tmp_path, CUBE)["cube"])


def test_a_changed_mesh_is_read_anew(tmp_path: Path) -> None:
    path = tmp_path / "models" / "cube.glb"
    cube = library_of(tmp_path, CUBE)["cube"]
    for half in (0.05, 0.045):
        write_glb(path, box((-half, -half, 0.0), (half, half, 0.1)))
        assert load_render_mesh(cube).high[0] == pytest.approx(half)


def test_a_library_may_have_textures_of_its_own(tmp_path: Path) -> None:
    folder = tmp_path / "textures"
    folder.mkdir()
    cv2.imwrite(str(folder / "cork.jpg"), np.full((16, 16, 3), 120, np.uint8))
    (folder / "textures.json").write_text(json.dumps({"cork": {"kinds": ["floor"], "size": 0.5}}))
    library = library_of(tmp_path, CUBE)
    assert library.texture_names("floor") == ("cork",)
    assert load_texture(library.texture("cork")).shape == (16, 16, 3)
    (folder / "cork.jpg").write_bytes(b"no picture")
    with pytest.raises(DamagedFileError, match=r"cork\.jpg cannot be read"):
        load_texture(library.texture("cork"))


def test_the_digest_tells_libraries_apart_by_what_results_depend_on(tmp_path: Path) -> None:
    write_library(tmp_path / "one")
    write_library(tmp_path / "two")
    one, two = load_library(tmp_path / "one"), load_library(tmp_path / "two")
    assert one.digest == two.digest != load_catalogue().digest
    mesh = tmp_path / "two" / "models" / "own_cup.glb"
    mesh.write_bytes(mesh.read_bytes().replace(b"0.8", b"0.7"))
    assert Catalogue(two.models, two.unseen_categories, two.textures, two.folder).digest != one.digest


def test_a_missing_mesh_has_no_digest_but_a_sentence(tmp_path: Path) -> None:
    with pytest.raises(DamagedFileError, match=r"cube\.glb cannot be read \(there is no such file\)"):
        _ = library_of(tmp_path, CUBE).digest


def test_a_checksum_is_checked_where_one_is_written_down(tmp_path: Path) -> None:
    path = tmp_path / "models" / "cube.glb"
    write_glb(path, box((-0.05, -0.05, 0.0), (0.05, 0.05, 0.1)))
    assert not list(library_problems(library_of(tmp_path, CUBE)))
    right = hashlib.sha256(path.read_bytes()).hexdigest()
    assert not list(library_problems(library_of(tmp_path, {**CUBE, "checksum": right})))
    wrong = library_problems(library_of(tmp_path, {**CUBE, "checksum": "0" * 64}))
    assert list(wrong) == ["models/cube.glb has changed since it was built"]
