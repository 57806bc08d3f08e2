"""Houses of the miniature as homes: what stands where, what stands in for what, and what is left out."""

import gzip
import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from worlds.procthor_miniature import ASSETS, first_house, on, thing, write_miniature

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.home import Home, Instance
from uniteam.world.homes.readers.procthor.house import read_procthor_house
from uniteam.world.homes.readers.procthor.stand_ins import misfit


@pytest.fixture
def houses(tmp_path: Path) -> Path:
    """Return the file of the miniature's houses."""
    return write_miniature(tmp_path)


def one(home: Home, category: str) -> Instance:
    """Return the only instance of a category."""
    (found,) = home.of_category(category)
    return found


def front(instance: Instance) -> tuple[float, float]:
    """Return the unit vector that an instance faces (world)."""
    x, y, _ = instance.model_to_world()[:3, :3] @ [0.0, -1.0, 0.0]
    return float(x), float(y)


def test_furniture_faces_as_the_house_says_with_its_back_where_the_assets_was(houses: Path) -> None:
    home = read_procthor_house(houses).home
    couch = one(home, "couch")
    assert front(couch) == pytest.approx((1.0, 0.0), abs=1e-9)
    assert couch.position[1] == pytest.approx(2.4)
    back = couch.position[0] - home.model_of(couch).size[1] / 2
    assert back == pytest.approx(0.5 - ASSETS["Sofa_Mini_1"][2] / 2)
    assert front(one(home, "chest_of_drawers")) == pytest.approx((1.0, 0.0), abs=1e-9)
    assert front(one(home, "bed")) == pytest.approx((0.0, -1.0), abs=1e-9)


def test_what_hangs_hangs_as_high_and_what_stands_on_something_stands_on_it(houses: Path) -> None:
    home = read_procthor_house(houses).home
    picture, tv, cabinet = one(home, "picture"), one(home, "tv"), one(home, "cabinet")
    assert picture.position[2] + home.model_of(picture).size[2] / 2 == pytest.approx(1.5)
    assert tv.position[2] in {surface.height for surface in home.model_of(cabinet).surfaces}
    assert math.dist(tv.position[:2], cabinet.position[:2]) < 0.1


def test_small_objects_lie_within_a_surface_of_what_they_lay_on_and_apart(houses: Path) -> None:
    home = read_procthor_house(houses).home
    counter = one(home, "counter")
    surfaces = home.model_of(counter).surfaces
    things = [i for i in home.instances if i.movable and math.dist(i.position[:2], counter.position[:2]) < 1.0]
    assert {i.category for i in things} == {"apple", "bowl", "cup"}
    inverse = np.linalg.inv(counter.model_to_world())
    for each in things:
        x, y, z = (inverse @ [*each.position, 1.0])[:3]
        top = min(surfaces, key=lambda surface: abs(surface.height - z))
        assert 0.0 < z - top.height < 0.01
        xs, ys = zip(*top.outline, strict=True)
        assert min(xs) <= x <= max(xs) and min(ys) <= y <= max(ys)
    places = {each.category: each.position[0] for each in things}
    assert places["bowl"] < places["apple"] < places["cup"]  # from west to east, as in the house


def test_on_a_turned_table_things_lie_where_they_lay(houses: Path) -> None:
    home = read_procthor_house(houses).home
    remote, books = one(home, "remote_control"), home.of_category("book")
    assert remote.position[:2] == pytest.approx((2.05, 2.6), abs=0.05)
    assert min(math.dist(book.position[:2], (2.0, 2.2)) for book in books) < 0.05


def test_the_stand_in_is_the_nearest_in_size_of_those_kept_from_training(houses: Path) -> None:
    home, library = read_procthor_house(houses).home, load_catalogue()
    _, width, depth, height = ASSETS["Sofa_Mini_1"]
    chosen = home.model_of(one(home, "couch"))
    rivals = library.of_category("couch", "test")
    assert chosen in rivals
    assert misfit(chosen, (width, depth, height)) == min(misfit(m, (width, depth, height)) for m in rivals)


def test_without_the_database_the_height_above_the_floor_chooses(houses: Path) -> None:
    (houses.parent / "asset-database.json").unlink()
    home = read_procthor_house(houses).home
    shelves = home.model_of(one(home, "shelves"))
    heights = [model.size[2] for model in load_catalogue().of_category("shelves", "test")]
    assert abs(math.log(shelves.size[2] / 1.8)) == pytest.approx(min(abs(math.log(h / 1.8)) for h in heights))


