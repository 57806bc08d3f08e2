"""Which graspable objects a home may hold, and which are likely in which room."""

from collections.abc import Mapping

from numpy.random import Generator

from uniteam.world.assets.catalogue import Catalogue, Model, Pool

_FITTING_ROOMS: Mapping[str, frozenset[str]] = {
    room: frozenset(words)
    for room, words in {
        "kitchen": ("cup", "mug", "plate", "bowl", "bottle", "glass", "fork", "knife", "spoon", "pan", "pot", "kettle",
                    "electric_kettle", "teapot", "bread", "apple", "banana", "toy_food", "spatula", "ladle", "jar",
                    "toaster", "butter_dish", "canister", "wine_bottle", "squeezer", "tray", "salt_and_pepper_shaker",
                    "utensil_holder_cup", "sponge", "can", "dish", "blender", "coffee_maker", "cutting_board"),
        "bathroom": ("bath_towel", "towel", "soap_dispenser", "toiletry", "sponge", "cloth", "toothbrush",
                     "spray_bottle", "hair_dryer", "toilet_paper", "shampoo", "basket"),
        "living_room": ("remote_control", "remote", "book", "vase", "candle", "picture_frame", "lamp", "newspaper",
                        "gaming_console", "board_game", "statue", "clock", "radio", "plant_container", "magazine"),
        "bedroom": ("book", "lamp", "clock", "watch", "spectacles", "hat", "handbag", "stuffed_toy", "cellphone",
                    "doll", "headphones", "shoe", "toy_animal", "picture_frame"),
        "office": ("laptop", "pen", "pencil_case", "stapler", "file_sorter", "scissors", "tape", "calculator", "book",
                   "telephone", "lamp", "cup", "mouse", "keyboard", "calendar", "camera"),
        "hall": ("shoe", "hat", "handbag", "keychain", "umbrella", "helmet", "backpack", "cellphone"),
        "laundry": ("spray_bottle", "bath_towel", "cloth", "basket", "box", "sponge"),
        "dining_room": ("plate", "glass", "candle", "bowl", "wine_bottle", "vase", "cup", "tray", "fork", "knife"),
    }.items()
}  # fmt: skip


class ObjectStock:
    """The graspable objects a home of one pool may hold, and the few categories that occur again and again in it."""

    def __init__(self, catalogue: Catalogue, pool: Pool, rng: Generator) -> None:
        self.catalogue = catalogue
        self._models: dict[str, list[Model]] = {}
        for model in sorted(catalogue.models.values(), key=lambda m: m.id):
            if model.role == "object" and _is_allowed(model, catalogue, pool):
                self._models.setdefault(model.category, []).append(model)
        self._categories = sorted(self._models)
        size = min(6, len(self._categories))
        self._frequent = [str(name) for name in rng.choice(self._categories, size=size, replace=False)]

    def choose(self, room_kind: str, rng: Generator) -> Model:
        """Return a model: often one that fits the room or is frequent in this home, as often any."""
        fitting = [name for name in self._categories if name in _FITTING_ROOMS.get(room_kind, ())]
        draw = rng.random()
        if draw < 0.4 and fitting:
            names = fitting
        elif draw < 0.6:
            names = self._frequent
        else:
            names = self._categories
        models = self._models[names[int(rng.integers(len(names)))]]
        return models[int(rng.integers(len(models)))]


def _is_allowed(model: Model, catalogue: Catalogue, pool: Pool) -> bool:
    is_unseen = model.category in catalogue.unseen_categories
    return model.pool == "train" and not is_unseen if pool == "train" else model.pool == "test" or is_unseen
