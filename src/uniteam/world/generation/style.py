"""The styles in which homes are made: a style is all that a seed does not decide.

`TIDY` homes are kept as a robot would like them; `LIVED_IN` homes are larger, fuller and narrower, as
people leave them.
"""

from collections.abc import Callable
from dataclasses import dataclass

from numpy.random import Generator

from uniteam.errors import UnknownNameError
from uniteam.world.generation.furniture.furnishing import FurnishingStyle
from uniteam.world.generation.furniture.leaves import fold_back, leave_as_used
from uniteam.world.generation.furniture.lived_in_rules import LIVED_IN_RULES
from uniteam.world.generation.furniture.rules import RULES
from uniteam.world.generation.objects.litter import no_litter, scatter_litter
from uniteam.world.generation.objects.scatter import Clutter, anywhere, often_beside
from uniteam.world.generation.objects.stock import ObjectStock
from uniteam.world.generation.passable import is_passable, is_roomy
from uniteam.world.generation.plan.floor_plan import draw_floor_plan
from uniteam.world.generation.plan.large_plan import draw_large_plan
from uniteam.world.generation.plan.planned_room import FloorPlan
from uniteam.world.homes.home import Home, Instance


@dataclass(frozen=True)
class HomeStyle:
    """How homes are planned, furnished and used.

    Attributes:
        name: what the style is called.
        prefix: of its homes' numbers in their names.
        draw_plan: draws the rooms.
        door_widths: those that a door may have (cm).
        furnishing: how rooms are furnished.
        clutter: the objects that lie about on furniture.
        litter: returns what lies on the floor of a furnished home.
        is_sound: whether the robot gets about in a home well enough; one where it does not is drawn again.
    """

    name: str
    prefix: str
    draw_plan: Callable[[Generator], FloorPlan]
    door_widths: tuple[int, ...]
    furnishing: FurnishingStyle
    clutter: Clutter
    litter: Callable[[Home, ObjectStock, Generator], tuple[Instance, ...]]
    is_sound: Callable[[Home], bool]


TIDY = HomeStyle(
    name="tidy",
    prefix="",
    draw_plan=draw_floor_plan,
    door_widths=(90, 95, 100),
    furnishing=FurnishingStyle(RULES, door_depth=70, hang_doors=fold_back, is_kept_in_reach=lambda rng: True),
    clutter=Clutter(
        fewest=20, wanted=(28, 55), more_per_room=0, highest=1.25, most_on_one=7, bare_share=0.2, per_area=6.0,
        edge=0.015, spot=anywhere, fitting=0.4, frequent=0.2,
    ),
    litter=no_litter,
    is_sound=is_roomy,
)  # fmt: skip

LIVED_IN = HomeStyle(
    name="lived_in",
    prefix="lived_in-",
    draw_plan=draw_large_plan,
    door_widths=(76, 78, 80, 84, 86, 88, 90, 95),
    furnishing=FurnishingStyle(
        LIVED_IN_RULES, door_depth=56, hang_doors=leave_as_used, is_kept_in_reach=lambda rng: bool(rng.random() < 0.85)
    ),
    clutter=Clutter(
        fewest=50, wanted=(40, 76), more_per_room=6, highest=1.5, most_on_one=14, bare_share=0.12, per_area=11.0,
        edge=0.005, spot=often_beside, fitting=0.65, frequent=0.22,
    ),
    litter=scatter_litter,
    is_sound=is_passable,
)  # fmt: skip

STYLES = {style.name: style for style in (TIDY, LIVED_IN)}


def style_of(name: str) -> HomeStyle:
    """Return the style of a name; raises UnknownNameError."""
    if name not in STYLES:
        raise UnknownNameError("style of homes", name, STYLES)
    return STYLES[name]
