"""A home as the camera sees it: rooms, walls, doors, windows, instances that move and hide."""

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from worlds.camera_scenes import CAMERA, FORWARD, NOWHERE, RED, looking, quad, two_rooms
from worlds.filled import filled

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.geometry import BasePose, PinholeCamera, invert_transform, pose_matrix, transform_points, yaw_quaternion
from uniteam.interface import Joints
from uniteam.stretch import head_camera_to_base
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.assets.mesh import Material
from uniteam.world.homes.home import Instance, Wall
from uniteam.world.rendering.camera import render, render_geometry
from uniteam.world.rendering.kernels.culling import coarsen, is_hidden
from uniteam.world.rendering.meshes.robot_mesh import part_poses, robot_parts
from uniteam.world.rendering.meshes.stage_mesh import stage_parts
from uniteam.world.rendering.scene import Scene

WIDE = PinholeCamera.from_horizontal_fov(160, 120, np.radians(75.0))


def _standing(category: str, x: float, y: float, yaw: float = 0.0) -> Instance:
    model = load_catalogue().of_category(category)[0]
    movable = model.role == "object"
    return Instance(f"{category}_{x:g}", model.id, category, movable, (x, y, 0.0), yaw_quaternion(yaw), "west")


@pytest.fixture(scope="module")
def furnished() -> Scene:
    pieces = [_standing("table", 2.0, 3.0), _standing("couch", 1.2, 0.9, np.pi), _standing("bed", 6.4, 2.6)]
    return Scene(two_rooms(*pieces, _standing("chair", 3.2, 2.2, 0.7), _standing("plant", 7.4, 0.6)))


def test_every_instance_is_labelled_with_its_index(furnished: Scene) -> None:
    for index, instance in filled(enumerate(furnished.home.instances)):
        x, y, _ = instance.position
        eye = (2.0, 1.9, 2.2) if x < 4.0 else (5.0, 0.5, 2.2)
        frame = render(furnished, WIDE, looking(eye, (x, y, 0.3)))
        size = load_catalogue()[instance.model].size
        assert index in frame.instances
        shown = WIDE.unproject(frame.depth)[frame.instances == index]
        points = transform_points(looking(eye, (x, y, 0.3)), shown)
        local = transform_points(invert_transform(instance.model_to_world()), points)
        assert (np.abs(local[:, :2]) <= np.array(size[:2]) / 2.0 + 0.01).all()
        assert (local[:, 2] <= size[2] + 0.01).all()


def test_depth_and_instances_without_colours_are_the_same_to_the_bit(furnished: Scene) -> None:
    for eye, target in (
        ((0.3, 0.3, 1.3), (8.0, 3.0, 0.5)),
        ((5.0, 0.5, 2.2), (6.4, 2.6, 0.3)),
        ((4.0, 9.0, 1.0), (4.0, 30.0, 1.0)),
    ):
        pose = looking(eye, target)
        frame, geometry = render(furnished, WIDE, pose), render_geometry(furnished, WIDE, pose)
        np.testing.assert_array_equal(geometry.depth, frame.depth)
        np.testing.assert_array_equal(geometry.instances, frame.instances)


def test_the_order_in_which_parts_are_culled_changes_no_pixel(furnished: Scene) -> None:
    for eye, target in (
        ((0.3, 0.3, 1.3), (8.0, 3.0, 0.5)),
        ((7.7, 3.7, 1.3), (2.0, 1.0, 0.4)),
        ((3.6, 2.0, 1.3), (8.0, 2.0, 0.9)),
    ):
        pose = looking(eye, target)
        culled = render(furnished, WIDE, pose)
        stage = furnished.buffers().part_is_stage
        kept = stage.copy()
        stage[:] = True  # a part of the stage is drawn whether or not it is hidden
        whole = render(furnished, WIDE, pose)
        stage[:] = kept
        assert np.array_equal(culled.depth, whole.depth)
        assert np.mean(culled.instances == whole.instances) > 0.9999


def test_the_door_shows_the_other_room_and_the_wall_does_not(furnished: Scene) -> None:
    through = render(furnished, CAMERA, looking((2.0, 1.95, 1.3), (8.0, 1.95, 1.3)))
    assert through.depth[24, 32] == pytest.approx(6.0, abs=1e-3)  # the pane of the far window
    beside = render(furnished, CAMERA, looking((2.0, 3.3, 1.3), (8.0, 3.3, 1.3)))
    assert beside.depth[24, 32] == pytest.approx(1.95, abs=1e-3)


def test_a_wall_is_as_thick_as_it_is(furnished: Scene) -> None:
    west = render(furnished, CAMERA, looking((3.0, 3.3, 1.3), (8.0, 3.3, 1.3))).depth[24, 32]
    east = render(furnished, CAMERA, looking((5.0, 3.3, 1.3), (0.0, 3.3, 1.3))).depth[24, 32]
    assert 2.0 - west - east == pytest.approx(0.1, abs=1e-4)


