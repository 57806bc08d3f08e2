"""OWLv2 by transformers, on a network of a few random weights."""

from pathlib import Path

import numpy as np
import pytest
from worlds.box_world import Box, observe
from worlds.tiny_networks import save_owlv2

from uniteam.errors import UnavailableError
from uniteam.geometry import BasePose
from uniteam.interface import Instruction
from uniteam.mind.perception.detectors import owlv2
from uniteam.mind.perception.registry import make_perception
from uniteam.testing import check_perception

pytest.importorskip("torch", reason="the extra 'owlv2' is not installed")
pytest.importorskip("transformers", reason="the extra 'owlv2' is not installed")

FRAME = observe((Box((1.0, -0.5, 0.0), (1.6, 0.5, 0.7), "table"),), BasePose(0.0, 0.0, 0.0))
CUP = Instruction("cup", "chest_of_drawers", "bed")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return save_owlv2(tmp_path_factory.mktemp("owlv2"))


def test_it_passes_the_check(folder: Path) -> None:
    check_perception(f"owlv2:{folder}", steps=4)


def test_it_gives_each_box_a_score_for_every_name_asked_for_and_an_embedding(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(owlv2, "LEAST_SCORE", 0.0)
    perception = make_perception(f"owlv2:{folder}")
    perception.reset(CUP, 0)
    seen = perception.perceive(FRAME)
    assert seen.detections
    for detection in seen.detections:
        assert {name for name, _ in detection.candidates} == {"cup", "chest_of_drawers", "bed"}
        assert detection.embedding is not None and detection.embedding.shape == (16,)
        assert np.linalg.norm(detection.embedding) == pytest.approx(1.0, abs=1e-5)


def test_boxes_are_where_transformers_own_post_processing_has_them(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    detector = owlv2.load_owlv2(owlv2.Weights(str(folder)))
    asked = [["a photo of a cup", "a photo of a bed"]]
    inputs = detector.processor(text=asked, images=FRAME.rgb, padding="max_length", return_tensors="pt")
    with detector.torch.inference_mode():
        outputs = detector.model(**inputs)
    (theirs,) = detector.processor.post_process_grounded_object_detection(
        outputs, threshold=0.0, target_sizes=[FRAME.depth.shape]
    )
    ours = owlv2._corners(outputs.pred_boxes[0].numpy(), max(FRAME.depth.shape))
    assert np.allclose(ours, theirs["boxes"].numpy(), atol=0.05)


def test_a_missing_model_is_told_with_what_to_do_offline(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HF_HUB_OFFLINE", "1")
    monkeypatch.setenv("HF_HOME", str(tmp_path))
    with pytest.raises(UnavailableError, match=r"model 'nobody/nothing@abc' cannot be loaded .* HF_HUB_OFFLINE is set"):
        make_perception("owlv2:nobody/nothing@abc")


def test_a_folder_without_weights_is_told(tmp_path: Path) -> None:
    with pytest.raises(UnavailableError, match="cannot be loaded"):
        make_perception(f"owlv2:{tmp_path}")
