"""Perception `grounded-sam`: boxes of Grounding DINO (Liu et al. 2023), masks of SAM or SAM 2, both of transformers."""

from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.interface import Detection, Observation
from uniteam.mind.perception.detectors.boxes import keep_apart
from uniteam.mind.perception.detectors.detector import DetectorFactory, Found, as_words, ranked
from uniteam.mind.perception.detectors.sam_masks import SamMasks, load_sam
from uniteam.mind.perception.detectors.weights import Weights, device_of, from_hub, import_library
from uniteam.registry import Family

EXTRA = "grounded-sam"
DEFAULT = "IDEA-Research/grounding-dino-tiny+facebook/sam2.1-hiera-tiny"
LEAST_SCORE = 0.2
MOST_OVERLAP = 0.7
MOST_BOXES = 40


@dataclass(frozen=True)
class GroundingDino:
    """Grounding DINO with its processor, both of transformers."""

    model: Any
    processor: Any
    torch: Any

    def boxes(self, rgb: NDArray[np.uint8], names: tuple[str, ...]) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Return (Q, 4) boxes (x0, y0, x1, y1 in px) of an (H, W, 3) frame, and how well each fits each name (Q, N).

        A name's score is the mean over its tokens: where a name has several, each of them has to fit.
        """
        texts = [as_words(name) for name in names]
        inputs = self.processor(images=rgb, text=" ".join(f"{text}." for text in texts), return_tensors="pt")
        with self.torch.inference_mode():
            outputs = self.model(**inputs.to(self.model.device))
        of_tokens = outputs.logits[0].float().sigmoid().cpu().numpy()
        scores = np.stack([of_tokens[:, span].mean(axis=1) for span in self._spans(texts)], axis=1)
        shares = outputs.pred_boxes[0].float().cpu().numpy()
        corners = np.concatenate([shares[:, :2] - shares[:, 2:] / 2, shares[:, :2] + shares[:, 2:] / 2], axis=1)
        return corners * np.array([rgb.shape[1], rgb.shape[0]] * 2, dtype=np.float32), scores

    def _spans(self, texts: list[str]) -> list[slice]:
        """Return where the tokens of each text stand: after the one that begins all, with a full stop after each."""
        spans, start = [], 1
        for text in texts:
            length = len(self.processor.tokenizer(text, add_special_tokens=False)["input_ids"])
            spans.append(slice(start, start + length))
            start += length + 1
        return spans


@dataclass(frozen=True)
class GroundedSam:
    """Boxes of one network, and masks of another in them."""

    grounding: GroundingDino
    sam: SamMasks

    def detect(self, observation: Observation, names: tuple[str, ...]) -> list[Found]:
        """Return what is found, with every name's score."""
        boxes, scores = self.grounding.boxes(observation.rgb, names)
        best = scores.max(axis=1)
        likely = np.flatnonzero(best >= LEAST_SCORE)
        kept = likely[keep_apart(boxes[likely], best[likely], MOST_OVERLAP)[:MOST_BOXES]]
        masks = self.sam.masks(observation.rgb, boxes[kept])
        return [Found(mask, Detection(ranked(names, scores[k]))) for k, mask in zip(kept, masks, strict=True)]


@cache
def load_grounding_dino(weights: Weights) -> GroundingDino:
    """Return the network of boxes, loaded once a process; raises UnavailableError."""
    torch, transformers = import_library("torch", EXTRA), import_library("transformers", EXTRA)
    model = from_hub(transformers.GroundingDinoForObjectDetection.from_pretrained, weights)
    processor = from_hub(transformers.GroundingDinoProcessor.from_pretrained, weights)
    return GroundingDino(model.to(device_of(torch)).eval(), processor, torch)


def load_grounded_sam(boxes: Weights, masks: Weights) -> GroundedSam:
    """Return the detector; raises UnavailableError, or InvalidInputError where weights are of another network."""
    return GroundedSam(load_grounding_dino(boxes), load_sam(masks, EXTRA))


def grounded_sam_of(argument: str) -> DetectorFactory:
    """Return what makes perceptions of the two models that an argument names; raises InvalidInputError."""
    boxes, plus, masks = argument.partition("+")
    if not plus:
        raise InvalidInputError(
            f"perception '{EXTRA}' needs two models, of boxes and of masks, got '{argument}'; give BOXES+MASKS, "
            f"such as {DEFAULT}"
        )
    load = partial(load_grounded_sam, Weights.of(boxes), Weights.of(masks))
    return DetectorFactory(load, ("torch", "transformers"))


GROUNDED_SAM = Family(
    "boxes of Grounding DINO, masks of SAM or SAM 2 in them", "BOXES+MASKS", DEFAULT, grounded_sam_of, DEFAULT
)
