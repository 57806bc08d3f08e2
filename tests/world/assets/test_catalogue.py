"""Reading the pack: meshes, textures, damaged files, the command."""

import json
import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from uniteam.cli.assets import assets, write_sheets
from uniteam.errors import DamagedFileError, UnknownNameError
from uniteam.visualization.contact_sheet import draw_sheet
from uniteam.visualization.shape_mesh import hull_triangles, shapes_and_surfaces
from uniteam.world.assets.catalogue import Catalogue, load_catalogue
from uniteam.world.assets.mesh import load_mesh
from uniteam.world.assets.model import Model
from uniteam.world.assets.verify import library_problems


def _model(category: str) -> Model:
    return load_catalogue().of_category(category)[0]


def test_a_mesh_has_the_shapes_and_types_the_camera_reads() -> None:
    mesh = load_mesh(_model("table").path)
    assert mesh.vertices.dtype == mesh.normals.dtype == mesh.uvs.dtype == np.float32
    assert mesh.triangles.dtype == mesh.triangle_materials.dtype == np.int32
    assert mesh.vertices.shape == mesh.normals.shape
    assert mesh.uvs.shape == (len(mesh.vertices), 2)
    assert mesh.triangle_materials.shape == (len(mesh.triangles),)
    assert all(array.flags.c_contiguous for array in (mesh.vertices, mesh.normals, mesh.uvs, mesh.triangles))


def test_a_table_faces_up_where_it_holds_things() -> None:
    model = max(load_catalogue().of_category("table"), key=lambda m: m.surfaces[0].height * len(m.id))
    mesh = load_mesh(model.path)
    top = model.surfaces[0].height
    corners = mesh.vertices[mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    is_top = (np.abs(corners[..., 2] - top) < 0.03).all(axis=1) & (np.abs(normals[:, 2]) > 1e-3)
    assert normals[is_top, 2].sum() > 0


def test_a_triangle_winds_the_way_its_normals_point() -> None:
    for category in ("chair", "bowl", "book", "refrigerator"):
        mesh = load_mesh(_model(category).path)
        corners = mesh.vertices[mesh.triangles]
        faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        smooth = mesh.normals[mesh.triangles].mean(axis=1)
        agrees = np.einsum("ij,ij->i", faces, smooth) >= 0
        assert np.average(agrees, weights=np.linalg.norm(faces, axis=1)) > 0.97


def test_a_cut_off_model_is_reported_as_damaged(tmp_path: Path) -> None:
    data = _model("cup").path.read_bytes()
    path = tmp_path / "cup.glb"
    path.write_bytes(data[: len(data) // 2])
    with pytest.raises(DamagedFileError, match="no complete glTF 2 binary"):
        load_mesh(path)


def test_a_missing_model_is_reported_as_damaged(tmp_path: Path) -> None:
    with pytest.raises(DamagedFileError):
        load_mesh(tmp_path / "nothing.glb")


def test_a_model_whose_document_names_no_mesh_is_reported_as_damaged(tmp_path: Path) -> None:
    text = json.dumps({"asset": {"version": "2.0"}}).encode()
    text += b" " * (-len(text) % 4)
    chunk = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", 0, b"BIN\x00")
    path = tmp_path / "empty.glb"
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunk)) + chunk)
    with pytest.raises(DamagedFileError):
        load_mesh(path)


def test_an_unknown_texture_is_answered_with_the_nearest() -> None:
    with pytest.raises(UnknownNameError, match="planks_oak"):
        load_catalogue().texture("plank_oak")


def test_a_changed_and_a_missing_file_are_found(tmp_path: Path) -> None:
    changed, missing = tmp_path / "changed.glb", tmp_path / "missing.glb"
    changed.write_bytes(b"something else")
    cup = replace(_model("cup"), checksum="0" * 64)
    library = Catalogue({"one": replace(cup, path=changed), "two": replace(cup, path=missing)}, frozenset())
    one, two = library_problems(library)
    assert one.endswith("changed.glb has changed since it was built")
    assert two.endswith("missing.glb is missing")


def test_a_sheet_shows_every_model_on_its_paper() -> None:
    models = [_model(c) for c in ("chair", "table", "cup")]
    page = draw_sheet(models, columns=2, side=64)
    assert page.shape == (2 * (64 + 30), 2 * 64, 3)
    cells = [page[:64, :64], page[:64, 64:], page[94:158, :64], page[94:158, 64:]]
    drawn = [float((cell.std(axis=(0, 1)) > 5).any()) for cell in cells]
    assert drawn == [1.0, 1.0, 1.0, 0.0]


def test_shapes_and_surfaces_become_meshes() -> None:
    model = _model("table")
    parts = shapes_and_surfaces(model)
    assert len(parts) == len(model.shapes) + len(model.surfaces)
    assert np.allclose(parts["surface_0"].vertices[:, 2], model.surfaces[0].height, atol=0.005)


def test_the_hull_of_a_cube_has_faces_that_point_outwards() -> None:
    cube = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    corners = cube[hull_triangles(cube)]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.einsum("ij,ij->i", normals, corners[:, 0] - 0.5) > 0).all()


def test_the_command_lists_a_category_and_writes_its_sheet(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assets("shoe_rack", sheet=tmp_path)
    assert "models of shoe_rack" in capsys.readouterr().out
    assert (tmp_path / "sheet_00.png").stat().st_size > 1000


def test_the_command_lists_every_category(capsys: pytest.CaptureFixture[str]) -> None:
    assets()
    shown = capsys.readouterr().out
    assert "washer_dryer" in shown
    assert "unseen" in shown


def test_a_misspelt_category_is_answered_with_the_nearest() -> None:
    with pytest.raises(UnknownNameError, match="'chair'"):
        assets("chiar")


def test_sheets_are_split_into_pages(tmp_path: Path) -> None:
    models = list(load_catalogue().models.values())[:50]
    assert [p.name for p in write_sheets(models, tmp_path, shapes=True)] == ["sheet_00.png", "sheet_01.png"]
