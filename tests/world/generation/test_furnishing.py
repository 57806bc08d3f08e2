"""Where furniture is proposed, and which proposals a room takes."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Box, Model, Role, SupportSurface
from uniteam.world.generation.furniture import hanging, standing
from uniteam.world.generation.furniture.doors import fitting_leaves, open_leaves
from uniteam.world.generation.furniture.piece import Piece, Site
from uniteam.world.generation.furniture.room_floor import Volume
from uniteam.world.generation.furniture.rules import Arrangement
from uniteam.world.generation.objects.scatter import scatter
from uniteam.world.generation.objects.stock import ObjectStock
from uniteam.world.generation.plan.floor_shape import FloorShape
from uniteam.world.generation.plan.openings import PlannedOpening, PlannedWall
from uniteam.world.generation.plan.planned_room import PlannedRoom
from uniteam.world.generation.plan.rect import Rect
from uniteam.world.generation.style import TIDY
from uniteam.world.homes.home import Instance

ROOM = Rect(6, 6, 494, 394)


def model(width: float, depth: float, height: float, role: Role = "receptacle", category: str = "table") -> Model:
    """Return a box that holds things on its top."""
    outline = tuple((x * width / 2, y * depth / 2) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
    return Model(
        f"{category}_{width}_{depth}_{height}", role, category, category, (width, depth, height), 1.0, "test",
        (Box((0.0, 0.0, height / 2), (width, depth, height)),), (SupportSurface(height, outline, 3.0),),
        "here", "", "", "CC0", "", Path("box.glb"),
    )  # fmt: skip


def site(anchor: Piece | None = None, seed: int = 0) -> Site:
    window = Volume(Rect(150, 369, 300, 419), 90, 210)
    return Site(FloorShape(ROOM), 250, (window,), anchor, np.random.default_rng(seed))


def gap_behind(piece: Piece) -> int:
    """Return the distance (cm) from a piece's back to the wall behind it."""
    dx, dy = piece.front
    rect = piece.rect
    if dx:
        return rect.x0 - ROOM.x0 if dx > 0 else ROOM.x1 - rect.x1
    return rect.y0 - ROOM.y0 if dy > 0 else ROOM.y1 - rect.y1


@pytest.mark.parametrize("place", [standing.against_wall, standing.in_corner, standing.mid_wall])
def test_what_stands_at_a_wall_turns_its_back_to_it(place: Arrangement) -> None:
    proposals = list(place(site(), model(1.2, 0.5, 0.8)))
    assert {piece.quarters for piece in proposals} == {0, 1, 2, 3}
    assert all(0 <= gap_behind(piece) <= 3 for piece in proposals)
    assert all(ROOM.contains(piece.rect) for piece in proposals)


def test_the_corner_comes_first_or_last() -> None:
    wardrobe = model(1.0, 0.6, 2.0)
    first, *_, last = standing.in_corner(site(), wardrobe)
    assert min(abs(first.rect.x0 - ROOM.x0), abs(ROOM.x1 - first.rect.x1)) <= 3
    assert min(abs(last.rect.x0 - ROOM.x0), abs(ROOM.x1 - last.rect.x1)) > 100


@pytest.mark.parametrize("quarters", range(4))
def test_chairs_stand_around_a_table_and_face_it(quarters: int) -> None:
    table = Piece(model(1.6, 0.9, 0.75), 250, 200, quarters)
    chairs = list(standing.around(site(table), model(0.45, 0.5, 0.9)))
    assert len(chairs) == 2 * 2 + 2 * 1
    for chair in chairs:
        towards = np.array([table.x - chair.x, table.y - chair.y])
        ahead = towards @ chair.front
        assert ahead > 0 and ahead >= 0.3 * np.abs(towards).max()
        assert not chair.rect.overlaps(table.rect)
        assert chair.rect.grown(15).overlaps(table.rect)


@pytest.mark.parametrize("quarters", range(4))
def test_a_coffee_table_stands_in_front_of_its_couch_and_an_armchair_faces_it(quarters: int) -> None:
    couch = Piece(model(2.0, 0.9, 0.8), 250, 200, quarters)
    table = next(standing.before(site(couch), model(1.2, 0.6, 0.45)))
    offset = np.array([table.x - couch.x, table.y - couch.y])
    assert offset @ couch.front == np.abs(offset).sum()
    assert not table.rect.overlaps(couch.rect)
    for armchair in filled(standing.facing(site(table), model(0.8, 0.8, 0.9))):
        assert np.array([table.x - armchair.x, table.y - armchair.y]) @ armchair.front > 0


@pytest.mark.parametrize("quarters", range(4))
def test_bedside_tables_stand_left_and_right_with_their_backs_in_line(quarters: int) -> None:
    bed = Piece(model(1.6, 2.1, 0.5), 250, 200, quarters)
    left, right = standing.beside(site(bed), model(0.45, 0.4, 0.5))
    assert {left.quarters, right.quarters} == {quarters}
    assert not left.rect.overlaps(bed.rect) and not right.rect.overlaps(bed.rect)
    assert left.rect.grown(10).overlaps(bed.rect) and right.rect.grown(10).overlaps(bed.rect)
    backs = [np.array([piece.offset(0, piece.half_size[1])]) @ bed.front for piece in (bed, left, right)]
    assert backs[0] == backs[1] == backs[2]


