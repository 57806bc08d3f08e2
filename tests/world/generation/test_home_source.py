"""Homes from sources of others: by name, by reference, and checked before they are used."""

from dataclasses import replace
from pathlib import Path

import pytest

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.world.generation.generate import generate_home
from uniteam.world.generation.registry import home_of_seed

SOURCES = """
from dataclasses import replace
from uniteam.world.generation.generate import generate_home

def mine(seed):
    return replace(generate_home(seed), name=f"mine-{seed}")

def doubled(seed):
    home = mine(seed)
    return replace(home, instances=2 * home.instances)

def failing(seed):
    return 1 / 0

def nothing(seed):
    return None
"""


@pytest.fixture(autouse=True)
def sources(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "own_sources.py").write_text(SOURCES)
    monkeypatch.syspath_prepend(tmp_path)


def test_the_generator_is_a_source_with_two_names() -> None:
    assert home_of_seed("test", 3) == generate_home(3, "test")
    assert home_of_seed("train", 3) == generate_home(3, "train")


def test_a_function_of_ones_own_is_a_source() -> None:
    assert home_of_seed("own_sources:mine", 3) == replace(generate_home(3), name="mine-3")


def test_a_misspelt_source_is_answered_with_the_nearest() -> None:
    with pytest.raises(UnknownNameError, match="did you mean 'train'"):
        home_of_seed("trian", 1)


@pytest.mark.parametrize(
    ("source", "seed", "sentence"),
    [
        ("own_sources:doubled", 3, "home 'mine-3' cannot be used: two are named instance"),
        ("own_sources:failing", 3, "own_sources:failing failed at seed 3: ZeroDivisionError: division by zero"),
        ("own_sources:nothing", 3, "own_sources:nothing returned a NoneType for seed 3, it must return a Home"),
        ("own_sources:mine", -3, "a home's seed must not be negative, got -3"),
    ],
)
def test_a_source_that_gives_no_sound_home_is_told_so(source: str, seed: int, sentence: str) -> None:
    with pytest.raises(InvalidInputError, match=sentence):
        home_of_seed(source, seed)
