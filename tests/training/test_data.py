"""Views, records, crops and the truth of cells: what the networks learn from."""

from pathlib import Path

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.mind.perception.learned.crops import CROP_SIZE
from uniteam.mind.perception.learned.kinds import Kind
from uniteam.training.augmentation import holed, relit
from uniteam.training.crop_samples import STORED_SIZE, crops_of
from uniteam.training.namer_data import JUNK, CropSampler, is_held_out, plain_batch
from uniteam.training.records import CropRecord, Crops, Thing, from_png, png, read_crops, things_of, write_records
from uniteam.training.segmenter_data import NO_RECEPTACLE, cell_truth
from uniteam.training.views import View, training_home, views_of
from uniteam.world.assets.catalogue import load_catalogue


@pytest.fixture(scope="module")
def seen() -> tuple[list[View], list[Thing], list[CropRecord]]:
    home, rng = training_home(0), np.random.default_rng(0)
    views, things = list(views_of(home, 6, rng)), things_of(home)
    return views, things, [crop for view in views for crop in crops_of(view, things, rng)]


def test_training_homes_hold_training_models_and_no_unseen_category() -> None:
    catalogue, home = load_catalogue(), training_home(2)
    for instance in filled(home.instances):
        assert home.model_of(instance).pool == "train"
        assert instance.category not in catalogue.unseen_categories


def test_views_are_the_same_stand_at_two_sizes(seen: tuple[list[View], list[Thing], list[CropRecord]]) -> None:
    for view in filled(seen[0]):
        agree = view.fine.instances[::2, ::2] == view.half.instances
        assert agree.mean() > 0.9
        assert 1.0 < view.camera_to_start[2, 3] < 1.6


def test_crops_are_of_things_and_of_pieces_and_last(
    seen: tuple[list[View], list[Thing], list[CropRecord]], tmp_path: Path
) -> None:
    crops = seen[2]
    assert any(crop.thing is None for crop in crops)
    assert any(crop.thing is not None and crop.thing.role == "object" for crop in crops)
    for crop in crops:
        mask = from_png(crop.mask)
        assert mask.shape == (STORED_SIZE, STORED_SIZE) and 0 < (mask > 127).mean() < 1
    write_records(tmp_path / "crops-0.msgpack", Crops(crops))
    assert read_crops([tmp_path / "crops-0.msgpack"]) == crops


def test_batches_bear_their_labels(seen: tuple[list[View], list[Thing], list[CropRecord]]) -> None:
    names = sorted({c.thing.category for c in seen[2] if c.thing is not None})
    batch = CropSampler(seen[2], names).batch(12, np.random.default_rng(0))
    again = CropSampler(seen[2], names).batch(12, np.random.default_rng(0))
    assert batch.crops.shape == (12, CROP_SIZE, CROP_SIZE, 3) and (batch.crops == again.crops).all()
    assert set(batch.labels) <= {JUNK, *range(len(names))} and len(set(batch.labels)) > 1
    plain = plain_batch(seen[2][:5], names)
    wanted = [JUNK if c.thing is None else names.index(c.thing.category) for c in seen[2][:5]]
    assert plain.labels.tolist() == wanted


def test_one_model_in_seven_or_so_is_held_out() -> None:
    models = [m.id for m in load_catalogue().models.values() if m.pool == "train"]
    share = np.mean([is_held_out(model) for model in models])
    assert 0.10 < share < 0.19


def test_the_truth_of_cells_keeps_small_things_and_parts_neighbours() -> None:
    things = [Thing("receptacle", "table", "t"), Thing("object", "cup", "a"), Thing("object", "cup", "b")]
    ids = np.full((40, 40), -1, dtype=np.int32)
    ids[12:32, 4:36] = 0
    ids[16:24, 8:16], ids[16:24, 16:24] = 1, 2
    ids[12:15, 28:31] = 1
    truth = cell_truth(ids, things, {"table": 7})
    assert truth.kinds[4, 2] == Kind.OBJECT and truth.kinds[7, 7] == Kind.RECEPTACLE and truth.kinds[0, 0] == Kind.STUFF
    assert truth.kinds[3, 7] == Kind.OBJECT
    assert truth.ends[4, 3] == 1.0 and truth.ends[4, 4] == 1.0 and truth.ends[4, 2] == 0.0
    assert truth.receptacles[7, 7] == 7 and truth.receptacles[4, 2] == NO_RECEPTACLE
    assert truth.weights[4, 2] > truth.weights[7, 7] > 0.0


def test_another_light_leaves_the_picture_recognisable() -> None:
    rgb = np.tile(np.arange(64, dtype=np.uint8)[:, None, None] * 4, (1, 64, 3))
    for seed in range(8):
        changed = relit(rgb, np.random.default_rng(seed))
        assert changed.shape == rgb.shape and changed.dtype == np.uint8
        assert np.corrcoef(changed[..., 1].ravel(), rgb[..., 1].ravel())[0, 1] > 0.8


def test_depth_gets_holes_and_noise_and_stays_a_depth() -> None:
    depth = np.full((64, 64), 2.0, dtype=np.float32)
    depth[:, 32:], depth[:8] = 4.0, 0.0
    worn = [holed(depth, np.random.default_rng(seed)) for seed in range(8)]
    assert all(image.min() >= 0.0 and (image[:8] == 0.0).all() for image in worn)
    assert any((image[20:, 30:34] == 0.0).any() for image in worn)
    assert any(np.abs(image[20:, 40:] - 4.0).max() > 0.02 for image in worn)


def test_images_are_kept_to_the_bit_where_they_must_be() -> None:
    image = np.arange(600, dtype=np.uint16).reshape(20, 30) * 100
    assert (from_png(png(image)) == image).all()
