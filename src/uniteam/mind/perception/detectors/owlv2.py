"""Perception `owlv2`: boxes of OWLv2 (Minderer et al. 2023), by transformers; their masks are cut out of the depth."""

from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import Detection, Observation
from uniteam.mind.perception.detectors.boxes import keep_apart, mask_of_box
from uniteam.mind.perception.detectors.detector import DetectorFactory, Found, as_words, ranked
from uniteam.mind.perception.detectors.weights import Weights, device_of, from_hub, import_library
from uniteam.registry import Family

EXTRA = "owlv2"
DEFAULT = "google/owlv2-base-patch16-ensemble"
LEAST_SCORE = 0.1
"""Below this OWLv2 means nothing; the agents' own thresholds come on top."""
MOST_OVERLAP = 0.5
MOST_BOXES = 100


@dataclass(frozen=True)
class Owlv2:
    """OWLv2 with its processor, both of transformers."""

    model: Any
    processor: Any
    torch: Any

    def detect(self, observation: Observation, names: tuple[str, ...]) -> list[Found]:
        """Return what is found, with every name's score and OWLv2's embedding of it."""
        asked = [[f"a photo of a {as_words(name)}" for name in names]]
        inputs = self.processor(text=asked, images=observation.rgb, padding="max_length", return_tensors="pt")
        with self.torch.inference_mode():
            outputs = self.model(**inputs.to(self.model.device))
        scores = outputs.logits[0].float().sigmoid().cpu().numpy()
        boxes = _corners(outputs.pred_boxes[0].float().cpu().numpy(), max(observation.depth.shape))
        embeddings = outputs.class_embeds[0].float().cpu().numpy()
        best = scores.max(axis=1)
        likely = [k for k in np.argsort(-best, kind="stable")[:MOST_BOXES] if best[k] >= LEAST_SCORE]
        kept = keep_apart(boxes[likely], best[likely], MOST_OVERLAP) if likely else []
        return [
            Found(mask_of_box(boxes[k], observation), _detection(names, scores[k], embeddings[k]))
            for k in (likely[index] for index in kept)
        ]


def _corners(boxes: NDArray[np.float32], side: int) -> NDArray[np.float32]:
    """Return (N, 4) corners (px) of boxes (centre, size), given as shares of the square that frames were padded to."""
    return np.concatenate([boxes[:, :2] - boxes[:, 2:] / 2, boxes[:, :2] + boxes[:, 2:] / 2], axis=1) * side


def _detection(names: tuple[str, ...], scores: NDArray[np.float32], embedding: NDArray[np.float32]) -> Detection:
    norm = max(float(np.linalg.norm(embedding)), 1e-9)
    return Detection(ranked(names, scores), (embedding / norm).astype(np.float32))


@cache
def load_owlv2(weights: Weights) -> Owlv2:
    """Return the detector, loaded once a process; raises UnavailableError."""
    torch, transformers = import_library("torch", EXTRA), import_library("transformers", EXTRA)
    model = from_hub(transformers.Owlv2ForObjectDetection.from_pretrained, weights)
    processor = from_hub(transformers.Owlv2Processor.from_pretrained, weights)
    return Owlv2(model.to(device_of(torch)).eval(), processor, torch)


def owlv2_of(argument: str) -> DetectorFactory:
    """Return what makes perceptions of the weights that an argument names; raises InvalidInputError."""
    return DetectorFactory(partial(load_owlv2, Weights.of(argument)), ("torch", "transformers"))


OWLV2 = Family("boxes of OWLv2, cut out of the depth", "ORG/NAME@REVISION", DEFAULT, owlv2_of, DEFAULT)
