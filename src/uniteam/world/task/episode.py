"""An episode: which home, where the robot starts, what it is asked, and what would count as done."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from hashlib import sha256

import numpy as np

from uniteam.geometry import BasePose, Point2
from uniteam.interface import Instruction, Joints
from uniteam.stretch import MANIPULATION_POSTURE
from uniteam.world.homes.home import Home
from uniteam.world.homes.serialization import home_digest
from uniteam.world.task.tags import Tags

MAXIMUM_STEPS = 1250
"""Of an episode, as in the challenge."""


@dataclass(frozen=True)
class Candidate:
    """An instance that counts, and where the base may stand to see it.

    Attributes:
        name: of the instance in the home.
        view_points: (x, y) on the floor (m, world); reachable, within 1 m of the instance's footprint, and it is seen
            from there.
    """

    name: str
    view_points: tuple[Point2, ...]


@dataclass(frozen=True)
class Certificate:
    """One way to solve an episode, tried in the simulator when the episode was made.

    Attributes:
        object: name of the candidate object that was grasped.
        grasp: where the base stood (world) before it entered manipulation mode and grasped.
        receptacle: name of the goal receptacle it was put on.
        release: where the base stood (world) before it entered manipulation mode and placed.
        release_joints: at which the object was released.
        grasp_joints: at which it was grasped.
        release_rise: how much higher (m) the gripper came over the place before it was lowered to release.
    """

    object: str
    grasp: BasePose
    receptacle: str
    release: BasePose
    release_joints: Joints
    grasp_joints: Joints = MANIPULATION_POSTURE
    release_rise: float = 0.0


@dataclass(frozen=True)
class Episode:
    """One task in one home.

    Attributes:
        id: unique in its split.
        home: name of the home.
        start: where the base stands at first (world).
        instruction: what is asked.
        objects: the objects that count: of the object class, lying on an instance of the start class.
        start_receptacles: names of the receptacles of the start class that hold a candidate object.
        goal_receptacles: every instance of the goal class that can be reached.
        unseen: whether the object's class occurs in no training home.
        seed: of every random choice made while it is played.
        certificate: how it was solved when it was made; None in an episode that nobody certified.
        tags: what makes it easy or hard; None in an episode that nobody measured.
    """

    id: str
    home: str
    start: BasePose
    instruction: Instruction
    objects: tuple[Candidate, ...]
    start_receptacles: tuple[str, ...]
    goal_receptacles: tuple[Candidate, ...]
    unseen: bool
    seed: int
    certificate: Certificate | None = None
    tags: Tags | None = None


@dataclass(frozen=True)
class Split:
    """Named episodes and the homes they are played in.

    Attributes:
        name: of the split.
        episodes: in their order.
        homes: by their names.
        version: which making of the split it is; results of one do not compare with those of another.
    """

    name: str
    episodes: tuple[Episode, ...]
    homes: Mapping[str, Home]
    version: int = 1

    @cached_property
    def digest(self) -> str:
        """A SHA-256 of all that results depend on: the version, the episodes in order, and the homes with libraries."""
        together = sha256(str(self.version).encode())
        for episode in self.episodes:
            candidates = (*episode.objects, *episode.goal_receptacles)
            names = [[c.name for c in part] for part in (episode.objects, episode.goal_receptacles)]
            rest = replace(episode, objects=(), goal_receptacles=())
            together.update(sha256(repr((rest, names)).encode()).digest())
            for candidate in candidates:
                together.update(sha256(np.array(candidate.view_points, np.float64).tobytes()).digest())
        for name in sorted({episode.home for episode in self.episodes}):
            together.update(sha256(repr((name, home_digest(self.homes[name]))).encode()).digest())
        return together.hexdigest()
