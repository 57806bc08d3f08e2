"""The parts of perception `learned`, on arrays made by hand, and the whole of it on rendered frames."""

from pathlib import Path

import numpy as np
import pytest

from uniteam.errors import DamagedFileError
from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Joints, Observation
from uniteam.mind.perception.learned.asking import calibrated
from uniteam.mind.perception.learned.crops import CROP_SIZE, GREY, greyed, region_crop, square_around
from uniteam.mind.perception.learned.eyes import half_frame
from uniteam.mind.perception.learned.geometry_image import geometry_image
from uniteam.mind.perception.learned.kinds import Kind
from uniteam.mind.perception.learned.networks import Network, read_card
from uniteam.mind.perception.learned.region_shape import region_shape
from uniteam.mind.perception.learned.regions import find_regions
from uniteam.stretch import HEAD_CAMERA_FULL, HEAD_CAMERA_HALF

CELLS = (HEAD_CAMERA_HALF.height // 4, HEAD_CAMERA_HALF.width // 4)
SHAPE = (HEAD_CAMERA_HALF.height, HEAD_CAMERA_HALF.width)
LEVEL = np.array([[0.0, 0.0, 1.0, 0.0], [-1.0, 0.0, 0.0, 0.0], [0.0, -1.0, 0.0, 1.3], [0.0, 0.0, 0.0, 1.0]])
"""A camera 1.3 m above the floor that looks straight ahead."""


def mask_of(rows: slice, columns: slice, shape: tuple[int, int] = SHAPE) -> np.ndarray:
    mask = np.zeros(shape, dtype=bool)
    mask[rows, columns] = True
    return mask


def test_a_crop_is_around_its_region_and_grey_elsewhere() -> None:
    rgb = np.zeros((*SHAPE, 3), dtype=np.uint8)
    rgb[100:120, 50:90] = (200, 100, 50)
    mask = mask_of(slice(100, 120), slice(50, 90))
    crop = region_crop(rgb, mask)
    assert crop.shape == (CROP_SIZE, CROP_SIZE, 3)
    assert tuple(crop[CROP_SIZE // 2, CROP_SIZE // 2]) == (200, 100, 50)
    assert crop[2, 2, 0] == pytest.approx(0.6 * GREY, abs=1.0)
    square = square_around(mask)
    assert (square.x, square.y, square.side) == (69.5, 109.5, 50.0)


def test_a_crop_of_a_finer_frame_shows_the_same_in_more_detail() -> None:
    fine = np.zeros((SHAPE[0] * 2, SHAPE[1] * 2, 3), dtype=np.uint8)
    fine[200:240, 100:180:2] = 255
    mask = mask_of(slice(100, 120), slice(50, 90))
    coarse = np.zeros((*SHAPE, 3), dtype=np.uint8)
    coarse[100:120, 50:90] = 128
    assert region_crop(fine, mask)[56, 20:90].std() > 40.0
    assert region_crop(coarse, mask)[56, 20:90].std() < 1.0


def test_what_leaves_the_frame_is_grey() -> None:
    rgb = np.full((*SHAPE, 3), 255, dtype=np.uint8)
    crop = region_crop(rgb, mask_of(slice(0, 40), slice(0, 8)))
    assert tuple(crop[56, 1]) == (GREY, GREY, GREY)
    assert greyed(crop, np.full((CROP_SIZE, CROP_SIZE), 255, np.uint8)).tolist() == crop.tolist()


def test_the_shape_of_a_region_is_in_metres() -> None:
    depth = np.full(SHAPE, 2.0, dtype=np.float32)
    mask = mask_of(slice(160, 200), slice(100, 140))
    shape = region_shape(mask, depth, HEAD_CAMERA_HALF, LEVEL)
    side = 40 / HEAD_CAMERA_HALF.fx * 2.0
    assert shape[0] == 1.0
    assert np.exp(shape[1:3] - 1.0) == pytest.approx([side, side], rel=0.1)
    assert np.exp(shape[3] - 1.0) == pytest.approx(2.0, rel=1e-3)
    assert shape[6] == pytest.approx(1.3, abs=0.02)
    assert shape[5] == pytest.approx(1.3 - side, abs=0.03)
    assert shape[7:].tolist() == [0.0, 0.0]
    blind = region_shape(mask_of(slice(0, 9), slice(5, 9)), np.zeros_like(depth), HEAD_CAMERA_HALF, LEVEL)
    assert blind[:4].tolist() == [0.0] * 4 and blind[8] == 1.0


def test_the_geometry_image_knows_the_floor() -> None:
    v = (np.arange(SHAPE[0]) - HEAD_CAMERA_HALF.cy) / HEAD_CAMERA_HALF.fy
    floor = np.where(v > 0.13, 1.3 / np.maximum(v, 0.13), 0.0).astype(np.float32)
    image = geometry_image(np.repeat(floor[:, None], SHAPE[1], axis=1), HEAD_CAMERA_HALF, LEVEL)
    assert image.shape == (3, *CELLS)
    assert image[1, :30].max() == 0.0 and image[1, -5:].min() == 1.0
    assert np.abs(image[2]).max() < 1e-3


def logits_of(*kinds: tuple[Kind, slice, slice]) -> np.ndarray:
    """Return logits in which rectangles of cells are of a kind, all else is stuff, and nothing ends."""
    logits = np.full((len(Kind) + 1 + 21, *CELLS), -6.0, dtype=np.float32)
    logits[Kind.STUFF] = 0.0
    for kind, rows, columns in kinds:
        logits[: len(Kind), rows, columns] = -6.0
        logits[kind, rows, columns] = 6.0
    return logits


def test_two_things_that_depth_parts_are_two_regions() -> None:
    logits = logits_of((Kind.OBJECT, slice(20, 30), slice(10, 30)))
    depth = np.full(SHAPE, 2.0, dtype=np.float32)
    assert len(find_regions(logits, depth)) == 1
    depth[:, 80:] = 1.5
    left, right = sorted(find_regions(logits, depth), key=lambda region: int(region.mask.argmax()) % SHAPE[1])
    assert not left.mask[:, 83:].any() and not right.mask[:, :78].any()
    assert np.count_nonzero(left.mask) > 1200 and left.kind is Kind.OBJECT
    assert left.certainty > 0.99


def test_two_things_that_touch_are_parted_where_one_ends() -> None:
    logits = logits_of((Kind.OBJECT, slice(20, 30), slice(10, 30)))
    logits[len(Kind), 20:30, 19:21] = 6.0
    assert len(find_regions(logits, np.full(SHAPE, 2.0, dtype=np.float32))) == 2


def test_specks_and_far_things_are_no_regions() -> None:
    logits = logits_of((Kind.OBJECT, slice(20, 21), slice(10, 11)), (Kind.RECEPTACLE, slice(40, 60), slice(10, 50)))
    depth = np.full(SHAPE, 2.0, dtype=np.float32)
    (table,) = find_regions(logits, depth)
    assert table.kind is Kind.RECEPTACLE and table.receptacle_scores.shape == (21,)
    assert find_regions(logits, depth * 5.0) == []


def test_a_full_frame_is_segmented_at_half_size() -> None:
    rgb = np.zeros((HEAD_CAMERA_FULL.height, HEAD_CAMERA_FULL.width, 3), dtype=np.uint8)
    depth = np.ones((HEAD_CAMERA_FULL.height, HEAD_CAMERA_FULL.width), dtype=np.float32)
    here = BasePose(0.0, 0.0, 0.0)
    frame = half_frame(Observation(rgb, depth, HEAD_CAMERA_FULL, LEVEL, here, Joints(0.0, 0.0), False, 0))
    assert frame.camera == HEAD_CAMERA_HALF and frame.fine_rgb is rgb
    odd = PinholeCamera.from_horizontal_fov(100, 50, 1.0)
    small = Observation(rgb[:50, :100], depth[:50, :100], odd, LEVEL, here, Joints(0.0, 0.0), False, 0)
    assert half_frame(small).depth.shape == SHAPE


def test_a_score_is_worth_what_was_measured() -> None:
    table = {"object": ([0.0, 0.5, 1.0], [0.0, 0.2, 0.8])}
    assert calibrated(0.25, "object", table) == pytest.approx(0.1)
    assert calibrated(0.75, "object", table) == pytest.approx(0.5)
    assert calibrated(0.75, "receptacle", table) == 0.75


def test_a_damaged_network_or_card_is_named(tmp_path: Path) -> None:
    (tmp_path / "card.json").write_text('{"names": 3}')
    with pytest.raises(DamagedFileError, match=r"card\.json"):
        read_card(tmp_path)
    (tmp_path / "net.onnx").write_bytes(b"nothing")
    with pytest.raises(DamagedFileError, match=r"net\.onnx"):
        Network(tmp_path / "net.onnx")
