"""Named changes that no built-in agent has: other ways to do a thing, for bodies or rules that need them."""

from uniteam.mind.agents.improvement import Improvement, replacing
from uniteam.mind.manipulation.pick.arm_grasp import ArmGrasp

OTHER_WAYS: tuple[Improvement, ...] = (
    replacing(
        "arm_grasp",
        "the open gripper is lowered around the object, closed, and lifted, instead of snapping from afar",
        pick__take=ArmGrasp(),
    ),
)
"""Worth nothing where the gripper snaps; needed where it does not (`--grasp arm`, a real robot)."""
