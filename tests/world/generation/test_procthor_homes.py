"""`procthor:FILE` as a source of homes: settled, accounted for, certified, and played from a split."""

import logging
from pathlib import Path

import pytest
from worlds.procthor_miniature import write_miniature

from uniteam.cli.main import main
from uniteam.errors import InvalidInputError
from uniteam.world.generation.objects.settling import resting_on
from uniteam.world.generation.registry import HOMES, home_of_seed
from uniteam.world.task.splits import load_split


def test_a_house_is_a_home_whose_objects_rest_on_what_they_lay_on(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    source = f"procthor:{write_miniature(tmp_path)}"
    with caplog.at_level(logging.WARNING):
        home = home_of_seed(source, 0)
    assert home == home_of_seed(source, 0)
    assert home.name == "procthor-houses-0"
    lying = {home.by_name[name].category: home.by_name[on].category for name, on in resting_on(home).items()}
    expected = {"apple": "counter", "bowl": "counter", "plate": "table", "clock": "stand", "remote_control": "table"}
    assert lying.items() >= expected.items()
    told = caplog.messages[0]
    assert "house 0 of" in told and "no like here 2 (1 DogBed, 1 Lettuce); found no place 1 (1 Pillow)" in told


def test_episodes_are_certified_in_a_house(tmp_path: Path) -> None:
    houses, out = write_miniature(tmp_path), tmp_path / "mine.jsonl.gz"
    with pytest.raises(SystemExit) as ended:
        main(("episodes", "--homes", "1", "--per-home", "1", "--source", f"procthor:{houses}", "--out", str(out)))
    assert ended.value.code == 0
    split = load_split(out)
    assert [episode.home for episode in split.episodes] == ["procthor-houses-1"]
    assert split.homes["procthor-houses-1"] == home_of_seed(f"procthor:{houses}", 1)


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("procthor", "'procthor' needs FILE.jsonl.gz after a colon, such as procthor:val.jsonl.gz"),
        ("procthor:nowhere.jsonl.gz", "there is no file 'nowhere.jsonl.gz'"),
        ("procthor:val.pickle", "its name must end in .jsonl.gz"),
    ],
)
def test_a_file_that_there_is_not_is_told_at_once(name: str, sentence: str) -> None:
    with pytest.raises(InvalidInputError, match=sentence):
        HOMES.get(name)
