"""What an asset of AI2-THOR is called here, and what is known of its size.

The classes are AI2-THOR's object types (https://ai2thor.allenai.org/ithor/documentation/objects/object-types). One that
is not in the table has no like in the package: it is left out.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from uniteam.geometry import Point3
from uniteam.world.assets.reading import read_json
from uniteam.world.homes.readers.procthor.schema import AssetEntry, ObjectEntry

ASSET_DATABASE = "asset-database.json"
"""Of https://github.com/allenai/procthor, in `procthor/databases`."""

_FURNITURE = {
    "ArmChair": "chair", "Bathtub": "bathtub", "Bed": "bed", "Cabinet": "cabinet", "Cart": "serving_cart",
    "Chair": "chair", "ClothesDryer": "washer_dryer", "CoffeeTable": "table", "CounterTop": "counter", "Desk": "table",
    "DiningTable": "table", "Dresser": "chest_of_drawers", "Footstool": "stool", "LaundryHamper": "hamper",
    "Ottoman": "stool", "Shelf": "shelves", "ShelvingUnit": "shelves", "SideTable": "stand", "Sink": "sink",
    "Sofa": "couch", "Stool": "stool", "Toilet": "toilet", "TVStand": "cabinet", "WashingMachine": "washer_dryer",
}  # fmt: skip
_DECOR = {
    "Blinds": "window_blind", "CoffeeMachine": "coffee_maker", "Curtains": "curtain", "FloorLamp": "floor_lamp",
    "Fridge": "refrigerator", "GarbageCan": "trash_can", "HousePlant": "plant", "Microwave": "microwave",
    "Mirror": "mirror", "Painting": "picture", "ShowerCurtain": "shower_curtain", "Television": "tv",
    "ToiletPaperHanger": "toilet_paper_holder", "TowelHolder": "towel_rack",
}  # fmt: skip
_OBJECTS = {
    "AlarmClock": "clock", "Apple": "apple", "BasketBall": "ball", "Book": "book", "Boots": "shoe", "Bottle": "bottle",
    "Bowl": "bowl", "Box": "box", "Bread": "bread", "ButterKnife": "knife", "Candle": "candle",
    "CellPhone": "cellphone",
    "Cup": "cup", "DeskLamp": "lamp", "DishSponge": "sponge", "Dumbbell": "dumbbell", "Egg": "egg", "Fork": "fork",
    "HandTowel": "towel", "Kettle": "kettle", "KeyChain": "keys", "Knife": "knife", "Ladle": "ladle",
    "Laptop": "laptop", "Mug": "cup", "Newspaper": "newspaper", "Pan": "pan", "PaperTowelRoll": "paper_towel",
    "Pen": "pen", "PepperShaker": "salt_and_pepper_shaker", "Pillow": "cushion", "Plate": "plate", "Pot": "pot",
    "RemoteControl": "remote_control", "SaltShaker": "salt_and_pepper_shaker", "SoapBar": "soap_bar",
    "SoapBottle": "soap_dispenser", "Spatula": "spatula", "Spoon": "spoon", "SprayBottle": "spray_bottle",
    "Statue": "statue", "TeddyBear": "stuffed_toy", "TissueBox": "tissue_box", "Toaster": "toaster",
    "ToiletPaper": "toilet_paper", "Tomato": "tomato", "Towel": "towel", "Vase": "vase", "Watch": "watch",
    "WineBottle": "wine_bottle",
}  # fmt: skip
CLASSES: Mapping[str, str] = {**_FURNITURE, **_DECOR, **_OBJECTS}
"""Our category by the type of AI2-THOR."""

ON_FURNITURE: Mapping[str, str] = {"HousePlant": "potted_plant"}
"""What is another category where it stands on something."""

HUNG = frozenset(
    {"curtain", "mirror", "picture", "shower_curtain", "toilet_paper_holder", "towel_rack", "tv", "window_blind"}
)
"""Categories that hang on walls where they stand on nothing."""

_TYPE = re.compile(r"[A-Z][A-Za-z]+")
_PREFIX = "robothor"


@dataclass(frozen=True)
class Asset:
    """An asset: the type of AI2-THOR, and its width, depth and height (m) before it is turned."""

    type: str
    size: Point3


def read_asset_database(path: Path) -> Mapping[str, Asset]:
    """Return the assets of an `asset-database.json` by id, none without a file; raises DamagedFileError."""
    if not path.exists():
        return {}
    entries = read_json(path, "the database of assets", dict[str, list[AssetEntry]])
    return {
        entry.asset_id: Asset(entry.object_type, (entry.bounding_box.x, entry.bounding_box.z, entry.bounding_box.y))
        for each in entries.values()
        for entry in each
    }


def type_of(entry: ObjectEntry, assets: Mapping[str, Asset]) -> str:
    """Return an object's type: from the database, else from its id ("Bed|2|0"), else from its asset's ("Bed_20")."""
    if entry.asset_id in assets:
        return assets[entry.asset_id].type
    first = entry.id.partition("|")[0]
    return first if _TYPE.fullmatch(first) else _type_of_asset(entry.asset_id)


def _type_of_asset(asset: str) -> str:
    """Return the longest type with which an asset's name begins; the name without its number where there is none."""
    letters = re.sub(r"[^a-z]", "", asset.lower()).removeprefix(_PREFIX)
    known = [name for name in CLASSES if letters.startswith(name.lower())]
    return max(known, key=len, default=re.sub(r"[_\d]+$", "", asset) or "thing")
