"""Episodes as rules of failures look at them, told by hand."""

from typing import Any

from uniteam.evaluation.causes.story import Grasp, Phase, Release, Story, Target
from uniteam.interface import Instruction
from uniteam.world.task.measures import Measures


def target(name: str = "cup_1", **facts: Any) -> Target:
    """Return an instance that was in view and known, and not come near to."""
    usual: dict[str, Any] = dict(
        seen_at=10, seen_for=20, most_pixels=500, recognised_at=12, taken_for="", nearest=3.0, nearest_at=100,
        place=(5.0, 5.0),
    )  # fmt: skip
    return Target(name, **{**usual, **facts})


def unseen(name: str = "cup_1", **facts: Any) -> Target:
    """Return an instance that was never in view."""
    return target(name, **{"seen_at": None, "seen_for": 0, "most_pixels": 3, "recognised_at": None, **facts})


def grasp(**facts: Any) -> Grasp:
    """Return an attempt that should have taken the cup."""
    usual: dict[str, Any] = dict(
        step=200,
        nearest="cup_1",
        distance=0.5,
        is_in_view=True,
        believed="cup_1",
        is_of_class=True,
        took=None,
        place=(4.0, 4.0),
    )
    return Grasp(**{**usual, **facts})


def release(**facts: Any) -> Release:
    """Return a release above the middle of a table, after which the cup lies on the floor."""
    usual: dict[str, Any] = dict(
        step=300, name="cup_1", place=(2.0, 2.0), bottom=0.9, side=0.1, arm=0.3, highest=1.1, touched=None,
        goal="table_1", to_goal=0.0, goal_lowest=0.75, goal_highest=0.75, goal_side=1.2, above=None,
        is_wall_between=False, believed="table_1", rests_on=("floor",), rests_at=(2.0, 2.8, 0.05), is_over_goal=False,
        stay_steps=60, rest_steps=0, has_fallen_through=False,
    )  # fmt: skip
    return Release(**{**usual, **facts})


def story(**facts: Any) -> Story:
    """Return an episode that ran out of steps on the way to a cup that it knew of."""
    usual: dict[str, Any] = dict(
        instruction=Instruction("cup", "counter", "table"), measures=Measures(num_steps=1250), traceback="",
        phases=(Phase("FIND_OBJECT", 0, 900), Phase("NAVIGATE_TO_OBJECT", 901, 1249)), last_words="I drive there.",
        end=(1.0, 1.0), objects=(target(),), receptacles=(unseen("table_1"),), way=1.2,
    )  # fmt: skip
    return Story(**{**usual, **facts})


def placing(*, measures: Measures | None = None, **facts: Any) -> Story:
    """Return an episode that let go of the cup, which missed the table."""
    measures = measures or Measures(True, True, True, False, 0, 400, True)
    return story(measures=measures, taken_at=200, release=release(**facts), receptacles=(target("table_1"),))
