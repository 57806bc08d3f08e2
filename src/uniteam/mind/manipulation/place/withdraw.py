"""What the arm does once it has let go: lift and retract, or nothing (`still_arm`)."""

from dataclasses import replace

from uniteam.mind.skills.skill import Skill, move_joints
from uniteam.mind.skills.view import View
from uniteam.stretch import JOINT_LIMITS


def lift_and_retract(view: View) -> Skill[View]:
    """Raise the lift to the top, then draw the arm in, whatever is there: HomeRobot's end of a place."""
    raised = replace(view.observation.joints, lift=JOINT_LIMITS[1].lift)
    view = yield from move_joints(view, raised, "I raise the arm from what I have put down.")
    return (yield from move_joints(view, replace(raised, arm=0.0), "I draw the arm in."))


def stay(view: View) -> Skill[View]:
    """Leave the arm where it is, where it touches nothing."""
    yield from ()
    return view
