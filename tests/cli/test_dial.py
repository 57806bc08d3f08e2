"""`uniteam dial`, from nothing to the figure, and taken up again."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from worlds.called import call

from uniteam.cli.perceptions import as_folder, perception_name
from uniteam.errors import InvalidInputError
from uniteam.evaluation.episode_choice import choose_episodes
from uniteam.evaluation.results.intervals import estimate_proportion
from uniteam.visualization.success_chart import HEIGHT, LINE_COLORS, WIDTH, Curve, draw_success_chart
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import load_split, write_split


@pytest.fixture(scope="module")
def one_episode(tmp_path_factory: pytest.TempPathFactory) -> Path:
    minival = load_split("minival")
    episode = minival.episodes[choose_episodes(minival.episodes, 1)[0]]
    path = tmp_path_factory.mktemp("split") / "one.jsonl.gz"
    write_split(Split("one", (episode,), {episode.home: minival.homes[episode.home]}), path)
    return path


def test_a_split_is_played_at_each_level_and_drawn_and_goes_on_with_more(
    one_episode: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    given = ("dial", "--split", str(one_episode), "--agents", "random", "--workers", "1", "--out", str(tmp_path))
    assert call(*given, "--levels", "1", "0") == 0
    shown = capsys.readouterr().out
    assert "Perception noisy:0 (1 of 2)" in shown and "random, noisy:0" in shown
    assert call(*given, "--levels", "0", "0.5", "1", "0.5", "--beside", "truth") == 0
    shown = capsys.readouterr().out
    assert shown.count("1 of 1 episodes were played before") == 2
    points = json.loads((tmp_path / "dial.json").read_text())["points"]
    assert [point["level"] for point in points] == [0.0, 0.5, 1.0, None]
    assert {point["agent"] for point in points} == {"random"} and points[-1]["perception"] == "truth"
    assert all(point["episode_count"] == 1 for point in points)
    picture = cv2.imread(str(tmp_path / "dial.png"))
    assert picture is not None and picture.shape == (HEIGHT, WIDTH, 3)


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("--levels", "1.5"), "needs a level from 0"),
        (("--levels", "nan"), "needs a level from 0"),
        (("--levels",), "--agents and --levels need at least one each"),
        (("--agents",), "--agents and --levels need at least one each"),
        (("--agents", "baselin"), "did you mean 'baseline'"),
        (("--beside", "thruth"), "did you mean 'truth'"),
        (("--episodes", "0"), "--episodes must be at least 1"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(
    arguments: tuple[str, ...], sentence: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert call("dial", *arguments, "--out", str(tmp_path)) == 2
    assert sentence in capsys.readouterr().err


def test_the_chart_shows_a_point_and_its_interval_where_they_belong() -> None:
    full, half = estimate_proportion(20, 20), estimate_proportion(10, 20)
    picture = draw_success_chart("success", [Curve("baseline", [(0.0, full), (1.0, half)])], "of twenty")
    dots = np.argwhere((picture[:, :800] == np.array(LINE_COLORS[0])).all(-1))
    assert dots[:, 1].min() in range(80, 92) and dots[:, 1].max() in range(788, 800)
    at_one = dots[dots[:, 1] >= 780][:, 0]
    heights = [1.0 - (row - 70) / 440 for row in (at_one.max(), at_one.min())]
    assert heights == pytest.approx([half.low, half.high], abs=0.02)


@pytest.mark.parametrize(
    ("given", "name"),
    [
        (("truth", None, None), "truth"),
        (("owlv2", "google/owlv2", None), "owlv2:google/owlv2"),
        (("owlv2", "google/owlv2", "abc"), "owlv2:google/owlv2@abc"),
    ],
)
def test_a_model_and_its_revision_become_the_argument_of_the_name(
    given: tuple[str, str | None, str | None], name: str
) -> None:
    assert perception_name(*given) == name


@pytest.mark.parametrize("given", [("owlv2", None, "abc"), ("owlv2:a/b", "c/d", None)])
def test_a_revision_without_a_model_and_two_models_are_refused(given: tuple[str, str | None, str | None]) -> None:
    with pytest.raises(InvalidInputError, match="give"):
        perception_name(*given)


def test_any_name_of_a_perception_is_the_name_of_one_folder() -> None:
    assert as_folder("noisy:0.6") == "noisy.0.6"
    assert as_folder("remote:http://gpu:8712/") == "remote.http.gpu.8712"
    assert as_folder("owlv2:../../weights") == "owlv2.......weights"
