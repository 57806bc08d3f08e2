"""Rules of episodes that did not fail by what the robot could not do: a crash, the world, what does not count."""

from uniteam.evaluation.causes.cause import Cause
from uniteam.evaluation.causes.finding import Finding
from uniteam.evaluation.causes.story import Story
from uniteam.world.task.judge import REST_STEPS

WALL = "wall"
SETTLED_STEPS = REST_STEPS // 2
"""What has lain still for so many steps to the end has come to rest, and does not tremble."""


def crashed(story: Story) -> Finding | None:
    """The agent raised an exception, or used up its time."""
    if not story.traceback:
        return None
    return Finding(Cause.CRASHED, story.last_step, None, story.traceback.strip().splitlines()[-1])


def moved_alone(story: Story) -> Finding | None:
    """An object that counts was moved before the robot had touched anything."""
    if story.moved_alone is None:
        return None
    words = f"{story.moved_alone} moved before the robot had touched anything"
    return Finding(Cause.WORLD, 0, None, words)


def touched_wall(story: Story) -> Finding | None:
    """The object was placed, but arm or gripper touched a wall first of all."""
    return _touched(story, Cause.AGAINST_WALL) if story.touches and story.touches[0].what == WALL else None


def touched(story: Story) -> Finding | None:
    """The object was placed, but arm or gripper touched something."""
    return _touched(story, Cause.COLLIDED)


def done_from_elsewhere(story: Story) -> Finding | None:
    """The object lies where it should, but a phase before was not counted: the robot stood at no view point."""
    release, measures = story.release, story.measures
    if release is None or not story.is_placed or release.rest_steps < REST_STEPS or measures.find_recep_phase_success:
        return None
    which = "an object" if not measures.pick_object_phase_success else "the receptacle"
    words = f"{release.name} lies on the goal, but {which} was never in view from one of its view points before"
    return Finding(Cause.NOT_COUNTED, release.step, release.place, words)


def never_still(story: Story) -> Finding | None:
    """The object stayed where it should be for long enough, and trembled, so that it counted as moving."""
    release, measures = story.release, story.measures
    if release is None or not story.is_placed or not release.is_over_goal or release.stay_steps < REST_STEPS:
        return None
    if measures.place_success or not measures.find_recep_phase_success or release.rest_steps >= SETTLED_STEPS:
        return None
    if release.rests_on is not None and not release.rest_steps:  # still, on another thing
        return None
    words = f"{release.name} stayed on {release.goal} for {release.stay_steps} steps, still for {release.rest_steps}"
    return Finding(Cause.WORLD, release.step, release.place, words)


def pushed_into(story: Story) -> Finding | None:
    """The object was pushed into the receptacle below its lowest surface, and lies in it."""
    release = story.release
    if release is None or not story.is_placed or not release.rest_steps or story.measures.place_success:
        return None
    if release.touched is None or release.bottom >= release.goal_lowest:
        return None
    words = (
        f"touched {release.touched}, and let go at {release.bottom:.2f} m in {release.goal}, whose lowest surface is "
        f"{release.goal_lowest:.2f} m high"
    )
    return Finding(Cause.COLLIDED, release.step, release.place, words)


def contact_not_counted(story: Story) -> Finding | None:
    """The object lies still on a goal receptacle and all phases were counted, but the contact was not."""
    release = story.release
    if release is None or not story.is_placed or release.rest_steps < REST_STEPS or story.measures.place_success:
        return None
    words = f"{release.name} lay on {release.goal} for {release.rest_steps} steps at a contact that does not count"
    return Finding(Cause.WORLD, release.step, release.place, words)


def stopped_early(story: Story) -> Finding | None:
    """The episode ended while the object was on a goal receptacle, but it had not yet lain there long enough."""
    release = story.release
    if release is None or not story.is_placed or not release.is_on_goal or release.rest_steps >= REST_STEPS:
        return None
    words = f"{release.name} had lain still on the goal for {release.rest_steps} of {REST_STEPS} steps at the end"
    return Finding(Cause.STOPPED_EARLY, story.last_step, release.place, words)


def _touched(story: Story, cause: Cause) -> Finding | None:
    if not story.measures.place_success or not story.touches:
        return None
    first, count = story.touches[0], len(story.touches)
    words = f"arm or gripper touched {first.what} in {first.state}; {count} step{'s'[: count != 1]} with a touch"
    return Finding(cause, first.step, first.place, words)


def time_ran_out(story: Story) -> Finding | None:
    """Nothing else explains it: the steps were used up, or the agent stopped."""
    cause = Cause.GAVE_UP if story.measures.does_want_terminate else Cause.TIME_RAN_OUT
    words = f"ended in {story.state}: {story.last_words}"
    return Finding(cause, story.last_step, story.end, words)
