"""The segmenter: of each cell of a half-size frame its kind, whether a thing ends in it, and which receptacle it is."""

import torch
from torch import Tensor, nn
from torch.nn import functional

from uniteam.mind.perception.learned.geometry_image import GEOMETRY_CHANNELS
from uniteam.mind.perception.learned.kinds import Kind
from uniteam.training.backbone import STRIDE_CHANNELS, network_input, pretrained_backbone
from uniteam.training.segmenter_data import NO_RECEPTACLE, FrameBatch

_WIDTH = 56
_ENDS_WEIGHT = 4.0
_SMOOTHING = 0.05


class Segmenter(nn.Module):
    """EfficientNet-Lite0, and a decoder that brings its features together at stride 4, where depth joins them."""

    def __init__(self, receptacle_count: int) -> None:
        """Begin with ImageNet's weights.

        Args:
            receptacle_count: how many names of receptacles there are.
        """
        super().__init__()
        self.backbone = pretrained_backbone()
        self.lateral = nn.ModuleDict({str(s): nn.Conv2d(c, _WIDTH, 1) for s, c in STRIDE_CHANNELS.items()})
        self.middle = nn.Conv2d(_WIDTH, _WIDTH, 3, padding=1)
        self.first = nn.Conv2d(_WIDTH + GEOMETRY_CHANNELS, _WIDTH, 3, padding=1)
        self.second = nn.Conv2d(_WIDTH, _WIDTH, 3, padding=1)
        self.last = nn.Conv2d(_WIDTH, len(Kind) + 1 + receptacle_count, 1)

    def forward(self, images: Tensor, geometry: Tensor) -> Tensor:
        """Return (N, 4 + 1 + receptacles, H / 4, W / 4) logits: of the kinds, of ending here, of the receptacles.

        Args:
            images: (N, 3, H, W), RGB from -1 to 1.
            geometry: (N, GEOMETRY_CHANNELS, H / 4, W / 4).
        """
        features = self.backbone(images)
        x = self.lateral["32"](features[32])
        for stride in (16, 8, 4):
            finer = self.lateral[str(stride)](features[stride])
            x = functional.interpolate(x, size=finer.shape[2:], mode="bilinear", align_corners=False) + finer
            x = functional.relu(x)
            if stride == 8:
                x = functional.relu(self.middle(x))
        x = functional.relu(self.first(torch.cat([x, geometry], dim=1)))
        x = functional.relu(x + self.second(x))
        logits: Tensor = self.last(x)
        return logits


def segmenter_loss(model: nn.Module, batch: FrameBatch, device: torch.device) -> Tensor:
    """Return the loss of a batch: of kinds (small things weigh more), of ends of things, of receptacles' names.

    A receptacle's name weighs as its kind does: a stool's few cells are not lost beside a bed's many.
    """
    geometry = torch.from_numpy(batch.geometry).to(device)
    logits = model(network_input(batch.images, device), geometry)
    kinds, weights = torch.from_numpy(batch.kinds).to(device), torch.from_numpy(batch.weights).to(device)
    kind_losses = functional.cross_entropy(logits[:, : len(Kind)], kinds, reduction="none")
    kind_loss = (kind_losses * weights).sum() / weights.sum()
    ends = torch.from_numpy(batch.ends).to(device)
    weight = torch.tensor(_ENDS_WEIGHT, device=device)
    end_loss = functional.binary_cross_entropy_with_logits(logits[:, len(Kind)], ends, pos_weight=weight)
    receptacles = torch.from_numpy(batch.receptacles).to(device)
    names = logits[:, len(Kind) + 1 :]
    is_named = (receptacles != NO_RECEPTACLE).float() * weights
    name_losses = functional.cross_entropy(
        names, receptacles, ignore_index=NO_RECEPTACLE, label_smoothing=_SMOOTHING, reduction="none"
    )
    name_loss = (name_losses * is_named).sum() / is_named.sum().clamp(min=1.0)
    return kind_loss + 0.5 * end_loss + 0.5 * name_loss
