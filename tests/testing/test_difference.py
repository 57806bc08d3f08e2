"""Values that differ in anything, differ; and it is said where."""

import math
from typing import Any

import numpy as np
import pytest

from uniteam.geometry import BasePose
from uniteam.interface import Decision, Detection, DiscreteAction
from uniteam.testing.difference import first_difference

ZEROS = np.zeros((2, 3), np.float32)


def decision(action: Any = DiscreteAction.STOP, reason: str = "r") -> Decision:
    return Decision(action, "S", reason)


@pytest.mark.parametrize(
    ("one", "other", "where"),
    [
        (1.0, 1.0, ""),
        (math.nan, float("nan"), ""),
        (0.0, -0.0, "it"),
        (1, 1.0, "it"),
        (ZEROS, ZEROS.copy(), ""),
        (ZEROS, -ZEROS, "it"),
        (ZEROS, ZEROS.astype(np.float64), "it"),
        (ZEROS, ZEROS.reshape(3, 2), "it"),
        (ZEROS, None, "it"),
        (BasePose(1.0, 2.0, 3.0), BasePose(1.0, 2.0, 3.5), "it.heading"),
        (decision(), decision(), ""),
        (decision(), decision(reason="q"), "it.reason"),
        (decision(), decision(action="stop"), "it.action"),
        ((1, 2), (1, 2, 3), "it"),
        ([(1, ZEROS)], [(1, ZEROS + 1)], "it[0][1]"),
        (Detection((("cup", 0.5),), ZEROS[0]), Detection((("cup", 0.5),), ZEROS[0] + 1), "it.embedding"),
    ],
)
def test_the_first_difference_is_found_to_the_bit(one: Any, other: Any, where: str) -> None:
    assert first_difference(one, other, "it") == where
