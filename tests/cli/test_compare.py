"""`uniteam compare`: what it prints, and what it refuses."""

from pathlib import Path

import pytest
from worlds.called import call
from worlds.filled import filled
from worlds.runs import CONFIGURATION, result, write_run

from uniteam.evaluation.analysis.likeness import MUST_AGREE


@pytest.fixture
def run(tmp_path: Path) -> Path:
    """Three agents on 40 episodes; the second succeeds at 12 more of them than the first, the third at one more."""
    successes = {"baseline": 8, "uniteam": 20, "my_agent:Spinner": 9}
    agents = {agent: [result(k, k < count) for k in range(40)] for agent, count in successes.items()}
    return write_run(tmp_path / "run", agents)


def row(told: str, heading: str) -> list[str]:
    """Return the cells of the first table's row, and those of the line below."""
    lines = told.splitlines()
    at = next(k for k, line in enumerate(lines) if heading in line)
    return [cell.strip() for line in lines[at : at + 2] for cell in line.strip("│").split("│")]


def test_two_agents_are_compared_on_the_same_episodes(run: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert call("compare", f"{run}:baseline", f"{run}:uniteam") == 0
    told = capsys.readouterr().out
    assert "A: baseline" in told and "B: uniteam" in told and "40 episodes in 40 homes" in told
    figures, below = row(told, "Overall")[:7], row(told, "Overall")[7:]
    assert figures[1:6] == ["20.0", "50.0", "+30.0", "0", "<.001"]
    assert below[1:5] == ["10–35", "35–65", "+13 to +45*", "12"]
    assert "Holm" not in told and "UNLIKE" not in told
    assert "Split val (version 2), perception truth" in " ".join(told.split())


def test_a_folder_stands_for_all_its_agents_and_p_is_corrected(run: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert call("compare", str(run)) == 0
    told = " ".join(capsys.readouterr().out.split())
    assert "p is corrected for 2 comparisons (Holm)" in told
    assert "B: my_agent:Spinner" in told
    assert call("compare", f"{run}:my_agent:Spinner", f"{run}:uniteam") == 0
    assert "A: my_agent:Spinner" in capsys.readouterr().out


def test_agents_of_one_name_in_two_runs_are_told_apart(
    run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = write_run(tmp_path / "other", {"baseline": [result(k, k < 4, steps=200) for k in range(10)]})
    assert call("compare", f"{run}:baseline", str(other)) == 0
    told = "".join(capsys.readouterr().out.split())
    assert f"A:{run}:baseline" in told and f"B:{other}:baseline" in told
    assert "10episodesin10homes" in told


@pytest.mark.parametrize("field", MUST_AGREE)
def test_runs_that_differ_in_more_than_their_agents_are_refused(
    field: str, run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert field in CONFIGURATION
    other = write_run(tmp_path / "other", {"uniteam": [result(k, True) for k in range(9)]}, **{field: "another"})
    given = ("compare", f"{run}:baseline", str(other))
    assert call(*given) == 2
    refused = capsys.readouterr()
    assert f"{MUST_AGREE[field]}: {CONFIGURATION[field]} in {run}, another in {other}" in refused.err
    assert "--allow-unlike" in refused.err and refused.out == ""
    assert call(*given, "--allow-unlike") == 0
    told = " ".join(capsys.readouterr().out.split())
    assert f"UNLIKE RUNS, so these differences are not the agents' alone. {MUST_AGREE[field]}:" in told


def test_other_software_is_said_and_not_refused(run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    other = write_run(tmp_path / "other", {"uniteam": [result(1, True)]}, software={"python": "3.14"})
    assert call("compare", f"{run}:baseline", str(other)) == 0
    assert "on other processors" in " ".join(capsys.readouterr().out.split())


def test_an_episode_of_one_name_with_another_request_is_another_episode(
    run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = write_run(tmp_path / "other", {"uniteam": [result(k, True, home="elsewhere") for k in range(9)]})
    assert call("compare", f"{run}:baseline", str(other)) == 2
    assert "have played no episode in common" in capsys.readouterr().err


def test_few_episodes_show_no_difference_at_all(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    agents = {name: [result(k, name == "b") for k in range(5)] for name in "ab"}
    assert call("compare", str(write_run(tmp_path / "run", agents))) == 0
    figures = filled(row(capsys.readouterr().out, "Overall"))
    assert figures[3] == "+100.0" and figures[6] == "none"


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ((), "two agents are needed to compare, got 0"),
        (("{run}:baseline",), "two agents are needed to compare, got 1"),
        (("{run}:baseline", "{run}:baseline"), "two agents are needed to compare, got 1"),
        (("{run}:baselin", "{run}"), "did you mean 'baseline'?"),
        (("nowhere", "{run}"), "'nowhere' names no folder"),
        (("{run}/..", "{run}"), "is not the folder of a run"),
    ],
)
def test_what_cannot_be_compared_is_answered_in_a_sentence(
    arguments: tuple[str, ...], sentence: str, run: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert call("compare", *(argument.format(run=run) for argument in arguments)) == 2
    assert sentence in capsys.readouterr().err