def test_a_mirror_hangs_on_the_wall_above_its_sink() -> None:
    sink = Piece(model(0.6, 0.5, 0.9), 250, 394 - 27, 0)
    mirror = next(hanging.over(site(sink), model(0.6, 0.04, 0.9)))
    assert mirror.volume.bottom >= sink.volume.top
    assert abs(gap_behind(mirror) - gap_behind(sink)) <= 1


def test_a_television_stands_on_the_surface_of_its_stand() -> None:
    stand = Piece(model(1.5, 0.45, 0.487), 250, 30, 2)
    television = next(hanging.on_top(site(stand), model(1.1, 0.3, 0.7, "decor", "tv")))
    assert television.z == pytest.approx(48.7)
    assert stand.rect.contains(television.rect)
    assert not list(hanging.on_top(site(stand), model(1.8, 0.3, 0.7, "decor", "tv")))


def test_curtains_hang_at_a_window_they_cover() -> None:
    curtain = next(hanging.at_window(site(), model(1.7, 0.12, 2.2, "decor", "curtain")))
    assert curtain.x == 225 and curtain.quarters == 0
    assert curtain.volume.top > 210
    assert not list(hanging.at_window(site(), model(1.2, 0.12, 2.2, "decor", "curtain")))


def test_a_door_folds_back_beside_its_opening_and_leaves_it_free() -> None:
    plan = (
        PlannedRoom("hall_1", "hall", Rect(0, -150, 500, 0)), PlannedRoom("bedroom_1", "bedroom", Rect(0, 0, 500, 400))
    )  # fmt: skip
    opening = PlannedOpening("door", 200, 290, 0, 210)
    wall = PlannedWall(True, 0, 0, 500, (0, 1), (opening,))
    leaf = model(0.86, 0.1, 2.02, "door", "door")
    assert fitting_leaves([leaf, model(1.2, 0.1, 2.0, "door", "door")], opening) == [leaf]
    ways = list(open_leaves(plan, wall, opening, leaf, np.random.default_rng(0)))
    assert {room for room, _ in ways} == {0, 1}
    passage = wall.stretch(opening, 70)
    assert not any(piece.rect.overlaps(passage) for _, piece in ways)


def catalogue() -> Catalogue:
    models = [model(1.5, 0.8, 0.75)]
    for k in range(4):
        thing = model(0.08 + 0.02 * k, 0.08, 0.1, "object", f"thing{k}")
        models += [thing]
    return Catalogue({m.id: m for m in models}, frozenset({"thing0"}))


def tables() -> Iterator[Instance]:
    for k in range(12):
        yield Instance(
            f"table_{k}", "table_1.5_0.8_0.75", "table", False, (2.0 * k, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0), "room_1"
        )


def test_objects_are_scattered_within_their_surfaces_and_apart() -> None:
    rng = np.random.default_rng(5)
    things = scatter(list(tables()), {"room_1": "office"}, ObjectStock(catalogue(), "test", rng), TIDY.clutter, rng)
    assert len(things) >= 20
    places = np.array([thing.position for thing in things])
    assert (np.abs((places[:, 0] + 1.0) % 2.0 - 1.0) < 0.75 - 0.04).all()
    assert (np.abs(places[:, 1]) < 0.4 - 0.04).all()
    assert ((places[:, 2] > 0.75) & (places[:, 2] < 0.77)).all()
    gaps = np.linalg.norm(places[:, None] - places[None], axis=2) + np.eye(len(places))
    assert gaps.min() > 0.08
    per_table = np.bincount((places[:, 0] / 2.0).round().astype(int), minlength=12)
    assert per_table.max() >= 3 and per_table.min() == 0


def test_objects_do_not_go_where_a_television_stands() -> None:
    stock = catalogue()
    television = model(1.4, 0.7, 0.5, "decor", "tv")
    stock = Catalogue({**stock.models, television.id: television}, stock.unseen_categories)
    on_every_table = [
        Instance("", television.id, "tv", False, (2.0 * k, 0.0, 0.75), (1.0, 0.0, 0.0, 0.0), "room_1")
        for k in range(12)
    ]
    rng = np.random.default_rng(5)
    assert not scatter(
        [*tables(), *on_every_table], {"room_1": "office"}, ObjectStock(stock, "test", rng), TIDY.clutter, rng
    )


def test_training_homes_get_no_unseen_category() -> None:
    models = [m if m.role != "object" else Model(**{**vars(m), "pool": "train"}) for m in catalogue().models.values()]
    stock = ObjectStock(Catalogue({m.id: m for m in models}, frozenset({"thing0"})), "train", np.random.default_rng(0))
    rng = np.random.default_rng(1)
    assert {stock.choose("office", rng).category for _ in range(200)} == {"thing1", "thing2", "thing3"}
