"""The words between world and mind refuse what they cannot mean."""

import numpy as np
import pytest

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Detection, Instruction, Joints, Observation, Segmentation

CAMERA = PinholeCamera.from_horizontal_fov(240, 320, 0.733)


def observation(rgb_shape: tuple[int, ...], depth_shape: tuple[int, ...]) -> Observation:
    rgb, depth = np.zeros(rgb_shape, np.uint8), np.zeros(depth_shape, np.float32)
    return Observation(rgb, depth, CAMERA, np.eye(4), BasePose(0, 0, 0), Joints(0.78, 0.0), False, 0)


def test_a_frame_of_the_cameras_shape_is_accepted() -> None:
    assert observation((320, 240, 3), (320, 240)).truth is None


@pytest.mark.parametrize(
    ("rgb_shape", "depth_shape"),
    [((240, 320, 3), (320, 240)), ((320, 240, 4), (320, 240)), ((320, 240, 3), (160, 120)), ((320, 240), (320, 240))],
)
def test_a_frame_of_another_shape_is_refused_with_what_was_expected(
    rgb_shape: tuple[int, ...], depth_shape: tuple[int, ...]
) -> None:
    with pytest.raises(InvalidInputError, match=r"240x320 camera needs rgb \(320, 240, 3\) and depth \(320, 240\)"):
        observation(rgb_shape, depth_shape)


def test_a_segmentation_of_another_shape_is_refused() -> None:
    with pytest.raises(InvalidInputError, match=r"must be \(H, W\)"):
        Segmentation(np.zeros((3, 2, 1), np.int16), ())


def test_an_instruction_reads_as_a_sentence() -> None:
    assert str(Instruction("toy_car", "chest_of_drawers", "sink")) == "Move toy car from chest of drawers to sink"


def test_joints_add_and_subtract_each_by_itself() -> None:
    start, delta = Joints(0.5, 0.25, head_pan=-1.0), Joints(0.25, 0.125, wrist_roll=0.5)
    assert start + delta == Joints(0.75, 0.375, wrist_roll=0.5, head_pan=-1.0)
    assert (start + delta) - delta == start


def test_a_detections_name_is_that_of_its_best_candidate() -> None:
    wavering = Detection((("cup", 0.5), ("mug", 0.4)))
    assert (wavering.name, wavering.score) == ("cup", 0.5)
