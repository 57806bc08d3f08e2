"""What stands in each kind of room, in the order of its importance, as rules.

A rule names a kind of furniture, how to arrange it, how likely it is, how many, and the kind it relates to. A rule
whose anchor does not stand in the room is passed over; where nothing is free, the piece is left out.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from uniteam.world.assets.model import Model
from uniteam.world.generation.furniture import hanging, standing
from uniteam.world.generation.furniture.piece import Piece, Site

Arrangement = Callable[[Site, Model], Iterator[Piece]]


@dataclass(frozen=True)
class Rule:
    """One kind of furniture for a room.

    Attributes:
        kind: of `furniture_kinds.KINDS`, or a category of decor; several are alternatives, the first that fits stands.
        arrange: proposes where it may be.
        chance: that the rule is used at all.
        count: least and most pieces.
        anchor: kind or kinds that the piece relates to; each standing one of them is tried in turn.
        min_area: of the room (m2), below which the rule is passed over.
        elbow_room: kept free around the piece (cm).
        one_model: whether all pieces are of one model, as chairs around a table are.
        covers_window: whether it may be before a window.
        only_if_none: whether the rule is passed over where a piece of its kinds stands already.
    """

    kind: str | tuple[str, ...]
    arrange: Arrangement
    chance: float = 1.0
    count: tuple[int, int] = (1, 1)
    anchor: str | tuple[str, ...] = ()
    min_area: float = 0.0
    elbow_room: int = 0
    one_model: bool = True
    covers_window: bool = False
    only_if_none: bool = False

    @property
    def kinds(self) -> tuple[str, ...]:
        """The alternatives."""
        return (self.kind,) if isinstance(self.kind, str) else self.kind

    @property
    def anchors(self) -> tuple[str, ...]:
        """The kinds that the piece relates to; none where it stands by itself."""
        return (self.anchor,) if isinstance(self.anchor, str) else self.anchor


_COUCHES = ("couch", "corner_couch")
_BEDS = ("bed", "single_bed")
_DESKS = ("desk", "work_table")
_DINING_TABLES = ("dining_table", "kitchen_table")

_DRESSING = (
    Rule("radiator", standing.under_window, 0.6),
    Rule("picture", hanging.on_wall, 0.55, (1, 2), elbow_room=15, one_model=False),
    Rule("wall_clock", hanging.on_wall, 0.2, elbow_room=15),
    Rule("plant", standing.in_corner, 0.45),
    Rule("ceiling_lamp", hanging.on_ceiling, 0.6),
    Rule("curtain", hanging.at_window, 0.7, (1, 4), covers_window=True),
)

LIVING_ROOM = (
    Rule(("couch", "corner_couch"), standing.mid_wall),
    Rule(("tv_stand", "low_cabinet"), standing.opposite, 0.9, anchor=_COUCHES),
    Rule("tv", hanging.on_top, anchor=("tv_stand", "low_cabinet")),
    Rule(("wall_tv", "tv"), hanging.over, anchor=("tv_stand", "low_cabinet"), only_if_none=True),
    Rule("coffee_table", standing.before, 0.9, anchor=_COUCHES),
    Rule("rug", hanging.beneath, 0.7, anchor="coffee_table"),
    Rule("armchair", standing.facing, 0.8, (1, 2), anchor="coffee_table"),
    Rule("side_table", standing.beside, 0.6, anchor=_COUCHES),
    Rule("floor_lamp", standing.beside, 0.5, anchor=_COUCHES),
    Rule("shelves", standing.against_wall, 0.8, (1, 2)),
    Rule("cabinet", standing.against_wall, 0.5),
    Rule("dining_table", standing.in_middle, 0.35, min_area=22.0),
    Rule("dining_chair", standing.around, 1.0, (3, 4), anchor="dining_table"),
    Rule("chest_of_drawers", standing.against_wall, 0.35),
    Rule("fireplace", standing.mid_wall, 0.2, min_area=18.0),
    Rule("piano", standing.against_wall, 0.15, min_area=20.0),
    Rule("armchair", standing.in_corner, 0.4),
    Rule("trunk", standing.against_wall, 0.35),
    Rule("bench", standing.against_wall, 0.3),
    Rule("stool", standing.in_corner, 0.3),
    Rule("stand", standing.against_wall, 0.35),
    Rule("serving_cart", standing.against_wall, 0.25),
    Rule("aquarium", standing.against_wall, 0.1),
    Rule("christmas_tree", standing.in_corner, 0.06),
    Rule("picture", hanging.over, 0.7, anchor=_COUCHES),
    Rule("picture", hanging.over, 0.5, anchor="low_cabinet"),
    Rule("table_lamp", hanging.on_top, 0.4, anchor=("side_table", "low_cabinet")),
    Rule("floor_lamp", standing.in_corner, 0.4),
    Rule("guitar", standing.against_wall, 0.15),
    *_DRESSING,
)

KITCHEN = (
    Rule("kitchen_sink", standing.mid_wall),
    Rule("counter", standing.in_row, 1.0, (1, 2), anchor="kitchen_sink", one_model=False),
    Rule("oven", standing.in_row, anchor="counter"),
    Rule("oven", standing.in_row, anchor="kitchen_sink", only_if_none=True),
    Rule("counter", standing.in_row, 1.0, (1, 2), anchor="oven", one_model=False),
    Rule("counter", standing.in_row, 0.6, anchor="counter", one_model=False),
    Rule("dishwasher", standing.in_row, 0.4, anchor="kitchen_sink"),
    Rule("oven", standing.against_wall, only_if_none=True),
    Rule("refrigerator", standing.in_corner),
    Rule("range_hood", hanging.overhead, 0.8, anchor="oven"),
    Rule("upper_cabinet", hanging.overhead, 0.8, (2, 4), anchor="counter"),
    Rule("counter", standing.against_wall, 0.6),
    Rule("microwave", hanging.on_top, 0.35, anchor="counter"),
    Rule("coffee_maker", hanging.on_top, 0.25, anchor="counter"),
    Rule("mixer", hanging.on_top, 0.15, anchor="counter"),
    Rule(("kitchen_table", "dining_table"), standing.in_middle, 0.75, min_area=9.0),
    Rule("dining_chair", standing.around, 1.0, (2, 4), anchor=_DINING_TABLES),
    Rule("island", standing.in_middle, 0.4, min_area=12.0),
    Rule("kitchen_table", standing.against_wall, 0.4),
    Rule("dining_chair", standing.around, 1.0, (1, 2), anchor="kitchen_table"),
    Rule("stool", standing.against_wall, 0.6, (1, 2)),
    Rule("serving_cart", standing.against_wall, 0.55),
    Rule(("small_cabinet", "cabinet"), standing.against_wall, 0.5),
    Rule("narrow_shelves", standing.against_wall, 0.35),
    Rule("washer_dryer", standing.against_wall, 0.3),
    Rule("trash_can", standing.in_corner, 0.6),
    Rule("water_cooler", standing.in_corner, 0.1),
    *_DRESSING,
)

DINING_ROOM = (
    Rule("dining_table", standing.in_middle),
    Rule("dining_chair", standing.around, 1.0, (3, 6), anchor="dining_table"),
    Rule("rug", hanging.beneath, 0.5, anchor="dining_table"),
    Rule("ceiling_lamp", hanging.above, 0.8, anchor="dining_table"),
    Rule(("low_cabinet", "cabinet"), standing.mid_wall, 0.8),
    Rule("serving_cart", standing.against_wall, 0.6),
    Rule("chest_of_drawers", standing.against_wall, 0.5),
    Rule("shelves", standing.against_wall, 0.4),
    Rule("bench", standing.against_wall, 0.4),
    Rule("stand", standing.in_corner, 0.35),
    Rule("stool", standing.in_corner, 0.25),
    Rule("trunk", standing.against_wall, 0.25),
    Rule("piano", standing.against_wall, 0.12),
    Rule("picture", hanging.over, 0.6, anchor="low_cabinet"),
    *_DRESSING,
)

BEDROOM = (
    Rule(("bed", "single_bed"), standing.mid_wall),
    Rule(("single_bed", "bed"), standing.in_corner, only_if_none=True),
    Rule("bedside_table", standing.beside, 0.95, (1, 2), anchor=_BEDS),
    Rule("wardrobe", standing.against_wall, 0.85),
    Rule("chest_of_drawers", standing.against_wall, 0.65),
    Rule(("trunk", "bench"), standing.at_foot, 0.4, anchor="bed"),
    Rule("rug", hanging.beneath, 0.5, anchor=_BEDS),
    Rule("crib", standing.against_wall, 0.12, min_area=13.0),
    Rule("desk", standing.against_wall, 0.35, min_area=13.0),
    Rule("dining_chair", standing.around, anchor="desk"),
    Rule("armchair", standing.in_corner, 0.4),
    Rule("shelves", standing.against_wall, 0.4),
    Rule("hamper", standing.in_corner, 0.5),
    Rule("trunk", standing.against_wall, 0.3),
    Rule("any_chair", standing.against_wall, 0.35),
    Rule("stool", standing.in_corner, 0.3),
    Rule("clothes_rack", standing.against_wall, 0.2),
    Rule(("exercise_bike", "doll_house", "treadmill"), standing.against_wall, 0.15),
    Rule("table_lamp", hanging.on_top, 0.35, anchor="bedside_table"),
    Rule("picture", hanging.over, 0.6, anchor=_BEDS),
    Rule(("tall_mirror", "mirror"), hanging.on_wall, 0.5, elbow_room=10),
    Rule("floor_lamp", standing.in_corner, 0.3),
    Rule("guitar", standing.against_wall, 0.12),
    *_DRESSING,
)

OFFICE = (
    Rule(("desk", "work_table"), standing.against_wall),
    Rule("office_chair", standing.around, anchor=_DESKS),
    Rule("monitor", hanging.on_top, 0.6, anchor=_DESKS),
    Rule("filing_cabinet", standing.against_wall, 0.9, (1, 2)),
    Rule("shelves", standing.against_wall, 0.95, (1, 2), one_model=False),
    Rule("armchair", standing.in_corner, 0.5),
    Rule(("cabinet", "small_cabinet"), standing.against_wall, 0.5),
    Rule("chest_of_drawers", standing.against_wall, 0.3),
    Rule("couch", standing.against_wall, 0.3, min_area=11.0),
    Rule("printer", hanging.on_top, 0.4, anchor="filing_cabinet"),
    Rule("rug", hanging.on_floor, 0.4),
    Rule("stool", standing.in_corner, 0.3),
    Rule("trunk", standing.against_wall, 0.2),
    Rule("treadmill", standing.against_wall, 0.12, min_area=11.0),
    Rule("exercise_bike", standing.in_corner, 0.12),
    Rule("floor_lamp", standing.in_corner, 0.4),
    Rule("trash_can", standing.in_corner, 0.5),
    Rule("water_cooler", standing.in_corner, 0.15),
    *_DRESSING,
)

BATHROOM = (
    Rule("toilet", standing.against_wall, elbow_room=18),
    Rule(("bathtub", "shower"), standing.in_corner, 0.85),
    Rule("bathroom_sink", standing.against_wall, elbow_room=8),
    Rule("mirror", hanging.over, 0.85, anchor="bathroom_sink"),
    Rule("shower", standing.in_corner, 0.35),
    Rule("bath_mat", standing.at_foot, 0.6, anchor="bathtub"),
    Rule("hamper", standing.in_corner, 0.65),
    Rule("washer_dryer", standing.against_wall, 0.4),
    Rule(("small_cabinet", "narrow_shelves"), standing.against_wall, 0.6),
    Rule("stool", standing.in_corner, 0.45),
    Rule("stand", standing.in_corner, 0.2),
    Rule("chest_of_drawers", standing.against_wall, 0.15),
    Rule("radiator", standing.against_wall, 0.4),
    Rule("towel_rack", hanging.on_wall, 0.4, elbow_room=10),
    Rule("trash_can", standing.in_corner, 0.3),
    Rule("ceiling_lamp", hanging.on_ceiling, 0.5),
)

LAUNDRY = (
    Rule("washer_dryer", standing.in_corner),
    Rule("washer_dryer", standing.in_row, 0.8, anchor="washer_dryer"),
    Rule("hamper", standing.in_corner, 0.95, (1, 2)),
    Rule("narrow_shelves", standing.against_wall, 0.8),
    Rule("bathroom_sink", standing.against_wall, 0.4),
    Rule(("small_cabinet", "cabinet"), standing.against_wall, 0.6),
    Rule("clothes_rack", standing.against_wall, 0.3),
    Rule("shoe_rack", standing.against_wall, 0.4),
    Rule("serving_cart", standing.against_wall, 0.25),
    Rule("trash_can", standing.in_corner, 0.4),
    Rule("ceiling_lamp", hanging.on_ceiling, 0.5),
)

HALL = (
    Rule("shoe_rack", standing.against_wall, 0.9),
    Rule(("chest_of_drawers", "small_cabinet"), standing.against_wall, 0.4),
    Rule("bench", standing.against_wall, 0.55),
    Rule("stand", standing.against_wall, 0.4),
    Rule("stool", standing.in_corner, 0.3),
    Rule("trunk", standing.against_wall, 0.35),
    Rule("clothes_rack", standing.in_corner, 0.2),
    Rule(("mirror", "tall_mirror"), hanging.on_wall, 0.6, elbow_room=10),
    Rule("picture", hanging.on_wall, 0.8, (1, 3), elbow_room=15, one_model=False),
    Rule("wall_lamp", hanging.on_wall, 0.3, (1, 2), elbow_room=15),
    Rule("plant", standing.in_corner, 0.4),
    Rule("ceiling_lamp", hanging.on_ceiling, 0.5),
)

RULES: dict[str, tuple[Rule, ...]] = {
    "living_room": LIVING_ROOM, "kitchen": KITCHEN, "dining_room": DINING_ROOM, "bedroom": BEDROOM,
    "office": OFFICE, "bathroom": BATHROOM, "laundry": LAUNDRY, "hall": HALL,
}  # fmt: skip
