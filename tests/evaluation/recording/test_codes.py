"""Depth, segmentations, maps and wishes as they are written, and back."""

from pathlib import Path

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.errors import InvalidInputError
from uniteam.evaluation.recording.depth_code import RELATIVE_ERROR, decode_depth, encode_depth
from uniteam.evaluation.recording.label_video import LabelEncoder, decode_labels
from uniteam.evaluation.recording.map_track import MapWriter, read_maps
from uniteam.evaluation.recording.order import (
    ACTION_SUFFIX,
    forget_recordings,
    is_failure,
    recording_order,
    recording_path,
)
from uniteam.evaluation.recording.step_line import MapLine
from uniteam.interface import Detection, MapOverlay, Segmentation


def test_depth_comes_back_to_one_percent_from_ten_centimetres_to_ten_metres() -> None:
    depth = np.random.default_rng(0).uniform(0.1, 10.0, (200, 301)).astype(np.float32)
    depth[::4, ::4] = 0.0
    back = decode_depth(encode_depth(depth))
    kept = depth[::2, ::2]
    assert back.shape == kept.shape == (100, 151)
    assert np.array_equal(back == 0.0, kept == 0.0)
    assert np.allclose(back, kept, rtol=RELATIVE_ERROR, atol=0.0)
    assert decode_depth(encode_depth(np.array([[100_000.0]], np.float32))) == pytest.approx(10.0)


def test_segmentations_come_back_exactly_however_many_detections_there_are() -> None:
    rng = np.random.default_rng(1)
    counts = (3, 0, 254, 255, 700, 2)
    images = [
        Segmentation(rng.integers(-1, n, (47, 61)).astype(np.int16), (Detection((("cup", 1.0),)),) * n) for n in counts
    ]
    encoder = LabelEncoder(47, 61)
    for image in images:
        encoder.add(image)
    for back, image in filled(zip(decode_labels(*encoder.finish(), 47, 61), images, strict=True)):
        assert np.array_equal(back, image.instances)


def test_maps_come_back_though_their_window_moves_grows_and_shrinks() -> None:
    rng = np.random.default_rng(2)
    frames = [
        ((0.0, 0.0), (5, 7)),
        ((-0.1, 0.05), (9, 8)),
        ((0.1, 0.1), (3, 4)),
        ((3.0, 3.0), (4, 4)),
        ((0.0, 0.0), (6, 6)),
    ]
    maps = [
        MapOverlay(
            rng.integers(0, 9, shape).astype(np.uint8), origin, 0.05, rng.random((k, 2)), None, rng.random((1, 2))
        )
        for k, (origin, shape) in enumerate(frames)
    ]
    writer = MapWriter()
    lines = []
    for one in maps:
        changed = writer.add(one)
        lines.append(MapLine(one.origin, 0.05, (len(one.labels), len(one.labels[0])), changed, len(one.goal), 1))
    for back, one in filled(zip(read_maps(lines, writer.arrays()), maps, strict=True)):
        assert back is not None
        assert np.array_equal(back.labels, one.labels)
        assert np.allclose(back.goal, one.goal, atol=1e-6) and np.allclose(back.path, one.path, atol=1e-6)


def test_a_wish_says_which_episodes_are_recorded(tmp_path: Path) -> None:
    ids = ["a", "b", "c"]
    assert recording_order(None, tmp_path, ids).episodes == frozenset()
    assert recording_order("all", tmp_path, ids).episodes == frozenset(ids)
    assert recording_order("failures", tmp_path, ids).is_kept is is_failure
    assert recording_order("2", tmp_path, ids).episodes == {"a", "b"}
    alone = recording_order("actions", tmp_path, ids)
    assert (alone.episodes, alone.path("x", "a")) == (frozenset(ids), tmp_path / "x" / "a.actions.gz")
    for wrong in ("0", "-1", "most", "", "1.5"):
        with pytest.raises(InvalidInputError, match="--record takes"):
            recording_order(wrong, tmp_path, ids)


def test_each_agent_and_episode_has_a_file_of_its_own_inside_the_folder(tmp_path: Path) -> None:
    labels = ["uniteam", "..", ".", "a/b", "a%2Fb", "my_agent:Spinner", "x" * 300, "x" * 301, "uniteam without a, b"]
    paths = {recording_path(tmp_path, label, episode) for label in labels for episode in ("home-1", "../1")}
    assert len(paths) == 2 * len(labels)
    assert all(path.resolve().parent.parent == tmp_path.resolve() for path in paths)
    assert recording_path(tmp_path, "uniteam without a, b", "e").parent.name == "uniteam without a, b"


def test_what_a_killed_process_left_of_a_recording_is_removed(tmp_path: Path) -> None:
    path = recording_path(tmp_path, "uniteam", "e_1")
    path.parent.mkdir()
    other = path.with_name("e_10.zip")
    actions = recording_path(tmp_path, "uniteam", "e_1", ACTION_SUFFIX)
    for one in (path, path.with_name("e_1.zip.4711.partial"), actions, other):
        one.write_bytes(b"half")
    forget_recordings(tmp_path, "uniteam", "e_1")
    assert list(path.parent.iterdir()) == [other]
