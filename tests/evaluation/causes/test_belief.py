"""What the agent believed of what it saw, from its own segmentation and the true one."""

import numpy as np
import pytest

from uniteam.evaluation.causes.reading.belief import NOT_A_THING, Look, spread
from uniteam.interface import Detection, Segmentation

NAMES = ("cup_1", "vase_1", "table_1")
CUP, VASE = Detection((("cup", 0.6), ("vase", 0.4))), Detection((("vase", 0.9),))


def look(believed: list[list[int]], true: list[list[int]], *detections: Detection) -> Look:
    return Look(Segmentation(np.array(believed, np.int16), detections), np.array(true, np.int16))


def test_an_instance_is_what_most_of_its_pixels_were_believed_to_be() -> None:
    seen = look([[0, 0, 0, -1], [-1, 1, 1, 1]], [[0, 0, 0, 0], [1, 1, 1, 1]], CUP, VASE)
    assert (seen.name_of(0), seen.name_of(1), seen.name_of(2)) == ("cup", "vase", "")


@pytest.mark.parametrize(("pixels", "name"), [(2, ""), (3, "cup"), (5, "cup")])
def test_a_few_pixels_of_a_detection_are_not_enough(pixels: int, name: str) -> None:
    believed = [0] * pixels + [-1] * (10 - pixels)
    assert look([believed], [[0] * 10], CUP).name_of(0) == name


def test_what_was_taken_for_something_is_what_most_of_those_pixels_are() -> None:
    assert look([[0, 0, 0, 1]], [[1, 1, 0, 0]], CUP, VASE).taken_for("cup", NAMES) == "vase_1"
    assert look([[0, 0, 0, 1]], [[-1, -1, 0, 0]], CUP, VASE).taken_for("cup", NAMES) == NOT_A_THING
    assert look([[0, 0, 0, 1]], [[1, 1, 0, 0]], CUP, VASE).taken_for("bowl", NAMES) is None
    assert look([[-1, -1]], [[0, 0]], CUP).taken_for("cup", NAMES) is None


def test_moments_are_taken_evenly_from_the_first_to_the_last() -> None:
    assert spread(range(5), 10) == [0, 1, 2, 3, 4]
    assert spread(range(100), 4) == [0, 33, 66, 99]
