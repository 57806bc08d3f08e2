"""`uniteam export`: from a run's folder to a file or folder of another program, whole or not at all."""

import json
import sys
from pathlib import Path

import pytest
from worlds.called import call
from worlds.recorded import Reciter, record
from worlds.runs import write_run

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.interface import DiscreteAction


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a run of one episode, a failure, which two agents have played and one has recorded."""
    folder = tmp_path_factory.mktemp("runs")
    played = record(folder / "own.zip", Reciter((DiscreteAction.TURN_LEFT,) * 2), AgentSpec("random", "truth"))
    made = write_run(folder / "run", {"random": [played.result], "baseline": [played.result]}, split="minival")
    recording = made / "recordings" / "random" / f"{played.result.episode}.zip"
    recording.parent.mkdir(parents=True)
    played.path.rename(recording)
    return made


def test_a_run_becomes_a_dataset(
    run: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert call("export", "lerobot", str(run), "--out", "a/dataset", "--depth") == 0
    assert "Dataset: a/dataset (1 episodes, 3 steps" in capsys.readouterr().out
    info = json.loads(Path("a/dataset/meta/info.json").read_text())
    assert info["total_episodes"] == 1
    assert "observation.images.head_depth" in info["features"]
    assert [path.name for path in Path("a").iterdir()] == ["dataset"]


def test_depth_is_left_out_unless_asked_for(run: Path, tmp_path: Path) -> None:
    (recording,) = (run / "recordings" / "random").iterdir()
    assert call("export", "lerobot", str(recording), "--out", str(tmp_path / "dataset")) == 0
    features = json.loads((tmp_path / "dataset" / "meta" / "info.json").read_text())["features"]
    assert [key for key in features if "images" in key] == ["observation.images.head"]


def test_a_recording_becomes_a_file_for_rerun(
    run: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("rerun", reason="the extra 'rerun' is not installed")
    (recording,) = (run / "recordings" / "random").iterdir()
    monkeypatch.chdir(tmp_path)
    assert call("export", "rerun", f"{run}:random", recording.stem) == 0
    written = Path(f"{recording.stem}.rrd")
    assert written.name in capsys.readouterr().out
    assert written.read_bytes().startswith(b"RRF")
    assert list(tmp_path.iterdir()) == [tmp_path / written]


def test_a_library_that_is_missing_is_named(
    run: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (recording,) = (run / "recordings" / "random").iterdir()
    monkeypatch.setitem(sys.modules, "rerun", None)
    assert call("export", "rerun", str(recording), "--out", str(tmp_path / "episode.rrd")) == 2
    assert "install it with pip install 'uniteam[rerun]'" in capsys.readouterr().err.replace("\n", " ")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("lerobot",), "give recordings: FILE.zip, or the folder of a run"),
        (("lerobot", "RUN:baseline"), "has no recording; play it with 'uniteam evaluate --record all'"),
        (("lerobot", "RUN", "--successes"), "of 1 recordings none is an overall success"),
        (("lerobot", "RUN", "--out", "."), "'.' is there already"),
        (("lerobot", "none.zip"), "the recording 'none.zip' cannot be read"),
        (("rerun",), "0 words name no recording"),
        (("rerun", "a.zip", "b.zip"), "a file for Rerun is of one recording"),
        (("rerun", "none.zip"), "the recording 'none.zip' cannot be read"),
        (("rerun", "none.zip", "--out", "none.txt"), "'none.txt' must end in .rrd"),
    ],
)
def test_what_cannot_be_exported_is_answered_in_one_sentence_and_leaves_nothing(
    arguments: tuple[str, ...],
    sentence: str,
    run: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert call("export", *(word.replace("RUN", str(run)) for word in arguments)) == 2
    assert sentence in capsys.readouterr().err.replace("\n", " ")
    assert list(tmp_path.iterdir()) == []
