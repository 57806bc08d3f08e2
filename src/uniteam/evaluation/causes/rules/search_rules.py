"""Rules of what was not found, or not got to: the object, or the receptacle once something was taken.

They are asked once no rule has found anything in a grasp, or in how the object was let go of.
"""

from math import isfinite

from uniteam.evaluation.causes.cause import Cause
from uniteam.evaluation.causes.finding import Finding
from uniteam.evaluation.causes.story import Standstill, Story, Target

NARROW = 0.80
"""m; the base is 0.60 wide, and the doors of tidy homes are 0.90."""
STILL_STEPS = 250
"""A base that does not get away from a place for so many steps is stuck there, or swings to and fro."""
CLOSE = 1.0
"""m; view points are no farther from a receptacle or an object."""
SHUT_STEPS = 10
"""A base that something is in the way of in so many steps of a standstill is kept there by it."""


def not_recognised(story: Story) -> Finding | None:
    """It was in view, large enough to be found, and never believed to be what it is."""
    seen = _seen(story)
    if not story.has_said or not seen or any(target.recognised_at is not None for target in story.sought):
        return None
    best = max(seen, key=lambda target: target.seen_for)
    taken = f"taken for {best.taken_for}" if best.taken_for else "taken for nothing"
    words = f"{best.name} was in view for {best.seen_for} steps, with up to {best.most_pixels} pixels, {taken}"
    return Finding(Cause.NOT_RECOGNISED, best.seen_at or 0, best.place, words)


def shut_out(story: Story) -> Finding | None:
    """It never got to what counts, the way there is narrow, and so it grasped, or let go, where it could get to.

    Not where it took something of another class for what was asked for, or into the gripper.
    """
    release = story.release if story.is_placed else None
    is_misled = release is not None and release.believed not in (None, release.goal)
    in_vain = () if story.has_taken else story.grasps
    if is_misled or any(grasp.took or (grasp.believed and not grasp.is_of_class) for grasp in in_vain):
        return None
    if release is None and (story.has_taken or not story.grasps):
        return None
    is_kept = story.standstill is not None and story.standstill.blocked >= SHUT_STEPS
    return narrow_passage(story) if _recognised(story) or is_kept else None


def narrow_passage(story: Story) -> Finding | None:
    """It got stuck, or did not get to what it had found, and the way there is narrow."""
    if story.way is None or story.way > NARROW or _was_close(story):
        return None
    still = _still(story)
    if still is None and not _recognised(story):
        return None
    step, place = (still.first, still.place) if still else (story.last_step, story.end)
    words = f"the widest way from there to the {story.sought_words} is {story.way:.2f} m wide, and the base 0.60 m"
    return Finding(Cause.NARROW_PASSAGE, step, place, words)


def stuck(story: Story) -> Finding | None:
    """For very many steps the base did not get away from one place."""
    still = _still(story)
    if still is None:
        return None
    words = f"within a metre for {still.steps} steps, to step {still.last}; something was in the way in {still.blocked}"
    return Finding(Cause.STUCK, still.first, still.place, words)


def gave_up(story: Story) -> Finding | None:
    """The agent stopped before it had the object, or with it in the gripper."""
    if not story.measures.does_want_terminate:
        return None
    words = f"stopped after {story.measures.num_steps} steps in {story.state}: {story.last_words}"
    return Finding(Cause.GAVE_UP, story.last_step, story.end, words)


def never_seen(story: Story) -> Finding | None:
    """The steps ran out, and no object that counts was ever large enough in the picture."""
    return None if story.has_taken else _never_seen(story, Cause.NEVER_SEEN)


def receptacle_never_found(story: Story) -> Finding | None:
    """The steps ran out with the object in the gripper, and no goal receptacle was ever in view."""
    return _never_seen(story, Cause.RECEPTACLE_NEVER_FOUND) if story.has_taken else None


def not_reached(story: Story) -> Finding | None:
    """What was found was known, and the base never came near."""
    known = _recognised(story)
    if not known or _was_close(story):
        return None
    best = min(known, key=lambda target: target.nearest)
    how_near = f"came no nearer than {best.nearest:.1f} m" if isfinite(best.nearest) else "was behind a wall from it"
    words = f"{best.name} was known from step {best.recognised_at}, and the base {how_near}"
    return Finding(Cause.NOT_REACHED, best.nearest_at, best.place, words)


def _never_seen(story: Story, cause: Cause) -> Finding | None:
    if _seen(story) or _recognised(story):
        return None
    pixels = max((target.most_pixels for target in story.sought), default=0)
    words = f"no {story.sought_words} was in view with more than {pixels} pixels; ended in {story.state}"
    return Finding(cause, story.last_step, story.end, words)


def _seen(story: Story) -> list[Target]:
    return [target for target in story.sought if target.seen_at is not None]


def _recognised(story: Story) -> list[Target]:
    return [target for target in story.sought if target.recognised_at is not None]


def _was_close(story: Story) -> bool:
    return any(target.nearest <= CLOSE for target in story.sought)


def _still(story: Story) -> Standstill | None:
    still = story.standstill
    return still if still is not None and still.steps >= STILL_STEPS else None
