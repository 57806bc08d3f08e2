"""The rules in their order: the first that finds something decides, so that an episode has one cause."""

from uniteam.evaluation.causes.finding import Finding, Rule
from uniteam.evaluation.causes.rules import end_rules, pick_rules, place_rules, search_rules
from uniteam.evaluation.causes.story import Story

RULES: tuple[Rule, ...] = (
    # what is not the robot's doing
    end_rules.crashed,
    end_rules.moved_alone,
    # the object lies where it should, and it does not count
    end_rules.touched_wall,
    end_rules.touched,
    end_rules.done_from_elsewhere,
    end_rules.never_still,
    end_rules.pushed_into,
    end_rules.contact_not_counted,
    end_rules.stopped_early,
    # it let go, or grasped, where it could get to
    search_rules.shut_out,
    # the object was let go of, and lies elsewhere
    place_rules.through_wall,
    place_rules.wrong_receptacle,
    place_rules.onto_another,
    place_rules.too_high,
    place_rules.collided,
    place_rules.too_small,
    place_rules.cluttered,
    place_rules.fell_through,
    place_rules.fell_off,
    place_rules.too_large,
    place_rules.beside,
    # it was grasped at in vain
    pick_rules.took_another,
    pick_rules.grasped_at_another,
    pick_rules.out_of_reach,
    pick_rules.out_of_view,
    # object or receptacle was not found, or not got to
    search_rules.not_recognised,
    search_rules.narrow_passage,
    search_rules.stuck,
    search_rules.gave_up,
    search_rules.never_seen,
    search_rules.receptacle_never_found,
    search_rules.not_reached,
    # nothing of all this
    end_rules.time_ran_out,
)


def decide(story: Story) -> Finding:
    """Return why an episode that is no overall success failed."""
    return next(finding for finding in (rule(story) for rule in RULES) if finding is not None)
