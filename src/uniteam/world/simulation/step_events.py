"""What came of an action, for those who watch: the measures, the observers of an episode, the certification."""

from dataclasses import dataclass


@dataclass(frozen=True)
class StepEvents:
    """What came of one action.

    Attributes:
        blocked: whether the base stayed because something was in its way.
        hit: what the arm, the gripper or the held object met first: an instance's name, "wall", "floor" or
            None.
        grasped: the instance that was grasped, or None.
        released: the instance that was released, or None.
    """

    blocked: bool = False
    hit: str | None = None
    grasped: str | None = None
    released: str | None = None

    def then(self, later: "StepEvents") -> "StepEvents":
        """Return what came of two things that were done one after the other."""
        return StepEvents(
            self.blocked or later.blocked,
            self.hit or later.hit,
            self.grasped or later.grasped,
            self.released or later.released,
        )


NOTHING = StepEvents()
