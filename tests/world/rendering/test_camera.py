"""The camera on scenes whose pictures can be computed by hand."""

import numpy as np
import pytest
from worlds.camera_scenes import BLUE, CAMERA, FORWARD, GREEN, NOWHERE, RED, quad, see, sphere
from worlds.filled import filled

from uniteam.errors import InvalidInputError
from uniteam.geometry import PinholeCamera
from uniteam.stretch import DEPTH_RANGE
from uniteam.world.assets.mesh import Material, Mesh
from uniteam.world.rendering.camera import render
from uniteam.world.rendering.scene import Scene


def test_a_plane_across_the_axis_is_equally_far_everywhere() -> None:
    depth = see({"plane": quad(3.0, 5.0, Material(RED))}).depth
    assert depth == pytest.approx(np.full((48, 64), 3.0), abs=1e-5)


def test_a_slanted_plane_is_as_far_as_its_equation_says() -> None:
    depth = see({"plane": quad(3.0, 6.0, Material(RED), tilt=0.5)}).depth
    # x = 3 - y / 2 and y = -x * (u - cx) / fx
    columns = (np.arange(64) - CAMERA.cx) / CAMERA.fx
    expected = np.broadcast_to(3.0 / (1.0 - 0.5 * columns), (48, 64))
    assert depth == pytest.approx(expected, rel=1e-5)


def test_a_sphere_is_as_far_as_its_equation_says_and_as_wide() -> None:
    camera = PinholeCamera.from_horizontal_fov(240, 180, np.radians(60.0))
    depth = see({"ball": sphere((2.0, 0.0, 0.0), 0.5, Material(RED))}, camera).depth
    rays = camera.unproject(np.ones((180, 240), dtype=np.float32)).astype(np.float64)
    along, squared = rays[..., 2] * 2.0, (rays**2).sum(axis=-1)
    root = along**2 - squared * (4.0 - 0.25)
    inside, outside = root > 0.02, root < -0.02
    expected = (along - np.sqrt(np.maximum(root, 0.0))) / squared
    assert depth[inside] == pytest.approx(expected[inside], abs=1e-3)
    assert not depth[outside].any()
    assert inside.sum() > 5000


@pytest.mark.parametrize("names", [("near", "middle", "far"), ("far", "middle", "near"), ("middle", "far", "near")])
def test_the_nearer_part_is_seen_whatever_the_order(names: tuple[str, ...]) -> None:
    parts = {
        "near": quad(1.0, 0.2, Material(RED)),
        "middle": quad(2.0, 0.8, Material(GREEN)),
        "far": quad(3.0, 9.0, Material(BLUE)),
    }
    frame = see({name: parts[name] for name in names})
    assert frame.depth[24, 32] == pytest.approx(1.0, abs=1e-5)
    assert frame.depth[24, 45] == pytest.approx(2.0, abs=1e-5)
    assert frame.depth[2, 2] == pytest.approx(3.0, abs=1e-5)
    assert [int(frame.rgb[24, x].argmax()) for x in (32, 45)] == [0, 1]


def test_parts_that_cross_are_cut_where_they_cross() -> None:
    tilted = {"one": quad(3.0, 9.0, Material(RED), tilt=0.5), "other": quad(3.0, 9.0, Material(BLUE), tilt=-0.5)}
    brightest = see(tilted).rgb.argmax(axis=-1)
    # The image's left is the world's +y, where "one" is nearer: x = 3 - y / 2.
    assert (brightest[:, :31] == 0).all()
    assert (brightest[:, 33:] == 2).all()


def test_nothing_nearer_than_the_near_plane_is_seen() -> None:
    frame = see({"lid": quad(0.04, 1.0, Material(RED)), "wall": quad(2.0, 5.0, Material(BLUE))})
    assert frame.depth == pytest.approx(np.full((48, 64), 2.0), abs=1e-5)
    assert see({"lid": quad(0.06, 1.0, Material(RED))}).depth == pytest.approx(np.full((48, 64), 0.06), abs=1e-5)


def test_a_floor_that_passes_under_the_camera_is_cut_and_not_lost() -> None:
    floor = Mesh(
        vertices=np.array([[-40, -40, -1], [40, -40, -1], [40, 40, -1], [-40, 40, -1]], dtype=np.float32),
        normals=np.tile(np.array([0, 0, 1], dtype=np.float32), (4, 1)),
        uvs=np.zeros((4, 2), dtype=np.float32),
        triangles=np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32),
        triangle_materials=np.zeros(2, dtype=np.int32),
        materials=(Material(GREEN),),
    )
    depth = see({"floor": floor}).depth
    below = (np.arange(48) - CAMERA.cy) / CAMERA.fy
    expected = np.where(below > 0.0, 1.0 / np.maximum(below, 1e-9), 0.0)
    expected[expected > DEPTH_RANGE] = 0.0
    assert depth == pytest.approx(np.broadcast_to(expected[:, None], (48, 64)), rel=1e-4)


def test_beyond_ten_metres_there_is_colour_but_no_depth() -> None:
    frame = see({"wall": quad(10.1, 20.0, Material(RED))})
    assert not frame.depth.any()
    assert (frame.rgb.argmax(axis=-1) == 0).all()
    assert see({"wall": quad(9.9, 20.0, Material(RED))}).depth.all()


def test_a_closed_surface_has_no_holes() -> None:
    camera = PinholeCamera.from_horizontal_fov(320, 240, np.radians(40.0))
    parts = {"ball": sphere((2.0, 0.03, 0.02), 0.6, Material(RED)), "wall": quad(4.0, 9.0, Material(BLUE))}
    seen = see(parts, camera).depth < 3.0
    rows = np.flatnonzero(seen.any(axis=1))
    for row in filled(rows):
        columns = np.flatnonzero(seen[row])
        assert len(columns) == columns[-1] - columns[0] + 1


def test_the_same_scene_gives_the_same_bits() -> None:
    parts = {"ball": sphere((2.0, 0.0, 0.0), 0.5, Material(RED)), "wall": quad(3.0, 5.0, Material(BLUE), tilt=0.3)}
    scene = Scene(NOWHERE, parts)
    first = render(scene, CAMERA, FORWARD)
    for other in (render(scene, CAMERA, FORWARD), see(parts)):
        assert np.array_equal(first.rgb, other.rgb)
        assert np.array_equal(first.depth, other.depth)
        assert np.array_equal(first.instances, other.instances)


def test_a_frame_stays_as_it_is_when_the_next_is_taken() -> None:
    scene = Scene(NOWHERE, {"wall": quad(3.0, 5.0, Material(BLUE))})
    first = render(scene, CAMERA, FORWARD)
    scene.show("wall", False)
    assert not render(scene, CAMERA, FORWARD).depth.any()
    assert first.depth.all()


def test_a_pose_of_the_wrong_shape_is_refused() -> None:
    with pytest.raises(InvalidInputError, match="camera"):
        render(Scene(NOWHERE, {"wall": quad(3.0, 5.0, Material(BLUE))}), CAMERA, np.eye(3))
