"""A whole evaluation: real episodes in worker processes, from nothing to the table."""

import gzip
import json
import pickle
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path

import pytest

from uniteam.errors import InvalidInputError, UniteamError
from uniteam.evaluation.agent_spec import AgentSpec, label_agents
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.episode_choice import choose_episodes
from uniteam.evaluation.evaluation import Evaluation
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import load_split, write_split

RANDOM = {"random": AgentSpec("random", "truth")}


@pytest.fixture(scope="module")
def two_episodes(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A split of two episodes in two homes; the second has lost its certificate, over which the oracle stumbles."""
    minival = load_split("minival")
    first, second = (minival.episodes[k] for k in choose_episodes(minival.episodes, 2))
    homes = {episode.home: minival.homes[episode.home] for episode in (first, second)}
    path = tmp_path_factory.mktemp("split") / "two.jsonl.gz"
    write_split(Split("two", (first, replace(second, certificate=None)), homes), path)
    return path


def ignore(*outcome: object) -> None:
    """Hear of a result or a loss and do nothing."""


@pytest.fixture(scope="module")
def evaluation(two_episodes: Path, tmp_path_factory: pytest.TempPathFactory) -> Evaluation:
    """The random agent and the oracle, played on that split by two workers."""
    run = Run(str(two_episodes), label_agents(("random", "oracle"), "truth"), "truth", "half")
    with Evaluation(run, tmp_path_factory.mktemp("run")) as evaluation:
        evaluation.play(2, ignore, ignore)
        evaluation.write_summary()
    return evaluation


def test_every_agent_plays_every_episode_and_the_oracle_succeeds(evaluation: Evaluation) -> None:
    results = evaluation.store.results
    ids = {episode.id for episode in evaluation.split.episodes}
    assert {agent: set(of_agent) for agent, of_agent in results.items()} == {"random": ids, "oracle": ids}
    solved = results["oracle"][evaluation.split.episodes[0].id]
    assert solved.measures.overall_success
    assert solved.failure == ""
    assert max(result.peak_memory for result in results["oracle"].values()) < 1500


def test_a_crash_is_recorded_with_its_traceback_and_counts_as_a_failure(evaluation: Evaluation) -> None:
    crashed = evaluation.store.results["oracle"][evaluation.split.episodes[1].id]
    assert "has no certificate" in crashed.failure
    assert "Traceback" in crashed.traceback
    summary = json.loads((evaluation.store.directory / "summary.json").read_text())
    assert summary["oracle"]["overall_success"]["mean"] == 0.5
    assert summary["oracle"]["crash_count"] == 1


def test_the_summary_says_what_it_is_from(evaluation: Evaluation) -> None:
    summary = json.loads((evaluation.store.directory / "summary.json").read_text())
    assert list(summary) == ["random", "oracle"] or list(summary) == ["oracle", "random"]
    random = summary["random"]
    source = {
        "split": "two",
        "perception": "truth",
        "camera": "half",
        "grasp": "challenge",
        "version": version("uniteam"),
        "episode_count": 2,
    }
    assert {name: random[name] for name in source} == source
    assert 0.0 <= random["num_steps"]["low"] <= random["num_steps"]["mean"] <= random["num_steps"]["high"]


def test_a_finished_run_is_taken_up_with_nothing_left_to_play(evaluation: Evaluation) -> None:
    with Evaluation(evaluation.run, evaluation.store.directory) as again:
        assert again.remaining == []
        assert again.summaries() == evaluation.summaries()


def test_figures_are_of_the_episodes_asked_for(evaluation: Evaluation) -> None:
    with Evaluation(replace(evaluation.run, episode_count=1), evaluation.store.directory) as first:
        assert {agent: summary.episode_count for agent, summary in first.summaries().items()} == {
            "random": 1,
            "oracle": 1,
        }
        assert first.summaries()["oracle"].estimates["overall_success"].mean == 1.0


def test_results_that_are_missing_are_played_again_and_are_the_same(evaluation: Evaluation, tmp_path: Path) -> None:
    """One worker, another order, another process: an episode is what its seed makes it."""
    shown: list[tuple[str, EpisodeResult]] = []
    with Evaluation(replace(evaluation.run, agents=RANDOM), tmp_path) as again:
        again.play(1, lambda agent, result: shown.append((agent, result)), ignore)
    assert [agent for agent, _ in shown] == ["random", "random"]
    for _, result in shown:
        assert result.measures == evaluation.store.results["random"][result.episode].measures


def test_an_unknown_grasp_rule_is_refused(evaluation: Evaluation, tmp_path: Path) -> None:
    with pytest.raises(UniteamError, match="honest"):
        Evaluation(replace(evaluation.run, grasp="honst"), tmp_path)


def test_a_directory_of_another_perception_camera_grasp_or_split_is_refused(evaluation: Evaluation) -> None:
    with pytest.raises(InvalidInputError, match="camera was half and is now full"):
        Evaluation(replace(evaluation.run, camera="full"), evaluation.store.directory)
    with pytest.raises(InvalidInputError, match="grasp was challenge and is now honest"):
        Evaluation(replace(evaluation.run, grasp="honest"), evaluation.store.directory)
    with pytest.raises(InvalidInputError, match="split was two and is now minival"):
        Evaluation(replace(evaluation.run, split="minival"), evaluation.store.directory)
    with pytest.raises(InvalidInputError, match=r"episode_seconds was 3600\.0 and is now 60\.0"):
        Evaluation(replace(evaluation.run, episode_seconds=60.0), evaluation.store.directory)


def test_a_home_that_has_changed_under_its_name_is_another_split(
    evaluation: Evaluation, two_episodes: Path, tmp_path: Path
) -> None:
    lines = [json.loads(line) for line in gzip.decompress(two_episodes.read_bytes()).splitlines()]
    for line in lines:
        if "home" in line:
            line["home"]["stage"]["walls"][0]["thickness"] *= 0.9
    changed = tmp_path / "two.jsonl"
    changed.write_text("".join(json.dumps(line) + "\n" for line in lines))
    with pytest.raises(InvalidInputError, match=r"split_digest was .* and is now"):
        Evaluation(replace(evaluation.run, split=str(changed)), evaluation.store.directory)


def test_what_a_worker_finds_changed_since_the_run_began_is_not_played(tmp_path: Path, two_episodes: Path) -> None:
    split = tmp_path / "mine.jsonl.gz"
    split.write_bytes(two_episodes.read_bytes())
    run = Run(str(split), RANDOM, "truth", "half")
    with Evaluation(run, tmp_path / "out") as evaluation:
        split.write_bytes(gzip.compress(gzip.decompress(split.read_bytes()) + b"\n", mtime=0))
        with pytest.raises(UniteamError, match="the split have changed since the run began"):
            evaluation.play(1, ignore, ignore)


def test_the_configuration_says_what_frames_depend_on(evaluation: Evaluation) -> None:
    recorded = json.loads((evaluation.store.directory / "config.json").read_text())
    assert set(recorded["software"]) > {"python", "numpy", "numba", "llvmlite", "mujoco", "cpu", "cpu_features"}
    assert recorded["software"]["numba"] == version("numba")
    assert len(recorded["models_digest"]) == len(recorded["split_digest"]) == 12


def test_a_run_can_be_sent_to_another_process(evaluation: Evaluation) -> None:
    assert pickle.loads(pickle.dumps(evaluation.run)) == evaluation.run


def test_a_few_episodes_come_from_many_homes() -> None:
    minival = load_split("minival")
    homes = [minival.episodes[k].home for k in choose_episodes(minival.episodes, None)]
    count = len(set(homes))
    assert len(set(homes[:count])) == count
    assert choose_episodes(minival.episodes, 3) == choose_episodes(minival.episodes, None)[:3]


def test_an_agent_is_labelled_by_what_was_changed_in_it() -> None:
    labelled = label_agents(("baseline", "uniteam"), "truth", ("edge_margin",), ("drop_height",))
    assert list(labelled) == [
        "baseline with edge_margin",
        "uniteam without drop_height",
    ]
    assert list(label_agents(("baseline", "uniteam"), "truth")) == ["baseline", "uniteam"]
