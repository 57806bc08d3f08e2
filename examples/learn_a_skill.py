"""Step four environments of a skill with a random policy, as a learner would with its own.

pip install 'uniteam[gym]'
python learn_a_skill.py
"""

import sys
from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray

from uniteam.adapters.gymnasium.wrappers import ImageAndVector  # which registers the environments, too

STEPS = 200


def random_policy(observations: dict[str, NDArray[Any]], space: gymnasium.Space[Any]) -> Any:
    """Return an action for each environment; yours looks at the (N, 160, 120, C) images and (N, V) vectors."""
    assert len(observations["image"]) == len(observations["vector"])
    return space.sample()


def collect(split: str = "minival", workers: int = 4, steps: int = STEPS) -> tuple[float, int]:
    """Return the mean reward a step of a random policy, and how many episodes came to an end."""
    envs = gymnasium.make_vec(
        "uniteam/NavigateToObject-v0",
        num_envs=workers,
        vectorization_mode="async",
        wrappers=[ImageAndVector],
        split=split,
        actions="discrete",
    )
    observations, _ = envs.reset(seed=0)
    rewards, ends = [], 0
    for _ in range(steps):
        observations, reward, terminated, truncated, _ = envs.step(random_policy(observations, envs.action_space))
        rewards.append(reward)
        ends += int((terminated | truncated).sum())
    envs.close()
    return float(np.mean(rewards)), ends


if __name__ == "__main__":
    reward, ends = collect()
    sys.stdout.write(f"{reward:.3f} a step, {ends} episodes ended\n")
