"""Kinds of furniture finer than the catalogue's categories: which table is a desk is told by its size.

Each kind is a category and bounds on the size, so a new model of the pack is used without being listed here.
"""

from collections.abc import Callable
from dataclasses import dataclass

from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Model, Pool

Bounds = tuple[float, float]
_ANY: Bounds = (0.0, 99.0)


@dataclass(frozen=True)
class FurnitureKind:
    """Models of some categories whose width, depth and height (m) are within bounds."""

    categories: tuple[str, ...]
    width: Bounds = _ANY
    depth: Bounds = _ANY
    height: Bounds = _ANY
    also: Callable[[Model], bool] = lambda model: True

    def matches(self, model: Model) -> bool:
        """Say whether a model is of this kind."""
        bounds = (self.width, self.depth, self.height)
        sized = all(low <= length <= high for (low, high), length in zip(bounds, model.size, strict=True))
        return model.category in self.categories and sized and self.also(model)


def _named(*words: str) -> Callable[[Model], bool]:
    return lambda model: any(word in model.name.lower() for word in words)


def _not_named(*words: str) -> Callable[[Model], bool]:
    return lambda model: not any(word in model.name.lower() for word in words)


_FOR_WASHING = ("vanity", "basin", "lavatory", "bath")
_OUTDOORS = ("deck", "beach", "ryokan", "garden", "child")


def _is_armchair(model: Model) -> bool:
    return "arm" in model.name.lower() or (model.size[0] >= 0.66 and _not_named("office", *_OUTDOORS)(model))


KINDS = {
    "couch": FurnitureKind(("couch",), depth=(0, 1.2)),
    "corner_couch": FurnitureKind(("couch",), depth=(1.2, 3.0)),
    "coffee_table": FurnitureKind(("table",), height=(0.25, 0.6), width=(0.6, 1.6)),
    "dining_table": FurnitureKind(("table",), width=(0.9, 2.4), depth=(0.75, 1.4), height=(0.68, 0.82),
                                  also=_not_named("desk")),
    "kitchen_table": FurnitureKind(("table",), width=(0.6, 1.3), depth=(0.5, 1.3), height=(0.6, 0.92),
                                   also=_not_named("desk")),
    "desk": FurnitureKind(("table",), width=(0.9, 2.4), depth=(0.45, 0.9), height=(0.68, 1.85),
                          also=_named("desk", "dressing")),
    "work_table": FurnitureKind(("table",), width=(0.9, 2.0), depth=(0.45, 0.85), height=(0.68, 0.8)),
    "side_table": FurnitureKind(("table", "stool", "stand"), width=(0.3, 0.75), depth=(0.3, 0.75), height=(0.35, 0.75)),
    "armchair": FurnitureKind(("chair",), width=(0.58, 1.2), depth=(0.55, 1.0), height=(0.6, 1.2), also=_is_armchair),
    "dining_chair": FurnitureKind(("chair",), width=(0.3, 0.62), depth=(0.3, 0.68), height=(0.7, 1.2),
                                  also=_not_named("bar", *_OUTDOORS)),
    "any_chair": FurnitureKind(("chair",), width=(0.3, 1.0), depth=(0.3, 1.0)),
    "bed": FurnitureKind(("bed",), width=(1.15, 2.3), height=(0.3, 1.3)),
    "single_bed": FurnitureKind(("bed",), width=(0.7, 1.32)),
    "bedside_table": FurnitureKind(("stand",), width=(0.25, 0.7), height=(0.3, 0.75)),
    "tv_stand": FurnitureKind(("stand",), width=(0.9, 2.2), height=(0.3, 0.95)),
    "stand": FurnitureKind(("stand",)),
    "tv": FurnitureKind(("tv",), also=_not_named("wall")),
    "wall_tv": FurnitureKind(("tv",), also=_named("wall")),
    "mirror": FurnitureKind(("mirror",), height=(0.0, 1.0)),
    "tall_mirror": FurnitureKind(("mirror",), height=(1.0, 2.2)),
    "low_cabinet": FurnitureKind(("cabinet", "chest_of_drawers"), width=(0.9, 2.2), height=(0.3, 0.95)),
    "office_chair": FurnitureKind(("chair",), width=(0.4, 0.75), depth=(0.4, 0.75), height=(0.7, 1.25),
                                  also=_not_named(*_OUTDOORS)),
    "bench": FurnitureKind(("bench",), width=(0.5, 2.1), depth=(0.2, 0.75)),
    "trunk": FurnitureKind(("trunk",)),
    "chest_of_drawers": FurnitureKind(("chest_of_drawers",)),
    "wardrobe": FurnitureKind(("wardrobe",)),
    "cabinet": FurnitureKind(("cabinet",), width=(0.45, 2.0)),
    "small_cabinet": FurnitureKind(("cabinet",), width=(0.15, 0.8), depth=(0.15, 0.65)),
    "shelves": FurnitureKind(("shelves",)),
    "narrow_shelves": FurnitureKind(("shelves",), width=(0.3, 1.05), depth=(0.15, 0.5)),
    "shoe_rack": FurnitureKind(("shoe_rack",)),
    "filing_cabinet": FurnitureKind(("filing_cabinet",)),
    "hamper": FurnitureKind(("hamper",)),
    "serving_cart": FurnitureKind(("serving_cart",)),
    "stool": FurnitureKind(("stool",)),
    "low_stool": FurnitureKind(("stool",), height=(0.2, 0.62)),
    "counter": FurnitureKind(("counter",), width=(0.4, 1.5), depth=(0.5, 0.75), also=_not_named("corner", "island")),
    "island": FurnitureKind(("counter",), width=(0.6, 2.4), depth=(0.6, 1.4), also=_named("island")),
    "kitchen_sink": FurnitureKind(("sink",), width=(0.55, 1.4), depth=(0.55, 0.75), height=(0.8, 1.3),
                                  also=_not_named(*_FOR_WASHING)),
    "bathroom_sink": FurnitureKind(("sink",), height=(0.6, 2.3), also=_named(*_FOR_WASHING)),
    "toilet": FurnitureKind(("toilet",)),
    "bathtub": FurnitureKind(("bathtub",)),
    "washer_dryer": FurnitureKind(("washer_dryer",)),
}  # fmt: skip
"""Kinds of receptacles; any other kind is a category of decor by its own name."""


def models_of_kind(catalogue: Catalogue, kind: str, pool: Pool) -> tuple[Model, ...]:
    """Return the pool's models of a kind, sorted by id; of every pool where the pool lacks the whole category."""
    wanted = KINDS.get(kind, FurnitureKind((kind,)))
    models = sorted(catalogue.models.values(), key=lambda model: model.id)
    usable = [m for m in models if m.role in ("receptacle", "decor") and m.category in wanted.categories]
    in_pool = [m for m in usable if m.pool == pool] or usable
    return tuple(m for m in in_pool if wanted.matches(m))
