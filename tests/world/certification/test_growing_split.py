"""Splits that are kept while they are made, and go on where they were interrupted."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from uniteam.errors import InvalidInputError
from uniteam.world.certification.growing_split import GrowingSplit, grow
from uniteam.world.generation.generate import generate_home
from uniteam.world.homes.home import Home
from uniteam.world.task.splits import load_split, write_split

SEEDS = (9000, 9001)
RECIPE = "two homes"


def homes(end: int = len(SEEDS)) -> Iterator[Home]:
    """Yield homes, and be interrupted before the `end`-th."""
    for number, seed in enumerate(SEEDS):
        if number == end:
            raise KeyboardInterrupt
        yield generate_home(seed)


def ignore(home: Home, count: int) -> None:
    """Take note of nothing."""


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("whole") / "mine.jsonl.gz"
    split = GrowingSplit(out, RECIPE, "tidy")
    grow(split, homes(), 1, ignore)
    split.finish()
    return out


def test_a_finished_split_leaves_nothing_but_its_file(whole: Path) -> None:
    assert list(whole.parent.iterdir()) == [whole]
    assert [episode.home for episode in load_split(whole).episodes] == ["test-9000", "test-9001"]


def test_what_is_interrupted_is_kept_and_can_be_played(tmp_path: Path) -> None:
    split = GrowingSplit(tmp_path / "mine.jsonl.gz", RECIPE, "tidy")
    with pytest.raises(KeyboardInterrupt):
        grow(split, homes(1), 1, ignore)
    assert list(tmp_path.iterdir()) == [split.partial]
    assert load_split(split.partial).episodes == split.split.episodes
    assert len(split.split.episodes) == 1


def test_what_goes_on_ends_as_if_nothing_had_happened(tmp_path: Path, whole: Path) -> None:
    out = tmp_path / "mine.jsonl.gz"
    first = GrowingSplit(out, RECIPE, "tidy")
    with pytest.raises(KeyboardInterrupt):
        grow(first, homes(1), 1, ignore)
    second = GrowingSplit(out, RECIPE, "tidy")
    grow(second, homes(), 1, ignore)
    second.finish()
    assert out.read_bytes() == whole.read_bytes()
    assert list(tmp_path.iterdir()) == [out]


def test_what_was_made_before_is_not_made_again(tmp_path: Path) -> None:
    out = tmp_path / "mine.jsonl.gz"
    first = GrowingSplit(out, RECIPE, "tidy")
    home = generate_home(SEEDS[0])
    grow(first, [home], 1, ignore)
    marked = replace(first.split.episodes[0], seed=4711)
    write_split(replace(first.split, episodes=(marked,)), first.partial)
    second = GrowingSplit(out, RECIPE, "tidy")
    grow(second, [home], 1, ignore)
    assert second.split.episodes[0].seed == 4711


def test_another_recipe_does_not_go_on_with_these_episodes(tmp_path: Path) -> None:
    out = tmp_path / "mine.jsonl.gz"
    assert GrowingSplit(out, RECIPE, "tidy").partial != GrowingSplit(out, "three homes", "tidy").partial


def test_a_home_that_has_changed_since_is_made_anew(tmp_path: Path) -> None:
    out = tmp_path / "mine.jsonl.gz"
    home = generate_home(SEEDS[0])
    first = GrowingSplit(out, RECIPE, "tidy")
    grow(first, [home], 1, ignore)
    marked = replace(first.split.episodes[0], seed=4711)
    write_split(replace(first.split, episodes=(marked,)), first.partial)
    other = replace(home, stage=replace(home.stage, ceiling_height=home.stage.ceiling_height + 0.1))
    again = GrowingSplit(out, RECIPE, "tidy")
    grow(again, [other], 1, ignore)
    assert again.split.homes[home.name] == other
    assert again.split.episodes[0].seed != 4711


def test_two_homes_of_one_name_are_refused(tmp_path: Path) -> None:
    home = generate_home(SEEDS[0])
    with pytest.raises(InvalidInputError, match="two homes are named 'test-9000'"):
        grow(GrowingSplit(tmp_path / "mine.jsonl.gz", RECIPE, "tidy"), [home, home], 1, ignore)
