"""Masks of things in boxes, by SAM (Kirillov et al. 2023) or SAM 2 (Ravi et al. 2024) of transformers."""

from dataclasses import dataclass
from functools import cache
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.mind.perception.detectors.weights import Weights, device_of, from_hub, import_library

MEAN = np.array([0.485, 0.456, 0.406], dtype=np.float32)
DEVIATION = np.array([0.229, 0.224, 0.225], dtype=np.float32)
"""Of ImageNet's colours, by which both models' frames are normalised."""


@dataclass(frozen=True)
class SamMasks:
    """A SAM that is asked for one mask a box.

    The frames are prepared here and not by the processors of transformers: that of SAM 2 needs torchvision.

    Attributes:
        model: of transformers.
        side: of the square that the model sees (px).
        keeps_shape: whether frames are fitted into the square and padded, as SAM's, or stretched to it, as SAM 2's.
        torch: the library.
    """

    model: Any
    side: int
    keeps_shape: bool
    torch: Any

    def masks(self, rgb: NDArray[np.uint8], boxes: NDArray[np.float32]) -> NDArray[np.bool_]:
        """Return the (N, H, W) masks of what is in (N, 4) boxes (x0, y0, x1, y1) of an (H, W, 3) frame."""
        height, width = rgb.shape[:2]
        if len(boxes) == 0:
            return np.zeros((0, height, width), dtype=bool)
        inner_width, inner_height = self._fitted(width, height)
        pixels = np.zeros((self.side, self.side, 3), dtype=np.float32)
        shrunk = cv2.resize(rgb, (inner_width, inner_height), interpolation=cv2.INTER_LINEAR)
        pixels[:inner_height, :inner_width] = (shrunk / np.float32(255.0) - MEAN) / DEVIATION
        scale = np.array([inner_width / width, inner_height / height] * 2, dtype=np.float32)
        with self.torch.inference_mode():
            outputs = self.model(
                pixel_values=self._tensor(pixels.transpose(2, 0, 1)[None]),
                input_boxes=self._tensor((boxes * scale)[None]),
                multimask_output=False,
            )
        logits = outputs.pred_masks.float().cpu().numpy().reshape(len(boxes), *outputs.pred_masks.shape[-2:])
        return np.stack([self._at_full_size(one, (inner_width, inner_height), (width, height)) for one in logits])

    def _fitted(self, width: int, height: int) -> tuple[int, int]:
        """Return the width and height of a frame in the square."""
        if not self.keeps_shape:
            return self.side, self.side
        scale = self.side / max(width, height)
        return int(width * scale + 0.5), int(height * scale + 0.5)

    def _tensor(self, values: NDArray[np.float32]) -> Any:
        return self.torch.from_numpy(np.ascontiguousarray(values)).to(self.model.device)

    def _at_full_size(
        self, logits: NDArray[np.float32], inner: tuple[int, int], full: tuple[int, int]
    ) -> NDArray[np.bool_]:
        square = cv2.resize(logits, (self.side, self.side), interpolation=cv2.INTER_LINEAR)
        cut = np.ascontiguousarray(square[: inner[1], : inner[0]])
        return np.asarray(cv2.resize(cut, full, interpolation=cv2.INTER_LINEAR) > 0.0)


@cache
def load_sam(weights: Weights, extra: str) -> SamMasks:
    """Return SAM or SAM 2, as the weights are, loaded once a process; raises UnavailableError or InvalidInputError."""
    torch, transformers = import_library("torch", extra), import_library("transformers", extra)
    kind = from_hub(transformers.AutoConfig.from_pretrained, weights).model_type
    if kind == "sam":
        model = from_hub(transformers.SamModel.from_pretrained, weights)
        side = model.config.vision_config.image_size
    elif kind in ("sam2", "sam2_video"):
        model = from_hub(transformers.Sam2Model.from_pretrained, weights)
        side = model.config.vision_config.backbone_config.image_size
    else:
        raise InvalidInputError(f"model '{weights}' is a {kind}, and must be a SAM or a SAM 2; choose another")
    side = side if isinstance(side, int) else side[0]
    return SamMasks(model.to(device_of(torch)).eval(), side, kind == "sam", torch)
