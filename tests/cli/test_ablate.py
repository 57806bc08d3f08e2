"""`uniteam ablate`: from what was played to tables, figure and page."""

from collections.abc import Sequence
from pathlib import Path

import cv2
import pytest
from worlds.called import call
from worlds.runs import result, write_run

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.analysis.ablation_plan import plan_ablation
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.evaluation import Evaluation, home_of
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import load_split, write_split


def played(folder: Path, perception: str = "truth") -> Path:
    """Write a run in which centre_approach alone is worth 30 points, and the others nothing."""
    worth: dict[str, Sequence[EpisodeResult]] = {}
    for label in plan_ablation(perception, ["alone"]).agents:
        worth[label] = [result(k, k < (16 if "centre_approach" in label else 4)) for k in range(40)]
    return write_run(folder, worth, perception=perception)


def report(folder: Path, *more: str) -> int:
    return call("ablate", "--report-only", "--groups", "alone", "--out", str(folder), *more)


def test_what_was_played_is_told_without_playing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = played(tmp_path / "run")
    before = (folder / "results.jsonl").read_bytes()
    assert report(folder) == 0
    lines = capsys.readouterr().out.splitlines()
    at = next(k for k, line in enumerate(lines) if "centre_approach" in line)
    assert "+30.0*" in lines[at] and "40 episodes" in lines[at + 1] and "12" in lines[at + 1]
    assert sum("*" in line for line in lines) == 2  # and where it is said what it means
    picture = cv2.imread(str(folder / "ablation.png"))
    assert picture is not None and picture.std() > 5.0
    assert (folder / "results.jsonl").read_bytes() == before


def test_a_page_holds_each_perceptions_tables_and_what_its_author_wrote(tmp_path: Path) -> None:
    page = tmp_path / "docs" / "ablation.md"
    assert report(played(tmp_path / "run"), "--docs", str(page)) == 0
    page.write_text(page.read_text().replace("worth\n", "worth\n\nMy own words.\n", 1))
    assert report(played(tmp_path / "noisy", "noisy:1"), "--perception", "noisy:1", "--docs", str(page)) == 0
    text = page.read_text()
    assert "My own words." in text and text.count("| centre_approach | 40 | 10.0 | 40.0 | +30.0* (") == 2
    for name in ("ablation-truth.png", "ablation-noisy.1.png"):
        assert f"({name})" in text and (page.parent / name).is_file()
    assert report(tmp_path / "run", "--docs", str(page)) == 0
    assert page.read_text() == text


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("--perception", "thruth"), "did you mean 'truth'"),
        (("--docs", "page.txt"), "must end in .md"),
        (("--report-only", "--groups", "removed"), "have played the same episode"),
        (("--shard", "3/2"), "such as 2/4"),
        (("--episodes", "0"), "--episodes must be at least 1"),
    ],
)
def test_what_cannot_be_is_answered_in_a_sentence(
    arguments: tuple[str, ...], sentence: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert call("ablate", *arguments, "--out", str(played(tmp_path / "run"))) == 2
    assert sentence in capsys.readouterr().err


def order(folder: Path, split: Path, by_episode: bool) -> list[str]:
    """Return the homes in the order in which one process plays two episodes in each of two homes."""
    run = Run(str(split), {"random": AgentSpec("random", "truth")}, "truth", "half")
    homes: list[str] = []
    group_of = (lambda episode: episode.id) if by_episode else home_of
    with Evaluation(run, folder) as evaluation:
        evaluation.play(1, lambda agent, result: homes.append(result.home), lambda *lost: None, group_of)
    return homes


def test_by_episode_all_homes_come_in_turn_and_by_home_one_after_the_other(tmp_path: Path) -> None:
    val = load_split("val")
    names = list(dict.fromkeys(episode.home for episode in val.episodes))[:2]
    episodes = tuple(episode for name in names for episode in [e for e in val.episodes if e.home == name][:2])
    split = tmp_path / "four.jsonl.gz"
    write_split(Split("four", episodes, {name: val.homes[name] for name in names}), split)
    first, second = names
    assert order(tmp_path / "a", split, by_episode=True) == [first, second, first, second]
    assert order(tmp_path / "b", split, by_episode=False) == [first, first, second, second]


@pytest.mark.slow
def test_an_ablation_is_played_and_taken_up(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    given = ("ablate", "--groups", "whole", "--split", "minival", "--episodes", "1", "--out", str(tmp_path / "run"))
    assert call(*given, "--workers", "1") == 0
    told = capsys.readouterr().out
    assert "3 agents on 1 episodes, 3 attempts to play." in told and "the report's 14" in told
    assert call(*given) == 0
    assert "3 of 3 episodes were played before" in capsys.readouterr().out