def test_a_wall_has_the_tint_of_the_room_it_looks_into(furnished: Scene) -> None:
    west = render(furnished, CAMERA, looking((2.0, 3.3, 1.3), (4.0, 3.3, 1.3))).rgb[14:34, 22:42].mean(axis=(0, 1))
    east = render(furnished, CAMERA, looking((6.0, 3.3, 1.3), (4.0, 3.3, 1.3))).rgb[14:34, 22:42].mean(axis=(0, 1))
    assert west[0] > west[2] * 1.2
    assert east[2] > east[0] * 1.2


def test_a_window_shows_a_bright_sky_in_the_middle_of_the_wall(furnished: Scene) -> None:
    frame = render(furnished, CAMERA, looking((6.5, 1.6, 1.6), (8.0, 1.6, 1.6)))
    assert frame.depth[24, 32] == pytest.approx(1.5, abs=1e-3)
    red, _, blue = frame.rgb[24, 32].astype(int)
    assert blue > 200 and blue >= red


@pytest.mark.parametrize("eye", [(2.0, 2.0), (6.0, 1.0), (4.0, 1.9)])
def test_no_ray_leaves_a_closed_home(furnished: Scene, eye: tuple[float, float]) -> None:
    for turn in np.arange(0.0, 2.0 * np.pi, np.pi / 4.0):
        for tilt in (-0.7, 0.0, 0.7):
            target = (eye[0] + np.cos(turn), eye[1] + np.sin(turn), 1.3 + tilt)
            assert render(furnished, WIDE, looking((*eye, 1.3), target)).depth.all()


def test_without_its_ceiling_a_home_can_be_seen_from_above(furnished: Scene) -> None:
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, 3] = (4.0, 2.0, 9.9)
    assert furnished.is_shown("ceiling")
    covered = render(furnished, WIDE, pose)
    furnished.show("ceiling", False)
    open_ = render(furnished, WIDE, pose)
    furnished.show("ceiling", True)
    assert not (covered.instances >= 0).any()
    assert set(np.unique(open_.instances)) >= {0, 1, 2, 3, 4}
    assert np.array_equal(render(furnished, WIDE, pose).rgb, covered.rgb)


def test_a_part_is_seen_where_it_was_moved_and_not_where_it_was() -> None:
    scene = Scene(NOWHERE, {"card": quad(2.0, 0.5, Material(RED))})
    scene.move("card", pose_matrix(np.array([1.0, 0.0, 0.0]), np.array([1.0, 0.0, 0.0, 0.0])))
    assert render(scene, CAMERA, FORWARD).depth[24, 32] == pytest.approx(3.0, abs=1e-5)
    scene.move("card", pose_matrix(np.array([0.0, 5.0, 0.0]), np.array([1.0, 0.0, 0.0, 0.0])))
    assert not render(scene, CAMERA, FORWARD).depth.any()
    assert scene.pose("card")[1, 3] == 5.0


def test_a_part_that_moves_while_hidden_is_shown_where_it_went() -> None:
    scene = Scene(NOWHERE, {"card": quad(2.0, 0.5, Material(RED))})
    scene.show("card", False)
    scene.move("card", pose_matrix(np.array([1.5, 0.0, 0.0]), np.array([1.0, 0.0, 0.0, 0.0])))
    assert not render(scene, CAMERA, FORWARD).depth.any()
    scene.show("card", True)
    assert render(scene, CAMERA, FORWARD).depth[24, 32] == pytest.approx(3.5, abs=1e-5)


def test_a_part_that_moves_out_of_view_is_seen_where_it_went_once_the_camera_turns_there() -> None:
    scene = Scene(NOWHERE, {"card": quad(2.0, 0.5, Material(RED))})
    render(scene, CAMERA, FORWARD)
    scene.move("card", pose_matrix(np.array([-6.0, 0.0, 0.0]), np.array([1.0, 0.0, 0.0, 0.0])))
    assert not render(scene, CAMERA, FORWARD).depth.any()
    behind = FORWARD @ np.diag([-1.0, 1.0, -1.0, 1.0])
    assert render(scene, CAMERA, behind).depth[24, 32] == pytest.approx(4.0, abs=1e-5)


def test_a_part_between_whose_pieces_the_camera_looks_leaves_nothing_where_it_was() -> None:
    """Its box is in the picture and none of its triangles; where it stood before, one of its pieces was."""
    near = quad(2.0, 0.5, Material(RED))
    apart = np.array([[0.0, 8.0, 0.0], [0.0, -8.0, 0.0]], np.float32)
    pieces = replace(
        near,
        vertices=np.concatenate([near.vertices + offset for offset in apart]),
        normals=np.concatenate([near.normals] * 2),
        uvs=np.concatenate([near.uvs] * 2),
        triangles=np.concatenate([near.triangles, near.triangles + np.int32(len(near.vertices))]),
        triangle_materials=np.concatenate([near.triangle_materials] * 2),
    )
    scene = Scene(NOWHERE, {"pieces": pieces})
    scene.move("pieces", pose_matrix(np.array([0.0, 8.0, 0.0]), np.array([1.0, 0.0, 0.0, 0.0])))
    assert render(scene, CAMERA, FORWARD).depth.any()
    scene.move("pieces", np.eye(4))
    assert not render(scene, CAMERA, FORWARD).depth.any()


