"""The fourteen named changes that make UniTeam out of the baseline (the UniTeam report, arXiv 2312.08611)."""

from collections.abc import Iterable
from enum import Enum

from uniteam.errors import UnknownNameError


class Improvement(Enum):
    """One change of the baseline, which can be switched on and off by its name."""

    CLASS_THRESHOLDS = "class_thresholds"
    FLOOR_FILTER = "floor_filter"
    GOAL_OR_FRONTIER = "goal_or_frontier"
    SURROUND_START_RECEPTACLE = "surround_start_receptacle"
    RECEPTACLE_PROBABILITY = "receptacle_probability"
    EARLY_GOAL_MEMORY = "early_goal_memory"
    COLLISION_MAPPING = "collision_mapping"
    CENTRE_APPROACH = "centre_approach"
    LOOK_AROUND_PICK = "look_around_pick"
    VERIFY_PICK = "verify_pick"
    STEPWISE_PLACE = "stepwise_place"
    EDGE_MARGIN = "edge_margin"
    SURFACE_FALLBACK = "surface_fallback"
    DROP_HEIGHT = "drop_height"


def improvements_named(names: Iterable[str]) -> frozenset[Improvement]:
    """Return the improvements of these names; raises UnknownNameError with the nearest valid name."""
    return frozenset(_improvement_named(name) for name in names)


def _improvement_named(name: str) -> Improvement:
    try:
        return Improvement(name)
    except ValueError:
        raise UnknownNameError("improvement", name, (improvement.value for improvement in Improvement)) from None
