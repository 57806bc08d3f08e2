"""Two small houses of our own, written as ProcTHOR writes its houses.

The first is in the schema 1.0.0 and asymmetric: its living room is an L, the kitchen lies to the east of it, the
bedroom to the north. The second is in the schema 0.0.1, and one of its walls is open. Coordinates are (x, z) of
Unity's world.
"""

import gzip
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

CEILING = 2.7
Data = dict[str, Any]
Corner = tuple[float, float]
Rooms = dict[str, tuple[str, list[Corner]]]

ASSETS: Mapping[str, tuple[str, float, float, float]] = {
    "Sofa_Mini_1": ("Sofa", 1.9, 0.9, 0.8),
    "Coffee_Table_Mini_1": ("CoffeeTable", 1.0, 0.6, 0.45),
    "TV_Stand_Mini_1": ("TVStand", 1.4, 0.45, 0.6),
    "Television_Mini_1": ("Television", 1.0, 0.15, 0.65),
    "Shelving_Unit_Mini_1": ("ShelvingUnit", 0.9, 0.35, 1.8),
    "Countertop_Mini_1": ("CounterTop", 1.8, 0.65, 0.9),
    "Fridge_Mini_1": ("Fridge", 0.8, 0.75, 1.8),
    "Dining_Table_Mini_1": ("DiningTable", 1.2, 0.8, 0.75),
    "Chair_Mini_1": ("Chair", 0.45, 0.5, 0.9),
    "Bed_Mini_1": ("Bed", 1.5, 2.0, 0.9),
    "Dresser_Mini_1": ("Dresser", 1.0, 0.5, 0.9),
    "Side_Table_Mini_1": ("SideTable", 0.45, 0.45, 0.55),
    "Painting_Mini_1": ("Painting", 0.6, 0.04, 0.7),
    "Dog_Bed_Mini_1": ("DogBed", 0.8, 0.6, 0.2),
    "Bowl_Mini_1": ("Bowl", 0.18, 0.18, 0.08),
    "Apple_Mini_1": ("Apple", 0.08, 0.08, 0.08),
    "Mug_Mini_1": ("Mug", 0.12, 0.09, 0.1),
    "Lettuce_Mini_1": ("Lettuce", 0.2, 0.2, 0.15),
    "Book_Mini_1": ("Book", 0.2, 0.15, 0.03),
    "Plate_Mini_1": ("Plate", 0.22, 0.22, 0.03),
    "Pillow_Mini_1": ("Pillow", 0.5, 0.35, 0.15),
    "Vase_Mini_1": ("Vase", 0.15, 0.15, 0.25),
    "Alarm_Clock_Mini_1": ("AlarmClock", 0.15, 0.1, 0.15),
    "Remote_Mini_1": ("RemoteControl", 0.05, 0.18, 0.02),
    "Toilet_Mini_1": ("Toilet", 0.45, 0.65, 0.8),
    "Soap_Bottle_Mini_1": ("SoapBottle", 0.08, 0.08, 0.2),
}
"""Type, width, depth and height (m)."""


def write_miniature(folder: Path) -> Path:
    """Write both houses and their assets' sizes into a folder, and return the file of houses."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "asset-database.json").write_text(json.dumps(asset_database(), indent=1), "utf-8")
    path = folder / "houses.jsonl.gz"
    text = "".join(json.dumps(house) + "\n" for house in (first_house(), second_house()))
    path.write_bytes(gzip.compress(text.encode(), mtime=0))
    return path


def asset_database() -> Data:
    """Return the file of the assets' sizes."""
    database: Data = {}
    for asset, (kind, width, depth, height) in ASSETS.items():
        box = {"x": width, "y": height, "z": depth}
        database.setdefault(kind, []).append({"assetId": asset, "objectType": kind, "boundingBox": box, "split": "val"})
    return database


