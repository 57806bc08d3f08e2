"""Grounding DINO and both SAMs by transformers, on networks of a few random weights."""

from pathlib import Path

import cv2
import numpy as np
import pytest
from worlds.box_world import Box, observe
from worlds.tiny_networks import save_grounding_dino, save_owlv2, save_sam, save_sam2

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose
from uniteam.interface import Instruction
from uniteam.mind.perception.detectors import grounded_sam
from uniteam.mind.perception.detectors.grounded_sam import load_grounding_dino
from uniteam.mind.perception.detectors.sam_masks import load_sam
from uniteam.mind.perception.detectors.weights import Weights
from uniteam.mind.perception.registry import make_perception
from uniteam.testing import check_perception

pytest.importorskip("torch", reason="the extra 'grounded-sam' is not installed")
pytest.importorskip("transformers", reason="the extra 'grounded-sam' is not installed")

FRAME = observe((Box((1.0, -0.5, 0.0), (1.6, 0.5, 0.7), "table"),), BasePose(0.0, 0.0, 0.0))
CUP = Instruction("cup", "chest_of_drawers", "bed")
BOXES = np.array([[20, 30, 200, 250], [100, 100, 180, 160]], np.float32)


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    root = tmp_path_factory.mktemp("networks")
    save = {"dino": save_grounding_dino, "sam": save_sam, "sam2": save_sam2, "owlv2": save_owlv2}
    return {name: write(root / name) for name, write in save.items()}


@pytest.mark.parametrize("masks", ["sam", "sam2"])
def test_it_passes_the_check(folders: dict[str, Path], masks: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(grounded_sam, "LEAST_SCORE", 0.0)
    check_perception(f"grounded-sam:{folders['dino']}+{folders[masks]}", steps=3)


def test_it_gives_each_thing_a_score_for_every_name_asked_for(
    folders: dict[str, Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(grounded_sam, "LEAST_SCORE", 0.0)
    perception = make_perception(f"grounded-sam:{folders['dino']}+{folders['sam']}")
    perception.reset(CUP, 0)
    seen = perception.perceive(FRAME)
    assert seen.detections
    assert all({n for n, _ in d.candidates} == {"cup", "chest_of_drawers", "bed"} for d in seen.detections)


def test_the_tokens_of_each_name_are_found_in_the_text(folders: dict[str, Path]) -> None:
    dino = load_grounding_dino(Weights(str(folders["dino"])))
    ids = dino.processor(images=FRAME.rgb, text="cup. chest of drawers. bed.", return_tensors="pt")["input_ids"][0]
    words = [dino.processor.tokenizer.decode(ids[span]) for span in dino._spans(["cup", "chest of drawers", "bed"])]
    assert words == ["cup", "chest of drawers", "bed"]


def test_boxes_are_where_transformers_own_post_processing_has_them(folders: dict[str, Path]) -> None:
    dino = load_grounding_dino(Weights(str(folders["dino"])))
    inputs = dino.processor(images=FRAME.rgb, text="cup. bed.", return_tensors="pt")
    with dino.torch.inference_mode():
        outputs = dino.model(**inputs)
    (theirs,) = dino.processor.post_process_grounded_object_detection(
        outputs, inputs["input_ids"], threshold=0.0, text_threshold=0.0, target_sizes=[FRAME.depth.shape]
    )
    ours, _ = dino.boxes(FRAME.rgb, ("cup", "bed"))
    assert np.allclose(ours, theirs["boxes"].numpy(), atol=0.05)


def test_masks_of_sam_are_those_of_transformers_own_processing(folders: dict[str, Path]) -> None:
    sam = load_sam(Weights(str(folders["sam"])), "grounded-sam")
    from transformers import SamProcessor

    processor = SamProcessor.from_pretrained(folders["sam"])
    rgb = np.random.default_rng(0).integers(0, 255, FRAME.rgb.shape, np.uint8)
    smooth = np.asarray(cv2.GaussianBlur(rgb, (0, 0), 20.0), np.uint8)
    inputs = processor(smooth, input_boxes=[BOXES.tolist()], return_tensors="pt")
    with sam.torch.inference_mode():
        outputs = sam.model(**{k: v for k, v in inputs.items() if "sizes" not in k}, multimask_output=False)
    theirs = processor.post_process_masks(outputs.pred_masks, inputs["original_sizes"], inputs["reshaped_input_sizes"])[
        0
    ][:, 0].numpy()
    ours = sam.masks(smooth, BOXES)
    assert ours.shape == theirs.shape == (2, 320, 240)
    assert (ours == theirs).mean() > 0.97


@pytest.mark.parametrize("masks", ["sam", "sam2"])
def test_no_boxes_have_no_masks(folders: dict[str, Path], masks: str) -> None:
    sam = load_sam(Weights(str(folders[masks])), "grounded-sam")
    assert sam.masks(FRAME.rgb, np.zeros((0, 4), np.float32)).shape == (0, 320, 240)
    assert sam.masks(FRAME.rgb, BOXES).shape == (2, 320, 240)


def test_what_is_no_sam_is_refused(folders: dict[str, Path]) -> None:
    with pytest.raises(InvalidInputError, match="is a owlv2, and must be a SAM or a SAM 2"):
        make_perception(f"grounded-sam:{folders['dino']}+{folders['owlv2']}")
