"""A dataset of LeRobot, read without its writer and without LeRobot: it holds what the robot saw, felt and did."""

import json
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import av
import numpy as np
import pandas as pd
import pyarrow.parquet as pq
import pytest
from numpy.typing import NDArray
from worlds.filled import filled
from worlds.recorded import Played, Reciter, record

from uniteam.adapters.lerobot import film_series
from uniteam.adapters.lerobot.dataset import DatasetWriter
from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.recording.recording import read_recording
from uniteam.interface import Action, BaseDisplacement, DiscreteAction, JointDisplacement, Joints
from uniteam.stretch import HEAD_CAMERA_FULL, HEAD_CAMERA_HALF

LEFT = DiscreteAction.TURN_LEFT
SCRIPTS: tuple[tuple[Action, ...], ...] = (
    (LEFT, JointDisplacement(Joints(-0.25, 0.125, head_tilt=0.25)), DiscreteAction.MANIPULATION_MODE),
    (LEFT, LEFT, BaseDisplacement(heading=1.0), DiscreteAction.SNAP_OBJECT, LEFT),
)
HEAD, DEPTH = "observation.images.head", "observation.images.head_depth"


@dataclass(frozen=True)
class Made:
    """A dataset, and the episodes that it is of."""

    root: Path
    played: tuple[Played, ...]

    @property
    def info(self) -> dict[str, Any]:
        found: dict[str, Any] = json.loads((self.root / "meta" / "info.json").read_text())
        return found

    def rows(self) -> list[dict[str, Any]]:
        found: list[dict[str, Any]] = pq.read_table(self.root / "data/chunk-000/file-000.parquet").to_pylist()
        return found

    def episodes(self) -> list[dict[str, Any]]:
        path = self.root / "meta" / "episodes" / "chunk-000" / "file-000.parquet"
        found: list[dict[str, Any]] = pq.read_table(path).to_pylist()
        return found

    def steps(self) -> Iterator[Any]:
        return (step for played in self.played for step in played.steps)


def write(root: Path, played: tuple[Played, ...]) -> Made:
    root.mkdir()
    writer = DatasetWriter(root, HEAD_CAMERA_HALF, with_depth=True)
    for each in played:
        writer.add(read_recording(each.path))
    writer.finish()
    return Made(root, played)


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> tuple[Played, ...]:
    folder, spec = tmp_path_factory.mktemp("recordings"), AgentSpec("random", "truth")
    return tuple(
        record(folder / f"{episode}.zip", Reciter(script), spec, episode)
        for episode, script in zip((5, 6), SCRIPTS, strict=True)
    )


@pytest.fixture(scope="module")
def made(recorded: tuple[Played, ...], tmp_path_factory: pytest.TempPathFactory) -> Made:
    return write(tmp_path_factory.mktemp("dataset") / "made", recorded)


def test_each_step_has_a_row_of_what_was_felt_and_done(made: Made) -> None:
    names = {key: made.info["features"][key]["names"] for key in ("observation.state", "action")}
    rows, steps = made.rows(), list(made.steps())
    assert len(rows) == len(steps) == made.info["total_frames"] == 10
    for row, step in filled(zip(rows, steps, strict=True)):
        seen = step.observation
        felt = dict(zip(names["observation.state"], row["observation.state"], strict=True))
        assert felt["lift.pos"] == pytest.approx(seen.joints.lift)
        assert felt["head_pan.pos"] == pytest.approx(seen.joints.head_pan)
        assert felt["base_heading.pos"] == pytest.approx(seen.base_to_start.heading)
        assert felt["gripper.holding"] == float(seen.is_holding)
    done = [{name: x for name, x in zip(names["action"], row["action"], strict=True) if x != 0.0} for row in rows]
    turn = {"base_heading.delta": pytest.approx(math.radians(30.0))}
    assert done == [
        turn, {"lift.delta": -0.25, "arm.delta": 0.125, "head_tilt.delta": 0.25}, {"manipulation_mode": 1.0},
        {"stop": 1.0}, turn, turn, {"base_heading.delta": 1.0}, {"gripper": 1.0}, turn, {"stop": 1.0},
    ]  # fmt: skip


def test_rows_are_counted_over_all_and_within_their_episode(made: Made) -> None:
    rows, frames = made.rows(), [*range(4), *range(6)]
    assert [row["index"] for row in rows] == list(range(10))
    assert [row["frame_index"] for row in rows] == frames
    assert [row["episode_index"] for row in rows] == [0] * 4 + [1] * 6
    assert [row["timestamp"] for row in rows] == pytest.approx([k / made.info["fps"] for k in frames])
    assert [row["next.done"] for row in rows] == [False] * 3 + [True] + [False] * 5 + [True]
    assert not any(row["next.success"] for row in rows)


def test_the_reward_is_what_the_partial_success_grows_by(made: Made) -> None:
    rows = made.rows()
    for index, played in filled(enumerate(made.played)):
        own = sum(row["next.reward"] for row in rows if row["episode_index"] == index)
        assert own == pytest.approx(played.result.measures.partial_success)


def test_the_instruction_is_the_task_as_pandas_reads_it(made: Made) -> None:
    tasks = pd.read_parquet(made.root / "meta" / "tasks.parquet")
    asked = [played.result.instruction for played in made.played]
    assert tasks.index.tolist() == asked
    assert tasks["task_index"].tolist() == [0, 1]
    assert [episode["tasks"] for episode in made.episodes()] == [[words] for words in asked]
    assert [row["task_index"] for row in made.rows()] == [0] * 4 + [1] * 6


