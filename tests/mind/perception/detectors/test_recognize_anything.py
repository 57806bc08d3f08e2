"""A tagger before a detector: what it does not see is not asked for."""

from collections.abc import Collection, Sequence

import numpy as np
import pytest
from numpy.typing import NDArray
from worlds.box_world import Box, observe

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.geometry import BasePose
from uniteam.interface import Detection, Instruction, Observation
from uniteam.mind.perception.detectors.detector import DetectorFactory, Found
from uniteam.mind.perception.registry import PERCEPTIONS, make_perception
from uniteam.registry import UnimportableError
from uniteam.testing import check_perception

FRAME = observe((Box((1.0, -0.5, 0.0), (1.6, 0.5, 0.7), "table"),), BasePose(0.0, 0.0, 0.0))


class LongWords:
    """Sees whatever has more than three letters, and some that nobody asked for."""

    def tags(self, rgb: NDArray[np.uint8], names: tuple[str, ...]) -> Collection[str]:
        return {"giraffe", *(name for name in names if len(name) > 3)}


class Blind:
    """Sees nothing."""

    def tags(self, rgb: NDArray[np.uint8], names: tuple[str, ...]) -> Collection[str]:
        return ()


class Rows:
    """Finds everything that it is asked for, each in a row of its own."""

    def detect(self, observation: Observation, names: tuple[str, ...]) -> Sequence[Found]:
        assert names, "a detector is not asked for nothing"
        masks = np.zeros((len(names), *observation.depth.shape), bool)
        for k in range(len(names)):
            masks[k, k] = True
        return [Found(mask, Detection(((name, 0.6),))) for name, mask in zip(names, masks, strict=True)]


rows = DetectorFactory(Rows)
"""Registered by its reference in what follows."""


def perceived(tagger: str, detector: str = f"{__name__}:rows") -> list[str]:
    perception = make_perception(f"recognize-anything:{__name__}:{tagger}+{detector}")
    perception.reset(Instruction("cup", "table", "bed"), 0)
    return [detection.name for detection in perception.perceive(FRAME).detections]


def test_only_what_the_tagger_sees_is_asked_of_the_detector() -> None:
    assert perceived("LongWords") == ["table"]
    assert perceived("Blind") == []


def test_it_passes_the_check() -> None:
    check_perception(f"recognize-anything:{__name__}:LongWords+{__name__}:rows", steps=4)


def test_the_taggers_code_is_what_results_depend_on() -> None:
    name = f"recognize-anything:{__name__}:LongWords+owlv2"
    assert "torch" in PERCEPTIONS.outside_code(name) and len(PERCEPTIONS.outside_code(name).split()) == 5
    assert PERCEPTIONS.outside_code("truth") == ""


@pytest.mark.parametrize(
    ("name", "kind", "sentence"),
    [
        ("recognize-anything", InvalidInputError, "needs TAGGER\\+DETECTOR after a colon"),
        ("recognize-anything:owlv2", InvalidInputError, "needs a tagger and a detector, got 'owlv2'"),
        (
            f"recognize-anything:{__name__}:Blind+truth",
            InvalidInputError,
            "'truth' cannot be asked for some",
        ),
        (f"recognize-anything:{__name__}:Blind+owlv3", UnknownNameError, "did you mean 'owlv2'"),
        ("recognize-anything:no_module:Tagger+owlv2", UnimportableError, "no_module"),
        (f"recognize-anything:{__name__}:Rows+{__name__}:rows", InvalidInputError, "needs tags.*Rows has none"),
        (f"recognize-anything:{__name__}:FRAME+{__name__}:rows", InvalidInputError, "must be a class"),
    ],
)
def test_what_does_not_fit_is_refused_in_a_sentence(name: str, kind: type[Exception], sentence: str) -> None:
    with pytest.raises(kind, match=sentence):
        make_perception(name)
