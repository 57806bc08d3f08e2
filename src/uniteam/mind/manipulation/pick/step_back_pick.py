"""Drawing back at the pick: what to do when the object was seen from farther away (`step_back_pick`).

Close to a shelf the board above hides what lies on the one below, and close to a basin its rim what lies in it.
"""

from dataclasses import dataclass

from uniteam.interface import DiscreteAction
from uniteam.mind.manipulation.leave_manipulation import fold_and_turn_back
from uniteam.mind.manipulation.pick.pick import Prepare, do_nothing, object_points
from uniteam.mind.skills.skill import Skill, discrete, drive
from uniteam.mind.skills.view import View


@dataclass(frozen=True)
class StepBack:
    """Drives backwards from what it faced until the object is in view again.

    Attributes:
        step: of the drive (m).
        most_steps: how often to drive; then the object may be beyond the gripper's reach.
        look: how to look for the object after each.
    """

    step: float = 0.15
    most_steps: int = 2
    look: Prepare = do_nothing

    def __call__(self, view: View) -> Skill[View]:
        """Answer with the first view of the object, or with the last view."""
        for _ in range(self.most_steps):
            if len(object_points(view)):
                break
            view = yield from fold_and_turn_back(view, "The object is not in view of the arm; I fold it to draw back.")
            view = yield drive(-self.step, f"I draw back by {self.step:.2f} m.")
            view = yield discrete(DiscreteAction.MANIPULATION_MODE, "I point the arm at the object again.")
            view = yield from self.look(view)
        return view