def first_house() -> Data:
    """Return the asymmetric house, in the schema 1.0.0."""
    rooms: Rooms = {
        "2": ("LivingRoom", [(0, 0), (0, 5), (4, 5), (4, 3), (6, 3), (6, 0)]),
        "3": ("Kitchen", [(6, 0), (6, 3), (6, 4), (10, 4), (10, 0)]),
        "4": ("Bedroom", [(0, 5), (0, 9), (4, 9), (4, 5)]),
    }
    doors = [
        _hole("door|2|3", "wall|2|6.00|0.00|6.00|3.00", "wall|3|6.00|0.00|6.00|3.00", (1.0, 2.0), (0.0, 2.1)),
        _hole("door|2|4", "wall|2|0.00|5.00|4.00|5.00", "wall|4|0.00|5.00|4.00|5.00", (0.6, 1.6), (0.0, 2.1)),
        _hole("door|1|2", "wall|2|0.00|0.00|6.00|0.00", "wall|exterior|0.00|0.00|6.00|0.00", (3.0, 4.0), (0.0, 2.1)),
    ]
    windows = [
        _hole("window|4|0", "wall|4|0.00|5.00|0.00|9.00", "wall|exterior|0.00|5.00|0.00|9.00", (1.5, 2.7), (0.9, 1.9))
    ]
    objects = [
        thing("Sofa|2|0", "Sofa_Mini_1", (0.5, 2.4), 90, [on("Pillow_Mini_1", (0.6, 2.9), 0.55)]),
        thing("CoffeeTable|2|1", "Coffee_Table_Mini_1", (2.0, 2.4), 90, [
            on("Book_Mini_1", (2.0, 2.2), 0.47, 30), on("Remote_Mini_1", (2.05, 2.6), 0.46, 10),
        ]),
        thing("TVStand|2|2", "TV_Stand_Mini_1", (3.3, 0.28), 0, [on("Television_Mini_1", (3.3, 0.28), 0.93)]),
        thing("ShelvingUnit|2|3", "Shelving_Unit_Mini_1", (3.5, 4.8), 180, [
            on("Vase_Mini_1", (3.5, 4.8), 1.2), on("Book_Mini_1", (3.3, 4.8), 0.8),
        ]),
        thing("CounterTop|3|0", "Countertop_Mini_1", (8.4, 0.4), 0, [
            on("Bowl_Mini_1", (7.8, 0.4), 0.94), on("Apple_Mini_1", (8.2, 0.4), 0.94),
            on("Mug_Mini_1", (8.6, 0.4), 0.95, 45), on("Lettuce_Mini_1", (9.0, 0.4), 0.98),
        ]),
        thing("Fridge|3|1", "Fridge_Mini_1", (9.5, 3.5), 180),
        thing("DiningTable|3|2", "Dining_Table_Mini_1", (8.2, 2.5), 0, [
            on("Plate_Mini_1", (8.0, 2.5), 0.77), on("Mug_Mini_1", (8.5, 2.6), 0.8),
        ]),
        thing("Chair|3|3", "Chair_Mini_1", (7.3, 2.5), 90),
        thing("Bed|4|0", "Bed_Mini_1", (2.9, 7.9), 180, [on("Pillow_Mini_1", (2.9, 8.5), 0.6)]),
        thing("Dresser|4|1", "Dresser_Mini_1", (0.3, 8.3), 90, [on("Vase_Mini_1", (0.3, 8.3), 1.03)]),
        thing("SideTable|4|2", "Side_Table_Mini_1", (1.75, 8.7), 180, [on("Alarm_Clock_Mini_1", (1.75, 8.7), 0.63)]),
        thing("DogBed|4|3", "Dog_Bed_Mini_1", (3.5, 5.5), 0, [on("Pillow_Mini_1", (3.5, 5.5), 0.25)]),
        thing("Painting|4|4", "Painting_Mini_1", (3.93, 6.5), 270, height=1.5),
    ]  # fmt: skip
    return _house("1.0.0", rooms, doors, windows, objects)


