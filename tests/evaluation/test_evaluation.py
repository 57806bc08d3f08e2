"""A whole evaluation: real episodes in worker processes, from nothing to the table."""

import json
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path

import pytest

from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import AgentSpec, label_agents
from uniteam.evaluation.evaluation import Evaluation, Run, choose_episodes
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


@pytest.fixture(scope="module")
def evaluation(two_episodes: Path, tmp_path_factory: pytest.TempPathFactory) -> Evaluation:
    """The random agent and the oracle, played on that split by two workers."""
    run = Run(str(two_episodes), label_agents(("random", "oracle"), "truth"), "truth", "half")
    evaluation = Evaluation(run, tmp_path_factory.mktemp("run"))
    evaluation.play(2, lambda agent, result: None)
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
        "version": version("uniteam"),
        "episode_count": 2,
    }
    assert {name: random[name] for name in source} == source
    assert 0.0 <= random["num_steps"]["low"] <= random["num_steps"]["mean"] <= random["num_steps"]["high"]


def test_a_finished_run_is_taken_up_with_nothing_left_to_play(evaluation: Evaluation) -> None:
    again = Evaluation(evaluation.run, evaluation.store.directory)
    assert again.remaining == []
    assert again.summaries() == evaluation.summaries()


def test_results_that_are_missing_are_played_again_and_are_the_same(evaluation: Evaluation, tmp_path: Path) -> None:
    """One worker, another order, another process: an episode is what its seed makes it."""
    again = Evaluation(replace(evaluation.run, agents=RANDOM), tmp_path)
    shown: list[tuple[str, EpisodeResult]] = []
    again.play(1, lambda agent, result: shown.append((agent, result)))
    assert [agent for agent, _ in shown] == ["random", "random"]
    for _, result in shown:
        assert result.measures == evaluation.store.results["random"][result.episode].measures


def test_a_directory_of_another_perception_camera_or_split_is_refused(evaluation: Evaluation) -> None:
    with pytest.raises(InvalidInputError, match="camera was half and is now full"):
        Evaluation(replace(evaluation.run, camera="full"), evaluation.store.directory)
    with pytest.raises(InvalidInputError, match="split was two and is now minival"):
        Evaluation(replace(evaluation.run, split="minival"), evaluation.store.directory)


def test_a_few_episodes_come_from_many_homes() -> None:
    minival = load_split("minival")
    homes = [minival.episodes[k].home for k in choose_episodes(minival.episodes, None)]
    count = len(set(homes))
    assert len(set(homes[:count])) == count
    assert choose_episodes(minival.episodes, 3) == choose_episodes(minival.episodes, None)[:3]


def test_an_agent_is_labelled_by_what_was_changed_in_it() -> None:
    labelled = label_agents(("baseline", "uniteam", "random"), "truth", ("edge_margin",), ("drop_height",))
    assert list(labelled) == [
        "baseline with edge_margin",
        "uniteam without drop_height",
        "random",
    ]
    assert list(label_agents(("baseline", "uniteam"), "truth")) == ["baseline", "uniteam"]
