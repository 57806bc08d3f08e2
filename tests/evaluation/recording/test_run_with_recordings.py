"""A run that records: what lies in its folder agrees with its results."""

from dataclasses import replace
from pathlib import Path

from worlds.filled import filled

from uniteam.evaluation.agent_spec import label_agents
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.episode_choice import choose_episodes
from uniteam.evaluation.evaluation import Evaluation
from uniteam.evaluation.recording.order import recording_path
from uniteam.evaluation.recording.recording import read_recording
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import load_split, write_split


def ignore(*outcome: object) -> None:
    """Hear of a result or a loss and do nothing."""


def test_each_kept_result_has_its_recording_and_only_those(tmp_path: Path) -> None:
    """The oracle solves the first episode; over the second, which has lost its certificate, it stumbles."""
    minival = load_split("minival")
    first, second = (minival.episodes[k] for k in choose_episodes(minival.episodes, 2))
    homes = {episode.home: minival.homes[episode.home] for episode in (first, second)}
    write_split(Split("two", (first, replace(second, certificate=None)), homes), tmp_path / "two.jsonl.gz")
    run = Run(str(tmp_path / "two.jsonl.gz"), label_agents(("oracle",), "truth"), "truth", "half")
    for wish, recorded in {"all": [first.id, second.id], "failures": [second.id]}.items():
        stale = recording_path(tmp_path / wish / "recordings", "oracle", first.id)
        stale.parent.mkdir(parents=True)
        stale.write_bytes(b"of a run that was killed")
        with Evaluation(run, tmp_path / wish) as evaluation:
            evaluation.play(1, ignore, ignore, record=wish)
            evaluation.write_summary()
        found = sorted(stale.parent.iterdir())
        assert found == sorted(recording_path(tmp_path / wish / "recordings", "oracle", e) for e in recorded)
        for path in filled(found):
            recording = read_recording(path)
            assert recording.result == evaluation.store.results["oracle"][recording.episode.id]
            assert recording.header.configuration == evaluation._configuration
        assert (tmp_path / wish / "home-robot" / "oracle" / "episode_results.json").is_file()
