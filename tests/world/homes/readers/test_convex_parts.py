"""Colliders as hulls: a part each, corners kept, against SciPy's hulls."""

from pathlib import Path

import numpy as np
from scipy.spatial import ConvexHull
from worlds.glb import box, write_glb

from uniteam.world.assets.mesh import load_pieces
from uniteam.world.assets.model import Hull
from uniteam.world.homes.readers.convex_parts import MOST_CORNERS, convex_hull, convex_parts


def hulls_of(path: Path) -> list[np.ndarray]:
    """Return the corners of the hulls of a file."""
    shapes = convex_parts(load_pieces(path))
    return [np.array(shape.vertices) for shape in shapes if isinstance(shape, Hull)]


def test_two_boxes_that_touch_are_two_hulls(tmp_path: Path) -> None:
    low, high = box((0.0, 0.0, 0.0), (1.0, 1.0, 0.5)), box((0.0, 0.0, 0.5), (0.2, 1.0, 2.0))
    write_glb(tmp_path / "l.glb", low, high)
    volumes = sorted(ConvexHull(points).volume for points in hulls_of(tmp_path / "l.glb"))
    assert np.allclose(volumes, [0.3, 0.5])


def test_boxes_of_one_mesh_that_lie_apart_are_hulls_of_their_own(tmp_path: Path) -> None:
    both = box((0.0, 0.0, 0.0), (1.0, 1.0, 1.0)), box((2.0, 0.0, 0.0), (3.0, 1.0, 1.0))
    together = type(both[0])(np.concatenate([part.corners for part in both]))
    write_glb(tmp_path / "two.glb", together)
    assert [len(points) for points in hulls_of(tmp_path / "two.glb")] == [8, 8]


def test_a_ball_keeps_its_size_in_few_corners() -> None:
    points = np.random.default_rng(0).normal(size=(2000, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    hull = convex_hull(points)
    assert hull is not None and len(hull.vertices) <= MOST_CORNERS
    assert ConvexHull(np.array(hull.vertices)).volume > 0.6 * 4.0 / 3.0 * np.pi
    assert np.allclose(np.ptp(np.array(hull.vertices), axis=0), np.ptp(points, axis=0))


def test_a_flat_part_is_given_a_little_thickness_and_a_line_is_nothing() -> None:
    square = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 1.0), (1.0, 1.0, 1.0), (0.0, 1.0, 0.0)])
    hull = convex_hull(square)
    assert hull is not None and 0.0 < ConvexHull(np.array(hull.vertices)).volume < 0.01
    assert convex_hull(square[:2]) is None
