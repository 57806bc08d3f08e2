"""The whole task as a Gymnasium environment."""

from typing import Any

from uniteam.adapters.gymnasium.task_env import TaskEnv
from uniteam.adapters.gymnasium.tasks.ovmm import ovmm
from uniteam.world.task.grasp_rules import grasp_rule_named


class OvmmEnv(TaskEnv):
    """Move an object from a receptacle to another, in at most 1,250 steps.

    Actions are the challenge's discrete ones, columns with `actions="continuous"`, or with `actions="metric"` the
    numbers that datasets of demonstrations hold.
    """

    def __init__(self, grasp: str = "challenge", **options: Any) -> None:
        """Take a rule by which the gripper takes objects, by its name, and what `TaskEnv` takes beside its task.

        Raises:
            UnknownNameError: there is no such rule; and what `TaskEnv` raises.
        """
        super().__init__(ovmm(grasp_rule_named(grasp)), **options)
