"""An episode: which home, where the robot starts, what it is asked, and what would count as done."""

from dataclasses import dataclass

from uniteam.geometry import BasePose
from uniteam.interface import Instruction
from uniteam.world.assets.catalogue import Point2
from uniteam.world.homes.home import Home


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
class Episode:
    """One certified task in one home.

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


@dataclass(frozen=True)
class Split:
    """Named episodes and the homes they are played in."""

    name: str
    episodes: tuple[Episode, ...]
    homes: dict[str, Home]
