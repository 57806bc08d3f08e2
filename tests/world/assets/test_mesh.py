"""Meshes of any program's glTF binaries: upright, where their nodes are, and refused where they are not whole."""

import struct
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from worlds.filled import filled
from worlds.glb import Part, box, document, packed, write_glb

from uniteam.errors import DamagedFileError
from uniteam.world.assets.image import MOST_PIXELS
from uniteam.world.assets.mesh import Mesh, load_mesh

TALL = box((0.0, 0.0, 0.0), (1.0, 2.0, 3.0), (0.5, 0.25, 0.0))


def blob_of(part: Any = TALL) -> bytes:
    corners = part.corners
    return np.stack([corners[..., 0], corners[..., 2], -corners[..., 1]], axis=-1).astype("<f4").tobytes()


def read(folder: Path, content: dict[str, Any], blob: bytes = b"") -> Mesh:
    path = folder / "mesh.glb"
    path.write_bytes(packed(content, blob or blob_of()))
    return load_mesh(path)


def extent(mesh: Mesh) -> tuple[list[float], list[float]]:
    return mesh.vertices.min(axis=0).round(5).tolist(), mesh.vertices.max(axis=0).round(5).tolist()


def with_node(**node: Any) -> dict[str, Any]:
    content = document([TALL])
    content["nodes"] = [{"mesh": 0, **node}]
    return content


def test_what_is_y_up_in_the_file_is_z_up_when_read(tmp_path: Path) -> None:
    write_glb(tmp_path / "box.glb", TALL)
    assert extent(load_mesh(tmp_path / "box.glb")) == ([0.0, 0.0, 0.0], [1.0, 2.0, 3.0])


def test_a_mesh_is_where_its_node_and_the_nodes_above_put_it(tmp_path: Path) -> None:
    content = with_node(scale=[2.0, 1.0, 1.0])
    content["nodes"].append({"children": [0], "translation": [0.0, 5.0, 0.0]})
    content["scenes"] = [{"nodes": [1]}]
    assert extent(read(tmp_path, content)) == ([0.0, 0.0, 5.0], [2.0, 2.0, 8.0])


def test_a_node_may_have_a_matrix_by_columns(tmp_path: Path) -> None:
    matrix = np.eye(4)
    matrix[:3, 3] = (1.0, 2.0, 3.0)
    content = with_node(matrix=matrix.T.ravel().tolist())
    assert extent(read(tmp_path, content)) == ([1.0, -3.0, 2.0], [2.0, -1.0, 5.0])


def outward_share(mesh: Mesh) -> float:
    """Return the share of triangles whose winding and whose normals point away from the middle."""
    corners = mesh.vertices[mesh.triangles]
    away = corners.mean(axis=1) - mesh.vertices.mean(axis=0)
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    smooth = mesh.normals[mesh.triangles].sum(axis=1)
    return float(np.mean((np.einsum("ij,ij->i", faces, away) > 0) & (np.einsum("ij,ij->i", smooth, away) > 0)))


def test_normals_that_are_missing_are_those_of_the_faces(tmp_path: Path) -> None:
    mesh = read(tmp_path, document([TALL]))
    assert outward_share(mesh) == 1.0
    assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1.0)


def test_a_mirrored_node_still_faces_outwards(tmp_path: Path) -> None:
    mesh = read(tmp_path, with_node(scale=[-1.0, 1.0, 1.0]))
    assert extent(mesh) == ([-1.0, 0.0, 0.0], [0.0, 2.0, 3.0])
    assert outward_share(mesh) == 1.0


def test_colours_are_srgb_and_what_has_none_is_white(tmp_path: Path) -> None:
    content = document([TALL])
    assert read(tmp_path, content).materials[0].color == pytest.approx((0.735, 0.537, 0.0), abs=1e-3)
    del content["meshes"][0]["primitives"][0]["material"]
    mesh = read(tmp_path, content)
    assert mesh.materials[int(mesh.triangle_materials[0])].color == pytest.approx((1.0, 1.0, 1.0))


