"""The trained networks as ONNX files for ONNX Runtime, with their weights in half precision."""

from pathlib import Path

import numpy as np
import torch
from torch import nn

from uniteam.files import write_whole
from uniteam.mind.perception.learned.crops import CROP_SIZE
from uniteam.mind.perception.learned.eyes import HALF_HEIGHT, HALF_WIDTH
from uniteam.mind.perception.learned.geometry_image import GEOMETRY_CHANNELS, STRIDE
from uniteam.mind.perception.learned.region_shape import SHAPE_NUMBERS

OPSET = 17
_LARGE = 256
"""Numbers; a weight of fewer stays as it is."""


def export_segmenter(model: nn.Module, path: Path) -> None:
    """Write the segmenter; its input is one frame."""
    geometry = torch.zeros(1, GEOMETRY_CHANNELS, HALF_HEIGHT // STRIDE, HALF_WIDTH // STRIDE)
    _export(model, (torch.zeros(1, 3, HALF_HEIGHT, HALF_WIDTH), geometry), path, ["image", "geometry"], ["logits"], {})


def export_namer(model: nn.Module, path: Path) -> None:
    """Write the namer; its input is any number of crops."""
    inputs = (torch.zeros(2, 3, CROP_SIZE, CROP_SIZE), torch.zeros(2, SHAPE_NUMBERS))
    any_number = {name: {0: "count"} for name in ("crops", "shapes", "vectors", "junk")}
    _export(model, inputs, path, ["crops", "shapes"], ["vectors", "junk"], any_number)


def _export(
    model: nn.Module,
    inputs: tuple[torch.Tensor, ...],
    path: Path,
    input_names: list[str],
    output_names: list[str],
    axes: dict[str, dict[int, str]],
) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    torch.onnx.export(
        model.cpu().eval(), inputs, str(path), input_names=input_names, output_names=output_names,
        dynamic_axes=axes, opset_version=OPSET, dynamo=False,
    )  # fmt: skip


def halve(path: Path, out: Path) -> None:
    """Write a network with its large weights kept in half precision; ONNX Runtime widens them when it loads them."""
    import onnx
    from onnx import TensorProto, helper, numpy_helper

    network = onnx.load(str(path))
    graph, casts = network.graph, []
    for weight in list(graph.initializer):
        if weight.data_type == TensorProto.FLOAT and np.prod(weight.dims) >= _LARGE:
            half = numpy_helper.from_array(numpy_helper.to_array(weight).astype(np.float16), weight.name + "_half")
            casts.append(helper.make_node("Cast", [half.name], [weight.name], to=TensorProto.FLOAT))
            graph.initializer.remove(weight)
            graph.initializer.append(half)
    nodes = [*casts, *graph.node]
    del graph.node[:]
    graph.node.extend(nodes)
    onnx.checker.check_model(network)
    write_whole(out, network.SerializeToString())
