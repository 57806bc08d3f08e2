"""Which graspable objects a home may hold, and which are likely in which room."""

from collections.abc import Iterable, Mapping

from numpy.random import Generator

from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Model, Pool

_KITCHEN = (
    "apple", "banana", "blender", "bottle", "bowl", "bread", "butter", "cake", "can", "canister", "carrot",
    "cereal_box", "citrus_juicer", "coaster", "coffee_press", "cup", "cupcake", "cutting_board", "egg", "fork",
    "french_fries", "glass", "hamburger", "hot_dog", "jar", "kettle", "knife", "knife_block", "ladle", "lemon",
    "milk_carton", "moka_pot", "orange", "pan", "paper_towel", "pear", "pitcher", "plate", "pot", "roasted_chicken",
    "rolling_pin", "salt_and_pepper_shaker", "sandwich_maker", "spatula", "sponge", "spoon", "steak", "teapot",
    "toaster", "tomato", "tray", "utensil_holder", "wine_bottle",
)  # fmt: skip
_BATHROOM = (
    "baby_bottle", "brush", "comb", "cup", "folded_clothes", "lipstick", "medicine_bottle", "perfume", "scale",
    "shampoo", "soap_bar", "soap_dispenser", "sponge", "spray_bottle", "tissue_box", "toilet_brush", "toilet_paper",
    "towel",
)  # fmt: skip
_LIVING_ROOM = (
    "ashtray", "board_game", "book", "candle", "clock", "coaster", "cushion", "die", "game_console",
    "game_controller", "lamp", "newspaper", "picture_frame", "potted_plant", "radio", "remote_control", "speaker",
    "statue", "tissue_box", "toy_vehicle", "trophy", "vase", "wine_bottle",
)  # fmt: skip
_BEDROOM = (
    "action_figure", "book", "cellphone", "clock", "cushion", "doll", "folded_clothes", "glove", "handbag", "hat",
    "lamp", "perfume", "picture_frame", "shoe", "sock", "spectacles", "stuffed_toy", "tablet", "toy_airplane",
    "toy_construction_set", "watch", "xylophone",
)  # fmt: skip
_OFFICE = (
    "book", "briefcase", "calendar", "camera", "cellphone", "computer_mouse", "cup", "file_sorter", "keyboard",
    "lamp", "laptop", "marker", "notebook", "pen", "pencil_case", "puzzle_cube", "ruler", "scissors", "stapler",
    "tablet", "tape", "telephone", "trophy",
)  # fmt: skip
_HALL = (
    "backpack", "ball", "flashlight", "glove", "handbag", "hat", "keys", "lantern", "shoe", "table_tennis_paddle",
    "umbrella", "wallet",
)  # fmt: skip
_LAUNDRY = (
    "basket", "box", "drill", "folded_clothes", "hammer", "pliers", "saw", "screwdriver", "sock", "sponge",
    "spray_bottle", "towel",
)  # fmt: skip

_FITTING_ROOMS: Mapping[str, tuple[str, ...]] = {
    "kitchen": _KITCHEN, "dining_room": _KITCHEN, "bathroom": _BATHROOM, "living_room": _LIVING_ROOM,
    "bedroom": _BEDROOM, "office": _OFFICE, "hall": _HALL, "laundry": _LAUNDRY,
}  # fmt: skip
"""Categories that one expects in a room; much of what lies about is not expected where it lies."""


class ObjectStock:
    """The graspable objects a home of one pool may hold, and the few categories that occur again and again in it."""

    def __init__(
        self, catalogue: Catalogue, pool: Pool, rng: Generator, fitting: float = 0.4, frequent: float = 0.2
    ) -> None:
        """Draw the categories that are frequent in the home.

        Args:
            catalogue, pool: of the models.
            rng: for the draw.
            fitting: the share of what is chosen for its room.
            frequent: the share of what is chosen among the frequent categories.
        """
        self.catalogue = catalogue
        self._fitting, self._frequent_from = fitting, fitting + frequent
        self._models: dict[str, list[Model]] = {}
        for model in sorted(catalogue.models.values(), key=lambda m: m.id):
            if model.role == "object" and _is_allowed(model, catalogue, pool):
                self._models.setdefault(model.category, []).append(model)
        self._categories = sorted(self._models)
        size = min(6, len(self._categories))
        self._frequent = [str(name) for name in rng.choice(self._categories, size=size, replace=False)]

    def choose(self, room_kind: str, rng: Generator) -> Model:
        """Return a model: often one that fits the room or is frequent in this home, else any."""
        fitting = [name for name in self._categories if name in _FITTING_ROOMS.get(room_kind, ())]
        draw = rng.random()
        if draw < self._fitting and fitting:
            names = fitting
        elif draw < self._frequent_from:
            names = self._frequent
        else:
            names = self._categories
        return self.of(names[int(rng.integers(len(names)))], rng)

    def known(self, categories: Iterable[str]) -> list[str]:
        """Return those of some categories of which there is a model, in their order."""
        return [name for name in categories if name in self._models]

    def of(self, category: str, rng: Generator) -> Model:
        """Return any model of a category that there is."""
        models = self._models[category]
        return models[int(rng.integers(len(models)))]


def _is_allowed(model: Model, catalogue: Catalogue, pool: Pool) -> bool:
    is_unseen = model.category in catalogue.unseen_categories
    return model.pool == "train" and not is_unseen if pool == "train" else model.pool == "test" or is_unseen