def frames_of(made: Made, key: str, array_format: str) -> list[tuple[float, NDArray[Any]]]:
    with av.open(str(made.root / "videos" / key / "chunk-000" / "file-000.mp4")) as film:
        return [(f.time, f.to_ndarray(format=array_format)) for f in film.decode(video=0)]


def place_of(made: Made, key: str, row: dict[str, Any]) -> float:
    """Return where in the film the picture of a row is (s), as a reader reckons."""
    begins: float = made.episodes()[row["episode_index"]][f"videos/{key}/from_timestamp"]
    return begins + row["timestamp"]


def test_the_film_shows_at_each_row_what_was_seen(made: Made) -> None:
    film = frames_of(made, HEAD, "rgb24")
    for k, (row, step) in filled(enumerate(zip(made.rows(), made.steps(), strict=True))):
        seen = step.observation.rgb.astype(float)
        errors = [np.abs(picture - seen).mean() for _, picture in film]
        assert errors[k] < 4.0
        assert errors[k] < min(errors) + 0.1
        assert film[k][0] == pytest.approx(place_of(made, HEAD, row), abs=1e-6)


def test_the_film_of_depth_holds_the_depth_of_each_row_to_a_level(made: Made) -> None:
    film, info = frames_of(made, DEPTH, "gray12le"), made.info["features"][DEPTH]["info"]
    assert info["is_depth_map"]
    assert info["depth_unit"] == "m"
    near, far, shift = (info[f"video.{name}"] for name in ("depth_min", "depth_max", "shift"))
    step_of = np.log((far + shift) / (near + shift)) / 4095
    for k, (row, step) in filled(enumerate(zip(made.rows(), made.steps(), strict=True))):
        metres = (near + shift) * np.exp(film[k][1].astype(float) * step_of) - shift
        expected = np.clip(step.observation.depth, near, far)
        assert np.abs(metres - expected).max() <= 0.51 * step_of * (far + shift)
        assert film[k][0] == pytest.approx(place_of(made, DEPTH, row), abs=1e-6)


def test_the_statistics_are_those_of_what_was_seen_and_done(made: Made) -> None:
    stats = json.loads((made.root / "meta" / "stats.json").read_text())
    actions = np.array([row["action"] for row in made.rows()])
    pixels = np.concatenate([step.observation.rgb.reshape(-1, 3) for step in made.steps()]) / 255.0
    depth = np.concatenate([step.observation.depth.ravel() for step in made.steps()])
    assert stats["action"]["count"] == [10]
    measures: dict[str, Callable[..., Any]] = {"min": np.min, "max": np.max, "mean": np.mean, "std": np.std}
    for name, measured in filled(measures.items()):
        assert np.allclose(stats["action"][name], measured(actions, axis=0))
        assert np.allclose(np.ravel(stats[HEAD][name]), measured(pixels, axis=0), atol=1e-6)
        assert np.allclose(np.ravel(stats[DEPTH][name]), measured(np.clip(depth, 0.01, 10.0)), atol=0.003)
    assert np.allclose(np.ravel(stats[HEAD]["q90"]), np.quantile(pixels, 0.9, axis=0), atol=1 / 255)
    assert np.shape(stats[HEAD]["q90"]) == (3, 1, 1)
    own = made.episodes()[1]["stats/action/mean"]
    assert np.allclose(own, actions[4:].mean(axis=0))


def test_an_episode_says_where_it_is_and_whose_it_was(made: Made) -> None:
    first, second = made.episodes()
    assert (first["dataset_from_index"], first["dataset_to_index"], first["length"]) == (0, 4, 4)
    assert (second["dataset_from_index"], second["dataset_to_index"], second["length"]) == (4, 10, 6)
    assert second[f"videos/{HEAD}/from_timestamp"] == first[f"videos/{HEAD}/to_timestamp"] == pytest.approx(0.4)
    assert second["uniteam/episode"] == made.played[1].result.episode
    assert second["uniteam/agent"] == "random"
    assert made.info["splits"] == {"train": "0:2"}


def test_a_large_film_is_followed_by_another(
    recorded: tuple[Played, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(film_series, "VIDEO_FILE_MB", 0)
    made = write(tmp_path / "made", recorded)
    first, second = made.episodes()
    assert (first[f"videos/{HEAD}/file_index"], second[f"videos/{HEAD}/file_index"]) == (0, 1)
    assert second[f"videos/{HEAD}/from_timestamp"] == 0.0
    with av.open(str(made.root / "videos" / HEAD / "chunk-000" / "file-001.mp4")) as film:
        assert len(list(film.decode(video=0))) == 6


def test_the_same_recordings_give_the_same_files(made: Made, recorded: tuple[Played, ...], tmp_path: Path) -> None:
    again = write(tmp_path / "made", recorded).root
    files = filled(sorted(path.relative_to(again) for path in again.rglob("*") if path.is_file()))
    for file in files:
        assert (again / file).read_bytes() == (made.root / file).read_bytes()


def test_what_makes_no_dataset_is_refused(recorded: tuple[Played, ...], tmp_path: Path) -> None:
    with pytest.raises(InvalidInputError, match="at least one episode"):
        DatasetWriter(tmp_path, HEAD_CAMERA_HALF, with_depth=False).finish()
    with pytest.raises(InvalidInputError, match="pictures of 320x240, those before it of 640x480"):
        DatasetWriter(tmp_path, HEAD_CAMERA_FULL, with_depth=False).add(read_recording(recorded[0].path))
