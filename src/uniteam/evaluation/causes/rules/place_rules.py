"""Rules of an object that was let go of and does not lie where it should."""

from uniteam.evaluation.causes.cause import Cause
from uniteam.evaluation.causes.finding import Finding, spoken
from uniteam.evaluation.causes.story import Release, Story
from uniteam.stretch import JOINT_LIMITS

FLOOR = "floor"
AT_THE_RECEPTACLE = 0.6
"""Of an object that was let go of farther from every goal receptacle (m), another place was taken for one."""
ARM_OUT = JOINT_LIMITS[1].arm - 0.02
"""An arm that is extended so far (m) reaches no farther."""


def through_wall(story: Story) -> Finding | None:
    """A wall is between the base and what it let go of, or between that and the receptacle."""
    release = _missed(story)
    if release is None or not release.is_wall_between:
        return None
    words = f"a wall is between the robot, {release.name} where it was let go of, and {release.goal}"
    return _found(Cause.AGAINST_WALL, release, words)


def wrong_receptacle(story: Story) -> Finding | None:
    """The object was let go of far from every goal receptacle, or lies on what was taken for one."""
    release = _missed(story)
    if release is None:
        return None
    is_on_it = release.believed != release.goal and release.believed in (release.rests_on or ())
    if release.to_goal <= AT_THE_RECEPTACLE and not is_on_it:
        return None
    where = f"let go {release.to_goal:.1f} m from the nearest goal, {release.goal}"
    taken = f"; {release.believed} was taken for a {spoken(story.instruction.goal_receptacle)}"
    return _found(Cause.WRONG_RECEPTACLE, release, where + (taken if release.believed else ""))


def onto_another(story: Story) -> Finding | None:
    """In the end the object lies on something that is neither the floor nor a goal receptacle."""
    release = _missed(story)
    things = [] if release is None else [thing for thing in release.rests_on or () if thing not in (FLOOR, "wall")]
    if release is None or not things:
        return None
    return _found(Cause.ONTO_ANOTHER, release, f"{release.name} lies on {', '.join(things)}")


def too_high(story: Story) -> Finding | None:
    """With lift and wrist at their highest the object would still have hung lower than the lowest surface."""
    release = _missed(story)
    if release is None:
        return None
    if release.highest >= release.goal_lowest:
        return None
    words = (
        f"{release.name} can hang at {release.highest:.2f} m, and {release.goal} is {release.goal_lowest:.2f} m high"
    )
    return _found(Cause.TOO_HIGH, release, words)


def collided(story: Story) -> Finding | None:
    """Arm, gripper or load touched something right before, and the object was lower than the highest surface.

    A receptacle of several boards is run into between two of them too.
    """
    release = _missed(story)
    if release is None or release.touched is None or release.bottom >= release.goal_highest:
        return None
    words = (
        f"touched {release.touched}, and let go at {release.bottom:.2f} m, lower than {release.goal}, which is "
        f"{release.goal_highest:.2f} m high"
    )
    return _found(Cause.COLLIDED, release, words)


def too_small(story: Story) -> Finding | None:
    """The object is longer than the receptacle."""
    release = _missed(story)
    if release is None or release.side <= release.goal_side:
        return None
    words = f"{release.name} is {release.side:.2f} m long, and {release.goal} {release.goal_side:.2f} m"
    return _found(Cause.TOO_SMALL, release, words)


def cluttered(story: Story) -> Finding | None:
    """The object was let go of above another thing on the receptacle."""
    release = _missed(story)
    if release is None or release.above is None or release.to_goal > 0.0:
        return None
    return _found(Cause.CLUTTERED, release, f"let go above {release.above}, which lies on {release.goal}")


def fell_through(story: Story) -> Finding | None:
    """The object went through the receptacle, which is solid there."""
    release = _missed(story)
    if release is None or not release.has_fallen_through:
        return None
    words = f"{release.name} was let go of over {release.goal} at {release.bottom:.2f} m, and fell through it"
    return _found(Cause.WORLD, release, words)


def fell_off(story: Story) -> Finding | None:
    """The object was let go of above the receptacle, and did not stay."""
    release = _missed(story)
    if release is None or release.to_goal > 0.0:
        return None
    x, y, z = release.rests_at
    words = (
        f"let go over {release.goal} at {release.bottom:.2f} m, now at ({x:.1f}, {y:.1f}), {z:.2f} m high{_on(release)}"
    )
    return _found(Cause.FELL_OFF, release, words)


def too_large(story: Story) -> Finding | None:
    """The arm was all out and the object still not above the receptacle."""
    release = _missed(story)
    if release is None or release.arm < ARM_OUT:
        return None
    words = f"the arm was out {release.arm:.2f} m, and {release.goal} still {release.to_goal:.2f} m away"
    return _found(Cause.TOO_LARGE, release, words)


def beside(story: Story) -> Finding | None:
    """The object was let go of beside the receptacle."""
    release = _missed(story)
    if release is None:
        return None
    words = f"let go {release.to_goal:.2f} m beside {release.goal}, the arm out {release.arm:.2f} m{_on(release)}"
    return _found(Cause.BESIDE, release, words)


def _missed(story: Story) -> Release | None:
    """Return the release by which the object came to where it is; rules before have asked whether that is a goal."""
    return story.release if story.is_placed else None


def _found(cause: Cause, release: Release, words: str) -> Finding:
    return Finding(cause, release.step, release.place, words)


def _on(release: Release) -> str:
    return "" if release.rests_on is None else f", on {', '.join(release.rests_on) or 'nothing'}"
