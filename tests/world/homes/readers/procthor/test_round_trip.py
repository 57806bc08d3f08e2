"""A home of the generator, written as ProcTHOR has its houses with our own models' sizes, comes back as it was."""

import json
import math
from pathlib import Path
from typing import Any

import pytest

from uniteam.geometry import wrap_angle
from uniteam.world.homes.home import Home, Instance
from uniteam.world.homes.readers.procthor.classes import CLASSES, HUNG
from uniteam.world.homes.readers.procthor.house import read_procthor_house
from uniteam.world.task.splits import load_split

TYPES = {category: kind for kind, category in reversed(list(CLASSES.items()))}


def yaw(instance: Instance) -> float:
    """Return the angle (rad) by which an upright instance is turned."""
    pose = instance.model_to_world()
    return math.atan2(pose[1, 0], pose[0, 0])


def standing(home: Home) -> list[Instance]:
    """Return the furniture that stands on the floor, of classes that ProcTHOR has."""
    return [
        i
        for i in home.instances
        if not i.movable and i.position[2] < 0.01 and i.category in TYPES and i.category not in HUNG
    ]


def as_house(home: Home) -> dict[str, Any]:
    """Return rooms and standing furniture as a house."""
    return {
        "rooms": [
            {"id": r.name, "roomType": "Bedroom", "floorPolygon": [{"x": x, "y": 0, "z": y} for x, y in r.outline]}
            for r in home.stage.rooms
        ],
        "walls": [],
        "objects": [
            {
                "id": f"{TYPES[i.category]}|{number}",
                "assetId": i.model,
                "position": {"x": i.position[0], "y": home.model_of(i).size[2] / 2, "z": i.position[1]},
                "rotation": {"x": 0, "y": 180.0 - math.degrees(yaw(i)), "z": 0},
            }
            for number, i in enumerate(standing(home))
        ],
    }


def sizes_of(home: Home) -> dict[str, Any]:
    """Return the models of the furniture as a database of assets."""
    models = {i.model: home.model_of(i) for i in standing(home)}
    return {
        TYPES[m.category] + m.id: [
            {
                "assetId": m.id,
                "objectType": TYPES[m.category],
                "boundingBox": {"x": m.size[0], "y": m.size[2], "z": m.size[1]},
            }
        ]
        for m in models.values()
    }


def test_a_generated_home_comes_back(tmp_path: Path) -> None:
    home = next(iter(load_split("minival").homes.values()))
    (tmp_path / "house.json").write_text(json.dumps(as_house(home)))
    (tmp_path / "asset-database.json").write_text(json.dumps(sizes_of(home)))
    read = read_procthor_house(tmp_path / "house.json")
    pairs = list(zip(standing(home), read.home.instances, strict=True))
    assert len(pairs) > 15 and not read.unknown
    for put, found in pairs:
        assert found.model == put.model
        assert math.dist(found.position, put.position) < 1e-3, put.name
        assert wrap_angle(yaw(found) - yaw(put)) == pytest.approx(0.0, abs=1e-6)
    assert [room.outline for room in read.home.stage.rooms] == [room.outline for room in home.stage.rooms]