def test_what_has_no_like_is_counted_and_what_lay_on_it_too(houses: Path) -> None:
    house = read_procthor_house(houses)
    assert house.unknown == {"DogBed": 1, "Lettuce": 1}
    assert house.no_place == {"Pillow": 1}
    entries = sum(1 + len(entry["children"]) for entry in first_house()["objects"])
    assert len(house.home.instances) == entries - 3


def test_types_come_from_ids_and_assets_where_there_is_no_database(tmp_path: Path) -> None:
    house = first_house() | {
        "objects": [
            {**thing("2|0", "Sofa_Mini_1", (2.0, 2.0), 0), "assetId": "RoboTHOR_sofa_ektorp"},
            {**thing("Bed|2|1", "Bed_Mini_1", (2.0, 3.5), 0), "assetId": "nothing_known"},
            {**thing("2|2", "Bed_Mini_1", (1.0, 1.0), 0), "assetId": "Zeppelin_12"},
        ]
    }
    path = tmp_path / "house.json"
    path.write_text(json.dumps(house))
    read = read_procthor_house(path)
    assert sorted(i.category for i in read.home.instances) == ["bed", "couch"]
    assert read.unknown == {"Zeppelin": 1}


def test_a_full_shelf_takes_no_more(houses: Path) -> None:
    plates = [on("Plate_Mini_1", (1.75, 1.0), 0.6) for _ in range(60)]
    house = first_house() | {"objects": [thing("SideTable|2|0", "Side_Table_Mini_1", (1.75, 1.0), 0, plates)]}
    path = houses.parent / "full.json"
    path.write_text(json.dumps(house))
    read = read_procthor_house(path)
    assert 0 < len(read.home.of_category("plate")) < 60
    assert len(read.home.of_category("plate")) + read.no_place["Plate"] == 60


def _write(path: Path, edit: Callable[[dict[str, Any]], object]) -> Path:
    house = first_house()
    edit(house)
    path.write_bytes(gzip.compress((json.dumps(house) + "\n").encode()))
    return path


@pytest.mark.parametrize(
    ("edit", "sentence"),
    [
        (lambda h: h.pop("rooms"), r"missing required field `rooms`"),
        (lambda h: h["rooms"][1].update(floorPolygon=[]), r"`rooms\[1\].floorPolygon`"),
        (lambda h: h["objects"][0]["position"].update(x="west"), r"Expected `float`, got `str` - at `objects"),
        (lambda h: h["objects"][0]["position"].update(x=1e9), r"`float` <= 1000.0"),
        (lambda h: h["walls"][0].update(polygon=[{"x": 0, "z": 0}]), r"`array` of length >= 4"),
        (lambda h: h["rooms"][0]["floorPolygon"].reverse() or h["rooms"][0]["floorPolygon"].insert(0, {"x": 5, "z": 9}),
         r"its outline crosses or touches itself"),
        (lambda h: h["doors"][0].pop("holePolygon"), r"has neither a holePolygon nor a boundingBox"),
    ],
)  # fmt: skip
def test_a_bad_house_is_told_in_a_sentence(
    tmp_path: Path, edit: Callable[[dict[str, Any]], object], sentence: str
) -> None:
    path = _write(tmp_path / "bad.jsonl.gz", edit)
    with pytest.raises(DamagedFileError, match=sentence) as raised:
        read_procthor_house(path)
    assert "house 0 of" in str(raised.value) and "mend it or write it anew" in str(raised.value)


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"version https://git-lfs.github.com/spec/v1\noid sha256:4a\nsize 5024660\n", "it is a pointer of Git LFS"),
        (b"no gzip at all", "not a gzipped file"),
        (gzip.compress(b"{}\n" * 1000, mtime=0)[:-20], "end-of-stream"),
        (gzip.compress(b"{not json\n", mtime=0), "malformed"),
        (gzip.compress(b"[" * 100_000 + b"\n", mtime=0), "house 0 of"),
    ],
)
def test_a_bad_file_is_told_in_a_sentence(tmp_path: Path, content: bytes, sentence: str) -> None:
    path = tmp_path / "bad.jsonl.gz"
    path.write_bytes(content)
    with pytest.raises(DamagedFileError, match=sentence):
        read_procthor_house(path, 999 if "stream" in sentence else 0)


def test_a_house_that_there_is_not_is_told_with_the_number_of_those_there_are(houses: Path) -> None:
    with pytest.raises(InvalidInputError, match="holds 2 houses, counted from 0; there is no house 2"):
        read_procthor_house(houses, 2)
    with pytest.raises(InvalidInputError, match="there is no file"):
        read_procthor_house(houses.parent / "none.jsonl.gz")
