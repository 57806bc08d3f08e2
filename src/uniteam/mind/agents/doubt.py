"""Whether the robot doubts that what it stands before is what it was asked for."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from uniteam.mind.perception.vocabulary import ClassRole, roles_of
from uniteam.mind.skills.view import View

Doubt = Callable[[View, ClassRole], bool]
"""From what the robot sees and the role of what it is about to act on to whether it looks again from another side."""


def trust_what_is_seen(view: View, role: ClassRole) -> bool:
    """Doubt nothing, as HomeRobot."""
    return False


@dataclass(frozen=True)
class BelowScore:
    """Doubts what no detection in view is sure enough to be.

    Attributes:
        sure: the score from which on a detection of a role is not doubted; of a role that is left out none is.
    """

    sure: Mapping[ClassRole, float] = field(
        default_factory=lambda: {ClassRole.OBJECT: 0.3, ClassRole.GOAL_RECEPTACLE: 0.8}
    )

    def __call__(self, view: View, role: ClassRole) -> bool:
        """Return whether the best score of the role in view is too low."""
        detections = view.segmentation.detections
        scores = (d.candidates[0][1] for d in detections if role in roles_of(d, view.instruction))
        return role in self.sure and max(scores, default=0.0) < self.sure[role]