def test_an_object_carried_into_another_room_takes_its_light() -> None:
    home = two_rooms(_standing("table", 2.0, 2.0))
    scene = Scene(home)
    name = home.instances[0].name
    tints = scene.buffers().part_tints[-1].copy()
    scene.move(name, pose_matrix(np.array([6.0, 2.0, 0.0]), np.array([1.0, 0.0, 0.0, 0.0])))
    assert not np.allclose(scene.buffers().part_tints[-1], tints)


def test_an_unknown_part_gets_the_nearest_name(furnished: Scene) -> None:
    with pytest.raises(UnknownNameError, match="did you mean 'ceiling'"):
        furnished.show("celing", False)
    with pytest.raises(UnknownNameError):
        furnished.move("nothing", np.eye(4))
    with pytest.raises(InvalidInputError):
        furnished.move("table_2", np.eye(3))


def test_a_part_is_hidden_only_behind_what_covers_its_whole_rectangle() -> None:
    inverse_depth = np.full((32, 32), 1.0, dtype=np.float32)
    coarse = np.zeros((4, 4), dtype=np.float32)
    coarsen(inverse_depth, coarse)
    behind = np.array([4.0, 20.0, 4.0, 20.0, 0.5], dtype=np.float32)
    assert is_hidden(behind, coarse)
    assert not is_hidden(np.array([4.0, 20.0, 4.0, 20.0, 1.5], dtype=np.float32), coarse)
    inverse_depth[18, 18] = 0.4
    coarsen(inverse_depth, coarse)
    assert not is_hidden(behind, coarse)


def test_the_floor_is_darker_at_the_foot_of_a_washing_machine() -> None:
    machine = _standing("washer_dryer", 2.0, 2.0)
    pose = looking((0.4, 2.0, 1.3), (2.0, 2.0, 0.0))
    bare, shaded = (render(Scene(home), WIDE, pose) for home in (two_rooms(), two_rooms(machine)))
    points = transform_points(pose, WIDE.unproject(shaded.depth))
    floor = (points[..., 2] < 0.005) & (shaded.instances < 0)
    size = load_catalogue()[machine.model].size
    gap = np.maximum(*(np.abs(points[..., k] - 2.0) - size[k] / 2.0 for k in (0, 1)))
    ratio = shaded.rgb.mean(axis=-1) / bare.rgb.mean(axis=-1)
    near, far = floor & (gap < 0.04), floor & (gap > 0.5)
    assert near.sum() > 20 and far.sum() > 20
    assert ratio[near].mean() < 0.93
    assert ratio[far].mean() == pytest.approx(1.0, abs=0.02)


def test_walls_in_one_line_meet_and_do_not_overlap() -> None:
    home = two_rooms()
    cut = [Wall((0.0, 0.0), (4.0, 0.0), 0.1), Wall((4.0, 0.0), (8.0, 0.0), 0.1), *home.stage.walls[1:]]
    parts = stage_parts(replace(home.stage, walls=tuple(cut)), home.library)
    first, second = (
        np.concatenate([part.mesh.vertices[:, 0] for part in parts if part.name == name])
        for name in ("wall_0", "wall_1")
    )
    assert first.max() == pytest.approx(second.min(), abs=1e-6)
    assert first.min() == pytest.approx(-0.05, abs=0.002)


def test_a_room_without_a_floor_texture_leaves_floor_ceiling_and_lamp_to_the_mesh() -> None:
    home = two_rooms()
    west, east = home.stage.rooms
    bare = replace(home.stage, rooms=(replace(west, floor_texture=None, wall_texture=None), east))
    both, one = (
        [part.room for part in stage_parts(stage, home.library) if part.name in ("floor", "ceiling")]
        for stage in (home.stage, bare)
    )
    assert (both, one) == ([0, 1, 0, 0, 1, 1], [1, 1, 1])


def test_a_part_whose_box_alone_is_in_the_picture_is_not_drawn_where_it_was_before() -> None:
    usual, always_moved = Scene(two_rooms(), robot_parts()), Scene(two_rooms(), robot_parts())
    base, near = BasePose(2.0, 2.0, 0.0), []
    for lift, arm, pitch, tilt in product((0.3, 0.9), (0.0, 0.5), (-1.5, 0.0), (-0.2, -0.6, -1.0)):
        joints = Joints(lift, arm, wrist_pitch=pitch, head_pan=-1.0, head_tilt=tilt)
        for name, pose in part_poses(base, joints).items():
            usual.move(name, pose)
            always_moved.move(name, pose)
        always_moved.buffers()
        eye = base.matrix() @ head_camera_to_base(joints)
        frame = render(usual, WIDE, eye)
        np.testing.assert_array_equal(frame.depth, render(always_moved, WIDE, eye).depth)
        near.append(np.count_nonzero(frame.depth < 1.0))
    assert max(near) > 500  # the arm is in the picture
