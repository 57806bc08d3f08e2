"""Textures are the right way up, right in perspective and calm far away; light falls from where the lamp is."""

import numpy as np
import pytest
from worlds.camera_scenes import CAMERA, quad, see, sphere

from uniteam.geometry import PinholeCamera
from uniteam.world.assets.mesh import Material
from uniteam.world.rendering.kernels.texture_atlas import build_mip_chain

WHITE = (1.0, 1.0, 1.0)


def test_a_texture_is_the_right_way_up() -> None:
    corners = np.array([[[255, 0, 0], [0, 255, 0]], [[0, 0, 255], [255, 255, 255]]], dtype=np.uint8)
    texture = np.kron(corners, np.ones((32, 32, 1), dtype=np.uint8))
    rgb = see({"picture": quad(2.0, 1.0, Material(WHITE, texture))}).rgb.astype(int)
    upper_left, upper_right, lower_left, lower_right = rgb[12, 20], rgb[12, 44], rgb[36, 20], rgb[36, 44]
    assert upper_left.argmax() == 0 and upper_left[1] < 20
    assert upper_right.argmax() == 1 and upper_right[0] < 20
    assert lower_left.argmax() == 2 and lower_left[0] < 20
    assert lower_right.min() > 100


def test_a_texture_is_right_in_perspective() -> None:
    ramp = np.broadcast_to(np.arange(256, dtype=np.uint8)[None, :, None], (256, 256, 3))
    rgb = see({"picture": quad(3.0, 1.2, Material(WHITE, np.ascontiguousarray(ramp)), tilt=1.5)}).rgb[24, :, 0]
    # x = 3 - 1.5 y and y = -x * (u - cx) / fx; the ramp runs from y = 1.2 to y = -1.2
    columns = (np.arange(64) - CAMERA.cx) / CAMERA.fx
    x = 3.0 / (1.0 - 1.5 * columns)
    across = (1.2 + x * columns) / 2.4
    inside = (across > 0.05) & (across < 0.95) & (x > 0.0)
    expected = 256.0 * across - 0.5
    light = rgb[inside] / expected[inside]
    assert inside.sum() > 15
    assert light == pytest.approx(np.full(inside.sum(), np.median(light)), abs=0.06)


def test_a_fine_pattern_is_calm_far_away() -> None:
    checks = (np.indices((256, 256)).sum(axis=0) % 2 * 255).astype(np.uint8)
    texture = np.ascontiguousarray(np.broadcast_to(checks[..., None], (256, 256, 3)))
    inner = see({"wall": quad(6.0, 2.0, Material(WHITE, texture))}).rgb[16:32, 22:42]
    assert inner.std() < 3.0
    assert 80 < inner.mean() < 180


def test_a_texture_repeats_beyond_its_edges() -> None:
    halves = np.zeros((8, 8, 3), dtype=np.uint8)
    halves[:, 4:] = 255
    mesh = quad(2.0, 1.0, Material(WHITE, halves))
    mesh.uvs[:, 0] = mesh.uvs[:, 0] * 2.0 - 5.0
    row = see({"wall": mesh}).rgb[24, :, 0]
    bright = (row[6:58] > 80).astype(int)
    assert np.abs(np.diff(bright)).sum() == 3


def test_a_material_colours_its_texture() -> None:
    grey = np.full((4, 4, 3), 128, dtype=np.uint8)
    frame = see({"wall": quad(2.0, 5.0, Material((1.0, 0.5, 0.0), grey))})
    red, green, blue = frame.rgb[24, 32].astype(float)
    assert green == pytest.approx(red / 2.0, abs=1.5)
    assert blue == 0.0


def test_the_upper_side_of_a_ball_is_brighter_than_its_lower_side() -> None:
    camera = PinholeCamera.from_horizontal_fov(96, 96, np.radians(40.0))
    rgb = see({"ball": sphere((2.0, 0.0, 0.0), 0.6, Material(WHITE))}, camera).rgb.mean(axis=-1)
    assert rgb[15, 48] > rgb[80, 48] + 20


def test_a_surface_wound_the_other_way_looks_the_same() -> None:
    mesh = quad(2.0, 5.0, Material((0.8, 0.6, 0.4)))
    turned = type(mesh)(
        mesh.vertices, mesh.normals, mesh.uvs, np.ascontiguousarray(mesh.triangles[:, ::-1]),
        mesh.triangle_materials, mesh.materials,
    )  # fmt: skip
    assert np.array_equal(see({"a": mesh}).rgb, see({"a": turned}).rgb)


def test_every_level_of_a_mip_chain_keeps_the_mean() -> None:
    image = np.random.default_rng(0).integers(0, 256, (64, 32, 3), dtype=np.uint8)
    chain = build_mip_chain(image)
    assert (chain.log2_width, chain.log2_height, chain.last_level) == (5, 6, 6)
    last = chain.texels[chain.starts[6]]
    means = [last & 255, (last >> 8) & 255, (last >> 16) & 255]
    assert np.array(means, dtype=float) == pytest.approx(image.reshape(-1, 3).mean(axis=0), abs=4.0)
    assert len(chain.texels) == sum(
        (w + 1) * (h + 1) for w, h in zip((32, 16, 8, 4, 2, 1, 1), (64, 32, 16, 8, 4, 2, 1), strict=True)
    )


def test_a_texture_of_any_size_becomes_a_power_of_two() -> None:
    chain = build_mip_chain(np.full((300, 500, 3), 77, dtype=np.uint8))
    assert (1 << chain.log2_width, 1 << chain.log2_height) == (512, 256)
    assert set(chain.texels.tolist()) == {77 | 77 << 8 | 77 << 16}
