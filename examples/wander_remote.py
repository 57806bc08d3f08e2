"""An agent for `uniteam serve NAME` that wanders about; it needs uniteam_client.py and no other part of uniteam.

python wander_remote.py 127.0.0.1:8085
"""

from __future__ import annotations

import random
import sys

import uniteam_client


class Wanderer:
    """Drives ahead where nothing is near, turns where something is, and stops after a while."""

    def __init__(self, steps: int = 40) -> None:
        self._steps = steps

    def reset(self, instruction: uniteam_client.Instruction, seed: int) -> None:
        """Forget the last episode; all that is random comes from the seed."""
        self._dice = random.Random(seed)

    def act(self, observation: uniteam_client.Observation) -> uniteam_client.Decision:
        """Look at the middle of the depth image, and decide."""
        if observation.step >= self._steps:
            return uniteam_client.Decision("stop", "DONE", "I have wandered enough")
        height, width = observation.depth.shape
        middle = observation.depth[: height // 2, width // 3 : 2 * width // 3]
        if middle[middle > 0.0].min(initial=10.0) < 0.8:
            return uniteam_client.Decision("turn_left", "WANDER", "something is near")
        if self._dice.random() < 0.2:
            return uniteam_client.Decision("turn_right", "WANDER", "the dice say so")
        return uniteam_client.Decision("move_forward", "WANDER", "the way is free")


if __name__ == "__main__":
    for played in uniteam_client.play(Wanderer(), sys.argv[1]):
        sys.stdout.write(f"{played.id}: {played.failure or 'success'}\n")
