"""Perception `yoloe`: YOLOE (Wang et al. 2025) of the package ultralytics, which is under AGPL-3.0."""

import os
from dataclasses import dataclass, field
from functools import cache, partial
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from uniteam.errors import InvalidInputError, UnavailableError
from uniteam.interface import Detection, Observation
from uniteam.mind.perception.detectors.detector import DetectorFactory, Found, as_words
from uniteam.mind.perception.detectors.weights import import_library
from uniteam.registry import Family

EXTRA = "yoloe"
LEAST_SCORE = 0.05
MOST_OVERLAP = 0.7
IMAGE_SIDE = 640


@dataclass
class Yoloe:
    """YOLOE with a vocabulary that changes.

    Attributes:
        model: of ultralytics.
        names: that it was told last.
    """

    model: Any
    names: tuple[str, ...] = field(default=())

    def detect(self, observation: Observation, names: tuple[str, ...]) -> list[Found]:
        """Return what is found; each thing has one name."""
        if names != self.names:
            self.model.set_classes([as_words(name) for name in names])
            self.names = names
        bgr = np.ascontiguousarray(observation.rgb[:, :, ::-1])
        (result,) = self.model.predict(
            bgr, conf=LEAST_SCORE, iou=MOST_OVERLAP, imgsz=IMAGE_SIDE, retina_masks=True, verbose=False
        )
        if result.masks is None:
            return []
        scores, classes = (np.asarray(each.cpu()) for each in (result.boxes.conf, result.boxes.cls))
        height, width = observation.depth.shape
        found = []
        for mask, score, index in zip(np.asarray(result.masks.data.cpu(), np.float32), scores, classes, strict=True):
            full = cv2.resize(mask, (width, height), interpolation=cv2.INTER_LINEAR) > 0.5
            found.append(Found(np.asarray(full), Detection(((names[int(index)], float(score)),))))
        return found


@cache
def load_yoloe(weights: str) -> Yoloe:
    """Return the detector, loaded once a process; raises UnavailableError."""
    os.environ.setdefault("YOLO_OFFLINE", "true")  # it would fetch what it finds missing, unasked
    ultralytics = import_library("ultralytics", EXTRA)
    try:
        return Yoloe(ultralytics.YOLOE(weights))
    except Exception as error:  # whatever reading somebody's weights raises
        raise UnavailableError(f"'{weights}' cannot be loaded as YOLOE ({type(error).__name__}: {error})") from error


def yoloe_of(argument: str) -> DetectorFactory:
    """Return what makes perceptions of a file of weights; raises InvalidInputError where there is none."""
    if not Path(argument).is_file():
        raise InvalidInputError(
            f"perception 'yoloe' needs a file of weights, such as yoloe-11s-seg.pt, and '{argument}' is none; "
            "fetch it as ultralytics' documentation says"
        )
    return DetectorFactory(partial(load_yoloe, argument), ("ultralytics", "torch"))


YOLOE = Family("YOLOE of ultralytics (AGPL-3.0)", "WEIGHTS.pt", "yoloe-11s-seg.pt", yoloe_of)
