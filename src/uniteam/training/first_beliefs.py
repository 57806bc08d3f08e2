"""From which score on to believe: fitted to whole searches, since an agent acts upon the first thing that it believes.

An agent that is told the truth plays episodes of training homes, and what a perception says beside it is noted, with
whether it was right. A threshold is good where the first thing that it lets through in an episode is right.
"""

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.episode_loop import play_episode
from uniteam.files import write_whole
from uniteam.interface import Instruction, Observation, Perception, Segmentation
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
from uniteam.mind.perception.instance_memory import Remember
from uniteam.mind.perception.threshold_file import THRESHOLD_FILE
from uniteam.mind.perception.truth import TruthPerception
from uniteam.mind.perception.vocabulary import ClassRole, class_names
from uniteam.world.task.environment import Environment

MATCH = 0.3
"""Intersection over union with a thing of the class from which on a detection is right."""
FARTHEST = {ClassRole.OBJECT: 3.5, ClassRole.START_RECEPTACLE: 3.5, ClassRole.GOAL_RECEPTACLE: 10.0}
"""m, up to which the map takes a detection in."""
_GRID = np.round(np.arange(0.05, 0.96, 0.025), 3)
_BESIDE = 0.15
"""m over the floor, from a start receptacle up to which an object is taken to lie on it."""


@dataclass(frozen=True)
class Belief:
    """A detection for a role, in the order of an episode: its score, and whether it was right."""

    score: float
    is_right: bool


Beliefs = Mapping[ClassRole, Sequence[Belief]]


class BesideTheTruth:
    """The truth for the agent, and notes of what another perception would have said."""

    needs_truth = True

    def __init__(self, other: Perception, remember: Remember) -> None:
        """Take the other perception, and what comes of its frames."""
        self._other, self._remember = other, remember
        self._truth = TruthPerception()
        self._instruction = Instruction("", "", "")
        self.beliefs: dict[ClassRole, list[Belief]] = {role: [] for role in ClassRole}

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Begin an episode."""
        self._instruction = instruction
        self._truth.reset(instruction, seed)
        self._other.reset(instruction, seed)

    def perceive(self, observation: Observation) -> Segmentation:
        """Return the truth, and note what the other makes of the frame."""
        truth = self._truth.perceive(observation)
        said = self._remember(self._other.perceive(observation), observation, self._instruction)
        roles = (ClassRole.GOAL_RECEPTACLE,) if observation.is_holding else tuple(ClassRole)
        for role in roles:
            self.beliefs[role] += _beliefs(role, said, truth, observation, self._instruction)
        return truth


def watch_search(environment: Environment, config: AgentConfig, other: Perception, remember: Remember) -> Beliefs:
    """Play an environment's episode with the truth, and return what another perception said on the way."""
    beside = BesideTheTruth(other, remember)
    play_episode(environment, HeuristicAgent(config, beside))
    return beside.beliefs


def best_thresholds(episodes: Sequence[Beliefs]) -> dict[ClassRole, tuple[float, float]]:
    """Return for each role the threshold of which the first belief is right most often, and how often it is."""
    found = {}
    for role in ClassRole:
        shares = [share_right_first([episode[role] for episode in episodes], float(t)) for t in _GRID]
        best = max(shares)
        middle = [float(t) for t, share in zip(_GRID, shares, strict=True) if share == best]
        found[role] = (middle[len(middle) // 2], best)
    return found


def write_thresholds(path: Path, found: Mapping[ClassRole, tuple[float, float]]) -> None:
    """Write the file that `class_thresholds` reads: the package's own with other thresholds; raises UnwritableError."""
    by_role = {role.name.lower(): threshold for role, (threshold, _) in found.items()}
    content = {**json.loads(THRESHOLD_FILE.read_text(encoding="utf-8")), "by_role": by_role, "by_class": {}}
    write_whole(path, (json.dumps(content, indent=2) + "\n").encode())


def share_right_first(episodes: Sequence[Sequence[Belief]], threshold: float) -> float:
    """Return the share of episodes in which the first detection with at least a score is right."""
    firsts = (next((b.is_right for b in beliefs if b.score >= threshold), False) for beliefs in episodes)
    return float(np.mean([*firsts])) if episodes else 0.0


def _beliefs(
    role: ClassRole, said: Segmentation, truth: Segmentation, observation: Observation, instruction: Instruction
) -> list[Belief]:
    name = class_names(instruction)[role]
    right = _masks(truth, name)
    ground = _near_start(truth, observation, instruction) if role is ClassRole.OBJECT else None
    found = []
    for index, detection in enumerate(said.detections):
        mask = said.instances == index
        depth = observation.depth[mask]
        if detection.name != name or depth.size == 0 or np.median(depth) > FARTHEST[role]:
            continue
        if ground is not None and not ground(mask):
            continue
        found.append(Belief(detection.score, any(_overlap(mask, other) >= MATCH for other in right)))
    return found


def _masks(segmentation: Segmentation, name: str) -> list[NDArray[np.bool_]]:
    """Return the masks of what bears a name."""
    return [
        segmentation.instances == i for i, detection in enumerate(segmentation.detections) if detection.name == name
    ]


def _overlap(one: NDArray[np.bool_], other: NDArray[np.bool_]) -> float:
    return float(np.count_nonzero(one & other)) / max(1, int(np.count_nonzero(one | other)))


def _near_start(
    truth: Segmentation, observation: Observation, instruction: Instruction
) -> Callable[[NDArray[np.bool_]], bool]:
    """Return whether what a mask shows lies over, or beside, what is seen of the start receptacles."""
    camera, depth = observation.camera, observation.depth
    points = camera.unproject(depth) @ observation.camera_to_start[:3, :3].T + observation.camera_to_start[:3, 3]
    start = np.zeros(depth.shape, dtype=np.bool_)
    for mask in _masks(truth, instruction.start_receptacle):
        start |= mask
    on_start = points[start & (depth > 0), :2]

    def is_near(mask: NDArray[np.bool_]) -> bool:
        if len(on_start) == 0:
            return False
        middle = np.median(points[mask & (depth > 0), :2], axis=0) if (mask & (depth > 0)).any() else np.full(2, 1e9)
        return bool(np.hypot(*(on_start - middle).T).min() <= _BESIDE)

    return is_near
