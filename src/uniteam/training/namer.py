"""The namer: from a crop and the region's shape to a vector of meaning, and whether it is a whole thing at all."""

from collections.abc import Sequence

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn import functional

from uniteam.mind.perception.learned.region_shape import SHAPE_NUMBERS
from uniteam.mind.perception.words.meaning import DIMENSIONS, load_words
from uniteam.training.backbone import HEAD, network_input, pretrained_backbone, pretrained_head
from uniteam.training.namer_data import JUNK, CropBatch

_HIDDEN = 320
_SHAPE_HIDDEN = 48
_FIRST_SCALE = 16.0
SMOOTHING = 0.05
NAME_DROPOUT = 0.2
"""Share of the names that a batch leaves out, so that absent names are not pushed away from everything."""


class Namer(nn.Module):
    """EfficientNet-Lite0 and the region's shape, joined: a unit vector in the space of the words and a junk logit."""

    def __init__(self) -> None:
        """Begin with ImageNet's weights."""
        super().__init__()
        self.backbone, self.head = pretrained_backbone(), pretrained_head()
        self.shape = nn.Sequential(nn.Linear(SHAPE_NUMBERS, _SHAPE_HIDDEN), nn.ReLU())
        self.join = nn.Sequential(
            nn.Dropout(0.2), nn.Linear(HEAD + _SHAPE_HIDDEN, _HIDDEN), nn.ReLU(), nn.Linear(_HIDDEN, DIMENSIONS + 1)
        )
        self.log_scale = nn.Parameter(torch.tensor(float(np.log(_FIRST_SCALE))))

    def forward(self, crops: Tensor, shapes: Tensor) -> tuple[Tensor, Tensor]:
        """Return the (N, DIMENSIONS) unit vectors and the (N,) junk logits.

        Args:
            crops: (N, 3, CROP_SIZE, CROP_SIZE), RGB from -1 to 1.
            shapes: (N, SHAPE_NUMBERS).
        """
        looks = self.head(self.backbone(crops)[32]).mean((2, 3))
        joined = self.join(torch.cat([looks, self.shape(shapes)], dim=1))
        return functional.normalize(joined[:, :DIMENSIONS], dim=1), joined[:, DIMENSIONS]


def name_vectors(names: Sequence[str]) -> Tensor:
    """Return the (K, DIMENSIONS) vectors of names; raises UnknownNameError where one is not in the table."""
    words = load_words()
    return torch.from_numpy(np.stack([words.meaning(name).vector for name in names]))


def namer_loss(model: Namer, batch: CropBatch, vectors: Tensor, generator: torch.Generator) -> Tensor:
    """Return the loss of a batch: cross-entropy over the names, a part of them left out, and of being junk."""
    device = vectors.device
    found, junk = model(network_input(batch.crops, device), torch.from_numpy(batch.shapes).to(device))
    labels = torch.from_numpy(batch.labels).to(device)
    is_thing = labels != JUNK
    junk_loss = functional.binary_cross_entropy_with_logits(junk, (~is_thing).float())
    logits = model.log_scale.exp().clamp(max=60.0) * found[is_thing] @ vectors.T
    left_out = torch.rand(len(vectors), generator=generator).to(device) < NAME_DROPOUT
    left_out[labels[is_thing]] = False
    kept = logits[:, ~left_out]
    places = torch.cumsum(~left_out, dim=0) - 1
    naming_loss = functional.cross_entropy(kept, places[labels[is_thing]], label_smoothing=SMOOTHING)
    return naming_loss + junk_loss
