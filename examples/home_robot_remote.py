"""Have HomeRobot's own agent evaluated by `uniteam serve NAME`: run this in HomeRobot's environment, with its Python.

With this file and uniteam_client.py in the folder projects/habitat_ovmm of its repository, at the repository's top:

    python projects/habitat_ovmm/home_robot_remote.py 127.0.0.1:8085

What is mapped is what its heuristic skills and Detic use; its learned skills need more (see `observations_of`).
"""

from __future__ import annotations

import random
import sys
from typing import Any

import numpy as np
import uniteam_client
from home_robot.core.interfaces import (
    ContinuousFullBodyAction,
    ContinuousNavigationAction,
    DiscreteNavigationAction,
    Observations,
)

NOTHING_RETURNED = 10001
"""What HomeRobot's maps take for a depth beyond the camera's range (m)."""
ARM_SEGMENTS = 4
"""HomeRobot's joint sensor has a number for each segment of the arm, which share its extension."""


class HomeRobotAgent:
    """An agent with HomeRobot's `reset()` and `act(observations)`, such as `OpenVocabManipAgent`."""

    def __init__(self, agent: Any) -> None:
        self._agent = agent

    def reset(self, instruction: uniteam_client.Instruction, seed: int) -> None:
        """Begin an episode; a learned agent seeds torch here, too."""
        random.seed(seed)
        np.random.seed(seed % 2**32)
        self._instruction = instruction
        self._agent.reset()

    def act(self, observation: uniteam_client.Observation) -> uniteam_client.Decision:
        """Return what the agent decides, with the skill that it is in."""
        action, info, _ = self._agent.act(observations_of(self._instruction, observation))
        return uniteam_client.Decision(action_of(action), info.get("curr_skill", "HOME_ROBOT"), "HomeRobot decided so")


def observations_of(instruction: uniteam_client.Instruction, observation: uniteam_client.Observation) -> Observations:
    """Return an observation in HomeRobot's words.

    Left out is what only its learned skills read: `object_embedding`, the numbers of the receptacles' classes and
    `relative_resting_position`; and the true segmentation, so that the configuration needs GROUND_TRUTH_SEMANTICS 0.
    """
    base, is_holding = observation.base_to_start, np.array([float(observation.is_holding)], np.float32)
    return Observations(
        gps=np.array([base.x, base.y], np.float32),
        compass=np.array([base.heading], np.float32),
        rgb=observation.rgb.copy(),
        depth=np.where(observation.depth > 0.0, observation.depth, np.float32(NOTHING_RETURNED)),
        camera_pose=camera_pose_of(observation.camera_to_start),
        joint=joint_of(observation.joints),
        is_holding=is_holding,
        task_observations={
            "goal_name": str(instruction),
            "object_name": instruction.object_category,
            "start_recep_name": instruction.start_receptacle,
            "place_recep_name": instruction.goal_receptacle,
            "object_goal": 1,
            "start_recep_goal": -1,
            "end_recep_goal": -1,
            "prev_grasp_success": is_holding,
        },
    )


def camera_pose_of(camera_to_start: np.ndarray) -> np.ndarray:
    """Return the (4, 4) pose of the camera as HomeRobot's maps read it: its axes point back, right and up."""
    pose = camera_to_start.astype(np.float32)
    right, down, forward = (pose[:3, column].copy() for column in range(3))
    pose[:3, 0], pose[:3, 1], pose[:3, 2] = -forward, right, -down
    return pose


def joint_of(joints: uniteam_client.Joints) -> np.ndarray:
    """Return the (10,) joints in HomeRobot's order: arm segments, lift (m), wrist yaw, pitch, roll, head pan, tilt."""
    arm = [joints.arm / ARM_SEGMENTS] * ARM_SEGMENTS
    wrist = [joints.wrist_yaw, joints.wrist_pitch, joints.wrist_roll]
    return np.array([*arm, joints.lift, *wrist, joints.head_pan, joints.head_tilt], np.float32)


def action_of(action: Any) -> uniteam_client.Action:
    """Return one of HomeRobot's actions in uniteam's words.

    A discrete action that Habitat's environment does not know, such as POST_NAV_MODE, lets a step pass there and here.
    """
    if isinstance(action, DiscreteNavigationAction):
        name = action.name.lower()
        return name if name in uniteam_client.DISCRETE_ACTIONS else "empty_action"
    if isinstance(action, ContinuousNavigationAction):
        return base_of(action.xyt)
    if isinstance(action, ContinuousFullBodyAction):
        # of the four numbers of the arm the first is the displacement of its whole extension
        arm, _, _, _, lift, yaw, pitch, roll, pan, tilt = (float(number) for number in action.joints)
        return uniteam_client.JointDisplacement(
            uniteam_client.Joints(lift, arm, yaw, pitch, roll, pan, tilt), base_of(action.xyt)
        )
    raise TypeError(f"HomeRobot's agent returned {type(action).__name__}, which is none of its actions")


def base_of(xyt: Any) -> uniteam_client.BaseDisplacement:
    """Return a displacement of the base; none where HomeRobot gives none."""
    return uniteam_client.BaseDisplacement(*(float(number) for number in (xyt if xyt is not None else (0, 0, 0))))


def make_agent() -> Any:
    """Return HomeRobot's agent with the configuration of its own evaluation, as eval_baselines_agent.py makes it."""
    from home_robot.agent.ovmm_agent.ovmm_agent import OpenVocabManipAgent
    from utils.config_utils import create_agent_config, create_env_config, get_habitat_config, get_omega_config

    habitat, _ = get_habitat_config("ovmm/ovmm_eval.yaml", overrides=[])
    environment = get_omega_config("projects/habitat_ovmm/configs/env/hssd_eval.yaml", overrides=[])
    agent = get_omega_config("projects/habitat_ovmm/configs/agent/heuristic_agent.yaml", overrides=[])
    merged = create_agent_config(create_env_config(habitat, environment, evaluation_type="remote"), agent)
    return OpenVocabManipAgent(merged)


if __name__ == "__main__":
    for played in uniteam_client.play(HomeRobotAgent(make_agent()), sys.argv[1], wait=600.0):
        sys.stdout.write(f"{played.id}: {played.failure or 'success'}\n")
