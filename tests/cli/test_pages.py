"""`uniteam replay` and `uniteam report`, from a run's folder to pages that link to each other."""

import re
from pathlib import Path

import pytest
from worlds.called import call
from worlds.recorded import Reciter, record
from worlds.runs import write_run

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.interface import DiscreteAction


def test_a_run_becomes_a_report_that_links_to_its_replays(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    played = record(tmp_path / "own.zip", Reciter((DiscreteAction.TURN_LEFT,) * 2), AgentSpec("random", "truth"))
    run = write_run(tmp_path / "run", {"random": [played.result]}, split="minival")
    recording = run / "recordings" / "random" / f"{played.result.episode}.zip"
    recording.parent.mkdir(parents=True)
    played.path.rename(recording)
    monkeypatch.chdir(tmp_path)

    assert call("replay", "run", played.result.episode) == 0
    page = tmp_path / f"{played.result.episode}.html"
    assert f"Replay: {page.name}" in capsys.readouterr().out
    assert page.read_text().startswith("<!doctype html>")

    assert call("report", "run", "--out", "pages/report.html", "--replays") == 0
    links = re.findall(r'"replay":"([^"]+)"', (tmp_path / "pages" / "report.html").read_text())
    assert links == [f"report-replays/random/{played.result.episode}.html"]
    assert (tmp_path / "pages" / links[0]).read_text() == page.read_text()


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("replay",), "give one FILE.zip or two"),
        (("replay", "none.zip"), "the recording 'none.zip' cannot be read"),
        (("replay", "none.zip", "--out", "page.txt"), "'page.txt' must end in .html"),
        (("report",), "name the folder of a run"),
        (("report", "none"), "'none' names no folder"),
    ],
)
def test_what_cannot_be_shown_is_answered_in_one_sentence(
    arguments: tuple[str, ...],
    sentence: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert call(*arguments) == 2
    assert sentence in capsys.readouterr().err.replace("\n", " ")
    assert list(tmp_path.iterdir()) == []
