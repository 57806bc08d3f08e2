"""YOLOE: against a stand-in of ultralytics' class, and where that is installed a network made from its yaml."""

import sys
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest
from worlds.box_world import Box, observe

from uniteam.errors import InvalidInputError, UnavailableError
from uniteam.geometry import BasePose
from uniteam.interface import Instruction
from uniteam.mind.perception.detectors.detector import DetectorPerception
from uniteam.mind.perception.detectors.yoloe import Yoloe, load_yoloe
from uniteam.mind.perception.registry import make_perception
from uniteam.testing import check_perception

FRAME = observe((Box((1.0, -0.5, 0.0), (1.6, 0.5, 0.7), "table"),), BasePose(0.0, 0.0, 0.0))
CUP = Instruction("cup", "chest_of_drawers", "bed")


class Tensor:
    """Numbers as ultralytics hands them out."""

    def __init__(self, values: Any) -> None:
        self.values = np.asarray(values, np.float32)

    def cpu(self) -> Any:
        return self.values


class StandIn:
    """Answers as ultralytics' YOLOE does: the bright third of the frame is the last class, at half the frame's size."""

    def __init__(self, weights: str) -> None:
        if Path(weights).read_text() != "weights":
            raise RuntimeError("not a zip archive")

    def set_classes(self, classes: list[str]) -> None:
        assert all("_" not in name for name in classes)
        self.classes = classes

    def predict(self, source: Any, **options: Any) -> list[Any]:
        assert options["verbose"] is False and source.flags.c_contiguous
        bright = source[::2, ::2].mean(axis=-1) > np.percentile(source, 66)
        if not bright.any():
            return [SimpleNamespace(masks=None, boxes=SimpleNamespace(conf=Tensor([]), cls=Tensor([])))]
        boxes = SimpleNamespace(conf=Tensor([0.6]), cls=Tensor([len(self.classes) - 1]))
        return [SimpleNamespace(masks=SimpleNamespace(data=Tensor([bright])), boxes=boxes)]


@pytest.fixture
def weights(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    module = ModuleType("ultralytics")
    module.YOLOE = StandIn  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "ultralytics", module)
    path = tmp_path / "yoloe.pt"
    path.write_text("weights")
    return path


def test_it_passes_the_check(weights: Path) -> None:
    check_perception(f"yoloe:{weights}", steps=4)


def test_masks_come_at_the_frames_size_with_the_names_that_were_asked_for(weights: Path) -> None:
    perception = make_perception(f"yoloe:{weights}")
    perception.reset(CUP, 0)
    rgb = FRAME.rgb.copy()
    rgb[:100] = 255
    seen = perception.perceive(type(FRAME)(**{**vars(FRAME), "rgb": rgb}))
    assert [(d.name, round(d.score, 3)) for d in seen.detections] == [("bed", 0.6)]
    assert (seen.instances[:99] == 0).all() and (seen.instances[102:] == -1).all()
    assert perception.perceive(FRAME).detections == ()


def test_weights_that_are_none_are_told(weights: Path, tmp_path: Path) -> None:
    (tmp_path / "broken.pt").write_text("hello")
    with pytest.raises(UnavailableError, match=r"broken\.pt' cannot be loaded as YOLOE \(RuntimeError"):
        make_perception(f"yoloe:{tmp_path / 'broken.pt'}")
    with pytest.raises(InvalidInputError, match="needs a file of weights"):
        make_perception("yoloe:nowhere.pt")


def test_a_missing_library_is_told_with_the_command_that_installs_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "ultralytics", None)
    (tmp_path / "any.pt").touch()
    with pytest.raises(UnavailableError, match=r"pip install 'uniteam\[yoloe\]'"):
        load_yoloe.__wrapped__(str(tmp_path / "any.pt"))


def test_a_network_of_random_weights_runs() -> None:
    ultralytics = pytest.importorskip("ultralytics", reason="the extra 'yoloe' is not installed")
    torch = pytest.importorskip("torch")
    model = ultralytics.YOLOE("yoloe-11s-seg.yaml")
    names = ("cup", "chest_of_drawers", "bed")
    model.set_classes([name.replace("_", " ") for name in names], torch.randn(1, 3, 512))
    perception = DetectorPerception(Yoloe(model, names))
    perception.reset(CUP, 0)
    assert perception.perceive(FRAME).instances.shape == FRAME.depth.shape
