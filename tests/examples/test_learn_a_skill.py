"""The example of a learner steps a vector of environments as its first lines say."""

import math
from pathlib import Path

import pytest


def test_a_random_policy_steps_the_vector_and_episodes_end(tidy_loft: Path) -> None:
    learn_a_skill = pytest.importorskip("learn_a_skill", reason="the extra 'gym' is not installed")
    reward, ends = learn_a_skill.collect(str(tidy_loft), workers=2, steps=40)
    assert math.isfinite(reward)
    assert -2.0 < reward < 10.0
    assert ends > 0
