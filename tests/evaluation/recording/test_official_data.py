"""Recordings of the challenge's own episodes, whose homes no file of ours can say: they are read again."""

import shutil
from pathlib import Path

import pytest

pytest.importorskip("alktx2", reason="the encoder has wheels for Linux only")

from worlds.ovmm_miniature.tiny import write_tiny
from worlds.recorded import Reciter

from uniteam.errors import UniteamError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.configuration import Run, resolve
from uniteam.evaluation.episode_loop import play_episode
from uniteam.evaluation.recording.body import RecordedBody
from uniteam.evaluation.recording.provenance import provenance_of
from uniteam.evaluation.recording.recorder import Recorder
from uniteam.evaluation.recording.recording import read_recording
from uniteam.interface import DiscreteAction
from uniteam.world.task.environment import Environment
from uniteam.world.task.splits import load_split


def test_an_episode_is_recorded_and_plays_again_while_its_data_is_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = write_tiny(tmp_path / "data")
    monkeypatch.chdir(tmp_path)
    name, spec = f"ovmm:{folder.relative_to(tmp_path)}", AgentSpec("random", "truth")
    split = load_split(name)
    (episode,) = split.episodes
    environment = Environment(split.homes[episode.home], episode)
    configuration = resolve(Run(name, {"random": spec}, "truth", "half"), split)
    recorder = Recorder(environment, provenance_of("random", spec, name, configuration))
    script = (DiscreteAction.TURN_LEFT, DiscreteAction.MOVE_FORWARD)
    result = play_episode(environment, Reciter(script), recorder)
    recorder.write(tmp_path / "made.zip", result)

    monkeypatch.chdir("/")
    recording = read_recording(tmp_path / "made.zip")
    assert recording.episode == episode
    assert recording.result == result
    body = RecordedBody(recording)
    body.reset()
    for action in (*script, DiscreteAction.STOP):
        body.step(action)  # compares each picture with what was seen
    assert body.is_over

    shutil.rmtree(tmp_path / "data")
    with pytest.raises(UniteamError, match=r"data"):
        _ = read_recording(tmp_path / "made.zip").episode


def test_a_recording_is_refused_where_its_data_has_become_another(tmp_path: Path) -> None:
    folder = write_tiny(tmp_path / "data")
    name, spec = f"ovmm:{folder}", AgentSpec("random", "truth")
    split = load_split(name)
    (episode,) = split.episodes
    environment = Environment(split.homes[episode.home], episode)
    recorder = Recorder(environment, provenance_of("random", spec, "minival", {"agents": {"random": {}}}))
    recorder.write(tmp_path / "made.zip", play_episode(environment, Reciter(()), recorder))
    with pytest.raises(UniteamError, match="'minival', on which it was played, does not have its home any more"):
        _ = read_recording(tmp_path / "made.zip").home
