"""What came of an action, for those who watch: the measures, the observers of an episode, the certification."""

from dataclasses import dataclass

from uniteam.world.simulation.touches import NO_TOUCH, Touches


@dataclass(frozen=True)
class StepEvents:
    """What came of one action.

    Attributes:
        blocked: whether the base stayed because something was in its way.
        touches: what the arm, the gripper and the held object met.
        grasped: the instance that was grasped, or None.
        released: the instance that was released, or None.
    """

    blocked: bool = False
    touches: Touches = NO_TOUCH
    grasped: str | None = None
    released: str | None = None

    @property
    def hit(self) -> str | None:
        """What the arm, the gripper or the held object met, be it ever so small; None where they met nothing."""
        return self.touches.first

    def then(self, later: "StepEvents") -> "StepEvents":
        """Return what came of two things that were done one after the other."""
        return StepEvents(
            self.blocked or later.blocked,
            self.touches.then(later.touches),
            self.grasped or later.grasped,
            self.released or later.released,
        )


NOTHING = StepEvents()
