"""Why a proposed episode was not kept, and how often which reason was met."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import IntEnum


class Cause(IntEnum):
    """Where the attempt to solve a proposal ended; the larger, the farther it came."""

    NO_START = 0
    OBJECT_UNSEEN = 1
    GOAL_UNSEEN = 2
    OBJECT_OUT_OF_REACH = 3
    GRASP_TOUCHES = 4
    GOAL_OUT_OF_REACH = 5
    RELEASE_FAILS = 6
    NOT_SOLVED = 7

    @property
    def sentence(self) -> str:
        """What it means."""
        return _SENTENCES[self]


_SENTENCES: Mapping[Cause, str] = {
    Cause.NO_START: "no start is far enough from the object",
    Cause.OBJECT_UNSEEN: "the object is seen from nowhere that the base gets to",
    Cause.GOAL_UNSEEN: "no goal receptacle is seen from where the base gets to",
    Cause.OBJECT_OUT_OF_REACH: "the object is out of reach or of sight of every stand",
    Cause.GRASP_TOUCHES: "the arm touches something, or another thing is grasped, at every stand tried",
    Cause.GOAL_OUT_OF_REACH: "no place on a goal receptacle has room and is within reach",
    Cause.RELEASE_FAILS: "the arm touches something, or the object does not stay, at every place tried",
    Cause.NOT_SOLVED: "every part can be done, but not the whole from the start",
}


@dataclass(frozen=True)
class Rejected:
    """A proposal that was not kept."""

    cause: Cause


@dataclass
class Proposals:
    """What came of the episodes that were proposed.

    Attributes:
        certified: how many were kept.
        rejected: how many were not, by cause.
    """

    certified: int = 0
    rejected: Counter[Cause] = field(default_factory=Counter)

    @property
    def total(self) -> int:
        """How many there were."""
        return self.certified + self.rejected.total()

    def add(self, other: "Proposals") -> None:
        """Count others too."""
        self.certified += other.certified
        self.rejected.update(other.rejected)

    def lines(self) -> list[str]:
        """Return the share that was rejected, and each cause's share of all proposals, the most frequent first."""
        if not self.total:
            return ["no episode was proposed"]
        first = f"{self.rejected.total()} of {self.total} proposals rejected ({self._share(self.rejected.total())})"
        return [first, *(f"{self._share(n)} {cause.sentence}" for cause, n in self.rejected.most_common())]

    def _share(self, count: int) -> str:
        return f"{100.0 * count / self.total:.1f} %"