def second_house() -> Data:
    """Return a house in the schema 0.0.1, with an open wall between kitchen and living room."""
    rooms: Rooms = {
        "2": ("LivingRoom", [(0, 0), (0, 4), (4, 4), (4, 0)]),
        "3": ("Kitchen", [(4, 0), (4, 4), (8, 4), (8, 0)]),
        "4": ("Bathroom", [(8, 0), (8, 4), (10.5, 4), (10.5, 0)]),
    }
    doors = [_hole("door|3|4", "wall|4|8.00|0.00|8.00|4.00", "wall|3|8.00|0.00|8.00|4.00", (0.5, 1.5), (0.0, 2.0))]
    objects = [
        thing("2|0", "Sofa_Mini_1", (0.5, 1.5), 90, [on("Pillow_Mini_1", (0.6, 1.8), 0.55)]),
        thing("2|1", "Side_Table_Mini_1", (0.35, 3.5), 90, [on("Remote_Mini_1", (0.35, 3.5), 0.56)]),
        thing("3|0", "Countertop_Mini_1", (6.2, 3.6), 180, [
            on("Bowl_Mini_1", (5.7, 3.6), 0.94), on("Mug_Mini_1", (6.3, 3.6), 0.95),
            on("Apple_Mini_1", (6.7, 3.6), 0.94),
        ]),
        thing("3|1", "Dining_Table_Mini_1", (5.5, 1.3), 90, [on("Plate_Mini_1", (5.5, 1.3), 0.77)]),
        thing("4|0", "Toilet_Mini_1", (10.1, 2.0), 270),
        thing("4|1", "Dresser_Mini_1", (9.6, 3.7), 180, [on("Soap_Bottle_Mini_1", (9.6, 3.7), 1.0)]),
    ]  # fmt: skip
    house = _house("0.0.1", rooms, doors, [], objects)
    for wall in house["walls"]:
        wall["empty"] = "4.00|0.00|4.00|4.00" in wall["id"]
    for hole in house["doors"]:
        low, high = hole.pop("holePolygon")
        hole["boundingBox"] = {"min": low, "max": high}
    return house


def thing(
    name: str, asset: str, place: Corner, turn: float, children: Sequence[Data] = (), height: float | None = None
) -> Data:
    """Return an asset that stands on the floor, or with its middle at `height`."""
    middle = ASSETS[asset][3] / 2 if height is None else height
    position = {"x": place[0], "y": middle, "z": place[1]}
    rotation = {"x": 0, "y": turn, "z": 0}
    return {"id": name, "assetId": asset, "position": position, "rotation": rotation, "children": list(children)}


def on(asset: str, place: Corner, height: float, turn: float = 0.0) -> Data:
    """Return a small asset on another, its middle at `height`."""
    name = f"{ASSETS[asset][0]}|surface|{place[0]}|{place[1]}"
    return thing(name, asset, place, turn, height=height)


def _hole(name: str, wall0: str, wall1: str, along: Corner, up: Corner) -> Data:
    polygon = [{"x": along[0], "y": up[0], "z": 0}, {"x": along[1], "y": up[1], "z": 0}]
    return {"id": name, "assetId": "Doorway_1", "wall0": wall0, "wall1": wall1, "holePolygon": polygon}


def _house(schema: str, rooms: Rooms, doors: list[Data], windows: list[Data], objects: list[Data]) -> Data:
    walls = [_wall(name, a, b) for name, (_, outline) in rooms.items() for a, b in _sides(outline)]
    counts = [wall["id"].partition("|")[2].partition("|")[2] for wall in walls]
    outside = [
        {**wall, "id": f"wall|exterior|{ends}", "polygon": wall["polygon"][::-1]}
        for wall, ends in zip(walls, counts, strict=True)
        if counts.count(ends) == 1
    ]
    return {
        "rooms": [
            {
                "id": f"room|{name}",
                "roomType": kind,
                "floorMaterial": {"name": "WoodFloorsCross" if kind != "Bathroom" else "TileSmall"},
                "floorPolygon": [{"x": x, "y": 0, "z": z} for x, z in outline],
                "ceilings": [],
                "children": [],
            }
            for name, (kind, outline) in rooms.items()
        ],
        "walls": [*walls, *outside],
        "doors": doors,
        "windows": windows,
        "objects": objects,
        "proceduralParameters": {"ceilingMaterial": {"name": "DrywallOrange"}, "lights": [], "skyboxId": "SkyMountain"},
        "metadata": {"schema": schema},
    }


def _sides(outline: list[Corner]) -> list[tuple[Corner, Corner]]:
    return list(zip(outline, [*outline[1:], outline[0]], strict=True))


def _wall(room: str, a: Corner, b: Corner) -> Data:
    low, high = (min(a[0], b[0]), min(a[1], b[1])), (max(a[0], b[0]), max(a[1], b[1]))
    polygon = [{"x": x, "y": y, "z": z} for y in (0, CEILING) for x, z in (a, b)]
    material = {"name": "PureWhite", "color": {"r": 0.9, "g": 0.92, "b": 0.88}}
    ends = f"{low[0]:.2f}|{low[1]:.2f}|{high[0]:.2f}|{high[1]:.2f}"
    return {"id": f"wall|{room}|{ends}", "roomId": f"room|{room}", "polygon": polygon, "material": material}
