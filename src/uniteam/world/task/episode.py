"""An episode: which home, where the robot starts, what it is asked, and what would count as done."""

from collections.abc import Mapping
from dataclasses import dataclass

from uniteam.geometry import BasePose, Point2
from uniteam.interface import Instruction, Joints
from uniteam.world.homes.home import Home

MAXIMUM_STEPS = 1250
"""Of an episode, as in the challenge."""


@dataclass(frozen=True)
class Candidate:
    """An instance that counts, and where the base may stand to see it.

    Attributes:
        name: of the instance in the home.
        view_points: (x, y) on the floor (m, world); reachable, within 1.5 m of the instance, and it is seen from there.
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
    """

    object: str
    grasp: BasePose
    receptacle: str
    release: BasePose
    release_joints: Joints


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


@dataclass(frozen=True)
class Split:
    """Named episodes and the homes they are played in."""

    name: str
    episodes: tuple[Episode, ...]
    homes: Mapping[str, Home]
