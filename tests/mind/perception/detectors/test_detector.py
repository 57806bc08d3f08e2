"""What all adapters share: names, masks, boxes, kept frames, and what is said where something is missing."""

import subprocess
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from worlds.box_world import Box, observe

from uniteam.errors import InvalidInputError, UnavailableError
from uniteam.geometry import BasePose
from uniteam.interface import Detection, Instruction, Observation
from uniteam.mind.perception.detectors import detector
from uniteam.mind.perception.detectors.boxes import keep_apart, mask_of_box
from uniteam.mind.perception.detectors.detector import DetectorPerception, Found, as_words, asked_names, paint
from uniteam.mind.perception.detectors.weights import Weights, import_library
from uniteam.mind.perception.registry import make_perception

CUP = Instruction("cup", "table", "table")
FRAME = observe((Box((1.0, -0.5, 0.0), (1.6, 0.5, 0.7), "table"),), BasePose(0.0, 0.0, 0.0))


class Counting:
    """Finds the left half of the frame, and counts how often it was asked for what."""

    def __init__(self) -> None:
        self.asked: list[tuple[str, ...]] = []

    def detect(self, observation: Observation, names: tuple[str, ...]) -> Sequence[Found]:
        self.asked.append(names)
        mask = np.zeros(observation.depth.shape, bool)
        mask[:, :120] = True
        return [Found(mask, Detection(((names[0], 0.7),)))]


def test_a_frame_is_looked_at_once_for_the_same_names() -> None:
    counting = Counting()
    perception = DetectorPerception(counting)
    perception.reset(CUP, 0)
    first = perception.perceive(FRAME)
    assert perception.perceive(replace(FRAME, step=9)) is first
    perception.reset(CUP, 1)
    perception.perceive(FRAME)
    assert counting.asked == [("cup", "table")]
    brighter = replace(FRAME, rgb=FRAME.rgb + np.uint8(1))
    perception.perceive(brighter)
    perception.reset(Instruction("bowl", "table", "bed"), 0)
    perception.perceive(brighter)
    assert counting.asked[1:] == [("cup", "table"), ("bowl", "table", "bed")]


def test_no_more_frames_are_kept_than_there_is_room_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(detector, "KEPT_FRAMES", 2)
    counting = Counting()
    perception = DetectorPerception(counting)
    perception.reset(CUP, 0)
    frames = [replace(FRAME, rgb=FRAME.rgb + np.uint8(k)) for k in range(3)]
    for k in (0, 1, 0, 2, 0, 1):
        perception.perceive(frames[k])
    assert len(counting.asked) == 4


def test_the_surer_of_two_masks_has_the_pixel_and_what_is_wholly_covered_is_gone() -> None:
    left, all_of_it = np.zeros((4, 4), bool), np.ones((4, 4), bool)
    left[:, :2] = True
    found = [
        Found(all_of_it, Detection((("table", 0.4),))),
        Found(left, Detection((("bowl", 0.3),))),
        Found(left, Detection((("cup", 0.9),))),
    ]
    seen = paint(found, (4, 4))
    assert [d.name for d in seen.detections] == ["cup", "table"]
    assert seen.instances[0].tolist() == [0, 0, 1, 1]


def test_names_are_asked_for_once_and_as_people_write_them() -> None:
    assert asked_names(CUP) == ("cup", "table")
    assert as_words("chest_of_drawers") == "chest of drawers"


def test_of_boxes_that_lie_upon_each_other_the_surest_is_kept() -> None:
    boxes = np.array([[0, 0, 10, 10], [1, 1, 11, 11], [20, 20, 30, 30]], np.float32)
    assert keep_apart(boxes, np.array([0.5, 0.8, 0.3], np.float32), 0.5) == [1, 2]
    assert keep_apart(boxes, np.array([0.5, 0.8, 0.3], np.float32), 0.9) == [1, 0, 2]


def test_a_box_leaves_out_what_is_far_behind_the_thing() -> None:
    cup = Box((1.0, -0.05, 0.9), (1.1, 0.05, 1.0), "cup")
    frame = observe((cup, Box((4.0, -3.0, 0.0), (4.1, 3.0, 2.5))), BasePose(0.0, 0.0, 0.0))
    assert frame.truth is not None
    true = frame.truth.instances == 0
    rows, columns = np.nonzero(true)
    box = np.array([columns.min() - 4, rows.min() - 4, columns.max() + 5, rows.max() + 5], float)
    mask = mask_of_box(box, frame)
    assert (mask & true).sum() / (mask | true).sum() > 0.95


@pytest.mark.parametrize("box", [(-50, -50, -10, -10), (300, 400, 500, 600), (10, 10, 10, 10), (50, 50, 20, 20)])
def test_a_box_outside_of_the_frame_or_without_extent_shows_nothing(box: tuple[int, ...]) -> None:
    assert not mask_of_box(np.array(box, float), FRAME).any()


def test_a_box_without_depth_is_taken_as_it_is() -> None:
    blind = replace(FRAME, depth=np.zeros_like(FRAME.depth))
    assert mask_of_box(np.array([10, 20, 30, 50], float), blind).sum() == 20 * 30


@pytest.mark.parametrize(
    ("argument", "weights"),
    [("google/owlv2", Weights("google/owlv2")), ("google/owlv2@v1.0", Weights("google/owlv2", "v1.0"))],
)
def test_a_model_is_named_with_its_revision(argument: str, weights: Weights) -> None:
    assert Weights.of(argument) == weights
    assert str(weights) == argument


@pytest.mark.parametrize("argument", ["owlv2", "a/b/c", "a/b@", "/nowhere/at/all", "a b/c", "/b"])
def test_what_is_no_model_is_refused(argument: str) -> None:
    with pytest.raises(InvalidInputError, match="is no model: give ORG/NAME"):
        Weights.of(argument)


def test_a_folder_is_a_model(tmp_path: Path) -> None:
    assert Weights.of(str(tmp_path)) == Weights(str(tmp_path))


def test_a_missing_library_is_told_with_the_command_that_installs_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "torch", None)
    with pytest.raises(UnavailableError, match=r"perception 'owlv2' needs the package torch.*uniteam\[owlv2\]"):
        import_library("torch", "owlv2")


def test_naming_the_perceptions_imports_none_of_their_libraries() -> None:
    code = (
        "import sys\nfrom uniteam.mind.perception.registry import PERCEPTIONS\n"
        "PERCEPTIONS.get('owlv2'), PERCEPTIONS.get('remote:http://nowhere')\n"
        "print(sorted({'torch', 'transformers', 'ultralytics', 'httpx'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_a_detector_without_its_library_says_so_when_it_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "torch", None)
    with pytest.raises(UnavailableError, match="pip install"):
        make_perception("owlv2:some/model")
