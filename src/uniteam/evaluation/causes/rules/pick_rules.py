"""Rules of grasps that took nothing, or the wrong thing."""

from uniteam.evaluation.causes.cause import Cause
from uniteam.evaluation.causes.finding import Finding, spoken
from uniteam.evaluation.causes.story import Grasp, Story
from uniteam.stretch import GRASP_RANGE


def took_another(story: Story) -> Finding | None:
    """The gripper took what does not count."""
    wrong = [grasp for grasp in _in_vain(story) if grasp.took is not None]
    return _found(Cause.WRONG_OBJECT, wrong[-1], f"took {wrong[-1].took}") if wrong else None


def grasped_at_another(story: Story) -> Finding | None:
    """It grasped at what it took for the object, mostly with no object that counts in the picture."""
    grasps = _in_vain(story)
    wrong = [g for g in grasps if g.believed is not None and g.believed != g.nearest and not g.is_in_view]
    if len(wrong) <= sum(grasp.is_in_view for grasp in grasps):
        return None
    last = wrong[-1]
    words = (
        f"grasped at {last.believed}, taken for a {spoken(story.instruction.object_category)}; the nearest that counts,"
        f" {last.nearest}, was {last.distance:.1f} m from the gripper and out of view"
    )
    return _found(Cause.WRONG_OBJECT, last, words)


def out_of_reach(story: Story) -> Finding | None:
    """The object was in the picture at a grasp, but farther from the gripper than it takes."""
    seen = [grasp for grasp in _in_vain(story) if grasp.is_in_view and grasp.distance > GRASP_RANGE]
    if not seen:
        return None
    best = min(seen, key=lambda grasp: grasp.distance)
    words = f"{best.nearest} was {best.distance:.2f} m from the gripper, which takes what is within {GRASP_RANGE:.2f} m"
    return _found(Cause.OUT_OF_REACH, best, words)


def out_of_view(story: Story) -> Finding | None:
    """It grasped, and the object was not in the picture."""
    blind = [grasp for grasp in _in_vain(story) if not grasp.is_in_view]
    if not blind:
        return None
    best = min(blind, key=lambda grasp: grasp.distance)
    words = f"{best.nearest} was {best.distance:.2f} m from the gripper and not in the picture; {len(blind)} such tries"
    return _found(Cause.OUT_OF_VIEW, best, words)


def _in_vain(story: Story) -> tuple[Grasp, ...]:
    """Return the attempts of an episode in which no candidate object was ever taken."""
    return () if story.has_taken else story.grasps


def _found(cause: Cause, grasp: Grasp, words: str) -> Finding:
    return Finding(cause, grasp.step, grasp.place, words)