def textured(image: bytes) -> tuple[dict[str, Any], bytes]:
    """Return a document whose one material shows an image, and its blob."""
    content, blob = document([TALL]), blob_of()
    content["bufferViews"].append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(image)})
    content["images"] = [{"bufferView": 1, "mimeType": "image/png"}]
    content["textures"] = [{"source": 0}]
    content["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    return content, blob + image


def test_a_png_within_the_file_is_its_texture(tmp_path: Path) -> None:
    image = np.zeros((4, 8, 3), np.uint8)
    image[..., 2] = 200  # OpenCV writes blue first
    texture = read(tmp_path, *textured(cv2.imencode(".png", image)[1].tobytes())).materials[0].texture
    assert texture is not None
    assert texture.shape == (4, 8, 3) and texture[0, 0].tolist() == [200, 0, 0]


@pytest.mark.parametrize("ending", [".png", ".jpg"])
def test_a_picture_that_would_fill_the_memory_is_not_unpacked(tmp_path: Path, ending: str) -> None:
    small = cv2.imencode(ending, np.zeros((4, 8, 3), np.uint8))[1].tobytes()
    huge = struct.pack(">HH", 65_535, 65_500) if ending == ".jpg" else struct.pack(">II", 65_500, 65_500)
    real = struct.pack(">HH", 4, 8) if ending == ".jpg" else struct.pack(">II", 8, 4)
    assert small.count(real) == 1
    with pytest.raises(DamagedFileError, match=f"at most {MOST_PIXELS}"):
        read(tmp_path, *textured(small.replace(real, huge)))


def test_points_and_lines_are_left_out(tmp_path: Path) -> None:
    content = document([TALL, TALL])
    content["meshes"][1]["primitives"][0]["mode"] = 1
    assert len(read(tmp_path, content, 2 * blob_of()).triangles) == 12


def broken(**changes: Any) -> dict[str, Any]:
    """Return a document in which things are changed by their paths, parts joined by two underscores."""
    content = document([TALL])
    for path, value in changes.items():
        *way, key = (int(step) if step.isdigit() else step for step in path.split("__"))
        owner: Any = content
        for step in way:
            owner = owner[step]
        owner[key] = value
    return content


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (broken(accessors__0__count=1000), "reads beyond its view"),
        (broken(accessors__0__count=0), "reads beyond its view, or nothing"),
        (broken(accessors__0__componentType=5131), "unknown type"),
        (broken(accessors__0__sparse={"count": 1}), "sparse"),
        (broken(bufferViews__0__byteLength=10**6), "outside of the file"),
        (broken(bufferViews__0__buffer=1), "outside of the file"),
        (broken(meshes__0__primitives__0__mode=5), "neither triangles nor lines nor points"),
        (broken(meshes__0__primitives__0__material=7), "a material that does not exist"),
        (broken(meshes__0__primitives__0__indices=0), "not given by whole numbers"),
        (broken(nodes__0={"mesh": 0, "children": [0]}), "two parents"),
        (broken(nodes__0={"mesh": 0, "rotation": [1.0, 1.0, 0.0, 0.0]}), "no unit quaternion"),
        (broken(nodes__0={"mesh": 0, "scale": [0.0, 1.0, 1.0]}), "flattens"),
        (broken(nodes__0={"mesh": 0, "scale": [1e4, 1.0, 1.0]}), "more than 1000 m from the origin"),
        (broken(scenes=[{"nodes": []}]), "no triangle"),
        (broken(extensionsRequired=["KHR_draco_mesh_compression"]), "KHR_draco_mesh_compression; export it without"),
        (broken(accessors__0__count="many"), "Expected `int`"),
    ],
)
def test_what_is_wrong_in_a_file_is_said(tmp_path: Path, content: dict[str, Any], reason: str) -> None:
    with pytest.raises(DamagedFileError, match=reason):
        read(tmp_path, content)


@pytest.mark.parametrize("corners", [(0, 1, 36), (0, 1), (0, 1, 65_535)])
def test_a_triangle_needs_three_corners_that_exist(tmp_path: Path, corners: tuple[int, ...]) -> None:
    content, blob = document([TALL]), blob_of()
    content["bufferViews"].append({"buffer": 0, "byteOffset": len(blob), "byteLength": 2 * len(corners)})
    content["accessors"].append({"bufferView": 1, "componentType": 5123, "count": len(corners), "type": "SCALAR"})
    content["meshes"][0]["primitives"][0]["indices"] = 1
    with pytest.raises(DamagedFileError, match="a triangle has a corner that does not exist"):
        read(tmp_path, content, blob + np.array(corners, "<u2").tobytes())


def test_positions_that_are_no_numbers_are_refused(tmp_path: Path) -> None:
    with pytest.raises(DamagedFileError, match="does not hold finite vectors"):
        read(tmp_path, document([TALL]), np.full(108, np.nan, "<f4").tobytes())


def test_a_folder_and_a_file_that_is_none_are_refused(tmp_path: Path) -> None:
    for path in (tmp_path, Path("/dev/zero")):
        with pytest.raises(DamagedFileError, match="there is no such file"):
            load_mesh(path)


def test_a_mesh_shown_many_times_does_not_fill_the_memory(tmp_path: Path) -> None:
    large = Part(np.tile(TALL.corners, (8_000, 1, 1)))
    content = document([large])
    content["nodes"] = [{"mesh": 0}] * 11
    content["scenes"] = [{"nodes": list(range(11))}]
    with pytest.raises(DamagedFileError, match="more than 1000000 triangles"):
        read(tmp_path, content, blob_of(large))
    with pytest.raises(DamagedFileError, match="length <= 10000"):
        read(tmp_path, {**content, "nodes": [{"mesh": 0}] * 10_001})


def test_one_picture_is_unpacked_once_and_many_not_at_all(tmp_path: Path) -> None:
    image = cv2.imencode(".png", np.zeros((4096, 4096, 3), np.uint8), [cv2.IMWRITE_PNG_COMPRESSION, 9])[1].tobytes()
    content, blob = textured(image)
    content["materials"] *= 6
    materials = read(tmp_path, content, blob).materials
    assert all(material.texture is materials[0].texture for material in filled(materials))
    content["bufferViews"] += 5 * content["bufferViews"][-1:]
    content["images"] = [{"bufferView": 1 + k} for k in range(6)]
    content["textures"] = [{"source": k} for k in range(6)]
    content["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": k}}} for k in range(6)]
    with pytest.raises(DamagedFileError, match="textures together would fill the memory"):
        read(tmp_path, content, blob)
