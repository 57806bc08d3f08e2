"""What stands in the rooms of a home that is lived in: what a tidy one has and more, less in line.

Chairs are pulled out, and stools, hampers, carts and chairs stand wherever they were used last, so that they narrow
the ways.
"""

from collections.abc import Mapping
from dataclasses import replace

from uniteam.world.generation.furniture import hanging, standing
from uniteam.world.generation.furniture.rules import RULES, Arrangement, Rule

_MORE_OFTEN = 1.2
_LOOSELY: Mapping[Arrangement, Arrangement] = {standing.around: standing.pulled_out}

_EXTRA: Mapping[str, tuple[Rule, ...]] = {
    "living_room": (
        Rule("dining_table", standing.in_middle, 0.7, min_area=29.0),
        Rule("dining_chair", standing.pulled_out, 1.0, (2, 5), anchor="dining_table"),
        Rule(("desk", "work_table"), standing.against_wall, 0.4, min_area=22.0),
        Rule("office_chair", standing.pulled_out, 1.0, anchor=("desk", "work_table")),
        Rule("shelves", standing.against_wall, 0.5),
        Rule("chest_of_drawers", standing.against_wall, 0.4),
        Rule(("low_stool", "dining_chair"), standing.left_about, 0.7, (1, 2)),
        Rule("side_table", standing.left_about, 0.3),
        Rule("hamper", standing.left_about, 0.25),
        Rule("plant", standing.in_corner, 0.5),
    ),
    "kitchen": (
        Rule(("low_stool", "dining_chair"), standing.left_about, 0.6, (1, 2)),
        Rule("serving_cart", standing.left_about, 0.25),
        Rule("trash_can", standing.left_about, 0.35),
        Rule("shelves", standing.against_wall, 0.3),
    ),
    "dining_room": (
        Rule("shelves", standing.against_wall, 0.4),
        Rule("dining_chair", standing.left_about, 0.4),
    ),
    "bedroom": (
        Rule("hamper", standing.left_about, 0.45),
        Rule(("dining_chair", "low_stool"), standing.left_about, 0.5),
        Rule("shelves", standing.against_wall, 0.35),
        Rule("chest_of_drawers", standing.against_wall, 0.3),
        Rule("desk", standing.against_wall, 0.3, min_area=14.0),
        Rule("dining_chair", standing.pulled_out, anchor="desk"),
        Rule("clothes_rack", standing.left_about, 0.15),
    ),
    "office": (
        Rule(("dining_chair", "low_stool"), standing.left_about, 0.4),
        Rule("shelves", standing.against_wall, 0.4),
        Rule("filing_cabinet", standing.against_wall, 0.3),
    ),
    "bathroom": (
        Rule("hamper", standing.left_about, 0.4),
        Rule("low_stool", standing.left_about, 0.3),
    ),
    "laundry": (
        Rule("hamper", standing.left_about, 0.7),
        Rule("clothes_rack", standing.left_about, 0.35),
        Rule("shelves", standing.against_wall, 0.4),
    ),
    "hall": (
        Rule("shoe_rack", standing.against_wall, 0.5),
        Rule(("chest_of_drawers", "small_cabinet"), standing.against_wall, 0.4),
        Rule("narrow_shelves", standing.against_wall, 0.35),
        Rule("picture", hanging.on_wall, 0.6, (1, 3), elbow_room=15, one_model=False),
    ),
}  # fmt: skip
"""Added behind what a tidy room has."""


def _loosened(rule: Rule) -> Rule:
    arrange = _LOOSELY.get(rule.arrange, rule.arrange)
    return replace(rule, arrange=arrange, chance=min(1.0, _MORE_OFTEN * rule.chance))


LIVED_IN_RULES: dict[str, tuple[Rule, ...]] = {
    kind: (*(_loosened(rule) for rule in rules), *_EXTRA[kind]) for kind, rules in RULES.items()
}
