"""What a replay page carries: the maps, where runs part, and words that nobody can break out with."""

import base64
import gzip
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from worlds.filled import filled
from worlds.recorded import Reciter, record

from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.recording.recording import Recording, read_recording
from uniteam.interface import BaseDisplacement, DiscreteAction, MapOverlay
from uniteam.visualization.html_file import PageParts, html_file
from uniteam.visualization.replay_page.first_parting import Parting, first_parting
from uniteam.visualization.replay_page.map_changes import map_data
from uniteam.visualization.replay_page.packing import packed

LEFT, RIGHT = DiscreteAction.TURN_LEFT, DiscreteAction.TURN_RIGHT
KINDS = {"Uint8Array": "u1", "Uint16Array": "<u2", "Uint32Array": "<u4", "Int16Array": "<i2", "Float32Array": "<f4"}


def unpacked(data: dict[str, str]) -> NDArray[Any]:
    return np.frombuffer(gzip.decompress(base64.b64decode(data["content"])), KINDS[data["kind"]])


def test_arrays_come_back_as_they_were_packed() -> None:
    for kind in filled(KINDS.values()):
        array = np.arange(7).astype(kind)
        assert np.array_equal(unpacked(packed(array)), array)


def overlay(origin: tuple[float, float], shape: tuple[int, int], seed: int, cell_size: float = 0.05) -> MapOverlay:
    rng = np.random.default_rng(seed)
    labels = rng.integers(0, 9, shape).astype(np.uint8)
    return MapOverlay(labels, origin, cell_size, rng.random((seed, 2)), (0.5, -1.0), rng.random((2, 2)))


def test_maps_can_be_gone_through_to_and_fro_in_one_frame() -> None:
    frames = [((0.0, 0.0), (5, 7)), ((-0.1, 0.05), (9, 8)), ((0.1, 0.1), (3, 4))]
    maps = [overlay(origin, shape, seed) for seed, (origin, shape) in enumerate(frames, start=1)]
    data = map_data([maps[0], None, *maps[1:]])
    assert data is not None
    counts, ways, changes = (unpacked(data[name]) for name in ("counts", "ways", "changes"))
    assert counts[1] == 0
    assert data["origin"] == pytest.approx([-0.1, 0.0])
    starts = [0, *np.cumsum(counts).tolist()]
    labels = np.zeros(data["rows"] * data["columns"], np.uint8)
    states = []
    for first, past in pairwise(starts):
        labels[np.cumsum(ways[first:past])] ^= changes[first:past]
        states.append(labels.copy())
    for state, one in filled(zip((states[0], *states[2:]), maps, strict=True)):
        left = round((one.origin[0] - data["origin"][0]) / 0.05)
        low = round((one.origin[1] - data["origin"][1]) / 0.05)
        whole = state.reshape(data["rows"], data["columns"])
        rows, columns = one.labels.shape
        assert np.array_equal(whole[low : low + rows, left : left + columns], one.labels)
        assert np.count_nonzero(whole) == np.count_nonzero(one.labels)


def test_the_points_of_goal_and_path_are_kept_to_a_centimetre_and_once() -> None:
    one = overlay((0.0, 0.0), (4, 4), 3)
    data = map_data([one, one])
    assert data is not None
    lengths, points = unpacked(data["lengths"]), unpacked(data["points"]).reshape(-1, 2)
    assert lengths.tolist() == [3, 2]
    assert np.allclose(points / 100.0, np.vstack([one.goal, one.path]), atol=0.006)
    assert unpacked(data["goal"]).tolist() == [0, 0]
    assert unpacked(data["path"]).tolist() == [1, 1]


def test_a_map_of_other_cells_is_left_out_and_without_any_map_there_is_none() -> None:
    data = map_data([overlay((0.0, 0.0), (4, 4), 1), overlay((0.0, 0.0), (4, 4), 2, cell_size=0.1)])
    assert data is not None
    assert unpacked(data["counts"])[1] == 0
    assert map_data([None, None]) is None


def recited(path: Path, script: tuple[DiscreteAction | BaseDisplacement, ...], episode: int = 5) -> Recording:
    record(path, Reciter(script), AgentSpec("random", "truth"), episode)
    return read_recording(path)


def test_two_runs_part_where_their_robots_do_different_things(tmp_path: Path) -> None:
    one = recited(tmp_path / "one.zip", (LEFT, LEFT, LEFT))
    other = recited(tmp_path / "other.zip", (LEFT, LEFT, RIGHT))
    assert first_parting(one, one) == Parting(None, None)
    assert first_parting(one, other) == Parting(2, 2)
    shorter = recited(tmp_path / "shorter.zip", (LEFT,))
    assert first_parting(one, shorter) == Parting(1, 1)
    crashed = read_recording(one.path)
    crashed.steps = crashed.steps[:2]
    assert first_parting(one, crashed) == first_parting(crashed, one) == Parting(2, 2)
    stranger = recited(tmp_path / "stranger.zip", (LEFT,), episode=6)
    with pytest.raises(InvalidInputError, match="two recordings of the same episode"):
        first_parting(one, stranger)


def test_no_words_end_the_element_that_the_data_lies_in() -> None:
    parts = PageParts("uniteam.visualization.report_page", "page.html", (), ())
    page = html_file(parts, "</title><script>", {"words": "</script><script>alert(1)</script><!--\u2028"})
    assert page.count("</script>") == 2
    assert "<!--" not in page
    assert "</title><script>" not in page
